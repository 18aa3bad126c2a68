"""What the bevel pair of the Colibri report is when it is treated as a bevel pair: mean cone, forces, ISO 10300."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

from gearwright.catalogue import gear_steel
from gearwright.parts.bevel import (
    WIDEST,
    WIDEST_MODULES,
    BevelDuty,
    BevelForces,
    BevelPair,
    Hand,
    Rotation,
    VirtualPair,
    bevel_bending,
    bevel_forces,
    bevel_load_factors,
    bevel_pitting,
)
from gearwright.parts.iso6336 import LoadedTooth, ToothProportions, root_section
from gearwright.replays.colibri.report.chain import executed

CONTACT_SAFETY, ROOT_SAFETY = 1.2, 1.6
"""S_H and S_F that a gear of an aircraft is given here [-]."""
_PITCH_DEVIATION = 10e-6
"""f_pt of ground bevel gears of this size [m]; it moves the module by under 1 %."""
_HARDNESS = 700.0
_FINE = 1e-3


def bevel_pair(module: float | None = None) -> BevelPair:
    """Return the report's straight pair with the widest face that its cone allows.

    Args:
        module: Outer transverse module [m]; None: the report's.

    Source: ISO 23509:2016, annex B: b ≤ R_e/3 and b ≤ 10 m_et.
    """
    steps = executed()
    teeth = round(steps["bevel-pinion.teeth"].value), round(steps["bevel-wheel.teeth-whole"].value)
    outer = steps["bevel-pinion.module"].value if module is None else module
    narrow = BevelPair(teeth, outer, _FINE * outer)
    return replace(narrow, face_width=min(WIDEST * narrow.outer_cone_distance, WIDEST_MODULES * outer))


def mean_cone_forces() -> BevelForces:
    """Return the forces of the report's pair at its mean cone [N]; straight teeth push alike in both directions."""
    torque = executed()["bevel-pinion.torque"].value
    return bevel_forces(bevel_pair(), torque, hand=Hand.LEFT, rotation=Rotation.CLOCKWISE)


def form_factor(virtual_teeth: float) -> float:
    """Return the report's γ for any number of teeth, π cos α Y_Fa [-].

    Args:
        virtual_teeth: Of the equivalent spur gear [-].

    Source: H9 with Y_F of ISO 6336-3 under load at the tip, rack 1.25/0.38.

    >>> round(form_factor(60 / math.cos(math.radians(15.0)) ** 3), 2)
    6.68
    """
    alpha = math.radians(20.0)
    tooth = LoadedTooth(virtual_teeth, virtual_teeth + 2.0, alpha, ToothProportions())
    return math.pi * math.cos(alpha) * float(root_section(tooth).form)


@cache
def bevel_safeties(module: float | None = None) -> tuple[float, float]:
    """Return the lesser S_H and S_F of the pair by ISO 10300, for unlimited life at the report's torque [-].

    Args:
        module: Outer transverse module [m]; None: the report's.

    Source: ISO 10300-1, -2, -3:2023, method B1; case-hardened steel MQ with a core of 30 HRC, K_A = 1.
    """
    virtual, steps = VirtualPair(bevel_pair(module)), executed()
    steel = gear_steel("case-hardened-core-30", "MQ", _HARDNESS)
    duty = BevelDuty(steps["bevel-pinion.torque"].value, steps["bevel-pinion.speed"].value, _PITCH_DEVIATION)
    loads, _ = bevel_load_factors(virtual, duty, (steel, steel))
    flanks = bevel_pitting(virtual, (steel, steel), duty, loads=loads, lives=(1.0, 1.0))
    roots = [bevel_bending(virtual, gear, steel, duty=duty, loads=loads, life=1.0).safety for gear in (0, 1)]
    return min(flanks.safeties), min(roots)


def module_for(safety: int) -> float:
    """Return the outer module at which the pair reaches its safety [m].

    Args:
        safety: 0 for S_H, 1 for S_F.
    """
    low, high = 4e-3, 20e-3
    asked = (CONTACT_SAFETY, ROOT_SAFETY)[safety]
    while high - low > 1e-7:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if bevel_safeties(middle)[safety] >= asked else (middle, high)
    return high
