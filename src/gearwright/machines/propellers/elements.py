"""Blade-element momentum: the stream through every element, found by one bracketed residual, in every state."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines.propellers.blade import BladeShape

BISECTIONS = 38
"""Halvings of the bracket of 90°: the inflow angle to 6e-12 rad."""
SMALLEST = 1e-7
"""Inflow angle nearest to the disc's plane [rad]."""
TURBULENT = 2.0 / 3.0
"""Load beyond which the stream of a windmill is turbulent, where its induction is 0.4 [-]."""
AT_REST = 2.0
"""Thrust over dynamic pressure and area at which Buhl's stream comes to rest in the disc [-]."""


class Loads(NamedTuple):
    """A propeller at operating points; arrays of their shape."""

    thrust: Floats
    """C_T = T/(ρ n² D⁴) [-]."""
    power: Floats
    """C_P = P/(ρ n³ D⁵) [-]."""
    element_thrust: Floats
    """dC_T/dx of every element, last axis [-]."""
    element_power: Floats
    """dC_P/dx of every element, last axis [-]."""
    inflow_angle: Floats
    """φ of every element, last axis [rad]."""
    axial: Floats
    """Speed added by the disc to the stream at every element, over the tip speed, last axis [-]."""
    swirl: Floats
    """Speed of the swirl in the disc at every element, over the tip speed, last axis [-]."""


class _Stream(NamedTuple):
    """What the elements meet; arrays broadcast to points by elements."""

    shape: BladeShape
    pitch: Floats
    """Angle of every element [rad]."""
    turning: Floats
    """Tangential speed over that of the tip [-]."""
    ratio: Floats
    """λ: axial over tangential speed [-]."""
    mach: Floats
    """Of the tip's rotation [-]."""


class _Balance(NamedTuple):
    residual: Floats
    axial_load: Floats
    """s c_n/sin² φ [-]."""
    swirl_load: Floats
    """s c_t/|sin φ| cos φ [-]."""
    through: Floats
    """Speed through the disc over the free stream's, where that is not zero [-]."""
    normal: Floats
    """c_n [-]."""
    tangential: Floats
    """c_t [-]."""
    factor: Floats
    """Prandtl's F [-]."""


def loads(
    shape: BladeShape, advance_ratio: Floats | float, pitch: Floats | float, tip_mach: Floats | float = 0.0
) -> Loads:
    """Return thrust and power of a propeller at any blade angle: driving, windmilling, braking, reversed.

    Args:
        shape: The blades.
        advance_ratio: J = V/(n D), not negative; 0 is standstill [-].
        pitch: Blade angle at three quarters of the radius [rad].
        tip_mach: Of the tip's rotation; 0 leaves compressibility out [-].

    Source: Ning, Wind Energy 17 (2014) 1327: one residual in the inflow angle, bracketed, so that it always converges;
        tip and hub losses after Prandtl; windmills beyond an induction of 0.4 after Buhl, NREL/TP-500-36834 (2005);
        where the blades throw back more than Buhl's stream at rest bears, momentum with the stream reversed.

    Valid for: axial flow; no swirl upstream, no interference of nacelle and wing.
    """
    ratio, angle, mach = (np.asarray(value, dtype=float)[..., None] for value in (advance_ratio, pitch, tip_mach))
    ratio, angle, mach, _ = np.broadcast_arrays(ratio, angle, mach, shape.radius)
    return loads_in(shape, ratio / math.pi, np.broadcast_to(shape.radius, ratio.shape), pitch=angle, tip_mach=mach)


def loads_in(
    shape: BladeShape, axial: Floats, turning: Floats, *, pitch: Floats | float, tip_mach: Floats | float = 0.0
) -> Loads:
    """Return thrust and power of blades whose elements meet the air at given speeds.

    Args:
        shape: The blades.
        axial: Speed along the axis over that of the tip; points by elements [-].
        turning: Speed along the turn over that of the tip, positive; points by elements [-].
        pitch: Blade angle at three quarters of the radius [rad].
        tip_mach: Of the tip's rotation [-].

    Source: `loads`; every element with the stream that its own load makes.
    """
    axial, turning, angle, mach, _ = np.broadcast_arrays(axial, turning, pitch, tip_mach, shape.radius)
    stream = _Stream(shape, angle + shape.twist, turning, axial / turning, mach)
    return _loads(stream, _inflow(stream))


def _inflow(stream: _Stream) -> Floats:
    """Return the inflow angle of every element by bisection in the state's bracket [rad]."""
    edge = _balance(stream, np.full_like(stream.ratio, SMALLEST))
    thrown_back = AT_REST * edge.factor * -edge.normal * _solidity(stream, edge.factor) > stream.ratio**2
    low = np.where(thrown_back, -math.pi / 2.0, SMALLEST)
    high = np.where(thrown_back, -SMALLEST, math.pi / 2.0)
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        above = _balance(stream, middle).residual > 0.0
        high, low = np.where(above, middle, high), np.where(above, low, middle)
    return 0.5 * (low + high)


def _solidity(stream: _Stream, factor: Floats) -> Floats:
    """s = σ'/(4 F): what a unit of force asks of the stream."""
    shape = stream.shape
    return shape.number * shape.chord / (2.0 * math.pi * shape.radius) / (4.0 * factor)


def _balance(stream: _Stream, inflow: Floats) -> _Balance:
    """Return how far momentum and forces are from each other at an inflow angle."""
    shape, sine, cosine = stream.shape, np.sin(inflow), np.cos(inflow)
    speed = stream.mach * stream.turning * np.hypot(1.0, stream.ratio)
    force = shape.polar(stream.pitch - inflow, shape.design_lift, shape.thickness, speed)
    normal, tangential = force.lift * cosine - force.drag * sine, force.lift * sine + force.drag * cosine
    factor = _loss(shape, np.abs(sine))
    part = _solidity(stream, factor)
    load = part * normal / sine**2
    swirl = part * tangential / (np.abs(sine) * cosine + 1e-300)
    through = _through(load, factor, sine)
    residual = sine * np.abs(sine) * through - stream.ratio * (np.abs(sine) * cosine + part * tangential)
    return _Balance(residual, load, swirl, through, normal, tangential, factor)


def _through(load: Floats, factor: Floats, sine: Floats) -> Floats:
    """Return the free stream's speed over that through the disc; it changes sign where the stream is reversed."""
    calm = np.where(sine > 0.0, 1.0 - load, 1.0 + load)
    turbulent = (sine > 0.0) & (load < -TURBULENT)
    k = 2.0 * factor * np.where(turbulent, -load, 1.0)
    first, second, third = k - (10.0 / 9.0 - factor), k - factor * (4.0 / 3.0 - factor), k - (25.0 / 9.0 - 2.0 * factor)
    third = np.where(np.abs(third) < 1e-9, 1e-9, third)
    slowed = (first - np.sqrt(np.maximum(second, 0.0))) / third
    return np.where(turbulent, 1.0 / np.maximum(1.0 - slowed, 1e-12), calm)


def _loss(shape: BladeShape, sine: Floats) -> Floats:
    """Return Prandtl's factor of tip and hub."""
    if not shape.losses:
        return np.ones(np.broadcast_shapes(sine.shape, shape.radius.shape))
    half, radius = shape.number / 2.0, shape.radius
    tip = np.exp(-half * (1.0 - radius) / (radius * np.maximum(sine, 1e-9)))
    hub = np.exp(-half * (radius - shape.hub) / (shape.hub * np.maximum(sine, 1e-9)))
    return np.maximum((2.0 / math.pi) ** 2 * np.arccos(tip) * np.arccos(hub), 1e-4)


def _loads(stream: _Stream, inflow: Floats) -> Loads:
    """Return the forces at the inflow angles that were found."""
    shape, balance = stream.shape, _balance(stream, inflow)
    sine, cosine, radius = np.sin(inflow), np.cos(inflow), shape.radius
    # Speeds over that of the tip; the stream's square from whichever of its parts is well known.
    turning = stream.turning / (1.0 + balance.swirl_load)
    total = turning / np.maximum(cosine, 1e-12)
    axial = stream.ratio * stream.turning / np.where(np.abs(balance.through) < 1e-12, np.inf, balance.through)
    total = np.where(np.abs(sine) > cosine, np.abs(axial / sine), total)
    scale = shape.number * shape.chord * total**2 * math.pi**2 / 8.0
    thrust, power = scale * balance.normal, scale * balance.tangential * math.pi * radius
    return Loads(
        thrust=np.sum(thrust * shape.width, axis=-1),
        power=np.sum(power * shape.width, axis=-1),
        element_thrust=thrust,
        element_power=power,
        inflow_angle=inflow,
        axial=total * sine - stream.ratio * stream.turning,
        swirl=stream.turning - total * cosine,
    )
