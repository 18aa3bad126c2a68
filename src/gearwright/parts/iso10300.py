"""Rating of bevel gears by ISO 10300, method B1: virtual cylindrical gears, pitting and tooth bending."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Annotated

import numpy as np

from gearwright.base import Origin, Problem, Quantity, refuse
from gearwright.parts.bevel_geometry import (
    BevelPair,
)
from gearwright.parts.gears import transverse_pressure_angle
from gearwright.parts.iso6336 import (
    STRESS_CORRECTION_TEST_GEAR,
    GearSteel,
    LifeCurve,
    LoadedTooth,
    MeshGeometry,
    RootSection,
    Steels,
    ToothLoadFactors,
    ToothProportions,
    Treatment,
    bending_size_factor,
    elasticity_factor,
    life_curves,
    life_factor,
    lubricant_factor,
    notch_sensitivity_factor,
    root_section,
    roughness_factor,
    speed_factor,
    surface_factor,
)
from gearwright.parts.stiffness import modulus_factor

# ----------------------------------------------------------------------------------------------------------------------
# The virtual cylindrical gears of a bevel pair by ISO 10300-1:2023, annex A, method B1, without hypoid offset.
# ----------------------------------------------------------------------------------------------------------------------


EFFECTIVE_WIDTH = 0.85
"""Part of the face that bears under load, b_2,eff/b [-] (ISO 10300-1:2023, annex A.2.4)."""
HIGH_CROWNING, LOW_CROWNING = 1.5, 3.0
"""Exponent e_LS of the load over the zone for high and low profile crowning [-] (ISO 10300-2:2023, table 5)."""


@dataclass(frozen=True)
class ContactLine:
    """One line of contact in the zone of action."""

    distance: float
    """Distance from the middle of the zone f [m]."""
    length: float
    """Length l_b [m]."""
    peak: float
    """Load relative to the middle of the zone p* [-]."""


@dataclass(frozen=True)
class VirtualPair:
    """The pair of cylindrical gears that stands for a bevel pair at its mean cone."""

    bevel: BevelPair
    """The bevel pair."""
    peak_exponent: float = HIGH_CROWNING
    """Exponent e_LS of the load over the zone [-]."""

    @cached_property
    def diameters(self) -> tuple[float, float]:
        """Reference diameters d_v = d_m/cos δ [m] (eq. A.1)."""
        first, second = (
            d / math.cos(angle) for d, angle in zip(self.bevel.mean_diameters, self.bevel.pitch_angles, strict=True)
        )
        return first, second

    @cached_property
    def transverse_angle(self) -> float:
        """α_vet [rad] (eq. A.10)."""
        return transverse_pressure_angle(self.bevel.pressure_angle, self.bevel.spiral_angle)

    @cached_property
    def base_helix_angle(self) -> float:
        """β_vb [rad] (eq. A.16)."""
        return math.asin(math.sin(self.bevel.spiral_angle) * math.cos(self.bevel.pressure_angle))

    @cached_property
    def base_diameters(self) -> tuple[float, float]:
        """d_vb [m] (eq. A.9)."""
        cosine = math.cos(self.transverse_angle)
        return self.diameters[0] * cosine, self.diameters[1] * cosine

    @cached_property
    def tip_diameters(self) -> tuple[float, float]:
        """d_va = d_v + 2 h_am [m] (eq. A.6)."""
        return self.diameters[0] + 2.0 * self.bevel.addenda[0], self.diameters[1] + 2.0 * self.bevel.addenda[1]

    @cached_property
    def teeth(self) -> tuple[float, float]:
        """z_v = z/cos δ [-] (eqs A.14, A.15)."""
        angles = self.bevel.pitch_angles
        return self.bevel.teeth[0] / math.cos(angles[0]), self.bevel.teeth[1] / math.cos(angles[1])

    @cached_property
    def normal_teeth(self) -> tuple[float, float]:
        """z_vn = z_v/(cos² β_vb cos β_v) [-] (eqs A.41, A.42)."""
        cosine = math.cos(self.base_helix_angle) ** 2 * math.cos(self.bevel.spiral_angle)
        return self.teeth[0] / cosine, self.teeth[1] / cosine

    @cached_property
    def base_pitch(self) -> float:
        """p_vet [m] (eq. A.17)."""
        return math.pi * self.bevel.mean_module * math.cos(self.transverse_angle) / math.cos(self.bevel.spiral_angle)

    @cached_property
    def path(self) -> float:
        """Length of the path of contact g_vα [m] (eq. A.18)."""
        sine = math.sin(self.transverse_angle)
        return sum(
            0.5 * (math.sqrt(tip**2 - base**2) - pitch * sine)
            for tip, base, pitch in zip(self.tip_diameters, self.base_diameters, self.diameters, strict=True)
        )

    @cached_property
    def effective_width(self) -> float:
        """b_v,eff [m] (eq. A.19 without offset)."""
        return EFFECTIVE_WIDTH * self.bevel.face_width

    @cached_property
    def profile_ratio(self) -> float:
        """ε_vα [-] (eq. A.23)."""
        return self.path / self.base_pitch

    @cached_property
    def face_ratio(self) -> float:
        """ε_vβ [-] (eq. A.24)."""
        return self.effective_width * math.sin(self.bevel.spiral_angle) / (math.pi * self.bevel.mean_module)

    @cached_property
    def total_ratio(self) -> float:
        """ε_vγ = ε_vα + ε_vβ [-] (eq. A.25)."""
        return self.profile_ratio + self.face_ratio

    @cached_property
    def curvature(self) -> float:
        """Radius of relative curvature normal to the contact line ρ_rel [m] (eqs A.37 to A.39)."""
        pair = self.bevel
        cones = sum(1.0 / (pair.mean_cone_distance * math.tan(angle)) for angle in pair.pitch_angles)
        normal = math.sin(pair.pressure_angle) / (math.cos(pair.spiral_angle) ** 2 * cones)
        return normal * math.cos(math.atan(math.tan(pair.spiral_angle) * math.sin(pair.pressure_angle))) ** 2

    @cached_property
    def lines(self) -> tuple[ContactLine, ContactLine, ContactLine]:
        """Contact lines at the tip, in the middle and at the root (table A.2, eqs A.26 to A.36)."""
        step = self.base_pitch * math.cos(self.base_helix_angle)
        middle = -step * (1.0 - 0.5 * self.profile_ratio) * (1.0 - self.face_ratio) if self.face_ratio < 1.0 else 0.0
        return self._line(middle + step), self._line(middle), self._line(middle - step)

    @cached_property
    def furthest(self) -> float:
        """Distance from the middle of the zone beyond which no line bears f_max [m]."""
        helix = self.base_helix_angle
        return 0.5 * (self.path + self.effective_width * math.tan(helix)) * math.cos(helix)

    def load_share(self, place: float) -> float:
        """Return the line load at a point of the path over that of one line across the face that bears all [-].

        Args:
            place: Distance of the point from the middle of the path of contact, along it, at mid-face [m].

        Source: ISO 10300-1:2023, annex A: lines one base pitch apart share the load as A* ~ p* l_b, p* = 1 −
            |f/f_max|^e_LS, which is p* (b_v,eff/cos β_vb)/Σ(p* l_b) or 1/ε_vα where all lines bear alike; along a line
            it fades as half an ellipse, whose peak over its mean is left to K_Hβ.
        """
        step = self.base_pitch * math.cos(self.base_helix_angle)
        here = place * math.cos(self.base_helix_angle)
        count = math.ceil(2.0 * self.furthest / step)
        lines = [self._line(here + number * step) for number in range(-count, count + 1)]
        borne = sum(line.peak * line.length for line in lines)
        start, end = self._ends(here)
        beside = min(abs(self.effective_width - start - end) / max(end - start, 1e-12 * self.effective_width), 1.0)
        across = self.effective_width / math.cos(self.base_helix_angle)
        return lines[count].peak * math.sqrt(1.0 - beside**2) * across / borne

    def _ends(self, distance: float) -> tuple[float, float]:
        """Ends of a contact line along the face [m]; those of a line out of the zone are one place."""
        helix, width = self.base_helix_angle, self.effective_width
        if helix <= 1e-9:
            return 0.0, width
        centre = 0.5 * width + distance / math.sin(helix)
        reach = 0.5 * self.path / math.tan(helix)
        start = max(centre - reach, 0.0)
        return start, max(min(centre + reach, width), start)

    def _line(self, distance: float) -> ContactLine:
        """One contact line, clipped at the edges of the zone of action."""
        part = min(abs(distance) / self.furthest, 1.0)
        start, end = self._ends(distance)
        length = (end - start) / math.cos(self.base_helix_angle)
        shortened = (1.0 - math.sqrt(EFFECTIVE_WIDTH)) * math.sqrt(1.0 - part**2)
        return ContactLine(distance, length * (1.0 - shortened), 1.0 - part**self.peak_exponent)

    @cached_property
    def load_sharing(self) -> float:
        """Z_LS = √(A*_m/(A*_t + A*_m + A*_r)) [-] (ISO 10300-2:2023, eqs 7 to 10)."""
        areas = [line.peak * line.length for line in self.lines]
        return math.sqrt(areas[1] / sum(areas))


def virtual_mesh(virtual: VirtualPair) -> MeshGeometry:
    """Return the virtual cylindrical gears as methods for cylindrical gears take them, with the part that bears.

    Args:
        virtual: The virtual pair.

    Source: ISO 10300-1:2023, annex A: z_v, d_va and a_v = (d_v1 + d_v2)/2; face 0.85 b.
    """
    first, second = virtual.tip_diameters
    return MeshGeometry(
        virtual.teeth,
        virtual.bevel.mean_module,
        virtual.effective_width,
        0.5 * sum(virtual.diameters),
        (0.5 * first, 0.5 * second),
        helix_angle=virtual.bevel.spiral_angle,
        pressure_angle=virtual.bevel.pressure_angle,
    )


# ----------------------------------------------------------------------------------------------------------------------
# Pitting and load factors of bevel gears by ISO 10300-1 and -2:2023, method B1, without hypoid offset.
# ----------------------------------------------------------------------------------------------------------------------


_PART1, _PART2 = "ISO 10300-1:2023", "ISO 10300-2:2023"
BEVEL_FACTOR = 1.2
"""Bevel gear factor Z_KP [-] (ISO 10300-2:2023, eq. 11)."""
STRADDLE, ONE_OVERHUNG, BOTH_OVERHUNG = 1.05, 1.10, 1.25
"""Mounting factor K_Hβ-be with the contact pattern checked under light load [-] (ISO 10300-1, table 4)."""
_STIFFNESS = 20e9  # N/m², mean mesh stiffness c_γ0 (ISO 10300-1, 7.7)
_SINGLE_STIFFNESS = 14e9  # N/m², c′_0
_STEEL = 210e9  # Pa, E of the steel for which both are printed (ISO/TR 10300-30, sample 1)
_FULL_LOAD = 100e3  # N/m
_MICRON = 1e-6


@dataclass(frozen=True)
class BevelDuty:
    """What the mesh carries and how it is made."""

    pinion_torque: float
    """T_1 [N m]."""
    pinion_speed: float
    """ω_1 [rad/s]."""
    pitch_deviation: float
    """Single pitch deviation of the wheel f_pt [m]."""
    application_factor: float = 1.0
    """K_A [-]."""
    mounting: float = ONE_OVERHUNG
    """K_Hβ-be [-]."""
    cutter_radius: float = math.inf
    """Cutter radius r_c0 [m]; matters below the mean cone distance."""

    def __post_init__(self) -> None:
        refuse(
            Problem(name, f"{value:.6g} given; must be above 0")
            for name, value in (
                ("pinion_torque", self.pinion_torque),
                ("pinion_speed", abs(self.pinion_speed)),
                ("pitch_deviation", self.pitch_deviation),
                ("application_factor", self.application_factor),
                ("mounting", self.mounting),
                ("cutter_radius", self.cutter_radius),
            )
            if not value > 0.0
        )


@dataclass(frozen=True)
class BevelDynamics:
    """K_V of a bevel pair and what it is made of."""

    reduced_mass: Annotated[float, Quantity("mass_per_length"), Origin("m_red", f"{_PART1}, eq. 10")]
    """Reduced mass per face width m_red [kg/m]."""
    resonance_ratio: Annotated[float, Quantity("ratio"), Origin("N = n_1/n_E1", f"{_PART1}, eq. 8")]
    """Reference speed N [-]."""
    pitch_deviation: Annotated[float, Quantity("length"), Origin("f_p,eff = f_pt − y_α", f"{_PART1}, eq. 17")]
    """Effective pitch deviation [m]."""
    factor: Annotated[float, Quantity("ratio"), Origin("K_V-B", f"{_PART1}, eqs 15 to 21")]
    """Dynamic factor K_V [-]."""


@dataclass(frozen=True)
class BevelPitting:
    """Contact stress and its limit for both gears."""

    mid_zone: Annotated[float, Quantity("ratio"), Origin("Z_M-B", f"{_PART2}, eq. 6")]
    """Mid-zone factor Z_M-B [-]."""
    load_sharing: Annotated[float, Quantity("ratio"), Origin("Z_LS", f"{_PART2}, eq. 10")]
    """Load sharing factor Z_LS [-]."""
    elasticity: Annotated[float, Quantity("elasticity_factor"), Origin("Z_E", f"{_PART2}, eq. 51")]
    """Elasticity factor Z_E [√Pa]."""
    film: Annotated[tuple[float, float, float], Quantity("ratio"), Origin("Z_L, Z_v, Z_R", f"{_PART2}, eqs 54 to 60")]
    """Z_L, Z_v, Z_R [-]."""
    nominal_stress: Annotated[
        float, Quantity("stress"), Origin("σ_H0 = √(F_n/(l_bm ρ_rel)) Z_M-B Z_LS Z_E", f"{_PART2}, eq. 2")
    ]
    """Nominal contact stress σ_H0 [Pa]."""
    stress: Annotated[float, Quantity("stress"), Origin("σ_H = σ_H0 √(K_A K_V K_Hβ K_Hα)", f"{_PART2}, eq. 1")]
    """Contact stress σ_H [Pa]."""
    permissible: Annotated[
        tuple[float, float],
        Quantity("stress"),
        Origin("σ_HP = σ_Hlim Z_NT Z_X Z_L Z_v Z_R Z_W Z_KP; Z_X = Z_W = 1, Z_KP = 1.2", f"{_PART2}, eq. 4"),
    ]
    """Permissible contact stress of pinion and wheel σ_HP [Pa]."""
    safeties: Annotated[tuple[float, float], Quantity("ratio"), Origin("S_H = σ_HP/σ_H", f"{_PART2}, eq. 5")]
    """S_H of pinion and wheel [-]."""


def virtual_force(pair: BevelPair, duty: BevelDuty) -> float:
    """Return the tangential force at the mean cone F_mt = F_vmt [N].

    Args:
        pair: The pair.
        duty: Torque.

    Source: ISO 10300-1:2023, eqs 1 and 2; the two are equal without offset.
    """
    return 2.0 * duty.pinion_torque / pair.mean_diameters[0]


def bevel_dynamics(virtual: VirtualPair, duty: BevelDuty, steels: tuple[GearSteel, GearSteel]) -> BevelDynamics:
    """Return K_V by method B.

    Args:
        virtual: The virtual pair.
        duty: Load, speed, deviation.
        steels: Of pinion and wheel, for their mass and stiffness.

    Source: ISO 10300-1:2023, clause 7.7.3, stiffness 14 and 20 N/(mm µm) E/E_St, y_α = 0.075 f_pt ≤ 3 µm of
        hard flanks.
    """
    pair = virtual.bevel
    specific = virtual_force(pair, duty) * duty.application_factor / virtual.effective_width
    soft = _softness(specific, steels)
    masses = [
        math.pi / 8.0 * steel.density * (d / math.cos(pair.pressure_angle)) ** 2
        for d, steel in zip(pair.mean_diameters, steels, strict=True)
    ]
    reduced = masses[0] * masses[1] / (masses[0] + masses[1])
    ratio = abs(duty.pinion_speed) * pair.teeth[0] / math.sqrt(_STIFFNESS * soft / reduced)
    deviation = duty.pitch_deviation - min(0.075 * duty.pitch_deviation, 3.0 * _MICRON)
    error = _SINGLE_STIFFNESS * soft * deviation / specific
    return BevelDynamics(reduced, ratio, deviation, _by_region(ratio, error, virtual.total_ratio))


def _softness(specific_load: float, steels: tuple[GearSteel, GearSteel]) -> float:
    """Stiffness over that of fully loaded teeth of steel [-]."""
    moduli = (steels[0].elastic_modulus, steels[1].elastic_modulus)
    return min(1.0, specific_load / _FULL_LOAD) * modulus_factor(moduli, _STEEL)


def _by_region(ratio: float, error: float, overlap: float) -> float:
    """K_V below, in, between and above the main resonance (eqs 15 to 21)."""
    if overlap <= 2.0:
        c_12, c_3, c_4, c_56 = 0.66, 0.23, 0.90, 0.94
    else:
        c_12, c_3 = 0.32 + 0.57 / (overlap - 0.3), 0.096 / (overlap - 1.56)
        c_4, c_56 = (0.57 - 0.05 * overlap) / (overlap - 1.44), 0.47 + 0.12 / (overlap - 1.74)
    middle = 0.125 * math.sin(math.pi * overlap) + 0.875  # ε_vγ − 2 in the standard: a whole turn less
    c_7 = 0.75 if overlap <= 1.5 else middle if overlap <= 2.5 else 1.0
    resonant, above = c_12 * error + c_4 + 1.0, c_56 * error + c_7
    if ratio <= 0.75:
        return ratio * (c_12 * error + c_3) + 1.0
    if ratio <= 1.25:
        return resonant
    return above if ratio >= 1.5 else above + (resonant - above) * (1.5 - ratio) / 0.25


def bevel_load_factors(
    virtual: VirtualPair, duty: BevelDuty, steels: tuple[GearSteel, GearSteel]
) -> tuple[ToothLoadFactors, BevelDynamics]:
    """Return the K factors of a bevel pair.

    Args:
        virtual: The virtual pair.
        duty: Load, speed, deviation, mounting, cutter.
        steels: Of pinion and wheel.

    Source: ISO 10300-1:2023, clauses 7 (K_V method B), 8 (K_Hβ = 1.5 K_Hβ-be, K_Fβ = K_Hβ/K_F0) and 9 (K_Hα method B).
    """
    pair = virtual.bevel
    dynamic = bevel_dynamics(virtual, duty, steels)
    face = 1.5 * duty.mounting
    force = virtual_force(pair, duty) * duty.application_factor
    stiffness = _STIFFNESS * _softness(force / virtual.effective_width, steels)
    error = stiffness * dynamic.pitch_deviation * pair.face_width / (force * dynamic.factor * face)
    total = virtual.total_ratio
    if total <= 2.0:
        share = 0.5 * total * (0.9 + 0.4 * error)
    else:
        share = 0.9 + 0.4 * math.sqrt(2.0 * (total - 1.0) / total) * error
    alpha = max(1.0, share)
    factors = ToothLoadFactors(
        duty.application_factor, 1.0, dynamic.factor, face, alpha, face / _lengthwise_curvature(pair, duty), alpha
    )
    return factors, dynamic


def _lengthwise_curvature(pair: BevelPair, duty: BevelDuty) -> float:
    """K_F0 (eqs 33 to 35): 1 for straight teeth and large cutters, else 1 to 1.15."""
    ratio = duty.cutter_radius / pair.mean_cone_distance
    if pair.spiral_angle == 0.0 or ratio > 1.0:
        return 1.0
    exponent = 0.279 / math.log10(math.sin(pair.spiral_angle))
    return min(max(0.211 * math.exp(exponent * math.log(ratio)) + 0.789, 1.0), 1.15)


def mid_zone_factor(virtual: VirtualPair) -> float:
    """Return the mid-zone factor Z_M-B.

    Args:
        virtual: The virtual pair.

    Source: ISO 10300-2:2023, eq. 6 and table 4.
    """
    alpha, beta = virtual.profile_ratio, min(virtual.face_ratio, 1.0)
    first = 2.0 + (alpha - 2.0) * beta
    second = 2.0 * alpha - 2.0 + (2.0 - alpha) * beta
    product = 1.0
    for tip, base, teeth, turns in zip(
        virtual.tip_diameters, virtual.base_diameters, virtual.teeth, (first, second), strict=True
    ):
        product *= math.sqrt((tip / base) ** 2 - 1.0) - turns * math.pi / teeth
    return math.tan(virtual.transverse_angle) / math.sqrt(product)


def bevel_pitting(
    virtual: VirtualPair,
    steels: tuple[GearSteel, GearSteel],
    duty: BevelDuty,
    *,
    loads: ToothLoadFactors,
    lives: tuple[float, float],
    viscosity: float = 100e-6,
    roughness: float = 8e-6,
) -> BevelPitting:
    """Return contact stress, limit and safety of both gears.

    Args:
        virtual: The virtual pair.
        steels: Of pinion and wheel.
        duty: Torque and speed.
        loads: K factors.
        lives: Z_NT of pinion and wheel [-].
        viscosity: ν_40 of the oil [m²/s].
        roughness: Mean R_z of the flanks [m].

    Source: ISO 10300-2:2023, clause 6, with Z_W = Z_X = Z_Hyp = 1 and Z_KP = 1.2.
    Valid for: ε_vα < 2, no hypoid offset, hardened flanks of about equal hardness.
    """
    pair = virtual.bevel
    force = virtual_force(pair, duty) / (math.cos(pair.pressure_angle) * math.cos(pair.spiral_angle))
    speed = 0.5 * abs(duty.pinion_speed) * pair.mean_diameters[0]
    softer = min(steel.tabulated_strength for steel in steels)
    film = (
        float(lubricant_factor(viscosity, softer)),
        float(speed_factor(speed, softer)),
        float(roughness_factor(roughness, virtual.curvature, softer)),
    )
    mid, sharing, elastic = mid_zone_factor(virtual), virtual.load_sharing, elasticity_factor(steels)
    nominal = math.sqrt(force / (virtual.lines[1].length * virtual.curvature)) * mid * sharing * elastic
    stress = nominal * float(np.sqrt(loads.contact))
    pinion, wheel = (
        steel.contact_strength * life * math.prod(film) * BEVEL_FACTOR
        for steel, life in zip(steels, lives, strict=True)
    )
    return BevelPitting(
        mid, sharing, elastic, film, nominal, stress, (pinion, wheel), (pinion / stress, wheel / stress)
    )


# ----------------------------------------------------------------------------------------------------------------------
# Tooth bending of bevel gears by ISO 10300-3:2023, method B1, generated teeth without hypoid offset.
# ----------------------------------------------------------------------------------------------------------------------


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
    loads: ToothLoadFactors,
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


# ----------------------------------------------------------------------------------------------------------------------
# Rating of one bevel pair by ISO 10300 parts 1 to 3, method B1, in one call, every factor shown.
# ----------------------------------------------------------------------------------------------------------------------


_MM, _FLANK_MICRON = 1e-3, 1e-6


@dataclass(frozen=True)
class BevelSurfaces:
    """Flanks, roots and oil of a bevel pair."""

    flank_roughness: float = 4e-6
    """Mean R_z of the flanks [m]."""
    root_roughness: float = 10e-6
    """R_z of the roots [m]."""
    viscosity: float = 100e-6
    """ν_40 of the oil [m²/s]."""
    peak_exponent: float = HIGH_CROWNING
    """Exponent of the load over the zone of contact e_LS [-], of how much the flanks are crowned."""


@dataclass(frozen=True)
class BevelRating:
    """A rated bevel pair: loads, factors, stresses, safeties."""

    virtual: VirtualPair
    """The cylindrical pair at the mean cone that stands for it."""
    tangential_force: Annotated[float, Quantity("force"), Origin("F_mt = 2 T_1/d_m1", "ISO 10300-1:2023, eq. 1")]
    """Nominal tangential force at the mean cone F_mt [N]."""
    speed: Annotated[float, Quantity("velocity"), Origin("v_mt = ω_1 d_m1/2", "ISO 10300-1:2023")]
    """Velocity at the mean diameters v_mt [m/s]."""
    cycles: Annotated[tuple[float, float], Quantity("number"), Origin("N_L", "ISO 10300-2:2023")]
    """Load cycles of pinion and wheel N_L [-]."""
    dynamic: BevelDynamics
    """K_V and its terms."""
    loads: ToothLoadFactors
    """All K factors."""
    contact_life: Annotated[tuple[float, float], Quantity("ratio"), Origin("Z_NT", "ISO 6336-2:2019, clause 11")]
    """Z_NT of pinion and wheel [-]."""
    root_life: Annotated[tuple[float, float], Quantity("ratio"), Origin("Y_NT", "ISO 6336-3:2019, clause 11")]
    """Y_NT of pinion and wheel [-]."""
    pitting: BevelPitting
    """Pitting."""
    bending: tuple[BevelBending, BevelBending]
    """Bending of pinion and wheel."""


def rate_bevel(
    pair: BevelPair, steels: Steels, duty: BevelDuty, life: float, *, surfaces: BevelSurfaces = BevelSurfaces()
) -> BevelRating:
    """Return the rating of a bevel pair by ISO 10300.

    Args:
        pair: The pair.
        steels: Of pinion and wheel.
        duty: Torque, speed, deviations, mounting.
        life: Required life [s].
        surfaces: Flanks, roots and oil.

    Source: ISO 10300-1, -2 and -3:2023, method B1; life factors Z_NT and Y_NT of ISO 6336-2 and -3, as ISO 10300 says.
    Valid for: ε_vα < 2, no hypoid offset, generated teeth.

    >>> from gearwright.parts.iso6336 import GearSteel, Treatment
    >>> steel = GearSteel("case-hardened", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6)
    >>> pair = BevelPair((17, 43), 8.5e-3, 51e-3, math.radians(35.0))
    >>> rated = rate_bevel(pair, (steel, steel), BevelDuty(2031.1, 158.5, 8e-6, 1.25), 3500 * 3600.0)
    >>> round(rated.tangential_force / 1e3, 1)
    32.3
    """
    virtual = VirtualPair(pair, surfaces.peak_exponent)
    loads, dynamic = bevel_load_factors(virtual, duty, steels)
    turns = abs(duty.pinion_speed) * life / (2.0 * math.pi)
    cycles = (turns, turns * pair.teeth[0] / pair.teeth[1])
    contact, root = _lives(steels, cycles)
    pitting = bevel_pitting(
        virtual,
        steels,
        duty,
        loads=loads,
        lives=contact,
        viscosity=surfaces.viscosity,
        roughness=surfaces.flank_roughness,
    )
    first, second = (
        bevel_bending(
            virtual, gear, steels[gear], duty=duty, loads=loads, life=root[gear], roughness=surfaces.root_roughness
        )
        for gear in (0, 1)
    )
    speed = 0.5 * abs(duty.pinion_speed) * pair.mean_diameters[0]
    force = virtual_force(pair, duty)
    return BevelRating(virtual, force, speed, cycles, dynamic, loads, contact, root, pitting, (first, second))


def _lives(steels: Steels, cycles: tuple[float, float]) -> tuple[tuple[float, float], tuple[float, float]]:
    """Life factors of pinion and wheel, of the flanks and of the roots."""
    first = life_curves(steels[0])
    second = first if steels[1] is steels[0] else life_curves(steels[1])
    (flank_1, flank_2), (root_1, root_2) = zip(first, second, strict=True)
    return (
        (_life(flank_1, cycles[0]), _life(flank_2, cycles[1])),
        (_life(root_1, cycles[0]), _life(root_2, cycles[1])),
    )


@lru_cache(maxsize=1024)
def _life(curve: LifeCurve, cycles: float) -> float:
    """Life factor of one gear; those of one pair in many sizes are the same."""
    return float(life_factor(curve, cycles))


def bevel_pitch_tolerance(diameter: float, module: float, grade: int) -> float:
    """Return the single pitch tolerance of a bevel gear f_ptT [m].

    Args:
        diameter: Mean pitch diameter of the gear d_m [m].
        module: Mean normal module m_mn [m].
        grade: Accuracy grade B, 2 to 11 [-].

    Source: ISO 17485:2006, 5.4: (0.003 d_T + 0.3 m_mn + 5) √2^(B−4), before rounding.

    >>> round(1e6 * bevel_pitch_tolerance(152.987e-3, 3.213e-3, 8))
    26
    """
    return float(_FLANK_MICRON * (0.003 * diameter / _MM + 0.3 * module / _MM + 5.0) * math.sqrt(2.0) ** (grade - 4))
