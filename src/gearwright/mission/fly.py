"""The verb: a mission flown quasi-steadily by a sized gearbox."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

from gearwright.catalogue import propeller_map, read_engine_deck, read_propeller_map
from gearwright.errors import DesignError, Problem, refuse
from gearwright.machines import EngineDeck, MachMap, PropellerMap
from gearwright.mission.aircraft import paths_of
from gearwright.mission.flight import Flight
from gearwright.mission.gearbox import Gearbox, Point, flown_airscrew, gearbox_of
from gearwright.mission.intervals import Asked, Flown, Interval, Log, Lost, collect, loaded, logged, recorded, with_tail
from gearwright.mission.plant import (
    GearHeat,
    PackState,
    Warm,
    Warmths,
    flown_oil,
    oil_start,
    oil_step,
    refuse_stiff,
    started,
)
from gearwright.mission.profile import Moment, moments
from gearwright.mission.strategies import Then, planned_shares, shared
from gearwright.mission.supply import Clocks, Given, Terms, bounds_of, endured, machine_speeds, supply_of
from gearwright.mission.thrust import Blades, performed, wanted_of, windmilling
from gearwright.mission.together import Reached, flights_together, log_at_once
from gearwright.sizing import Sizing
from gearwright.spec import NO_MAP, Mission, engine_out, is_map_file, mission_problems
from gearwright.verbs import verb


class _Before(NamedTuple):
    """What an interval takes over from the one before it."""

    point: Point | None
    """Of the gearbox; None at the start."""
    pack: PackState
    """Of the battery."""
    warmths: Warmths
    """Of the motors."""
    warm: Warm | None
    """Of the gearbox; None where a mission does not follow it."""
    burnt: float
    """Fuel of all engines [kg]."""
    clocks: Clocks
    """How long limits of machines have been passed."""


@verb
def fly(sizing: Sizing, mission: Mission, *, folder: Path | None = None) -> Flight:
    """Return the flight: what a mission asks of every shaft and mesh, and what it burns.

    Every interval is in equilibrium, with the power that spins the train up; the aircraft's own acceleration between
    two phases is left out. Drag and spin-up load the machines, not the meshes.

    Args:
        sizing: The sized transmission; it has one propeller.
        mission: What is flown, with one such gearbox for each of its engines.
        folder: Where files that it names are looked for, map and deck; left out: where the program runs.

    Raises:
        DesignError: A power that the machines cannot give, a battery that is empty or overloaded, a point outside the
            propeller map; with phase and time.

    Valid for: steady flight; a propeller map of one's own has the compressibility that it was measured with.
    """
    flown = _prepared(sizing, mission, folder)
    found = log_at_once(flown)
    return collect(flown, found if isinstance(found, Log) else _one_by_one(flown, found))


@verb
def fly_each(sizing: Sizing, missions: Sequence[Mission], *, folder: Path | None = None) -> list[Flight | DesignError]:
    """Return the flight of each mission, or why it cannot be flown; those that differ by numbers are flown together.

    A flight has the same bits whatever others it is flown with.

    Args:
        sizing: The sized transmission.
        missions: What is flown.
        folder: Where propeller maps are looked for that are files.
    """
    found: list[Flight | DesignError] = []
    prepared = list[Flown | DesignError]()
    for mission in missions:
        known = next((flown.gearbox for flown in reversed(prepared) if isinstance(flown, Flown)), None)
        prepared.append(_attempted(sizing, mission, folder, known))
    for alike in _alike(prepared):
        together = flights_together(alike) if isinstance(alike[0], Flown) else [None]
        for flown, flight in zip(alike, together, strict=True):
            found.append(flight if isinstance(flight, Flight) else _alone(flown, flight))
    return found


def _alike(prepared: Sequence[Flown | DesignError]) -> Iterator[list[Any]]:
    """Yield neighbours that are flown with the same machines, oil and propeller; what cannot be flown stands alone."""
    group: list[Any] = []
    for flown in prepared:
        if group and not (isinstance(flown, Flown) and isinstance(group[0], Flown) and _same(group[0], flown)):
            yield group
            group = []
        group.append(flown)
    if group:
        yield group


def _same(one: Flown, other: Flown) -> bool:
    kept = one.mission.propeller_map == other.mission.propeller_map and one.gearbox.oil == other.gearbox.oil
    return kept and one.supply == other.supply


def _attempted(sizing: Sizing, mission: Mission, folder: Path | None, known: Gearbox | None) -> Flown | DesignError:
    try:
        return _prepared(sizing, mission, folder, known)
    except DesignError as error:
        return error


def _alone(flown: Flown | DesignError, reached: Reached | None) -> Flight | DesignError:
    if isinstance(flown, DesignError):
        return flown
    try:
        return collect(flown, _one_by_one(flown, reached))
    except DesignError as error:
        return error


def _prepared(sizing: Sizing, mission: Mission, folder: Path | None, known: Gearbox | None = None) -> Flown:
    """Return what flies; a gearbox that is ready to fly is made ready again where its oil is another."""
    refuse(mission_problems(mission))
    oil = flown_oil(sizing, mission)
    gearbox = known if known and known.oil == oil else gearbox_of(sizing, flown_airscrew(sizing), oil)
    blades = Blades(mission.propeller_map, _chart(mission, folder), sizing.design.airscrews[gearbox.propeller].diameter)
    flown = Flown(gearbox, blades, mission, supply_of(sizing, mission, _deck(mission, folder)))
    return flown._replace(paths=paths_of(flown))


def _one_by_one(flown: Flown, reached: Reached | None) -> Log:
    """Fly the intervals one after the other; where one is reached that cannot be flown, it says so at once."""
    if reached is not None:
        _tried(flown, reached)
    mission, before, intervals = flown.mission, _start(flown), list[Interval]()
    plan = planned_shares(flown)
    for k, moment in enumerate(moments(mission, flown.paths)):
        try:
            interval = _interval(flown, moment, before, plan.get(k, 0.0))
            clocks = _clocks(flown, moment, interval, before.clocks)
        except DesignError as error:
            raise _placed(error, moment) from None
        intervals.append(interval)
        engines = mission.phases[moment.phase].engines or mission.engines
        burnt = before.burnt + interval.values.fuel_flow * moment.duration * engines
        before = _Before(interval.point, interval.pack, interval.warmths, interval.warm, burnt, clocks)
    return logged(intervals)


def _tried(flown: Flown, reached: Reached) -> None:
    """Fly the interval that a flight reaches."""
    moment = next(islice(moments(flown.mission, flown.paths), reached.place, None))
    pack = PackState(reached.charge)
    before = _start(flown)._replace(point=reached.point, pack=pack, burnt=reached.burnt)
    try:
        _clocks(flown, moment, _interval(flown, moment, before, 0.0), before.clocks)
    except DesignError as error:
        raise _placed(error, moment) from None


def _start(flown: Flown) -> _Before:
    """Return with what a flight begins."""
    rules, supply = flown.mission.battery, flown.supply
    charge = rules.start_charge if rules else 0.0
    pack = supply.pack.start(charge) if supply.pack else PackState(charge)
    air = next(iter(moments(flown.mission, flown.paths))).air.temperature
    oil = flown.mission.oil
    warm = oil_start(oil.network, oil.inlet_temperature_k) if oil.network else None
    return _Before(None, pack, started(supply.windings, supply.motors, air), warm, 0.0, {})


def _chart(mission: Mission, folder: Path | None) -> PropellerMap | MachMap | None:
    name = mission.propeller_map
    if name == NO_MAP:
        return None
    return read_propeller_map((folder or Path()) / name) if is_map_file(name) else propeller_map(name)


def _deck(mission: Mission, folder: Path | None) -> EngineDeck | None:
    name = mission.engine.deck
    return None if name is None else read_engine_deck((folder or Path()) / name)


def _placed(error: DesignError, moment: Moment) -> DesignError:
    at = f"phases.{moment.phase}"
    return DesignError(
        [Problem(at, f"at {moment.time:.0f} s, {problem.path}: {problem.message}") for problem in error.problems]
    )


def _interval(flown: Flown, moment: Moment, before: _Before, planned: float) -> Interval:
    """Return what is recorded of an interval."""
    flown = _oiled(flown, before.warm)
    gearbox, blades, mission, supply, _ = flown
    phase = mission.phases[moment.phase]
    wanted = wanted_of(blades, mission, moment, burnt=before.burnt)
    spin_up = gearbox.inertia * moment.propeller_speed * moment.propeller_gain / moment.duration
    asked = Asked(supply.parts(phase), wanted.power, spin_up)
    if phase.strategy is not None:
        phase, asked = shared(flown, moment, asked, Then(phase, before.point, before.pack.charge, planned))
    flown = with_tail(flown, moment, asked, before.point, burnt=before.burnt)
    gearbox = flown.gearbox
    point, friction, dragged, powers = loaded(flown, moment, asked, before.point)
    rating = mission.engine.contingency if engine_out(mission, phase) else 1.0
    terms = Terms(before.pack, before.warmths, rating, phase.mode)
    try:
        drawn = supply.drive(gearbox, moment, Given(point, powers), terms)
    except DesignError as error:
        raise windmilling(error, blades, moment, wanted) from None
    performance = performed(blades, moment, point.work, pitch=wanted.pitch)
    lost = Lost(point.mesh_loss, friction, drawn.motor_loss + dragged, spin_up)
    share = sum(asked.parts.get(name, 0.0) for name in supply.motors)
    warm = _warmed(flown, moment, before.warm, lost)
    values = recorded(moment, performance, drawn, lost=lost, work=point.work, share=share, warm=warm)
    return Interval(moment.phase, values, powers, point, drawn.pack, drawn.warmths, warm)


def _oiled(flown: Flown, warm: Warm | None) -> Flown:
    """Return what flies with oil as warm as it is."""
    if warm is None:
        return flown
    oil = flown.gearbox.oil._replace(temperature=warm.oil)
    refuse_stiff(oil)
    return flown._replace(gearbox=replace(flown.gearbox, oil=oil))


def _warmed(flown: Flown, moment: Moment, warm: Warm | None, lost: Lost) -> Warm | None:
    """Return the temperatures of a gearbox at the end of an interval."""
    rules = flown.mission.oil.network
    if warm is None or rules is None:
        return None
    heat, mass = GearHeat(lost.meshes, *lost.friction), flown.gearbox.sizing.mass
    air, duration = moment.air.temperature, moment.duration
    return oil_step(rules, mass, warm, heat=heat, air=air, duration=duration)[0]


def _clocks(flown: Flown, moment: Moment, interval: Interval, before: Clocks) -> Clocks:
    """Return how long limits of machines have been passed after an interval."""
    gearbox, _, mission, supply, _ = flown
    contingency = mission.engine.contingency if engine_out(mission, mission.phases[moment.phase]) else 1.0
    overload = dict.fromkeys(supply.motors, mission.motor.overload) | dict.fromkeys(supply.engines, contingency)
    ratings = {name: rating * overload[name] for name, rating in supply.ratings.items()}
    speeds = machine_speeds(gearbox, interval.point)
    points = {name: (power, speeds[name]) for name, power in interval.powers.items()}
    return endured(bounds_of(gearbox.sizing.design.machines, ratings), before, moment.duration, points)
