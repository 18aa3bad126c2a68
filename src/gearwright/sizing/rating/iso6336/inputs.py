"""What ISO 6336 is told of a stage: steel, quality of flanks and roots, and duty."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from gearwright.catalogue import rated_steel
from gearwright.parts.iso6336 import (
    CENTRED,
    CORRECTED_AND_CROWNED,
    CROWNED,
    UNMODIFIED,
    Edition,
    GearSteel,
    MeshDuty,
    MeshQuality,
    PinionShaft,
    bending_life_curve,
    contact_life_curve,
)
from gearwright.sizing.rating.rules import Rating

IDLER_MEAN_STRESS = 0.7
"""Y_M of gears that are loaded on both flanks [-] (ISO 6336-3:2019, annex B)."""
SQUARE_MM = 1e-6
_PARTS = tuple((f"ISO 6336-{part}", f"DIN 3990-{part}:1987") for part in (1, 2, 3))
EDITIONS = {"iso6336": Edition.ISO2019, "iso6336-2006": Edition.ISO2006, "din3990": Edition.DIN1987}
"""Name of a method -> edition."""
_HELIX = {"none": UNMODIFIED, "crowning": CROWNED, "corrected": CORRECTED_AND_CROWNED}


def steel_of(rating: Rating) -> GearSteel:
    """Return the steel of a stage as ISO 6336 rates it.

    Args:
        rating: Resolved rules.

    Raises:
        DesignError: Unknown class or grade, or a hardness outside the grade's range.
    """
    rules = rating.rules.iso6336
    steel = rated_steel(rating.material, rules.steel, rules.grade, hardness=rules.hardness_hv)
    return _endless(steel) if EDITIONS.get(rating.method) is Edition.DIN1987 else steel


def _endless(steel: GearSteel) -> GearSteel:
    """Return a steel whose strength does not fall beyond the knee, as DIN 3990 has it; its own S-N curves stay."""
    return replace(
        steel,
        contact_life=steel.contact_life or contact_life_curve(steel.treatment, at_1e10=1.0),
        bending_life=steel.bending_life or bending_life_curve(steel.treatment, at_1e10=1.0),
    )


def clause_of(source: str, edition: Edition) -> str:
    """Return the source of a quantity in the words of an edition; of DIN 3990 its part.

    Args:
        source: With the edition of 2019.
        edition: That rates.
    """
    if edition is Edition.ISO2006:
        return source.replace(":2019", ":2006")
    if edition is Edition.DIN1987:
        return next((own for part, own in _PARTS if part in source), source)
    return source


def quality_of(rating: Rating, *, idlers: tuple[bool, bool], shaft: PinionShaft = CENTRED) -> MeshQuality:
    """Return how the flanks of a stage are made and mounted.

    Args:
        rating: Resolved rules.
        idlers: Which of the two gears is loaded on both flanks.
        shaft: Where the pinion sits on its shaft.
    """
    rules = rating.rules.iso6336
    means = [IDLER_MEAN_STRESS if idler else 1.0 for idler in idlers]
    return MeshQuality(
        grade=rules.tolerance_class,
        flank_roughness=rules.flank_roughness,
        root_roughness=rules.root_roughness,
        tip_relief=rules.tip_relief,
        helix=_HELIX[rules.helix_modification],
        shaft=shaft,
        viscosity=rules.oil_viscosity * SQUARE_MM,
        mean_stresses=(means[0], means[1]),
    )


def duty_of(
    rating: Rating, torque: ArrayLike, speed: ArrayLike, *, life: ArrayLike, passes: tuple[float, float]
) -> MeshDuty:
    """Return what a cylindrical mesh carries.

    Args:
        rating: Resolved rules.
        torque: On the first gear, of one mesh, load factor included [N m].
        speed: Of the first gear against the carrier [rad/s].
        life: Time under that load [s].
        passes: Mates that a tooth of each gear meets in a turn [-].
    """
    return MeshDuty(
        np.asarray(torque, dtype=float) / rating.load_factor,
        np.asarray(speed, dtype=float),
        np.asarray(life, dtype=float),
        application_factor=rating.service.application_factor,
        mesh_load_factor=rating.load_factor,
        meshes_per_turn=passes,
    )
