"""How a shoulder of a shaft raises stress, or an undercut at its foot, and what of it the material feels."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.units import INCH, POUND_FORCE

LEAST_RADIUS = 0.03
"""Fillet radius over height of the step from which on the formulas hold [-] (DIN 743-2:2012)."""
_MM = 1e3
_MPA = 1e6
_KSI = 1000.0 * POUND_FORCE / INCH**2
"""One ksi in Pa."""


class Concentration(NamedTuple):
    """Factors on the nominal stresses of the smaller section."""

    bending: float
    """[-]"""
    torsion: float
    """[-]"""


class Shoulder(NamedTuple):
    """A step between two diameters with a fillet."""

    diameter: float
    """Smaller diameter d [m]."""
    larger: float
    """D [m]."""
    radius: float
    """Of the fillet r [m]."""
    undercut: float = 0.0
    """Depth t of an undercut at its foot, whose bottom then is the smaller diameter [m]; the step of a plain groove."""


def _check_shoulder(shoulder: Shoulder) -> None:
    """Refuse diameters in the wrong order and a fillet that is too sharp."""
    step = (shoulder.larger - shoulder.diameter) / 2.0
    if step <= 0.0:
        message = f"{1e3 * shoulder.larger:g} mm is not above the smaller diameter, {1e3 * shoulder.diameter:g} mm"
        raise DesignError([Problem("shoulder.larger", message)])
    if not 0.0 <= shoulder.undercut <= (1.0 + 1e-9) * step:
        message = f"{1e3 * shoulder.undercut:g} mm given; it is no deeper than the step, {1e3 * step:.3g} mm"
        raise DesignError([Problem("shoulder.undercut", message)])
    if shoulder.radius < LEAST_RADIUS * step:
        smallest = 1e3 * LEAST_RADIUS * step
        message = f"{1e3 * shoulder.radius:g} mm given; the formulas hold from {smallest:.3g} mm on, 0.03 of the step"
        raise DesignError([Problem("shoulder.radius", message)])


def stress_concentration(shoulder: Shoulder) -> Concentration:
    """Return the stress concentration α of a shoulder [-].

    Args:
        shoulder: [m].

    Source: DIN 743-2:2012: 1 + 1/√(A r/t + 2 B r/d (1 + 2 r/d)² + C (r/t)^z d/D), bending A = 0.62, B = 5.8,
        C = 0.2, z = 3; torsion A = 3.4, B = 19, C = 1, z = 2; of a round groove, bending A = 0.2, B = 2.75, torsion
        A = 0.7, B = 10.3, C = 0, as two public programs have them alike (GitHub: hanslhansl/din743,
        sydgtfzguhgfhtr/ME_Wellennachweis). With an undercut of bottom d in a shaft of d_1, 5.2.2 of the standard:
        (α_R − α_A) √((d_1 − d)/(D − d)) + α_A, of the shoulder and of a groove of the same d in D. This equation is
        from memory; what finite elements say of it is told in docs/theory/shafts-in-bearings.md.

    Valid for: r/t ≥ 0.03, d/D ≤ 0.98.

    Raises:
        DesignError: If the shoulder cannot be made.
    """
    _check_shoulder(shoulder)
    bending = _alpha(shoulder, (0.62, 5.8, 0.2), 3.0), (0.2, 2.75, 0.0)
    torsion = _alpha(shoulder, (3.4, 19.0, 1.0), 2.0), (0.7, 10.3, 0.0)
    return Concentration(*(_undercut(shoulder, plain, groove) for plain, groove in (bending, torsion)))


def _undercut(shoulder: Shoulder, plain: float, groove: tuple[float, float, float]) -> float:
    """Return α between that of the shoulder, d_1 = d, and that of the groove that it ends as where d_1 = D."""
    if not shoulder.undercut:
        return plain
    share = math.sqrt(2.0 * shoulder.undercut / (shoulder.larger - shoulder.diameter))
    return plain + share * (_alpha(shoulder, groove, 1.0) - plain)


def _alpha(shoulder: Shoulder, shape: tuple[float, float, float], exponent: float) -> float:
    first, second, third = shape
    over_step = 2.0 * shoulder.radius / (shoulder.larger - shoulder.diameter)
    over_shaft = shoulder.radius / shoulder.diameter
    wall = third * math.pow(over_step, exponent) * shoulder.diameter / shoulder.larger
    return 1.0 + 1.0 / math.sqrt(first * over_step + 2.0 * second * over_shaft * (1.0 + 2.0 * over_shaft) ** 2 + wall)


def fatigue_notch_factor(shoulder: Shoulder, yield_strength: float) -> Concentration:
    """Return the fatigue notch factor β of a shoulder by the stress gradient [-].

    Args:
        shoulder: [m].
        yield_strength: σ_S of the real section [Pa].

    Source: DIN 743-2:2012: β = α/n, n = 1 + √(G′ mm) 10^−(0.33 + σ_S/712 MPa); G′ = 2.3 (1 + φ)/r in bending and
        1.15/r in torsion, φ = 1/(4 √(t/r) + 2) for d/D > 0.67, else 0. Those of an undercut are assumed to be those of
        a groove, 2 (1 + φ)/r and 1/r, which support it less.

    Raises:
        DesignError: If the shoulder cannot be made.
    """
    alpha = stress_concentration(shoulder)
    step = (shoulder.larger - shoulder.diameter) / 2.0
    slender = shoulder.diameter / shoulder.larger > 0.67
    phi = 1.0 / (4.0 * math.sqrt(step / shoulder.radius) + 2.0) if slender else 0.0
    support = math.pow(10.0, -(0.33 + yield_strength / _MPA / 712.0))
    gradients = (2.0 * (1.0 + phi), 1.0) if shoulder.undercut else (2.3 * (1.0 + phi), 1.15)
    factors = (1.0 + math.sqrt(gradient / (shoulder.radius * _MM)) * support for gradient in gradients)
    return Concentration(*(peak / factor for peak, factor in zip(alpha, factors, strict=True)))


def notch_sensitivity(radius: float, ultimate_strength: float) -> Concentration:
    """Return Neuber's notch sensitivity q of steel [-].

    Args:
        radius: Of the notch r [m].
        ultimate_strength: S_ut, 50 to 250 ksi [Pa].

    Source: Budynas & Nisbett, Shigley's Mechanical Engineering Design, eqs (6-34) and (6-35), S_ut in ksi, r in in:
        q = 1/(1 + √a/√r).

    >>> q = notch_sensitivity(3e-3, 690e6)
    >>> round(q.bending, 2), round(q.torsion, 2)
    (0.85, 0.88)
    """
    ksi = ultimate_strength / _KSI
    bending = 0.246 - 3.08e-3 * ksi + 1.51e-5 * ksi**2 - 2.67e-8 * ksi**3
    torsion = 0.190 - 2.51e-3 * ksi + 1.35e-5 * ksi**2 - 2.67e-8 * ksi**3
    root = math.sqrt(radius / INCH)
    return Concentration(1.0 / (1.0 + bending / root), 1.0 / (1.0 + torsion / root))


def felt_concentration(concentration: Concentration, sensitivity: Concentration) -> Concentration:
    """Return the fatigue stress concentration K_f = 1 + q (K_t − 1) [-].

    Args:
        concentration: K_t [-].
        sensitivity: q [-].

    Source: Budynas & Nisbett, Shigley's Mechanical Engineering Design, eq. (6-32).
    """
    return Concentration(*(1.0 + q * (k - 1.0) for k, q in zip(concentration, sensitivity, strict=True)))
