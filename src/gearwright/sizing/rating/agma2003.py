"""Straight and spiral bevel gears by ANSI/AGMA 2003, with the geometry factors of its annex C."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Annotated, ClassVar

import numpy as np

from gearwright.base import Check, DesignError, Floats, Origin, PartId, Problem, Quantity, Ratio, Velocity
from gearwright.parts.agma2001 import greatest_velocity
from gearwright.parts.agma2003 import (
    CONTACT,
    CROWNED,
    GREATEST_BENDING,
    GREATEST_CONTACT,
    ONE_STRADDLE,
    OVERHUNG,
    STRADDLE,
    UNCROWNED,
    AgmaBevelDuty,
    AgmaBevelMaking,
    AgmaBevelRating,
    BevelEdition,
    BevelSteel,
    bevel_geometry,
    bevel_strength,
    rate_agma_bevel,
    size_factor_contact,
)
from gearwright.parts.agma2003_geometry import MeanSection
from gearwright.parts.bevel_geometry import WIDEST_MODULES
from gearwright.parts.gears import Numbers
from gearwright.parts.iso6336 import StressBin, damage_part, spectrum_damage
from gearwright.sizing.rating.geometry import bevel_pair, cone_ratio
from gearwright.sizing.rating.protocol import ClassDamage, Factor, Load, LoadedMesh, Making, MeshSpectrum, factor_rows
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.search import by_teeth
from gearwright.spec.missions import GearLifeRules

# ----------------------------------------------------------------------------------------------------------------------
# What AGMA 2003 is told of a bevel stage: duty, steel, accuracy, mounting.
# ----------------------------------------------------------------------------------------------------------------------


_MOUNTING = {"straddle": STRADDLE, "one-overhung": ONE_STRADDLE, "both-overhung": OVERHUNG}


def making_of(rating: Rating) -> AgmaBevelMaking:
    """Return steel, accuracy and mounting of a bevel stage.

    Args:
        rating: Resolved rules.

    Raises:
        DesignError: A grade that the steel does not have, or a hardness out of its range.
    """
    rules, steel = rating.rules.agma2003, BevelSteel(rating.rules.agma2003.steel)
    hardnesses = rules.hardness_hb, rules.wheel_hardness_hb or rules.hardness_hb
    first, second = (bevel_strength(steel, rules.grade, hardness) for hardness in hardnesses)
    return AgmaBevelMaking(
        (first, second),
        hardnesses=hardnesses if steel is BevelSteel.THROUGH_HARDENED else None,
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
        quality=rules.quality_number,
        mounting=_MOUNTING[rules.mounting],
        crowning=CROWNED if rules.crowned else UNCROWNED,
        cutter_radius=math.inf if rating.rules.cutter_radius is None else rating.rules.cutter_radius,
        reliability=rules.reliability,
        temperature=rules.blank_temperature,
        is_critical=rules.critical_service,
        edition=BevelEdition[rules.edition],
    )


def duty_of(rating: Rating, ask: Ask, torque: float, *, speed: float, life: float) -> AgmaBevelDuty:
    """Return what a bevel mesh carries.

    Args:
        rating: Resolved rules.
        ask: Which gears are loaded on both flanks, and how many mates a tooth meets in a turn.
        torque: On the pinion, of one mesh, load factor included [N m].
        speed: Of the pinion [rad/s].
        life: Time under that load [s].
    """
    return AgmaBevelDuty(
        torque,
        float(np.asarray(speed)),
        life,
        overload=rating.service.application_factor,
        meshes_per_turn=ask.passes,
        is_reversed=ask.idlers,
    )


# ----------------------------------------------------------------------------------------------------------------------
# At which limit of AGMA 2003 a factor stands: there it no longer answers to what it depends on.
# ----------------------------------------------------------------------------------------------------------------------


_FIXED: dict[tuple[str, str], tuple[tuple[float, str], ...]] = {
    ("mesh", "size contact"): ((0.5, "least: b up to 12.7 mm"),),
    ("mesh", "size bending"): ((0.5, "least: m_et below 1.6 mm"),),
    ("mesh", "curvature"): ((1.0, "least, or straight teeth"), (1.15, "greatest")),
    ("mesh", "contact cycles"): ((GREATEST_CONTACT, "greatest: 1e4 cycles"),),
    ("mesh", "bending cycles"): ((GREATEST_BENDING, "greatest: 1e3 cycles"),),
    ("mesh", "temperature"): ((1.0, "least: up to 250 °F"),),
    ("pitting", "inertia"): ((1.0, "least: ε_o from 2"),),
    ("tooth root", "inertia"): ((1.0, "least: ε_o from 2"),),
}
"""Chapter and quantity -> values at which it is held, and which limit each is."""


def limited(rows: Iterable[Factor], edition: BevelEdition) -> Iterator[Factor]:
    """Yield the rows of a rating, each with the limit at which it stands.

    Args:
        rows: Of the rating.
        edition: By which it is.
    """
    widest = (size_factor_contact(edition.value, edition), f"greatest: b from {1e3 * edition.value:g} mm")
    known = _FIXED | {("mesh", "size contact"): (*_FIXED["mesh", "size contact"], widest)}
    for row in rows:
        bounds = known.get((row.chapter, row.quantity), ())
        words = dict.fromkeys(
            word for value in row.values for bound, word in bounds if math.isclose(float(value), bound, rel_tol=1e-12)
        )
        yield replace(row, limit=", ".join(words))


# ----------------------------------------------------------------------------------------------------------------------
# A bevel mesh as AGMA 2003 rates it.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCE = "ANSI/AGMA 2003-D19"


@dataclass(frozen=True)
class Agma2003Rating:
    """A rated bevel mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    method: ClassVar[str] = "agma2003"
    case: str
    """Heaviest case."""
    factors: AgmaBevelRating
    """In that case, over the whole life."""
    edition: BevelEdition
    """Whose C_s."""
    pitting: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_H = s_wc/s_c; several cases: Σ n/N(S_H s_c) = 1", f"{_SOURCE}, eq. 2"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F = s_wt/s_t; several cases: Σ n/N(S_F s_t) = 1", f"{_SOURCE}, eq. 6"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    pitting_asked: Ratio
    """Least S_H [-]."""
    bending_asked: Ratio
    """Least S_F [-]."""
    velocity_limit: Velocity
    """Up to which the curve of K_v holds [m/s]."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_mn with the least S_F", f"{_SOURCE}, eqs 5 and 6")]
    """Mean normal module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_mn with the least S_H", f"{_SOURCE}, eqs 1 and 2")]
    """Mean normal module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("s_t = W_t K_o K_v K_s K_m/(b m_et K_x J), the larger", f"{_SOURCE}, eq. 5")
    ]
    """Bending stress number of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_SOURCE}, eq. 6")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("s_c = C_p √(W_t K_o K_v K_m C_s C_xc/(b d_e1 I))", f"{_SOURCE}, eq. 1")
    ]
    """Contact stress number in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_SOURCE}, eq. 2")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_o K_v", f"{_SOURCE}, clauses 7 and 10")]
    """Factor on the nominal force for peaks of the load in the heaviest case [-]."""


# ----------------------------------------------------------------------------------------------------------------------
# AGMA 2003 as a method of rating.
# ----------------------------------------------------------------------------------------------------------------------


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

    def of_sizes(self, mesh: LoadedMesh, left_out: Collection[str]) -> None:
        """Return nothing: sizes are taken one by one."""

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
