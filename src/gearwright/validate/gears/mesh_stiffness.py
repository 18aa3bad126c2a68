"""Published mesh stiffness: the worked example of ISO/TR 6336-30, other programs' by ISO 6336 and by energy."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from gearwright.parts import Material
from gearwright.parts.gears import ISO53_D, CylindricalGear, GearPair
from gearwright.parts.stiffness import MeshStiffness, mesh_stiffness_iso6336, pair_stiffness
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


def wind_turbine_pair(stage: int) -> GearPair:
    """Return sun and planet, or pinion and wheel, of a stage of the 5 MW reference gearbox of Nejad et al. 2016.

    The first stage's stiffness is left out: that program takes the sun for the pinion although its 19 teeth are more
    than the planet's 17, which turns c′_th = 18.379 into the 18.829 N/(mm µm) that it finds.

    Args:
        stage: 1 to 3.
    """
    teeth, shifts, module, width, distance, shortened, helix = {
        1: ((19, 17), (0.617, 0.802), 45e-3, 0.491, 0.863, 10.861e-3, 0.0),
        2: ((18, 36), (0.389, 0.504), 21e-3, 0.550, 0.584, 1.75e-3, 0.0),
        3: ((24, 95), (0.480, 0.669), 14e-3, 0.360, 0.861, 0.938e-3, math.radians(10.0)),
    }[stage]
    first, second = (
        CylindricalGear(z, module, width, helix, profile_shift=x, tip_alteration=-shortened / module)
        for z, x in zip(teeth, shifts, strict=True)
    )
    return GearPair(first, second, distance)


def _contact_ratios() -> Sequence[float]:
    return [wind_turbine_pair(stage).transverse_contact_ratio for stage in (1, 2, 3)]


def _wind_turbine(stage: int) -> Sequence[float]:
    found = mesh_stiffness_iso6336(wind_turbine_pair(stage))
    return [value / 1e9 for value in (found.theoretical, found.single, found.mesh, found.face)]


def _bored_pair() -> tuple[GearPair, Material]:
    """Return the pair of ROSS's tests: 62 teeth each, 2 mm, 20 mm wide, on bores of 35 mm."""
    gear = CylindricalGear(62, 2e-3, 20e-3)
    return GearPair(gear, gear), Material("gear steel", 206e9, 0.3, 7810.0)


def _two_pairs_begin() -> Sequence[float]:
    """Return the mesh stiffness where the second pair of teeth comes into contact [MN/m]."""
    pair, steel = _bored_pair()
    pitch = math.pi * pair.driver.module * math.cos(pair.driver.rack.pressure_angle)
    places = np.array([-pair.approach, pitch - pair.approach])
    found = pair_stiffness(pair, places, materials=(steel, steel), bore_radii=(17.5e-3, 17.5e-3))
    return [float(np.sum(found.stiffness)) * pair.face_width / 1e6]


def _contact() -> Sequence[float]:
    pair, steel = _bored_pair()
    contact = pair_stiffness(pair, np.zeros(1), materials=(steel, steel)).contact
    return [pair.transverse_contact_ratio, pair.face_width / contact / 1e6]


_NREL = "Nejad et al. 2016, 5 MW reference gearbox, by Rebouças' Drivetrain (tests)"
_ROSS = "ROSS 2.3, test of gears of varying mesh stiffness (method of Ma et al. 2014)"

CASES = (
    Case(
        "contact ratios of three shifted stages",
        _NREL,
        "-",
        (1.114698962948295, 1.3703997308907856, 1.462659404435414),
        _contact_ratios,
        1e-12,
        "rounding",
    ),
    Case(
        "stiffness c′_th, c′, c_γα, c_γβ of a sun and planet",
        _NREL,
        "N/(mm µm)",
        (18.198806127990704, 14.19506877983275, 18.138456021852434, 15.417687618574568),
        partial(_wind_turbine, 2),
        1e-12,
        "rounding",
    ),
    Case(
        "stiffness c′_th, c′, c_γα, c_γβ of a shifted helical pair",
        _NREL,
        "N/(mm µm)",
        (20.051822093657176, 15.402808090686957, 20.74749860408961, 17.635373813476168),
        partial(_wind_turbine, 3),
        1e-12,
        "rounding",
    ),
    Case(
        "contact ratio and Hertzian stiffness",
        _ROSS,
        "-, MN/m",
        (1.7897798668330458, 3555.8686079093266),
        _contact,
        1e-12,
        "rounding",
    ),
    Case(
        "mesh stiffness where a second pair of teeth comes in",
        _ROSS,
        "MN/m",
        (396.6229213581085,),
        _two_pairs_begin,
        0.05,
        "another root: straight from the base circle down there, the rack's trochoid here",
    ),
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
