"""A propeller of given blades at one point of flight, with what its incidence does to its shaft."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from gearwright.air import air_at
from gearwright.catalogue.propellers.charts import charted_point, charted_problems, hamilton_standard_charts
from gearwright.errors import DesignError, Problem, SolveError, refuse
from gearwright.machines import Blades, performance
from gearwright.machines.propellers import BladeShape, generic_blade, inclined, loads
from gearwright.showing import Shown
from gearwright.units import Angle, Force, Origin, Power, Quantity, Ratio, Torque
from gearwright.verbs import verb

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
    problems = _problems(point)
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


def _problems(point: FlightPoint) -> list[Problem]:
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
