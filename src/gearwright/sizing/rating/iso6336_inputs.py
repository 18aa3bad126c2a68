"""Inputs to the rating of a stage by ISO 6336, and the ranges of validity of its formulas."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import Angle, Check, PartId, Role, apart, text
from gearwright.catalogue import is_cast_iron, rated_steel
from gearwright.memo import of_latest
from gearwright.parts import Material
from gearwright.parts.agma2001 import reliability_factor
from gearwright.parts.iso6336 import (
    CENTRED,
    CORRECTED_AND_CROWNED,
    CROWNED,
    LIFE_AT_1E10,
    UNMODIFIED,
    Choices,
    Edition,
    GearSteel,
    MeshDuty,
    MeshGeometry,
    MeshQuality,
    MovingBody,
    Neighbour,
    PairRating,
    PinionShaft,
    RatingMethod,
    ReliefRule,
    Steels,
    Value,
    bending_life_curve,
    contact_life_curve,
)
from gearwright.sizing.rating.geometry import body_inside, rim_factors
from gearwright.sizing.rating.protocol import Ask, FarGear, Rating

# ----------------------------------------------------------------------------------------------------------------------
# What ISO 6336 is told of a stage: steel, quality of flanks and roots, and duty.
# ----------------------------------------------------------------------------------------------------------------------


IDLER_MEAN_STRESS = 0.7
"""Y_M of gears that are loaded on both flanks alike [-] (ISO 6336-3:2019, annex B)."""
SQUARE_MM = 1e-6
_SCUFFING = "ISO/TS 6336-20:2017, C_eff"
_PARTS = (*((f"ISO 6336-{part}", f"DIN 3990-{part}:1987") for part in (1, 2, 3)), (_SCUFFING, "DIN 3990-4:1987"))
"""Part of ISO 6336 -> that of DIN 3990 on the same."""
EDITIONS = {"iso6336": Edition.ISO2019, "iso6336-2006": Edition.ISO2006, "din3990": Edition.DIN1987}
"""Name of a method -> edition."""
WITH_OWN_STEEL = (Role.WHEEL, Role.RING)
"""Gears that may be of another steel than the rest of their stage."""
ASKED_RELIABILITY = 0.99
"""Part of the gears that survive σ_lim of ISO 6336-5 [-]."""
HELIX = {"none": UNMODIFIED, "crowning": CROWNED, "corrected": CORRECTED_AND_CROWNED}
"""Helix modification -> what it leaves of misalignment."""


def steel_of(rating: Rating, role: Role = Role.PINION) -> GearSteel:
    """Return the steel of a gear as ISO 6336 rates it.

    Args:
        rating: Resolved rules.
        role: Of the gear; wheels and rings may be of a steel of their own.

    Raises:
        DesignError: Unknown class or grade, or a hardness outside the grade's range.
    """
    known = _steels(rating)
    if role not in known:
        known[role] = _steel(rating, role)
    return known[role]


@of_latest(256)
def _steels(rating: Rating) -> dict[Role, GearSteel]:
    """Role -> steel of a gear, of those that were asked for."""
    return {}


def _steel(rating: Rating, role: Role) -> GearSteel:
    rules = rating.rules.iso6336
    if rules.wheel is None or role not in WITH_OWN_STEEL:
        steel = rated_steel(rating.material, rules.steel, rules.grade, hardness=rules.hardness_hv)
    else:
        own = rules.wheel
        steel = rated_steel(rating.material, own.steel, own.grade, hardness=own.hardness_hv, base=rules.steel)
        steel = replace(steel, yield_strength=own.yield_strength or _proof_of(rating.material, steel))
    return _surviving(_lasting(steel, rating), rules.reliability)


def _proof_of(material: Material, own: GearSteel) -> float | None:
    """Return R_p0.2 of a material for a gear of another class; that of a steel is none of an iron's [Pa]."""
    return None if own.treatment.is_cast_iron and not is_cast_iron(material.steel) else material.yield_strength


def steels_of(rating: Rating, roles: tuple[Role, Role]) -> Steels:
    """Return the steels of both gears of a mesh.

    Args:
        rating: Resolved rules.
        roles: What both gears are in their stage.

    Raises:
        DesignError: Unknown class or grade, or a hardness outside the grade's range.
    """
    return steel_of(rating, roles[0]), steel_of(rating, roles[1])


def _lasting(steel: GearSteel, rating: Rating) -> GearSteel:
    """Return a steel with the S-N curves asked for: DIN 3990 has no fall beyond the knee; its own curves stay."""
    rules = rating.rules.iso6336
    end = 1.0 if EDITIONS.get(rating.method) is Edition.DIN1987 else rules.life_factor_1e10
    if end == LIFE_AT_1E10 and not rules.some_pitting:
        return steel
    flank = contact_life_curve(steel.treatment, some_pitting=rules.some_pitting, at_1e10=end)
    root = bending_life_curve(steel.treatment, at_1e10=end)
    return replace(steel, contact_life=steel.contact_life or flank, bending_life=steel.bending_life or root)


def _surviving(steel: GearSteel, reliability: float) -> GearSteel:
    """Return a steel with the strengths that another part of the gears survives, by the table of AGMA 2001."""
    if reliability == ASKED_RELIABILITY:
        return steel
    factor = float(reliability_factor(reliability))
    return replace(
        steel,
        contact_strength=steel.contact_strength / factor,
        bending_strength=steel.bending_strength / factor,
        survival=factor,
        source=f"{steel.source or 'ISO 6336-5:2016, table 1'}; over K_R = {factor:.4g}, AGMA 2001-D04, table 11",
    )


def clause_of(source: str, edition: Edition) -> str:
    """Return the source of a quantity in the words of an edition; of DIN 3990 its part.

    Args:
        source: With the edition of 2019.
        edition: That rates.
    """
    if edition is Edition.ISO2006:
        return source.replace(":2019", ":2006").replace(_SCUFFING, "ISO/TR 13989-1:2000, C_eff")
    if edition is Edition.DIN1987:
        return next((own for part, own in _PARTS if part in source), source)
    return source


def mean_stress_factor(reverse: float) -> float:
    """Return Y_M of a gear that is loaded on both flanks [-].

    Args:
        reverse: Load of the less loaded flank over that of the other, 0 to 1 [-].

    Source: ISO 6336-3:2019, annex B, 1/Y_M = 1 - R (1 - M)/(1 + M) with R = -1.2 times that part (the root is bent back
        by more than its own flank's load), and the M that makes it 0.7 where both flanks are loaded alike, 0.47: what
        case-hardened steel has, 0.8 - 0.15 Y_S, at Y_S = 2.2; the equation from memory.

    >>> round(mean_stress_factor(0.5), 3)  # 7/(7 + 3/2)
    0.824
    """
    return IDLER_MEAN_STRESS / (IDLER_MEAN_STRESS + (1.0 - IDLER_MEAN_STRESS) * reverse)


def quality_of(
    rating: Rating,
    *,
    idlers: tuple[bool, bool],
    reverse: tuple[float, float] = (1.0, 1.0),
    shaft: PinionShaft = CENTRED,
    rims: tuple[float, float] = (1.0, 1.0),
) -> MeshQuality:
    """Return how the flanks of a stage are made and mounted.

    Args:
        rating: Resolved rules.
        idlers: Which of the two gears is loaded on both flanks.
        reverse: Load of the less loaded flank over that of the other, of gears that are [-].
        shaft: Where the pinion sits on its shaft.
        rims: Y_B of both gears [-].
    """
    return replace(_flanks(rating), shaft=shaft, rims=rims, mean_stresses=_mean_stresses(idlers, reverse))


def _mean_stresses(idlers: tuple[bool, bool], reverse: tuple[float, float]) -> tuple[float, float]:
    """Y_M of both gears."""
    first, second = (mean_stress_factor(part) if idler else 1.0 for idler, part in zip(idlers, reverse, strict=True))
    return first, second


@of_latest(256)
def _flanks(rating: Rating) -> MeshQuality:
    """Return what all meshes of a stage have in common."""
    rules = rating.rules.iso6336
    return MeshQuality(
        grade=rules.tolerance_class,
        flank_roughness=rules.flank_roughness,
        root_roughness=rules.root_roughness,
        tip_relief=rules.tip_relief,
        relief_rule=ReliefRule(rules.tip_relief_for),
        relief_tolerance=rules.tip_relief_tolerance,
        blank=rules.blank_factor,
        helix=HELIX[rules.helix_modification],
        viscosity=rules.oil_viscosity * SQUARE_MM,
        choices=Choices(
            RatingMethod(rules.dynamic_method),
            RatingMethod(rules.root_method),
            rules.least_dynamic_factor,
        ),
    )


def mesh_quality(rating: Rating, ask: Ask, module: Value) -> MeshQuality:
    """Return how the flanks and bodies of a mesh are made: rims, bores, and relief and class once they are sized.

    Args:
        rating: Resolved rules.
        ask: Teeth and kind of the mesh.
        module: m_n [m].
    """
    bodies = tuple(
        _body(rating, ask.roles[gear], ask.teeth[gear], module, bore=ask.bores[gear], held=ask.held[gear],
              internal=ask.internal and gear == 1)
        for gear in (0, 1)
    )  # fmt: skip
    beyond = tuple(None if far is None else _neighbour(rating, far, module) for far in ask.beyond)
    planet = ask.roles.index(Role.PLANET) if Role.PLANET in ask.roles else None
    made: dict[str, Any] = {}
    if ask.made is not None:
        made = {
            "tip_relief": ask.made.relief, "relief_tolerance": ask.made.tolerance or None, "grade": ask.made.grade
        }  # fmt: skip
    return replace(
        _flanks(rating),
        rims=rim_factors(rating, ask.roles, internal=ask.internal),
        mean_stresses=_mean_stresses(ask.idlers, ask.reverse),
        bodies=(bodies[0], bodies[1]),
        beyond=(beyond[0], beyond[1]),
        planet=planet,
        **made,
    )


def _body(
    rating: Rating, role: Role, teeth: Value, module: Value, *, bore: float | None, held: bool, internal: bool
) -> MovingBody:
    inside = body_inside(rating, role, teeth, module, internal=internal) if bore is None else bore
    return MovingBody(inside, held=held)


def _neighbour(rating: Rating, far: FarGear, module: Value) -> Neighbour:
    """Return the gear beyond an idler, of the steel and the rules of the mesh."""
    body = _body(
        rating, far.role, abs(far.teeth), module, bore=far.bore, held=far.held, internal=far.teeth < 0
    )  # fmt: skip
    return Neighbour(far.teeth, steel_of(rating, far.role).density, replace(body, meshes=far.meshes))


def duty_of(rating: Rating, torque: ArrayLike, speed: ArrayLike, *, life: ArrayLike, ask: Ask) -> MeshDuty:
    """Return what a cylindrical mesh carries.

    Args:
        rating: Resolved rules.
        torque: On the first gear, of one mesh, load factor included [N m].
        speed: Of the first gear against the carrier [rad/s].
        life: Time under that load [s].
        ask: Mates that a tooth of each gear meets in a turn, the load for which tips are relieved, the greatest speed.
    """
    relieved = np.asarray(ask.relieved, dtype=float) * np.asarray(ask.teeth[0], dtype=float)
    fastest = np.asarray(ask.fastest, dtype=float)
    return MeshDuty(
        np.asarray(torque, dtype=float) / rating.load_factor,
        np.asarray(speed, dtype=float),
        np.asarray(life, dtype=float),
        application_factor=rating.service.application_factor,
        mesh_load_factor=rating.load_factor,
        meshes_per_turn=ask.passes,
        relief_torque=relieved / rating.load_factor if (relieved > 0.0).all() else None,
        fastest=fastest if (fastest > 0.0).all() else None,
    )


# ----------------------------------------------------------------------------------------------------------------------
# Ranges in which the formulas of ISO 6336 hold, and what of a mesh lies beyond: it is rated, and said.
# ----------------------------------------------------------------------------------------------------------------------


_SCOPE, _ROOT = "ISO 6336-1:2019, clause 1", "ISO 6336-3:2019, clause 7"
_CLASSES, _STIFFNESS = "ISO 1328-1:2013, clause 1", "ISO 6336-1:2019, clause 9"
_STEEPEST: Angle = np.radians(30.0)
"""Helix angle as which a larger one counts in Y_β [rad] (ISO 6336-3:2019, clause 8)."""

_STEEPEST_RATIO = 200.0
"""Of 1000 teeth over 5 [-] (ISO 1328-1:2013, clause 1)."""


@dataclass(frozen=True)
class Beyond:
    """A quantity of a mesh that lies beyond the range of a formula."""

    quantity: str
    """With its symbol."""
    dimension: str
    value: float
    """As it is [SI]."""
    least: float
    """Where the range begins [SI]."""
    most: float
    """Where it ends [SI]."""
    clause: str
    """That says so."""


def beyond_ranges(mesh: MeshGeometry, rated: PairRating, *, films: bool = False) -> tuple[Beyond, ...]:
    """Return what of a mesh lies beyond the ranges of the formulas that rate it.

    Args:
        mesh: One mesh.
        rated: Its factors.
        films: Whether its oil film is rated, too.

    Source: ISO 6336-1:2019, clauses 1 and 9 (ε_α, x_1 + x_2), ISO 6336-3:2019, clauses 7 and 8 (q_s, β), ISO
        1328-1:2013, clause 1 (z, d, m_n, b), ISO/TS 6336-22 (external pairs, ε_α).
    """
    ranges = [*_ranges(mesh, rated), *(_of_films(mesh) if films else ())]
    return tuple(entry for entry in ranges if not entry.least <= entry.value <= entry.most)


def _ranges(mesh: MeshGeometry, rated: PairRating) -> Iterator[Beyond]:
    yield _range("ε_α", "ratio", mesh.transverse_contact_ratio, (1.0, 2.5), _SCOPE)
    yield _range("β", "angle", mesh.helix_angle, (0.0, float(_STEEPEST)), "ISO 6336-3:2019, clause 8 (Y_β)")
    yield _range("m_n", "length", mesh.module, (0.5e-3, 70e-3), _CLASSES)
    yield _range("b", "length", mesh.face_width, (4e-3, 1.2), _CLASSES)
    for gear in (0, 1):
        yield _range(f"z_{gear + 1}", "number", abs(float(mesh.teeth[gear])), (5.0, 1000.0), _CLASSES)
        yield _range(f"d_{gear + 1}", "length", mesh.pitch_diameters[gear], (5e-3, 15.0), _CLASSES)
        yield _range(f"q_s{gear + 1}", "ratio", rated.bending[gear].section.notch, (1.0, 8.0), _ROOT)
    if mesh.side > 0:
        shifts = sum(float(proportion.profile_shift) for proportion in mesh.proportions)
        yield _range("x_1 + x_2", "ratio", shifts, (-0.5, 2.0), _STIFFNESS)


def _of_films(mesh: MeshGeometry) -> Iterator[Beyond]:
    yield _range("u of the oil film", "ratio", mesh.ratio, (0.0, _STEEPEST_RATIO), "ISO/TS 6336-22: external pairs")
    yield _range("ε_α of the oil film", "ratio", mesh.transverse_contact_ratio, (1.0, 2.0), "ISO/TS 6336-22, method B")


def _range(quantity: str, dimension: str, value: object, span: tuple[float, float], clause: str) -> Beyond:
    return Beyond(quantity, dimension, float(np.asarray(value)), *span, clause)


def range_checks(beyond: tuple[Beyond, ...], mesh: PartId) -> Iterator[Check]:
    """Yield what lies beyond the range of a formula, as not assessed: nothing says what the formula is worth there.

    Args:
        beyond: Of the mesh.
        mesh: The mesh.
    """
    for entry in beyond:
        below = entry.value < entry.least
        value, bound = apart(entry.value, entry.least if below else entry.most, entry.dimension)
        other = text(entry.most if below else entry.least, entry.dimension)
        least, most = (bound, other) if below else (other, bound)
        words = f"{value}; the formulas hold from {least} to {most}, and the safeties are extrapolated"
        yield Check(mesh, f"range of {entry.quantity}", entry.clause, None, None, why=words)
