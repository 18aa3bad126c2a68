"""A propeller of given blades at one point of flight, with what its incidence does to its shaft."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.air import air_at
from gearwright.errors import DesignError, Problem, refuse
from gearwright.machines import Blades
from gearwright.machines.propellers import BladeShape, generic_blade, inclined, loads
from gearwright.showing import Shown
from gearwright.units import Angle, Force, Origin, Power, Quantity, Ratio, Torque
from gearwright.verbs import verb

SEARCHED = np.radians(np.linspace(-10.0, 88.0, 197))
"""Blade angles among which one is looked for that takes a power [rad]."""
HALVINGS = 32
"""Of the bracket in which the blade angle is looked for."""
_ELEMENTS = "blade elements and momentum"
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
    blades: Blades | BladeShape, point: FlightPoint, *, power: float | None = None, blade_angle: float | None = None
) -> PropellerLoads:
    """Return thrust, torque and the loads of incidence on its shaft, of a propeller at a point of flight.

    Args:
        blades: Number, activity factor and design lift, or blades from `read_blades`.
        point: Where it turns.
        power: Of its shaft; the blade angle that takes it is looked for [W].
        blade_angle: At three quarters of the radius, in its place [rad].

    Source: `machines.propellers.loads` and `inclined`, with compressibility.

    Valid for: steady flight to 30° of incidence; without wing and nacelle, whose upwash adds to the incidence.

    Raises:
        DesignError: Something is out of its range, or the blades take no such power at any angle.
    """
    problems = _problems(point)
    if (power is None) == (blade_angle is None):
        problems.append(Problem("power", "give either power or blade_angle"))
    refuse(problems, "propeller")
    shape = generic_blade(blades) if isinstance(blades, Blades) else blades
    air, turns = air_at(point.altitude), point.speed / (2.0 * math.pi)
    ratio, tip_mach = point.airspeed / (turns * point.diameter), 0.5 * point.speed * point.diameter / air.sound_speed
    unit = air.density * turns**2 * point.diameter**4
    scale = unit * turns * point.diameter
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
