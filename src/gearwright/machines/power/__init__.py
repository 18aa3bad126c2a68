"""The power plant beyond laws of one line: gases, exhaust, spools, cells, windings, networks of heat.

Numbers in, numbers out, as in `machines`; what a mission asks of them is in `mission`.
"""

from gearwright.machines.power.cells import (
    Cells,
    CellState,
    CellStep,
    cell_step,
    held_energy,
    open_voltage,
    resistance_factor,
    straight,
)
from gearwright.machines.power.equilibrium import engine_state, state_for, steady_state
from gearwright.machines.power.exhaust import Breathing, Exhaust, air_flow, exhaust_heat, exhaust_of, mixed
from gearwright.machines.power.free_turbine import Held, RotorGovernor, held_rotor, turbine_torque
from gearwright.machines.power.gases import (
    AIR,
    GAS_CONSTANT,
    Gas,
    enthalpy,
    entropy,
    heat_capacity,
    isentropic,
    temperature_of,
)
from gearwright.machines.power.network import Network, Warmed, steady, warmed
from gearwright.machines.power.spools import (
    FuelControl,
    Spooled,
    SpoolStep,
    at_rest,
    fuelled,
    limited_fuel,
    spool,
    time_constant,
)
from gearwright.machines.power.turboshaft import (
    EngineState,
    Inlet,
    Rated,
    Turboshaft,
    engine_of,
    entering,
    leaving,
    state_at,
)

__all__ = [
    "AIR",
    "GAS_CONSTANT",
    "Breathing",
    "CellState",
    "CellStep",
    "Cells",
    "EngineState",
    "Exhaust",
    "FuelControl",
    "Gas",
    "Held",
    "Inlet",
    "Network",
    "Rated",
    "RotorGovernor",
    "SpoolStep",
    "Spooled",
    "Turboshaft",
    "Warmed",
    "air_flow",
    "at_rest",
    "cell_step",
    "engine_of",
    "engine_state",
    "entering",
    "enthalpy",
    "entropy",
    "exhaust_heat",
    "exhaust_of",
    "fuelled",
    "heat_capacity",
    "held_energy",
    "held_rotor",
    "isentropic",
    "leaving",
    "limited_fuel",
    "mixed",
    "open_voltage",
    "resistance_factor",
    "spool",
    "state_at",
    "state_for",
    "steady",
    "steady_state",
    "straight",
    "temperature_of",
    "time_constant",
    "turbine_torque",
    "warmed",
]
