"""Walls of housings: by casting, by torque, by bearings; arms that hold a gearbox's torque; fatigue of castings."""

from __future__ import annotations

from typing import NamedTuple

from gearwright.elementwise import Values, functions

# ----------------------------------------------------------------------------------------------------------------------
# Fatigue of cast materials that are loaded from zero: what a wall bears for ever.
# ----------------------------------------------------------------------------------------------------------------------


CAST_SAFETY = 3.5
"""Fatigue strength of a cast material over its working stress [-]: 2.1 as the FKM guideline asks of castings that are
not inspected and whose failure is severe, times 1.5 for bosses and ribs, over 0.89 for a cast skin (from memory)."""


def pulsating_strength(alternating: float, sensitivity: float) -> float:
    """Return the largest stress that a material bears for ever when it is loaded from zero, again and again [Pa].

    Args:
        alternating: Fatigue strength σ_W or τ_W about zero, not negative [Pa].
        sensitivity: To mean stress, M, not negative [-].

    Source: σ_m = σ_a in σ_a = σ_W − M σ_m, so that 2 σ_a = 2 σ_W/(1 + M): FKM guideline, stress ratio 0.

    >>> round(pulsating_strength(0.65 * 0.34 * 400.0, 0.65 * 0.22))
    155
    """
    return 2.0 * alternating / (1.0 + sensitivity)


# ----------------------------------------------------------------------------------------------------------------------
# How thick a wall is.
# ----------------------------------------------------------------------------------------------------------------------


class CastingRule(NamedTuple):
    """How thick the walls of a kind of castings are: t = t_0 + κ L between two limits."""

    base: float
    """t_0 [m]."""
    slope: float
    """κ [-]."""
    least: float
    """[m]"""
    most: float
    """[m]"""


def casting_wall(area: Values, rule: CastingRule) -> Values:
    """Return the wall that a foundry pours for a housing of some size [m].

    Args:
        area: A, of all its walls [m²].
        rule: Of its material.

    Source: t = t_0 + κ L within limits, with the L of a box of L × L × L/2, A = 4 L²; for iron around hardened gears
        6 mm + 0.010 L, 8 to 50 mm (Niemann and Winter, from memory), for light metals estimates.

    >>> iron = CastingRule(6e-3, 0.010, 8e-3, 50e-3)
    >>> [round(1e3 * casting_wall(area, iron), 1) for area in (0.04, 9.409, 26.883, 100.0)]
    [8.0, 21.3, 31.9, 50.0]
    """
    f = functions(area)
    return f.min(f.max(rule.base + rule.slope * f.sqrt(area / 4.0), rule.least), rule.most)


def torque_wall(torque: float, section: Values, shear: float) -> Values:
    """Return the wall of a closed section that bears a torque [m].

    Args:
        torque: T, about an axis square to the section [N m].
        section: A, that its wall encloses [m²].
        shear: τ, permissible [Pa].

    Source: Bredt, τ = T/(2 A t).

    >>> round(1e3 * torque_wall(1e6, 4.0, 25e6), 3)
    5.0
    """
    return torque / (2.0 * section * shear)


def bearing_wall(force: float, diameter: float, shear: float) -> float:
    """Return the wall across a shaft that bears the radial force of a bearing [m].

    Args:
        force: F [N].
        diameter: D, outside of the bearing [m].
        shear: τ, permissible [Pa].

    Source: equilibrium: F goes into the wall on both sides of the bearing, τ = F/(2 D t).

    >>> round(1e3 * bearing_wall(100e3, 0.2, 25e6), 3)
    10.0
    """
    return force / (2.0 * diameter * shear)


# ----------------------------------------------------------------------------------------------------------------------
# What holds the torque of a gearbox against its frame.
# ----------------------------------------------------------------------------------------------------------------------


SLENDERNESS = 2.0
"""Length of a torque arm over its height [-], an estimate."""


def torque_arm_volume(torque: float, bending: float) -> float:
    """Return what the arms fill by which a gearbox leans on its frame [m³].

    Args:
        torque: T, that they hold together [N m].
        bending: σ, permissible [Pa].

    Source: each of n arms of length l, height h and width b bears T/n at its foot, σ = 6 (T/n)/(b h²), and fills
        b h l/2, as it tapers to its end: n b h l/2 = 3 (l/h) T/σ, 6 T/σ at l = 2 h, however many they are.

    >>> round(torque_arm_volume(1e6, 60e6), 9)
    0.1
    """
    return 3.0 * SLENDERNESS * torque / bending
