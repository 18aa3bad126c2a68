"""AGMA 2003 as a method of rating."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from gearwright.arrays import Floats
from gearwright.checks import Check
from gearwright.errors import DesignError, Problem
from gearwright.identity import PartId
from gearwright.parts.agma2001 import greatest_velocity
from gearwright.parts.agma2003 import (
    CONTACT,
    AgmaBevelMaking,
    AgmaBevelRating,
    MeanSection,
    bevel_geometry,
    rate_agma_bevel,
)
from gearwright.parts.bevel import WIDEST_MODULES
from gearwright.parts.gears import Numbers
from gearwright.parts.iso6336 import StressBin, damage_part, spectrum_damage
from gearwright.sizing.rating.agma2003.inputs import duty_of, making_of
from gearwright.sizing.rating.agma2003.limits import limited
from gearwright.sizing.rating.agma2003.record import Agma2003Rating
from gearwright.sizing.rating.factors import Factor, factor_rows
from gearwright.sizing.rating.protocol import ClassDamage, Load, LoadedMesh, Making, MeshSpectrum
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.search import by_teeth
from gearwright.sizing.rating.standard_teeth import bevel_pair, cone_ratio
from gearwright.spec.missions import GearLifeRules

USUAL_BEVEL_WIDTH = 0.30
"""Face width of bevel gears over the outer cone distance b/R_e [-] (ANSI/AGMA 2003-D19, annex D)."""
_STEPS = 4
"""Corrections of the module; each closes the gap to the asked safety to a tenth or better."""
_START = 0.3
"""Module over the cube root of the torque where the search begins [mm/(N m)^⅓]."""


class Agma2003:
    """Straight and spiral bevel gears on square axes."""

    edition = "ANSI/AGMA 2003-D19"
    peaks = "K_o K_v"
    life_source = "Miner, AGMA 2003-D19, clause 16"
    safeties: Mapping[str, tuple[str, ...]] = MappingProxyType(
        {"pitting": ("agma2003", "pitting_safety"), "bending": ("agma2003", "bending_safety")}
    )

    def refuse(self, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
        """Yield teeth that are undercut, and straight ones of which at times none are in contact."""
        try:
            MeanSection(bevel_pair(teeth, 1.0, float(self.width_ratio(rating, *map(np.asarray, teeth))), rating))
        except DesignError as error:
            yield from error.problems

    def width_ratio(self, rating: Rating, small: Floats, large: Floats) -> Floats:
        """Return λ of b = min(0.30 R_e, 10 m_et) [-]."""
        cones = cone_ratio(small, large)
        share = np.minimum(USUAL_BEVEL_WIDTH, WIDEST_MODULES / cones)
        return np.asarray(share * cones / (math.cos(rating.helix_angle) * (1.0 - 0.5 * share)))

    def module(self, ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
        """Return the mean normal modules at which S_F and S_H are the asked ones [m]."""
        rules, making = rating.rules.agma2003, making_of(rating)

        def search(teeth: tuple[int, int], torque: float, speed: float, ratio: float) -> tuple[float, float]:
            geometry = bevel_geometry(bevel_pair(teeth, 1.0, ratio, rating))
            duty = duty_of(rating, ask, torque, speed=speed, life=rating.service.life)

            def gaps(module: float) -> tuple[float, float]:
                pair = bevel_pair(teeth, module, ratio * module, rating)
                one, other = rate_agma_bevel(pair, duty, making, geometry).gears
                flank = min(one.contact_safety, other.contact_safety)
                return (
                    rules.bending_safety / min(one.bending_safety, other.bending_safety),
                    (rules.pitting_safety / flank) ** 2,
                )

            modules = [1e-3 * _START * math.cbrt(torque)] * 2
            for _ in range(_STEPS):
                modules = [module * math.cbrt(gaps(module)[mode]) for mode, module in enumerate(modules)]
            return modules[0], modules[1]

        return by_teeth(ask, search)

    def rate(self, mesh: LoadedMesh) -> Agma2003Rating:
        """Return the factors of the heaviest case, and the safeties under all cases by Miner's sum."""
        rules, making = mesh.rating.rules.agma2003, making_of(mesh.rating)
        factors = _rated(mesh.rating, mesh.heaviest, making, mesh.module, mesh.face_width)
        alone = mesh.loads == (mesh.heaviest,)
        every = [factors] if alone else [
            _rated(mesh.rating, load, making, mesh.module, mesh.face_width) for load in mesh.loads
        ]  # fmt: skip
        pitting = _safety(every, 0, making, contact=True), _safety(every, 1, making, contact=True)
        bending = _safety(every, 0, making, contact=False), _safety(every, 1, making, contact=False)
        return Agma2003Rating(
            case=mesh.heaviest.case,
            factors=factors,
            edition=making.edition,
            pitting=pitting,
            bending=bending,
            pitting_asked=rules.pitting_safety,
            bending_asked=rules.bending_safety,
            velocity_limit=greatest_velocity(rules.quality_number),
            module_bending=mesh.asked[0],
            module_contact=mesh.asked[1],
            bending_stress=max(gear.bending_stress for gear in factors.gears),
            bending_margin=min(bending) / rules.bending_safety,
            contact_stress=factors.gears[0].contact_stress,
            contact_margin=min(pitting) / rules.pitting_safety,
            peaks=factors.mesh.overload * factors.mesh.dynamic,
        )

    def reserve(self, rated: Agma2003Rating) -> float:
        """Return the factor on the loads; the contact stress grows with its root [-]."""
        return min(rated.bending_margin, rated.contact_margin**2)

    def reserve_of(self, mesh: LoadedMesh) -> float:
        """Return the same of a mesh whose record nobody reads [-]."""
        return self.reserve(self.rate(mesh))

    def damage(self, spectrum: MeshSpectrum) -> tuple[ClassDamage, ClassDamage]:
        """Return Miner's parts, with the stresses and the stress cycle factors of AGMA 2003 in each class."""
        rating, making = spectrum.rating, making_of(spectrum.rating)
        loads = zip(spectrum.torques, spectrum.speeds, strict=True)
        every = [
            _rated(rating, Load("", torque, spectrum.ask._replace(speed=speed), 1.0), making, spectrum.module,
                   spectrum.face_width)
            for torque, speed in loads
        ]  # fmt: skip
        first, second = (float(np.asarray(teeth)) for teeth in spectrum.ask.teeth)
        both = []
        for gear, relative in enumerate((1.0, first / second)):
            cycles = [turns * relative * spectrum.ask.passes[gear] for turns in spectrum.turns]
            modes = ((True, CONTACT), (False, making.bending_curve))
            both.append(ClassDamage(*(
                [damage_part(turns, _over(one, gear, contact=mode), curve)
                 for one, turns in zip(every, cycles, strict=True)]
                for mode, curve in modes
            )))  # fmt: skip
        return both[0], both[1]

    def life_slope(self, rating: Rating, mode: str, steel: GearLifeRules) -> float:
        """Return 1/e of the stress cycle factor below its corner [-]."""
        return (CONTACT if mode == "pitting" else making_of(rating).bending_curve).slope

    def checks(self, rated: Agma2003Rating, mesh: PartId, gears: tuple[PartId, PartId]) -> Iterator[Check]:
        """Yield both safeties of both gears, and whether the curve of K_v holds at this velocity."""
        for gear, pitting, bending in zip(gears, rated.pitting, rated.bending, strict=True):
            yield Check(gear, "pitting", "AGMA 2003-D19, eq. 2", pitting, rated.pitting_asked, symbol="S_H")
            yield Check(gear, "tooth root", "AGMA 2003-D19, eq. 6", bending, rated.bending_asked, symbol="S_F")
        speed, limit, clause = rated.factors.mesh.speed, rated.velocity_limit, "AGMA 2003-D19, eq. 17: range of K_v"
        yield Check(mesh, "velocity", clause, speed, limit, "velocity", at_most=True, exponent=None, symbol="v_et")

    def factors(self, rated: Agma2003Rating) -> Iterator[Factor]:
        """Yield loads, geometry factors, strengths and stresses, each with the limit at which it stands."""
        yield from limited(factor_rows(rated.factors, "mesh"), rated.edition)

    def making(self, rating: Rating) -> Making:
        """Return accuracy and steel."""
        rules = rating.rules.agma2003
        hardness = f", {rules.hardness_hb:g} HB" if rules.steel == "through-hardened" else ""
        steel = f"{rules.steel}, grade {rules.grade}{hardness}"
        return Making(f"Q_v {rules.quality_number} AGMA 2003", steel=("AGMA 2003-D19", steel))


def _rated(rating: Rating, load: Load, making: AgmaBevelMaking, module: float, face_width: float) -> AgmaBevelRating:
    pinion, wheel = (round(float(np.asarray(tooth))) for tooth in load.ask.teeth)
    pair = bevel_pair((pinion, wheel), module, face_width, rating)
    duty = duty_of(rating, load.ask, float(load.torque), speed=float(np.asarray(load.ask.speed)), life=load.life)
    return rate_agma_bevel(pair, duty, making)


def _over(rated: AgmaBevelRating, gear: int, *, contact: bool) -> float:
    """Return the stress of one gear over its limit at a stress cycle factor of 1 [-]."""
    one, mesh = rated.gears[gear], rated.mesh
    if contact:
        return one.contact_stress * mesh.contact_cycles[gear] / one.contact_limit
    return one.bending_stress * mesh.bending_cycles[gear] / one.bending_limit


def _safety(every: Sequence[AgmaBevelRating], gear: int, making: AgmaBevelMaking, *, contact: bool) -> float:
    if len(every) == 1:
        one = every[0].gears[gear]
        return one.contact_safety if contact else one.bending_safety
    curve = CONTACT if contact else making.bending_curve
    bins = [StressBin(_over(rated, gear, contact=contact), rated.mesh.cycles[gear]) for rated in every]
    return spectrum_damage(bins, 1.0, curve).safety
