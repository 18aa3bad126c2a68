"""Rotors of a helicopter in hover, climb and forward flight, with the tail rotor that holds it straight."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.air import air_at
from gearwright.errors import DesignError, Problem, refuse
from gearwright.machines.rotor_power import Disc, Stream
from gearwright.machines.rotor_trim import Airframe, Lift, antitorque, lift
from gearwright.showing import Shown
from gearwright.units import Angle, Area, Force, Length, Mass, Origin, Power, Quantity, Ratio, Speed, Torque, Velocity
from gearwright.verbs import verb

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
    refuse(_problems(helicopter, speeds, (altitude, rate_of_climb, isa_offset)), "rotor")
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


def _problems(helicopter: Helicopter, speeds: Sequence[float], flight: tuple[float, float, float]) -> list[Problem]:
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
