"""Fatigue of shafts by the distortion energy: Goodman, Gerber, Soderberg, ASME-elliptic, and the first yield.

Moments and torques are split into a mean and an amplitude. A rotating shaft turns a steady bending moment into an
amplitude, and a steady torque stays a mean.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from gearwright.errors import Problem, refuse
from gearwright.parts.shafts.notch import Concentration

_MPA = 1e6
_MM = 1e3
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

    Valid for: d from 2.79 to 254 mm.

    Raises:
        DesignError: If surface, reliability or diameter is not in the tables.
    """
    problems = []
    if surface not in SURFACES:
        problems.append(Problem("surface", f"{surface!r} is not known; allowed: {', '.join(SURFACES)}"))
    if reliability not in RELIABILITY_DEVIATES:
        allowed = ", ".join(f"{level:g}" for level in RELIABILITY_DEVIATES)
        problems.append(Problem("reliability", f"{reliability:g} given; allowed: {allowed}"))
    size = diameter * _MM
    if not 2.79 <= size <= 254.0:
        problems.append(Problem("diameter", f"{size:g} mm given; allowed: 2.79 to 254 mm"))
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
