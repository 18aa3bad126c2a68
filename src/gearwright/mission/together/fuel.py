"""Rounds over all intervals at once, in which the mass of aircraft and the fuel that they have burnt agree."""

from __future__ import annotations

import numpy as np

from gearwright.air import stagnation_along
from gearwright.arrays import Bools, Floats
from gearwright.mission.supply import Supply
from gearwright.mission.thrust import Blades
from gearwright.mission.together.craft import angle_for_thrusts, needed_thrust
from gearwright.mission.together.deck import Deck
from gearwright.mission.together.gearbox import Box
from gearwright.mission.together.plant import fuel_along
from gearwright.mission.together.rounds import Asked, Balanced, balanced_rounds, given_powers, no_losses

_MASSES = 24
"""Most rounds: fuel that is wrong by a part of the mass makes later fuel wrong by less than its part of all fuel."""
_SAME = 1e-13
"""Change of the fuel that is burnt, over the mass at the start, below which rounds have settled [-]."""


def balanced_with_fuel(
    box: Box, blades: Blades, supply: Supply, deck: Deck, asked: Asked
) -> tuple[Balanced, Floats, Bools] | None:
    """Return the gearbox in balance, blade angles that are held or give a thrust [rad], and what cannot be flown.

    Args:
        box: The gearbox.
        blades: The propeller.
        supply: The machines.
        deck: Of intervals.
        asked: Of the gearbox; powers that follow from a thrust are found here.

    Source: an interval's mass is what fuel before it has left. Every round takes the fuel of the round before; what is
        wrong begins later each time. A flight keeps the fuel with which it settled: it is the same whatever others it
        is found with.
    """
    fails = np.zeros(len(deck.pitch), bool)
    if deck.craft is None:
        free = balanced_rounds(box, asked)
        return None if free is None else (free, deck.pitch, free.short | ~free.settled)
    rows = np.flatnonzero(deck.craft.asks)
    craft, course, ratios = (
        deck.craft.at(rows),
        deck.course.at(rows),
        stagnation_along(deck.course.air, deck.course.mach),
    )
    whose = np.repeat(np.arange(len(deck.flights)), [lanes.stop - lanes.start for lanes in deck.flights])
    heavy = np.array([mission.aircraft.mass if mission.aircraft else 1.0 for mission in deck.missions])[whose]
    burnt, lost, going = np.zeros(len(fails)), no_losses(box, len(fails)), fails
    found: Balanced | None = None
    pitch, wanted = deck.pitch.copy(), asked.wanted.copy()
    for _ in range(_MASSES):
        thrust, unflown = needed_thrust(craft, course, burnt[rows])
        pitch[rows], wanted[rows], outside = angle_for_thrusts(blades, course, craft, thrust / deck.engines[rows])
        fails[rows] = unflown | outside
        found = balanced_rounds(box, asked._replace(wanted=wanted), lost)
        if found is None:
            return None
        flow = fuel_along(supply, ratios, given_powers(box.gearbox.machines, asked, found))
        after = _before(deck, flow)
        moved = (np.abs(after - burnt) > _SAME * heavy) | ~found.settled
        going = (np.bincount(whose, moved) > 0.0)[whose]
        if not going.any():
            break
        burnt, lost = np.where(going, after, burnt), np.where(going[:, None], found.lost, lost)
    return None if found is None else (found, pitch, fails | found.short | going)


def _before(deck: Deck, flow: Floats) -> Floats:
    """Return the fuel that all engines of every flight have burnt before each interval [kg]."""
    spent, burnt = flow * deck.course.duration * deck.engines, np.zeros(len(flow))
    for lanes in deck.flights:
        burnt[lanes.start + 1 : lanes.stop] = np.cumsum(spent[lanes.start : lanes.stop - 1])
    return burnt
