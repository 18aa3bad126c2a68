"""Yielding at momentary overloads by ANSI/AGMA 2001-D04, clause 16.4."""

from __future__ import annotations

from gearwright.parts.agma2001.geometry import BendingGeometry
from gearwright.parts.iso6336 import Value, as_value
from gearwright.units import INCH, POUND_FORCE

_PSI = POUND_FORCE / INCH**2
INDUSTRIAL, CONSERVATIVE = 0.75, 0.50
"""Yield strength factor K_y [-]."""


def allowable_yield(hardness: float) -> float:
    """Return the allowable yield strength number s_ay of a through-hardened steel [Pa].

    Args:
        hardness: HB of the gear, or of the core under a hard case [-].

    Source: ANSI/AGMA 2001-D04, clause 16.4: 482 HB − 32800 psi (AGMA 2101: 3.324 HB − 226 N/mm²).

    >>> round(allowable_yield(300.0) / 1e6)
    771
    """
    return _PSI * (482.0 * hardness - 32800.0)


def overload_distribution(face_width: Value) -> Value:
    """Return the load distribution factor of overloads K_my of straddle-mounted gears [-].

    Args:
        face_width: F [m].

    Source: ANSI/AGMA 2001-D04, clause 16.4: 1.07 + 0.0144 F, in inches.

    >>> round(float(overload_distribution(2.0 * 0.0254)), 4)
    1.0988
    """
    return as_value(1.07 + 0.0144 * face_width / INCH)


def yield_safety(
    force: Value, geometry: BendingGeometry, strength: float, *, face_width: Value, module: Value, factor: float
) -> Value:
    """Return by how much the root of a gear stays below yielding under its largest load [-]; 1 is just enough.

    Args:
        force: W_max [N].
        geometry: J and K_f.
        strength: s_ay [Pa].
        face_width: F [m].
        module: Transverse module m_t [m].
        factor: K_y [-].

    Source: ANSI/AGMA 2001-D04, clause 16.4: s_ay K_y ≥ W_max K_my/(F m_t J K_f).
    """
    stress = force * overload_distribution(face_width) / (face_width * module)
    return as_value(strength * factor * geometry.factor * geometry.stress_correction / stress)
