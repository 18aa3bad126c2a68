"""A permanent-magnet motor whose three phases are short-circuited while it turns."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats


class Winding(NamedTuple):
    """One phase of a permanent-magnet motor without saliency."""

    back_emf: float
    """E, open-circuit voltage at the rated speed, rms [V]."""
    inductance: float
    """L, synchronous [H]."""
    resistance: float
    """R [Ω]."""
    pole_pairs: int
    """p"""
    rated_speed: float
    """At which E is given [rad/s]."""

    @property
    def linkage(self) -> float:
        """ψ = √2 E/(p Ω_r), amplitude of the flux linkage of the magnets [V s]."""
        return math.sqrt(2.0) * self.back_emf / (self.pole_pairs * self.rated_speed)


def short_circuit_torque(winding: Winding, speed: float, *, before: float, time: Floats) -> Floats:
    """Return the torque of a motor after all its phases are short-circuited at constant speed [N m].

    Args:
        winding: Its phase.
        speed: Of its rotor [rad/s].
        before: Torque until then, by a current in phase with E [N m].
        time: Since then [s], shape (n,).

    Returns:
        Positive where it drives, shape (n,).

    Source: voltage equations in coordinates of the rotor (Park 1929), L di/dt = −(R + j ω L) i − j ω ψ, i = i_d + j i_q
        and T = 3/2 p ψ i_q, solved in closed form for constant ω = p Ω.
        Without resistance and load its peak is 3 E²/(Ω X), X = p Ω L, which is also the greatest torque of a motor that
        slips a pole on a voltage E.
    Valid for: no saliency (L_d = L_q), no saturation, no damper winding.

    >>> winding = Winding(back_emf=100.0, inductance=1e-3, resistance=0.0, pole_pairs=4, rated_speed=250.0)
    >>> quarter = np.array([0.5 * math.pi / (4 * 250.0)])
    >>> round(-float(short_circuit_torque(winding, 250.0, before=0.0, time=quarter)[0]), 3)  # 3 E²/(Ω X)
    120.0
    """
    linkage = winding.linkage
    if linkage == 0.0 or speed == 0.0:
        return np.zeros(len(time))
    electric = winding.pole_pairs * speed
    per_current = 1.5 * winding.pole_pairs * linkage
    settled = -1j * electric * linkage / complex(winding.resistance, electric * winding.inductance)
    decay = complex(winding.resistance / winding.inductance, electric)
    current = settled + (1j * before / per_current - settled) * np.exp(-decay * time)
    return np.asarray(per_current * current.imag)
