"""The rating rules of one mesh, resolved: allowables, widths and the module that a torque per tooth asks for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearwright.catalogue.materials import materials
from gearwright.parts.hertz import ContactAngles, contact_angles, module_hertz
from gearwright.parts.lewis import lewis_form_factor, module_lewis, virtual_teeth
from gearwright.parts.material import Material, contact_strength
from gearwright.spec import GearRules

Array = NDArray[np.float64]
SPUR_WIDTH_RATIO = 10.0
"""λ = b/m_n of spur gears where nothing else is said (Pulvirenti 2023 leaves λ open; 10 is usual for aircraft)."""


@dataclass(frozen=True)
class Rating:
    """Gear rules in the numbers that the formulas take."""

    rules: GearRules
    material: Material
    helix_angle: float
    """β [rad]."""
    width_ratio: float
    """λ = b/m_n [-]."""
    bending_allowable: float
    """R_p0.2 over its factor [Pa]."""
    contact_allowable: float
    """2.5 HB over its factor [Pa]."""
    angles: ContactAngles

    @property
    def load_factor(self) -> float:
        """K_γ [-]."""
        return self.rules.mesh_load_factor or 1.0


def rating_of(rules: GearRules, *, helical: bool) -> Rating:
    """Return the resolved rules of a stage.

    Args:
        rules: As the design gives them.
        helical: The helix angle applies (pairs); planetary sets are spur.
    """
    material = materials()[rules.material]
    helix = rules.helix_angle if helical else 0.0
    return Rating(
        rules=rules,
        material=material,
        helix_angle=helix,
        width_ratio=width_ratio(rules, helix),
        bending_allowable=(material.yield_strength or 0.0) / rules.bending_safety,
        contact_allowable=contact_strength(material.surface_hardness or 0.0) / rules.contact_safety,
        angles=contact_angles(rules.pressure_angle, helix, transverse=rules.contact_angles == "transverse"),
    )


def width_ratio(rules: GearRules, helix: float) -> float:
    """Return λ = b/m_n [-]: given, or from the overlap ratio ε_β = b sin β / (π m_n), or that of spur gears.

    Args:
        rules: As the design gives them.
        helix: β [rad].

    Source: Pulvirenti 2023, eq. (2.3), which fixes λ = ε_β π / sin β for helical gears.
    """
    if rules.face_width_ratio is not None:
        return rules.face_width_ratio
    return rules.overlap_ratio * math.pi / math.sin(helix) if helix else SPUR_WIDTH_RATIO


def form_factor(teeth: ArrayLike, rating: Rating) -> Array:
    """Return the Lewis form factor at the virtual tooth number [-].

    Args:
        teeth: z [-].
        rating: Resolved rules.
    """
    number = np.asarray(teeth, dtype=float)
    if number.ndim == 0:
        return _form_factor(float(number), rating.helix_angle, rating.rules.pressure_angle)
    return lewis_form_factor(virtual_teeth(teeth, rating.helix_angle, rating.rules.pressure_angle))


@lru_cache(maxsize=4096)
def _form_factor(teeth: float, helix: float, pressure_angle: float) -> Array:
    """Return the form factor of one gear; those of a study repeat."""
    return lewis_form_factor(virtual_teeth(teeth, helix, pressure_angle))


def modules(
    torque_per_tooth: ArrayLike, teeth: tuple[ArrayLike, ArrayLike], rating: Rating, *, internal: bool = False,
    idler: bool = False,
) -> tuple[Array, Array]:  # fmt: skip
    """Return the modules that bending and contact ask of a mesh [m].

    Args:
        torque_per_tooth: T/z of one mesh, its share of the load included [N m].
        teeth: Tooth numbers of the two gears, the external (or smaller) one first [-].
        rating: Resolved rules.
        internal: The second gear is internal: it is not the weaker in bending, and its curvature is negative.
        idler: A gear of the mesh is loaded on both flanks.
    """
    one, other = (np.asarray(each, dtype=float) for each in teeth)
    weaker = one if internal else np.minimum(one, other)
    allowable = rating.bending_allowable * (rating.rules.idler_factor if idler else 1.0)
    bending = module_lewis(
        torque_per_tooth,
        form_factor(weaker, rating),
        rating.width_ratio,
        allowable=allowable,
        helix_angle=rating.helix_angle,
    )
    contact = module_hertz(
        torque_per_tooth,
        1.0 / one - 1.0 / other if internal else 1.0 / one + 1.0 / other,
        rating.width_ratio,
        allowable=rating.contact_allowable,
        elastic_modulus=rating.material.elastic_modulus,
        angles=rating.angles,
        helix_angle=rating.helix_angle,
    )
    return bending, contact
