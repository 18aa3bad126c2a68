"""How a ball bearing shares its load among its balls: ISO/TS 16281, with clearance, axial load and tilt.

The inner ring moves against the outer one in five ways: along x and y, along its axis, and it tilts in the planes x-a
and y-a. A ball at the angle φ from x is squeezed by what that does to the distance of the two groove centres there.
Displacements are counted from the middle of the clearance, where no ball touches.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import Problem, SolveError, refuse
from gearwright.parts.bearings.rolling_bearing import BearingGeometry, ball_contacts, load_deflection_constant

STEEL_MODULUS, STEEL_POISSON = 210e9, 0.3
"""Elastic constants of bearing steel [Pa, -]."""
_SCHEDULES = tuple(
    tuple(first * ratio**step for step in range(count))
    for first, ratio, count in ((10.0, 0.1, 12), (10.0, 0.3, 26), (100.0, 0.4, 36))
)
"""Springs that hold the ring while its place is sought, share of the load per A moved; the next set if one fails."""
_STEPS = 40
"""Newton steps at most for each spring."""
BALANCED = 1e-8
"""Unbalanced load over the load, above which equilibrium is not reached [-]."""


class RingLoad(NamedTuple):
    """What the shaft puts on the inner ring."""

    x: float = 0.0
    """Radial force F_x [N]; the first ball stands at x."""
    y: float = 0.0
    """Radial force F_y [N]."""
    axial: float = 0.0
    """F_a [N]."""
    moment_x: float = 0.0
    """Couple that tilts in the plane of x and the axis [N m]."""
    moment_y: float = 0.0
    """Couple that tilts in the plane of y and the axis [N m]."""


class RingMotion(NamedTuple):
    """Where the inner ring goes, from the middle of the clearance."""

    x: float
    """[m]"""
    y: float
    """[m]"""
    axial: float
    """[m]"""
    tilt_x: float
    """In the plane of x and the axis [rad]."""
    tilt_y: float
    """In the plane of y and the axis [rad]."""

    @property
    def radial(self) -> float:
        """Radial displacement δ_r [m]."""
        return math.hypot(self.x, self.y)

    @property
    def tilt(self) -> float:
        """Misalignment ψ [rad]."""
        return math.hypot(self.tilt_x, self.tilt_y)


class LoadDistribution(NamedTuple):
    """A loaded ball bearing in equilibrium."""

    motion: RingMotion
    """Where the inner ring stands [m, rad]."""
    force: Floats
    """Load of every ball Q_j [N], (Z,)."""
    contact_angle: Floats
    """Contact angle of every ball α_j [rad], (Z,)."""


class _Balls(NamedTuple):
    """A bearing as its equilibrium sees it; lengths in units of A, the distance of the groove centres."""

    angle: Floats
    radial: float
    """A cos α_0 over A: what the clearance leaves of it [-]."""
    tilt_arm: float
    """R_i over A [-]."""
    couple_arm: float
    """D_pw / 2 over A [-]."""
    stiffness: float
    """c_P A^1.5 [N]."""
    distance: float
    """A [m]."""


def load_distribution(geometry: BearingGeometry, load: RingLoad, *, clearance: float) -> LoadDistribution:
    """Return the loads of the balls of a deep groove bearing and the motion of its inner ring.

    Args:
        geometry: Rolling elements and grooves [m].
        load: On the inner ring [N, N m].
        clearance: Radial operating clearance s [m].

    Source: ISO/TS 16281:2008; equilibrium about D_pw/2, tilt about R_i, as the standard has them.

    Valid for: rigid rings, slow turning (no centrifugal load of the balls).

    Raises:
        DesignError: If the clearance is negative or wider than the grooves, or if nothing loads the bearing.
        SolveError: If no equilibrium is found.
    """
    _check(geometry, load, clearance)
    balls = _balls(geometry, clearance)
    wanted = np.array(load) / np.array([1.0, 1.0, 1.0, balls.distance, balls.distance])
    moved = _equilibrium(balls, wanted)
    residual = float(np.abs(_unbalance(moved, balls, wanted)[0]).max())
    if residual > BALANCED:
        message = f"no equilibrium of the bearing under {tuple(map(float, load))} N, N m"
        raise SolveError(f"{message}: {residual:.2g} of the load is left over")
    squeeze, radial, axial = _squeeze(moved, balls)
    lengths = np.array([balls.distance, balls.distance, balls.distance, 1.0, 1.0])
    motion = RingMotion(*(moved * lengths).tolist())
    return LoadDistribution(motion, balls.stiffness * squeeze**1.5, np.arctan2(axial, radial))


def _equilibrium(balls: _Balls, wanted: Floats) -> Floats:
    """Return the motion that balances the load, or the best found.

    Clearance leaves the balls free, so that nothing holds the ring at first. Weak springs to the housing do, and are
    slackened step by step until only the balls are left.
    """
    arms = np.array([1.0, 1.0, 1.0, balls.tilt_arm, balls.tilt_arm])
    motion = np.zeros(5)
    for schedule in _SCHEDULES:
        motion = np.zeros(5)
        for spring in (*schedule, 0.0):
            motion = _settled(motion, balls, wanted, springs=np.diag(spring * arms**2))
        if np.abs(_unbalance(motion, balls, wanted)[0]).max() < BALANCED:
            break
    return motion


def _settled(motion: Floats, balls: _Balls, wanted: Floats, *, springs: Floats) -> Floats:
    """Return a motion after Newton steps, each taken only as far as it lessens what is left over."""
    residual, slope = _unbalance(motion, balls, wanted)
    residual, slope = residual + springs @ motion, slope + springs
    for _ in range(_STEPS):
        if np.linalg.norm(residual) < 1e-3 * BALANCED:
            break
        step = np.linalg.lstsq(slope, -residual)[0]
        for halving in range(14):
            trial = motion + 0.5**halving * step
            new, tangent = _unbalance(trial, balls, wanted)
            new += springs @ trial
            if np.linalg.norm(new) < np.linalg.norm(residual):
                motion, residual, slope = trial, new, tangent + springs
                break
        else:
            break
    return motion


def _check(geometry: BearingGeometry, load: RingLoad, clearance: float) -> None:
    problems = []
    widest = 2.0 * _groove_distance(geometry)
    if not 0.0 <= clearance < widest:
        message = f"{1e6 * clearance:g} µm given; allowed: 0 to {1e6 * widest:.0f} µm (use 0 for a preloaded bearing)"
        problems.append(Problem("clearance", message))
    if not any(load):
        problems.append(Problem("load", "nothing loads the bearing; give a force or a couple"))
    refuse(problems)


def _groove_distance(geometry: BearingGeometry) -> float:
    """Return A = r_i + r_e − D_w."""
    return (geometry.inner_conformity + geometry.outer_conformity - 1.0) * geometry.diameter


def _balls(geometry: BearingGeometry, clearance: float) -> _Balls:
    distance = _groove_distance(geometry)
    radial = 1.0 - clearance / (2.0 * distance)
    stiffness = load_deflection_constant(
        ball_contacts(geometry), elastic_modulus=STEEL_MODULUS, poisson_ratio=STEEL_POISSON
    )
    groove = (geometry.inner_conformity - 0.5) * geometry.diameter * radial
    return _Balls(
        angle=2.0 * math.pi * np.arange(geometry.elements) / geometry.elements,
        radial=radial,
        tilt_arm=(geometry.pitch_diameter / 2.0 + groove) / distance,
        couple_arm=geometry.pitch_diameter / 2.0 / distance,
        stiffness=stiffness * distance**1.5,
        distance=distance,
    )


def _squeeze(motion: Floats, balls: _Balls) -> tuple[Floats, Floats, Floats]:
    """Return the approach of every ball and the two legs of its groove centres' distance, all over A."""
    cosine, sine = np.cos(balls.angle), np.sin(balls.angle)
    radial = balls.radial + motion[0] * cosine + motion[1] * sine
    axial = motion[2] + balls.tilt_arm * (np.sin(motion[3]) * cosine + np.sin(motion[4]) * sine)
    return np.maximum(np.hypot(radial, axial) - 1.0, 0.0), radial, axial


def _unbalance(motion: Floats, balls: _Balls, wanted: Floats) -> tuple[Floats, Floats]:
    """Return what the balls bear less the load, over the load, and its derivatives."""
    squeeze, radial, axial = _squeeze(motion, balls)
    length = np.hypot(radial, axial)
    along = np.stack([radial, axial]) / length
    across = np.stack([-along[1], along[0]])
    spring, string = 1.5 * np.sqrt(squeeze), squeeze**1.5 / length
    local = spring * along[:, None] * along + string * across[:, None] * across
    cosine, sine, zeros = np.cos(balls.angle), np.sin(balls.angle), np.zeros(len(balls.angle))
    ones = zeros + 1.0
    round_ring = np.stack([cosine, sine])
    moves = np.array([[*round_ring, zeros, zeros, zeros], [zeros, zeros, ones, *(balls.tilt_arm * round_ring)]])
    bears = np.array([[*round_ring, zeros, zeros, zeros], [zeros, zeros, ones, *(balls.couple_arm * round_ring)]])
    moves[1, 3:] *= np.cos(motion[3:])[:, None]
    size = np.abs(wanted).max() / balls.stiffness
    force = np.einsum("dkj,dj->k", bears, squeeze**1.5 * along) / size - wanted / (size * balls.stiffness)
    return force, np.einsum("dkj,dej,elj->kl", bears, local, moves) / size
