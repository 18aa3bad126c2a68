"""Fit a design to another engine: power, input speed and propeller speed."""

import math
from collections.abc import Mapping

from gearwright.base import RPM, DesignError, Problem, refuse, verb
from gearwright.spec import Design, edited
from gearwright.spec.design import SUN_LIMITS, Motor, Turbine
from gearwright.spec.edit import Value
from gearwright.train import speed_range


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
    motor's speed is scaled by the geometric mean of the two speeds' changes, which keeps the split of the ratio as far
    as the stages beside it can have their parts. Cases are scaled with the powers.

    Args:
        design: Where to start.
        power: Rated power of turbines and motors together [W].
        engine_speed: Speed of the turbines [rad/s].
        propeller_speed: Speed of the propellers [rad/s].

    Raises:
        DesignError: If a design has no turbine, or a value is not allowed.
    """
    refuse_no_size(power=power, engine_speed=engine_speed, propeller_speed=propeller_speed)
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
    known = {engine.shaft: engine.speed * fast for engine in design.turbines.values()}
    known |= {turned.shaft: turned.speed * slow for turned in design.propellers.values()}
    for name, engine in design.turbines.items():
        changes[f"turbines.{name}.power_kw"] = engine.power * share / 1e3
        changes[f"turbines.{name}.speed_rpm"] = engine.speed * fast / RPM
    for name, motor in design.motors.items():
        along = math.isclose(motor.speed, turbine.speed)
        speed = motor.speed * fast if along else _between(design, motor, motor.speed * math.sqrt(fast * slow), known)
        changes[f"motors.{name}.power_kw"] = motor.power * share / 1e3
        changes[f"motors.{name}.speed_rpm"] = speed / RPM
    for name, engine in design.turbines.items():
        changes |= _limits(f"turbines.{name}", engine, share, changes)
    for name, motor in design.motors.items():
        changes |= _limits(f"motors.{name}", motor, share, changes)
    for name, turned in design.airscrews.items():
        table = "propellers" if name in design.propellers else "rotors"
        changes[f"{table}.{name}.speed_rpm"] = turned.speed * slow / RPM
    for case, drives in design.cases.items():
        for machine, drive in drives.machines.items():
            if drive.power is not None:
                changes[f"cases.{case}.{machine}.power_kw"] = drive.power * share / 1e3
    return edited(design, changes)


def _limits(path: str, engine: Turbine | Motor, share: float, changes: Mapping[str, Value]) -> dict[str, Value]:
    """Return the limits of an engine, scaled as its power and its speed are."""
    faster = float(str(changes[f"{path}.speed_rpm"])) * RPM / engine.speed
    scaled: dict[str, Value] = {}
    for name, limit in engine.limits.items():
        if limit.power is not None:
            scaled[f"{path}.limits.{name}.power_kw"] = limit.power * share / 1e3
        if limit.torque is not None:
            scaled[f"{path}.limits.{name}.torque_nm"] = limit.torque * share / faster
        if limit.speed is not None:
            scaled[f"{path}.limits.{name}.speed_rpm"] = limit.speed * faster / RPM
    return scaled


@verb
def for_requirement(
    design: Design,
    *,
    power: float | None = None,
    engine_speed: float | None = None,
    propeller_speed: float | None = None,
) -> Design:
    """Return a design as an architecture for a requirement, or as it is where nothing is required.

    What its shafts, stages and rules are stays; tooth numbers and how many planets there are become free.

    Args:
        design: Where to start.
        power: Rated power of turbines and motors together [W].
        engine_speed: Speed of the turbines [rad/s].
        propeller_speed: Speed of the propellers [rad/s].

    Raises:
        DesignError: If a design has no turbine, or a value is not allowed.
    """
    if power is None and engine_speed is None and propeller_speed is None:
        return design
    free: dict[str, Value] = {}
    for name, pair in design.pairs.items():
        free |= {f"pairs.{name}.{key}": None for key in _PAIR_FREEDOMS if getattr(pair, key) is not None}
    for name, planetary in design.planetaries.items():
        free |= {f"planetaries.{name}.{key}": None for key in _SET_FREEDOMS if getattr(planetary, key) is not None}
        free[f"planetaries.{name}.planets"] = None
    return for_engine(edited(design, free), power=power, engine_speed=engine_speed, propeller_speed=propeller_speed)


_PAIR_FREEDOMS = ("pinion_teeth", "wheel_teeth")
_SET_FREEDOMS = ("sun_teeth", "planet_teeth", "ring_teeth")


def _between(design: Design, motor: Motor, speed: float, known: Mapping[str, float]) -> float:
    """Return the speed nearest to a motor's that the stages beside its shaft can give it; its own where none can."""
    for sun in SUN_LIMITS:
        least, most = speed_range(motor.shaft, design, known, sun=sun)
        if least <= most:
            return min(max(speed, least), most)
    return speed


def refuse_no_size(*, power: float | None, engine_speed: float | None, propeller_speed: float | None) -> None:
    """Raise for every power or speed that is asked and can be none.

    Args:
        power: Of all machines [W].
        engine_speed: Of the turbines [rad/s].
        propeller_speed: Of the propellers [rad/s].

    Raises:
        DesignError: With the name of each.
    """
    asked = {"power": power, "engine_speed": engine_speed, "propeller_speed": propeller_speed}
    refuse(
        Problem(name, f"{value:g} is asked, and it must be above 0 and finite; leave it out for the design's own")
        for name, value in asked.items()
        if value is not None and not 0.0 < value < math.inf
    )
