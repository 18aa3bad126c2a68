"""The verb: a mission flown quasi-steadily by a sized gearbox, alone or with others that differ by numbers."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Ints, Problem, refuse, verb
from gearwright.catalogue import propeller_map, read_engine_deck, read_propeller_map
from gearwright.machines import EngineDeck, MachMap, PropellerMap
from gearwright.mission.aircraft import paths_of
from gearwright.mission.flight import (
    Balance,
    Flight,
    History,
    MachineHistory,
    MeshHistory,
    NodeHistory,
    PackWear,
    consumed,
    fuel_energy,
)
from gearwright.mission.gearbox import ROUNDS, Drag, Gearbox, Point, flown_airscrew, gearbox_of, given_powers
from gearwright.mission.intervals import (
    Deck,
    Flown,
    Flying,
    Followed,
    deck_of,
    doubt_of_oil,
    doubts_before,
    followed,
    planned,
    refusal,
    shortened,
)
from gearwright.mission.plant import (
    BEARINGS,
    GEARS,
    HOUSING,
    OIL,
    DryRun,
    GearHeat,
    Pack,
    PackState,
    Warm,
    dry_run,
    flown_oil,
)
from gearwright.mission.profile import Doubt, spread
from gearwright.mission.strategies import driven, has_plan
from gearwright.mission.supply import (
    Burnt,
    Discharged,
    Supply,
    bounds_of,
    burnt_along,
    discharged,
    electric_along,
    outlasted,
    supply_of,
)
from gearwright.mission.thrust import Blades, Performance, Wanted, performance_along, performed, windmilling
from gearwright.parts.losses import cooler_conductance, oil_flow
from gearwright.sizing import Sizing
from gearwright.spec import NO_MAP, Mission, is_map_file, mission_problems

# ----------------------------------------------------------------------------------------------------------------------
# Missions flown: prepared one by one, and flown together where gearbox, machines, oil and propeller are the same.
# ----------------------------------------------------------------------------------------------------------------------


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
    (found,) = _flights([_prepared(sizing, mission, folder)])
    if isinstance(found, DesignError):
        raise found
    return found


@verb
def fly_each(sizing: Sizing, missions: Sequence[Mission], *, folder: Path | None = None) -> list[Flight | DesignError]:
    """Return the flight of each mission, or why it cannot be flown; those that differ by numbers are flown together.

    A flight has the same bits whatever others it is flown with.

    Args:
        sizing: The sized transmission.
        missions: What is flown.
        folder: Where propeller maps are looked for that are files.
    """
    prepared = list[Flown | DesignError]()
    for mission in missions:
        known = next((flown.gearbox for flown in reversed(prepared) if isinstance(flown, Flown)), None)
        prepared.append(_attempted(sizing, mission, folder, known))
    found: list[Flight | DesignError] = []
    for alike in _alike(prepared):
        found += _flights(alike) if isinstance(alike[0], Flown) else alike
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
    alike = [
        (flown.mission.propeller_map, flown.gearbox.oil, flown.mission.oil.network is None, flown.supply)
        for flown in (one, other)
    ]
    planned = has_plan(one.supply, one.mission) or has_plan(other.supply, other.mission)
    return alike[0] == alike[1] and not planned


def _attempted(sizing: Sizing, mission: Mission, folder: Path | None, known: Gearbox | None) -> Flown | DesignError:
    try:
        return _prepared(sizing, mission, folder, known)
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


def _chart(mission: Mission, folder: Path | None) -> PropellerMap | MachMap | None:
    name = mission.propeller_map
    if name == NO_MAP:
        return None
    return read_propeller_map((folder or Path()) / name) if is_map_file(name) else propeller_map(name)


def _deck(mission: Mission, folder: Path | None) -> EngineDeck | None:
    name = mission.engine.deck
    return None if name is None else read_engine_deck((folder or Path()) / name)


# ----------------------------------------------------------------------------------------------------------------------
# All intervals of flights at once: what each asks of gearbox, machines and battery, and what it gets.
# ----------------------------------------------------------------------------------------------------------------------


class Together(NamedTuple):
    """What intervals ask and get; arrays have a first axis of n."""

    point: Point
    friction: Drag
    powers: dict[str, Floats]
    """Machine -> power into the train, with drag and spin-up [W]."""
    work: Floats
    """Power of the propeller's shaft [W]."""
    mesh_loss: Floats
    motor_loss: Floats
    """With those that are dragged [W]."""
    spin_up: Floats
    share: Floats
    """Motors' part [-]."""
    performance: Performance
    burnt: Burnt
    winding: Floats | None
    warm: Floats
    """Temperatures of the gearbox at the end of each interval, shape (n, 4); NaN: not followed [K]."""
    open: Bools
    """Where loads and losses do not agree yet."""
    battery: Discharged
    doubts: tuple[Doubt, ...]
    """Where a law refuses an interval, in the order in which they are asked."""


class Log(NamedTuple):
    """What is known of all intervals of one flight."""

    phase: tuple[str, ...]
    history: History[Floats]
    point: Point
    powers: Mapping[str, Floats]
    """Machine -> power into the train [W]."""
    end: PackState
    """Of the battery."""
    warm: Floats
    """Temperatures of the gearbox at the end of each interval, shape (n, 4); NaN: not followed [K]."""


def _flights(all_flown: Sequence[Flown], *, coupled: bool = False) -> list[Flight | DesignError]:
    """Return the flight of each, or why it cannot be flown.

    Args:
        all_flown: With the same gearbox, machines and propeller; their missions differ in numbers.
        coupled: Whether rounds go on until loads and losses agree, also where a few should do.
    """
    gearbox, blades, mission, supply, _ = all_flown[0]
    try:
        flying = Flying(gearbox, blades, supply, deck_of(all_flown), coupled=coupled)
        with np.errstate(all="ignore"):  # of what follows on an interval that cannot be flown
            if has_plan(supply, mission):
                flying = planned(flying)
            whole = _flown_together(flying)
    except DesignError as error:  # one that has no course is told why alone, and does not stop the others
        if len(all_flown) == 1:
            return [error]
        half = len(all_flown) // 2
        return _flights(all_flown[:half], coupled=coupled) + _flights(all_flown[half:], coupled=coupled)
    deck, found = flying.deck, list[Flight | DesignError]()
    history = _history_of(deck, whole)
    for place, flown in enumerate(all_flown):
        if whole.open[deck.flights[place]].any() and not (coupled or flying.follows):
            found += _flights([flown], coupled=True)
            continue
        told = refusal(deck, deck.flights[place], whole.doubts)
        found.append(_collected(flown, _log(deck, whole, place, history)) if told is None else told)
    return found


def _collected(flown: Flown, log: Log) -> Flight | DesignError:
    try:
        return _collect(flown, log)
    except DesignError as error:
        return error


def _flown_together(flying: Flying) -> Together:
    """Return what all intervals ask and get; those that are asked what the one before is asked get what it gets, as
    soon as rounds would have settled.
    """
    gearbox, blades, supply, deck, *_ = flying
    everywhere = np.arange(len(deck.pitch))
    wound = supply.windings is not None and bool(supply.motors)
    short, source = (deck, everywhere) if flying.follows or wound or flying.coupled else shortened(deck, ROUNDS)
    flying = flying._replace(deck=short)
    settled = followed(flying)
    found, asked, pitch, *_ = settled
    course, point, speeds = short.course, found.point, flying.speeds(found.point.speeds)
    work, powers = point.work, given_powers(gearbox.machines, asked, found)
    performance, left = performance_along(blades, course, work, pitch=pitch)
    burnt, weak = burnt_along(supply, course, powers, speeds, short.rating)
    share = sum((asked.parts[:, gearbox.machines.index(name)] for name in supply.motors), np.zeros(len(work)))

    def mode(k: int) -> str:
        """Return the mode of a phase as the interval is driven."""
        phase = short.phase(k)
        return (phase if phase.strategy is None else driven(phase, float(share[k]))).mode

    def blown(k: int) -> None:
        performed(blades, course.moment(k), float(work[k]), pitch=None if np.isnan(pitch[k]) else float(pitch[k]))

    electric = electric_along(supply, course, short.flights, powers, speeds, mode)
    starts = [mission.battery.start_charge if mission.battery else 0.0 for mission in deck.missions]
    battery = discharged(supply, starts, deck.flights, power=electric.bus[source], course=deck.course)
    bus = electric.bus[source]

    def drained(k: int) -> None:
        supply.refuse_battery(battery.starts(k), float(bus[k]), deck.course.moment(k), mode(int(source[k])))

    drawn = [
        *_all(deck, source, (*weak, *electric.doubts)),
        Doubt(battery.faulty, drained),
        *_all(deck, source, electric.hot),
    ]
    limits = _limits(flying, deck, spread(powers, source), spread(speeds, source))
    doubts = [
        *_all(deck, source, doubts_before(flying, settled)),
        *(_blamed(flying, source, settled, doubt) for doubt in drawn),
        *_all(deck, source, [Doubt(left | np.isnan(work), blown), doubt_of_oil(flying, settled)]),
        *limits,
    ]
    mesh_loss = point.mesh_loss
    columns = (
        point, found.friction, powers, work, mesh_loss, electric.heat + asked.dragged, asked.spin_up, share,
        performance, burnt, electric.winding, settled.after, settled.moving,
    )  # fmt: skip
    values: tuple[Any, ...] = (*spread(columns, source), battery, tuple(doubts))
    return Together(*values)


def _all(deck: Deck, source: Ints, doubts: Sequence[Doubt]) -> Iterator[Doubt]:
    """Yield what laws refuse of all intervals, from what they refuse of those that speak for them."""
    for doubt in doubts:
        yield Doubt(doubt.where[source], _asked_by(doubt.words, source))


def _asked_by(words: Callable[[int], None], source: Ints) -> Callable[[int], None]:
    """Return the words on an interval that are those on another one."""
    return lambda k: words(int(source[k]))


def _blamed(flying: Flying, source: Ints, settled: Followed, doubt: Doubt) -> Doubt:
    """Return a doubt of machines that blames the air where it drives a propeller that has to brake."""

    def words(k: int) -> None:
        try:
            doubt.words(k)
        except DesignError as error:
            place = int(source[k])
            power, pitch = (float(column[place]) for column in (settled.asked.wanted, settled.pitch))
            wanted = Wanted(None if np.isnan(power) else power, None if np.isnan(pitch) else pitch)
            raise windmilling(error, flying.blades, flying.deck.course.moment(place), wanted) from None

    return Doubt(doubt.where, words)


def _limits(flying: Flying, deck: Deck, powers: Mapping[str, Floats], speeds: Mapping[str, Floats]) -> Iterator[Doubt]:
    """Yield where machines give for too long more than they may."""
    supply, machines = flying.supply, flying.gearbox.sizing.design.machines
    if not any(machine.limits for machine in machines.values()):
        return
    for lanes, mission in zip(deck.flights, deck.missions, strict=True):
        sets = []
        for rating in np.unique(deck.rating[lanes]).tolist():
            overload = dict.fromkeys(supply.motors, mission.motor.overload) | dict.fromkeys(supply.engines, rating)
            ratings = {name: power * overload[name] for name, power in supply.ratings.items()}
            sets.append((bounds_of(machines, ratings), deck.rating[lanes] == rating))
        columns = [{name: column[lanes] for name, column in source.items()} for source in (powers, speeds)]
        doubt, late = outlasted(sets, deck.course.duration[lanes], *columns), np.zeros(len(deck.pitch), bool)
        late[lanes] = doubt.where
        yield Doubt(late, _asked_by(doubt.words, np.arange(len(late)) - lanes.start))


def _history_of(deck: Deck, found: Together) -> History[Floats]:
    """Return what is recorded of all intervals of a deck."""
    course, battery, burnt = deck.course, found.battery, found.burnt
    friction: dict[str, Any] = dict(zip(("bearing", "windage", "churning"), found.friction, strict=True))
    warm = found.warm.T.copy() if deck.warms else [None] * 4
    return History(
        time=course.time,
        duration=course.duration,
        altitude=course.altitude,
        true_airspeed=course.true_airspeed,
        mach=course.mach,
        air_temperature=course.air.temperature,
        air_density=course.air.density,
        propeller_speed=course.propeller_speed,
        propeller_gain=course.propeller_gain,
        propeller_power=found.work,
        **found.performance._asdict(),
        electric_share=found.share,
        fuel_flow=burnt.fuel_flow,
        turbine_power=burnt.power,
        turbine_available=burnt.available,
        air_flow=burnt.exhaust.air_flow,
        exhaust_temperature=burnt.exhaust.temperature,
        exhaust_heat=burnt.heat,
        casing_heat=burnt.exhaust.casing,
        battery_power=battery.open_power,
        battery_current=battery.current,
        battery_voltage=battery.voltage,
        state_of_charge=battery.charge,
        battery_temperature=battery.temperature,
        winding_temperature=found.winding,
        mesh_loss=found.mesh_loss,
        **{f"{origin}_loss": loss for origin, loss in friction.items()},
        oil_temperature=warm[OIL],
        gears_temperature=warm[GEARS],
        bearings_temperature=warm[BEARINGS],
        housing_temperature=warm[HOUSING],
        gearbox_heat=found.mesh_loss + sum(friction.values()),
        motor_loss=found.motor_loss,
        battery_loss=battery.loss,
        spin_up=found.spin_up,
    )


def _log(deck: Deck, whole: Together, place: int, history: History[Floats]) -> Log:
    """Return the log of one flight."""
    lanes = deck.flights[place]
    columns: dict[str, Any] = {
        field.name: None if (values := getattr(history, field.name)) is None else values[lanes]
        for field in fields(History)
    }
    return Log(
        phase=deck.course.phase[lanes],
        history=History(**columns),
        point=Point(*(column[lanes] for column in whole.point)),
        powers={name: power[lanes] for name, power in whole.powers.items()},
        end=whole.battery.ends[place],
        warm=whole.warm[lanes],
    )


# ----------------------------------------------------------------------------------------------------------------------
# Intervals become a flight: histories, oil, and the balance of energies.
# ----------------------------------------------------------------------------------------------------------------------


_LEAST_COOLING = 1.0
"""By how much the oil in a cooler must be warmer than the air [K]."""


def _collect(flown: Flown, log: Log) -> Flight:
    """Return the flight of its intervals."""
    gearbox, blades, mission, _, paths = flown
    history, point, train = log.history, log.point, gearbox.sizing.train
    heat = history.gearbox_heat
    oil_outlet = mission.oil.inlet_temperature_k + mission.oil.rise_k * heat / heat.max()
    if history.oil_temperature is not None:
        oil_outlet = history.oil_temperature
    rows = zip(train.nodes, point.speeds.T, point.shaft_torques.T, strict=True)
    nodes = {name: NodeHistory(*map(np.ascontiguousarray, columns)) for name, *columns in rows}
    machines = {
        name: MachineHistory(log.powers[name], nodes[shaft].speed)
        for name, shaft in train.machines.items()
        if name != gearbox.propeller
    }
    return Flight(
        mission=mission,
        sizing=gearbox.sizing,
        phase=log.phase,
        history=history,
        oil_outlet=oil_outlet,
        nodes=nodes,
        machines=machines,
        meshes=_meshes(gearbox, np.ascontiguousarray(point.mesh_torques.T)),
        balance=_balance(flown, history, consumed(gearbox.sizing, machines, history.time), log.end),
        pack=_wear(flown.supply.pack, log.end),
        oil_flow=oil_flow(float(heat.max()), mission.oil.rise_k),
        cooler_conductance=_cooler(mission, history, oil_outlet),
        dry=_dry(mission, gearbox, log),
        inertia=gearbox.inertia,
        propeller_map=blades.chart,
        engine_deck=flown.supply.deck,
        paths=paths,
    )


def _meshes(gearbox: Gearbox, torques: Floats) -> dict[str, MeshHistory]:
    rows = zip(gearbox.sizing.train.meshes, torques, torques / gearbox.teeth.radii[:, None], strict=True)
    return {mesh.name: MeshHistory(torque, force) for mesh, torque, force in rows}


def _cooler(mission: Mission, history: History[Floats], oil_outlet: Floats) -> float:
    """The largest conductance that any interval needs [W/K]."""
    if mission.oil.network is not None:
        return mission.oil.network.cooler_w_k
    warm, air = 0.5 * (mission.oil.inlet_temperature_k + oil_outlet), history.air_temperature
    if float((warm - air).min()) < _LEAST_COOLING:
        message = (
            f"{mission.oil.inlet_temperature_k:g} K: the air, of up to {float(air.max()):.4g} K,"
            " does not cool this oil; let it be warmer"
        )
        raise DesignError([Problem("oil.inlet_temperature_k", message)])
    return float(np.max(cooler_conductance(history.gearbox_heat, warm, air)))


def _dry(mission: Mission, gearbox: Gearbox, log: Log) -> DryRun | None:
    """How long the gearbox runs without oil from the end of the phase that the mission names."""
    rules = mission.oil.network
    if rules is None or rules.dry_from is None:
        return None
    k = max(place for place, phase in enumerate(log.phase) if phase == rules.dry_from)
    warm, history = Warm(*log.warm[k].tolist()), log.history
    losses = (history.mesh_loss, history.bearing_loss, history.windage_loss, history.churning_loss)
    heat = GearHeat(*(float(loss[k]) for loss in losses))
    return dry_run(rules, gearbox.sizing.mass, warm, heat=heat, air=float(history.air_temperature[k]))


def _wear(pack: Pack | None, end: PackState) -> PackWear | None:
    if pack is None or pack.cells is None:
        return None
    return PackWear(pack.mass, end.throughput, end.throughput / (2.0 * pack.battery.charge), end.worn)


def _balance(flown: Flown, history: History[Floats], taken: Floats, end: PackState) -> Balance:
    gearbox, _, mission, supply, _ = flown

    def total(power: Floats) -> float:
        return float((power * history.duration).sum())

    first = next(iter(mission.phases.values())).propeller_speed
    last = float(history.propeller_speed[-1] + 0.5 * history.propeller_gain[-1])
    fuel = fuel_energy(total(history.fuel_flow))
    return Balance(
        fuel=fuel,
        battery=_drawn(mission, supply, end),
        propeller=total(history.propeller_power),
        consumers=total(taken),
        turbine_heat=total(history.exhaust_heat) + total(history.casing_heat),
        exhaust_heat=total(history.exhaust_heat),
        casing_heat=total(history.casing_heat),
        mesh_loss=total(history.mesh_loss),
        bearing_loss=total(history.bearing_loss),
        windage_loss=total(history.windage_loss),
        churning_loss=total(history.churning_loss),
        motor_loss=total(history.motor_loss),
        battery_loss=total(history.battery_loss),
        stored=0.5 * gearbox.inertia * (last**2 - first**2),
    )


def _drawn(mission: Mission, supply: Supply, end: PackState) -> float:
    """What the battery's store has lost [J]: its state, and not the sum of what it gave."""
    if supply.pack is None or mission.battery is None:
        return 0.0
    return supply.pack.energy(supply.pack.start(mission.battery.start_charge)) - supply.pack.energy(end)
