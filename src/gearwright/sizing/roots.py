"""Root circles of gears, inside which a shaft must stay."""

from __future__ import annotations

from gearwright.sizing.context import Context
from gearwright.sizing.result import GearSizing

DEDENDUM = 1.25
"""Dedendum of the basic rack over the module [-] (ISO 53)."""


def root_diameter(given: Context, gear: GearSizing) -> float:
    """Return the diameter of a gear's root circle [m].

    Args:
        given: What sizing reads.
        gear: A pinion, wheel or sun.

    Source: ISO 21771:2007: d_f = d − 2 m_n (1.25 − x).
    """
    shift = given.ratings[gear.stage].rules.profile_shift if gear.role == "pinion" else 0.0
    return gear.pitch_diameter - 2.0 * gear.module * (DEDENDUM - shift)
