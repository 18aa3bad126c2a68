"""Tooth bending of bevel gears by ISO 10300-3:2023, method B1, generated teeth without hypoid offset."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated

from gearwright.parts.bevel.pitting import BevelDuty, virtual_force
from gearwright.parts.bevel.virtual import VirtualPair
from gearwright.parts.iso6336 import (
    STRESS_CORRECTION_TEST_GEAR,
    GearSteel,
    LoadedTooth,
    LoadFactors,
    RootSection,
    ToothProportions,
    Treatment,
    bending_size_factor,
    notch_sensitivity_factor,
    root_section,
    surface_factor,
)
from gearwright.units import Origin, Quantity

_PART3 = "ISO 10300-3:2023"


@dataclass(frozen=True)
class BevelBending:
    """Root stress and its limit for one gear."""

    section: RootSection
    """Critical section with Y_Fa and Y_Sa, loaded at the tip."""
    contact_ratio: Annotated[float, Quantity("ratio"), Origin("Y_ε", f"{_PART3}, eqs 27 to 29")]
    """Contact ratio factor Y_ε [-]."""
    spiral: Annotated[float, Quantity("ratio"), Origin("Y_BS", f"{_PART3}, eq. 30")]
    """Bevel spiral angle factor Y_BS [-]."""
    load_sharing: Annotated[float, Quantity("ratio"), Origin("Y_LS = Z_LS²", f"{_PART3}, eq. 36")]
    """Load sharing factor Y_LS [-]."""
    notch_sensitivity: Annotated[float, Quantity("ratio"), Origin("Y_δrelT", f"{_PART3}, eq. 43")]
    """Relative notch sensitivity factor Y_δrelT [-]."""
    surface: Annotated[float, Quantity("ratio"), Origin("Y_R,relT", f"{_PART3}, eqs 40 to 42")]
    """Relative surface condition factor Y_R,relT [-]."""
    size: Annotated[float, Quantity("ratio"), Origin("Y_X", f"{_PART3}, clause 8.1")]
    """Size factor Y_X [-]."""
    nominal_stress: Annotated[
        float, Quantity("stress"), Origin("σ_F0 = F_vmt/(b_v m_mn) Y_Fa Y_Sa Y_ε Y_BS Y_LS", f"{_PART3}, eq. 2")
    ]
    """Nominal root stress σ_F0 [Pa]."""
    stress: Annotated[float, Quantity("stress"), Origin("σ_F = σ_F0 K_A K_V K_Fβ K_Fα", f"{_PART3}, eq. 1")]
    """Root stress σ_F [Pa]."""
    permissible: Annotated[
        float, Quantity("stress"), Origin("σ_FP = σ_Flim Y_ST Y_NT Y_δrelT Y_R,relT Y_X", f"{_PART3}, eq. 4")
    ]
    """Root stress limit σ_FP [Pa]."""
    safety: Annotated[float, Quantity("ratio"), Origin("S_F = σ_FP/σ_F", f"{_PART3}, eq. 5")]
    """S_F [-]."""


def tip_loaded_section(virtual: VirtualPair, gear: int) -> RootSection:
    """Return the critical section of a generated bevel tooth loaded at its tip.

    Args:
        virtual: The virtual pair.
        gear: 0 for the pinion, 1 for the wheel.

    Source: ISO 10300-3:2023, eqs 6 to 17 and 24 to 26: the formulas of ISO 6336-3 with x_s and d_van.
    """
    pair, tooth = virtual.bevel, virtual.bevel.tooth
    shift = tooth.profile_shift if gear == 0 else -tooth.profile_shift
    teeth = virtual.normal_teeth[gear]
    loaded = LoadedTooth(
        teeth,
        teeth + 2.0 * (tooth.addendum + shift),
        pair.pressure_angle,
        ToothProportions(tooth.dedendum, tooth.edge_radii[gear], shift),
        thickness_shift=tooth.thickness_shifts[gear],
    )
    return _section(loaded)


@lru_cache(maxsize=4096)
def _section(loaded: LoadedTooth) -> RootSection:
    """Critical section in modules; it is the same in all sizes of a pair."""
    return root_section(loaded)


@lru_cache(maxsize=1024)
def _surface(roughness: float, treatment: Treatment) -> float:
    """Y_R,relT of roots that many pairs have."""
    return float(surface_factor(roughness, treatment))


def contact_ratio_factor_bending(virtual: VirtualPair) -> float:
    """Return the contact ratio factor Y_ε.

    Args:
        virtual: The virtual pair.

    Source: ISO 10300-3:2023, eqs 27 to 29: 0.25 + 0.75/ε_vα for ε_vβ = 0, 0.625 from ε_vβ = 1, straight between.
    """
    spur = max(0.25 + 0.75 / virtual.profile_ratio, 0.625)
    return spur - min(virtual.face_ratio, 1.0) * (spur - 0.625)


def spiral_angle_factor(virtual: VirtualPair) -> float:
    """Return the bevel spiral angle factor Y_BS; 1 for straight teeth.

    Args:
        virtual: The virtual pair.

    Source: ISO 10300-3:2023, eqs 30 to 35.
    """
    pair = virtual.bevel
    if pair.spiral_angle == 0.0:
        return 1.0
    width = pair.face_width / math.cos(pair.spiral_angle)
    covered = virtual.lines[1].length * math.cos(virtual.base_helix_angle) / math.cos(pair.spiral_angle)
    x = 2.0 * width / (sum(pair.addenda) + sum(pair.dedenda))
    a = -0.0182 * x**2 + 0.4736 * x - 0.32
    b = -0.0032 * x**2 + 0.0526 * x + 0.712
    c = -0.0050 * x**2 + 0.0850 * x + 0.54
    return a / c * (covered / width - 1.05 * b) ** 2 + 1.0


def bevel_bending(
    virtual: VirtualPair,
    gear: int,
    steel: GearSteel,
    *,
    duty: BevelDuty,
    loads: LoadFactors,
    life: float,
    roughness: float = 16e-6,
) -> BevelBending:
    """Return root stress, limit and safety of one gear.

    Args:
        virtual: The virtual pair.
        gear: 0 for the pinion, 1 for the wheel.
        steel: Of the gear.
        duty: Torque.
        loads: K factors.
        life: Y_NT [-].
        roughness: R_z of the root [m].

    Source: ISO 10300-3:2023, clause 6.
    Valid for: generated teeth, ε_vα < 2.
    """
    pair = virtual.bevel
    section = tip_loaded_section(virtual, gear)
    ratio, spiral, sharing = (
        contact_ratio_factor_bending(virtual),
        spiral_angle_factor(virtual),
        virtual.load_sharing**2,
    )
    nominal = virtual_force(pair, duty) / (pair.face_width * pair.mean_module) * float(section.form)
    nominal *= float(section.stress_correction) * ratio * spiral * sharing
    stress = nominal * float(loads.bending)
    notch = float(notch_sensitivity_factor(section.notch, steel))
    surface = _surface(roughness, steel.treatment)
    size = float(bending_size_factor(pair.mean_module, steel.treatment))
    limit = steel.bending_strength * STRESS_CORRECTION_TEST_GEAR * life * notch * surface * size
    return BevelBending(section, ratio, spiral, sharing, notch, surface, size, nominal, stress, limit, limit / stress)
