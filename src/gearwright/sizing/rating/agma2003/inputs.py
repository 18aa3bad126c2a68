"""What AGMA 2003 is told of a bevel stage: duty, steel, accuracy, mounting."""

from __future__ import annotations

import math

import numpy as np

from gearwright.parts.agma2003 import (
    CROWNED,
    ONE_STRADDLE,
    OVERHUNG,
    STRADDLE,
    UNCROWNED,
    AgmaBevelDuty,
    AgmaBevelMaking,
    BevelEdition,
    BevelSteel,
    bevel_strength,
)
from gearwright.sizing.rating.rules import Ask, Rating

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
