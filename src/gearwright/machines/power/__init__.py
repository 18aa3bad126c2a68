"""The power plant beyond laws of one line: gases, exhaust, spools, cells, windings, networks of heat.

Numbers in, numbers out, as in `machines`; what a mission asks of them is in `mission`.
"""

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

__all__ = [
    "AIR",
    "GAS_CONSTANT",
    "Breathing",
    "Exhaust",
    "Gas",
    "air_flow",
    "enthalpy",
    "entropy",
    "exhaust_heat",
    "exhaust_of",
    "heat_capacity",
    "isentropic",
    "mixed",
    "temperature_of",
]
