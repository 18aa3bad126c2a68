"""Rating of cylindrical gears by AGMA 2001 and of bevel gears by AGMA 2003."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Annotated, ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import (
    Check,
    DesignError,
    Floats,
    Origin,
    PartId,
    Problem,
    Quantity,
    Ratio,
    Role,
    Velocity,
    smallest,
)
from gearwright.parts.agma908 import HobbedPair, bending_geometry
from gearwright.parts.agma2001 import (
    BENDING_CARBURISED,
    BENDING_HB160,
    BENDING_HB250,
    BENDING_HB400,
    BENDING_NITRIDED,
    COMMERCIAL,
    EXTRA_PRECISION,
    OPEN_GEARING,
    PITTING,
    PITTING_NITRIDED,
    PRECISION,
    AgmaDuty,
    AgmaMaking,
    AgmaPairRating,
    AgmaSteel,
    AgmaWheel,
    Hardnesses,
    agma_strength,
    allowable_yield,
    greatest_velocity,
    rate_agma,
    rim_factor_agma,
    yield_safety,
)
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
from gearwright.parts.gears import ISO53_A, Numbers
from gearwright.parts.iso6336 import LifeCurve, StressBin, damage_part, spectrum_damage
from gearwright.sizing.rating.geometry import RIMMED, bevel_pair, cone_ratio, widest_ratio
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
    module_for,
    untabulated,
)
from gearwright.spec.missions import GearLifeRules

# ----------------------------------------------------------------------------------------------------------------------
# What AGMA 2001 is told of a stage: teeth, steel, accuracy, mounting.
# ----------------------------------------------------------------------------------------------------------------------


_ENCLOSURES = {
    "open": OPEN_GEARING, "commercial": COMMERCIAL, "precision": PRECISION, "extra-precision": EXTRA_PRECISION,
}  # fmt: skip
_BY_HARDNESS = {160.0: BENDING_HB160, 250.0: BENDING_HB250, 400.0: BENDING_HB400}
"""HB -> Y_N of through-hardened steel; the nearest one is taken."""
CROWNED_FACE, ADJUSTED = 0.8, 0.8
"""C_mc and C_e of such gears [-] (AGMA 2001-D04, clause 15.3)."""


def hobbed_pair(ask: Ask, width_ratio: ArrayLike, rating: Rating) -> HobbedPair:
    """Return the teeth of a mesh in normal modules, with the basic rack 1.25/0.38 of ISO 53, profile A.

    Args:
        ask: Teeth of pinion and wheel.
        width_ratio: b/m_n [-].
        rating: Resolved rules: angles and profile shift.
    """
    pinion, wheel = (np.asarray(teeth, dtype=float) for teeth in ask.teeth)
    first, second = rating.shifts.mesh(internal=False)
    return HobbedPair(
        (pinion, wheel),
        pressure_angle=rating.rules.pressure_angle,
        helix_angle=rating.helix_angle,
        face_width=np.asarray(width_ratio, dtype=float),
        profile_shifts=(first.profile_shift, second.profile_shift),
        hob_addendum=ISO53_A.dedendum,
        hob_radius=ISO53_A.fillet_radius,
    )


def making_of(rating: Rating, roles: tuple[Role, Role] = (Role.PINION, Role.WHEEL)) -> AgmaMaking:
    """Return steel, accuracy and mounting of a stage.

    Args:
        rating: Resolved rules.
        roles: What both gears are in their stage; wheels may have rims.

    Raises:
        DesignError: A grade that the steel does not have, or a hardness out of its range.
    """
    rules = rating.rules.agma2001
    steel = AgmaSteel(rules.steel)
    return AgmaMaking(
        strength=agma_strength(steel, rules.grade, rules.hardness_hb),
        bending_curve=_bending_curve(steel, rules.hardness_hb),
        contact_curve=PITTING_NITRIDED if steel is AgmaSteel.NITRIDED_4140 else PITTING,
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
        quality=rules.quality_number,
        mounting=_ENCLOSURES[rules.enclosure],
        crowning=CROWNED_FACE if rules.crowned else 1.0,
        adjustment=ADJUSTED if rules.adjusted else 1.0,
        reliability=rules.reliability,
        temperature=rules.temperature_factor,
        wheel=_wheel(rating),
        rims=(_rim(rating, roles[0]), _rim(rating, roles[1])),
    )


def yield_strength_of(rating: Rating, gear: int) -> float | None:
    """Return the allowable yield strength number s_ay of one gear [Pa]; None where nothing says it.

    Args:
        rating: Resolved rules.
        gear: 0 for the pinion, 1 for the gear.

    Source: ANSI/AGMA 2001-D04, clause 16.4, by HB; of carburised gears R_p0.2 of their core.
    """
    rules = rating.rules.agma2001
    own = rules if gear == 0 or rules.wheel is None else rules.wheel
    if own.steel == AgmaSteel.CARBURISED.value:
        return rating.material.yield_strength
    return allowable_yield(own.hardness_hb)


def _wheel(rating: Rating) -> AgmaWheel | None:
    rules = rating.rules.agma2001
    if rules.wheel is None:
        return None
    steel, through = AgmaSteel(rules.wheel.steel), AgmaSteel.THROUGH_HARDENED
    return AgmaWheel(
        agma_strength(steel, rules.wheel.grade, rules.wheel.hardness_hb),
        _bending_curve(steel, rules.wheel.hardness_hb),
        PITTING_NITRIDED if steel is AgmaSteel.NITRIDED_4140 else PITTING,
        Hardnesses(
            rules.hardness_hb,
            rules.wheel.hardness_hb,
            hard_pinion=AgmaSteel(rules.steel) is not through,
            hard_wheel=steel is not through,
            roughness=rules.flank_roughness,
        ),
    )


def _rim(rating: Rating, role: Role) -> float:
    ratio = rating.rules.rim_ratio
    return 1.0 if ratio is None or role not in RIMMED else float(np.asarray(rim_factor_agma(ratio)))


def _bending_curve(steel: AgmaSteel, hardness: float) -> LifeCurve:
    if steel is AgmaSteel.CARBURISED:
        return BENDING_CARBURISED
    if steel is AgmaSteel.NITRIDED_4140:
        return BENDING_NITRIDED
    return _BY_HARDNESS[min(_BY_HARDNESS, key=lambda known: abs(known - hardness))]


# ----------------------------------------------------------------------------------------------------------------------
# Static cases of a mesh by AGMA 2001: roots must not yield under a momentary overload.
# ----------------------------------------------------------------------------------------------------------------------


_CLAUSE = "AGMA 2001-D04, clause 16.4"


@dataclass(frozen=True)
class YieldingCase:
    """How near to yielding the roots of a mesh come in a static case."""

    case: str
    """Its name."""
    strengths: Annotated[tuple[float, float], Quantity("stress"), Origin("s_ay", _CLAUSE)]
    """Allowable yield strength numbers of both gears [Pa]."""
    safeties: Annotated[tuple[float, float], Quantity("ratio"), Origin("s_ay K_y F m_t J K_f/(W_max K_my)", _CLAUSE)]
    """Safety against yielding of both gears [-]."""


class YieldingMesh(Protocol):
    """A mesh with its worst static case."""

    @property
    def static(self) -> YieldingCase | None:
        """That case."""

    @property
    def yielding_asked(self) -> float:
        """Least safety [-]."""


def worst_yielding(mesh: LoadedMesh) -> YieldingCase | None:
    """Return the static case that comes nearest to yielding; None where there is none, or no yield strength is known.

    Args:
        mesh: As loaded.
    """
    known = [yield_strength_of(mesh.rating, gear) for gear in (0, 1)]
    if known[0] is None or known[1] is None:
        return None
    strengths = known[0], known[1]
    cases = [_case(mesh, load, strengths) for load in mesh.loads if load.static]
    return smallest(cases, lambda case: min(case.safeties)) if cases else None


def yielding_checks(rated: YieldingMesh, gears: tuple[PartId, PartId]) -> Iterator[Check]:
    """Yield the judgements on yielding.

    Args:
        rated: The mesh.
        gears: Both gears.
    """
    if rated.static is None:
        return
    for gear, safety in zip(gears, rated.static.safeties, strict=True):
        yield Check(gear, "yielding root", _CLAUSE, safety, rated.yielding_asked, symbol="S_y", case=rated.static.case)


def _case(mesh: LoadedMesh, load: Load, strengths: tuple[float, float]) -> YieldingCase:
    pair = hobbed_pair(load.ask, mesh.face_width / mesh.module, mesh.rating)
    transverse = mesh.module / float(np.cos(pair.helix_angle))
    force = load.torque / (float(np.asarray(pair.radii[0])) * mesh.module)
    first, second = (
        float(
            np.asarray(
                yield_safety(
                    force,
                    bending_geometry(pair, gear),
                    strength,
                    face_width=mesh.face_width,
                    module=transverse,
                    factor=mesh.rating.rules.agma2001.yield_factor,
                )
            )
        )
        for gear, strength in enumerate(strengths)
    )
    return YieldingCase(load.case, strengths, (first, second))


# ----------------------------------------------------------------------------------------------------------------------
# A mesh as AGMA 2001 rates it.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCE = "ANSI/AGMA 2001-D04"


@dataclass(frozen=True)
class Agma2001Rating:
    """A rated mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    method: ClassVar[str] = "agma2001"
    case: str
    """Heaviest case."""
    factors: AgmaPairRating
    """In that case, over the whole life."""
    pitting: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_H; several cases: Σ n/N(S_H s_c) = 1", f"{_SOURCE}, eq. 4"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F; several cases: Σ n/N(S_F s_t) = 1", f"{_SOURCE}, eq. 13"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    pitting_asked: Ratio
    """Least S_H [-]."""
    bending_asked: Ratio
    """Least S_F [-]."""
    static: YieldingCase | None
    """The static case that comes nearest to yielding; None where none loads the mesh or no yield strength is known."""
    yielding_asked: Ratio
    """Least safety against yielding [-]."""
    velocity_limit: Velocity
    """Up to which the curve of K_v holds [m/s]."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_n with the least S_F", f"{_SOURCE}, eqs 10, 13")]
    """Module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_n with the least S_H", f"{_SOURCE}, eqs 1, 4")]
    """Module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("s_t = W_t K_o K_v K_s K_m K_B/(F m_t J), the larger", f"{_SOURCE}, eq. 10")
    ]
    """Bending stress number of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_SOURCE}, eq. 13")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float,
        Quantity("stress"),
        Origin("s_c = C_p √(W_t K_o K_v K_s K_m C_f/(d F I)), the larger", f"{_SOURCE}, eq. 1"),
    ]
    """Contact stress number of the higher stressed gear in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_SOURCE}, eq. 4")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_o K_v", f"{_SOURCE}, clauses 8 and 9")]
    """Factor on the nominal force for peaks of the load in the heaviest case [-]."""


# ----------------------------------------------------------------------------------------------------------------------
# AGMA 2001 as a method of rating.
# ----------------------------------------------------------------------------------------------------------------------


class Agma2001:
    """External spur and helical gears."""

    edition = "ANSI/AGMA 2001-D04"
    peaks = "K_o K_v"
    life_source = "Miner, AGMA 2001-D04, clause 17"
    safeties: Mapping[str, tuple[str, ...]] = MappingProxyType(
        {"pitting": ("agma2001", "pitting_safety"), "bending": ("agma2001", "bending_safety")}
    )

    def refuse(self, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
        """Yield pinions with more teeth than their wheels, and fewer teeth than the table of its size factor has."""
        yield from untabulated(rating, teeth)
        if teeth[0] > teeth[1]:
            message = f"{teeth[0]} teeth drive or meet {teeth[1]}; AGMA 2001 calls the smaller gear pinion, name it so"
            yield Problem("pinion", message)

    def width_ratio(self, rating: Rating, small: Floats, large: Floats) -> Floats:
        """Return λ of the widest gears that are allowed; the face width is narrowed later [-]."""
        return widest_ratio(rating, small)

    def module(self, ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
        """Return the modules at which S_F and S_H are the asked ones [m]."""
        rules, making = rating.rules.agma2001, making_of(rating, ask.roles)
        torque = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0], dtype=float)
        pair = hobbed_pair(ask, ask.width_ratio, rating)
        duty = _duty(rating, ask, torque, ask.speed, rating.service.life)

        def safeties_at(module: Floats) -> tuple[Floats, Floats]:
            one, other = rate_agma(pair, module, duty, making).gears
            bending = np.minimum(one.bending_safety, other.bending_safety)
            return np.asarray(bending), np.asarray(np.minimum(one.contact_safety, other.contact_safety))

        return module_for(safeties_at, torque, (rules.bending_safety, rules.pitting_safety))

    def rate(self, mesh: LoadedMesh) -> Agma2001Rating:
        """Return the factors of the heaviest case, and the safeties under all cases by Miner's sum."""
        rules, making = mesh.rating.rules.agma2001, making_of(mesh.rating, mesh.heaviest.ask.roles)
        factors = _rate_pair(mesh, mesh.heaviest, making)
        every = [factors] if mesh.loads == (mesh.heaviest,) else [_rate_pair(mesh, load, making) for load in mesh.loads]
        pitting = _both([_safety(every, gear, making, contact=True) for gear in (0, 1)])
        bending = _both([_safety(every, gear, making, contact=False) for gear in (0, 1)])
        return Agma2001Rating(
            case=mesh.heaviest.case,
            factors=factors,
            pitting=pitting,
            bending=bending,
            pitting_asked=rules.pitting_safety,
            bending_asked=rules.bending_safety,
            static=worst_yielding(mesh),
            yielding_asked=rules.yielding_safety,
            velocity_limit=greatest_velocity(rules.quality_number),
            module_bending=mesh.asked[0],
            module_contact=mesh.asked[1],
            bending_stress=max(float(gear.bending_stress) for gear in factors.gears),
            bending_margin=min(bending) / rules.bending_safety,
            contact_stress=max(float(gear.contact_stress) for gear in factors.gears),
            contact_margin=min(pitting) / rules.pitting_safety,
            peaks=float(factors.overload * factors.dynamic),
        )

    def reserve(self, rated: Agma2001Rating) -> float:
        """Return the factor on the loads; the contact stress grows with its root [-]."""
        return min(rated.bending_margin, rated.contact_margin**2)

    def reserve_of(self, mesh: LoadedMesh) -> float:
        """Return the same of a mesh whose record nobody reads [-]."""
        return self.reserve(self.rate(mesh))

    def of_sizes(self, mesh: LoadedMesh, left_out: Collection[str]) -> None:
        """Return nothing: sizes are taken one by one."""

    def damage(self, spectrum: MeshSpectrum) -> tuple[ClassDamage, ClassDamage]:
        """Return Miner's parts, with the stresses and the stress cycle factors of AGMA 2001 in each class."""
        rating, making = spectrum.rating, making_of(spectrum.rating, spectrum.ask.roles)
        pair = hobbed_pair(spectrum.ask, spectrum.face_width / spectrum.module, rating)
        duty = _duty(rating, spectrum.ask, np.asarray(spectrum.torques), np.asarray(spectrum.speeds), 1.0)
        rated = rate_agma(pair, spectrum.module, duty, making)
        first, second = (float(np.asarray(teeth)) for teeth in spectrum.ask.teeth)
        both = []
        for gear, relative in enumerate((1.0, first / second)):
            cycles = [turns * relative * spectrum.ask.passes[gear] for turns in spectrum.turns]
            modes = zip((True, False), making.curves_of(gear), strict=True)
            both.append(ClassDamage(*(
                [damage_part(turns, ratio, curve)
                 for turns, ratio in zip(cycles, _over(rated, gear, contact=mode).tolist(), strict=True)]
                for mode, curve in modes
            )))  # fmt: skip
        return both[0], both[1]

    def life_slope(self, rating: Rating, mode: str, steel: GearLifeRules) -> float:
        """Return 1/e of the stress cycle factor below its corner [-]."""
        making = making_of(rating)
        return (making.contact_curve if mode == "pitting" else making.bending_curve).slope

    def checks(self, rated: Agma2001Rating, mesh: PartId, gears: tuple[PartId, PartId]) -> Iterator[Check]:
        """Yield both safeties of both gears, and whether the curve of K_v holds at this velocity."""
        for gear, pitting, bending in zip(gears, rated.pitting, rated.bending, strict=True):
            yield Check(gear, "pitting", "AGMA 2001-D04, eq. 4", pitting, rated.pitting_asked, symbol="S_H")
            yield Check(gear, "tooth root", "AGMA 2001-D04, eq. 13", bending, rated.bending_asked, symbol="S_F")
        yield from yielding_checks(rated, gears)
        speed, clause = float(rated.factors.speed), "AGMA 2001-D04, clause 8: range of K_v"
        limit = rated.velocity_limit
        yield Check(mesh, "velocity", clause, speed, limit, "velocity", at_most=True, exponent=None, symbol="v_t")

    def factors(self, rated: Agma2001Rating) -> Iterator[Factor]:
        """Yield loads, geometry factors, stresses and strengths."""
        yield from factor_rows(rated.factors, "mesh")
        if rated.static is not None:
            yield from factor_rows(rated.static, "static strength")

    def making(self, rating: Rating) -> Making:
        """Return accuracy and steel."""
        rules = rating.rules.agma2001
        hardness = "" if rules.steel == "carburised" else f", {rules.hardness_hb:g} HB"
        steel = f"{rules.steel}, grade {rules.grade}{hardness}"
        if (own := rules.wheel) is not None:
            steel += f"; wheels {own.steel}, grade {own.grade}, {own.hardness_hb:g} HB"
        return Making(f"Q_v {rules.quality_number} AGMA 2000", steel=("AGMA 2001-D04", steel))


def _duty(rating: Rating, ask: Ask, torque: Numbers, speed: Numbers, life: float) -> AgmaDuty:
    return AgmaDuty(torque, speed, life, overload=rating.service.application_factor, meshes_per_turn=ask.passes)


def _rate_pair(mesh: LoadedMesh, load: Load, making: AgmaMaking) -> AgmaPairRating:
    pair = hobbed_pair(load.ask, mesh.face_width / mesh.module, mesh.rating)
    return rate_agma(pair, mesh.module, _duty(mesh.rating, load.ask, load.torque, load.ask.speed, load.life), making)


def _over(rated: AgmaPairRating, gear: int, *, contact: bool) -> Floats:
    """Return the stresses of one gear over their limit at a stress cycle factor of 1 [-]."""
    one = rated.gears[gear]
    if contact:
        return np.asarray(one.contact_stress * rated.contact_cycles[gear] / one.contact_limit)
    return np.asarray(one.bending_stress * rated.bending_cycles[gear] / one.bending_limit)


def _safety(every: Sequence[AgmaPairRating], gear: int, making: AgmaMaking, *, contact: bool) -> float:
    if len(every) == 1:
        one = every[0].gears[gear]
        return float(one.contact_safety if contact else one.bending_safety)
    curve = making.curves_of(gear)[0 if contact else 1]
    bins = [StressBin(float(_over(rated, gear, contact=contact)), float(rated.cycles[gear])) for rated in every]
    return spectrum_damage(bins, 1.0, curve).safety


def _both(values: Sequence[float]) -> tuple[float, float]:
    return values[0], values[1]


# ----------------------------------------------------------------------------------------------------------------------
# What AGMA 2003 is told of a bevel stage: duty, steel, accuracy, mounting.
# ----------------------------------------------------------------------------------------------------------------------


_MOUNTING = {"straddle": STRADDLE, "one-overhung": ONE_STRADDLE, "both-overhung": OVERHUNG}


def bevel_making_of(rating: Rating) -> AgmaBevelMaking:
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


_BEVELS = "ANSI/AGMA 2003-D19"


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
        Origin("S_H = s_wc/s_c; several cases: Σ n/N(S_H s_c) = 1", f"{_BEVELS}, eq. 2"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F = s_wt/s_t; several cases: Σ n/N(S_F s_t) = 1", f"{_BEVELS}, eq. 6"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    pitting_asked: Ratio
    """Least S_H [-]."""
    bending_asked: Ratio
    """Least S_F [-]."""
    velocity_limit: Velocity
    """Up to which the curve of K_v holds [m/s]."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_mn with the least S_F", f"{_BEVELS}, eqs 5 and 6")]
    """Mean normal module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_mn with the least S_H", f"{_BEVELS}, eqs 1 and 2")]
    """Mean normal module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("s_t = W_t K_o K_v K_s K_m/(b m_et K_x J), the larger", f"{_BEVELS}, eq. 5")
    ]
    """Bending stress number of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_BEVELS}, eq. 6")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("s_c = C_p √(W_t K_o K_v K_m C_s C_xc/(b d_e1 I))", f"{_BEVELS}, eq. 1")
    ]
    """Contact stress number in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_BEVELS}, eq. 2")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_o K_v", f"{_BEVELS}, clauses 7 and 10")]
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
        rules, making = rating.rules.agma2003, bevel_making_of(rating)

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
        rules, making = mesh.rating.rules.agma2003, bevel_making_of(mesh.rating)
        factors = _rated(mesh.rating, mesh.heaviest, making, mesh.module, mesh.face_width)
        alone = mesh.loads == (mesh.heaviest,)
        every = [factors] if alone else [
            _rated(mesh.rating, load, making, mesh.module, mesh.face_width) for load in mesh.loads
        ]  # fmt: skip
        pitting = _bevel_safety(every, 0, making, contact=True), _bevel_safety(every, 1, making, contact=True)
        bending = _bevel_safety(every, 0, making, contact=False), _bevel_safety(every, 1, making, contact=False)
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
        rating, making = spectrum.rating, bevel_making_of(spectrum.rating)
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
                [damage_part(turns, _bevel_over(one, gear, contact=mode), curve)
                 for one, turns in zip(every, cycles, strict=True)]
                for mode, curve in modes
            )))  # fmt: skip
        return both[0], both[1]

    def life_slope(self, rating: Rating, mode: str, steel: GearLifeRules) -> float:
        """Return 1/e of the stress cycle factor below its corner [-]."""
        return (CONTACT if mode == "pitting" else bevel_making_of(rating).bending_curve).slope

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


def _bevel_over(rated: AgmaBevelRating, gear: int, *, contact: bool) -> float:
    """Return the stress of one gear over its limit at a stress cycle factor of 1 [-]."""
    one, mesh = rated.gears[gear], rated.mesh
    if contact:
        return one.contact_stress * mesh.contact_cycles[gear] / one.contact_limit
    return one.bending_stress * mesh.bending_cycles[gear] / one.bending_limit


def _bevel_safety(every: Sequence[AgmaBevelRating], gear: int, making: AgmaBevelMaking, *, contact: bool) -> float:
    if len(every) == 1:
        one = every[0].gears[gear]
        return one.contact_safety if contact else one.bending_safety
    curve = CONTACT if contact else making.bending_curve
    bins = [StressBin(_bevel_over(rated, gear, contact=contact), rated.mesh.cycles[gear]) for rated in every]
    return spectrum_damage(bins, 1.0, curve).safety
