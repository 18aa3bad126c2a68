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
from gearwright.machines.power.exhaust import Breathing, Exhaust, air_flow, exhaust_heat, exhaust_of, mixed
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

__all__ = [
    "AIR",
    "GAS_CONSTANT",
    "Breathing",
    "CellState",
    "CellStep",
    "Cells",
    "Exhaust",
    "Gas",
    "Network",
    "Warmed",
    "air_flow",
    "cell_step",
    "enthalpy",
    "entropy",
    "exhaust_heat",
    "exhaust_of",
    "heat_capacity",
    "held_energy",
    "isentropic",
    "mixed",
    "open_voltage",
    "resistance_factor",
    "steady",
    "straight",
    "temperature_of",
    "warmed",
]
