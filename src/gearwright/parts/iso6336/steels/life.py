"""Life factors Z_NT and Y_NT: the S-N curves of ISO 6336-2 and -3 by group of material, and their inverse.

One rule for every standard of gears: below the first corner a curve is flat, the static limit; its last line goes on,
beyond 1e10 cycles too, so that damage and life factor say the same. A load is borne without end only where that line is
flat, as with a life factor of 1 at 1e10 cycles and in DIN 3990.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from gearwright.parts.iso6336.geometry import Value, as_value
from gearwright.parts.iso6336.steels.strength import GearSteel, LifeCurve, Treatment

LIFE_AT_1E10 = 0.85
"""Life factor at 1e10 cycles otherwise [-]."""
ENDLESS = 600.0
"""Natural logarithm of a number of cycles that counts as endless [-]: 1e260."""


def _contact_corners(treatment: Treatment, *, some_pitting: bool) -> LifeCurve:
    """Corners of Z_NT up to the reference, ISO 6336-2:2019, table 2."""
    if treatment is Treatment.NITROCARBURISED:
        return LifeCurve((1e5, 2e6), (1.1, 1.0))
    if treatment.is_nitrided or treatment.is_brittle_iron:
        return LifeCurve((1e5, 2e6), (1.3, 1.0))
    if some_pitting:
        return LifeCurve((6e5, 1e7, 1e9), (1.6, 1.3, 1.0))
    return LifeCurve((1e5, 5e7), (1.6, 1.0))


@cache
def contact_life_curve(treatment: Treatment, *, some_pitting: bool = False, at_1e10: float = LIFE_AT_1E10) -> LifeCurve:
    """Return the S-N curve of the flank.

    Args:
        treatment: Material group.
        some_pitting: A little pitting may be left on the flanks, which moves the corner from 5e7 to 1e9 cycles.
        at_1e10: Z_NT at 1e10 cycles, 0.85 to 1 [-].

    Source: ISO 6336-2:2019, clause 11, table 2.
    """
    corners = _contact_corners(treatment, some_pitting=some_pitting)
    return LifeCurve((*corners.cycles, 1e10), (*corners.factors, at_1e10))


@cache
def bending_life_curve(treatment: Treatment, *, at_1e10: float = LIFE_AT_1E10) -> LifeCurve:
    """Return the S-N curve of the tooth root.

    Args:
        treatment: Material group.
        at_1e10: Y_NT at 1e10 cycles, 0.85 to 1 [-].

    Source: ISO 6336-3:2019, clause 11, table 1.
    """
    first_corner, greatest = {
        Treatment.STRUCTURAL: (1e4, 2.5),
        Treatment.THROUGH_HARDENED: (1e4, 2.5),
        Treatment.CASE_HARDENED: (1e3, 2.5),
        Treatment.INDUCTION_HARDENED: (1e3, 2.5),
        Treatment.NITRIDED: (1e3, 1.6),
        Treatment.NITRIDED_THROUGH_HARDENED: (1e3, 1.6),
        Treatment.NITROCARBURISED: (1e3, 1.1),
        Treatment.MALLEABLE_IRON: (1e4, 2.5),
        Treatment.NODULAR_IRON: (1e4, 2.5),
        Treatment.FERRITIC_NODULAR_IRON: (1e3, 1.6),
        Treatment.GREY_IRON: (1e3, 1.6),
    }[treatment]
    return LifeCurve((first_corner, 3e6, 1e10), (greatest, 1.0, at_1e10))


def life_curves(steel: GearSteel) -> tuple[LifeCurve, LifeCurve]:
    """Return the S-N curves of flank and root: the steel's own, or those of its treatment.

    Args:
        steel: Of the gear.

    Source: ISO 6336-2:2019, table 2; ISO 6336-3:2019, table 1; or the steel's own.
    """
    contact = contact_life_curve(steel.treatment) if steel.contact_life is None else steel.contact_life
    return contact, bending_life_curve(steel.treatment) if steel.bending_life is None else steel.bending_life


def knee_curve(knee: float, exponent: float, *, greatest: float, at_1e10: float = LIFE_AT_1E10) -> LifeCurve:
    """Return the S-N curve of a line that is stated by its knee and slope.

    Args:
        knee: Cycles at which the life factor is 1 [-].
        exponent: p of N ~ σ^(−p) below the knee [-].
        greatest: Static life factor [-].
        at_1e10: Life factor at 1e10 cycles [-].

    Source: ISO 6336-6:2019, clause 5: lines in double logarithmic scale.

    >>> round(knee_curve(5e7, 13.222, greatest=1.6).cycles[0], -3)
    100000.0
    """
    return LifeCurve((knee * greatest**-exponent, knee, 1e10), (greatest, 1.0, at_1e10))


def life_factor(curve: LifeCurve, cycles: Value) -> Value:
    """Return Z_NT or Y_NT at a number of load cycles.

    Args:
        curve: S-N curve.
        cycles: N_L [-].

    Returns:
        Life factor [-]; the static value below the first corner, that of the last line, prolonged, beyond the last.

    Source: ISO 6336-2:2019, clause 11; ISO 6336-3:2019, clause 11; beyond 1e10 cycles, where their tables end, the
        slope with which damage is summed (ISO 6336-6:2019, clause 5).

    >>> round(float(life_factor(contact_life_curve(Treatment.CASE_HARDENED), 1.08e9)), 3)
    0.91
    """
    logarithm, ends = np.log(np.maximum(cycles, curve.cycles[0])), np.log(curve.cycles)
    beyond = np.maximum(logarithm - ends[-1], 0.0)
    return as_value(np.exp(np.interp(logarithm, ends, np.log(curve.factors)) - curve.fall * beyond))


def endurable_cycles(curve: LifeCurve, factor: float) -> float:
    """Return the most cycles whose life factor is not below one, the inverse of `life_factor`.

    Args:
        curve: S-N curve.
        factor: Life factor that the stress asks for [-].

    Returns:
        N [-]; 0 above the static value; ∞ where the curve ends flat and the stress is not above its end.

    Source: ISO 6336-6:2019, clause 5.
    """
    if factor > curve.factors[0]:
        return 0.0
    for start, greatest, least, longer, weaker in curve.lines:
        if factor > least:
            exponent = longer * math.log(greatest / factor) / weaker
            return start * math.exp(exponent) if exponent < ENDLESS else math.inf
    return math.inf
