"""The rating rules of one stage, resolved: allowables, widths and the module that a torque per tooth asks for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.parts import Material, contact_strength
from gearwright.parts.gears import (
    ContactAngles,
    Numbers,
    contact_angles,
    lewis_form_factor,
    module_hertz,
    module_lewis,
    virtual_teeth,
)
from gearwright.spec import Design, GearRules, Pair
from gearwright.spec.design import Service

Array = NDArray[np.float64]
SPUR_WIDTH_RATIO = 10.0
"""λ = b/m_n of spur gears where nothing else is said (Pulvirenti 2023 leaves λ open; 10 is usual for aircraft)."""


@dataclass(frozen=True)
class Rating:
    """Gear rules in the numbers that the formulas take."""

    rules: GearRules
    kind: Literal["cylindrical", "face", "bevel"]
    material: Material
    helix_angle: float
    """β, of bevel gears β_m [rad]."""
    given_width_ratio: float | None
    """λ = b/m_n where it does not depend on the teeth [-]."""
    bending_allowable: float
    """R_p0.2 over its factor [Pa]."""
    contact_allowable: float
    """2.5 HB over its factor [Pa]."""
    angles: ContactAngles
    service: Service

    @property
    def load_factor(self) -> float:
        """K_γ [-]."""
        return self.rules.mesh_load_factor or 1.0

    @property
    def by_standard(self) -> bool:
        """True where ISO 6336 or ISO 10300 rates the gears."""
        return self.rules.rating == "iso6336"


def rating_of(design: Design, name: str) -> Rating:
    """Return the resolved rules of a stage; planetary sets are spur.

    Args:
        design: As read.
        name: Of a pair or planetary set.
    """
    rules, stage = design.rules(name), design.stages[name]
    pair = stage if isinstance(stage, Pair) else None
    helix = 0.0 if pair is None else pair.spiral_angle if pair.kind == "bevel" else rules.helix_angle
    material = design.material(rules.material)
    return Rating(
        rules=rules,
        kind="cylindrical" if pair is None else pair.kind,
        material=material,
        helix_angle=helix,
        given_width_ratio=_given_width_ratio(rules, helix),
        bending_allowable=(material.yield_strength or 0.0) / rules.bending_safety,
        contact_allowable=contact_strength(material.surface_hardness or 0.0) / rules.contact_safety,
        angles=contact_angles(rules.pressure_angle, helix, transverse=rules.contact_angles == "transverse"),
        service=design.service,
    )


def _given_width_ratio(rules: GearRules, helix: float) -> float | None:
    if rules.rating == "iso6336":
        return rules.face_width_ratio
    return width_ratio(rules, helix)


def width_ratio(rules: GearRules, helix: float) -> float:
    """Return λ = b/m_n [-] of the first sizing: given, or from the overlap ratio, or that of spur gears.

    Args:
        rules: As the design gives them.
        helix: β [rad].

    Source: Pulvirenti 2023, eq. (2.3), which fixes λ = ε_β π / sin β for helical gears.
    """
    if rules.face_width_ratio is not None:
        return rules.face_width_ratio
    return rules.overlap_ratio * math.pi / math.sin(helix) if helix else SPUR_WIDTH_RATIO


class Ask(NamedTuple):
    """What is asked of one mesh."""

    per_tooth: Numbers
    """T/z of one mesh, its share of the load included [N m]."""
    teeth: tuple[Numbers, Numbers]
    """Tooth numbers of the two gears, the external (or smaller) one first [-]."""
    width_ratio: Numbers
    """λ = b/m_n [-]."""
    internal: bool = False
    """The second gear is internal."""
    idlers: tuple[bool, bool] = (False, False)
    """Which of the two gears is loaded on both flanks."""
    speed: Numbers = 0.0
    """Of the first gear against the carrier [rad/s]; only ISO 6336 asks for it."""
    passes: tuple[float, float] = (1.0, 1.0)
    """Mates that a tooth of each gear meets in a turn [-]; only ISO 6336 asks for it."""


def form_factor(teeth: Numbers, rating: Rating) -> Numbers:
    """Return the Lewis form factor at the virtual tooth number [-].

    Args:
        teeth: z [-].
        rating: Resolved rules.
    """
    if not isinstance(teeth, np.ndarray):
        return _form_factor(teeth, rating.helix_angle, rating.rules.pressure_angle)
    return lewis_form_factor(virtual_teeth(teeth, rating.rules.pressure_angle, rating.helix_angle))


@lru_cache(maxsize=4096)
def _form_factor(teeth: float, helix: float, pressure_angle: float) -> float:
    """Return the form factor of one gear; those of a study repeat."""
    return float(lewis_form_factor(virtual_teeth(teeth, pressure_angle, helix)))


def first_modules(ask: Ask, rating: Rating) -> tuple[Array, Array]:
    """Return the modules that Lewis's bending and Hertz's contact ask of a mesh [m].

    Args:
        ask: Load and teeth. An internal gear is not the weaker in bending, and its curvature is negative.
        rating: Resolved rules.
    """
    pinion, wheel = ask.teeth
    weaker = pinion if ask.internal else np.minimum(pinion, wheel)
    allowable = rating.bending_allowable * (rating.rules.idler_factor if any(ask.idlers) else 1.0)
    bending = module_lewis(
        ask.per_tooth,
        form_factor(weaker, rating),
        ask.width_ratio,
        allowable=allowable,
        helix_angle=rating.helix_angle,
    )
    contact = module_hertz(
        ask.per_tooth,
        1.0 / pinion - 1.0 / wheel if ask.internal else 1.0 / pinion + 1.0 / wheel,
        ask.width_ratio,
        allowable=rating.contact_allowable,
        elastic_modulus=rating.material.elastic_modulus,
        angles=rating.angles,
        helix_angle=rating.helix_angle,
    )
    return bending, contact
