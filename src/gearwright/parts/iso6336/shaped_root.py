"""The fillet that a shaper cutter leaves in a ring: the envelope of the cutter's rounded tip as both roll.

Lengths are in normal modules, tooth numbers those of the equivalent spur gears and positive; the ring's centre is the
origin, the cutter's lies on the x axis, and the pole where their generating circles touch.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.errors import SolveError
from gearwright.parts.iso6336.geometry import ShaperCutter, ToothProportions, Value, as_value

_STEPS = 40
_TANGENT = np.pi / 6.0
"""The normal of the critical section's fillet point against the tooth's centre line: its tangent lies at 60° to it."""


class ShapedFillet(NamedTuple):
    """Where the 60° tangent touches the fillet of a ring, over the module."""

    chord: Value
    """s_Fn/m_n [-]."""
    radius: Value
    """ρ_F/m_n [-]."""
    height: Value
    """Distance of the critical section from the ring's centre along the tooth's centre line [-]."""
    normal: Value
    """Angle of the fillet's normal to the line of centres ϑ [rad]."""


class _Tip(NamedTuple):
    """The rounding of the cutter's tip, and where the cutter stands in the ring."""

    centre: Value
    """Generating centre distance a_0/m_n [-]."""
    pole: Value
    """Of the pole from the ring's centre [-]."""
    reach: Value
    """Of the rounding's centre from the cutter's centre [-]."""
    angle: Value
    """Half angle between the centres of a tooth's two roundings [rad]."""


def shaped_fillet(tooth: ToothProportions, teeth: Value, pressure_angle: Value) -> ShapedFillet:
    """Return where the 60° tangent touches the fillet that a shaper cutter generates.

    Args:
        tooth: Of the ring, with its cutter; its fillet radius is that of the cutter's tip, its dedendum gives the root
            circle.
        teeth: z_n of the ring, positive [-].
        pressure_angle: α_n [rad].

    Source: law of gearing: the normal of the fillet runs through the pole (Litvin and Fuentes 2004, section 6.4); with
        Euler and Savary's ρ_F = ρ_a0 + (1 − z_0/z_n) l/(dη/dφ).

    Raises:
        SolveError: a tip that has no room for its two roundings, or no tangent point on the fillet.
    """
    cutter = tooth.cutter
    assert cutter is not None
    tip, turn = _tip(tooth, cutter, teeth, pressure_angle), cutter.teeth / teeth
    roll: Value = 0.0
    for _ in range(_STEPS):
        lean, rate, _ = _normal(tip, roll)
        step = (lean - turn * roll - np.pi / teeth - _TANGENT) / (rate - turn)
        roll = roll - np.clip(step, -0.5 * np.pi / cutter.teeth, 0.5 * np.pi / cutter.teeth)
        if np.all(np.abs(step) < 1e-14):
            break
    lean, rate, length = _normal(tip, roll)
    if not np.all(np.abs(lean - turn * roll - np.pi / teeth - _TANGENT) < 1e-9):
        raise SolveError(
            "no 60° tangent on the fillet that this cutter leaves; give fewer teeth or a smaller tip radius"
        )
    across = tip.reach * np.sin(tip.angle + roll) + tooth.fillet_radius * np.sin(lean)
    along = tip.centre + tip.reach * np.cos(tip.angle + roll) + tooth.fillet_radius * np.cos(lean)
    behind = np.arctan2(across, along) - turn * roll - np.pi / teeth
    distance = np.hypot(across, along)
    return ShapedFillet(
        chord=as_value(-2.0 * distance * np.sin(behind)),
        radius=as_value(tooth.fillet_radius + (1.0 - turn) * length / (rate - turn)),
        height=as_value(distance * np.cos(behind)),
        normal=as_value(lean),
    )


def _tip(tooth: ToothProportions, cutter: ShaperCutter, teeth: Value, pressure_angle: Value) -> _Tip:
    """Place the cutter by inv α_w0 = inv α_n − 2 tan α_n (x_0 + x)/(z_n − z_0), its tip on the ring's root circle."""
    slope, difference = 2.0 * np.tan(pressure_angle), teeth - cutter.teeth
    generating = _involute(pressure_angle) - slope * (cutter.shift + tooth.profile_shift) / difference
    working = _involute_angle(generating, pressure_angle)
    centre = 0.5 * difference * np.cos(pressure_angle) / np.cos(working)
    reach = 0.5 * teeth + tooth.dedendum - tooth.profile_shift - centre - tooth.fillet_radius
    base = 0.5 * cutter.teeth * np.cos(pressure_angle)
    thickness = (0.5 * np.pi + slope * cutter.shift) / cutter.teeth + _involute(pressure_angle)
    angle = thickness - _involute(np.arccos(base / reach)) - tooth.fillet_radius / base
    if not np.all(angle >= 0.0):
        raise SolveError("its tip is too narrow for this radius; give a smaller tip radius")
    return _Tip(centre, centre * teeth / difference, reach, angle)


def _normal(tip: _Tip, roll: Value) -> tuple[Value, Value, Value]:
    """Lean η of the normal to the line of centres [rad], dη/dφ [-], distance from rounding to pole [-]."""
    angle = tip.angle + roll
    along = tip.centre - tip.pole + tip.reach * np.cos(angle)
    across = tip.reach * np.sin(angle)
    square = along**2 + across**2
    rate = tip.reach * ((tip.centre - tip.pole) * np.cos(angle) + tip.reach) / square
    return np.arctan2(across, along), rate, np.sqrt(square)


def _involute(angle: Value) -> Value:
    """Return inv α = tan α − α, for one angle or an array of them [rad]."""
    return as_value(np.tan(angle) - angle)


def _involute_angle(value: Value, start: Value) -> Value:
    """Return the angle of an involute near the pressure angle [rad], by Newton's iteration."""
    angle = start
    for _ in range(_STEPS):
        angle = angle - (_involute(angle) - value) / np.tan(angle) ** 2
    return angle
