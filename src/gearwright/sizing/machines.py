"""Machines as the gearbox needs them: torque, mass of motors, inertia of what turns; how fast tips of rotors are."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.checks import Check
from gearwright.identity import Kind, PartId
from gearwright.machines import (
    LENGTH_RATIO,
    motor_diameter,
    motor_mass_ndarc,
    motor_mass_power_law,
    propeller_inertia,
    rotor_inertia,
    turbine_diameter,
    turbine_inertia,
)
from gearwright.sizing.rating import Context
from gearwright.sizing.result import MachineSizing
from gearwright.spec import Airscrew, ElectricMachine, Machine, Turbine
from gearwright.spec.design import Rotor

FASTEST_TIP = 250.0
"""Tip speed of a rotor that leaves the advancing blade some forward speed [m/s]: Mach 0.73 at sea level. The UH-1H with
14.63 m at 324 rpm has 248 m/s, faster than helicopters since; 200 to 225 m/s are usual."""
_MASS_LAWS = {"ndarc": motor_mass_ndarc, "thesis": motor_mass_power_law}


def size_machines(context: Context) -> tuple[MachineSizing, ...]:
    """Return every machine.

    Args:
        context: What sizing reads.
    """
    return tuple(_machine(context, name, machine) for name, machine in context.design.machines.items())


def machine_checks(context: Context) -> Iterator[Check]:
    """Yield the tip speed of every rotor in the case that turns it the fastest.

    Args:
        context: What sizing reads.
    """
    for name, machine in context.design.machines.items():
        if isinstance(machine, Rotor):
            case, speed = max(
                ((case, abs(flow.speeds[machine.shaft])) for case, flow in context.flows.items()),
                key=lambda turning: turning[1],
            )
            yield Check(
                PartId(Kind.MACHINE, name), "tip speed", "UH-1H: 248 m/s, Mach 0.73", speed * machine.diameter / 2.0,
                FASTEST_TIP, "velocity", at_most=True, exponent=None, case=case,
            )  # fmt: skip


def _machine(context: Context, name: str, machine: Machine) -> MachineSizing:
    if machine.rating is not None and machine.asked_speed is not None:
        torque = machine.rating / machine.asked_speed
    else:
        torque = max(abs(flow.machine_torques[name]) for flow in context.flows.values())
    mass = _mass(context, name, machine, torque)
    given: float | None = getattr(machine, "inertia", None)
    return MachineSizing(
        name=name,
        kind=type(machine).__name__.lower(),
        shaft=machine.shaft,
        torque=torque,
        mass=mass,
        inertia=_inertia(machine, mass) if given is None else given,
        inertia_is_given=given is not None,
    )


def _mass(context: Context, name: str, machine: Machine, torque: float) -> float | None:
    if not isinstance(machine, ElectricMachine):
        return context.given.get(f"{name}.mass")
    return context.given.get(f"{name}.mass", _MASS_LAWS[machine.mass_law](torque))


def _inertia(machine: Machine, mass: float | None) -> float:
    """Return the estimated inertia; none of what is too various to estimate [kg m²]."""
    match machine:
        case Turbine():
            return turbine_inertia(machine.diameter or turbine_diameter(machine.speed))
        case ElectricMachine():
            return rotor_inertia(mass or 0.0, motor_diameter(mass or 0.0, LENGTH_RATIO[machine.flux]))
        case Airscrew():
            return propeller_inertia(machine.diameter, machine.blades)
        case _:
            return 0.0
