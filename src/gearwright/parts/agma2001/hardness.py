"""Hardness ratio factor C_H of ANSI/AGMA 2001-D04: a harder pinion works the flanks of its gear."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.parts.agma2001.factors import hardness_ratio_factor
from gearwright.parts.iso6336 import Value, as_value
from gearwright.units import INCH

_MICROINCH = 1e-6 * INCH
SOFTEST, HARDEST = 180.0, 400.0
"""Brinell hardness of gears that a surface-hardened pinion works [-]."""


@dataclass(frozen=True)
class Hardnesses:
    """Of two different steels of a mesh."""

    pinion: float
    """HB of a through-hardened pinion [-]."""
    wheel: float
    """HB of the gear [-]."""
    hard_pinion: bool = False
    """The pinion is surface-hardened, 48 HRC or more."""
    hard_wheel: bool = False
    """The gear is surface-hardened, too: nothing works it."""
    roughness: float = 0.0
    """R_a of the pinion's flanks [m]; a surface-hardened pinion works the gear the more the smoother it is."""


def hardened_pinion_factor(wheel: float, roughness: float) -> float:
    """Return C_H of a through-hardened gear against a surface-hardened pinion.

    Args:
        wheel: HB of the gear [-].
        roughness: R_a of the pinion's flanks [m].

    Source: AGMA 2001-D04, clause 14.2, as Shigley 9th ed., eq. 14-37: 1 + 0.00075 e^(−0.0112 f_p) (450 − HB), f_p in
        microinches.
    Valid for: 180 to 400 HB.

    >>> round(hardened_pinion_factor(300.0, 16e-6 * 0.0254), 3)  # 1 + 0.00075 e^-0.1792 150
    1.094
    """
    hardness = min(max(wheel, SOFTEST), HARDEST)
    return 1.0 + 0.00075 * float(np.exp(-0.0112 * roughness / _MICROINCH)) * (450.0 - hardness)


def hardness_ratio_of(hardnesses: Hardnesses | None, ratio: Value) -> Value:
    """Return C_H of the gear of a mesh [-]; 1 where both gears are of one steel.

    Args:
        hardnesses: Of both gears; None: of one steel.
        ratio: m_G = N_G/N_P [-].

    Source: AGMA 2001-D04, clauses 14.1 and 14.2.
    """
    if hardnesses is None or hardnesses.hard_wheel:
        return 1.0
    if hardnesses.hard_pinion:
        return hardened_pinion_factor(hardnesses.wheel, hardnesses.roughness)
    slope = hardness_ratio_factor(hardnesses.pinion, hardnesses.wheel, 2.0) - 1.0
    return as_value(1.0 + slope * (np.asarray(ratio) - 1.0))
