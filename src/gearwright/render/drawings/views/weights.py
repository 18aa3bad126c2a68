"""What drawn parts weigh and how their bodies are: as the complete mass has them, whose bodies the solids have, too."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from gearwright.latest import of_latest
from gearwright.parts.gears import Blank
from gearwright.shape.teeth import gear_of
from gearwright.sizing import Sizing
from gearwright.sizing.mass import TRAIN, complete_mass, gear_blanks


class Made(NamedTuple):
    """Parts as they are made."""

    weights: Mapping[str, float]
    """Gear, shaft or carrier -> mass of one [kg]."""
    casing: Mapping[str, float]
    """Housing shell, housing ribs and what else a housing is weighed as -> mass [kg]."""
    total: float
    """Of the whole gearbox [kg]."""
    blanks: Mapping[str, Blank]
    """External gear -> its body."""


@of_latest
def made_of(sizing: Sizing) -> Made:
    """Return the parts of a sizing as they are made.

    Args:
        sizing: What was sized.
    """
    whole = complete_mass(sizing)
    weights = {str(item.part): item.each for item in whole.parts if item.group in TRAIN}
    casing = {item.part: item.total for item in whole.parts if item.group == "housing"}
    return Made(weights, casing, whole.total, gear_blanks(sizing))


def mass_with_gears(sizing: Sizing, gears: tuple[str, ...], shaft: str) -> float:
    """Return the mass of a shaft with the gears that are one piece with it [kg].

    Args:
        sizing: What was sized.
        gears: One piece with it.
        shaft: Its name.
    """
    weights, whole = made_of(sizing).weights, [gear_of(sizing, name) for name in gears]
    return weights.get(shaft, 0.0) + sum(weights[gear.name] * gear.bodies / len(gear.shafts) for gear in whole)
