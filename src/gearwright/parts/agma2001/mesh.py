"""Rating of one external cylindrical mesh by ANSI/AGMA 2001-D04 in one call, every factor shown."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.parts.agma2001.factors import (
    COMMERCIAL,
    Mounting,
    dynamic_factor_agma,
    load_distribution_factor,
    reliability_factor,
    size_factor,
)
from gearwright.parts.agma2001.geometry import BendingGeometry, HobbedPair, bending_geometry, pitting_geometry_factor
from gearwright.parts.agma2001.hardness import Hardnesses, hardness_ratio_of
from gearwright.parts.agma2001.rating import (
    AgmaGear,
    AgmaLoad,
    AgmaMesh,
    AgmaRating,
    AgmaStrength,
    agma_rating,
    elastic_coefficient,
)
from gearwright.parts.gears import lewis_form_factor
from gearwright.parts.iso6336 import LifeCurve, Value, life_factor
from gearwright.units import FOOT, Origin, Quantity

_SOURCE = "ANSI/AGMA 2001-D04"


@dataclass(frozen=True)
class AgmaDuty:
    """What a mesh carries."""

    torque: Value
    """On the pinion, of one mesh [N m]."""
    speed: Value
    """Of the pinion against the carrier [rad/s]."""
    life: Value
    """Time under that load [s]."""
    overload: float = 1.0
    """K_o [-]."""
    meshes_per_turn: tuple[float, float] = (1.0, 1.0)
    """Mates that a tooth of each gear meets in a turn [-]."""


@dataclass(frozen=True)
class AgmaWheel:
    """A steel of the gear that is another than the pinion's."""

    strength: AgmaStrength
    """Allowable stress numbers."""
    bending_curve: LifeCurve
    """Y_N over cycles."""
    contact_curve: LifeCurve
    """Z_N over cycles."""
    hardnesses: Hardnesses
    """Of both gears, for C_H."""


@dataclass(frozen=True)
class AgmaMaking:
    """How both gears are made and mounted, and of what."""

    strength: AgmaStrength
    """Allowable stress numbers."""
    bending_curve: LifeCurve
    """Y_N over cycles."""
    contact_curve: LifeCurve
    """Z_N over cycles."""
    elastic_modulus: float
    """E [Pa]."""
    poisson_ratio: float
    """ν [-]."""
    quality: int = 11
    """Transmission accuracy Q_v [-]."""
    mounting: Mounting = COMMERCIAL
    """Constants of C_ma."""
    crowning: float = 1.0
    """C_mc [-]."""
    adjustment: float = 1.0
    """C_e [-]."""
    reliability: float = 0.99
    """Part of the gears that survive [-]."""
    temperature: float = 1.0
    """K_T [-]."""
    wheel: AgmaWheel | None = None
    """Steel of the gear where it is another than the pinion's."""
    rims: tuple[Value, Value] = (1.0, 1.0)
    """K_B of pinion and gear [-]."""

    def strength_of(self, gear: int) -> AgmaStrength:
        """Return the allowable stress numbers of one gear.

        Args:
            gear: 0 for the pinion, 1 for the gear.
        """
        return self.strength if gear == 0 or self.wheel is None else self.wheel.strength

    def curves_of(self, gear: int) -> tuple[LifeCurve, LifeCurve]:
        """Return Z_N and Y_N of one gear over cycles.

        Args:
            gear: 0 for the pinion, 1 for the gear.
        """
        own: AgmaMaking | AgmaWheel = self if gear == 0 or self.wheel is None else self.wheel
        return own.contact_curve, own.bending_curve


@dataclass(frozen=True)
class AgmaPairRating:
    """A rated mesh: loads, factors, stresses, safeties."""

    tangential_force: Annotated[Value, Quantity("force"), Origin("W_t = 2 T/d", f"{_SOURCE}, clause 7")]
    """Of one mesh, K_γ included [N]."""
    speed: Annotated[Value, Quantity("velocity"), Origin("v_t = ω d/2", f"{_SOURCE}, clause 7")]
    """Pitch-line velocity [m/s]."""
    cycles: Annotated[tuple[Value, Value], Quantity("number"), Origin("n = ω L q/(2 π)", f"{_SOURCE}, clause 17")]
    """Stress cycles of both gears [-]."""
    overload: Annotated[Value, Quantity("ratio"), Origin("K_o", f"{_SOURCE}, clause 9")]
    """[-]"""
    dynamic: Annotated[
        Value, Quantity("ratio"), Origin("K_v = ((A + √V)/A)^B", f"{_SOURCE}, clause 8; Shigley, eq. 14-27")
    ]
    """[-]"""
    distribution: Annotated[
        Value, Quantity("ratio"), Origin("K_m = 1 + C_mc (C_pf C_pm + C_ma C_e)", f"{_SOURCE}, clause 15.3")
    ]
    """[-]"""
    size: Annotated[
        tuple[Value, Value], Quantity("ratio"), Origin("K_s = 1.192 (F √Y m_t)^0.0535", "Shigley, section 14-10")
    ]
    """Of both gears [-]."""
    elastic: Annotated[float, Quantity("elasticity_factor"), Origin("C_p", f"{_SOURCE}, eq. 31")]
    """[√Pa]"""
    pitting_geometry: Annotated[Value, Quantity("ratio"), Origin("I", "AGMA 908-B89, clause 4")]
    """[-]"""
    tooth_root: tuple[BendingGeometry, BendingGeometry]
    """J and its parts of both gears."""
    bending_cycles: Annotated[tuple[Value, Value], Quantity("ratio"), Origin("Y_N", f"{_SOURCE}, clause 17")]
    """Of both gears [-]."""
    contact_cycles: Annotated[tuple[Value, Value], Quantity("ratio"), Origin("Z_N", f"{_SOURCE}, clause 17")]
    """Of both gears [-]."""
    reliability: Annotated[Value, Quantity("ratio"), Origin("K_R", f"{_SOURCE}, table 11")]
    """[-]"""
    temperature: Annotated[float, Quantity("ratio"), Origin("K_T", f"{_SOURCE}, clause 19")]
    """[-]"""
    strength: AgmaStrength
    """Of both gears, or of the pinion."""
    gears: tuple[AgmaRating, AgmaRating]
    """Stresses, limits and safeties of both gears."""
    rims: Annotated[tuple[Value, Value], Quantity("ratio"), Origin("K_B = 1.6 ln(2.242/m_B)", f"{_SOURCE}, annex B")]
    """Rim thickness factors of both gears [-]."""
    hardness_ratio: Annotated[Value, Quantity("ratio"), Origin("C_H", f"{_SOURCE}, clause 14")]
    """Hardness ratio factor of the gear [-]."""
    wheel_strength: AgmaStrength | None
    """Of the gear where its steel is another."""


def rate_agma(pair: HobbedPair, module: Value, duty: AgmaDuty, making: AgmaMaking) -> AgmaPairRating:
    """Return the rating of one mesh or of an array of them.

    Args:
        pair: In normal modules, pinion first.
        module: m_n [m].
        duty: Torque, speed, life.
        making: Steel, accuracy, mounting.

    Source: ANSI/AGMA 2001-D04, clauses 5 to 20, with I and J of AGMA 908-B89; C_f = 1.
    Valid for: external gears on the standard centre distance.
    """
    width, transverse = pair.face_width * module, module / np.cos(pair.helix_angle)
    diameter = 2.0 * pair.radii[0] * module
    force, speed = 2.0 * duty.torque / diameter, 0.5 * np.abs(duty.speed) * diameter
    turns = np.abs(duty.speed) * duty.life / (2.0 * np.pi)
    ratio = pair.teeth[1] / pair.teeth[0]
    cycles = turns * duty.meshes_per_turn[0], turns * duty.meshes_per_turn[1] / ratio
    load = AgmaLoad(
        force,
        duty.overload,
        dynamic_factor_agma(speed, making.quality),
        load_distribution_factor(
            width, diameter, mounting=making.mounting, crowning=making.crowning, adjustment=making.adjustment
        ),
    )
    elastic = elastic_coefficient((making.elastic_modulus,) * 2, (making.poisson_ratio,) * 2)
    mesh = AgmaMesh(width, transverse, diameter, pitting_geometry_factor(pair), elastic)
    bodies = [_body(pair, gear, cycles[gear], making=making, width=width, transverse=transverse) for gear in (0, 1)]
    survival = reliability_factor(making.reliability)
    first, second = (
        agma_rating(load, body, mesh, reliability=survival, temperature=making.temperature) for body, _ in bodies
    )
    (one, j_one), (other, j_other) = bodies
    return AgmaPairRating(
        tangential_force=force,
        speed=speed,
        cycles=cycles,
        overload=duty.overload,
        dynamic=load.dynamic,
        distribution=load.distribution,
        size=(one.size, other.size),
        elastic=elastic,
        pitting_geometry=mesh.pitting_factor,
        tooth_root=(j_one, j_other),
        bending_cycles=(one.bending_cycles, other.bending_cycles),
        contact_cycles=(one.contact_cycles, other.contact_cycles),
        reliability=survival,
        temperature=making.temperature,
        strength=making.strength,
        gears=(first, second),
        rims=making.rims,
        hardness_ratio=other.hardness_ratio,
        wheel_strength=None if making.wheel is None else making.wheel.strength,
    )


def _body(
    pair: HobbedPair, gear: int, cycles: Value, *, making: AgmaMaking, width: Value, transverse: Value
) -> tuple[AgmaGear, BendingGeometry]:
    """Return what the rating needs of one gear, and its J with parts."""
    geometry = bending_geometry(pair, gear)
    contact_curve, bending_curve = making.curves_of(gear)
    harder = making.wheel.hardnesses if gear == 1 and making.wheel is not None else None
    body = AgmaGear(
        bending_factor=geometry.factor,
        strength=making.strength_of(gear),
        size=size_factor(width, transverse, lewis_form_factor(pair.virtual_teeth[gear])),
        rim=making.rims[gear],
        bending_cycles=life_factor(bending_curve, cycles),
        contact_cycles=life_factor(contact_curve, cycles),
        hardness_ratio=hardness_ratio_of(harder, pair.teeth[1] / pair.teeth[0]),
    )
    return body, geometry


def greatest_velocity(quality: float) -> float:
    """Return the pitch-line velocity up to which the curve of K_v holds [m/s].

    Args:
        quality: Transmission accuracy Q_v, 5 to 11 [-].

    Source: ANSI/AGMA 2001-D04, clause 8, as Shigley 9th ed., eq. 14-29: (A + Q_v − 3)² in ft/min.

    >>> round(greatest_velocity(11), 1)
    50.8
    """
    base = 50.0 + 56.0 * (1.0 - 0.25 * (12.0 - quality) ** (2.0 / 3.0))
    return float((base + quality - 3.0) ** 2 * FOOT / 60.0)
