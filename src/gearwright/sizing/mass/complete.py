"""Complete mass of a sized gearbox with its oil system, seals, sensors and accessory drives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gearwright.base import verb
from gearwright.sizing.casing import shell_of
from gearwright.sizing.losses import largest_heat
from gearwright.sizing.mass.bearings import bearing_items, planet_bores, seat_duties
from gearwright.sizing.mass.bodies import carrier_items, gear_items, shaft_items
from gearwright.sizing.mass.housing import housing_items
from gearwright.sizing.mass.record import CALIBRATED, Calibration, CompleteMass, MassItem, ordered
from gearwright.sizing.result import Sizing
from gearwright.sizing.shafts import holders_of, unsealed_exits

# ----------------------------------------------------------------------------------------------------------------------
# Oil, and what moves, cleans and cools it: all by the heat that the gearbox makes in the case that speaks for it.
# ----------------------------------------------------------------------------------------------------------------------


HEAT_CAPACITY = 2000.0
"""Of lubricating oil at about 90 °C [J/(kg K)]."""
FILM = 0.02
"""Oil on walls and in mist over the housing's inside [-], an estimate."""
SUMP = 0.10
"""Oil of splash lubrication over the housing's inside [-], an estimate: the lowest gear dips a tooth deep or two."""
SURE_OIL_SYSTEM = 0.5
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
        yield MassItem("oil", "lubrication", 1, SUMP * inside * oil.density, SURE_OIL_SYSTEM, "0.1 V ρ", "estimate")
        return
    heat = largest_heat(sizing)
    flow = oil_flow(sizing, heat)
    mass = (flow * rules.oil_dwell + FILM * inside) * oil.density
    yield MassItem("oil", "lubrication", 1, mass, 0.3, "(q t + 0.02 V) ρ, q = P_V/(ρ c ΔT)", "heat balance; estimate")
    for rule in RULES:
        mass = rule.least + rule.per_flow * flow / _LITRE_MIN + rule.per_heat * heat / 1e3
        yield MassItem(rule.part, "lubrication", 1, mass, SURE_OIL_SYSTEM, "m_0 + k q + j P_V", "estimate")


# ----------------------------------------------------------------------------------------------------------------------
# Seals, sensors, drives of accessories, what holds and seals bearings, and the rest that no rule counts.
# ----------------------------------------------------------------------------------------------------------------------


SEAL = 40.0
"""Seal that is not chosen, with its cover, over the square of the shaft's diameter, an estimate [kg/m²]."""
SENSORS = 0.8
"""Chip detector, pressure and temperature sensors with their leads [kg], an estimate."""
PAD = 1.5
"""Pad, gear and bearings of an accessory's drive [kg], an estimate."""
SURE_DETAILS = 0.5
"""One standard deviation of details over their value, an estimate [-]."""
HELD = 0.2
"""The same of parts that hold bearings, which are sized, an estimate [-]."""


def detail_items(sizing: Sizing, counted: Sequence[MassItem], fitted: Calibration) -> Iterator[MassItem]:
    """Yield seals, sensors, drives of accessories and the rest.

    Args:
        sizing: As sized.
        counted: Every other part.
        fitted: What published gearboxes set.
    """
    housing = sizing.design.housing
    for leaves in unsealed_exits(sizing):
        yield MassItem(
            f"{leaves.machine} seal", "details", 1, SEAL * leaves.diameter**2, SURE_DETAILS, "40 kg/m² d²", "estimate"
        )
    if housing.oil_system == "own":
        yield MassItem("sensors", "details", 1, SENSORS, SURE_DETAILS, "0.8 kg", "estimate")
    if housing.accessory_drives:
        yield MassItem(
            "accessory drives", "details", housing.accessory_drives, PAD, SURE_DETAILS, "1.5 kg each", "estimate"
        )
    held = {holder.name: holder.mass for holder in holders_of(sizing)}
    for name, mass in held.items():
        yield MassItem(
            name, "details", 1, mass, HELD, "as drawn; nuts: catalogue", "parts that hold bearings and seal shafts"
        )
    share = fitted.details * sum(item.total for item in counted if item.group not in ("lubrication", "details"))
    rest = max(share - sum(held.values()), 0.0)
    yield MassItem(
        "fasteners and small parts", "details", 1, rest, SURE_DETAILS, "a share, less what is sized", "held against"
    )


# ----------------------------------------------------------------------------------------------------------------------
# The verb: what a sized gearbox weighs with everything in it.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def complete_mass(sizing: Sizing) -> CompleteMass:
    """Return the complete mass of a gearbox: gears with teeth and webs, shafts, carriers, bearings, housing, oil.

    Machines are not in it. What the design gives (masses of parts, of the housing, of the whole) stands as given.

    Args:
        sizing: As sized.

    >>> import gearwright as gw
    >>> mass = gw.complete_mass(gw.size(gw.read("off-set")))
    >>> ", ".join(group.group for group in mass.groups)
    'gears, shafts, bearings, housing, lubrication, details'
    """
    return summed(sizing, CALIBRATED)


def summed(sizing: Sizing, fitted: Calibration) -> CompleteMass:
    """Return the complete mass with given constants, for their fit.

    Args:
        sizing: As sized.
        fitted: What published gearboxes set.
    """
    whole = sizing.given.get("gearbox.mass")
    if whole is not None:
        item = MassItem("gearbox", "details", 1, whole.value, 0.02, "given", whole.origin or "the design")
        return CompleteMass(sizing.design.name, (item,), 1.0)
    duties = tuple(seat_duties(sizing))
    bores = planet_bores(sizing, duties)
    bearings = tuple(bearing_items(sizing, duties, bores))
    parts = [*gear_items(sizing, bores), *shaft_items(sizing), *carrier_items(sizing), *bearings]
    shell = shell_of(sizing)
    parts += housing_items(sizing, shell, bearings, fitted)
    parts += oil_items(sizing, shell.volume)
    parts += detail_items(sizing, parts, fitted)
    return CompleteMass(sizing.design.name, ordered(parts), fitted.scatter)
