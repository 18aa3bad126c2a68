"""Intervals of flights as arrays: what they ask, and rounds in which what follows from the intervals before agrees."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Ints, Problem, SolveError, near
from gearwright.mission.gearbox import (
    Asked,
    Balanced,
    Gearbox,
    Known,
    balanced_rounds,
    given_powers,
    has_fault,
    no_losses,
    warm_oil,
)
from gearwright.mission.plant import OIL, GearHeat, Warm, oil_along, oil_start, oil_step, refuse_stiff, too_stiff
from gearwright.mission.profile import Course, Doubt, Paths, Stretch, laid_out, runs_of, stretches_of
from gearwright.mission.strategies import (
    AGREED,
    PLANS,
    Charging,
    Demand,
    Needs,
    Strategies,
    planned_shares,
    strategies_of,
    strategy_doubts,
)
from gearwright.mission.supply import Supply, available_along, dragged_along, electric_along, fuel_along
from gearwright.mission.thrust import (
    Blades,
    Craft,
    Trim,
    angle_for_thrusts,
    asked_power,
    craft_of,
    needed_thrust,
    trimmed,
    wanted_of,
)
from gearwright.spec import Mission, Phase, engine_out

# ----------------------------------------------------------------------------------------------------------------------
# What the intervals of one flight, or of many, ask: courses one after the other, with modes as arrays.
# ----------------------------------------------------------------------------------------------------------------------


class Flown(NamedTuple):
    """What flies."""

    gearbox: Gearbox
    blades: Blades
    mission: Mission
    supply: Supply
    paths: Paths = MappingProxyType({})
    """Of the phases that an aircraft flies."""


class Deck(NamedTuple):
    """All intervals of some flights; arrays have one entry for each."""

    missions: tuple[Mission, ...]
    course: Course
    flights: tuple[slice, ...]
    """Which intervals are whose."""
    stretches: tuple[Stretch, ...]
    """The phases of all flights."""
    whose: Ints
    """Number of the phase."""
    parts: Mapping[str, Floats]
    """Machine -> part of the power of all machines [-]."""
    driven: Mapping[str, Bools]
    """Machine -> where it has a part."""
    refused: Mapping[int, DesignError]
    """Phase -> why its mode has no machines."""
    pitch: Floats
    """That is held; NaN: none [rad]."""
    rating: Floats
    """Of the turbines over the usual one [-]."""
    engines: Floats
    """Of the aircraft that run [-]."""
    craft: Craft | None
    """The aircraft; None where no interval is asked for a thrust."""
    rotors: Ints
    """Intervals in which a helicopter's trim says what its rotors take."""
    strategies: Strategies | None
    """Rules by which machines divide the power; None where no interval has one."""
    warms: bool
    """Whether temperatures of gearboxes are followed."""

    @property
    def first(self) -> Bools:
        """Where a flight begins."""
        starts = np.zeros(len(self.pitch), bool)
        starts[[lanes.start for lanes in self.flights]] = True
        return starts

    @property
    def follows(self) -> bool:
        """Whether what intervals ask follows from those before them."""
        return self.craft is not None or self.strategies is not None or len(self.rotors) > 0 or self.warms

    @property
    def owner(self) -> Ints:
        """Number of the flight of each."""
        return np.repeat(np.arange(len(self.flights)), [lanes.stop - lanes.start for lanes in self.flights])

    def mission(self, k: int) -> Mission:
        """Return the mission of an interval.

        Args:
            k: Its number.
        """
        return self.stretches[int(self.whose[k])].mission

    def phase(self, k: int) -> Phase:
        """Return the phase of an interval.

        Args:
            k: Its number.
        """
        return self.stretches[int(self.whose[k])].phase

    def at(self, kept: Ints) -> Deck:
        """Return the deck of some intervals, of every flight at least one; none follows from those before it.

        Args:
            kept: Their numbers, rising.
        """
        ends = np.searchsorted(kept, [0, *(lanes.stop for lanes in self.flights)]).tolist()
        return self._replace(
            course=self.course.at(kept),
            flights=tuple(slice(start, end) for start, end in pairwise(ends)),
            whose=self.whose[kept],
            parts={name: part[kept] for name, part in self.parts.items()},
            driven={name: driven[kept] for name, driven in self.driven.items()},
            pitch=self.pitch[kept],
            rating=self.rating[kept],
            engines=self.engines[kept],
        )


def deck_of(all_flown: Sequence[Flown]) -> Deck:
    """Return what the intervals of flights ask.

    Args:
        all_flown: With the same machines.

    Raises:
        DesignError: A phase is supersonic.
    """
    supply, missions = all_flown[0].supply, [flown.mission for flown in all_flown]
    whole = [stretches_of(flown.mission, flown.paths) for flown in all_flown]
    stretches = [stretch for flight in whole for stretch in flight]
    course, counts = laid_out(stretches)
    ends = np.cumsum([0, *counts])[np.cumsum([0, *map(len, whole)])].tolist()
    asked, refused = list[dict[str, float]](), dict[int, DesignError]()
    for k, stretch in enumerate(stretches):
        try:
            asked.append(supply.parts(stretch.phase))
        except DesignError as error:
            asked.append({})
            refused[k] = error
    names = (*supply.engines, *supply.motors)
    engines = [float(stretch.phase.engines or stretch.mission.engines) for stretch in stretches]
    whose = np.repeat(np.arange(len(stretches)), counts)
    trims = np.array([stretch.mission.rotorcraft is not None for stretch in stretches])
    return Deck(
        missions=tuple(missions),
        course=course,
        flights=tuple(slice(start, end) for start, end in pairwise(ends)),
        stretches=tuple(stretches),
        whose=whose,
        parts={name: np.repeat([parts.get(name, 0.0) for parts in asked], counts) for name in names},
        driven={name: np.repeat([name in parts for parts in asked], counts) for name in names},
        refused=refused,
        pitch=np.repeat([_pitch(stretch.phase) for stretch in stretches], counts),
        rating=np.repeat([_rating(stretch.mission, stretch.phase) for stretch in stretches], counts),
        engines=np.repeat(engines, counts),
        craft=craft_of(stretches, counts),
        rotors=np.flatnonzero(trims[whose] & np.isnan(course.power)),
        strategies=strategies_of(supply, stretches, counts),
        warms=any(mission.oil.network is not None for mission in missions),
    )


def _pitch(phase: Phase) -> float:
    return math.nan if phase.pitch is None else phase.pitch


def _rating(mission: Mission, phase: Phase) -> float:
    return mission.engine.contingency if engine_out(mission, phase) else 1.0


def shortened(deck: Deck, depth: int) -> tuple[Deck, Ints]:
    """Return a deck without what repeats, and which of its intervals speaks for each of the full one.

    Args:
        deck: What is asked; none follows from those before it.
        depth: As in `runs_of`.
    """
    course = deck.course
    columns = (course.altitude, course.true_airspeed, course.power, course.propeller_speed, deck.pitch, deck.rating)
    spun = course.propeller_gain / course.duration
    runs = runs_of(
        (*columns, spun, *deck.parts.values(), *deck.driven.values()), course.starts_phase | deck.first, depth
    )
    return deck.at(runs.kept), runs.source


# ----------------------------------------------------------------------------------------------------------------------
# Rounds over all intervals at once, in which what follows from the intervals before agrees: fuel, losses, shares, oil.
# ----------------------------------------------------------------------------------------------------------------------


_MOST = 24
"""Most rounds: fuel that is wrong by a part of the mass makes later fuel wrong by less than its part of all fuel."""
_SAME = 1e-13
"""Change of the fuel that is burnt, over the mass at the start, below which rounds have settled [-]."""
_WARM = 1e-12
"""Change of the oil's temperature below which rounds have settled, over itself [-]."""


class Flying(NamedTuple):
    """With what flights are flown."""

    gearbox: Gearbox
    blades: Blades
    supply: Supply
    deck: Deck
    planning: bool = False
    """Whether only a plan is made, which knows neither the charge nor warm oil."""
    coupled: bool = False
    """Whether rounds go on until loads and losses agree, also where a few should do."""

    @property
    def follows(self) -> bool:
        """Whether what intervals ask follows from those before them; motors of shafts that clutches part, too."""
        parted = bool(self.gearbox.sizing.train.joints) and bool(self.supply.motors)
        return self.deck.follows or parted

    def speeds(self, nodes: Floats) -> dict[str, Floats]:
        """Return machine -> speed without sign, shape (n,) [rad/s].

        Args:
            nodes: Speeds of the train's nodes, shape (n, nodes) [rad/s].
        """
        pairs = zip(self.gearbox.machines, self.gearbox.places, strict=True)
        return {name: np.abs(nodes[:, place]) for name, place in pairs}


class Guess(NamedTuple):
    """What a round takes from the one before, shape (n, ...)."""

    burnt: Floats
    """Fuel of all engines before each interval [kg]."""
    lost: Floats
    """Part that teeth of each stage lose [-]."""
    share: Floats
    """Motors' part of the machines' power, where a strategy sets it [-]."""
    warm: Floats
    """Temperatures of the gearbox at the start of each interval, shape (n, 4); NaN: not followed [K]."""
    torques: Floats
    """On gear a of one single mesh of each row, shape (n, meshes) [N m]."""
    nodes: Floats
    """Speeds of the train's nodes, shape (n, nodes) [rad/s]."""

    @property
    def known(self) -> Known:
        """Of the gearbox."""
        return Known(self.lost, self.torques, self.nodes)


class Followed(NamedTuple):
    """Intervals in agreement with those before them."""

    found: Balanced
    asked: Asked
    """Of the gearbox, with the parts of machines."""
    pitch: Floats
    """Blade angles that are held or give a thrust; NaN: none [rad]."""
    guess: Guess
    """With what they were found."""
    starts: Floats
    """Temperatures of the gearbox at the start of each interval by its losses, shape (n, 4); NaN: not followed [K]."""
    after: Floats
    """At its end."""
    unflown: Bools
    """Where no thrust, blade angle or trim is found."""
    unoiled: Bools
    """Where oil is too cold to flow, or oil, gears or bearings are too warm."""
    moving: Bools
    """What has not settled."""


def followed(flying: Flying) -> Followed:
    """Return intervals in agreement with those before them.

    Args:
        flying: With what is flown.

    Source: an interval's mass is what fuel before it has left, its share what its strategy makes of its power and of
        the charge before it, its oil as warm as losses before it have made it. Every round takes fuel, losses, shares
        and temperatures of the round before; what is wrong begins later each time. A flight keeps that with which it
        settled: it is the same whatever others it is found with.
    """
    asked, outside = _asked(flying)
    guess, none = _first(flying, asked), np.zeros(len(outside), bool)
    if not (flying.follows or flying.coupled):
        free = balanced_rounds(flying.gearbox, asked)
        round_ = Followed(free, asked, flying.deck.pitch, guess, guess.warm, guess.warm, outside, none, none)
        return round_._replace(moving=_open(flying, round_, ~free.settled))
    for count in range(2 * _MOST):
        round_ = _round(flying, asked, guess, outside)
        if flying.deck.warms and not flying.planning:
            starts, ends = _warmths(flying, round_)
            round_ = round_._replace(starts=starts, after=ends)
            round_ = round_._replace(unoiled=_unoiled(flying, round_))
        after, moved = _after(flying, round_, guess, shares=count < _MOST)
        going = _open(flying, round_, moved | ~round_.found.settled)
        round_ = round_._replace(moving=going)
        if not going.any():
            break
        columns = zip(guess, after, strict=True)
        guess = Guess(*(np.where(going[:, None] if new.ndim == 2 else going, new, old) for old, new in columns))
    return round_


def _open(flying: Flying, round_: Followed, moving: Bools) -> Bools:
    """Return the intervals of flights that have not settled; what follows on one that is refused does not count."""
    counts, stops = moving.copy(), round_.unflown | round_.unoiled | round_.found.fails
    if stops.any():
        for lanes in flying.deck.flights:
            counts[lanes] &= np.cumsum(stops[lanes]) - stops[lanes] == 0
    owner = flying.deck.owner
    return np.asarray((np.bincount(owner, counts) > 0.0)[owner])


def _first(flying: Flying, asked: Asked) -> Guess:
    """Return with what the rounds begin."""
    gearbox, deck = flying.gearbox, flying.deck
    count, train = len(deck.pitch), gearbox.sizing.train
    held = tuple(joint for joint in train.joints if joint.overrunning or not joint.is_open)
    nodes = gearbox.way(held, frozenset(train.machines)).speeds * asked.speed[:, None]
    share = deck.strategies.begun() if deck.strategies else np.zeros(count)
    warm = np.full((count, 4), math.nan)
    for lanes, mission in zip(deck.flights, deck.missions, strict=True):
        if mission.oil.network is not None and not flying.planning:
            warm[lanes] = oil_start(mission.oil.network, mission.oil.inlet_temperature_k)
    return Guess(np.zeros(count), no_losses(gearbox, count), share, warm, np.zeros((count, len(train.meshes))), nodes)


def _asked(flying: Flying) -> tuple[Asked, Bools]:
    """Return what is asked of the gearbox, and where a held pitch is outside its map."""
    gearbox, blades, supply, deck, *_ = flying
    course, none = deck.course, np.zeros(len(deck.pitch))
    wanted, outside = asked_power(blades, course, deck.pitch)
    spin_up = gearbox.inertia * course.propeller_speed * course.propeller_gain / course.duration
    parts = np.stack([deck.parts.get(name, none) for name in gearbox.machines], axis=1)
    taken = np.array([gearbox.taken.get(name, 0.0) for name in gearbox.machines])
    given, oil = np.where(np.isnan(course.power), 0.0, course.power), np.full(len(none), math.nan)
    asked = Asked(
        deck.first, course.starts_phase, wanted, given, course.propeller_speed, spin_up, none, oil, parts,
        np.broadcast_to(taken, parts.shape),
    )  # fmt: skip
    nodes = _first(flying, asked).nodes
    return asked._replace(dragged=dragged_along(supply, deck.driven, flying.speeds(nodes))), outside


def _round(flying: Flying, asked: Asked, guess: Guess, outside: Bools) -> Followed:
    gearbox, blades, supply, deck, *_ = flying
    pitch, unflown, speeds = deck.pitch, outside.copy(), flying.speeds(guess.nodes)
    asked = asked._replace(oil=guess.warm[:, OIL], wanted=asked.wanted.copy())
    if deck.craft is not None:
        rows, pitch = np.flatnonzero(deck.craft.asks), pitch.copy()
        craft, course = deck.craft.at(rows), deck.course.at(rows)
        thrust, stalled = needed_thrust(craft, course, guess.burnt[rows])
        pitch[rows], asked.wanted[rows], beyond = angle_for_thrusts(blades, course, craft, thrust / deck.engines[rows])
        unflown[rows] = stalled | beyond
    driven = deck.driven
    if deck.strategies is not None:
        parts, idle = deck.strategies.parts(deck.parts, guess.share), np.zeros(len(pitch))
        driven = {name: np.where(deck.strategies.follows, parts[name] != 0.0, on) for name, on in driven.items()}
        asked = asked._replace(parts=np.stack([parts.get(name, idle) for name in gearbox.machines], axis=1))
    asked = asked._replace(dragged=dragged_along(supply, driven, speeds))
    tails: dict[int, tuple[int, Trim]] = {}
    if len(deck.rotors):
        asked, tails = _trimmed(flying, asked, guess.burnt, unflown)
    found = balanced_rounds(gearbox, asked, guess.known)
    if tails and not flying.planning:  # losses hardly change with what the tail takes: corrected once
        for k, (place, trim) in tails.items():
            part, tail = -asked.taken[k, place], trim.tail or 0.0
            over = part / (1.0 - part) * tail / -found.point.machine_powers[k, place]
            asked.taken[k, place] = -over / (1.0 + over)  # what all others take does not depend on it
        found = balanced_rounds(gearbox, asked, guess.known)
    none = np.zeros(len(pitch), bool)
    return Followed(found, asked, pitch, guess, guess.warm, guess.warm, unflown, none, none)


def _trimmed(flying: Flying, asked: Asked, burnt: Floats, unflown: Bools) -> tuple[Asked, dict[int, tuple[int, Trim]]]:
    """Return what is asked of the gearbox by the trim of helicopters, and the tail rotors that are machines of it."""
    gearbox, deck, tails = flying.gearbox, flying.deck, dict[int, tuple[int, Trim]]()
    asked = asked._replace(taken=asked.taken.copy())
    for k, moment in zip(deck.rotors.tolist(), deck.course.at(deck.rotors).moments(), strict=True):
        mission = deck.mission(k)
        craft = mission.rotorcraft
        assert craft is not None  # `deck_of`
        try:
            trim = trimmed(craft, mission, moment, diameter=flying.blades.diameter, burnt=float(burnt[k]))
        except DesignError:
            asked.wanted[k], unflown[k] = 0.0, True
            continue
        asked.wanted[k] = trim.main
        if craft.tail is not None and trim.tail is not None and craft.tail.machine in gearbox.taken:
            place = gearbox.machines.index(craft.tail.machine)
            asked.taken[k, place] = -trim.tail / (trim.main + trim.tail)
            tails[k] = place, trim
    return asked, tails


def _after(flying: Flying, round_: Followed, guess: Guess, *, shares: bool) -> tuple[Guess, Bools]:
    """Return what a round makes of a guess, and where it differs; shares that will not agree stay as they are."""
    gearbox, _, supply, deck, *_ = flying
    found = round_.found
    heavy = np.array([mission.aircraft.mass if mission.aircraft else np.inf for mission in deck.missions])[deck.owner]
    powers = given_powers(gearbox.machines, round_.asked, found)
    burnt = _before(deck, fuel_along(supply, deck.course, powers) * deck.course.duration * deck.engines)
    nodes = found.point.speeds
    share = _shares(flying, powers, guess.share, flying.speeds(nodes)) if shares else guess.share
    warm = round_.starts
    moved = (np.abs(burnt - guess.burnt) > _SAME * heavy) | (np.abs(share - guess.share) > AGREED)
    moved |= np.any(np.abs(warm - guess.warm) > _WARM * warm, axis=1)
    moved |= np.any(np.abs(nodes - guess.nodes) > _WARM * np.abs(nodes), axis=1)
    return Guess(burnt, found.lost, share, warm, found.point.mesh_torques, nodes), moved


def _warmths(flying: Flying, round_: Followed) -> tuple[Floats, Floats]:
    """Return the temperatures of gearboxes at the start and the end of every interval, shape (n, 4) each [K]."""
    deck, point, friction = flying.deck, round_.found.point, round_.found.friction
    start, end = (np.full((len(deck.pitch), 4), math.nan) for _ in range(2))
    heat = (point.mesh_loss, *friction)
    for lanes, mission in zip(deck.flights, deck.missions, strict=True):
        rules = mission.oil.network
        if rules is None:
            continue
        begun, air = oil_start(rules, mission.oil.inlet_temperature_k), deck.course.air.temperature[lanes]
        heats, mass = [GearHeat(*row) for row in np.stack(heat, axis=1)[lanes].tolist()], flying.gearbox.sizing.mass
        start[lanes], end[lanes] = oil_along(rules, mass, begun, heats, air=air, duration=deck.course.duration[lanes])
    return start, end


def _shares(flying: Flying, powers: dict[str, Floats], share: Floats, speeds: dict[str, Floats]) -> Floats:
    """Return the motors' part of the machines' power by their strategies; as it is where there are none [-]."""
    _, _, supply, deck, planning, _ = flying
    if deck.strategies is None:
        return share
    power = sum((powers[name] for name in (*supply.engines, *supply.motors)), np.zeros(len(share)))
    available = available_along(supply, deck.course, speeds, deck.rating, deck.strategies.working)
    begun = np.array([mission.battery.start_charge if mission.battery else 0.0 for mission in deck.missions])
    demand = Demand(power, available, begun[deck.owner], deck.course.duration)
    share = deck.strategies.shares(demand)
    if supply.pack is not None and deck.strategies.charging:
        electric = electric_along(supply, deck.course, deck.flights, powers, speeds)
        for lanes in deck.flights:
            battery = Charging(lanes, electric.bus, deck.course.air.temperature, powers, speeds, share, planning)
            deck.strategies.charged(supply, demand, battery)
    return share


def _before(deck: Deck, spent: Floats) -> Floats:
    """Return what every flight has spent before each interval, of what each spends."""
    sums = np.zeros(len(spent))
    for lanes in deck.flights:
        sums[lanes.start + 1 : lanes.stop] = np.cumsum(spent[lanes.start : lanes.stop - 1])
    return sums


def planned(flying: Flying) -> Flying:
    """Return with what a flight is flown whose shares are planned.

    Args:
        flying: With what one flight is flown, of optimal strategies.

    Raises:
        DesignError: An interval cannot be flown, or no shares can fly all of them.
    """
    deck, supply, mission = flying.deck, flying.supply, flying.deck.missions[0]
    for _ in range(PLANS):
        trying = flying._replace(deck=deck, planning=True)
        round_ = followed(trying)
        told = refusal(deck, slice(0, len(deck.pitch)), doubts_before(trying, round_))
        if told is not None:
            raise told
        assert deck.strategies is not None  # there are rules
        powers = given_powers(flying.gearbox.machines, round_.asked, round_.found)
        names = (*supply.engines, *supply.motors)
        power = sum((powers[name] for name in names), np.zeros(len(deck.pitch)))
        columns = dict(zip(flying.gearbox.machines, round_.asked.parts.T, strict=True))
        share = sum((columns[name] for name in supply.motors), np.zeros(len(power)))
        weights = [supply.weights(stretch.phase) for stretch in deck.stretches]
        needs = Needs(
            deck.course, deck.rating, power, trying.speeds(round_.found.point.speeds),
            {name: np.array([one.get(name, 0.0) for one in weights])[deck.whose] for name in names}, share,
        )  # fmt: skip
        strategies = deck.strategies._replace(planned=planned_shares(supply, mission, needs))
        deck = deck._replace(strategies=strategies)
    return flying._replace(deck=deck)


# ----------------------------------------------------------------------------------------------------------------------
# What cannot be flown: laws that refuse an interval, in the order in which it is asked, and the first of them told.
# ----------------------------------------------------------------------------------------------------------------------


def refusal(deck: Deck, lanes: slice, doubts: Sequence[Doubt]) -> DesignError | None:
    """Return what is wrong with a flight, with phase and time, or None.

    Args:
        deck: What is asked.
        lanes: The flight's intervals.
        doubts: In the order in which laws are asked.

    Raises:
        SolveError: A computation did not succeed.
    """
    for k in np.flatnonzero(np.any([doubt.where[lanes] for doubt in doubts], axis=0)) + lanes.start:
        for doubt in doubts:
            if doubt.where[k]:
                try:
                    doubt.words(int(k))
                except DesignError as error:
                    at, time = f"phases.{deck.course.phase[k]}", float(deck.course.time[k])
                    problems = [f"at {time:.0f} s, {problem.path}: {problem.message}" for problem in error.problems]
                    return DesignError([Problem(at, problem) for problem in problems])
    return None


def doubts_before(flying: Flying, round_: Followed) -> list[Doubt]:
    """Return where laws refuse an interval up to the loads of the gearbox.

    Args:
        flying: With what is flown.
        round_: Its intervals.
    """
    gearbox, blades, supply, deck, *_ = flying
    oil, found, asked = warm_oil(gearbox, round_.guess.warm[:, OIL]), round_.found, round_.asked

    def wanted(k: int) -> None:
        wanted_of(blades, deck.mission(k), deck.course.moment(k), burnt=float(round_.guess.burnt[k]))

    def mode(k: int) -> None:
        raise deck.refused[int(deck.whose[k])]

    def tail(k: int) -> None:
        craft = deck.mission(k).rotorcraft
        assert craft is not None and craft.tail is not None  # of these intervals
        name = craft.tail.machine
        message = f"no load or tail rotor of the design is called {name!r}; {near(name, gearbox.taken)}"
        raise DesignError([Problem("rotorcraft.tail.machine", message)])

    def unbalanced(k: int) -> None:
        raise found.faults[k]

    def eaten(k: int) -> None:
        given, spin_up, dragged = (float(column[k]) for column in (asked.given, asked.spin_up, asked.dragged))
        raise DesignError(
            [Problem("power", _eaten(given, spin_up, given - spin_up - dragged - float(found.short[k]), dragged))]
        )

    def open_(k: int) -> None:
        raise SolveError(f"at {deck.course.time[k]:.0f} s the loads of the intervals do not agree with those before")

    none = np.zeros(len(deck.pitch), bool)
    stiff = np.broadcast_to(too_stiff(oil), none.shape) if deck.warms and not flying.planning else none
    lacking, lone = none.copy(), np.isin(deck.whose, list(deck.refused))
    for k in deck.rotors.tolist():
        craft = deck.mission(k).rotorcraft
        lacking[k] = craft is not None and craft.tail is not None and craft.tail.machine not in gearbox.taken
    share = sum((asked.parts[:, gearbox.machines.index(name)] for name in supply.motors), np.zeros(len(none)))
    return [
        Doubt(stiff, lambda k: refuse_stiff(oil._replace(temperature=float(round_.guess.warm[k, OIL])))),
        Doubt(round_.unflown, wanted),
        Doubt(lone, mode),
        *strategy_doubts(supply, deck.stretches, deck.whose, share),
        Doubt(lacking, tail),
        Doubt(has_fault(found.faults), unbalanced),
        Doubt(~np.isnan(found.short), eaten),
        Doubt(round_.moving & ~found.settled, open_),
    ]


def _eaten(power: float, spin_up: float, rubbed: float, dragged: float) -> str:
    """Return what takes a power before it reaches the propeller."""
    parts = (("bearings and oil", rubbed), ("motors that are dragged", dragged), ("spinning the train up", spin_up))
    taken = ", ".join(f"{name} {1e-3 * value:.3g} kW" for name, value in parts if value > 0.0)
    fix = "give more, or a longer ramp_s" if spin_up > 0.0 else "give more"
    return f"of {1e-3 * power:.4g} kW nothing reaches the propeller: {taken}; {fix}"


def doubt_of_oil(flying: Flying, round_: Followed) -> Doubt:
    """Return where oil, gears or bearings become too warm.

    Args:
        flying: With what is flown.
        round_: Its intervals.
    """
    deck, found = flying.deck, round_.found

    def words(k: int) -> None:
        rules, warm = deck.mission(k).oil.network, Warm(*round_.guess.warm[k].tolist())
        assert rules is not None  # of these intervals
        heat = GearHeat(float(found.point.mesh_loss[k]), *(float(loss[k]) for loss in found.friction))
        air, duration = float(deck.course.air.temperature[k]), float(deck.course.duration[k])
        oil_step(rules, flying.gearbox.sizing.mass, warm, heat=heat, air=air, duration=duration)

    return Doubt(_too_warm(flying, round_), words)


def _too_warm(flying: Flying, round_: Followed) -> Bools:
    too_warm = np.zeros(len(flying.deck.pitch), bool)
    for lanes, mission in zip(flying.deck.flights, flying.deck.missions, strict=True):
        if (rules := mission.oil.network) is not None:
            limits = np.array([rules.highest_oil_k, rules.highest_gears_k, rules.highest_bearings_k])
            too_warm[lanes] = ~(round_.after[lanes, :3] <= limits * (1.0 + 1e-12)).all(axis=1)
    return too_warm


def _unoiled(flying: Flying, round_: Followed) -> Bools:
    """Return where oil is too cold to flow, or oil, gears or bearings become too warm."""
    stiff = too_stiff(warm_oil(flying.gearbox, round_.guess.warm[:, OIL]))
    return np.asarray(stiff | _too_warm(flying, round_))


# ----------------------------------------------------------------------------------------------------------------------
# One load alone: of paths that follow from a power, and of windows in which machines change theirs.
# ----------------------------------------------------------------------------------------------------------------------


def loaded(gearbox: Gearbox, supply: Supply, parts: Mapping[str, float], *, power: float, speed: float) -> Balanced:
    """Return the gearbox where its machines give a power, as a flight of one interval.

    Args:
        gearbox: The gearbox.
        supply: Its machines.
        parts: Machine -> part of the power [-].
        power: Of all machines [W].
        speed: Of the propeller [rad/s].

    Raises:
        DesignError: Nothing is left for the propeller, or nothing balances.
    """
    one, turning, many = np.ones(1, bool), np.array([speed]), np.zeros((1, len(gearbox.machines)))
    train = gearbox.sizing.train
    held = tuple(joint for joint in train.joints if joint.overrunning or not joint.is_open)
    nodes = gearbox.way(held, frozenset(train.machines)).speeds * turning[:, None]
    speeds = {name: np.abs(nodes[:, place]) for name, place in zip(gearbox.machines, gearbox.places, strict=True)}
    dragged = dragged_along(supply, {name: np.array([name in parts]) for name in supply.motors}, speeds)
    columns = [[source.get(name, 0.0) for name in gearbox.machines] + many for source in (parts, gearbox.taken)]
    none = np.full(1, math.nan)
    asked = Asked(one, one, none, np.array([power]), turning, np.zeros(1), dragged, none, columns[0], columns[1])
    found = balanced_rounds(gearbox, asked, Known(no_losses(gearbox, 1), np.zeros((1, len(train.meshes))), nodes))
    if found.faults[0] is not None:
        raise found.faults[0]
    if not np.isnan(found.short[0]):
        rubbed = power - float(dragged[0]) - float(found.short[0])
        raise DesignError([Problem("power", _eaten(power, 0.0, rubbed, float(dragged[0])))])
    return found
