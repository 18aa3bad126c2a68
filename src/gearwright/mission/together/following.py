"""Rounds over all intervals at once, in which what follows from the intervals before agrees: fuel, losses, shares."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwright.air import stagnation_along
from gearwright.arrays import Bools, Floats
from gearwright.mission.moments import Blades
from gearwright.mission.strategies import AGREED, Demand
from gearwright.mission.supply import Supply
from gearwright.mission.together.craft import angle_for_thrusts, needed_thrust
from gearwright.mission.together.deck import Deck
from gearwright.mission.together.gearbox import Box
from gearwright.mission.together.plant import (
    available_along,
    dragged_along,
    electric_along,
    fuel_along,
)
from gearwright.mission.together.rounds import Asked, Balanced, balanced_rounds, given_powers, no_losses
from gearwright.mission.together.shared import Charging

_MOST = 24
"""Most rounds: fuel that is wrong by a part of the mass makes later fuel wrong by less than its part of all fuel."""
_SAME = 1e-13
"""Change of the fuel that is burnt, over the mass at the start, below which rounds have settled [-]."""


class Guess(NamedTuple):
    """What a round takes from the one before, shape (n, ...)."""

    burnt: Floats
    """Fuel of all engines before each interval [kg]."""
    lost: Floats
    """Part that teeth of each stage lose [-]."""
    share: Floats
    """Motors' part of the machines' power, where a strategy sets it [-]."""


class Followed(NamedTuple):
    """Intervals in agreement with those before them."""

    found: Balanced
    asked: Asked
    """Of the gearbox, with the parts of machines."""
    pitch: Floats
    """Blade angles that are held or give a thrust; NaN: none [rad]."""
    fails: Bools
    """What cannot be flown, or has not settled."""


class Flying(NamedTuple):
    """With what flights are flown."""

    box: Box
    blades: Blades
    supply: Supply
    deck: Deck
    speeds: dict[str, Floats]
    """Machine -> speed without sign, shape (n,) [rad/s]."""


def followed(flying: Flying, asked: Asked) -> Followed | None:
    """Return intervals in agreement with those before them; None where the gearbox loses too much to be solved so.

    Args:
        flying: With what is flown.
        asked: Of the gearbox; powers that follow from a thrust, and parts by strategies, are found here.

    Source: an interval's mass is what fuel before it has left, and its share what its strategy makes of its power and
        of the charge before it. Every round takes fuel, losses and shares of the round before; what is wrong begins
        later each time. A flight keeps that with which it settled: it is the same whatever others it is found with.
    """
    box, _, supply, deck, _ = flying
    if deck.craft is None and deck.strategies is None:
        free = balanced_rounds(box, asked)
        return None if free is None else Followed(free, asked, deck.pitch, free.short | ~free.settled)
    count = len(deck.pitch)
    whose = np.repeat(np.arange(len(deck.flights)), [lanes.stop - lanes.start for lanes in deck.flights])
    heavy = np.array([mission.aircraft.mass if mission.aircraft else np.inf for mission in deck.missions])[whose]
    ratios = stagnation_along(deck.course.air, deck.course.mach)
    begun = deck.strategies.begun() if deck.strategies else np.zeros(count)
    guess, round_ = Guess(np.zeros(count), no_losses(box, count), begun), None
    going = np.ones(count, bool)
    for _ in range(_MOST):
        round_ = _round(flying, asked, guess)
        if round_ is None:
            return None
        powers = given_powers(box.gearbox.machines, round_.asked, round_.found)
        burnt = _before(deck, fuel_along(supply, ratios, powers) * deck.course.duration * deck.engines)
        share = _shares(flying, powers, guess.share)
        moved = (np.abs(burnt - guess.burnt) > _SAME * heavy) | (np.abs(share - guess.share) > AGREED)
        going = (np.bincount(whose, moved | ~round_.found.settled) > 0.0)[whose]
        if not going.any():
            break
        guess = Guess(
            np.where(going, burnt, guess.burnt),
            np.where(going[:, None], round_.found.lost, guess.lost),
            np.where(going, share, guess.share),
        )
    return None if round_ is None else round_._replace(fails=round_.fails | going)


def _round(flying: Flying, asked: Asked, guess: Guess) -> Followed | None:
    box, blades, supply, deck, speeds = flying
    pitch, fails = deck.pitch, np.zeros(len(deck.pitch), bool)
    if deck.craft is not None:
        rows, pitch, wanted = np.flatnonzero(deck.craft.asks), pitch.copy(), asked.wanted.copy()
        craft, course = deck.craft.at(rows), deck.course.at(rows)
        thrust, unflown = needed_thrust(craft, course, guess.burnt[rows])
        pitch[rows], wanted[rows], outside = angle_for_thrusts(blades, course, craft, thrust / deck.engines[rows])
        fails[rows] = unflown | outside
        asked = asked._replace(wanted=wanted)
    if deck.strategies is not None:
        parts, none = deck.strategies.parts(deck.parts, guess.share), np.zeros(len(pitch))
        driven = {name: np.where(deck.strategies.follows, parts[name] != 0.0, on) for name, on in deck.driven.items()}
        columns = [parts.get(name, none) for name in box.gearbox.machines]
        asked = asked._replace(parts=np.stack(columns, axis=1), dragged=dragged_along(supply, driven, speeds))
    found = balanced_rounds(box, asked, guess.lost)
    return None if found is None else Followed(found, asked, pitch, fails | found.short)


def _shares(flying: Flying, powers: dict[str, Floats], share: Floats) -> Floats:
    """Return the motors' part of the machines' power by their strategies; as it is where there are none [-]."""
    _, _, supply, deck, speeds = flying
    if deck.strategies is None:
        return share
    power = sum((powers[name] for name in (*supply.engines, *supply.motors)), np.zeros(len(share)))
    available = available_along(supply, deck.course, speeds, deck.rating, deck.strategies.working)
    columns: Any = (power, available, power, deck.course.duration)
    demand = Demand(*columns)
    share = deck.strategies.shares(demand)
    if supply.pack is not None and deck.strategies.charging:
        bus, air = electric_along(supply, powers, speeds)[0], np.asarray(deck.course.air.temperature)
        for lanes, mission in zip(deck.flights, deck.missions, strict=True):
            start = supply.pack.start(mission.battery.start_charge if mission.battery else 0.0)
            deck.strategies.charged(supply, demand, start, Charging(lanes, bus, air, speeds, share))
    return share


def _before(deck: Deck, spent: Floats) -> Floats:
    """Return what every flight has spent before each interval, of what each spends."""
    sums = np.zeros(len(spent))
    for lanes in deck.flights:
        sums[lanes.start + 1 : lanes.stop] = np.cumsum(spent[lanes.start : lanes.stop - 1])
    return sums
