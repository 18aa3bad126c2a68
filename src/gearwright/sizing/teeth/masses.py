"""What the gears of partial choices weigh: their modules, and their bodies over the module's cube."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.identity import Role
from gearwright.sizing.rating import Ask, modules, rating_of, stage_width_ratio
from gearwright.sizing.teeth.candidates import ring_teeth
from gearwright.sizing.teeth.front import Front, Task
from gearwright.spec import Design, Pair, Planetary
from gearwright.spec.design import module_owners
from gearwright.train import gears_of


def weigh(front: Front, task: Task, small: Ints, large: Ints, *, planets: int) -> Front:
    """Return the front with a stage's teeth, module and bodies.

    Args:
        front: Choices of the stages before.
        task: The stage.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
        planets: Of a planetary set; 1 of a pair [-].
    """
    stage, rating = task.stage, task.rating
    names, discs = _bodies(task, small, large, planets=planets)
    by_ring = isinstance(stage, Planetary) and task.edge is not None and task.edge.grounded is Role.SUN
    reference = ring_teeth(stage, small, large) if by_ring and isinstance(stage, Planetary) else small
    speed = front.speeds[task.edge.fast[0]] if task.edge is not None else np.full(len(small), task.speed)
    per_tooth = task.torque * task.speed / speed / reference / planets
    width_ratio = stage_width_ratio(rating, small, large)
    ask = Ask(
        per_tooth,
        (small, large),
        width_ratio,
        internal=isinstance(stage, Pair) and stage.internal,
        idlers=(False, isinstance(stage, Planetary)),
        speed=task.rolling,
        passes=(planets, 1.0),
    )
    bending, contact = modules(ask, rating)
    module = np.maximum(bending, contact)
    cube = module * module * module
    group = task.group
    cubes = {**front.cubes, group: np.maximum(front.cubes.get(group, 0.0), cube)}
    volumes = {**front.volumes, group: front.volumes.get(group, 0.0) + width_ratio * discs}
    counts = {task.name: np.full(len(small), planets)} if isinstance(stage, Planetary) else {}
    return Front({**front.teeth, **names}, front.speeds, cubes, volumes, {**front.planets, **counts})


def _bodies(task: Task, small: Ints, large: Ints, *, planets: int) -> tuple[dict[str, Ints], Floats]:
    """Return the stage's gears and the mass of its own bodies over b m_n² [kg/m³]."""
    stage, rating = task.stage, task.rating
    cosine = math.cos(rating.helix_angle)
    disc = math.pi / 4.0 * rating.material.density / cosine**2
    wall = rating.rules.rim_thickness_ratio
    if isinstance(stage, Planetary):
        ring = ring_teeth(stage, small, large)
        annulus = _annulus(ring, wall)
        teeth = dict(zip(gears_of(task.name, stage), (small, large, ring), strict=True))
        return teeth, np.asarray(disc * (small**2 + planets * large**2 + annulus), dtype=np.float64)
    pinion, wheel = gears_of(task.name, stage)
    wheel_square = (
        _annulus(large, wall * cosine) if stage.internal else rating.rules.web_ratio * large.astype(float) ** 2
    )
    squares = {Role.PINION: small.astype(float) ** 2, Role.WHEEL: wheel_square}
    factor: Floats = np.zeros(len(small))
    for side, square in squares.items():
        if stage.shared(side) is None:
            factor = np.asarray(factor + disc * (len(stage.named(side)) * stage.halves) * square, dtype=np.float64)
    return {pinion: small, wheel: large}, factor


def _annulus(teeth: Ints, wall: float) -> Floats:
    """Return (d_o² − d²)/m_t² of a ring whose wall is so many transverse modules thick [-]."""
    return np.asarray((teeth + 2.0 * wall) ** 2 - teeth**2, dtype=np.float64)


def aligned(front: Front, design: Design) -> Front:
    """Return the front with modules at which pairs on the same axes have one centre distance, that of the larger.

    Args:
        front: Choices of all stages.
        design: With the pairs.
    """
    cubes, group = dict(front.cubes), module_owners(design)
    for name, pair in design.pairs.items():
        if pair.coaxial_with is None:
            continue
        spans = {tied: _span(front, tied, design) for tied in (name, pair.coaxial_with)}
        distance = np.max([cubes[group[tied]] * span**3 for tied, span in spans.items()], axis=0)
        cubes |= {group[tied]: distance / span**3 for tied, span in spans.items()}
    return replace(front, cubes=cubes)


def _span(front: Front, name: str, design: Design) -> Floats:
    """Return a pair's centre distance over its normal module [-]."""
    pair = design.pairs[name]
    pinion, wheel = (front.teeth[gear] for gear in gears_of(name, pair))
    helix = math.cos(rating_of(design, name).helix_angle)
    return np.asarray((wheel - pinion if pair.internal else wheel + pinion) / (2.0 * helix))
