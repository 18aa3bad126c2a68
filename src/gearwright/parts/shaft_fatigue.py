"""Notch factors and fatigue strength of shafts, and rainflow cycle counting."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType
from typing import Literal, NamedTuple

from gearwright.errors import DesignError, Problem, refuse
from gearwright.units import INCH, POUND_FORCE

# ----------------------------------------------------------------------------------------------------------------------
# How a shoulder of a shaft raises stress, or an undercut at its foot, and what of it the material feels.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# How what sits on a shaft notches it: keyways, press fits and splines, measured and not computed from their shape.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Fatigue of shafts by the distortion energy: Goodman, Gerber, Soderberg, ASME-elliptic, and the first yield.
#
# Moments and torques are split into a mean and an amplitude. A rotating shaft turns a steady bending moment into an
# amplitude, and a steady torque stays a mean.
# ----------------------------------------------------------------------------------------------------------------------


SURFACES = {
    "ground": (1.58, -0.085),
    "machined": (4.51, -0.265),
    "hot-rolled": (57.7, -0.718),
    "forged": (272.0, -0.995),
}
"""Surface -> a [MPa] and b of k_a = a S_ut^b (Shigley, table 6-2)."""
RELIABILITY_DEVIATES = {0.5: 0.0, 0.9: 1.288, 0.95: 1.645, 0.99: 2.326, 0.999: 3.091, 0.9999: 3.719}
"""Reliability -> standard deviate z_a (Shigley, table 6-5)."""
NO_NOTCH = Concentration(1.0, 1.0)


class SectionLoad(NamedTuple):
    """Bending and torsion of one section."""

    bending_amplitude: float = 0.0
    """M_a [N m]."""
    bending_mean: float = 0.0
    """M_m [N m]."""
    torque_amplitude: float = 0.0
    """T_a [N m]."""
    torque_mean: float = 0.0
    """T_m [N m]."""


class FatigueStrength(NamedTuple):
    """What a shaft's material bears in one section."""

    endurance: float
    """Endurance limit of the part S_e [Pa]."""
    ultimate: float
    """S_ut [Pa]."""
    yielding: float
    """S_y [Pa]."""


class SectionStress(NamedTuple):
    """Equivalent stresses of one section by von Mises."""

    amplitude: float
    """σ_a′ [Pa]."""
    mean: float
    """σ_m′ [Pa]."""
    greatest: float
    """σ_max′, of mean and amplitude added component by component [Pa]."""


def endurance_limit(ultimate_strength: float, diameter: float, *, surface: str, reliability: float = 0.5) -> float:
    """Return the endurance limit of a rotating steel shaft S_e [Pa].

    Args:
        ultimate_strength: S_ut [Pa].
        diameter: d [m].
        surface: A key of `SURFACES`.
        reliability: Part that survives, a value of Shigley's table 6-5 [-].

    Source: Marin; Budynas & Nisbett, Shigley's Mechanical Engineering Design, eqs (6-8) and (6-18) to (6-29):
        k_a k_b k_e 0.5 S_ut, at most 700 MPa; k_b = 1.24 d^−0.107 to 51 mm, then 1.51 d^−0.157; k_e = 1 − 0.08 z_a.

    Valid for: d from 2.79 to 254 mm. To 400 mm the same curve goes on, down to k_b = 0.59, an assumption: earlier
        editions of the book say 0.60 to 0.75 of larger sizes.

    Raises:
        DesignError: If surface or reliability is not in the tables, or the diameter beyond the curve.
    """
    problems = []
    if surface not in SURFACES:
        problems.append(Problem("surface", f"{surface!r} is not known; allowed: {', '.join(SURFACES)}"))
    if reliability not in RELIABILITY_DEVIATES:
        allowed = ", ".join(f"{level:g}" for level in RELIABILITY_DEVIATES)
        problems.append(Problem("reliability", f"{reliability:g} given; allowed: {allowed}"))
    size = diameter * _MM
    if not 2.79 <= size <= 400.0:
        problems.append(Problem("diameter", f"{size:g} mm given; allowed: 2.79 to 400 mm"))
    refuse(problems)
    factor, exponent = SURFACES[surface]
    finish = min(factor * math.pow(ultimate_strength / _MPA, exponent), 1.0)
    volume = 1.24 * math.pow(size, -0.107) if size <= 51.0 else 1.51 * math.pow(size, -0.157)
    smooth = 0.5 * min(ultimate_strength, 1400e6)
    return finish * volume * (1.0 - 0.08 * RELIABILITY_DEVIATES[reliability]) * smooth


def section_stress(
    load: SectionLoad, diameter: float, notch: Concentration = NO_NOTCH, *, bore: float = 0.0
) -> SectionStress:
    """Return the equivalent stresses of a section.

    Args:
        load: Bending and torsion [N m].
        diameter: d [m].
        notch: K_f and K_fs [-].
        bore: Inner diameter [m].

    Source: Budynas & Nisbett, Shigley's Mechanical Engineering Design, eqs (7-5), (7-6), (7-15):
        σ′ = √((32 K_f M/π d³)² + 3 (16 K_fs T/π d³)²).
    """
    return section_stresses((load,), diameter, notch, bore=bore)[0]


def section_stresses(
    loads: Sequence[SectionLoad], diameter: float, notch: Concentration = NO_NOTCH, *, bore: float = 0.0
) -> list[SectionStress]:
    """Return the equivalent stresses of a section under several loads, as `section_stress` gives each.

    Args:
        loads: Bending and torsion [N m].
        diameter: d [m].
        notch: K_f and K_fs [-].
        bore: Inner diameter [m].

    Source: as `section_stress`.
    """
    hollow = 1.0 - (bore / diameter) ** 4
    bending = 32.0 * notch.bending / (math.pi * diameter**3 * hollow)
    torsion = math.sqrt(3.0) * 16.0 * notch.torsion / (math.pi * diameter**3 * hollow)
    return [
        SectionStress(
            math.hypot(bending * amplitude, torsion * torque_amplitude),
            math.hypot(bending * mean, torsion * torque_mean),
            math.hypot(bending * (amplitude + mean), torsion * (torque_amplitude + torque_mean)),
        )
        for amplitude, mean, torque_amplitude, torque_mean in loads
    ]


def goodman_safety(stress: SectionStress, strength: FatigueStrength) -> float:
    """Return the safety against fatigue by the modified Goodman line [-].

    Args:
        stress: From `section_stress` [Pa].
        strength: [Pa].

    Source: Budynas & Nisbett, Shigley's Mechanical Engineering Design, eq. (7-7): 1/n = σ_a′/S_e + σ_m′/S_ut.
    """
    return _inverse(stress.amplitude / strength.endurance + stress.mean / strength.ultimate)


def asme_safety(stress: SectionStress, strength: FatigueStrength) -> float:
    """Return the safety against fatigue by the ASME ellipse [-].

    Args:
        stress: From `section_stress` [Pa].
        strength: [Pa].

    Source: Budynas & Nisbett, Shigley's Mechanical Engineering Design, eq. (7-11): 1/n² = (σ_a′/S_e)² + (σ_m′/S_y)².
    """
    return _inverse(math.hypot(stress.amplitude / strength.endurance, stress.mean / strength.yielding))


def gerber_safety(stress: SectionStress, strength: FatigueStrength) -> float:
    """Return the safety against fatigue by Gerber's parabola [-].

    Args:
        stress: From `section_stress` [Pa].
        strength: [Pa].

    Source: Gerber 1874: n σ_a′/S_e + (n σ_m′/S_ut)² = 1, solved for n.
    """
    half = 0.5 * stress.amplitude / strength.endurance
    return _inverse(half + math.hypot(half, stress.mean / strength.ultimate))


def soderberg_safety(stress: SectionStress, strength: FatigueStrength) -> float:
    """Return the safety against fatigue by Soderberg's line [-].

    Args:
        stress: From `section_stress` [Pa].
        strength: [Pa].

    Source: Soderberg 1930: 1/n = σ_a′/S_e + σ_m′/S_y.
    """
    return _inverse(stress.amplitude / strength.endurance + stress.mean / strength.yielding)


def yield_safety(stress: SectionStress, strength: FatigueStrength) -> float:
    """Return the safety against yielding in the first turn [-].

    Args:
        stress: From `section_stress` [Pa].
        strength: [Pa].

    Source: Budynas & Nisbett, Shigley's Mechanical Engineering Design, eqs (7-15) and (7-16).
    """
    return _inverse(stress.greatest / strength.yielding)


CRITERIA: Mapping[str, Callable[[SectionStress, FatigueStrength], float]] = MappingProxyType(
    {"asme": asme_safety, "goodman": goodman_safety, "gerber": gerber_safety, "soderberg": soderberg_safety}
)
"""Name in design files -> criterion of fatigue."""


def _inverse(use: float) -> float:
    """Return the safety of what uses a share of its strength: without load, without end."""
    return 1.0 / use if use else math.inf


# ----------------------------------------------------------------------------------------------------------------------
# Rainflow counting: a history of load as cycles of a range and a mean, by ASTM E1049.
# ----------------------------------------------------------------------------------------------------------------------


Residue = Literal["half-cycles", "repeated"]
"""What becomes of what closes no loop: every range of it is half a cycle, or the history is one period that repeats."""
HALF, WHOLE = 0.5, 1.0


@dataclass(frozen=True)
class LoadCycle:
    """Cycles of one size."""

    range: float
    """From valley to peak, in the unit of the history."""
    mean: float
    """Half of valley and peak, in the same unit."""
    count: float
    """Cycles, a half one counted as 0.5 [-]."""


def reversals(history: Sequence[float]) -> list[float]:
    """Return the peaks and valleys of a history, with its first and its last value.

    Args:
        history: Loads one after the other [N m], or any other unit of load.

    Source: ASTM E1049-85 (2017), clause 3.

    >>> reversals([0.0, 1.0, 1.0, 2.0, -1.0, 0.0])
    [0.0, 2.0, -1.0, 0.0]
    """
    turned: list[float] = []
    for value in history:
        if turned and value == turned[-1]:
            continue
        if len(turned) > 1 and (turned[-1] - turned[-2]) * (value - turned[-1]) > 0.0:
            turned[-1] = value
        else:
            turned.append(value)
    return turned


def rainflow(history: Sequence[float], *, residue: Residue = "half-cycles") -> tuple[LoadCycle, ...]:
    """Return the cycles of a history of load, the largest range first.

    Args:
        history: Loads one after the other [N m], or any other unit of load.
        residue: By ``half-cycles`` each range that closes no loop counts as half a cycle (clause 5.4.4); by
            ``repeated`` the history is one period of many, begins at its highest peak and leaves nothing open (5.4.5).

    Source: ASTM E1049-85 (2017), clauses 5.4.4 and 5.4.5.

    >>> [(cycle.range, cycle.count) for cycle in rainflow([-2, 1, -3, 5, -1, 3, -4, 4, -2], residue="repeated")]
    [(9, 1.0), (7, 1.0), (4, 1.0), (3, 1.0)]
    """
    turned = reversals(history)
    if residue == "repeated" and turned:
        top = turned.index(max(turned))
        turned = reversals([*turned[top:], *turned[: top + 1]])
    counted: dict[tuple[float, float], float] = {}
    for first, second, count in _counted(turned):
        key = (abs(first - second), (first + second) / 2.0)
        counted[key] = counted.get(key, 0.0) + count
    merged = [LoadCycle(*key, count) for key, count in counted.items()]
    return tuple(sorted(merged, key=lambda cycle: (-cycle.range, -cycle.mean)))


def _counted(turned: Sequence[float]) -> Iterator[tuple[float, float, float]]:
    """Yield both ends and the count of every range, in the order in which loops close."""
    held: list[float] = []
    for value in turned:
        held.append(value)
        while len(held) > 2 and abs(held[-1] - held[-2]) >= abs(held[-2] - held[-3]):
            if len(held) == 3:
                yield held[0], held[1], HALF
                del held[0]
            else:
                yield held[-3], held[-2], WHOLE
                del held[-3:-1]
    for place in range(len(held) - 1):
        yield held[place], held[place + 1], HALF


# ----------------------------------------------------------------------------------------------------------------------
# Safety of a shaft's section by DIN 743: against fatigue and lasting deformation, in tension, bending and torsion.
#
# Strengths of the steel are those of the reference diameter d_B; the size of the blank lowers them (K_1), the size of
# the section (K_2) and its surface (K_F) lower what a notch leaves.
# ----------------------------------------------------------------------------------------------------------------------


_NOTCH_RAISES = ((1.5, 1.0), (2.0, 1.05), (3.0, 1.1))
"""Greatest β_σ and γ_F: a notch keeps its ground from yielding (DIN 743-2:2012)."""
_NOTCH_RAISES_MOST = 1.15


class _SizeLaw(NamedTuple):
    """K_1 = 1 − slope lg(d_eff/reference) up to an end; lengths in mm."""

    ultimate: tuple[float, float]
    """Reference and slope of σ_B and of the fatigue limits."""
    yielding: tuple[float, float]
    """Reference and slope of σ_S."""
    end: float


class SteelGroup(Enum):
    """How strength falls with the diameter of the blank (DIN 743-2:2012)."""

    STRUCTURAL = _SizeLaw((100.0, 0.23), (32.0, 0.26), 300.0)
    """Structural steels."""
    NITRIDING = _SizeLaw((100.0, 0.23), (100.0, 0.23), 300.0)
    """Nitriding steels."""
    TEMPERED = _SizeLaw((16.0, 0.26), (16.0, 0.34), 300.0)
    """Quenched and tempered steels."""
    NICKEL_CASE_HARDENED = _SizeLaw((16.0, 0.26), (16.0, 0.26), 300.0)
    """Case-hardening steels with chromium and nickel, core."""
    CASE_HARDENED = _SizeLaw((16.0, 0.41), (16.0, 0.41), 150.0)
    """Other case-hardening steels, core."""


class Overload(Enum):
    """How stress would grow until the section fails (DIN 743-1:2012, cases 1 and 2)."""

    CONSTANT_MEAN = 1
    """The amplitude alone: its limit is σ_WK − ψ σ_mv."""
    CONSTANT_RATIO = 2
    """Mean and amplitude together: its limit is σ_WK/(1 + ψ σ_mv/σ_a)."""


class ShaftSteel(NamedTuple):
    """Strengths of a steel at its reference diameter."""

    ultimate: float
    """σ_B [Pa]."""
    yielding: float
    """σ_S [Pa]."""
    bending_fatigue: float
    """σ_bW, fully reversed, about 0.5 σ_B [Pa]."""
    torsion_fatigue: float
    """τ_tW, fully reversed, about 0.3 σ_B [Pa]."""
    group: SteelGroup
    """How strength falls with size."""
    tension_fatigue: float | None = None
    """σ_zdW, fully reversed [Pa]; None: 0.8 σ_bW, which is 0.4 σ_B where σ_bW is 0.5 σ_B."""


class AxialLoad(NamedTuple):
    """Force along a section, tension positive."""

    amplitude: float = 0.0
    """F_a [N]."""
    mean: float = 0.0
    """F_m [N]."""
    greatest: float = 0.0
    """F_max, for yielding [N]."""


NO_AXIAL = AxialLoad()


class ShaftSection(NamedTuple):
    """A notched section."""

    diameter: float
    """Of the section d [m]."""
    blank: float
    """Diameter at which the steel was heat treated d_eff [m]."""
    notch: Concentration
    """β_σ and β_τ [-]."""
    roughness: float = 10e-6
    """R_z [m]."""
    bore: float = 0.0
    """Inner diameter [m]."""
    hardening: float = 1.0
    """K_V, above 1 for shot-peened, rolled or case-hardened surfaces [-]."""
    tension_notch: float | None = None
    """β_σ in tension [-]; None: that of bending, as hubs have it."""
    hard_surface: bool = False
    """Whether it is hard: K_F = 1 (its roughness is in K_V), K_2F = 1 and γ_F = 1 (its core does not yield first)."""


class Din743Safety(NamedTuple):
    """Both safeties of a section."""

    fatigue: float
    """S_D [-]."""
    yielding: float
    """S_F [-]."""


def blank_factor(blank: float, group: SteelGroup, *, yielding: bool) -> float:
    """Return the technological size factor K_1 [-].

    Args:
        blank: d_eff [m].
        group: Of the steel [-].
        yielding: Of σ_S instead of σ_B.

    Source: DIN 743-2:2012: 1 − slope lg(d_eff/d_B) between d_B and the end of the range, constant beyond.
    """
    law = group.value
    reference, slope = law.yielding if yielding else law.ultimate
    return 1.0 - slope * math.log10(min(max(blank * _MM, reference), law.end) / reference)


def section_factor(diameter: float) -> float:
    """Return the geometric size factor K_2 in bending and torsion [-].

    Args:
        diameter: d [m].

    Source: DIN 743-2:2012: 1 − 0.2 lg(d/7.5 mm)/lg 20 from 7.5 to 150 mm, 0.8 above.

    >>> round(section_factor(0.04), 4)
    0.8882
    """
    size = min(max(diameter * _MM, 7.5), 150.0)
    return 1.0 - 0.2 * math.log10(size / 7.5) / math.log10(20.0)


def surface_factors(roughness: float, ultimate: float) -> Concentration:
    """Return the influence of the surface's roughness K_Fσ and K_Fτ [-].

    Args:
        roughness: R_z [m].
        ultimate: σ_B of the section [Pa].

    Source: DIN 743-2:2012: 1 − 0.22 lg(R_z/µm) (lg(σ_B/20 MPa) − 1); K_Fτ = 0.575 K_Fσ + 0.425.
    """
    bending = 1.0 - 0.22 * math.log10(max(roughness * 1e6, 1.0)) * (
        math.log10(min(ultimate / _MPA, 2000.0) / 20.0) - 1.0
    )
    return Concentration(bending, 0.575 * bending + 0.425)


def din743_safety(
    load: SectionLoad,
    section: ShaftSection,
    steel: ShaftSteel,
    *,
    greatest: SectionLoad,
    overload: Overload = Overload.CONSTANT_MEAN,
    axial: AxialLoad = NO_AXIAL,
) -> Din743Safety:
    """Return the safeties of a shaft's section.

    Args:
        load: For fatigue: amplitudes and means of bending and torsion [N m].
        section: Diameter and notch [m].
        steel: Strengths [Pa].
        greatest: For yielding: means and amplitudes of the greatest load [N m].
        overload: How the load would grow.
        axial: Force along the section [N].

    Source: DIN 743-1:2012: total factor K = (β/K_2 + 1/K_F − 1)/K_V, fatigue limit of the part σ_WK = σ_W K_1/K, mean
        stress by ψ = σ_WK/(2 K_1 σ_B − σ_WK) at constant mean stress (case 1) or constant σ_m/σ_a (case 2), and never
        beyond yielding; 1/S_D² = (σ_zda/σ_zdADK + σ_ba/σ_bADK)² + (τ_ta/τ_tADK)², 1/S_F² the same of the greatest
        stresses and yield limits; in tension K_2 = K_2F = 1.

    Raises:
        DesignError: If the mean stress alone uses up the fatigue limit.
    """
    resist = math.pi / 32.0 * section.diameter**3 * (1.0 - (section.bore / section.diameter) ** 4)
    area = math.pi / 4.0 * (section.diameter**2 - section.bore**2)
    yielding, stretched = yield_limits(section, steel), _tension_yield(section, steel)
    pull = abs(axial.amplitude) / area
    steady = abs(axial.mean) / area
    limits = _fatigue_limits(load, section, steel, resist=resist, overload=overload, steady=steady)
    pulled = (
        _tension_limit(load, section, steel, resist=resist, overload=overload, pull=(pull, steady)) if pull else 1.0
    )
    tired = math.hypot(
        pull / pulled + load.bending_amplitude / resist / limits.bending,
        load.torque_amplitude / (2.0 * resist) / limits.torsion,
    )
    strained = math.hypot(
        abs(axial.greatest) / area / stretched
        + (greatest.bending_mean + greatest.bending_amplitude) / resist / yielding.bending,
        (greatest.torque_mean + greatest.torque_amplitude) / (2.0 * resist) / yielding.torsion,
    )
    return Din743Safety(1.0 / tired if tired else math.inf, 1.0 / strained if strained else math.inf)


def yield_limits(section: ShaftSection, steel: ShaftSteel) -> Concentration:
    """Return the yield limits of a section in bending σ_bFK and torsion τ_tFK [Pa].

    Args:
        section: Diameter and notch [m].
        steel: Strengths [Pa].

    Source: DIN 743-1:2012: K_1 K_2F γ_F σ_S, in torsion over √3; γ_F of DIN 743-2:2012.
    """
    strength = steel.yielding * blank_factor(section.blank, steel.group, yielding=True)
    support = _support(section, steel.group)
    raised = next((factor for end, factor in _NOTCH_RAISES if section.notch.bending <= end), _NOTCH_RAISES_MOST)
    raised = 1.0 if section.hard_surface else raised
    return Concentration(strength * support.bending * raised, strength * support.torsion / math.sqrt(3.0))


def _support(section: ShaftSection, group: SteelGroup) -> Concentration:
    """Return K_2F: the core of a section bears on where its surface yields, unless a hard surface would crack."""
    if section.hard_surface or group in (SteelGroup.CASE_HARDENED, SteelGroup.NICKEL_CASE_HARDENED):
        return Concentration(1.0, 1.0)
    return Concentration(1.1, 1.0) if section.bore else Concentration(1.2, 1.2)


def _tension_yield(section: ShaftSection, steel: ShaftSteel) -> float:
    """Return the yield limit in tension σ_zdFK [Pa]: K_1 γ_F σ_S, as K_2F is 1."""
    return yield_limits(section, steel).bending / _support(section, steel.group).bending


def _fatigue_limits(
    load: SectionLoad, section: ShaftSection, steel: ShaftSteel, *, resist: float, overload: Overload, steady: float
) -> Concentration:
    """Return σ_bADK and τ_tADK [Pa]."""
    mean = _mean_stress(load, resist, steady)
    means, limits = (mean, mean / math.sqrt(3.0)), []
    stresses = (load.bending_amplitude / resist, load.torque_amplitude / (2.0 * resist))
    reversed_limits, yields = _reversed_limits(section, steel), yield_limits(section, steel)
    for part, held, stress, yielding in zip(reversed_limits, means, stresses, yields, strict=True):
        limits.append(_amplitude(_ultimate(section, steel), part, yielding, (held, stress), overload=overload))
    return Concentration(*limits)


def _tension_limit(
    load: SectionLoad, section: ShaftSection, steel: ShaftSteel, *, resist: float, overload: Overload,
    pull: tuple[float, float],
) -> float:  # fmt: skip
    """Return σ_zdADK under amplitude and mean of the tension [Pa]."""
    amplitude, steady = pull
    size = blank_factor(section.blank, steel.group, yielding=False)
    smooth = size * (0.8 * steel.bending_fatigue if steel.tension_fatigue is None else steel.tension_fatigue)
    rough = 1.0 if section.hard_surface else surface_factors(section.roughness, size * steel.ultimate).bending
    notch = section.notch.bending if section.tension_notch is None else section.tension_notch
    part = smooth / (notch + 1.0 / rough - 1.0) * section.hardening
    held = (_mean_stress(load, resist, steady), amplitude)
    return _amplitude(_ultimate(section, steel), part, _tension_yield(section, steel), held, overload=overload)


def _mean_stress(load: SectionLoad, resist: float, steady: float) -> float:
    """Return the equivalent mean stress σ_mv [Pa]."""
    return math.hypot(load.bending_mean / resist + steady, math.sqrt(3.0) * load.torque_mean / (2.0 * resist))


def _ultimate(section: ShaftSection, steel: ShaftSteel) -> float:
    return blank_factor(section.blank, steel.group, yielding=False) * steel.ultimate


def _amplitude(
    ultimate: float, part: float, yielding: float, held: tuple[float, float], *, overload: Overload
) -> float:
    """Return the amplitude that a part bears beside a mean stress, of a stress that grows as the overload says [Pa]."""
    steady, stress = held
    sensitivity = part / (2.0 * ultimate - part)
    if overload is Overload.CONSTANT_MEAN:
        amplitude = min(part - sensitivity * steady, yielding - steady)
    else:
        ratio = steady / stress if stress else 0.0
        amplitude = min(part / (1.0 + sensitivity * ratio), yielding / (1.0 + ratio))
    if amplitude <= 0.0:
        message = f"mean stress of {steady / _MPA:.4g} MPa leaves no fatigue strength; take a larger diameter"
        raise DesignError([Problem("section.diameter", message)])
    return amplitude


def _reversed_limits(section: ShaftSection, steel: ShaftSteel) -> Concentration:
    """Return σ_bWK and τ_tWK [Pa]."""
    size = blank_factor(section.blank, steel.group, yielding=False)
    hard = Concentration(1.0, 1.0)
    surface = hard if section.hard_surface else surface_factors(section.roughness, size * steel.ultimate)
    support = section_factor(section.diameter)
    smooth = (size * steel.bending_fatigue, size * steel.torsion_fatigue)
    return Concentration(
        *(
            limit / (notch / support + 1.0 / rough - 1.0) * section.hardening
            for limit, notch, rough in zip(smooth, section.notch, surface, strict=True)
        )
    )
