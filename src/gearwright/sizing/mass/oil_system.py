"""Oil, and what moves, cleans and cools it: all by the heat that the gearbox makes in the case that speaks for it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gearwright.sizing.losses import largest_heat
from gearwright.sizing.mass.record import MassItem
from gearwright.sizing.result import Sizing

HEAT_CAPACITY = 2000.0
"""Of lubricating oil at about 90 °C [J/(kg K)]."""
FILM = 0.02
"""Oil on walls and in mist over the housing's inside [-], an estimate."""
SUMP = 0.10
"""Oil of splash lubrication over the housing's inside [-], an estimate: the lowest gear dips a tooth deep or two."""
SURE = 0.5
"""One standard deviation of the oil system over its value, an estimate [-]."""
_LITRE_MIN = 1e-3 / 60.0


class _Rule(NamedTuple):
    """A unit of the oil system: what it weighs at least, and what every litre a minute or kilowatt adds."""

    part: str
    least: float
    """[kg]"""
    per_flow: float
    """[kg/(l/min)]"""
    per_heat: float = 0.0
    """[kg/kW]"""


RULES = (
    _Rule("oil pump", 0.5, 0.10),
    _Rule("oil filter", 0.3, 0.05),
    _Rule("oil cooler", 0.3, 0.0, 0.25),
    _Rule("oil lines and jets", 0.3, 0.05),
)
"""Estimates from data sheets of aircraft units as a class; none of them is one unit's published mass."""


def oil_flow(sizing: Sizing, heat: float) -> float:
    """Return the oil that carries a heat away at the temperature rise of the design [m³/s].

    Args:
        sizing: As sized.
        heat: Of the gearbox [W].

    Source: heat balance, q = P_V/(ρ c ΔT).
    """
    return heat / (sizing.design.oil.density * HEAT_CAPACITY * sizing.design.housing.oil_temperature_rise)


def oil_items(sizing: Sizing, inside: float) -> Iterator[MassItem]:
    """Yield the oil and its units.

    Args:
        sizing: As sized.
        inside: Volume inside the housing [m³].

    Source: heat balance, q = P_V/(ρ c ΔT); the tank holds what the dwell asks.
    """
    rules, oil = sizing.design.housing, sizing.design.oil
    if rules.oil_system == "shared":
        return
    if rules.oil_system == "splash":
        yield MassItem("oil", "lubrication", 1, SUMP * inside * oil.density, SURE, "0.1 V ρ", "estimate")
        return
    heat = largest_heat(sizing)
    flow = oil_flow(sizing, heat)
    mass = (flow * rules.oil_dwell + FILM * inside) * oil.density
    yield MassItem("oil", "lubrication", 1, mass, 0.3, "(q t + 0.02 V) ρ, q = P_V/(ρ c ΔT)", "heat balance; estimate")
    for rule in RULES:
        mass = rule.least + rule.per_flow * flow / _LITRE_MIN + rule.per_heat * heat / 1e3
        yield MassItem(rule.part, "lubrication", 1, mass, SURE, "m_0 + k q + j P_V", "estimate")
