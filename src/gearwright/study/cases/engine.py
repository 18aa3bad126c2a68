"""Fit a design to another engine: power, input speed and propeller speed."""

from __future__ import annotations

import math

from gearwright.errors import DesignError, Problem
from gearwright.spec import Design, edited
from gearwright.spec.edit import Value
from gearwright.units import RPM
from gearwright.verbs import verb


@verb
def for_engine(
    design: Design,
    *,
    power: float | None = None,
    engine_speed: float | None = None,
    propeller_speed: float | None = None,
) -> Design:
    """Return a design for another engine, its machines scaled alike.

    Every machine's power is scaled by the total. A motor that turns as fast as the turbine keeps doing so; another
    motor's speed is scaled by the geometric mean of the two speeds' changes, which keeps the split of the ratio. Cases
    are scaled with the powers.

    Args:
        design: Where to start.
        power: Rated power of turbines and motors together [W].
        engine_speed: Speed of the turbines [rad/s].
        propeller_speed: Speed of the propellers [rad/s].

    Raises:
        DesignError: If a design has no turbine, or a value is not allowed.
    """
    if not design.turbines:
        raise DesignError([Problem("turbines", "there is no turbine to take the place of; add one")])
    turbine, propeller = next(iter(design.turbines.values())), next(iter(design.airscrews.values()))
    fast = (engine_speed or turbine.speed) / turbine.speed
    slow = (propeller_speed or propeller.speed) / propeller.speed
    total = sum(machine.power for machine in design.turbines.values()) + sum(
        machine.power for machine in design.motors.values()
    )
    share = (power or total) / total
    changes: dict[str, Value] = {}
    for name, engine in design.turbines.items():
        changes[f"turbines.{name}.power_kw"] = engine.power * share / 1e3
        changes[f"turbines.{name}.speed_rpm"] = engine.speed * fast / RPM
    for name, motor in design.motors.items():
        along = fast if math.isclose(motor.speed, turbine.speed) else math.sqrt(fast * slow)
        changes[f"motors.{name}.power_kw"] = motor.power * share / 1e3
        changes[f"motors.{name}.speed_rpm"] = motor.speed * along / RPM
    for name, turned in design.airscrews.items():
        table = "propellers" if name in design.propellers else "rotors"
        changes[f"{table}.{name}.speed_rpm"] = turned.speed * slow / RPM
    for case, drives in design.cases.items():
        for machine, drive in drives.machines.items():
            if drive.power is not None:
                changes[f"cases.{case}.{machine}.power_kw"] = drive.power * share / 1e3
    return edited(design, changes)
