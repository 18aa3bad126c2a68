"""Machines as the gearbox needs them: torque, mass of motors, inertia of what turns."""

from __future__ import annotations

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
from gearwright.spec import Motor, Propeller, Turbine
from gearwright.train import RATED

_MASS_LAWS = {"ndarc": motor_mass_ndarc, "thesis": motor_mass_power_law}


def size_machines(context: Context) -> tuple[MachineSizing, ...]:
    """Return every machine.

    Args:
        context: What sizing reads.
    """
    return tuple(_machine(context, name, machine) for name, machine in context.design.machines.items())


def _machine(context: Context, name: str, machine: Turbine | Motor | Propeller) -> MachineSizing:
    if isinstance(machine, Propeller):
        torque = abs(context.flows[RATED].machine_torques[name])
    else:
        torque = machine.power / machine.speed
    mass = _mass(context, name, machine, torque)
    inertia = machine.inertia if machine.inertia is not None else _inertia(machine, mass)
    return MachineSizing(
        name=name,
        kind=type(machine).__name__.lower(),
        shaft=machine.shaft,
        torque=torque,
        mass=mass,
        inertia=inertia,
        inertia_is_given=machine.inertia is not None,
    )


def _mass(context: Context, name: str, machine: Turbine | Motor | Propeller, torque: float) -> float | None:
    if not isinstance(machine, Motor):
        return None
    return context.given.get(f"{name}.mass", _MASS_LAWS[machine.mass_law](torque))


def _inertia(machine: Turbine | Motor | Propeller, mass: float | None) -> float:
    match machine:
        case Turbine():
            return turbine_inertia(machine.diameter or turbine_diameter(machine.speed))
        case Motor():
            return rotor_inertia(mass or 0.0, motor_diameter(mass or 0.0, LENGTH_RATIO[machine.flux]))
        case Propeller():
            return propeller_inertia(machine.diameter, machine.blades)
