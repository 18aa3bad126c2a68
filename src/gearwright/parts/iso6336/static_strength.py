"""Static strength of cylindrical gears: what flanks and roots bear once, without pitting, cracking or yielding."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.parts.hardness import BRINELL_PER_VICKERS
from gearwright.parts.iso6336.bending import BendingRating
from gearwright.parts.iso6336.geometry import Value, as_value
from gearwright.parts.iso6336.pitting import PittingRating
from gearwright.parts.iso6336.steels import STRESS_CORRECTION_TEST_GEAR, GearSteel, Treatment, life_curves
from gearwright.units import Origin, Quantity

_PART2, _PART3 = "ISO 6336-2:2019", "ISO 6336-3:2019"
_MPA = 1e6
_SOFT = 130.0


@dataclass(frozen=True)
class StaticStrength:
    """What one gear bears under a load that comes once."""

    contact_life: Annotated[Value, Quantity("ratio"), Origin("Z_NT, static", f"{_PART2}, table 2")]
    """Z_NT of static stress [-]."""
    work_hardening: Annotated[Value, Quantity("ratio"), Origin("Z_W, static", f"{_PART2}, clause 13")]
    """Z_W of static stress [-]."""
    contact_stress: Annotated[
        Value, Quantity("stress"), Origin("σ_H = Z_B,D σ_H0 √(K_V K_Hβ K_Hα K_γ), K_A = 1", f"{_PART2}, clause 5")
    ]
    """σ_H [Pa]."""
    contact_limit: Annotated[
        Value,
        Quantity("stress"),
        Origin("σ_HG,stat = σ_Hlim Z_NT Z_W, Z_L = Z_v = Z_R = Z_X = 1", f"{_PART2}, clauses 5, 11 to 14"),
    ]
    """σ_HG of static stress [Pa]."""
    contact_safety: Annotated[Value, Quantity("ratio"), Origin("S_H,stat = σ_HG,stat/σ_H", f"{_PART2}, clause 5")]
    """S_H against one load [-]."""
    bending_life: Annotated[Value, Quantity("ratio"), Origin("Y_NT, static", f"{_PART3}, table 1")]
    """Y_NT of static stress [-]."""
    notch_sensitivity: Annotated[
        Value, Quantity("ratio"), Origin("Y_δrelT, static, by Y_S", "ISO 6336-3:2006, clause 12.3")
    ]
    """Y_δrelT of static stress [-]."""
    bending_stress: Annotated[
        Value, Quantity("stress"), Origin("σ_F = σ_F0 K_V K_Fβ K_Fα K_γ, K_A = 1", f"{_PART3}, clause 5")
    ]
    """σ_F [Pa]."""
    bending_limit: Annotated[
        Value,
        Quantity("stress"),
        Origin("σ_FG,stat = σ_Flim Y_ST Y_NT Y_δrelT, Y_RrelT = Y_X = 1", f"{_PART3}, clauses 5, 11 to 14"),
    ]
    """σ_FG of static stress [Pa]."""
    bending_safety: Annotated[Value, Quantity("ratio"), Origin("S_F,stat = σ_FG,stat/σ_F", f"{_PART3}, clause 5")]
    """S_F against one load [-]."""
    yielding_safety: Annotated[
        Value | None,
        Quantity("ratio"),
        Origin("S_y = R_p0.2 Y_S/σ_F", "beam of the critical section, without its notch"),
    ] = None
    """R_p0.2 of the core over the nominal stress of the critical section [-]; None where it is not known."""


def static_notch_sensitivity(correction: Value, steel: GearSteel) -> Value:
    """Return the relative notch sensitivity factor Y_δrelT of static stress.

    Args:
        correction: Y_S [-].
        steel: Of the gear.

    Source: ISO 6336-3:2006, clause 12.3: 0.44 Y_S + 0.12 for case- and induction-hardened roots, 0.20 Y_S + 0.60 for
        nitrided ones; by the yield strength (1 + k (Y_S − 1) s)/(1 + k s), with k = 0.93 and s = (200/σ_S)^¼ for
        structural, k = 0.82 and s = (300/σ_0.2)^¼ for through-hardened steel.
        Grey and ferritic nodular iron are taken at 1, an assumption.
    Valid for: stress up to the first crack, or up to yielding where the steel is soft.

    >>> from gearwright.parts.iso6336.steels import Treatment
    >>> steel = GearSteel("x", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6)
    >>> round(float(static_notch_sensitivity(2.0, steel)), 12)  # of the test gears
    1.0
    """
    if steel.treatment.is_brittle_iron:
        return as_value(np.ones_like(np.asarray(correction)))
    if steel.treatment.is_nitrided:
        return 0.20 * correction + 0.60
    if steel.treatment.is_surface_hardened or steel.yield_strength is None:
        return 0.44 * correction + 0.12
    structural = steel.treatment is Treatment.STRUCTURAL
    weight, reference = (0.93, 200.0) if structural else (0.82, 300.0)
    part = weight * (reference * _MPA / steel.yield_strength) ** 0.25
    return as_value((1.0 + part * (correction - 1.0)) / (1.0 + part))


def static_work_hardening(steel: GearSteel, mate: GearSteel) -> float:
    """Return the work hardening factor Z_W of static stress.

    Args:
        steel: Of the gear.
        mate: Of its mate.

    Source: ISO 6336-2:2006, clause 13: 1.05 − (HB − 130)/680 of a soft gear against a hard mate, 1.05 below 130 HB,
        at least 1; 1 otherwise.
    """
    if steel.treatment.is_cast_iron or steel.treatment.is_surface_hardened or not mate.treatment.is_surface_hardened:
        return 1.0
    above = max(steel.hardness * BRINELL_PER_VICKERS - _SOFT, 0.0)
    return max(1.0, 1.05 - above / 680.0)


def static_strength(
    pitting: PittingRating, bending: tuple[BendingRating, BendingRating], steels: tuple[GearSteel, GearSteel], gear: int
) -> StaticStrength:
    """Return what one gear bears under a load that comes once.

    Args:
        pitting: The mesh under that load, K_A = 1.
        bending: Roots of both gears under it.
        steels: Of both gears.
        gear: 0 for the pinion, 1 for the wheel.

    Source: ISO 6336-2:2019, clauses 5 and 11 to 14; ISO 6336-3:2019, clauses 5 and 11 to 14: reference factors of film,
        roughness and size are 1 for static stress. Y_M is 1, since a load that comes once does not bend both ways.
    """
    steel, root = steels[gear], bending[gear]
    flank_curve, root_curve = life_curves(steel)
    hardening = static_work_hardening(steel, steels[1 - gear])
    sensitivity = static_notch_sensitivity(root.section.stress_correction, steel)
    flank = steel.contact_strength * flank_curve.factors[0] * hardening
    limit = steel.bending_strength * STRESS_CORRECTION_TEST_GEAR * root_curve.factors[0] * sensitivity
    nominal = np.asarray(root.stress) / root.section.stress_correction
    return StaticStrength(
        contact_life=flank_curve.factors[0],
        work_hardening=hardening,
        contact_stress=pitting.stresses[gear],
        contact_limit=flank,
        contact_safety=flank / pitting.stresses[gear],
        bending_life=root_curve.factors[0],
        notch_sensitivity=sensitivity,
        bending_stress=root.stress,
        bending_limit=limit,
        bending_safety=limit / root.stress,
        yielding_safety=None if steel.yield_strength is None else as_value(steel.yield_strength / nominal),
    )
