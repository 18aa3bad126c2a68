"""Lewis and Hertz as a method of rating."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from gearwright.arrays import Floats
from gearwright.checks import Check, stressed
from gearwright.errors import Problem
from gearwright.identity import PartId
from gearwright.parts.gears import Numbers, bending_stress_lewis, contact_stress
from gearwright.sizing.rating.factors import Factor
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.sizing.rating.lewis_hertz import strength
from gearwright.sizing.rating.lewis_hertz.record import LewisHertzRating
from gearwright.sizing.rating.protocol import ClassDamage, LoadedMesh, Making, MeshSpectrum
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.search import untabulated
from gearwright.sizing.rating.standard_teeth import working_radii
from gearwright.spec.design import Iso6336Rules
from gearwright.spec.missions import GearLifeRules

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
        return np.full(small.shape, strength.width_ratio(rating.rules, rating.helix_angle))

    def module(self, ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
        """Return the modules that bending and contact ask for, in closed form [m]."""
        return strength.first_modules(ask, rating)

    def rate(self, mesh: LoadedMesh) -> LewisHertzRating:
        """Return stresses and margins in the worst case."""
        rating, ask, width = mesh.rating, mesh.heaviest.ask, mesh.face_width
        first, second = (int(teeth) for teeth in ask.teeth)
        radii = working_radii(first, second, rating, internal=ask.internal, module=mesh.module)
        diameters = [2.0 * radius for radius in radii]
        force = 2.0 * mesh.heaviest.torque / diameters[0]
        form = float(strength.form_factor(min(ask.teeth), rating))
        bending = float(bending_stress_lewis(force, width, mesh.module, form_factor=form))
        curvature = 2.0 / diameters[0] + (-2.0 if ask.internal else 2.0) / diameters[1]
        angles = strength.working_angles(rating, ask, stretch=diameters[0] / (mesh.module * first))
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
        bending_allowed = strength.bending_allowable(rating, idler=any(ask.idlers))
        contact_allowed = strength.contact_allowable(rating)
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
