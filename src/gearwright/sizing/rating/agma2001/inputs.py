"""What AGMA 2001 is told of a stage: teeth, steel, accuracy, mounting."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from gearwright.identity import Role
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
    AgmaMaking,
    AgmaSteel,
    AgmaWheel,
    Hardnesses,
    HobbedPair,
    agma_strength,
    allowable_yield,
    rim_factor_agma,
)
from gearwright.parts.gears import ISO53_A
from gearwright.parts.iso6336 import LifeCurve
from gearwright.sizing.rating.rims import RIMMED
from gearwright.sizing.rating.rules import Ask, Rating

_ENCLOSURES = {
    "open": OPEN_GEARING, "commercial": COMMERCIAL, "precision": PRECISION, "extra-precision": EXTRA_PRECISION,
}  # fmt: skip
_BY_HARDNESS = {160.0: BENDING_HB160, 250.0: BENDING_HB250, 400.0: BENDING_HB400}
"""HB -> Y_N of through-hardened steel; the nearest one is taken."""
CROWNED, ADJUSTED = 0.8, 0.8
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
        crowning=CROWNED if rules.crowned else 1.0,
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
