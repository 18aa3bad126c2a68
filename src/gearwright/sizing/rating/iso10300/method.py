"""ISO 10300 as a method of rating."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from gearwright.arrays import Floats
from gearwright.checks import Check
from gearwright.errors import DesignError, Problem
from gearwright.identity import PartId
from gearwright.parts.bevel import WIDEST_MODULES, BevelRating, rate_bevel
from gearwright.parts.gears import Numbers
from gearwright.sizing.rating.factors import Factor, factor_rows, steel_rows
from gearwright.sizing.rating.iso6336 import steel_of
from gearwright.sizing.rating.iso6336.method import SAFETIES, iso_making, life_slope
from gearwright.sizing.rating.iso6336.miner import Strain, Strains, damages, safeties
from gearwright.sizing.rating.iso6336.scuffing import scuffing_checks
from gearwright.sizing.rating.iso10300.inputs import bevel_duty, bevel_surfaces
from gearwright.sizing.rating.iso10300.limits import limited
from gearwright.sizing.rating.iso10300.module import bevel_modules
from gearwright.sizing.rating.iso10300.record import Iso10300Rating
from gearwright.sizing.rating.iso10300.scuffing import SCUFFING, bevel_scuffing
from gearwright.sizing.rating.protocol import ClassDamage, Load, LoadedMesh, Making, MeshSpectrum
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.standard_teeth import bevel_pair, cone_ratio
from gearwright.spec.missions import GearLifeRules

USUAL_BEVEL_WIDTH = 0.30
"""Face width of bevel gears over the outer cone distance b/R_e [-] (ISO 23509:2016, annex B)."""


class Iso10300:
    """Straight and spiral bevel gears on square axes."""

    edition = "ISO 10300, method B1"
    peaks = "K_A K_V"
    life_source = "Miner, ISO 6336-6"
    safeties = SAFETIES

    def refuse(self, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
        """Yield teeth that are undercut."""
        try:
            bevel_pair(teeth, 1.0, float(self.width_ratio(rating, *map(np.asarray, teeth))), rating)
        except DesignError as error:
            yield from error.problems

    def width_ratio(self, rating: Rating, small: Floats, large: Floats) -> Floats:
        """Return λ of b = min(0.30 R_e, 10 m_et), ISO 23509:2016, annex B [-]."""
        cones = cone_ratio(small, large)
        share = np.minimum(USUAL_BEVEL_WIDTH, WIDEST_MODULES / cones)
        return np.asarray(share * cones / (math.cos(rating.helix_angle) * (1.0 - 0.5 * share)))

    def module(self, ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
        """Return the mean normal modules at which S_F = S_Fmin and S_H = S_Hmin [m]."""
        return bevel_modules(ask, rating)

    def rate(self, mesh: LoadedMesh) -> Iso10300Rating:
        """Return the factors of the heaviest case, and the safeties under all cases by Miner's sum (ISO 6336-6)."""
        rules, steel = mesh.rating.rules.iso6336, steel_of(mesh.rating)
        factors = _rated(mesh.rating, mesh.heaviest, mesh.module, mesh.face_width)
        alone = mesh.loads == (mesh.heaviest,)
        every = [factors] if alone else [
            _rated(mesh.rating, load, mesh.module, mesh.face_width) for load in mesh.loads
        ]  # fmt: skip
        temperatures = bevel_scuffing(mesh.rating, factors)
        pitting, bending = safeties([_strains(rated) for rated in every], (steel, steel))
        return Iso10300Rating(
            case=mesh.heaviest.case,
            factors=factors,
            steel=steel,
            pitting=pitting,
            bending=bending,
            scuffing=temperatures.integral,
            flash=temperatures.flash,
            pitting_asked=rules.pitting_safety,
            bending_asked=rules.bending_safety,
            scuffing_asked=rules.scuffing_safety,
            scuffing_by=rules.scuffing_method,
            module_bending=mesh.asked[0],
            module_contact=mesh.asked[1],
            bending_stress=max(root.stress for root in factors.bending),
            bending_margin=min(bending) / rules.bending_safety,
            contact_stress=factors.pitting.stress,
            contact_margin=min(pitting) / rules.pitting_safety,
            peaks=float(factors.loads.application * factors.loads.dynamic),
        )

    def reserve(self, rated: Iso10300Rating) -> float:
        """Return the factor on the loads; the contact stress grows with its root [-]."""
        return min(rated.bending_margin, rated.contact_margin**2)

    def reserve_of(self, mesh: LoadedMesh) -> float:
        """Return the factor on the loads without scuffing, which it does not ask for [-]."""
        rules, steel = mesh.rating.rules.iso6336, steel_of(mesh.rating)
        every = [_rated(mesh.rating, load, mesh.module, mesh.face_width) for load in mesh.loads]
        pitting, bending = safeties([_strains(rated) for rated in every], (steel, steel))
        return min(min(bending) / rules.bending_safety, (min(pitting) / rules.pitting_safety) ** 2)

    def damage(self, spectrum: MeshSpectrum) -> tuple[ClassDamage, ClassDamage]:
        """Return Miner's parts by ISO 6336-6, with the stresses of ISO 10300-2 and -3 in each class."""
        loads = zip(spectrum.torques, spectrum.speeds, strict=True)
        every = [
            _rated(spectrum.rating, Load("", torque, spectrum.ask._replace(speed=speed), 1.0),
                   spectrum.module, spectrum.face_width)
            for torque, speed in loads
        ]  # fmt: skip
        strains = [_strains(rated) for rated in every]
        return damages(_stacked(strains), spectrum, (steel_of(spectrum.rating),) * 2)

    def life_slope(self, rating: Rating, mode: str, steel: GearLifeRules) -> float:
        """Return p of the S-N curve of the steel [-]."""
        return life_slope(rating, mode)

    def checks(self, rated: Iso10300Rating, mesh: PartId, gears: tuple[PartId, PartId]) -> Iterator[Check]:
        """Yield both safeties of both gears, and that against scuffing."""
        for gear, pitting, bending in zip(gears, rated.pitting, rated.bending, strict=True):
            yield Check(gear, "pitting", "ISO 10300-2, eq. 5", pitting, rated.pitting_asked, symbol="S_H")
            yield Check(gear, "tooth root", "ISO 10300-3, eq. 5", bending, rated.bending_asked, symbol="S_F")
        yield from scuffing_checks(rated, mesh, clauses=SCUFFING)

    def factors(self, rated: Iso10300Rating) -> Iterator[Factor]:
        """Yield steel, loads, flanks, roots and scuffing."""
        yield from steel_rows(rated.steel)
        yield from limited(factor_rows(rated.factors, "mesh"), rated.factors, rated.steel)
        if rated.scuffing is not None:
            for row in factor_rows(rated.scuffing, "scuffing"):
                yield replace(row, clause=f"{SCUFFING[0]}; as {row.clause}")
        if rated.flash is not None:
            for row in factor_rows(rated.flash, "scuffing, flash temperature"):
                yield replace(row, clause=f"{SCUFFING[1]}; as {row.clause}")

    def making(self, rating: Rating) -> Making:
        """Return flank class, roughness and steel."""
        return iso_making(rating, "ISO 17485", None)


def _rated(rating: Rating, load: Load, module: float, face_width: float) -> BevelRating:
    pinion, wheel = (round(float(np.asarray(tooth))) for tooth in load.ask.teeth)
    pair, steel = bevel_pair((pinion, wheel), module, face_width, rating), steel_of(rating)
    duty = bevel_duty(rating, pair, float(load.torque), float(np.asarray(load.ask.speed)))
    return rate_bevel(pair, (steel, steel), duty, load.life, surfaces=bevel_surfaces(rating))


def _strains(rated: BevelRating) -> Strains:
    """Return stress and limits of flanks and roots of both gears."""
    pitting = rated.pitting
    flanks = [
        Strain(pitting.stress, pitting.permissible[gear] / rated.contact_life[gear], pitting.permissible[gear],
               rated.cycles[gear])
        for gear in (0, 1)
    ]  # fmt: skip
    roots = [
        Strain(root.stress, root.permissible / life, root.permissible, cycles)
        for root, life, cycles in zip(rated.bending, rated.root_life, rated.cycles, strict=True)
    ]
    return (flanks[0], flanks[1]), (roots[0], roots[1])


def _stacked(rated: list[Strains]) -> Strains:
    """Return the strains of several loads as arrays over them."""
    (flank, root) = (
        tuple(Strain(*map(np.array, zip(*(row[mode][gear] for row in rated), strict=True))) for gear in (0, 1))
        for mode in (0, 1)
    )
    return (flank[0], flank[1]), (root[0], root[1])
