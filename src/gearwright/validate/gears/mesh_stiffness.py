"""Published mesh stiffness: the worked example of ISO/TR 6336-30."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gearwright.parts.gears import ISO53_D, CylindricalGear, GearPair
from gearwright.parts.stiffness import MeshStiffness, mesh_stiffness_iso6336
from gearwright.validate.case import Case


def iso_example() -> MeshStiffness:
    """Return the stiffness of the pair of example 1: 17 and 103 teeth, 8 mm, 15.8°, centre distance 0.5 m."""
    helix = math.radians(15.8)
    pair = GearPair(
        CylindricalGear(17, 8e-3, 0.1, helix_angle=helix, profile_shift=0.145, rack=ISO53_D),
        CylindricalGear(103, 8e-3, 0.1, helix_angle=helix, rack=ISO53_D),
        0.5,
    )
    return mesh_stiffness_iso6336(pair)


def _single() -> Sequence[float]:
    stiffness = iso_example()
    return [stiffness.theoretical / 1e9, stiffness.single / 1e9]


def _mesh() -> Sequence[float]:
    stiffness = iso_example()
    return [stiffness.mesh / 1e9, stiffness.face / 1e9]


CASES = (
    Case(
        "single stiffness c′_th, c′",
        "ISO/TR 6336-30:2017, example 1",
        "N/(mm µm)",
        (17.85584, 12.37047),
        _single,
        6e-6,
        "five decimals are printed",
        is_relative=False,
    ),
    Case(
        "mesh stiffness c_γα, c_γβ",
        "ISO/TR 6336-30:2017, example 1",
        "N/(mm µm)",
        (17.46485, 14.84512),
        _mesh,
        6e-4,
        "the contact ratio there is rounded to three decimals",
    ),
)
"""Published mesh stiffness."""
