"""Tip relief and flank class of a mesh where nobody states them, and what relief leaves of the dynamic factor."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Annotated, cast

import numpy as np

from gearwright.parts.iso6336.geometry import MeshGeometry, Value, as_value
from gearwright.parts.iso6336.loads.stiffness import MeshSprings
from gearwright.parts.iso6336.steels import GearSteel
from gearwright.parts.stiffness import LINEAR_LOAD, theoretical_stiffness
from gearwright.units import Origin, Quantity

_PART1 = "ISO 6336-1:2019"
_MICRON, _MPA = 1e-6, 1e6
LARGEST_RELIEF = 0.02
"""Tip relief over the module, at most, where none is stated [-]: shop practice, from memory."""
COARSE_CLASS = 6
"""Flank class from which on B_k = 1, whatever the relief (ISO 6336-1, clause 6.5.5)."""
_LEAST_TOLERANCE, _TOLERANCE = 3e-6, 0.15
"""Tolerance of a relief that is not stated: ±3 µm, or ±15 % where that is more; an estimate of grinding."""
_LEAST_TERM = 0.1
"""B_k at least where a tolerance is stated that is tighter [-]."""
_FAST, _SLOW = 60.0, 15.0
"""Pitch-line velocities above which class 4 and class 5 are taken [m/s]: AGMA 2015 A4 and A5 for aircraft; estimate."""


class ReliefRule(Enum):
    """What a tip relief is made for where its amount is not stated."""

    LOAD = "load"
    """The deflection under the load that does most damage."""
    RUN_IN = "run-in"
    """Nothing: what running in leaves."""


@dataclass(frozen=True)
class TipRelief:
    """Tip relief of both gears of a mesh."""

    amount: Annotated[Value, Quantity("length"), Origin("C_a ≤ C_eff, 0.02 m_n; at least C_ay", f"{_PART1}, 6.5.5")]
    """C_a [m]."""
    deflection: Annotated[
        Value, Quantity("length"), Origin("C_eff = F_t K_A K_γ/(b c′), of ε_β ≥ 1 c_γα", "ISO/TS 6336-20:2017, C_eff")
    ]
    """Relief that the load for which it is made asks for C_eff [m]."""
    tolerance: Annotated[Value, Quantity("length"), Origin("max(3 µm, 0.15 C_a)", "estimate for ground teeth")] = 0.0
    """By how much C_a may miss [m]; 0 where an amount is stated without one."""
    stiffness: Annotated[Value, Quantity("number"), Origin("c′", f"{_PART1}, clause 9")] = 0.0
    """Of one pair of teeth in the mesh that is relieved c′ [N/m²]."""
    stated: bool = False
    """Whether the tolerance is stated; then B_k is at least 0.1."""


def running_in_relief(steels: tuple[GearSteel, GearSteel]) -> float:
    """Return the tip relief that running in gives C_ay, the mean of both gears [m].

    Args:
        steels: Of the two gears.

    Source: ISO 6336-1:2006, clause 6.5.5: (σ_Hlim/97 − 18.45)²/18 + 1.5 µm; 2.00 µm at 1500 MPa in a printed report.
    """
    strengths = (steel.tabulated_strength / _MPA for steel in steels)
    return 0.5 * sum((strength / 97.0 - 18.45) ** 2 / 18.0 + 1.5 for strength in strengths) * _MICRON


def load_deflection(mesh: MeshGeometry, springs: MeshSprings, load: Value, design_load: Value) -> Value:
    """Return the deflection of the teeth under a load, which a relief makes up for C_eff [m].

    Args:
        mesh: The pair.
        springs: Stiffness under the load at hand.
        load: F_t K_A K_γ/b at hand, to which the stiffness belongs [N/m].
        design_load: F_t K_A K_γ/b for which the relief is made [N/m].

    Source: ISO/TS 6336-20:2017, C_eff, with c′ of spur gears and c_γα from ε_β = 1 on; below 100 N/mm teeth are softer.

    >>> spur = MeshGeometry((20, 60), 2e-3, 0.02, 0.08, (0.022, 0.062))
    >>> deflection = load_deflection(spur, MeshSprings(14e9, 20e9, 17e9), 5e5, 5e5)
    >>> round(1e6 * float(deflection), 1)  # 500 N/mm over 14 N/(mm µm)
    35.7
    """
    stiffness = np.where(np.asarray(mesh.overlap_ratio) >= 1.0, springs.mesh, springs.single)
    soft = (_lightness(design_load) / _lightness(load)) ** 0.25
    return as_value(design_load / (stiffness * soft))


def in_ring(mesh: MeshGeometry, springs: MeshSprings, planet: int) -> MeshSprings:
    """Return the stiffness of a planet's mesh in an unshifted ring, from that of one of its meshes.

    Args:
        mesh: Sun and planet, or planet and ring.
        springs: Of that mesh.
        planet: Which of its gears is the planet.

    Source: ISO 6336-1:2006, clause 9: z_n2 = ∞ for an internal wheel.
    """
    teeth = mesh.virtual_teeth[planet], np.inf
    here = (mesh.virtual_teeth[0], np.where(np.asarray(mesh.side) > 0.0, mesh.virtual_teeth[1], np.inf))
    shifts = (mesh.proportions[0].profile_shift, mesh.proportions[1].profile_shift)
    stiffer = _theory(teeth, (shifts[planet], 0.0)) / _theory(here, shifts)
    return MeshSprings(springs.single * stiffer, springs.mesh * stiffer, springs.face * stiffer)


def _theory(teeth: tuple[Value, Value], shifts: tuple[Value, Value]) -> Value:
    # The formula is plain arithmetic, so arrays pass through it.
    return theoretical_stiffness(cast(tuple[float, float], teeth), cast(tuple[float, float], shifts))


def _lightness(load: Value) -> Value:
    return np.minimum(1.0, np.maximum(load, 1.0) / LINEAR_LOAD)


def relief_for(deflection: Value, module: Value, run_in: float) -> TipRelief:
    """Return the relief that a deflection asks for: rounded down to whole micrometres, capped, not below running in.

    Args:
        deflection: C_eff [m].
        module: m_n [m].
        run_in: C_ay [m].

    Source: ISO 6336-1:2006, clause 6.5.5 (B_k = 0 at C_a = C_eff); the cap of 0.02 m_n by shop practice.

    >>> made = relief_for(35.7e-6, 3e-3, 2e-6)
    >>> round(1e6 * float(made.amount), 1), round(1e6 * float(made.tolerance), 2)
    (35.0, 5.25)
    """
    whole = np.floor(np.minimum(deflection, LARGEST_RELIEF * module) / _MICRON + 1e-6) * _MICRON
    amount = np.maximum(whole, run_in)
    return TipRelief(as_value(amount), deflection, as_value(np.maximum(_LEAST_TOLERANCE, _TOLERANCE * amount)))


def relief_term(relief: TipRelief, load: Value, *, grade: Value) -> Value:
    """Return what relief leaves of the vibration B_k [-], at the worse end of its tolerance.

    Args:
        relief: Of both gears.
        load: F_t K_A K_γ/b [N/m].
        grade: Flank class [-].

    Source: ISO 6336-1:2006, clause 6.5.5: |1 − c′ C_a b/(F_t K_A K_γ)|, 1 from class 6 on.
    """
    per = relief.stiffness / load
    term = np.abs(1.0 - per * relief.amount) + per * relief.tolerance
    if relief.stated:
        term = np.maximum(term, _LEAST_TERM)
    return as_value(np.where(np.asarray(grade) >= COARSE_CLASS, 1.0, term))


def usual_class(speed: Value) -> Value:
    """Return the flank class that gears of aircraft are made to at a pitch-line velocity [-].

    Args:
        speed: Greatest pitch-line velocity v [m/s].

    Source: classes A4 and A5 of AGMA 2015 in aircraft, an estimate: 4 above 60 m/s, 5 from 15 on, 6 below.
    """
    return as_value(np.where(np.asarray(speed) > _FAST, 4.0, np.where(np.asarray(speed) >= _SLOW, 5.0, 6.0)))
