"""Operating points of a propeller at incidence, and of helicopter main and tail rotors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from gearwright.air import air_at
from gearwright.base import (
    Angle,
    Area,
    DesignError,
    Force,
    Length,
    Mass,
    Origin,
    Power,
    Problem,
    Quantity,
    Ratio,
    Shown,
    SolveError,
    Speed,
    Torque,
    Velocity,
    refuse,
    verb,
)
from gearwright.catalogue.propeller_maps import (
    charted_point,
    charted_problems,
    hamilton_standard_charts,
)
from gearwright.machines import Airframe, Blades, Disc, Lift, Stream, antitorque, lift, performance
from gearwright.machines.propellers import BladeShape, generic_blade, inclined, loads

# ----------------------------------------------------------------------------------------------------------------------
# A propeller of given blades at one point of flight, with what its incidence does to its shaft.
# ----------------------------------------------------------------------------------------------------------------------


SEARCHED = np.radians(np.linspace(-10.0, 88.0, 197))
"""Blade angles among which one is looked for that takes a power [rad]."""
HALVINGS = 32
"""Of the bracket in which the blade angle is looked for."""
_ELEMENTS = "blade elements and momentum, or the charts of NASA CR-114399"
_AROUND = "mean over the turn of blade elements, V sin α along the disc"


@dataclass(frozen=True)
class FlightPoint:
    """Where a propeller turns."""

    diameter: float
    """[m]"""
    speed: float
    """Of its rotation [rad/s]."""
    airspeed: float
    """True [m/s]."""
    altitude: float = 0.0
    """Pressure altitude in the standard atmosphere [m]."""
    incidence: float = 0.0
    """Of its axis to the stream, positive where the nose points up [rad]."""


@dataclass(frozen=True, repr=False)
class PropellerLoads(Shown):
    """What a propeller does at a point of flight, and what it asks of its shaft."""

    advance_ratio: Ratio
    """J = V/(n D)."""
    tip_mach: Ratio
    """Of the tips' rotation."""
    blade_angle: Angle
    """At three quarters of the radius."""
    power: Annotated[Power, Origin("C_P ρ n³ D⁵", _ELEMENTS)]
    torque: Annotated[Torque, Origin("P/ω", "definition")]
    thrust: Annotated[Force, Origin("C_T ρ n² D⁴", _ELEMENTS)]
    efficiency: Annotated[Ratio, Origin("V T/P", "definition")]
    in_plane_force: Annotated[Force, Origin("C_N ρ n² D⁴", _AROUND)]
    """Across the shaft: key `in_plane_force_n` of a propeller in a design."""
    hub_moment: Annotated[Torque, Origin("C_n ρ n² D⁵", _AROUND)]
    """Bending moment at the hub, across that force: key `hub_moment_nm`."""
    blade_bending: Annotated[float, Quantity("torque"), Origin("first harmonic of ∫ r dT", _AROUND)]
    """Amplitude once a turn at one blade's root, about the axis' centre."""


@verb
def propeller_loads(
    blades: Blades | BladeShape, point: FlightPoint, *, power: float | None = None, blade_angle: float | None = None,
    by: Literal["elements", "charts"] = "elements",
) -> PropellerLoads:  # fmt: skip
    """Return thrust, torque and the loads of incidence on its shaft, of a propeller at a point of flight.

    Args:
        blades: Number, activity factor and design lift, or blades from `read_blades`.
        point: Where it turns.
        power: Of its shaft; the blade angle that takes it is looked for [W].
        blade_angle: At three quarters of the radius, in its place [rad].
        by: Blade elements, or the Hamilton Standard charts, which know no incidence.

    Source: `machines.propellers.loads` and `inclined`, or Worobel and Mayo, NASA CR-114399 (1971); with the air's
        compressibility.

    Valid for: steady flight to 30° of incidence; without wing and nacelle, whose upwash adds to the incidence.

    Raises:
        DesignError: Something is out of its range, or the blades take no such power at any angle.
    """
    problems = _point_problems(point)
    if (power is None) == (blade_angle is None):
        problems.append(Problem("power", "give either power or blade_angle"))
    if by == "charts":
        problems += charted_problems(blades)
    if by == "charts" and point.incidence:
        problems.append(Problem("incidence", 'the charts know none; leave it out, or take by = "elements"'))
    refuse(problems, "propeller")
    if by == "charts":
        assert isinstance(blades, Blades)  # refused otherwise
        return _charted(blades, point, power, blade_angle)
    shape = generic_blade(blades) if isinstance(blades, Blades) else blades
    ratio, tip_mach, unit, scale = _scales(point)
    try:
        if blade_angle is None:
            assert power is not None  # refused otherwise
            wanted = power / scale
            blade_angle = _angle(shape, ratio, tip_mach, incidence=point.incidence, wanted=wanted, watt=scale)
        found = inclined(shape, ratio, blade_angle, incidence=point.incidence, tip_mach=tip_mach)
    except ValueError as error:
        raise DesignError([Problem("incidence", str(error))], "propeller") from None
    taken = found.power * scale
    return PropellerLoads(
        advance_ratio=ratio,
        tip_mach=tip_mach,
        blade_angle=blade_angle,
        power=taken,
        torque=taken / point.speed,
        thrust=found.thrust * unit,
        efficiency=ratio * found.thrust / found.power if found.power > 0.0 else 0.0,
        in_plane_force=abs(found.normal) * unit,
        hub_moment=abs(found.yaw) * unit * point.diameter,
        blade_bending=found.once_a_turn * unit * point.diameter,
    )


def _scales(point: FlightPoint) -> tuple[float, float, float, float]:
    """Return J, tip Mach number [-], ρ n² D⁴ [N] and ρ n³ D⁵ [W]."""
    air, turns = air_at(point.altitude), point.speed / (2.0 * math.pi)
    ratio, tip_mach = point.airspeed / (turns * point.diameter), 0.5 * point.speed * point.diameter / air.sound_speed
    unit = air.density * turns**2 * point.diameter**4
    return ratio, tip_mach, unit, unit * turns * point.diameter


def _charted(blades: Blades, point: FlightPoint, power: float | None, blade_angle: float | None) -> PropellerLoads:
    """Return what the charts say of a propeller whose axis lies in the stream."""
    ratio, tip_mach, unit, scale = _scales(point)
    if power is None:
        assert blade_angle is not None  # refused otherwise
        at_angle = charted_point(blades, ratio, blade_angle)
        coefficient = 0.0 if at_angle is None else at_angle[0]
    else:
        coefficient = power / scale
    mach = point.airspeed / air_at(point.altitude).sound_speed
    try:
        found = performance(
            hamilton_standard_charts(), blades, ratio, power_coefficient=coefficient, mach=mach, tip_mach=tip_mach
        )
        left = found.held if coefficient > 0.0 else ("power coefficient",)
    except SolveError:
        left = ("thrust coefficient",)
    if left:
        message = (
            f"the charts do not hold this point, as its {' and '.join(left)} lies outside; fly another one, or take"
            ' by = "elements"'
        )
        raise DesignError([Problem("by", message)], "propeller")
    taken = coefficient * scale
    return PropellerLoads(
        advance_ratio=ratio, tip_mach=tip_mach, blade_angle=found.blade_angle, power=taken,
        torque=taken / point.speed, thrust=found.thrust_coefficient * unit,
        efficiency=ratio * found.thrust_coefficient / coefficient, in_plane_force=0.0, hub_moment=0.0,
        blade_bending=0.0,
    )  # fmt: skip


def _point_problems(point: FlightPoint) -> list[Problem]:
    limits = (("diameter", 0.05, 300.0), ("speed", 0.1, 2e4), ("airspeed", 0.0, 300.0), ("altitude", -500.0, 20e3))
    return [
        Problem(f"point.{name}", f"{getattr(point, name):g}: give {low:g} to {high:g} (SI)")
        for name, low, high in limits
        if not low <= getattr(point, name) <= high
    ]


def _angle(shape: BladeShape, ratio: float, tip_mach: float, *, incidence: float, wanted: float, watt: float) -> float:
    """Return the blade angle that takes a power, on the rise between idle and stall [rad]."""
    power = loads(shape, ratio, SEARCHED, tip_mach).power
    most = int(np.argmax(power))
    least = int(np.argmin(power[: most + 1]))
    if not power[least] <= wanted <= power[most]:
        span = f"{power[least] * watt / 1e3:.4g} to {power[most] * watt / 1e3:.4g} kW"
        message = (
            f"{wanted * watt / 1e3:.4g} kW is asked for; at this speed these blades take {span} before they stall;"
            " ask for less, turn faster, or take wider or more blades"
        )
        raise DesignError([Problem("power", message)], "propeller")
    low, high = float(SEARCHED[least]), float(SEARCHED[most])
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        taken = inclined(shape, ratio, middle, incidence=incidence, tip_mach=tip_mach).power
        low, high = (middle, high) if taken < wanted else (low, middle)
    return 0.5 * (low + high)


# ----------------------------------------------------------------------------------------------------------------------
# Rotors of a helicopter in hover, climb and forward flight, with the tail rotor that holds it straight.
# ----------------------------------------------------------------------------------------------------------------------


MOST_ADVANCE = 0.4
"""Forward speed over that of the tips to which profile power by 1 + 4.65 μ² is told [-]."""
FINEST = 0.25
"""Step of speeds among which the best are looked for [m/s]."""
STILL = 5.0
"""Speed from which on power over speed is looked at [m/s]."""
_MOMENTUM = "Glauert; Leishman, Principles of Helicopter Aerodynamics, chapters 2 and 5"
_RANGES = {
    "mass": (1e-3, 1e6), "diameter": (0.05, 100.0), "speed": (0.1, 2e4), "solidity": (1e-4, 1.0),
    "flat_plate_area": (0.0, 100.0), "profile_drag": (1e-4, 0.1), "induced_factor": (0.5, 3.0),
    "download": (0.0, 0.5), "highest_loading": (1e-3, 0.3), "arm": (0.01, 100.0),
}  # fmt: skip
"""Field -> what it can be (SI)."""


@dataclass(frozen=True)
class TailRotor:
    """A tail rotor."""

    diameter: Length
    speed: Speed
    """Of its rotation."""
    arm: Length
    """From the mast to its shaft."""
    solidity: Ratio
    """Area of the blades over that of the disc."""
    profile_drag: Ratio = 0.012
    """c_d0 of its blades; an assumption."""
    induced_factor: Ratio = 1.25
    """κ; about 0.85 in a duct; assumptions."""


@dataclass(frozen=True)
class Helicopter:
    """A main rotor, what it carries, and what holds it straight."""

    mass: Mass
    diameter: Length
    speed: Speed
    """Of the rotation of the main rotor."""
    solidity: Ratio
    """Area of the blades over that of the disc."""
    flat_plate_area: Area = 0.0
    """f: drag of the fuselage over the dynamic pressure."""
    profile_drag: Ratio = 0.010
    """c_d0 of the blades; an assumption."""
    induced_factor: Ratio = 1.15
    """κ over the ideal induced power; an assumption."""
    download: Ratio = 0.03
    """Of the wake on the fuselage in hover, over the weight."""
    highest_loading: Ratio = 0.12
    """C_T/σ at which blades stall; an assumption."""
    tail: TailRotor | None = None


@dataclass(frozen=True)
class RotorRow:
    """The rotors at one speed."""

    airspeed: Velocity
    """Forward, in the plane of the disc."""
    advance_ratio: Annotated[Ratio, Origin("μ = V/(ω R)", "definition")]
    thrust: Annotated[Force, Origin("√((m g (1 + download))² + (ρ V² f/2)²)", _MOMENTUM)]
    loading: Annotated[Ratio, Origin("C_T/σ = T/(ρ A (ω R)² σ)", "definition")]
    tilt: Annotated[Angle, Origin("atan(drag/lift)", "equilibrium")]
    induced_velocity: Annotated[Velocity, Origin("T = 2 ρ A v √(V² + (V_c + v)²)", _MOMENTUM)]
    induced: Annotated[Power, Origin("κ T v", _MOMENTUM)]
    profile: Annotated[Power, Origin("ρ A (ω R)³ σ c_d0/8 (1 + 4.65 μ²)", _MOMENTUM)]
    parasite: Annotated[Power, Origin("ρ V³ f/2", _MOMENTUM)]
    climb: Annotated[Power, Origin("m g V_c", "definition")]
    power: Annotated[Power, Origin("sum of the four", _MOMENTUM)]
    """Of the main rotor's shaft."""
    torque: Annotated[Torque, Origin("P/ω", "definition")]
    """Of the mast."""
    tail_thrust: Annotated[float | None, Quantity("force"), Origin("Q/l", "equilibrium")]
    """None without a tail rotor."""
    tail_power: Annotated[float | None, Quantity("power"), Origin("as of the main rotor", _MOMENTUM)]
    total: Annotated[Power, Origin("main + tail", "definition")]


@dataclass(frozen=True, repr=False)
class RotorTrim(Shown):
    """What a helicopter's rotors take over its speed."""

    helicopter: Helicopter
    altitude: Length
    rate_of_climb: Velocity
    figure_of_merit: Annotated[float | None, Quantity("ratio"), Origin("T^1.5/√(2 ρ A)/P, in hover", "definition")]
    """Of the main rotor; None where it cannot hover."""
    least_power_speed: Velocity
    """Of greatest endurance."""
    least_power: Power
    best_range_speed: Velocity
    """Of least power over speed."""
    rows: tuple[RotorRow, ...]


@verb
def rotor(
    helicopter: Helicopter, speeds: Sequence[float], *, altitude: float = 0.0, rate_of_climb: float = 0.0,
    isa_offset: float = 0.0,
) -> RotorTrim:  # fmt: skip
    """Return what a helicopter's main and tail rotor take at forward speeds: hover, climb, forward flight.

    Args:
        helicopter: Its rotors and its fuselage.
        speeds: Forward speeds; 0 is hover [m/s].
        altitude: Pressure altitude in the standard atmosphere [m].
        rate_of_climb: Negative in descent [m/s].
        isa_offset: Temperature above the standard one [K].

    Source: momentum of the stream (Glauert), profile power by a mean drag, thrust of the tail rotor times its arm the
        torque of the mast (Leishman, Principles of Helicopter Aerodynamics, chapters 2 and 5).

    Valid for: advance ratios to 0.4, blades that do not stall, no slow steep descent; the stream that drives through
        the tilted disc counts in power, not in the induced velocity.

    Raises:
        DesignError: Something is out of its range, blades stall, or the rotor sinks into its own wake.
    """
    refuse(_helicopter_problems(helicopter, speeds, (altitude, rate_of_climb, isa_offset)), "rotor")
    air = (air_at(altitude, isa_offset).density, rate_of_climb)
    rows = tuple(_row(helicopter, air, float(speed)) for speed in speeds)
    fastest = MOST_ADVANCE * 0.5 * helicopter.speed * helicopter.diameter
    tried = [_tried(helicopter, air, speed) for speed in np.arange(0.0, fastest, FINEST)]
    flown = [row for row in tried if row is not None]
    if not flown:
        raise DesignError([Problem("rotor", "there is no speed at which it flies; be lighter, or sink slower")])
    least = min(flown, key=lambda row: row.total)
    moving = [row for row in flown if row.airspeed >= STILL] or flown[-1:]
    best = min(moving, key=lambda row: row.total / max(row.airspeed, FINEST))
    return RotorTrim(
        helicopter=helicopter,
        altitude=altitude,
        rate_of_climb=rate_of_climb,
        figure_of_merit=_merit(helicopter, air[0]),
        least_power_speed=least.airspeed,
        least_power=least.total,
        best_range_speed=best.airspeed,
        rows=rows,
    )


def _helicopter_problems(
    helicopter: Helicopter, speeds: Sequence[float], flight: tuple[float, float, float]
) -> list[Problem]:
    parts = [("helicopter", helicopter)] + ([("helicopter.tail", helicopter.tail)] if helicopter.tail else [])
    problems = [
        Problem(f"{place}.{name}", f"{value:g}: give {_RANGES[name][0]:g} to {_RANGES[name][1]:g} (SI)")
        for place, part in parts
        for name, value in vars(part).items()
        if name in _RANGES and not _RANGES[name][0] <= value <= _RANGES[name][1]
    ]
    limits = (("altitude", -500.0, 20e3), ("rate_of_climb", -100.0, 100.0), ("isa_offset", -60.0, 60.0))
    problems += [
        Problem(name, f"{value:g}: give {low:g} to {high:g} (SI)")
        for value, (name, low, high) in zip(flight, limits, strict=True)
        if not low <= value <= high
    ]
    fastest = MOST_ADVANCE * 0.5 * helicopter.speed * helicopter.diameter
    if not len(speeds):
        problems.append(Problem("speeds", "none is given; give forward speeds, 0 for hover"))
    return problems + [
        Problem("speeds", f"{speed:.4g} m/s: give 0 to {fastest:.4g} m/s, {MOST_ADVANCE:g} of the tips' speed")
        for speed in speeds
        if not 0.0 <= speed <= fastest
    ]


def _main(helicopter: Helicopter) -> Disc:
    return Disc(helicopter.diameter, helicopter.solidity, helicopter.profile_drag, helicopter.induced_factor)


def _lifted(helicopter: Helicopter, air: tuple[float, float], speed: float) -> Lift:
    """Return the main rotor in air of a density [kg/m³] with a rate of climb [m/s]."""
    airframe = Airframe(helicopter.mass, helicopter.flat_plate_area, helicopter.download)
    return lift(_main(helicopter), airframe, Stream(air[0], speed, air[1], helicopter.speed))


def _tried(helicopter: Helicopter, air: tuple[float, float], speed: float) -> RotorRow | None:
    try:
        return _row(helicopter, air, float(speed))
    except DesignError:
        return None


def _row(helicopter: Helicopter, air: tuple[float, float], speed: float) -> RotorRow:
    found = _lifted(helicopter, air, speed)
    if found.loading > helicopter.highest_loading:
        message = (
            f"blades bear C_T/σ {found.loading:.3g} at {speed:.4g} m/s, and stall beyond"
            f" {helicopter.highest_loading:.3g}; be lighter, fly lower, turn faster, or take more blade area"
        )
        raise DesignError([Problem("rotor", message)])
    tail, torque = helicopter.tail, found.power / helicopter.speed
    anti = None
    if tail is not None:
        disc = Disc(tail.diameter, tail.solidity, tail.profile_drag, tail.induced_factor)
        anti = antitorque(disc, Stream(air[0], speed, 0.0, tail.speed), torque, tail.arm)
    return RotorRow(
        airspeed=speed,
        advance_ratio=speed / (0.5 * helicopter.speed * helicopter.diameter),
        thrust=found.thrust,
        loading=found.loading,
        tilt=found.tilt,
        induced_velocity=found.induced_velocity,
        induced=found.induced,
        profile=found.profile,
        parasite=found.parasite,
        climb=found.climb,
        power=found.power,
        torque=torque,
        tail_thrust=None if anti is None else anti.thrust,
        tail_power=None if anti is None else anti.power,
        total=found.power + (0.0 if anti is None else anti.power),
    )


def _merit(helicopter: Helicopter, density: float) -> float | None:
    """Return ideal over real power of the main rotor in hover [-]."""
    found = _tried(helicopter, (density, 0.0), 0.0)
    if found is None:
        return None
    ideal = found.thrust * math.sqrt(found.thrust / (2.0 * density * _main(helicopter).area))
    return ideal / found.power
