"""Battery, motor windings and oil in flight: state of charge, temperatures and running without oil.

Laws are in `machines`; `mission/supply` asks them in every interval.
"""

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import CELSIUS, DesignError, Floats, Problem, apart, smallest
from gearwright.elementwise import Values
from gearwright.machines import (
    EMPTY,
    FULL,
    Battery,
    BatteryStep,
    Cells,
    CellState,
    MotorLosses,
    Network,
    Relaxing,
    Warmed,
    battery_step,
    cell_step,
    held_energy,
    highest_current,
    motor_loss,
    relaxing,
    stored_energy,
    straight,
    warmed,
)
from gearwright.parts.losses import MeshLaw, oil_viscosity
from gearwright.sizing import Sizing
from gearwright.sizing.losses import Oil, dipping, oil_of_design
from gearwright.spec import BatteryRules, CellRules, Mission, OilNetworkRules, WindingRules

# ----------------------------------------------------------------------------------------------------------------------
# The battery of a flight: a plain one, or cells that polarise, warm and age.
# ----------------------------------------------------------------------------------------------------------------------


YEAR = 365.25 * 86400.0
"""[s]"""
_REFERENCE = 298.15
"""Temperature at which lives are stated [K]."""


class PackState(NamedTuple):
    """What a battery remembers from interval to interval."""

    charge: float
    """State of charge [-]."""
    polarisation: float = 0.0
    """Of the slow pair [V]."""
    temperature: float | None = None
    """Of the cells [K]; None for a plain battery."""
    throughput: float = 0.0
    """Charge that went in or out [C]."""
    worn: float = 0.0
    """Part of its life that is spent [-]."""


class Pack(NamedTuple):
    """The battery of one gearbox."""

    battery: Battery
    """Its resistance holds the bus, too."""
    cells: Cells | None
    rules: CellRules | None
    mass: float
    """[kg]"""

    def start(self, charge: float) -> PackState:
        """Return the state with which a flight begins.

        Args:
            charge: State of charge [-].
        """
        return PackState(charge, temperature=self.rules.start_temperature_k if self.rules else None)

    def energy(self, state: PackState) -> float:
        """Return what the battery holds [J].

        Args:
            state: Of it.
        """
        if self.cells is None:
            return stored_energy(self.battery, state.charge)
        return held_energy(self.battery, self.cells, CellState(state.charge, state.polarisation))

    def drawn(self, state: PackState, power: float, duration: float, air: float) -> tuple[BatteryStep, PackState]:
        """Return a battery over an interval, and its state at the end.

        Args:
            state: At the start.
            power: At the bus; negative charges [W].
            duration: [s].
            air: Temperature of the air [K].

        Raises:
            DesignError: The cells become too warm or too cold.
        """
        if self.cells is None or self.rules is None:
            step = battery_step(self.battery, state.charge, power, duration)
            return step, state._replace(charge=step.state_of_charge)
        warm = state.temperature or _REFERENCE
        _within(self.rules, warm)
        held = CellState(state.charge, state.polarisation)
        step, after = cell_step(self.battery, self.cells, held, power=power, duration=duration, temperature=warm)
        lost = step.loss * (1.0 - self._bus_part())
        end, mean = self._warmed(warm, lost, air, duration)
        passed = abs(step.current) * duration
        worn = state.worn + self._worn(passed, duration, mean)
        return step, PackState(after.charge, after.polarisation, end, state.throughput + passed, worn)

    def _bus_part(self) -> float:
        bus = self.rules.bus_resistance_ohm if self.rules else 0.0
        return bus / self.battery.resistance if bus else 0.0

    def _warmed(self, warm: float, lost: float, air: float, duration: float) -> tuple[float, float]:
        """Return the temperature at the end of an interval, and its mean [K]."""
        assert self.rules is not None  # called for cells alone
        capacity = self.mass * self.rules.heat_capacity_j_kg_k
        network = Network(np.array([capacity]), np.zeros((1, 1)), np.array([[self.rules.cooling_w_k]]))
        around = np.array([self.rules.coolant_temperature_k or air])
        after = warmed(network, np.array([warm]), np.array([lost]), surroundings=around, duration=duration)
        return float(after.temperature[0]), float(after.mean[0])

    def _worn(self, passed: float, duration: float, temperature: float) -> float:
        """Return the part of its life that an interval takes [-].

        Source: Miner's sum of throughput over cycle life, two capacities a cycle, and of time over calendar life; both
            double with every `doubling_k` above 25 °C.
        """
        assert self.rules is not None  # called for cells alone
        rules = self.rules
        faster = math.exp2((temperature - _REFERENCE) / rules.doubling_k)
        cycles = passed / (2.0 * self.battery.charge) / rules.cycle_life if rules.cycle_life else 0.0
        years = duration / YEAR / rules.calendar_years if rules.calendar_years else 0.0
        return faster * (cycles + years)


def _within(rules: CellRules, temperature: float) -> None:
    limits = ((rules.highest_temperature_k, "highest"), (rules.lowest_temperature_k, "lowest"))
    for limit, name in limits:
        if (temperature - limit) * (1.0 if name == "highest" else -1.0) > 1e-9:
            fix = "cool it more, draw less" if name == "highest" else "let it start warmer, cool it less"
            found = f"the cells are at {temperature - CELSIUS:.1f} °C, the {name} is {limit - CELSIUS:.1f} °C"
            raise DesignError([Problem(f"battery.cells.{name}_temperature_k", f"{found}; {fix}, or change the limit")])


def pack_of(rules: BatteryRules) -> Pack:
    """Return the battery that a mission says.

    Args:
        rules: Of the mission.
    """
    mean = 0.5 * (rules.full_voltage_v + rules.empty_voltage_v)
    bus = rules.cells.bus_resistance_ohm if rules.cells else 0.0
    battery = Battery(
        rules.energy / mean,
        rules.full_voltage_v,
        rules.empty_voltage_v,
        rules.resistance_ohm + bus,
        rules.highest_c_rate,
        rules.minimum_charge,
    )
    return Pack(battery, None, None, 0.0) if rules.cells is None else _celled(rules, battery, rules.cells)


def _celled(rules: BatteryRules, battery: Battery, cells: CellRules) -> Pack:
    slow, time, activation = cells.slow_resistance_ohm, cells.slow_time, cells.activation_k
    curve = straight(battery, slow_resistance=slow, time=time, activation=activation)
    if cells.ocv_charge and cells.ocv_v:
        pieces = list(zip(cells.ocv_charge, cells.ocv_v, strict=True))
        held = sum((b - a) * 0.5 * (u + v) for (a, u), (b, v) in pairwise(pieces))
        battery = battery._replace(charge=rules.energy / held, full_voltage=pieces[-1][1], empty_voltage=pieces[0][1])
        curve = curve._replace(charges=tuple(cells.ocv_charge), voltages=tuple(cells.ocv_v))
    mass = rules.energy / (cells.specific_energy_wh_kg * 3600.0)
    return Pack(battery, curve, cells, mass)


# ----------------------------------------------------------------------------------------------------------------------
# Why a battery cannot give or take a power, and what helps.
# ----------------------------------------------------------------------------------------------------------------------


def less(mode: str) -> str:
    """Return what makes the motors' power less; only a hybrid phase divides it.

    Args:
        mode: Of the phase.
    """
    return "lower electric_share or power" if mode == "hybrid" else "ask for less power"


def faulty(battery: Battery, charge: float, power: float, *, step: BatteryStep, mode: str) -> str:
    """Return what is wrong with a power that a battery cannot give or take, its limit, and what helps.

    Args:
        battery: The battery.
        charge: State of charge at the start [-].
        power: At its terminals [W].
        step: With the fault.
        mode: Of the phase.
    """
    said = f"{step.fault}: {power / 1e3:.0f} kW at a state of charge of {charge:.3f}"
    lower = less(mode)
    if step.fault == FULL:
        return f"{said} (maximum 1); start with a lower start_charge, charge less or shorter, or give more energy_kwh"
    if step.fault == EMPTY:
        return f"{said} (minimum {battery.minimum:g}); {lower}, fly shorter, or give more energy_kwh"
    highest = highest_current(battery)
    if abs(step.current) <= highest:  # no current gives this power behind the resistance
        limit = f"more than its resistance of {battery.resistance:g} Ω lets through"
        return f"{said}, {limit}; {lower}, or lower resistance_ohm"
    current, most = apart(abs(step.current), highest, "current")
    limit = f"{current}, of {most} (highest_c_rate {battery.highest_rate:g})"
    return f"{said}: {limit}; {lower}, or give more energy_kwh or highest_c_rate"


# ----------------------------------------------------------------------------------------------------------------------
# Motors of a flight that warm up: winding and case, copper that resists more, limits that fall.
# ----------------------------------------------------------------------------------------------------------------------


COPPER = 234.5
"""Temperature below 0 °C at which copper's resistance would vanish if its slope went on [K]; IEC 60034-1."""


class Warmth(NamedTuple):
    """Temperatures of one motor."""

    winding: float
    """[K]"""
    case: float
    """[K]"""


Warmths = Mapping[str, Warmth]
"""Motor -> its temperatures; empty where a mission does not follow them."""


def started(rules: WindingRules | None, motors: Mapping[str, MotorLosses], air: float) -> Warmths:
    """Return the temperatures with which motors start.

    Args:
        rules: Of the mission; None: they are not followed.
        motors: By name.
        air: Temperature of the air [K].
    """
    if rules is None:
        return {}
    start = rules.start_temperature_k or rules.coolant_temperature_k or air
    return dict.fromkeys(motors, Warmth(start, start))


def warm_motor(rules: WindingRules | None, motor: MotorLosses, warmth: Warmth | None) -> MotorLosses:
    """Return a motor as its winding's temperature makes it: more copper loss, lower limits.

    Args:
        rules: Of the mission; None: temperature changes nothing.
        motor: At its rated temperature.
        warmth: Its temperatures.

    Source: R ∝ 234.5 + t for copper, t in °C (IEC 60034-1); limits fall linearly to nothing, as controllers have it.
    """
    if rules is None or warmth is None:
        return motor
    copper = (COPPER + warmth.winding - CELSIUS) / (COPPER + rules.rated_winding_k - CELSIUS)
    kept = 1.0
    if rules.derate_from_k is not None and rules.derate_from_k < rules.highest_winding_k:
        fall = (rules.highest_winding_k - warmth.winding) / (rules.highest_winding_k - rules.derate_from_k)
        kept = min(max(fall, 0.0), 1.0)
    return motor._replace(
        copper=motor.copper * copper, peak_torque=motor.peak_torque * kept, peak_power=motor.peak_power * kept
    )


def warmed_motor(
    rules: WindingRules, motor: MotorLosses, warmth: Warmth, *, at: tuple[float, float], air: float, duration: float
) -> Warmth:
    """Return a motor's temperatures after an interval.

    Args:
        rules: Of the mission.
        motor: As warm as it is.
        warmth: At the start.
        at: Torque [N m] and speed [rad/s].
        air: Temperature of the air [K].
        duration: [s].
    """
    torque, speed = at
    copper = rules.winding_loss * motor.copper * torque * torque
    heat = np.array([copper, motor_loss(motor, torque, speed) - copper])
    between = np.array([[0.0, rules.winding_to_case_w_k], [rules.winding_to_case_w_k, 0.0]])
    capacity = np.array([rules.winding_capacity_j_k, rules.case_capacity_j_k])
    network = Network(capacity, between, np.array([[0.0], [rules.case_to_coolant_w_k]]))
    around = np.array([rules.coolant_temperature_k or air])
    after = warmed(network, np.array(warmth), heat, surroundings=around, duration=duration)
    return Warmth(*after.temperature.tolist())


def refuse_hot(rules: WindingRules, name: str, warmth: Warmth) -> None:
    """Refuse a winding that is too warm.

    Args:
        rules: Of the mission.
        name: Of the motor.
        warmth: Its temperatures.

    Raises:
        DesignError: It is; with the limit.
    """
    if warmth.winding > rules.highest_winding_k * (1.0 + 1e-12):
        found, limit = apart(warmth.winding - CELSIUS, rules.highest_winding_k - CELSIUS, "temperature")
        message = (
            f"the winding of {name} reaches {found}, the highest is {limit}; give the motor less power or"
            " more cooling (case_to_coolant_w_k, coolant_temperature_k), or let derate_from_k lower its limits"
        )
        raise DesignError([Problem("motor.heat.highest_winding_k", message)])


# ----------------------------------------------------------------------------------------------------------------------
# Temperatures of oil, gears, bearings and housing in flight, and minutes without oil.
# ----------------------------------------------------------------------------------------------------------------------


OIL, GEARS, BEARINGS, HOUSING = range(4)
"""Bodies of the network."""
_STEP = 10.0
"""Longest step of running dry [s]."""
_LONGEST = 6.0 * 3600.0
"""Running dry that is looked at [s]."""


class GearHeat(NamedTuple):
    """What heats a gearbox."""

    meshes: float
    """[W]"""
    bearings: float
    """And seals [W]."""
    windage: float
    """[W]"""
    churning: float
    """[W]"""


class Warm(NamedTuple):
    """Temperatures in a gearbox."""

    oil: float
    """[K]"""
    gears: float
    """[K]"""
    bearings: float
    """[K]"""
    housing: float
    """[K]"""


class DryRun(NamedTuple):
    """A gearbox that has lost its oil."""

    lasts: float
    """Until the first limit [s]; infinite where none is reached within six hours."""
    part: str
    """What reaches its limit first; empty: nothing."""
    gears: float
    """Temperature at the end [K]."""
    bearings: float
    """Temperature at the end [K]."""


def oil_start(rules: OilNetworkRules, inlet: float) -> Warm:
    """Return the temperatures with which a gearbox starts.

    Args:
        rules: Of the mission.
        inlet: Temperature of the oil that the mission states [K].
    """
    return Warm(*[rules.start_temperature_k or inlet] * 4)


def _network(rules: OilNetworkRules, gear_mass: float, opened: float, *, wet: bool) -> Network:
    """Return the network with its cooler's valve opened by a part."""
    steel = rules.steel_heat_j_kg_k
    capacity = np.array(
        [
            rules.oil_mass * rules.oil_heat_j_kg_k,
            gear_mass * steel,
            rules.bearing_mass * steel,
            rules.housing_mass * rules.housing_heat_j_kg_k,
        ]
    )
    links = np.zeros((4, 4))
    if wet:
        links[OIL, [GEARS, BEARINGS, HOUSING]] = (
            rules.gears_to_oil_w_k, rules.bearings_to_oil_w_k, rules.oil_to_housing_w_k,
        )  # fmt: skip
    links[GEARS, HOUSING], links[BEARINGS, HOUSING] = rules.gears_to_housing_w_k, rules.bearings_to_housing_w_k
    outside = np.array([[rules.cooler_w_k * opened if wet else 0.0], [0.0], [0.0], [rules.housing_to_air_w_k]])
    return Network(capacity, links + links.T, outside)


def _asked(rules: OilNetworkRules, oil: float) -> float:
    """Return the part to which oil of a temperature [K] opens the cooler's valve."""
    return min(max((oil - rules.cooler_opens_k) / rules.cooler_range_k, 0.0), 1.0)


def _heat(rules: OilNetworkRules, heat: GearHeat, *, wet: bool) -> Floats:
    share, more = (rules.oil_share, 1.0) if wet else (0.0, rules.dry_friction)
    meshes, bearings = more * heat.meshes, more * heat.bearings
    return np.array(
        [
            share * (meshes + bearings) + (heat.churning if wet else 0.0),
            (1.0 - share) * meshes + heat.windage,
            (1.0 - share) * bearings,
            0.0,
        ]
    )


def oil_step(
    rules: OilNetworkRules, gear_mass: float, warm: Warm, *, heat: GearHeat, air: float, duration: float
) -> tuple[Warm, Warmed]:
    """Return the temperatures of a gearbox after an interval, and what its network stored and rejected.

    Args:
        rules: Of the mission.
        gear_mass: Of gears and shafts [kg].
        warm: Temperatures at the start.
        heat: What heats it.
        air: Temperature of the air [K].
        duration: [s].

    Raises:
        DesignError: Oil, gears or bearings become too warm.

    Source: the cooler's valve stands as the oil at the interval's end asks, so that no interval is too long for it.
    """
    hot, around = _heat(rules, heat, wet=True), np.array([air])
    opened, _ = _Valve(rules, gear_mass).step(np.array(warm), hot, around, duration)
    network = _network(rules, gear_mass, opened, wet=True)
    after = warmed(network, np.array(warm), hot, surroundings=around, duration=duration)
    end = Warm(*after.temperature.tolist())
    for part in ("oil", "gears", "bearings"):
        limit, found = getattr(rules, f"highest_{part}_k"), getattr(end, part)
        if found > limit * (1.0 + 1e-12):
            said = f"{part} reach {found - CELSIUS:.1f} °C in air of {air - CELSIUS:.1f} °C, the highest is"
            fix = "give a larger cooler_w_k or gears_to_oil_w_k, ask for less power, or raise the limit"
            raise DesignError([Problem(f"oil.network.highest_{part}_k", f"{said} {limit - CELSIUS:.1f} °C; {fix}")])
    return end, after


class _Valve:
    """The cooler's valve of one gearbox, shut, wide open or between."""

    def __init__(self, rules: OilNetworkRules, gear_mass: float) -> None:
        self.rules, self.gear_mass = rules, gear_mass
        self.shut, self.wide = (self._network(opened) for opened in (0.0, 1.0))

    def _network(self, opened: float) -> Relaxing:
        return relaxing(_network(self.rules, self.gear_mass, opened, wet=True))

    def step(self, warm: Floats, heat: Floats, air: Floats, duration: float) -> tuple[float, Floats]:
        """Return how far the valve stands open in an interval, and the temperatures at its end."""
        from scipy.optimize import brentq  # a third of the time that flights take to load

        def at(network: Relaxing, opened: float) -> tuple[Floats, float]:
            after = network.after(warm, heat, surroundings=air, duration=duration)
            return after, _asked(self.rules, float(after[OIL])) - opened

        (cold, low), (hot, high) = at(self.shut, 0.0), at(self.wide, 1.0)
        if low <= 0.0:
            return 0.0, cold
        if high >= 0.0:
            return 1.0, hot
        ends = {0.0: low, 1.0: high}

        def left(opened: float) -> float:
            return ends[opened] if opened in ends else at(self._network(opened), opened)[1]

        opened = float(brentq(left, 0.0, 1.0, xtol=1e-10))
        return opened, at(self._network(opened), opened)[0]


def oil_along(
    rules: OilNetworkRules, gear_mass: float, begun: Warm, heats: Sequence[GearHeat], *, air: Floats, duration: Floats
) -> tuple[Floats, Floats]:
    """Return the temperatures of a gearbox at the start and the end of every interval, shape (n, 4) each [K].

    Args:
        rules: Of the mission.
        gear_mass: Of gears and shafts [kg].
        begun: Temperatures at the start of the flight.
        heats: What heats it in every interval.
        air: Temperature of the air, shape (n,) [K].
        duration: Of every interval, shape (n,) [s].
    """
    start, end, now, limits = np.empty((len(air), 4)), np.empty((len(air), 4)), np.array(begun), _limits(rules)
    valve = _Valve(rules, gear_mass)
    for k, (heat, lasts) in enumerate(zip(heats, duration.tolist(), strict=True)):
        start[k] = now
        _, end[k] = valve.step(now, _heat(rules, heat, wet=True), air[k : k + 1], lasts)
        if (end[k, : len(limits)] <= limits).all():
            now = end[k]  # what is too warm is refused, and what follows on it does not count
    return start, end


def _limits(rules: OilNetworkRules) -> Floats:
    """Return the highest temperatures of oil, gears and bearings, shape (3,) [K]."""
    return np.array([rules.highest_oil_k, rules.highest_gears_k, rules.highest_bearings_k]) * (1.0 + 1e-12)


def dry_run(rules: OilNetworkRules, gear_mass: float, warm: Warm, *, heat: GearHeat, air: float) -> DryRun:
    """Return how long a gearbox runs without oil until gears or bearings reach their limit.

    Args:
        rules: Of the mission.
        gear_mass: Of gears and shafts [kg].
        warm: Temperatures when the oil is lost.
        heat: What heated it with oil; meshes and bearings then lose `dry_friction` times as much.
        air: Temperature of the air [K].

    Source: the network without oil; the step in which the limit is passed is cut at a straight line.

    Valid for: a stated limit and a stated friction; real gearboxes end by softening, lost clearances and cages.
    """
    network, hot = _network(rules, gear_mass, 0.0, wet=False), _heat(rules, heat, wet=False)
    limits = {"gears": rules.highest_gears_k, "bearings": rules.highest_bearings_k}
    now, clock = warm, 0.0
    while clock < _LONGEST:
        after = warmed(network, np.array(now), hot, surroundings=np.array([air]), duration=_STEP)
        end = Warm(*after.temperature.tolist())
        cuts = {
            part: (limit - getattr(now, part)) / (getattr(end, part) - getattr(now, part))
            for part, limit in limits.items()
            if getattr(end, part) > limit
        }
        if cuts:
            part = smallest(cuts, cuts.__getitem__)
            cut = max(cuts[part], 0.0)
            at = [a + cut * (b - a) for a, b in zip(now, end, strict=True)]
            return DryRun(clock + cut * _STEP, part, at[GEARS], at[BEARINGS])
        now, clock = end, clock + _STEP
    return DryRun(float("inf"), "", now.gears, now.bearings)


# ----------------------------------------------------------------------------------------------------------------------
# The oil of a flight: as its mission says, and where it says nothing as the design does.
# ----------------------------------------------------------------------------------------------------------------------


THICKEST = 0.02
"""Kinematic viscosity beyond which no pump moves oil and no law of losses holds [m²/s]; MIL-PRF-23699 lets an oil have
0.013 at -40 °C, below which engines are not started without heating."""


def flown_oil(sizing: Sizing, mission: Mission) -> Oil:
    """Return the oil of a flight, and by whose formulas power is lost in it.

    Args:
        sizing: With the design's oil and losses.
        mission: Whose [oil] comes first.

    Raises:
        DesignError: A gear dips that there is not.
    """
    rules, oil = mission.oil, oil_of_design(sizing)
    return oil._replace(
        temperature=rules.inlet_temperature_k,
        roughness=oil.roughness if rules.roughness is None else rules.roughness,
        of_stages={
            stage: flank if rules.roughness is None else flank._replace(roughness=rules.roughness)
            for stage, flank in oil.of_stages.items()
        },
        dip=dipping(sizing, rules.dip, "oil.dip") if rules.dip else oil.dip,
        friction=MeshLaw(rules.friction) if rules.friction else oil.friction,
        bearings=rules.bearings or oil.bearings,
        windage=rules.windage or oil.windage,
        seals=rules.seals or oil.seals,
    )


def too_stiff(oil: Oil) -> Values:
    """Tell whether oil is too cold to flow.

    Args:
        oil: As warm as it is, in one interval or in many.
    """
    return oil_viscosity(oil.temperature, oil.grade) > THICKEST


def refuse_stiff(oil: Oil) -> None:
    """Refuse oil that is too cold to flow.

    Args:
        oil: As warm as it is.

    Raises:
        DesignError: It is; with its viscosity.
    """
    viscosity = oil_viscosity(oil.temperature, oil.grade)
    if viscosity > THICKEST:
        message = (
            f"at {oil.temperature - CELSIUS:.1f} °C it has {1e6 * viscosity:.3g} mm²/s, and above {1e6 * THICKEST:g}"
            " no pump moves it; heat it before the start (oil.network.start_temperature_k, oil.inlet_temperature_k), or"
            " take a thinner one ([oil] of the design)"
        )
        raise DesignError([Problem("oil", message)])
