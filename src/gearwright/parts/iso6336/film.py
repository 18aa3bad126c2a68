"""Lubricant film factors Z_L, Z_v, Z_R and work hardening Z_W of ISO 6336-2."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from gearwright.parts.iso6336.geometry import Value, as_value
from gearwright.parts.iso6336.steels import Treatment

_MPA = 1e6
_MM2_S = 1e-6
_MICRON = 1e-6
SMOOTH = 3.0 * _MICRON
"""R_zH at which a hard flank works its mate best; Z_W has its full value [m]."""
RZ_OVER_RA = 6.0
"""R_z over R_a of ground flanks [-] (ISO 6336-2:2019, clause 12)."""


def _film_constant(contact_strength: Value, at_850: float, at_1200: float) -> Value:
    """Constant that runs linearly between σ_Hlim of 850 and 1200 N/mm²."""
    if isinstance(contact_strength, float):
        return _constant_of_one(contact_strength, at_850, at_1200)
    return _constant(contact_strength, at_850, at_1200)


@lru_cache(maxsize=256)
def _constant_of_one(contact_strength: float, at_850: float, at_1200: float) -> Value:
    """The same of one steel, which many pairs have."""
    return _constant(contact_strength, at_850, at_1200)


def _constant(contact_strength: Value, at_850: float, at_1200: float) -> Value:
    strength = np.asarray(contact_strength) / _MPA
    part = (np.minimum(np.maximum(strength, 850.0), 1200.0) - 850.0) / 350.0
    return as_value(at_850 + (at_1200 - at_850) * part)


def lubricant_factor(viscosity: Value, contact_strength: Value) -> Value:
    """Return the lubricant factor Z_L of mineral oils.

    Args:
        viscosity: Kinematic viscosity at 40 °C ν_40 [m²/s].
        contact_strength: σ_Hlim of the softer gear [Pa].

    Source: ISO 6336-2:2006, clause 12.3.1.

    >>> round(float(lubricant_factor(320e-6, 1500e6)), 5)
    1.04739
    """
    constant = _film_constant(contact_strength, 0.83, 0.91)
    return constant + 4.0 * (1.0 - constant) / (1.2 + 134.0 * _MM2_S / viscosity) ** 2


def speed_factor(speed: Value, contact_strength: Value) -> Value:
    """Return the velocity factor Z_v.

    Args:
        speed: Pitch-line velocity v [m/s].
        contact_strength: σ_Hlim of the softer gear [Pa].

    Source: ISO 6336-2:2006, clause 12.3.2, C_Zv = C_ZL + 0.02.

    >>> round(float(speed_factor(2.6642, 1500e6)), 5)
    0.96911
    """
    constant = _film_constant(contact_strength, 0.85, 0.93)
    return constant + 2.0 * (1.0 - constant) / np.sqrt(0.8 + 32.0 / speed)


def roughness_factor(roughness: Value, curvature: Value, contact_strength: Value) -> Value:
    """Return the roughness factor Z_R.

    Args:
        roughness: Mean R_z of the two flanks [m]; R_z ≈ 6 R_a where only R_a is known.
        curvature: ρ_red at the pitch point [m].
        contact_strength: σ_Hlim of the softer gear [Pa].

    Source: ISO 6336-2:2006, clause 12.3.3, (3 µm/R_z10)^C_ZR with R_z10 = R_z (10 mm/ρ_red)^(1/3).
    """
    exponent = _film_constant(contact_strength, 0.15, 0.08)
    relative = roughness / _MICRON * (10e-3 / curvature) ** (1.0 / 3.0)
    return (3.0 / relative) ** exponent


def equivalent_roughness(flanks: tuple[Value, Value], curvature: Value, *, viscosity: Value, speed: Value) -> Value:
    """Return the equivalent roughness R_zH of a hard flank, by which it works the soft flank of its mate [m].

    Args:
        flanks: R_z of the hard gear and of the soft one, before running in [m].
        curvature: ρ_red at the pitch point [m].
        viscosity: ν_40 [m²/s].
        speed: Pitch-line velocity v [m/s].

    Returns:
        R_zH [m], held between 3 and 16 µm.

    Source: ISO 6336-2:2006, clause 13.3.2: R_z1 (10 mm/ρ_red)^0.33 (R_z1/R_z2)^0.66 / (ν_40 v/1500)^0.33.

    >>> hard = equivalent_roughness((4.8e-6, 8e-6), 173e-3, viscosity=220e-6, speed=1.0)
    >>> round(float(hard) / 1e-6, 2)  # a smooth flank of a wind turbine's planet
    3.0
    """
    hard, soft = flanks
    running_in = (10e-3 / curvature) ** 0.33 * (hard / soft) ** 0.66
    film = (viscosity / _MM2_S * speed / 1500.0) ** 0.33
    return as_value(np.clip(hard * running_in / film, SMOOTH, 16.0 * _MICRON))


def contact_size_factor(module: Value, treatment: Treatment) -> Value:
    """Return the size factor Z_X of DIN 3990; ISO 6336-2 leaves it at 1.

    Args:
        module: m_n [m].
        treatment: Material group.

    Source: DIN 3990-2:1987, table 4: 1.05 − 0.005 m_n from 10 mm for case- and induction-hardened, 1.08 − 0.011 m_n
        from 7.5 mm for nitrided gears, to 30 mm; 1 for others.

    >>> round(float(contact_size_factor(16e-3, Treatment.CASE_HARDENED)), 3)
    0.97
    """
    if not treatment.is_surface_hardened:
        return 1.0
    size = np.minimum(module / 1e-3, 30.0)
    return as_value(np.minimum(1.0, 1.08 - 0.011 * size if treatment.is_nitrided else 1.05 - 0.005 * size))


def work_hardening_factor(
    hardness: float,
    treatments: tuple[Treatment, Treatment],
    *,
    mate_hardness: float,
    mate_roughness: Value,
    ratio: Value,
) -> Value:
    """Return the work hardening factor Z_W of a gear.

    Args:
        hardness: Brinell hardness of this gear HB [-].
        treatments: Of this gear and of its mate.
        mate_hardness: Brinell hardness of the mate [-].
        mate_roughness: `equivalent_roughness` R_zH of the mate [m].
        ratio: |u| [-].

    Returns:
        Z_W [-]; 1 unless this gear is of soft steel and its steel mate is hard or clearly harder.

    Source: ISO 6336-2:2006, clause 13: 1.2 − (HB − 130)/1700 times (3 µm/R_zH)^0.15 against a hard mate;
        1 + (0.00898 HB_1/HB_2 − 0.00829)(u − 1) between through-hardened gears.
    """
    treatment, mate_treatment = treatments
    if treatment.is_surface_hardened or treatment.is_cast_iron or mate_treatment.is_cast_iron:
        return 1.0
    if mate_treatment.is_surface_hardened:
        base = 1.2 - (min(max(hardness, 130.0), 470.0) - 130.0) / 1700.0
        return as_value(np.maximum(1.0, base * (SMOOTH / np.asarray(mate_roughness)) ** 0.15))
    harder = mate_hardness / hardness
    if harder < 1.2:
        return 1.0
    slope = 0.00698 if harder > 1.7 else 0.00898 * harder - 0.00829
    return 1.0 + slope * (np.minimum(ratio, 20.0) - 1.0)
