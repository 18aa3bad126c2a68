"""Safety of a shaft's section by DIN 743: against fatigue and lasting deformation, in tension, bending and torsion.

Strengths of the steel are those of the reference diameter d_B; the size of the blank lowers them (K_1), the size of the
section (K_2) and its surface (K_F) lower what a notch leaves.
"""

from __future__ import annotations

import math
from enum import Enum
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.parts.shaft_fatigue import Concentration, SectionLoad

_MPA = 1e6
_MM = 1e3
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
