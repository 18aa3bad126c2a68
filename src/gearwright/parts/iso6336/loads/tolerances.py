"""Flank tolerances of ISO 1328-1:2013, which the load factors of ISO 6336-1 start from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.parts.iso6336.geometry import Value
from gearwright.units import Origin, Quantity

_STEP = np.sqrt(2.0)
_MM, _MICRON = 1e-3, 1e-6


@dataclass(frozen=True)
class FlankTolerances:
    """Tolerances of one gear, unrounded."""

    single_pitch: Annotated[
        Value, Quantity("length"), Origin("f_pT = (0.001 d + 0.4 m_n + 5) √2^(A−5)", "ISO 1328-1:2013")
    ]
    """Single pitch f_pT [m]."""
    profile_form: Annotated[Value, Quantity("length"), Origin("f_fα = (0.55 m_n + 5) √2^(A−5)", "ISO 1328-1:2013")]
    """Profile form f_fαT [m]."""
    profile_slope: Annotated[
        Value, Quantity("length"), Origin("f_Hα = (0.4 m_n + 0.001 d + 4) √2^(A−5)", "ISO 1328-1:2013")
    ]
    """Profile slope f_HαT [m]."""
    helix_slope: Annotated[
        Value, Quantity("length"), Origin("f_Hβ = (0.05 √d + 0.35 √b + 4) √2^(A−5)", "ISO 1328-1:2013")
    ]
    """Helix slope f_HβT [m]."""


def flank_tolerances(diameter: Value, module: Value, face_width: Value, *, grade: Value) -> FlankTolerances:
    """Return the flank tolerances of one gear by its tolerance class.

    Args:
        diameter: Reference diameter d [m].
        module: Normal module m_n [m].
        face_width: Face width b [m].
        grade: Flank tolerance class A, 1 to 11 [-].

    Returns:
        Tolerances before the rounding of the standard.

    Source: ISO 1328-1:2013, clause 5.
    Valid for: 5 ≤ z ≤ 1000, 0.5 mm ≤ m_n ≤ 70 mm, 5 mm ≤ d ≤ 15 m, 4 mm ≤ b ≤ 1.2 m, β ≤ 45°.
    """
    d, m, b = diameter / _MM, module / _MM, face_width / _MM
    scale = _MICRON * _STEP ** (grade - 5.0)
    return FlankTolerances(
        single_pitch=scale * (0.001 * d + 0.4 * m + 5.0),
        profile_form=scale * (0.55 * m + 5.0),
        profile_slope=scale * (0.4 * m + 0.001 * d + 4.0),
        helix_slope=scale * (0.05 * np.sqrt(d) + 0.35 * np.sqrt(b) + 4.0),
    )
