"""Factors of ANSI/AGMA 2003: sizes, load distribution, lengthwise curvature, temperature, cycles, steels; SI outside.

The dynamic, reliability and hardness ratio factors are those of `agma2001`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Annotated

from gearwright.errors import DesignError, Problem, refuse
from gearwright.parts.agma2001 import stress_cycle_curve
from gearwright.parts.agma2003.section import SOURCE
from gearwright.parts.iso6336 import LifeCurve
from gearwright.units import INCH, POUND_FORCE, Origin, Quantity

_MM = 1e-3
_PSI = POUND_FORCE / INCH**2
STRADDLE, ONE_STRADDLE, OVERHUNG = 1.00, 1.10, 1.25
"""Load distribution modifier K_mb of both, one or no member between bearings [-] (figure 4)."""
CROWNED, UNCROWNED = 1.5, 2.0
"""Crowning factor C_xc of properly crowned teeth and the least one of others [-] (clause 13)."""
WIDEST = 356 * _MM
"""Face width up to which K_m is given [m] (eq. 20)."""
REVERSED = 0.70
"""Part of s_at of teeth that are loaded on both flanks [-] (clause 21)."""
GREATEST_CONTACT, GREATEST_BENDING = 2.0, 2.7
"""C_L up to 1e4 and K_L up to 1e3 cycles [-] (figures 5 and 6)."""
_CONTACT, _BENDING = (3.4822, 0.0602), (6.1514, 0.1192)


def _reached(greatest: float, line: tuple[float, float]) -> float:
    """Return the cycles at which a line c N^−e comes down to the greatest factor [-]."""
    return math.exp(math.log(line[0] / greatest) / line[1])


CONTACT = LifeCurve(
    (_reached(GREATEST_CONTACT, _CONTACT), 1e10), (GREATEST_CONTACT, _CONTACT[0] * 1e10 ** -_CONTACT[1])
)
"""C_L of case-hardened steel (figure 5)."""
BENDING = stress_cycle_curve(_reached(GREATEST_BENDING, _BENDING), _BENDING, (1.3558, 0.0178))
"""K_L of case-hardened steel in general use, the upper edge of the band (figure 6)."""
BENDING_CRITICAL = stress_cycle_curve(_reached(GREATEST_BENDING, _BENDING), _BENDING, (1.6831, 0.0323))
"""K_L in critical service, the lower edge of the band (figure 6)."""


class BevelEdition(Enum):
    """Whose size factor C_s, by the face width from which it stays what it is [m]."""

    B97 = 114.3 * _MM
    """ANSI/AGMA 2003-B97 as Shigley prints it: 1 from 4.5 in."""
    D19 = 79.8 * _MM
    """ANSI/AGMA 2003-D19: 0.83 from 79.8 mm."""


def size_factor_contact(face_width: float, edition: BevelEdition = BevelEdition.D19) -> float:
    """Return the size factor for pitting C_s [-].

    Args:
        face_width: b [m].
        edition: Which says where it ends.

    Source: ANSI/AGMA 2003-D19, eq. 18M, 0.00492 b + 0.4375 from 0.5 at 12.7 mm; B97 as Shigley 9th ed., eq. 15-9.

    >>> round(size_factor_contact(25.4e-3), 4)
    0.5625
    """
    width = min(face_width, edition.value) / INCH
    return max(0.5, 0.125 * width + 0.4375)


def size_factor_bending(module: float) -> float:
    """Return the size factor for bending K_s [-].

    Args:
        module: Outer transverse module m_et [m].

    Source: ANSI/AGMA 2003-D19, eq. 19, 0.4867 + 0.2132/P_d; 0.5 below 1.6 mm.

    >>> round(size_factor_bending(25.4e-3 / 5.6), 4)
    0.5248
    """
    return 0.5 if module < 1.6 * _MM else 0.4867 + 0.2132 * module / INCH


def load_distribution(face_width: float, modifier: float) -> float:
    """Return the load distribution factor K_m [-].

    Args:
        face_width: b [m].
        modifier: K_mb [-].

    Source: ANSI/AGMA 2003-D19, eq. 20, K_mb + 0.0036 F², F in inches, up to 14 in.

    Raises:
        DesignError: A wider face.

    >>> round(load_distribution(25.4e-3, ONE_STRADDLE), 4)
    1.1036
    """
    if face_width > WIDEST:
        message = f"{face_width / _MM:.4g} mm given; {SOURCE}, eq. 20 holds up to {WIDEST / _MM:g} mm"
        raise DesignError([Problem("face_width", message)])
    return modifier + 0.0036 * (face_width / INCH) ** 2


def lengthwise_curvature(spiral_angle: float, cutter_radius: float, cone_distance: float) -> float:
    """Return the lengthwise curvature factor K_x [-].

    Args:
        spiral_angle: β_m [rad].
        cutter_radius: r_c0 [m]; infinite for a large one.
        cone_distance: Mean cone distance R_m [m].

    Source: ANSI/AGMA 2003-D19, eqs 21 to 23: 0.211 (r_c0/R_m)^q + 0.789, q = 0.279/lg sin β_m, from 1 to 1.15; 1 for
        straight teeth.
    """
    if spiral_angle == 0.0:
        return 1.0
    exponent = 0.279 / math.log10(math.sin(spiral_angle))
    raw = 0.789 + 0.211 * math.exp(exponent * math.log(cutter_radius / cone_distance))
    return min(max(raw, 1.0), 1.15)


def temperature_factor(temperature: float) -> float:
    """Return the temperature factor K_T [-].

    Args:
        temperature: Of the gear blanks [°C].

    Source: ANSI/AGMA 2003-D19, clause 18 and eq. 31, (460 + t)/710 with t in °F, 1 up to 250 °F; its metric form,
        (273 + t)/393, is 0.3 % higher.

    >>> round(temperature_factor(148.9), 3)  # 300 °F; Shigley 9th ed., example 15-2: 1.070
    1.07
    """
    return max(1.0, (492.0 + 1.8 * temperature) / 710.0)


class BevelSteel(Enum):
    """Steels with their rows in tables 3 and 5."""

    THROUGH_HARDENED = "through-hardened"
    """Through-hardened, 180 to 400 HB."""
    CARBURISED = "carburised"
    """Carburised and hardened."""
    NITRIDED_4140 = "nitrided-4140"
    """AISI 4140, nitrided."""
    NITRALLOY = "nitralloy-135m"
    """Nitralloy 135M, nitrided."""


@dataclass(frozen=True)
class BevelStrength:
    """Allowable stress numbers of a steel."""

    bending: Annotated[float, Quantity("stress"), Origin("s_at", f"{SOURCE}, table 5 and figure 10")]
    """Allowable bending stress number s_at [Pa]."""
    contact: Annotated[float, Quantity("stress"), Origin("s_ac", f"{SOURCE}, table 3 and figure 9")]
    """Allowable contact stress number s_ac [Pa]."""


_ROWS: dict[tuple[BevelSteel, int], tuple[float, float]] = {
    (BevelSteel.CARBURISED, 1): (30e3, 200e3), (BevelSteel.CARBURISED, 2): (35e3, 225e3),
    (BevelSteel.CARBURISED, 3): (40e3, 250e3), (BevelSteel.NITRIDED_4140, 2): (22e3, 145e3),
    (BevelSteel.NITRALLOY, 2): (24e3, 160e3),
}  # fmt: skip
"""Steel and grade -> s_at and s_ac [psi]."""
_LINES = {1: ((44.0, 2100.0), (341.0, 23620.0)), 2: ((48.0, 5980.0), (363.6, 29560.0))}
"""Grade of through-hardened steel -> slope over HB and intercept of s_at and s_ac [psi]."""


def bevel_strength(steel: BevelSteel, grade: int, hardness: float = 0.0) -> BevelStrength:
    """Return the allowable stress numbers of a steel.

    Args:
        steel: The steel.
        grade: 1 to 3; of nitrided steels 2 [-].
        hardness: HB of a through-hardened gear, 180 to 400 [-].

    Source: ANSI/AGMA 2003-D19, tables 3 and 5, figures 9 and 10, in psi; of through-hardened steel as Shigley 9th ed.,
        eqs 15-22 and 15-23 (the standard's lines in N/mm² lie up to 1 % lower).

    Raises:
        DesignError: A grade that the steel does not have, or a hardness outside 180 to 400 HB.

    >>> round(bevel_strength(BevelSteel.THROUGH_HARDENED, 1, 180.0).bending / 6894.757)  # Shigley, example 15-1
    10020
    """
    lines = steel is BevelSteel.THROUGH_HARDENED
    known = sorted(_LINES if lines else (own for name, own in _ROWS if name is steel))
    problems = []
    if grade not in known:
        problems.append(Problem("grade", f"{grade} given; {steel.value} steel has {' and '.join(map(str, known))}"))
    if lines and not 180.0 <= hardness <= 400.0:
        problems.append(Problem("hardness", f"{hardness:g} HB given; {SOURCE}, figures 9 and 10 have 180 to 400 HB"))
    refuse(problems)
    if lines:
        bending, contact = (slope * hardness + constant for slope, constant in _LINES[grade])
    else:
        bending, contact = _ROWS[steel, grade]
    return BevelStrength(_PSI * bending, _PSI * contact)
