"""Fatigue of cast housings: nominal stresses of shells, walls, webs, mounts; S-N curves of castings; Miner's sum."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

# ----------------------------------------------------------------------------------------------------------------------
# Nominal stresses: what torque, and radial and axial forces of bearings, do to sections of a housing.
# ----------------------------------------------------------------------------------------------------------------------


def shell_stress(torque: float, section: float, wall: float) -> float:
    """Return the shear stress of a closed section that bears a torque [Pa].

    Args:
        torque: T, about an axis square to the section [N m].
        section: A, that its wall encloses [m²].
        wall: t [m].

    Source: Bredt, τ = T/(2 A t).

    >>> round(shell_stress(1e6, 4.0, 5e-3) / 1e6, 6)
    25.0
    """
    return torque / (2.0 * section * wall)


def corner_concentration(wall: float, radius: float) -> float:
    """Return by how much the inner corner of a thin section in torsion is stressed more than its wall [-].

    Args:
        wall: t [m].
        radius: r, of the fillet in the corner [m].

    Source: Timoshenko and Goodier, Theory of Elasticity, torsion of thin sections: 1 + t/(4 r).

    Valid for: r small beside the section.

    >>> corner_concentration(6e-3, 3e-3)
    1.5
    """
    return 1.0 + wall / (4.0 * radius)


def shoulder_concentration(step: float, ratio: float) -> float:
    """Return the stress concentration of a shoulder's fillet in a flat bar that is bent [-].

    Args:
        step: h/r, height of the shoulder over the radius of its fillet [-].
        ratio: D/d, depth of the thick part over that of the thin one [-].

    Source: Heywood, Designing Against Fatigue, 1962, from memory: 1 + (h/r/(5.37 D/d − 4.8))^0.85.

    >>> round(shoulder_concentration(2.5, 2.0), 2)
    1.48
    """
    return 1.0 + math.pow(step / (5.37 * ratio - 4.8), 0.85)


def pulled_concentration(step: float, ratio: float) -> float:
    """Return the stress concentration of a shoulder's fillet in a flat bar that is pulled [-].

    Args:
        step: h/r, height of the shoulder over the radius of its fillet [-].
        ratio: D/d, depth of the thick part over that of the thin one [-].

    Source: Heywood, Designing Against Fatigue, 1962, from memory: 1 + (h/r/(2.8 D/d − 2))^0.65.

    >>> round(pulled_concentration(2.5, 2.0), 2)
    1.79
    """
    return 1.0 + math.pow(step / (2.8 * ratio - 2.0), 0.65)


def seat_stress(force: float, boss: float, wall: float) -> float:
    """Return the largest normal stress in a wall beside a rigid boss that a force in its plane pushes [Pa].

    Args:
        force: F, radial force of a bearing [N].
        boss: a, radius of the boss [m].
        wall: t [m].

    Source: rigid disc in a wide sheet: φ = A ln z, ψ = −κ A ln z − A a²/z², A = −F/(2π (1 + κ) t) (Kolosov and
        Muskhelishvili) leave it no strain at its rim, and spread the force evenly around it: σ_r = −F cos θ/(2π a t).

    Valid for: walls much wider than the boss.

    >>> round(seat_stress(100e3, 0.1, 10e-3) / 1e6, 3)
    15.915
    """
    return force / (2.0 * math.pi * boss * wall)


def pushed_wall(force: float, boss: float, edge: float, wall: float) -> float:
    """Return the bending stress of a round wall, built in at its edge, beside a rigid boss that is pushed axially [Pa].

    Args:
        force: F, along the axis of the boss [N].
        boss: a, radius of the boss [m].
        edge: b, radius at which the wall is built in [m].
        wall: t [m].

    Source: Kirchhoff's plate with w' = 0 at a and b: σ = 3 F/(2 π t²) (2 b² ln(b/a)/(b² − a²) − 1), at the boss;
        Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, table 3: σ = k F/t², k = 0.405 at b = 2 a.

    Valid for: a < b, and walls that are thin beside b − a; ribs are not counted.

    >>> round(pushed_wall(1.0, 1.0, 2.0, 1.0), 3)
    0.405
    """
    share = 2.0 * edge**2 * math.log(edge / boss) / (edge**2 - boss**2) - 1.0
    return 3.0 * force / (2.0 * math.pi * wall**2) * share


def tilted_wall(moment: float, boss: float, edge: float, wall: float) -> float:
    """Return the bending stress of a round wall, built in at its edge, beside a rigid boss that a moment tilts [Pa].

    Args:
        moment: M, about a line in the wall [N m].
        boss: a, radius of the boss [m].
        edge: b, radius at which the wall is built in [m].
        wall: t [m].

    Source: Kirchhoff's plate, w = (A r + B r³ + C/r + E r ln r) cos φ: σ = 3 M/(π a t²) (b² − a²)/(b² + a²), at the
        boss; Roark's Formulas for Stress and Strain, plate with a trunnion: σ = β M/(b t²), β = 1.146 at b = 2 a.

    Valid for: a < b, and walls that are thin beside b − a; ribs are not counted.

    >>> round(tilted_wall(1.0, 0.5, 1.0, 1.0), 3)
    1.146
    """
    return 3.0 * moment / (math.pi * boss * wall**2) * (edge**2 - boss**2) / (edge**2 + boss**2)


def web_stress(pull: float, moment: float, width: float, thickness: float) -> float:
    """Return the normal stress at the foot of a web that is pulled, and bent along the shaft [Pa].

    Args:
        pull: N, along the web [N].
        moment: M, at its foot [N m].
        width: b, along the shaft [m].
        thickness: t, around the shaft [m].

    Source: σ = N/(b t) + 6 M/(t b²).

    >>> round(web_stress(12e3, 150.0, 0.03, 0.01) / 1e6, 6)
    140.0
    """
    return pull / (width * thickness) + 6.0 * moment / (thickness * width**2)


def collar_stress(radial: float, axial: float, outer: float, inner: float) -> float:
    """Return the stress of a short tube that carries a boss, of equal effect as one in tension [Pa].

    Args:
        radial: F_r [N].
        axial: F_a [N].
        outer: Radius [m].
        inner: Radius [m].

    Source: shear 2 F_r/A of a thin tube, doubled (Tresca), and F_a/A.

    >>> round(collar_stress(10e3, 5e3, 0.05, 0.04) / 1e6, 3)
    15.915
    """
    return (4.0 * radial + axial) / (math.pi * (outer**2 - inner**2))


def mount_force(torque: float, radius: float, weight: float, number: int) -> float:
    """Return what the most loaded of equal mounts on a circle bears [N].

    Args:
        torque: T, that they hold together [N m].
        radius: Of the circle [m].
        weight: With its load factor, that they carry together [N].
        number: n of them [-].

    Source: equilibrium: T/(n r) and W/n, in line at one of them.

    >>> mount_force(2000.0, 0.25, 1000.0, 4)
    2250.0
    """
    return (torque / radius + weight) / number


def lug_stress(force: float, lever: float, height: float, depth: float) -> float:
    """Return the bending stress at the foot of a lug [Pa].

    Args:
        force: F, at its hole, across the lug [N].
        lever: l, of the hole over the wall [m].
        height: h, of the section in the force's direction [m].
        depth: b, of the section square to it [m].

    Source: σ = 6 F l/(b h²).

    >>> round(lug_stress(2250.0, 0.036, 0.06, 0.03) / 1e6, 6)
    4.5
    """
    return 6.0 * force * lever / (depth * height**2)


def arm_stress(torque: float, volume: float) -> float:
    """Return the bending stress at the feet of tapered torque arms [Pa].

    Args:
        torque: T, that they hold together [N m].
        volume: V, of all of them [m³].

    Source: as `housings.torque_arm_volume`: σ = 6 T/V, of arms twice as long as high.

    >>> round(arm_stress(1e6, 0.1) / 1e6, 6)
    60.0
    """
    return 6.0 * torque / volume


# ----------------------------------------------------------------------------------------------------------------------
# What castings bear: ranges of stress against cycles in two straight lines that end, and Miner's sum of a spectrum.
# ----------------------------------------------------------------------------------------------------------------------


CUT_OFF = 1e8
"""Cycles at whose range of stress S-N curves end: EN 1999-1-3 and the FKM guideline, from memory [-]."""


class CastCurve(NamedTuple):
    """S-N curve of a casting with its usual pores and skin, without notch: 97.5 % survive."""

    strength: float
    """Range of normal stress that is borne so many times [Pa]."""
    cycles: float
    """How often [-]; no more than at the knee."""
    slopes: tuple[float, float]
    """Exponents up to the knee and from there to the cut-off [-]."""
    knee: float
    """Cycles at which the slope changes [-]."""

    @property
    def at_knee(self) -> float:
        """Range of stress there [Pa]."""
        return self.strength * math.pow(self.cycles / self.knee, 1.0 / self.slopes[0])

    @property
    def harmless(self) -> float:
        """Range of stress at the cut-off, below which any number of cycles is borne [Pa]."""
        return self.at_knee * math.pow(self.knee / CUT_OFF, 1.0 / self.slopes[1])


class StressCycles(NamedTuple):
    """Cycles of one size."""

    range: float
    """Of the stress, from valley to peak [Pa]."""
    number: float
    """[-]"""


def borne_cycles(curve: CastCurve, stress: float) -> float:
    """Return how many cycles of one range a casting bears [-]; infinite below the cut-off.

    Args:
        curve: Of the casting.
        stress: Range Δσ, from valley to peak [Pa].

    Source: N = N_k (Δσ_k/Δσ)^m; whatever the mean stress is.

    >>> curve = CastCurve(50e6, 2e6, (7.0, 9.0), 5e6)
    >>> round(borne_cycles(curve, 100e6))
    15625
    """
    if stress < curve.harmless:
        return math.inf
    return curve.knee * math.pow(curve.at_knee / stress, curve.slopes[0 if stress >= curve.at_knee else 1])


def miner_sum(curve: CastCurve, cycles: Sequence[StressCycles], *, factor: float) -> float:
    """Return Miner's sum of cycles, all loads being larger by a factor [-].

    Args:
        curve: Of the casting.
        cycles: With what the notch makes of their ranges.
        factor: On all of them [-].

    Source: Miner 1945.

    >>> curve = CastCurve(50e6, 2e6, (7.0, 9.0), 5e6)
    >>> round(miner_sum(curve, [StressCycles(50e6, 1e6)], factor=1.0), 12)
    0.5
    """
    return math.fsum(one.number / borne_cycles(curve, factor * one.range) for one in cycles)


def used_up(curve: CastCurve, cycles: Sequence[StressCycles], *, spectrum: float, factor: float) -> float:
    """Return Miner's sum over the one that is allowed, all loads being larger by a factor [-].

    Args:
        curve: Of the casting.
        cycles: With what the notch makes of their ranges.
        spectrum: D_M, sum that is allowed of loads of many sizes [-].
        factor: On all of them [-].

    Source: FKM guideline, from memory: what is allowed rises from D_M of many sizes to 1 of one, of which the S-N curve
        itself tells: D = D_M + (1 − D_M) v, with v the part of the sum that cycles of one size do.

    >>> curve = CastCurve(50e6, 2e6, (7.0, 9.0), 5e6)
    >>> round(used_up(curve, [StressCycles(50e6, 1e6)], spectrum=0.3, factor=1.0), 9)
    0.5
    """
    parts = [one.number / borne_cycles(curve, factor * one.range) for one in cycles]
    total = math.fsum(parts)
    return total / (spectrum + (1.0 - spectrum) * max(parts) / total) if total else 0.0


def fatigue_safety(curve: CastCurve, cycles: Sequence[StressCycles], *, spectrum: float) -> float:
    """Return by what all loads may grow until Miner's sum is the allowed one [-]; infinite without load.

    Args:
        curve: Of the casting.
        cycles: With what the notch makes of their ranges.
        spectrum: D_M, sum that is allowed of loads of many sizes [-].

    Source: `used_up` = 1, bisected.

    >>> curve = CastCurve(50e6, 2e6, (7.0, 9.0), 5e6)
    >>> round(fatigue_safety(curve, [StressCycles(25e6, 2e6)], spectrum=0.3), 9)
    2.0
    """
    loaded = [one for one in cycles if one.range > 0.0 and one.number > 0.0]
    if not loaded:
        return math.inf
    low = high = curve.strength / max(one.range for one in loaded)
    while used_up(curve, loaded, spectrum=spectrum, factor=high) < 1.0:
        high *= 2.0
    while used_up(curve, loaded, spectrum=spectrum, factor=low) > 1.0:
        low /= 2.0
    for _ in range(BISECTIONS):
        middle = math.sqrt(low * high)
        if used_up(curve, loaded, spectrum=spectrum, factor=middle) < 1.0:
            low = middle
        else:
            high = middle
    return math.sqrt(low * high)


BISECTIONS = 48
"""Of an interval of factors; what is left is rounding [-]."""
