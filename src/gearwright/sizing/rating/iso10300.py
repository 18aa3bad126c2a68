"""Rating of bevel gear meshes by ISO 10300, method B1, with scuffing and the required module."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, ClassVar, NamedTuple

import numpy as np

from gearwright.base import Check, DesignError, Floats, Origin, PartId, Problem, Quantity, Ratio
from gearwright.parts.bevel_geometry import WIDEST_MODULES, BevelPair
from gearwright.parts.gears import Numbers
from gearwright.parts.iso6336 import RZ_OVER_RA, GearSteel, life_curves
from gearwright.parts.iso10300 import (
    BOTH_OVERHUNG,
    HIGH_CROWNING,
    LOW_CROWNING,
    ONE_OVERHUNG,
    STRADDLE,
    BevelDuty,
    BevelRating,
    BevelSurfaces,
    bevel_pitch_tolerance,
    rate_bevel,
    virtual_mesh,
)
from gearwright.parts.scuffing import IntegralTemperature, ScuffingMesh, integral_temperature
from gearwright.sizing.rating.geometry import bevel_pair, cone_ratio
from gearwright.sizing.rating.iso6336 import (
    SAFETIES,
    Strain,
    Strains,
    damages,
    iso_making,
    life_limits,
    life_slope,
    safeties,
)
from gearwright.sizing.rating.iso6336_inputs import SQUARE_MM, steel_of
from gearwright.sizing.rating.iso6336_scuffing import FlashPeak, flash_peak, oil_of, scuffing_checks
from gearwright.sizing.rating.protocol import (
    Ask,
    ClassDamage,
    Factor,
    Load,
    LoadedMesh,
    Making,
    MeshSpectrum,
    Rating,
    by_teeth,
    factor_rows,
    steel_rows,
)
from gearwright.spec.missions import GearLifeRules

# ----------------------------------------------------------------------------------------------------------------------
# What ISO 10300 is told of a bevel stage beside its steel: duty, flanks, roots and oil.
# ----------------------------------------------------------------------------------------------------------------------


USUAL_CLASS = 5
"""Tolerance class of ISO 17485 where none is stated [-]."""
_MOUNTING = {"straddle": STRADDLE, "one-overhung": ONE_OVERHUNG, "both-overhung": BOTH_OVERHUNG}


def bevel_duty(rating: Rating, pair: BevelPair, torque: float, speed: float) -> BevelDuty:
    """Return what a bevel mesh carries.

    Args:
        rating: Resolved rules.
        pair: Its geometry.
        torque: On the pinion, of one mesh, load factor included [N m].
        speed: Of the pinion [rad/s].
    """
    rules = rating.rules.iso6336
    return BevelDuty(
        torque,
        speed,
        bevel_pitch_tolerance(pair.mean_diameters[1], pair.mean_module, rules.tolerance_class or USUAL_CLASS),
        application_factor=rating.service.application_factor,
        mounting=_MOUNTING[rules.mounting],
        cutter_radius=math.inf if rating.rules.cutter_radius is None else rating.rules.cutter_radius,
    )


def bevel_surfaces(rating: Rating) -> BevelSurfaces:
    """Return flanks, roots and oil of a bevel stage.

    Args:
        rating: Resolved rules.
    """
    rules = rating.rules.iso6336
    exponent = HIGH_CROWNING if rules.profile_crowning == "high" else LOW_CROWNING
    return BevelSurfaces(rules.flank_roughness, rules.root_roughness, rules.oil_viscosity * SQUARE_MM, exponent)


# ----------------------------------------------------------------------------------------------------------------------
# The mean normal module that bevel meshes ask for by ISO 10300.
# ----------------------------------------------------------------------------------------------------------------------


_STEPS = 4
"""Corrections of the module; each closes the gap to the asked safety to a tenth or better."""
_START = 0.3
"""Module over the cube root of the torque where the search begins [mm/(N m)^⅓]."""


def bevel_modules(ask: Ask, rating: Rating) -> tuple[Floats, Floats]:
    """Return the modules at which S_F = S_Fmin and S_H = S_Hmin [m].

    Args:
        ask: Load, teeth and width; numbers, or arrays over choices.
        rating: Resolved rules.
    """
    return by_teeth(ask, partial(_one_bevel, rating, steel_of(rating)))


def _one_bevel(
    rating: Rating, steel: GearSteel, teeth: tuple[int, int], torque: float, speed: float, ratio: float
) -> tuple[float, float]:
    rules, surfaces = rating.rules.iso6336, bevel_surfaces(rating)

    def rated(module: float) -> BevelRating:
        pair = bevel_pair(teeth, module, ratio * module, rating)
        duty = bevel_duty(rating, pair, torque, speed)
        return rate_bevel(pair, (steel, steel), duty, rating.service.life, surfaces=surfaces)

    def bending(found: BevelRating) -> float:
        return rules.bending_safety / min(root.safety for root in found.bending)

    def contact(found: BevelRating) -> float:
        return (rules.pitting_safety / min(found.pitting.safeties)) ** 2

    start = 1e-3 * _START * math.cbrt(torque)
    first = rated(start)  # the same for both
    modules = [start * math.cbrt(gap(first)) for gap in (bending, contact)]
    for _ in range(_STEPS - 1):
        modules = [
            module * math.cbrt(gap(rated(module))) for module, gap in zip(modules, (bending, contact), strict=True)
        ]
    return modules[0], modules[1]


# ----------------------------------------------------------------------------------------------------------------------
# Scuffing of a rated bevel mesh by the temperatures of its virtual cylindrical gears.
# ----------------------------------------------------------------------------------------------------------------------


SCUFFING = ("ISO/TR 13989-2, 6.2", "ISO/TS 6336-20 on the virtual cylindrical gears")
"""Of the integral and of the flash temperature."""
_SAMPLES = 21
"""Places of half the path at which the load over the zone of action is looked at; straight between them."""


class BevelTemperatures(NamedTuple):
    """Both temperatures of a bevel mesh."""

    integral: IntegralTemperature | None
    """By the integral temperature; None where contact lies on one side of the pitch point alone."""
    flash: FlashPeak | None
    """By the flash temperature; None where tips of the virtual gears interfere."""


def bevel_scuffing(rating: Rating, factors: BevelRating) -> BevelTemperatures:
    """Return the temperatures of a bevel mesh and its safeties, without relief of the tips.

    Args:
        rating: Resolved rules: roughness, class, oil.
        factors: As rated in the heaviest case.

    Source: ISO/TR 13989-2:2000, 6.2: the formulas of cylindrical gears with z_v, d_va, a_v, v_mt and
        w_Bt = K_A K_V K_Hβ K_Hα F_mt/(0.85 b); the flash temperature on the same gears, by ISO/TS 6336-20, is no
        document's: ISO/TS 10300-20 was not at hand.
    """
    rules, steel, geometry = rating.rules.iso6336, steel_of(rating), virtual_mesh(factors.virtual)
    force = factors.tangential_force / float(geometry.face_width)
    scuffed = ScuffingMesh(
        geometry,
        specific_load=force * float(factors.loads.contact),
        nominal_load=force * float(factors.loads.application),
        speed=factors.speed,
        roughness=rules.flank_roughness / RZ_OVER_RA,
        grade=rules.tolerance_class or USUAL_CLASS,
        elastic_modulus=steel.elastic_modulus,
        poisson_ratio=steel.poisson_ratio,
    )
    oil = oil_of(rules)
    around = min(float(ratio) for ratio in geometry.addendum_contact_ratios) > 0.0
    integral = integral_temperature(scuffed, oil) if around else None
    if not geometry.rolls:
        return BevelTemperatures(integral, None)

    def sharing(place: Floats) -> Floats:
        along = np.linspace(0.0, 0.5, _SAMPLES)  # even about the middle
        shares = [factors.virtual.load_share(part * factors.virtual.path) for part in along]
        return np.asarray(np.interp(np.abs((place - place[0]) / (place[-1] - place[0]) - 0.5), along, shares))

    return BevelTemperatures(integral, flash_peak(scuffed, oil, sharing))


# ----------------------------------------------------------------------------------------------------------------------
# At which limit of ISO 10300 a factor stands: there it no longer answers to what it depends on.
# ----------------------------------------------------------------------------------------------------------------------


_WORN, _SOFT = 1200e6, 850e6
"""σ_Hlim between which the film's constants run [Pa] (ISO 10300-2:2023, 8.2.3)."""
_Bounds = tuple[tuple[float, str], ...]
_FIXED: Mapping[tuple[str, str], _Bounds] = {
    ("load factors", "transverse contact"): ((1.0, "least"),),
    ("load factors", "transverse bending"): ((1.0, "least"),),
    ("tooth root", "contact ratio"): ((0.625, "least: ε_vβ from 1"),),
    ("tooth root", "spiral"): ((1.0, "straight teeth"),),
    ("tooth root", "size"): ((1.0, "greatest"), (0.8, "least"), (0.85, "least")),
}
"""Chapter and quantity -> values at which it is held, and which limit each is."""


def limited(rows: Iterable[Factor], rated: BevelRating, steel: GearSteel) -> Iterator[Factor]:
    """Yield the rows of a rating, each with the limit at which it stands.

    Args:
        rows: Of the rating.
        rated: That they show.
        steel: Of both gears.
    """
    known = {**_FIXED, **_own_limits(rated, steel)}
    for row in rows:
        bounds = known.get((row.chapter, row.quantity), ())
        words = dict.fromkeys(
            word for value in row.values for bound, word in bounds if math.isclose(float(value), bound, rel_tol=1e-12)
        )
        yield replace(row, limit=", ".join(words))


def _own_limits(rated: BevelRating, steel: GearSteel) -> dict[tuple[str, str], _Bounds]:
    """Return the limits that depend on the steel and the load."""
    limits: dict[tuple[str, str], _Bounds] = {}
    lives = (rated.contact_life, rated.root_life)
    for name, curve, factors in zip(("contact life", "root life"), life_curves(steel), lives, strict=True):
        limits["mesh", name] = tuple(
            bound
            for cycles, factor in zip(rated.cycles, factors, strict=True)
            for bound in life_limits(curve, cycles, factor)
        )
    if not _SOFT < steel.contact_strength < _WORN:
        end = "σ_Hlim counts as 1200" if steel.contact_strength >= _WORN else "σ_Hlim counts as 850"
        limits["pitting", "film"] = ((rated.pitting.film[0], end),)
    loads = rated.loads
    eased = float(loads.face_contact / loads.face_bending)
    for bound, words in ((1.0, "K_F0 least, or straight teeth"), (1.15, "K_F0 greatest")):
        if math.isclose(eased, bound, rel_tol=1e-12):
            limits["load factors", "face bending"] = ((float(loads.face_bending), words),)
    return limits


# ----------------------------------------------------------------------------------------------------------------------
# A bevel mesh as ISO 10300 rates it.
# ----------------------------------------------------------------------------------------------------------------------


_CONTACT, _ROOT = "ISO 10300-2:2023", "ISO 10300-3:2023"


@dataclass(frozen=True)
class Iso10300Rating:
    """A rated bevel mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    method: ClassVar[str] = "iso10300"
    case: str
    """Heaviest case."""
    factors: BevelRating
    """In that case, over the whole life."""
    steel: GearSteel
    """Of both gears."""
    pitting: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_H = σ_HP/σ_H; several cases: U(S_H σ_H) = 1", f"{_CONTACT}, eq. 5; ISO 6336-6:2019"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F = σ_FP/σ_F; several cases: U(S_F σ_F) = 1", f"{_ROOT}, eq. 5; ISO 6336-6:2019"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    scuffing: IntegralTemperature | None
    """In the heaviest case, on the virtual cylindrical gears; None where contact lies on one side of the pitch point
    alone."""
    flash: FlashPeak | None
    """In the heaviest case, on the same gears; None where their tips interfere."""
    pitting_asked: Ratio
    """S_Hmin [-]."""
    bending_asked: Ratio
    """S_Fmin [-]."""
    scuffing_asked: Ratio
    """S_Smin [-]."""
    scuffing_by: str
    """Temperature that it is against: ``integral``, ``flash`` or ``both``."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_mn at which S_F = S_Fmin", f"{_ROOT}, eq. 5")]
    """Mean normal module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_mn at which S_H = S_Hmin", f"{_CONTACT}, eq. 5")]
    """Mean normal module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("σ_F = σ_F0 K_A K_V K_Fβ K_Fα, the larger", f"{_ROOT}, eq. 1")
    ]
    """Root stress of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_ROOT}, eq. 5")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("σ_H = σ_H0 √(K_A K_V K_Hβ K_Hα)", f"{_CONTACT}, eq. 1")
    ]
    """Contact stress in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_CONTACT}, eq. 5")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_A K_V", "ISO 10300-1:2023")]
    """Factor on the nominal force for peaks of the load in the heaviest case [-]."""


# ----------------------------------------------------------------------------------------------------------------------
# ISO 10300 as a method of rating.
# ----------------------------------------------------------------------------------------------------------------------


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

    def of_sizes(self, mesh: LoadedMesh, left_out: Collection[str]) -> None:
        """Return nothing: sizes are taken one by one."""

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
