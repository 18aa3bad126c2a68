"""What a train is asked for: the machines, cases and rules of a design, whatever stages that design has itself."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from gearwright.errors import Problem, refuse
from gearwright.spec import Design, drives_of
from gearwright.spec.design import Drive, Motor, Turbine

_SLOWEST_RATIO = 1.5
"""Least ratio that two stages are looked for [-]."""


@dataclass(frozen=True)
class Requirement:
    """One engine, one propeller, at most one motor."""

    design: Design
    """Whose machines, cases and rules count."""
    engine: str
    """Name of the turbine."""
    propeller: str
    """Name of the propeller."""
    motor: str | None
    """Name of the motor; None where there is none."""
    fastest: float
    """Speed that a motor may have [rad/s]."""

    @property
    def engine_speed(self) -> float:
        """Of the turbine [rad/s]."""
        return self.design.turbines[self.engine].speed

    @property
    def propeller_speed(self) -> float:
        """Asked of the propeller [rad/s]."""
        return self.design.propellers[self.propeller].speed

    @property
    def ratio(self) -> float:
        """Of the whole train [-]."""
        return self.engine_speed / self.propeller_speed

    @property
    def added(self) -> float:
        """Rated power of the motor over that of the engine; 0 without one [-]."""
        if self.motor is None:
            return 0.0
        return self.design.motors[self.motor].power / self.design.turbines[self.engine].power

    @property
    def added_in(self) -> dict[str, float]:
        """Case -> power of the motor over that of the engine [-]."""
        if self.motor is None:
            return {}
        found = dict[str, float]()
        for case in self.design.cases:
            drives = drives_of(self.design, case)
            engine = _power(self.design.turbines[self.engine], drives[self.engine])
            motor = _power(self.design.motors[self.motor], drives[self.motor])
            found[case] = motor / engine if engine > 0.0 else math.inf
        return found

    @property
    def slowed(self) -> tuple[str, float]:
        """Case in which a differential turns the propeller slowest, and that speed over the asked one [-].

        Its torques stand in a fixed ratio, so that a motor that gives less turns slower, and the propeller with it.
        """
        speeds = {case: (1.0 + added) / (1.0 + self.added) for case, added in self.added_in.items()}
        return min(speeds.items(), key=lambda item: item[1], default=("", 1.0))

    @property
    def helix(self) -> float | None:
        """Helix angle of its gears [rad]; None where the design states none."""
        return self.design.gears.helix_angle or None


def _power(machine: Turbine | Motor, drive: Drive) -> float:
    """Return what a machine gives in a case [W]."""
    if drive.power is not None:
        return drive.power
    if drive.torque is not None:
        return drive.torque * (drive.speed or machine.speed)
    return (drive.rating or 0.0) * machine.power


def requirement_of(design: Design, *, fastest: float | None = None) -> Requirement:
    """Return what a design asks of any train in its place.

    Args:
        design: With one turbine and one propeller, and perhaps a motor.
        fastest: Speed that the motor may have [rad/s]; left out: that of the faster of motor and turbine.

    Raises:
        DesignError: Where it has other machines, or its propeller is not slower than its turbine.
    """
    refuse(_problems(design, fastest), design.name)
    engine, propeller = next(iter(design.turbines)), next(iter(design.propellers))
    motor = next(iter(design.motors), None)
    speeds = [design.turbines[engine].speed, *(one.speed for one in design.motors.values())]
    return Requirement(design, engine, propeller, motor, max(speeds) if fastest is None else fastest)


def _problems(design: Design, fastest: float | None) -> Iterator[Problem]:
    """Yield what no train of these architectures serves."""
    for table, least, most in (("turbines", 1, 1), ("propellers", 1, 1), ("motors", 0, 1)):
        count = len(getattr(design, table))
        if not least <= count <= most:
            asked = "one" if least else "at most one"
            fix = "state one" if count < least else "leave the others out"
            yield Problem(table, f"there are {count}; architectures are enumerated for {asked}: {fix}")
    for table in ("rotors", "generators", "accessories", "loads"):
        if getattr(design, table):
            names = ", ".join(getattr(design, table))
            yield Problem(table, f"{names}: architectures have engine, motor and propeller alone; leave it out")
    if fastest is not None and not 0.0 < fastest < math.inf:
        yield Problem("fastest", f"a motor of {fastest:g} rad/s is asked; it must be above 0 and finite")
    for name, turbine in list(design.turbines.items())[:1]:
        for driven, propeller in list(design.propellers.items())[:1]:
            if turbine.speed < _SLOWEST_RATIO * propeller.speed:
                yield Problem(
                    f"propellers.{driven}.speed_rpm",
                    f"is not below {1 / _SLOWEST_RATIO:.2f} of the speed of {name}: there is nothing to reduce",
                )
