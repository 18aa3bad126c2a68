"""Preliminary sizing of gears by Lewis bending and Hertzian contact, after Pulvirenti 2023."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from types import MappingProxyType
from typing import Annotated, ClassVar

import numpy as np

from gearwright.base import Check, Endless, Floats, Origin, PartId, Problem, Quantity, stressed
from gearwright.parts import contact_strength
from gearwright.parts.gears import (
    ContactAngles,
    Numbers,
    bending_stress_lewis,
    contact_angles,
    contact_stress,
    lewis_form_factor,
    module_hertz,
    module_lewis,
    virtual_teeth,
)
from gearwright.sizing.rating.geometry import push_angle, working_radii
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.sizing.rating.protocol import (
    Ask,
    ClassDamage,
    Factor,
    LoadedMesh,
    Making,
    MeshSpectrum,
    Rating,
    untabulated,
)
from gearwright.spec import GearLifeRules, GearRules
from gearwright.spec.design import Iso6336Rules

# ----------------------------------------------------------------------------------------------------------------------
# Allowables, form factors and widths of the first sizing, and the modules that a torque per tooth asks for.
# ----------------------------------------------------------------------------------------------------------------------


SPUR_WIDTH_RATIO = 10.0
"""λ = b/m_n of spur gears where nothing else is said (Pulvirenti 2023 leaves λ open; 10 is usual for aircraft)."""


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


def bending_allowable(rating: Rating, *, idler: bool) -> float:
    """Return R_p0.2 over its factor [Pa], of idlers their share of it.

    Args:
        rating: Resolved rules.
        idler: A gear of the mesh is loaded on both flanks.
    """
    whole = (rating.material.yield_strength or 0.0) / rating.rules.bending_safety
    return whole * (rating.rules.idler_factor if idler else 1.0)


def contact_allowable(rating: Rating) -> float:
    """Return 2.5 HB over its factor [Pa].

    Args:
        rating: Resolved rules.
    """
    return contact_strength(rating.material.surface_hardness or 0.0) / rating.rules.contact_safety


def angles_of(rating: Rating) -> ContactAngles:
    """Return the angles of the contact formula.

    Args:
        rating: Resolved rules.
    """
    rules = rating.rules
    return contact_angles(rules.pressure_angle, rating.helix_angle, transverse=rules.contact_angles == "transverse")


def working_angles(rating: Rating, ask: Ask, *, stretch: float) -> ContactAngles:
    """Return the angles of the contact formula at the working pitch circles.

    Args:
        rating: Resolved rules.
        ask: Teeth of both gears.
        stretch: Working pitch diameter over z m_n [-].

    Source: ISO 21771:2007, tan β_w = tan β d_w/d, tan α_wn = tan α_wt cos β_w.
    """
    if rating.shifts.centre is None:
        return angles_of(rating)
    first, second = (int(teeth) for teeth in ask.teeth)
    helix = math.atan(math.tan(rating.helix_angle) * stretch * math.cos(rating.helix_angle))
    angle = math.tan(push_angle(first, second, rating, internal=ask.internal)) * math.cos(helix)
    return contact_angles(math.atan(angle), helix, transverse=rating.rules.contact_angles == "transverse")


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


def first_modules(ask: Ask, rating: Rating) -> tuple[Floats, Floats]:
    """Return the modules that Lewis's bending and Hertz's contact ask of a mesh [m].

    Args:
        ask: Load and teeth. An internal gear is not the weaker in bending, and its curvature is negative.
        rating: Resolved rules.
    """
    pinion, wheel = ask.teeth
    bending = module_lewis(
        ask.per_tooth,
        form_factor(np.minimum(pinion, wheel), rating),
        ask.width_ratio,
        allowable=bending_allowable(rating, idler=any(ask.idlers)),
        helix_angle=rating.helix_angle,
    )
    contact = module_hertz(
        ask.per_tooth,
        1.0 / pinion - 1.0 / wheel if ask.internal else 1.0 / pinion + 1.0 / wheel,
        ask.width_ratio,
        allowable=contact_allowable(rating),
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
        angles=angles_of(rating),
        helix_angle=rating.helix_angle,
    )
    return bending, contact


# ----------------------------------------------------------------------------------------------------------------------
# A mesh as Lewis and Hertz rate it.
# ----------------------------------------------------------------------------------------------------------------------


_THESIS = "Pulvirenti 2023"


@dataclass(frozen=True)
class LewisHertzRating:
    """A mesh at its worst case: the root of the weaker gear, and the flanks at the pitch point."""

    method: ClassVar[str] = "lewis-hertz"
    case: str
    module_bending: Annotated[
        float, Quantity("length"), Origin("m_n³ = 2 (T/z) cos β / (λ Y σ)", f"{_THESIS}, eq. 2.1, cube root")
    ]
    """Module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("from σ_H = 2.5 HB / S", f"{_THESIS}, eq. 2.2, 0.418")]
    """Module that contact asks for [m]."""
    form_factor: Annotated[float, Quantity("ratio"), Origin("Y at z_v", "Shigley, 9th ed., table 14-2")]
    """Lewis form factor of the weaker gear [-]."""
    bending_stress: Annotated[float, Quantity("stress"), Origin("σ = F_t / (b m_n Y)", "Lewis 1892")]
    """Bending stress of the weaker gear [Pa]."""
    bending_allowable: Annotated[
        float, Quantity("stress"), Origin("R_p0.2 over the asked factor", f"{_THESIS}, eq. 2.1")
    ]
    """Share of idlers included [Pa]."""
    bending_margin: Annotated[
        float, Quantity("ratio"), Origin("R_p0.2 / σ over the asked factor", f"{_THESIS}, eq. 2.1"), Endless()
    ]
    """Allowable over actual bending stress [-]; 1 is just enough, ∞ where nothing bends a tooth."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("σ_H = 0.418 √(F_t E Σ(1/r) cos β / (b cos α sin α))", f"{_THESIS}, eq. 2.2")
    ]
    """Hertz pressure at the pitch point [Pa]."""
    contact_allowable: Annotated[
        float, Quantity("stress"), Origin("2.5 HB over the asked factor", f"{_THESIS}, eq. 2.2")
    ]
    """[Pa]"""
    contact_margin: Annotated[
        float, Quantity("ratio"), Origin("2.5 HB / σ_H over the asked factor", f"{_THESIS}, eq. 2.2"), Endless()
    ]
    """Allowable over actual contact pressure [-]; 1 is just enough, ∞ where nothing presses the flanks."""
    peaks: Annotated[float, Quantity("ratio"), Origin("1: the loads are nominal", f"{_THESIS}, eqs 2.1, 2.2")] = 1.0
    """Factor on the tangential force for peaks of the load [-]."""


# ----------------------------------------------------------------------------------------------------------------------
# Lewis and Hertz as a method of rating.
# ----------------------------------------------------------------------------------------------------------------------


_OIL_VISCOSITY = 100.0
"""ν_40 where no standard rates the gears [mm²/s]: the film factor Z_L is 1 there."""


class LewisHertz:
    """First sizing of cylindrical and face gears."""

    edition = "Lewis and Hertz"
    peaks = ""
    life_source = "Miner, ISO 6336-6"
    safeties: Mapping[str, tuple[str, ...]] = MappingProxyType(
        {"pitting": ("contact_safety",), "bending": ("bending_safety",)}
    )

    def refuse(self, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
        """Yield fewer teeth than its table has."""
        yield from untabulated(rating, teeth)

    def width_ratio(self, rating: Rating, small: Floats, large: Floats) -> Floats:
        """Return λ of the overlap ratio, or that of spur gears [-]."""
        return np.full(small.shape, width_ratio(rating.rules, rating.helix_angle))

    def module(self, ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
        """Return the modules that bending and contact ask for, in closed form [m]."""
        return first_modules(ask, rating)

    def rate(self, mesh: LoadedMesh) -> LewisHertzRating:
        """Return stresses and margins in the worst case."""
        rating, ask, width = mesh.rating, mesh.heaviest.ask, mesh.face_width
        first, second = (int(teeth) for teeth in ask.teeth)
        radii = working_radii(first, second, rating, internal=ask.internal, module=mesh.module)
        diameters = [2.0 * radius for radius in radii]
        force = 2.0 * mesh.heaviest.torque / diameters[0]
        form = float(form_factor(min(ask.teeth), rating))
        bending = float(bending_stress_lewis(force, width, mesh.module, form_factor=form))
        curvature = 2.0 / diameters[0] + (-2.0 if ask.internal else 2.0) / diameters[1]
        angles = working_angles(rating, ask, stretch=diameters[0] / (mesh.module * first))
        contact = float(
            contact_stress(
                force,
                width,
                curvature,
                angles=angles,
                elastic_modulus=rating.material.elastic_modulus,
                poisson_ratio=rating.material.poisson_ratio,
            )
        )
        bending_allowed = bending_allowable(rating, idler=any(ask.idlers))
        contact_allowed = contact_allowable(rating)
        return LewisHertzRating(
            case=mesh.heaviest.case,
            module_bending=mesh.asked[0],
            module_contact=mesh.asked[1],
            form_factor=form,
            bending_stress=bending,
            bending_allowable=bending_allowed,
            bending_margin=bending_allowed / bending if bending else math.inf,
            contact_stress=contact,
            contact_allowable=contact_allowed,
            contact_margin=contact_allowed / contact if contact else math.inf,
        )

    def reserve(self, rated: LewisHertzRating) -> float:
        """Return the factor on the loads; the contact stress grows with its root [-]."""
        return min(rated.bending_margin, rated.contact_margin**2)

    def reserve_of(self, mesh: LoadedMesh) -> float:
        """Return the same of a mesh whose record nobody reads [-]."""
        return self.reserve(self.rate(mesh))

    def of_sizes(self, mesh: LoadedMesh, left_out: Collection[str]) -> None:
        """Return nothing: sizes are taken one by one."""

    def damage(self, spectrum: MeshSpectrum) -> tuple[ClassDamage, ClassDamage]:
        """Return Miner's parts by ISO 6336 with the mission's steel: Lewis and Hertz know no life."""
        return Iso6336().damage(spectrum._replace(rating=_by_iso(spectrum.rating, spectrum.steel)))

    def life_slope(self, rating: Rating, mode: str, steel: GearLifeRules) -> float:
        """Return p of the S-N curve of the mission's steel [-]."""
        return Iso6336().life_slope(_by_iso(rating, steel), mode, steel)

    def checks(self, rated: LewisHertzRating, mesh: PartId, gears: tuple[PartId, PartId]) -> Iterator[Check]:
        """Yield both stresses."""
        bending = (rated.bending_stress, rated.bending_margin, "Pulvirenti 2023, eq. 2.1")
        contact = (rated.contact_stress, rated.contact_margin, "Pulvirenti 2023, eq. 2.2")
        for mode, (stress, margin, clause) in {"bending": bending, "contact": contact}.items():
            yield stressed(mesh, mode, clause, stress, margin, case=rated.case)

    def factors(self, rated: LewisHertzRating) -> Iterator[Factor]:
        """Yield nothing: the table of stresses and margins has all that there is."""
        yield from ()

    def making(self, rating: Rating) -> Making:
        """Return that no accuracy is chosen."""
        return Making("not chosen (Lewis and Hertz)")


def _by_iso(rating: Rating, steel: GearLifeRules) -> Rating:
    """Return the rules of a stage as ISO 6336 rates it with the mission's steel."""
    rules = Iso6336Rules(
        steel=steel.steel,
        grade=steel.grade,
        hardness_hv=steel.hardness_hv,
        tolerance_class=steel.flank_class,
        helix_modification="none",
        tip_relief_for="run-in",
        oil_viscosity=_OIL_VISCOSITY,
    )
    return replace(rating, rules=rating.rules.model_copy(update={"iso6336": rules}))
