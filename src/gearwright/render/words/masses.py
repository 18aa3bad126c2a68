"""What gearboxes weigh, in words: the train by its groups, everything with its band, and beside real gearboxes."""

from __future__ import annotations

from gearwright.render.tables.sizing.masses import with_band
from gearwright.sizing import Sizing, mass_groups
from gearwright.sizing.mass import band_of, complete_mass, requirement_of
from gearwright.spec.design import CONCEPT, PRELIMINARY
from gearwright.study import Table
from gearwright.units import text

_ROWS = ("complete_mass.low", "complete_mass.high")


def train_mass(sizing: Sizing) -> str:
    """Return the mass of the train as sized with its groups, which add up to it unless it is given.

    Args:
        sizing: As sized.
    """
    discs = {} if sizing.level in (CONCEPT, PRELIMINARY) else {"gears": "gears as discs of their pitch circles"}
    parts = ", ".join(f"{discs.get(group, group)} {text(mass, 'mass')}" for group, mass in mass_groups(sizing).items())
    if "gearbox.mass" in sizing.given:
        return f"{text(sizing.mass, 'mass')}, given, in place of the {text(sizing.parts_mass, 'mass')} of {parts}"
    return f"{text(sizing.mass, 'mass')} ({parts})"


def complete_words(sizing: Sizing) -> str:
    """Return the complete mass with its band, nothing at level ``concept`` or where a mass is given.

    Args:
        sizing: As sized.
    """
    if sizing.level == CONCEPT or "gearbox.mass" in sizing.given:
        return ""
    return with_band(complete_mass(sizing))


def summary(sizing: Sizing) -> str:
    """Return mass and power density in a few sentences; above level ``concept`` the complete mass comes first.

    Args:
        sizing: As sized.
    """
    complete = complete_words(sizing)
    turning = 0.0 if "planet bearings" in mass_groups(sizing) else sizing.planet_bearing_mass
    beside = {"Bearings": sizing.bearing_mass + turning, "Motors": sizing.motor_mass}
    told = "".join(f" {what} {text(mass, 'mass')}." for what, mass in beside.items() if mass)
    first = f"Complete mass {complete}. Train as sized " if complete else ""
    return f"{first}{train_mass(sizing)}, {text(sizing.power_density, 'specific_power')}.{told}"


def beside_statistics(table: Table, sizing: Sizing) -> str:
    """Return what 61 real gearboxes say of a comparison's power and speeds, and which designs do not meet their band.

    Args:
        table: Of designs with their complete masses.
        sizing: Any of them.
    """
    need = requirement_of(sizing)
    found = None if need is None else band_of(need)
    if found is None or any(name not in table.results for name in _ROWS):
        return ""
    _, low, high = found
    limits = {row.design: [row.number(name) for name in _ROWS] for row in table.good}
    lighter = [name for name, (_, most) in limits.items() if most < low]
    heavier = [name for name, (least, _) in limits.items() if least > high]
    shown = [text(value, "mass", 3) for value in found]
    words = [f"61 real gearboxes: {shown[0]}, 68 % from {shown[1]} to {shown[2]}."]
    if lighter:
        words.append(f"Sums of parts below that: {', '.join(lighter)}; margins below 1 are part of the reason.")
    if heavier:
        words.append(f"Sums of parts above that: {', '.join(heavier)}.")
    return " ".join(words)
