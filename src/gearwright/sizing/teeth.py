"""Choose the tooth numbers: every admissible combination is evaluated, and the lightest gears win.

Stages are taken from the kept machines outwards, so that a stage's target is what the teeth chosen so far leave of the
asked speeds. A front holds all partial choices at once as arrays; each stage multiplies it by its candidates.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearwright.errors import DesignError, Problem
from gearwright.parts.planets import assembles, neighbours_clear
from gearwright.sizing.rating import Rating, modules, rating_of
from gearwright.sizing.refusal import refusal
from gearwright.spec import Design, Pair, Planetary
from gearwright.train.flow import RATED, PowerFlow, asked_speeds, power_flow
from gearwright.train.graph import Train, gear_of
from gearwright.train.kinematics import rows, solve_speeds
from gearwright.train.targets import Edge, Targets

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Front:
    """All partial choices: every array has one entry per choice."""

    teeth: Mapping[str, Integers]
    """Gear -> tooth numbers."""
    speeds: Mapping[str, Floats]
    """Shaft -> speed that the teeth give [rad/s]."""
    cubes: Mapping[str, Floats]
    """Group of gears with one module -> m_n³ [m³]."""
    volumes: Mapping[str, Floats]
    """Group -> mass of its bodies over m_n³ [kg/m³]."""

    @property
    def mass(self) -> Floats:
        """Mass of the gears chosen so far [kg]."""
        parts = [self.cubes[group] * self.volumes[group] for group in self.cubes]
        return np.sum(parts, axis=0) if parts else np.zeros(1)

    def take(self, index: Integers) -> Front:
        """Return the choices of an index, repeated where it repeats them."""
        picked = [
            {name: value[index] for name, value in part.items()} for part in (self.speeds, self.cubes, self.volumes)
        ]
        return Front({name: value[index] for name, value in self.teeth.items()}, *picked)


@dataclass(frozen=True)
class Task:
    """One stage of the search."""

    name: str
    stage: Pair | Planetary
    edge: Edge | None
    group: str
    rating: Rating
    torque: float
    """Largest nominal torque on the stage's reference gear per mesh, share and K_γ included [N m]."""
    speed: float
    """Nominal speed that belongs to it [rad/s]."""


def choose_teeth(design: Design, train: Train, nominal: Targets) -> dict[str, int]:
    """Return the tooth number of every gear.

    Args:
        design: Given teeth are kept, those left out are chosen.
        train: Its graph.
        nominal: Speeds and ratios asked.

    Raises:
        DesignError: If a stage has no candidate; with what would do.
    """
    flow, kept = _nominal_flow(design, train, nominal)
    tasks = [_task(name, design, train, nominal, flow) for name in design.stages]
    front = Front({}, {shaft: np.array([nominal.speeds[shaft]]) for shaft in kept}, {}, {})
    while tasks:
        task = next((each for each in tasks if _ready(each, front)), None)
        if task is None:
            break
        tasks.remove(task)
        front = _joined(design, _extend(front, task, design, nominal))
    best = front.take(np.array([int(np.argmin(front.mass))]))
    return {name: int(value[0]) for name, value in best.teeth.items()}


def _nominal_flow(design: Design, train: Train, nominal: Targets) -> tuple[dict[str, PowerFlow], set[str]]:
    """Return the power flow of every case at the asked ratios, and the shafts whose speed is kept."""
    real: dict[str, float] = {}
    for name, stage in design.stages.items():
        ratio = nominal.tooth_ratios[name]
        if isinstance(stage, Planetary):
            real |= {f"{name}.sun": 1.0, f"{name}.planet": (ratio - 1.0) / 2.0, f"{name}.ring": ratio}
        else:
            pinion, wheel = (gear_of(name, side, stage) for side in ("pinion", "wheel"))
            size = real.get(pinion) or (real[wheel] / ratio if wheel in real else 1.0)
            real |= {pinion: size, wheel: size * ratio}
    flows = {case: power_flow(design, train, real, case) for case in (RATED, *design.cases)}
    asked = asked_speeds(design, {})
    _, yielded = solve_speeds(train, rows(train, real, train.joints), asked)
    free = {each.machine for each in yielded}
    return flows, {train.machines[machine] for machine in asked if machine not in free}


def groups_of(design: Design) -> dict[str, str]:
    """Return stage -> the stage whose module it shares.

    Args:
        design: With its pairs; a pair that shares a gear has its owner's module.
    """
    owner = {name: name for name in design.stages}
    for name, pair in design.pairs.items():
        for side in ("pinion", "wheel"):
            other = gear_of(name, side, pair).partition(".")[0]
            if other != name:
                owner[name] = other
    return owner


def _task(name: str, design: Design, train: Train, nominal: Targets, flows: Mapping[str, PowerFlow]) -> Task:
    stage, edge = design.stages[name], nominal.edges.get(name)
    rating = rating_of(design.rules(name), helical=isinstance(stage, Pair))
    # The reference gear sits on the edge's fast shaft: the ring where the sun stands still, else sun or pinion.
    meshes = [mesh for mesh in train.meshes if mesh.stage == name]
    ring = edge is not None and edge.grounded == "sun"
    own_rows = meshes[1:] if ring else (meshes[:1] if isinstance(stage, Planetary) else meshes)
    torque, speed = 0.0, 1.0
    for flow in flows.values():
        for mesh in own_rows:
            each = abs(flow.meshes[mesh.name].torques[1 if ring else 0]) / mesh.count * rating.load_factor
            if each > torque:
                torque = each
                speed = abs(flow.speeds[mesh.nodes[1 if ring else 0]])
    return Task(name, stage, edge, groups_of(design)[name], rating, torque, speed)


def _ready(task: Task, front: Front) -> bool:
    """Tell whether the speeds on one side of a stage, and the teeth that it shares, are chosen."""
    if isinstance(task.stage, Pair):
        shared = [gear_of(task.name, side, task.stage) for side in ("pinion", "wheel")]
        if any(gear.partition(".")[0] != task.name and gear not in front.teeth for gear in shared):
            return False
    if task.edge is None:
        members = [getattr(task.stage, member) for member in ("sun", "ring", "carrier")]
        return sum(member in front.speeds for member in members) >= 2
    return task.edge.fast[0] in front.speeds or task.edge.slow[0] in front.speeds


def _joined(design: Design, front: Front) -> Front:
    """Carry speeds across clutches."""
    speeds = dict(front.speeds)
    for clutch in design.clutches.values():
        ends = (clutch.driving, clutch.driven)
        for here, there in (ends, ends[::-1]):
            if here in speeds and there not in speeds and clutch.kind != "open":
                speeds[there] = speeds[here]
    return replace(front, speeds=speeds)


def _extend(front: Front, task: Task, design: Design, nominal: Targets) -> Front:
    """Multiply the front by a stage's candidates and keep those that its rules admit."""
    target = _target(front, task, nominal)
    parent, small, large = _candidates(front, task, design, target)
    actual = large / small
    if isinstance(task.stage, Planetary):
        actual = 1.0 + 2.0 * large / small
    edge = task.edge
    ratio = np.array([1.0]) if edge is None else _speed_ratio(edge, actual)
    asked = None if edge is None else _speed_ratio(edge, target[parent])
    good = _admissible(task, design, small, large)
    if asked is not None and not _given(task.stage):
        good &= np.abs(ratio / asked - 1.0) <= design.teeth.stage_tolerance
    if edge is not None:
        speeds = _new_speeds(front, edge, parent, ratio)
        good &= _speeds_hold(design, speeds, task)
    if not good.any():
        raise refusal(task.name, task.stage, design, float(np.median(target)))
    grown = front.take(parent[good])
    if edge is not None:
        grown = replace(grown, speeds={**grown.speeds, **{shaft: value[good] for shaft, value in speeds.items()}})
    return _weigh(grown, task, small[good], large[good], design)


def _target(front: Front, task: Task, nominal: Targets) -> Floats:
    """Return the tooth ratio asked of every choice in the front [-]."""
    count = len(next(iter(front.speeds.values())))
    if task.edge is None:
        return np.full(count, nominal.tooth_ratios[task.name])
    fast = front.speeds.get(task.edge.fast[0], np.full(count, nominal.speeds[task.edge.fast[0]]))
    slow = front.speeds.get(task.edge.slow[0], np.full(count, nominal.speeds[task.edge.slow[0]]))
    ratio = fast / slow
    match task.edge.grounded:
        case "ring":
            return np.asarray(ratio - 1.0)
        case "sun":
            return np.asarray(1.0 / (ratio - 1.0))
        case _:
            return np.asarray(ratio)


def _speed_ratio(edge: Edge, tooth_ratio: Floats) -> Floats:
    match edge.grounded:
        case "ring":
            return 1.0 + tooth_ratio
        case "sun":
            return 1.0 + 1.0 / tooth_ratio
        case _:
            return tooth_ratio


def _given(stage: Pair | Planetary) -> bool:
    if isinstance(stage, Pair):
        return bool(stage.pinion_teeth and stage.wheel_teeth)
    return sum(each is not None for each in (stage.sun_teeth, stage.planet_teeth, stage.ring_teeth)) >= 2


def _candidates(front: Front, task: Task, design: Design, target: Floats) -> tuple[Integers, Integers, Integers]:
    """Return parents, and the tooth numbers of pinion and wheel, or of sun and planet."""
    stage, rules = task.stage, design.teeth
    if isinstance(stage, Planetary):
        first, second = _planetary_given(stage)
        small = np.array([first]) if first else np.arange(rules.sun_minimum, rules.sun_maximum + 1)
        wanted = (target[:, None] - 1.0) / 2.0 * small
        return _neighbours(wanted, small, second)
    pinion, wheel = (gear_of(task.name, side, stage) for side in ("pinion", "wheel"))
    if wheel in front.teeth:
        large = front.teeth[wheel]
        return _around(large / target, large, stage.pinion_teeth)
    if pinion in front.teeth:
        parent, large, small_ = _around(front.teeth[pinion] * target, front.teeth[pinion], stage.wheel_teeth)
        return parent, small_, large
    fewest = rules.pinion_minimum or fewest_teeth(task.rating)
    small = np.array([stage.pinion_teeth]) if stage.pinion_teeth else np.arange(fewest, rules.pinion_maximum + 1)
    return _neighbours(target[:, None] * small, small, stage.wheel_teeth)


def _planetary_given(stage: Planetary) -> tuple[int | None, int | None]:
    """Return the sun's and the planets' teeth, where they are given or follow."""
    sun, planet, ring = stage.sun_teeth, stage.planet_teeth, stage.ring_teeth
    if sun is None and planet is not None and ring is not None:
        sun = ring - 2 * planet
    if planet is None and sun is not None and ring is not None and (ring - sun) % 2 == 0:
        planet = (ring - sun) // 2
    return sun, planet


def fewest_teeth(rating: Rating, profile_shift: float = 0.0) -> int:
    """Return the smallest tooth number without undercut [-].

    Args:
        rating: Resolved rules: pressure and helix angle.
        profile_shift: x [-].

    Source: z_min = 2 cos β (1 − x) / sin² α_t; Pulvirenti 2023, eq. (2.6) has its approximation with cos³ β / sin² α_n.
    """
    transverse = math.atan(math.tan(rating.rules.pressure_angle) / math.cos(rating.helix_angle))
    return math.ceil(2.0 * math.cos(rating.helix_angle) * (1.0 - profile_shift) / math.sin(transverse) ** 2)


def _neighbours(wanted: Floats, small: Integers, given: int | None) -> tuple[Integers, Integers, Integers]:
    """Return every choice of the front with every small gear and the integers around the wanted large one."""
    parent = np.arange(len(wanted))[:, None, None]
    low = np.floor(wanted).astype(np.int64)[:, :, None]
    large = low + np.arange(2) if given is None else np.full((*low.shape[:2], 1), given)
    parent, teeth, large = np.broadcast_arrays(parent, small[None, :, None], large)
    return parent.ravel(), teeth.ravel().astype(np.int64), large.ravel().astype(np.int64)


def _around(wanted: Floats, large: Integers, given: int | None) -> tuple[Integers, Integers, Integers]:
    """Return the integers around the wanted gear that meshes with one that is chosen already."""
    low = np.floor(wanted).astype(np.int64)[:, None]
    small = low + np.arange(2) if given is None else np.full((len(low), 1), given)
    parent, teeth, shared = np.broadcast_arrays(np.arange(len(low))[:, None], small, large[:, None])
    return parent.ravel(), teeth.ravel(), shared.ravel()


def _admissible(task: Task, design: Design, small: Integers, large: Integers) -> NDArray[np.bool_]:
    """Tell which tooth numbers can be made and put together."""
    rules, stage = design.teeth, task.stage
    if isinstance(stage, Planetary):
        ring = small + 2 * large
        good = assembles(small, ring, stage.planets) & neighbours_clear(small, large, stage.planets)
        good &= large >= rules.planet_minimum
        if rules.hunting:
            good &= (np.gcd(small, large) == 1) & (np.gcd(large, ring) == 1)
        return good
    good = np.minimum(small, large) >= (rules.pinion_minimum or fewest_teeth(task.rating))
    if stage.pinion_teeth:
        good = np.ones(len(small), dtype=bool)
    if rules.hunting:
        good &= np.gcd(small, large) == 1
    return good


def _new_speeds(front: Front, edge: Edge, parent: Integers, ratio: Floats) -> dict[str, Floats]:
    """Return the speeds of the shafts on the far side of a stage."""
    if edge.fast[0] in front.speeds:
        return dict.fromkeys(edge.slow, front.speeds[edge.fast[0]][parent] / ratio)
    return dict.fromkeys(edge.fast, front.speeds[edge.slow[0]][parent] * ratio)


def _speeds_hold(design: Design, speeds: Mapping[str, Floats], task: Task) -> NDArray[np.bool_]:
    """Tell which choices keep the machines' speeds within the tolerance."""
    good = np.ones(len(next(iter(speeds.values()))), dtype=bool)
    for machine in design.machines.values():
        if machine.shaft in speeds and not _given(task.stage):
            good &= np.abs(speeds[machine.shaft] / machine.speed - 1.0) <= design.teeth.speed_tolerance
    return good


def _weigh(front: Front, task: Task, small: Integers, large: Integers, design: Design) -> Front:
    """Add a stage's teeth, module and bodies to the front."""
    stage, rating = task.stage, task.rating
    names, factor = _bodies(task, small, large)
    reference = small + 2 * large if task.edge is not None and task.edge.grounded == "sun" else small
    speed = front.speeds[task.edge.fast[0]] if task.edge is not None else np.full(len(small), task.speed)
    per_tooth = task.torque * task.speed / speed / reference
    bending, contact = modules(
        per_tooth,
        (small, large),
        rating,
        internal=isinstance(stage, Pair) and stage.internal,
        idler=isinstance(stage, Planetary),
    )
    cube = np.maximum(bending, contact) ** 3
    group = task.group
    cubes = {**front.cubes, group: np.maximum(front.cubes.get(group, 0.0), cube)}
    volumes = {**front.volumes, group: front.volumes.get(group, 0.0) + factor}
    return Front({**front.teeth, **names}, front.speeds, cubes, volumes)


def _bodies(task: Task, small: Integers, large: Integers) -> tuple[dict[str, Integers], Floats]:
    """Return the stage's gears and the mass of its own bodies over m_n³ [kg/m³]."""
    stage, rating = task.stage, task.rating
    disc = math.pi / 4.0 * rating.width_ratio * rating.material.density / math.cos(rating.helix_angle) ** 2
    if isinstance(stage, Planetary):
        ring = small + 2 * large
        wall = rating.rules.rim_thickness_ratio
        annulus = (ring + 2.0 * wall) ** 2 - ring**2
        teeth = {f"{task.name}.sun": small, f"{task.name}.planet": large, f"{task.name}.ring": ring}
        return teeth, np.asarray(disc * (small**2 + stage.planets * large**2 + annulus), dtype=np.float64)
    gears = {side: gear_of(task.name, side, stage) for side in ("pinion", "wheel")}
    counts = {
        side: (len(getattr(stage, side)) if isinstance(getattr(stage, side), list) else 1) * stage.halves
        for side, gear in gears.items()
        if gear == f"{task.name}.{side}"
    }
    squares = {"pinion": small.astype(float) ** 2, "wheel": rating.rules.web_ratio * large.astype(float) ** 2}
    factor: Floats = np.zeros(len(small))
    for side, count in counts.items():
        factor = np.asarray(factor + disc * count * squares[side], dtype=np.float64)
    return {gears["pinion"]: small, gears["wheel"]: large}, factor


def unresolved(design: Design, teeth: Mapping[str, int]) -> DesignError | None:
    """Return the error of stages that the search could not reach, if any.

    Args:
        design: The design.
        teeth: What was chosen.
    """
    missing = [name for name in design.stages if not any(gear.startswith(f"{name}.") for gear in teeth)]
    if not missing:
        return None
    return DesignError([Problem(name, "no machine's speed leads to this stage") for name in missing])
