"""What a bevel mesh is asked, how it is made, and the factors of ANSI/AGMA 2003 that both of its gears share."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from gearwright.parts.agma2001 import (
    dynamic_factor_agma,
    elastic_coefficient,
    hardness_ratio_factor,
    reliability_factor,
)
from gearwright.parts.agma2003.factors import (
    BENDING,
    BENDING_CRITICAL,
    CONTACT,
    CROWNED,
    ONE_STRADDLE,
    REVERSED,
    BevelEdition,
    BevelStrength,
    lengthwise_curvature,
    load_distribution,
    size_factor_bending,
    size_factor_contact,
    temperature_factor,
)
from gearwright.parts.agma2003.section import SOURCE
from gearwright.parts.bevel import BevelPair
from gearwright.parts.iso6336 import LifeCurve, life_factor
from gearwright.units import Origin, Quantity

Both = tuple[float, float]
"""Of pinion and wheel."""


@dataclass(frozen=True)
class AgmaBevelDuty:
    """What a bevel mesh carries."""

    torque: float
    """On the pinion, of one mesh T_1 [N m]."""
    speed: float
    """Of the pinion ω_1 [rad/s]."""
    life: float
    """Time under that load [s]."""
    overload: float = 1.0
    """K_o [-]."""
    meshes_per_turn: Both = (1.0, 1.0)
    """Mates that a tooth of each gear meets in a turn [-]."""
    is_reversed: tuple[bool, bool] = (False, False)
    """Which gear is loaded on both flanks."""


@dataclass(frozen=True)
class AgmaBevelMaking:
    """How both gears are made and mounted, and of what."""

    strengths: tuple[BevelStrength, BevelStrength]
    """Allowable stress numbers of pinion and wheel."""
    hardnesses: Both | None = None
    """HB of pinion and wheel where both are through-hardened, for C_H [-]; None: C_H = 1."""
    elastic_modulus: float = 207e9
    """E [Pa]."""
    poisson_ratio: float = 0.3
    """ν [-]."""
    quality: int = 11
    """Transmission accuracy Q_v [-]."""
    mounting: float = ONE_STRADDLE
    """K_mb [-]."""
    crowning: float = CROWNED
    """C_xc [-]."""
    cutter_radius: float = math.inf
    """r_c0 [m]."""
    reliability: float = 0.99
    """Part of the gears that survive [-]."""
    temperature: float = 80.0
    """Of the gear blanks [°C]."""
    is_critical: bool = False
    """K_L by the lower edge of its band."""
    edition: BevelEdition = BevelEdition.D19
    """Whose C_s."""

    @property
    def bending_curve(self) -> LifeCurve:
        """K_L over cycles."""
        return BENDING_CRITICAL if self.is_critical else BENDING


@dataclass(frozen=True)
class AgmaBevelFactors:
    """Load, speed, cycles and the factors on them."""

    tangential_force: Annotated[float, Quantity("force"), Origin("W_t = 2 T_1/d_e1", f"{SOURCE}, clause 6")]
    """At the outer pitch circle W_t [N]."""
    speed: Annotated[float, Quantity("velocity"), Origin("v_et = ω_1 d_e1/2", f"{SOURCE}, eq. 16")]
    """Velocity of the outer pitch circle [m/s]."""
    cycles: Annotated[Both, Quantity("number"), Origin("N = ω L q/(2 π)", f"{SOURCE}, clause 16")]
    """Stress cycles of both gears [-]."""
    overload: Annotated[float, Quantity("ratio"), Origin("K_o", f"{SOURCE}, clause 7")]
    """[-]"""
    dynamic: Annotated[float, Quantity("ratio"), Origin("K_v = ((A + √V)/A)^B", f"{SOURCE}, eqs 13 to 15")]
    """[-]"""
    distribution: Annotated[float, Quantity("ratio"), Origin("K_m = K_mb + 0.0036 F²", f"{SOURCE}, eq. 20")]
    """[-]"""
    size_contact: Annotated[float, Quantity("ratio"), Origin("C_s = 0.125 F + 0.4375", f"{SOURCE}, eq. 18")]
    """[-]"""
    size_bending: Annotated[float, Quantity("ratio"), Origin("K_s = 0.4867 + 0.2132/P_d", f"{SOURCE}, eq. 19")]
    """[-]"""
    crowning: Annotated[float, Quantity("ratio"), Origin("C_xc", f"{SOURCE}, clause 13")]
    """[-]"""
    curvature: Annotated[
        float, Quantity("ratio"), Origin("K_x = 0.211 (r_c0/R_m)^q + 0.789", f"{SOURCE}, eqs 21 to 23")
    ]
    """[-]"""
    elastic: Annotated[float, Quantity("elasticity_factor"), Origin("C_p", f"{SOURCE}, eq. 32")]
    """[√Pa]"""
    contact_cycles: Annotated[Both, Quantity("ratio"), Origin("C_L", f"{SOURCE}, figure 5")]
    """Of both gears [-]."""
    bending_cycles: Annotated[Both, Quantity("ratio"), Origin("K_L", f"{SOURCE}, figure 6")]
    """Of both gears [-]."""
    hardness_ratio: Annotated[Both, Quantity("ratio"), Origin("C_H = 1 + B_1 (z_2/z_1 − 1)", f"{SOURCE}, clause 17")]
    """Of both gears; 1 of the pinion [-]."""
    reversal: Annotated[Both, Quantity("ratio"), Origin("0.7 where both flanks are loaded", f"{SOURCE}, clause 21")]
    """Of both gears [-]."""
    reliability_contact: Annotated[float, Quantity("ratio"), Origin("C_R = √K_R", f"{SOURCE}, clause 19")]
    """[-]"""
    reliability_bending: Annotated[float, Quantity("ratio"), Origin("K_R", f"{SOURCE}, table 2")]
    """[-]"""
    temperature: Annotated[float, Quantity("ratio"), Origin("K_T", f"{SOURCE}, eq. 31")]
    """[-]"""


def bevel_factors(pair: BevelPair, duty: AgmaBevelDuty, making: AgmaBevelMaking) -> AgmaBevelFactors:
    """Return the factors of a bevel mesh.

    Args:
        pair: The pair.
        duty: Torque, speed, life.
        making: Steel, accuracy, mounting.

    Source: ANSI/AGMA 2003-D19, clauses 6 to 20; C_R as the root of K_R, as Shigley 9th ed., eq. 15-20.

    Raises:
        DesignError: A face above 356 mm.
    """
    diameter, ratio = pair.outer_diameters[0], pair.teeth[1] / pair.teeth[0]
    turns, speed = abs(duty.speed) * duty.life / (2.0 * math.pi), 0.5 * abs(duty.speed) * diameter
    cycles = turns * duty.meshes_per_turn[0], turns * duty.meshes_per_turn[1] / ratio
    survival = float(reliability_factor(making.reliability))
    softer = 1.0 if making.hardnesses is None else hardness_ratio_factor(*making.hardnesses, ratio)
    return AgmaBevelFactors(
        tangential_force=2.0 * duty.torque / diameter,
        speed=speed,
        cycles=cycles,
        overload=duty.overload,
        dynamic=float(dynamic_factor_agma(speed, making.quality)),
        distribution=load_distribution(pair.face_width, making.mounting),
        size_contact=size_factor_contact(pair.face_width, making.edition),
        size_bending=size_factor_bending(pair.outer_module),
        crowning=making.crowning,
        curvature=lengthwise_curvature(pair.spiral_angle, making.cutter_radius, pair.mean_cone_distance),
        elastic=elastic_coefficient((making.elastic_modulus,) * 2, (making.poisson_ratio,) * 2),
        contact_cycles=_factors(CONTACT, cycles),
        bending_cycles=_factors(making.bending_curve, cycles),
        hardness_ratio=(1.0, softer),
        reversal=(REVERSED if duty.is_reversed[0] else 1.0, REVERSED if duty.is_reversed[1] else 1.0),
        reliability_contact=math.sqrt(survival),
        reliability_bending=survival,
        temperature=temperature_factor(making.temperature),
    )


def _factors(curve: LifeCurve, cycles: Both) -> Both:
    first, second = (float(life_factor(curve, count)) for count in cycles)
    return first, second
