"""Parallel keys of DIN 6885-1, form A and B, high."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from gearwright.catalogue.tables import data_rows
from gearwright.errors import DesignError, Problem
from gearwright.parts.joints import KeySection
from gearwright.units import Length

LENGTHS = tuple(
    length / 1e3
    for length in (
        6, 8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 32, 36, 40, 45, 50, 56, 63, 70, 80, 90, 100, 110, 125, 140, 160, 180,
        200, 220, 250, 280, 320, 360, 400,
    )
)  # fmt: skip
"""Lengths of keys [m] (DIN 6885-1:1968)."""


@dataclass(frozen=True)
class StandardKey:
    """A key section with the shafts and lengths for which it is made."""

    over: Length
    """Shaft diameters above this [m]."""
    to: Length
    """Shaft diameters up to this [m]."""
    section: KeySection
    """b, h, t_1, t_2 [m]."""
    shortest: Length
    """Shortest length [m]."""
    longest: Length
    """Longest length [m]."""


@cache
def standard_keys() -> tuple[StandardKey, ...]:
    """Return the sections of DIN 6885-1 by shaft diameter."""
    return tuple(_key({name: float(value) / 1e3 for name, value in row.items()}) for row in data_rows("keys.csv"))


def _key(row: dict[str, float]) -> StandardKey:
    section = KeySection(row["width_mm"], row["height_mm"], row["shaft_depth_mm"], row["hub_depth_mm"])
    return StandardKey(row["over_mm"], row["to_mm"], section, row["shortest_mm"], row["longest_mm"])


def key_for_shaft(diameter: float) -> StandardKey:
    """Return the key of a shaft.

    Args:
        diameter: d [m].

    Raises:
        DesignError: If the standard has none for this diameter.
    """
    for key in standard_keys():
        if key.over < diameter - 1e-9 and diameter <= key.to + 1e-9:
            return key
    keys = standard_keys()
    message = (
        f"{1e3 * diameter:g} mm given; DIN 6885-1 has keys above {1e3 * keys[0].over:g} to {1e3 * keys[-1].to:g} mm"
    )
    raise DesignError([Problem("diameter", message)])


def keyway_tolerance(section: KeySection) -> Length:
    """Return how much deeper than t_1 a keyway in a shaft may be [m].

    Args:
        section: Of the key.

    Source: DIN 6885-1 as Berger Tools prints it (standard parts catalogue, pp. 2079 and 2080) for shafts up to 50 mm:
        0.1 mm of keys up to 6 mm wide, 0.2 mm of wider ones; 0.3 mm from 36 mm on is from memory.

    >>> round(1e3 * keyway_tolerance(key_for_shaft(0.020).section), 1)
    0.1
    """
    width = 1e3 * section.width
    return 0.1e-3 if width < 6.5 else 0.2e-3 if width < 35.0 else 0.3e-3
