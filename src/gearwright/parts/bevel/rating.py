"""Rating of one bevel pair by ISO 10300 parts 1 to 3, method B1, in one call, every factor shown."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated

from gearwright.parts.bevel.bending import BevelBending, bevel_bending
from gearwright.parts.bevel.geometry import BevelPair
from gearwright.parts.bevel.pitting import (
    BevelDuty,
    BevelDynamics,
    BevelPitting,
    bevel_load_factors,
    bevel_pitting,
    virtual_force,
)
from gearwright.parts.bevel.virtual import HIGH_CROWNING, VirtualPair
from gearwright.parts.iso6336 import LifeCurve, LoadFactors, Steels, life_curves, life_factor
from gearwright.units import Origin, Quantity

_MM, _MICRON = 1e-3, 1e-6


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
    loads: LoadFactors
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
    return float(_MICRON * (0.003 * diameter / _MM + 0.3 * module / _MM + 5.0) * math.sqrt(2.0) ** (grade - 4))
