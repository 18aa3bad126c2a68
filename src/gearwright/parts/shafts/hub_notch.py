"""How what sits on a shaft notches it: keyways, press fits and splines, measured and not computed from their shape."""

from __future__ import annotations

import math

from gearwright.parts.shafts.notch import Concentration, felt_concentration, notch_sensitivity

_MPA = 1e6
_MM = 1e3
_REFERENCE = 40.0
"""Diameter of the shafts that were tested d_BK [mm] (DIN 743-2:2012)."""
KEYSEAT = Concentration(2.14, 3.0)
"""K_t and K_ts of an end-milled keyseat with r/d = 0.02 (Shigley, table 7-1) [-]."""
KEYSEAT_RADIUS = 0.02
"""Its radius over the shaft's diameter [-]."""

GROOVE = Concentration(5.0, 3.0)
"""K_t and K_ts of the groove of a retaining ring (Shigley, table 7-1) [-]."""


def groove_concentration(radius: float, ultimate_strength: float) -> Concentration:
    """Return K_f and K_fs of a sharp groove around a shaft: of a retaining ring, or of a thread [-].

    Args:
        radius: At its bottom [m].
        ultimate_strength: S_ut [Pa].

    Source: Budynas & Nisbett, Shigley's Mechanical Engineering Design, table 7-1 and eq. (6-32).

    >>> groove = groove_concentration(0.15e-3, 1000e6)
    >>> round(groove.bending, 2), round(groove.torsion, 2)
    (3.74, 2.46)
    """
    return felt_concentration(GROOVE, notch_sensitivity(radius, ultimate_strength))


def keyseat_concentration(diameter: float, ultimate_strength: float) -> Concentration:
    """Return K_f and K_fs of an end-milled keyseat [-].

    Args:
        diameter: d of the shaft [m].
        ultimate_strength: S_ut [Pa].

    Source: Budynas & Nisbett, Shigley's Mechanical Engineering Design, table 7-1 (r/d = 0.02) and eq. (6-32).
    """
    return felt_concentration(KEYSEAT, notch_sensitivity(KEYSEAT_RADIUS * diameter, ultimate_strength))


def keyway_factor(diameter: float, ultimate_strength: float) -> Concentration:
    """Return the fatigue notch factors β_σ and β_τ of a shaft with one key [-].

    Args:
        diameter: d of the shaft [m].
        ultimate_strength: σ_B of the section [Pa].

    Source: DIN 743-2:2012, table 1: β_σ = 3 (σ_B/1000 MPa)^0.38, β_τ = 0.56 β_σ + 0.1 at 40 mm.
    """
    bending = 3.0 * math.pow(ultimate_strength / _MPA / 1e3, 0.38)
    return _of_size(Concentration(bending, 0.56 * bending + 0.1), diameter)


def press_fit_factor(diameter: float, ultimate_strength: float) -> Concentration:
    """Return the fatigue notch factors β_σ and β_τ at the edge of a press fit [-].

    Args:
        diameter: d of the shaft [m].
        ultimate_strength: σ_B of the section [Pa].

    Source: DIN 743-2:2012, table 1: β_σ = 2.7 (σ_B/1000 MPa)^0.43, β_τ = 0.65 β_σ at 40 mm.
    """
    bending = 2.7 * math.pow(ultimate_strength / _MPA / 1e3, 0.43)
    return _of_size(Concentration(bending, 0.65 * bending), diameter)


def spline_factor(diameter: float, ultimate_strength: float) -> Concentration:
    """Return the fatigue notch factors β_σ and β_τ of a shaft with an involute spline, on its root circle [-].

    Args:
        diameter: d of the root circle [m].
        ultimate_strength: σ_B of the section [Pa].

    Source: DIN 743-2:2012, 4.2: β_τ = exp(4.2e-7 (σ_B/MPa)²), β_σ = 1 + 0.49 (β_τ − 1).
    """
    torsion = math.exp(4.2e-7 * (ultimate_strength / _MPA) ** 2)
    return _of_size(Concentration(1.0 + 0.49 * (torsion - 1.0), torsion), diameter)


def _of_size(tested: Concentration, diameter: float) -> Concentration:
    """Return measured factors at another diameter: times K_3(d_BK)/K_3(d)."""
    return Concentration(*(factor * _size(factor, _REFERENCE) / _size(factor, diameter * _MM) for factor in tested))


def _size(factor: float, diameter: float) -> float:
    """Return K_3 = 1 − 0.2 lg β lg(d/7.5 mm)/lg 20 of a diameter in mm."""
    bounded = min(max(diameter, 7.5), 150.0)
    return 1.0 - 0.2 * math.log10(factor) * math.log10(bounded / 7.5) / math.log10(20.0)
