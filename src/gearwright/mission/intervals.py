"""Loads of a mission interval, tail rotor power, and the history and energy balance of all intervals."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from gearwright.air import SEA_LEVEL_TEMPERATURE, stagnation_ratios
from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, SolveError, near
from gearwright.lanes import rebound
from gearwright.machines.turboshaft import exhaust_heat
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
    stacked,
)
from gearwright.mission.gearbox import Drag, Gearbox, Point, drag, efficiencies, operate
from gearwright.mission.plant import DryRun, GearHeat, Pack, PackState, Warm, Warmths, dry_run
from gearwright.mission.profile import Moment, Paths
from gearwright.mission.supply import Drawn, Supply
from gearwright.mission.thrust import Blades, Performance, trimmed
from gearwright.parts import losses as oil
from gearwright.parts.losses import oil_flow
from gearwright.spec import Mission

# ----------------------------------------------------------------------------------------------------------------------
# Intervals become a flight: histories, oil, and the balance of energies.
# ----------------------------------------------------------------------------------------------------------------------


_OIL = rebound(oil)
_LEAST_COOLING = 1.0
"""By how much the oil in a cooler must be warmer than the air [K]."""


class Interval(NamedTuple):
    """One flown interval."""

    phase: str
    """Name of its phase."""
    values: History[float]
    """What is recorded."""
    powers: Mapping[str, float]
    """Machine -> power into the train, with drag and spin-up [W]."""
    point: Point
    """Of the gearbox."""
    pack: PackState
    """Of the battery at its end."""
    warmths: Warmths
    """Of the motors at its end."""
    warm: Warm | None
    """Of the gearbox at its end."""


class Log(NamedTuple):
    """What is known of all intervals, for a flight."""

    phase: tuple[str, ...]
    history: History[Floats]
    point: Point
    """Of the gearbox; every field has a first axis of intervals."""
    powers: Mapping[str, Floats]
    """Machine -> power into the train [W]."""
    end: PackState
    """Of the battery."""
    warm: tuple[Warm | None, ...]
    """Of the gearbox at the end of each; empty where it is not followed."""


class Flown(NamedTuple):
    """What flew."""

    gearbox: Gearbox
    blades: Blades
    mission: Mission
    supply: Supply
    paths: Paths = MappingProxyType({})
    """Of the phases that an aircraft flies."""


class Lost(NamedTuple):
    """Losses of an interval, and what spins the train up."""

    meshes: float
    """[W]"""
    friction: Drag
    motors: float
    """With those that are dragged [W]."""
    spin_up: float
    """[W]"""


def recorded(
    moment: Moment, performance: Performance, drawn: Drawn, *, lost: Lost, work: float, share: float, warm: Warm | None
) -> History[float]:
    """Return what is recorded of an interval.

    Args:
        moment: Where it is flown.
        performance: What the propeller does with its power.
        drawn: By machines and battery.
        lost: On the way.
        work: Power of the propeller's shaft [W].
        share: Motors' part of the machines' power [-].
        warm: Temperatures of the gearbox at its end, where they are followed.
    """
    return History(
        time=moment.time,
        duration=moment.duration,
        altitude=moment.altitude,
        true_airspeed=moment.true_airspeed,
        mach=moment.mach,
        air_temperature=moment.air.temperature,
        air_density=moment.air.density,
        propeller_speed=moment.propeller_speed,
        propeller_gain=moment.propeller_gain,
        propeller_power=work,
        **performance._asdict(),
        electric_share=share,
        fuel_flow=drawn.fuel_flow,
        turbine_power=drawn.turbine_power,
        turbine_available=drawn.turbine_available,
        air_flow=drawn.exhaust.air_flow,
        exhaust_temperature=drawn.exhaust.temperature,
        exhaust_heat=exhaust_heat(drawn.exhaust, _inlet(moment)),
        casing_heat=drawn.exhaust.casing,
        battery_power=drawn.battery.open_power,
        battery_current=drawn.battery.current,
        battery_voltage=drawn.battery.terminal_voltage,
        state_of_charge=drawn.battery.state_of_charge,
        battery_temperature=drawn.pack.temperature,
        winding_temperature=max((warmth.winding for warmth in drawn.warmths.values()), default=None),
        mesh_loss=lost.meshes,
        bearing_loss=lost.friction.bearings,
        windage_loss=lost.friction.windage,
        churning_loss=lost.friction.churning,
        oil_temperature=warm.oil if warm else None,
        gears_temperature=warm.gears if warm else None,
        bearings_temperature=warm.bearings if warm else None,
        housing_temperature=warm.housing if warm else None,
        gearbox_heat=lost.meshes + sum(lost.friction),
        motor_loss=lost.motors,
        battery_loss=drawn.battery.loss,
        spin_up=lost.spin_up,
    )


def _inlet(moment: Moment) -> float:
    """Stagnation temperature of the air [K]."""
    return stagnation_ratios(moment.air, moment.mach)[0] * SEA_LEVEL_TEMPERATURE


def logged(intervals: Sequence[Interval]) -> Log:
    """Return what is known of intervals that were flown one by one.

    Args:
        intervals: In their order.
    """
    points = zip(*(interval.point for interval in intervals), strict=True)
    return Log(
        phase=tuple(interval.phase for interval in intervals),
        history=stacked([interval.values for interval in intervals]),
        point=Point(*map(np.array, points)),
        powers={name: np.array([interval.powers[name] for interval in intervals]) for name in intervals[0].powers},
        end=intervals[-1].pack,
        warm=tuple(interval.warm for interval in intervals),
    )


def collect(flown: Flown, log: Log) -> Flight:
    """Return the flight of its intervals.

    Args:
        flown: Gearbox, propeller, mission and machines.
        log: Of its intervals.
    """
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
    return float(np.max(_OIL.cooler_conductance(history.gearbox_heat, warm, air)))


def _dry(mission: Mission, gearbox: Gearbox, log: Log) -> DryRun | None:
    """How long the gearbox runs without oil from the end of the phase that the mission names."""
    rules = mission.oil.network
    if rules is None or rules.dry_from is None:
        return None
    k = max(place for place, phase in enumerate(log.phase) if phase == rules.dry_from)
    warm, history = log.warm[k], log.history
    assert warm is not None  # followed where there is a network
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


# ----------------------------------------------------------------------------------------------------------------------
# An interval's loads: the operating point for what is asked, and what each machine gives with drag and spin-up.
# ----------------------------------------------------------------------------------------------------------------------


TRIAL_POWER = 1e5
"""Power at which an operating point is found before it is scaled [W]; torques and powers are proportional."""
MET = 1e-12
"""Difference of the propeller's power from the asked one that is met, over all that is given [-]."""
MOST_TRIALS = 20
"""Trials for it: the power is nearly linear in what is given, and two or three do."""


class Asked(NamedTuple):
    """What an interval asks of the gearbox."""

    parts: Mapping[str, float]
    """Machine -> part of the power [-]."""
    propeller: float | None
    """Power of its shaft [W]; None where the machines' power is given."""
    spin_up: float
    """Power into everything that turns [W]."""


class Loaded(NamedTuple):
    """A gearbox under the loads of an interval."""

    point: Point
    """Of the gearbox."""
    friction: Drag
    """Beside its meshes."""
    dragged: float
    """What motors without current take [W]."""
    powers: Mapping[str, float]
    """Machine -> power into the train, with drag and spin-up [W]."""

    @property
    def total(self) -> float:
        """Of all machines that give or take by their parts [W]."""
        return sum(self.powers.values())


def loaded(flown: Flown, moment: Moment, asked: Asked, before: Point | None) -> Loaded:
    """Return the loads of an interval.

    Args:
        flown: Gearbox, propeller, mission and machines.
        moment: Where it is flown.
        asked: Of the gearbox.
        before: Point of the interval before; None at the start.
    """
    gearbox, supply = flown.gearbox, flown.supply
    # Losses are those of the last interval's loads; where the loads change at once, they are found twice.
    point = _operating(flown, moment, asked, before)
    if before is None or moment.starts_phase:
        point = _operating(flown, moment, asked, point)
    friction, dragged = drag(gearbox, point), supply.dragged(gearbox, point, asked.parts)
    carried = sum(friction) + dragged + asked.spin_up
    rigid = zip(gearbox.machines, point.machine_powers.tolist(), strict=True)
    powers = {name: power + asked.parts.get(name, 0.0) * carried for name, power in rigid}
    return Loaded(point, friction, dragged, powers)


def _operating(flown: Flown, moment: Moment, asked: Asked, last: Point | None) -> Point:
    """Return the operating point for a propeller power, or for the machines' power where that is given.

    A propeller that the air drives has a negative power: it is found with machines that take power, so that losses
    stay losses.
    """
    gearbox, supply = flown.gearbox, flown.supply
    efficiency = efficiencies(gearbox, last) if last is not None else {}

    def given(power: float) -> Point:
        """Return the point at which the machines give a power [W]."""
        machines = {name: part * power for name, part in asked.parts.items()}
        return operate(gearbox, machines, moment.propeller_speed, efficiency)

    if asked.propeller is not None and gearbox.demand:
        return _met(given, asked.propeller, asked.propeller + gearbox.demand)
    point = given(math.copysign(TRIAL_POWER, asked.propeller or 0.0))
    if asked.propeller is not None:
        return point.scaled(asked.propeller / point.work)
    at = given if gearbox.demand else lambda power: point.scaled(power / TRIAL_POWER)
    rubbed, dragged = sum(drag(gearbox, at(moment.power or 0.0))), supply.dragged(gearbox, point, asked.parts)
    left = (moment.power or 0.0) - asked.spin_up - rubbed - dragged
    if left <= 0.0:
        raise DesignError([Problem("power", _eaten(moment.power or 0.0, asked.spin_up, rubbed, dragged))])
    return at(left)


def _eaten(power: float, spin_up: float, rubbed: float, dragged: float) -> str:
    """Return what takes a power before it reaches the propeller."""
    parts = (("bearings and oil", rubbed), ("motors that are dragged", dragged), ("spinning the train up", spin_up))
    taken = ", ".join(f"{name} {1e-3 * value:.3g} kW" for name, value in parts if value > 0.0)
    fix = "give more, or a longer ramp_s" if spin_up > 0.0 else "give more"
    return f"of {1e-3 * power:.4g} kW nothing reaches the propeller: {taken}; {fix}"


def _met(given: Callable[[float], Point], wanted: float, power: float) -> Point:
    """Return the point at which the propeller has its power, by secants from a first guess of what is given [W]."""
    point, slope = given(power), 1.0
    for _ in range(MOST_TRIALS):
        missing = wanted - point.work
        if abs(missing) <= MET * (abs(wanted) + abs(power)):
            return point
        power += missing / slope
        before, point = point, given(power)
        slope *= (point.work - before.work) / missing
        if not slope:
            break
    raise SolveError(f"no power of the machines gives the propeller its {wanted / 1e3:.4g} kW")


# ----------------------------------------------------------------------------------------------------------------------
# The tail rotor in flight: a machine of the gearbox that takes what the trim of a helicopter says.
# ----------------------------------------------------------------------------------------------------------------------


_ROUNDS = 1
"""Corrections of the tail rotor's part of the power: losses hardly change with it [-]."""


def with_tail(flown: Flown, moment: Moment, asked: Asked, before: Point | None, *, burnt: float) -> Flown:
    """Return what flies, its tail rotor taking what the trim says; as it is where no trim sets the power.

    Args:
        flown: Gearbox, rotor, mission and machines.
        moment: Where it is flown.
        asked: Of the gearbox.
        before: Point of the interval before; None at the start.
        burnt: Fuel so far [kg].

    Raises:
        DesignError: The tail rotor is no machine of the design that takes power.
    """
    craft = flown.mission.rotorcraft
    if craft is None or craft.tail is None or moment.power is not None:
        return flown
    name, gearbox = craft.tail.machine, flown.gearbox
    if name not in gearbox.taken:
        message = f"no load or tail rotor of the design is called {name!r}; {near(name, gearbox.taken)}"
        raise DesignError([Problem("rotorcraft.tail.machine", message)])
    trim = trimmed(craft, flown.mission, moment, diameter=flown.blades.diameter, burnt=burnt)
    assert trim.tail is not None  # it has one
    part = trim.tail / (trim.main + trim.tail)
    for _ in range(_ROUNDS):
        flown = flown._replace(gearbox=_taking(gearbox, name, part))
        over = part / (1.0 - part) * trim.tail / -loaded(flown, moment, asked, before).powers[name]
        part = over / (1.0 + over)  # what all others take does not depend on it
    return flown._replace(gearbox=_taking(gearbox, name, part))


def _taking(gearbox: Gearbox, name: str, part: float) -> Gearbox:
    """Return a gearbox of which a machine takes a part of the power that is given."""
    return replace(gearbox, taken={**gearbox.taken, name: -part})
