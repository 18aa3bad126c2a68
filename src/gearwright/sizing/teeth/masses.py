"""Gear masses of partial choices of tooth numbers, and module and face width of bevel pairs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from gearwright.base import Floats, Ints, Role, largest
from gearwright.sizing.rating import (
    BEARING_GAP,
    LEAST_TORQUE,
    RIM,
    STANDARD_MODULES,
    Ask,
    Load,
    LoadedMesh,
    Rating,
    bevel_module,
    bevel_pair,
    bevel_width,
    least_width,
    mean_module,
    method_for,
    modules,
    next_standard,
    rating_of,
    stage_width_ratio,
    under_spectrum,
)
from gearwright.sizing.rough_mass import around_mass, oil_mass
from gearwright.sizing.teeth.candidates import ring_teeth
from gearwright.sizing.teeth.front import Front, Task
from gearwright.spec import Design, Pair, Planetary, case_named
from gearwright.spec.design import GROUND, module_owners
from gearwright.train import Mesh, PowerFlow, gears_of

# ----------------------------------------------------------------------------------------------------------------------
# Module and face width of a bevel pair as sizing makes them, for the search.
#
# A narrower face of the same outer module has a larger mean module and bears about as much, so that faces become much
# narrower than the widest that are allowed: the search cannot leave that out.
# ----------------------------------------------------------------------------------------------------------------------


def bevel_size(rating: Rating, rows: Sequence[Load], teeth: tuple[int, int], ratio: float) -> tuple[float, float]:
    """Return mean normal module and face width of a bevel pair under the heaviest case of each row [m].

    Args:
        rating: Resolved rules.
        rows: Loads of its rows, as a task of the search has them.
        teeth: z_1, z_2 [-].
        ratio: λ = b/m_mn of the widest face [-].
    """
    if not rows:
        return 0.0, 0.0
    loaded = [_with_teeth(load, teeth, ratio) for load in rows]
    method, rules = method_for(rating), rating.proportions

    def gap(module: float, width: float) -> float:
        meshes = (LoadedMesh(rating, module, width, load, (load,), (0.0, 0.0)) for load in loaded)
        return min(method.reserve_of(mesh) for mesh in meshes)

    needed = max(float(module) for load in loaded for module in modules(load.ask, rating))

    def outer_of(module: float) -> float:
        outer = bevel_pair(teeth, module, ratio * module, rating).outer_module
        return next_standard(outer) if rules is not None and rules.standard_modules else outer

    outer = bevel_module(teeth, outer_of(under_spectrum(needed, ratio, gap, outer_of)), ratio, rating, gap)
    width = bevel_width(teeth, outer, ratio, rating, gap)
    return mean_module(teeth, outer, width, rating), width


def bevel_rows(
    design: Design, meshes: Sequence[Mesh], flows: Mapping[str, PowerFlow], rating: Rating
) -> tuple[Load, ...]:
    """Return of each loaded row of a pair the heaviest case, over the whole life.

    Args:
        design: With its cases.
        meshes: The rows.
        flows: Every load case at the asked ratios.
        rating: Resolved rules.
    """
    lasting = {case: flow for case, flow in flows.items() if not case_named(design, case).static}
    rows = (
        largest((_load(case, mesh, flow, rating) for case, flow in lasting.items()), lambda load: load.torque)
        for mesh in meshes
    )
    return tuple(load for load in rows if load.torque > LEAST_TORQUE)


def _load(case: str, mesh: Mesh, flow: PowerFlow, rating: Rating) -> Load:
    """Return a case as one mesh of a row feels it over the whole life."""
    torque = abs(flow.meshes[mesh.name].torques[0]) / mesh.count * rating.load_factor
    speed = abs(flow.speeds[mesh.nodes[0]] - flow.speeds[mesh.nodes[2]])
    return Load(case, torque, Ask(0.0, (1, 1), 1.0, speed=speed), rating.service.life)


def _with_teeth(load: Load, teeth: tuple[int, int], ratio: float) -> Load:
    return load._replace(ask=load.ask._replace(per_tooth=load.torque / teeth[0], teeth=teeth, width_ratio=ratio))


# ----------------------------------------------------------------------------------------------------------------------
# What the gears of partial choices weigh: their modules, and their bodies over the module's cube.
# ----------------------------------------------------------------------------------------------------------------------


_MM = 1e-3


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
    reference = ring_teeth(task, small, large) if by_ring else small
    speed = front.speeds[task.edge.fast[0]] if task.edge is not None else np.full(len(small), task.speed)
    width_ratio = stage_width_ratio(rating, small, large)
    ask = Ask(
        _torque(task, planets) * task.speed / speed / reference / planets,
        (small, large),
        width_ratio,
        internal=isinstance(stage, Pair) and stage.internal,
        idlers=(False, isinstance(stage, Planetary)),
        speed=task.rolling,
        passes=(planets, 1.0) if isinstance(stage, Planetary) else _mates(stage),
        roles=(Role.SUN, Role.PLANET) if isinstance(stage, Planetary) else (Role.PINION, Role.WHEEL),
        held=(isinstance(stage, Planetary) and stage.sun == GROUND, False),
        bores=_bores(stage),
    )
    ask = _relieved(ask, task)
    if rating.proportions is None:
        cube = _cubes(ask, task)
    else:
        cube, width_ratio, around = _known_sizes(ask, task, reference, speed, planets=planets, discs=discs)
        discs = discs + around / width_ratio
    group = task.group
    cubes = {**front.cubes, group: np.maximum(front.cubes.get(group, 0.0), cube)}
    volume = width_ratio * discs
    volumes = {**front.volumes, group: front.volumes.get(group, 0.0) + volume}
    counts = {task.name: np.full(len(small), planets)} if isinstance(stage, Planetary) else {}
    weighed = Front({**front.teeth, **names}, front.speeds, cubes, volumes, {**front.planets, **counts})
    return replace(weighed, tally=tallied(front.tally, weighed.mass - front.mass))


def tallied(tally: Mapping[str, Floats], added: Floats) -> Mapping[str, Floats]:
    """Return what choices stand for when each of them grows heavier.

    Args:
        tally: Before.
        added: By how much [kg].
    """
    return {**tally, "second": tally["second"] + added} if tally else tally


def _torque(task: Task, planets: int) -> float:
    """Return the largest nominal torque of a stage with so many planets, their own K_γ included [N m]."""
    return task.torque * task.factors.get(planets, task.rating.load_factor) / task.rating.load_factor


def _relieved(ask: Ask, task: Task) -> Ask:
    """Return what is asked with the load for which tips are relieved and the greatest speed."""
    return ask._replace(relieved=task.steady * np.asarray(ask.per_tooth), fastest=task.fastest * np.asarray(ask.speed))


def _cubes(ask: Ask, task: Task) -> Floats:
    """Return the cube of the module that each mesh asks for, in a set that a standard rates that with the ring too."""
    module = np.maximum(*modules(ask, task.rating))
    if isinstance(task.stage, Planetary) and task.rating.proportions is not None:
        module = np.maximum(module, np.maximum(*modules(_in_ring(ask, task), task.rating)))
    return np.asarray(module * module * module)


def _in_ring(ask: Ask, task: Task) -> Ask:
    """Return what is asked of the mesh of planets and ring where sun and planets are asked for."""
    assert isinstance(task.stage, Planetary)
    small, large = (np.asarray(teeth) for teeth in ask.teeth)
    turns = small / large
    return ask._replace(
        teeth=(large, ring_teeth(task, small, large)),
        internal=True,
        idlers=(True, False),
        passes=(1.0, ask.passes[0]),
        roles=(Role.PLANET, Role.RING),
        held=(False, task.stage.ring == GROUND),
        bores=(ask.bores[1], None),
        speed=np.asarray(ask.speed) * turns,
        fastest=np.asarray(ask.fastest) * turns,
    )


def _mates(stage: Pair) -> tuple[float, float]:
    """Return how many mates a tooth of pinion and wheel meets in a turn [-]."""
    return float(len(stage.named(Role.WHEEL))), float(len(stage.named(Role.PINION)))


def _bores(stage: Pair | Planetary) -> tuple[float | None, float | None]:
    if isinstance(stage, Planetary):
        return stage.sun_bore, stage.planet_bore
    return stage.pinion_bore, stage.wheel_bore


def _known_sizes(
    ask: Ask, task: Task, reference: Ints, speed: Floats, *, planets: int, discs: Floats
) -> tuple[Floats, Floats, Floats]:
    """Return m_n³, λ and what is around the gears over m_n³ where a standard rates them: of each pair of numbers once.

    Scaled by m³ ∝ T.
    """
    small, large = (np.asarray(teeth) for teeth in ask.teeth)
    load = task.speed / speed
    pairs = zip(small.tolist(), large.tolist(), strict=True)
    keys = [(first, second, planets, task.deviation) for first, second in pairs]
    if missing := list({key: place for place, key in enumerate(keys) if key not in task.known}.values()):
        new = ask._replace(
            per_tooth=_torque(task, planets) / reference[missing] / planets,
            teeth=(small[missing], large[missing]),
            width_ratio=np.asarray(ask.width_ratio)[missing],
        )
        sizes = _sizes(_relieved(new, task), task, np.asarray(discs)[missing], planets=planets)
        task.known.update(zip([keys[k] for k in missing], sizes, strict=True))
    cubes, widths, around = np.array([task.known[key] for key in keys]).reshape(-1, 3).T
    return cubes * load, widths, around


def _sizes(ask: Ask, task: Task, discs: Floats, *, planets: int) -> Iterator[tuple[float, float, float]]:
    """Yield m_n³ [m³], λ and what is around over m_n³ [kg/m³] of every choice, about as sizing makes them."""
    small, large, ratios = (np.asarray(column).tolist() for column in (*ask.teeth, ask.width_ratio))
    if task.rating.kind == "bevel":
        for teeth, ratio in zip(zip(small, large, strict=True), ratios, strict=True):
            mean, width = bevel_size(task.rating, task.rows, teeth, ratio)
            own = ask._replace(teeth=(np.array(teeth[:1]), np.array(teeth[1:])))
            (beside,) = _around(own, task, np.array([mean]), np.array([width]), planets=planets).tolist()
            yield mean * mean * mean, width / mean, beside / mean**3
        return
    needed = np.cbrt(_cubes(ask, task))
    found = _on_grid(ask, task, needed, discs, planets=planets) if task.rating.width_is_open else None
    if found is None:
        modules, widths = needed, np.asarray(ask.width_ratio) * needed
        around = _around(ask, task, modules, widths, planets=planets)
    else:
        modules, widths, masses = found
        around = masses - np.asarray(discs) * widths * modules**2
    yield from zip(*(column.tolist() for column in (modules**3, widths / modules, around / modules**3)), strict=True)


# ----------------------------------------------------------------------------------------------------------------------
# Standard modules and whole millimetres of width of many choices at once, by a few ratings of each module.
# ----------------------------------------------------------------------------------------------------------------------


_TRIED = 11
"""Standard modules that are tried of each choice [-]."""
_BELOW = 3
"""How many of them are smaller than what it needs at the widest face in its heaviest case [-]."""
_ROUNDS = 5
"""Ratings by which the face width of each is found [-]."""
_SLOPES = (0.5, 8.0)
"""Powers of the width with which the load may grow that a size bears [-]."""
_SHORT = 10.0
"""Factor on the mass of a size that is too weak, so that it is taken where none is strong enough [-]."""
_BESIDE = 1.5
"""Factor on the mass of a size that runs in a resonance or the like, for which a wider face may do [-]."""


def _on_grid(
    ask: Ask, task: Task, needed: Floats, discs: Floats, *, planets: int
) -> tuple[Floats, Floats, Floats] | None:
    """Return module and face width [m] with which a gearbox of every choice weighs least, and what it weighs [kg].

    None where its method rates no arrays.

    Args:
        ask: Of choices.
        task: The stage.
        needed: Module that each needs with its widest face [m].
        discs: What its bodies weigh over b m_n² [kg/m³].
        planets: Of a planetary set [-].
    """
    modules = _modules(task, needed)
    count, asks = modules.shape[1], (ask, _in_ring(ask, task)) if isinstance(task.stage, Planetary) else (ask,)
    each = [_repeated(own, count) for own in asks]
    wide = np.asarray(ask.width_ratio)[:, None] * modules
    narrow = np.minimum(_narrow(task, modules), wide)
    widths, before, slope = np.clip(wide * (needed[:, None] / modules) ** 3, narrow, wide), None, np.ones_like(modules)
    for _ in range(_ROUNDS):
        near = [_near(task, own, modules, widths) for own in each]
        if any(one is None for one in near):
            return None
        strength, rest = (np.minimum.reduce(column).reshape(modules.shape) for column in zip(*near, strict=True))
        now = np.log(widths), np.log(np.maximum(strength, 1e-6))
        if before is not None:
            moved = np.where(now[0] == before[0], 1.0, now[0] - before[0])
            slope = np.clip(np.where(now[0] == before[0], slope, (now[1] - before[1]) / moved), *_SLOPES)
        wanted = np.ceil(widths * np.exp(-now[1] / slope) / _MM - 1e-6) * _MM
        widths, before = np.clip(wanted, narrow, wide), now
    short = np.where(wanted > wide * (1.0 + 1e-9), _SHORT, 1.0) * np.where(rest < 1.0, _BESIDE, 1.0)
    around = _around(each[0], task, modules.ravel(), widths.ravel(), planets=planets).reshape(modules.shape)
    masses = short * (discs[:, None] * widths * modules**2 + around)
    best = np.arange(len(modules)), np.argmin(masses, axis=1)
    return modules[best], widths[best], masses[best]


def _modules(task: Task, needed: Floats) -> Floats:
    """Return the modules that are tried of every choice, shape (choices, modules) [m]."""
    rules = task.rating.proportions
    assert rules is not None
    if not rules.standard_modules:
        return needed[:, None] * np.asarray(1.12 ** np.arange(-_BELOW, _TRIED - _BELOW))
    series = [_MM * module for module in STANDARD_MODULES]
    while series[-1] < needed.max(initial=0.0):
        series.append(1.1 * series[-1])
    table = np.array(series + [series[-1] * 1.1 ** (k + 1) for k in range(_TRIED)])
    first = np.maximum(np.searchsorted(table, needed * (1.0 - 1e-9)) - _BELOW, 0)
    return np.asarray(table[first[:, None] + np.arange(_TRIED)])


def _narrow(task: Task, modules: Floats) -> Floats:
    """Return the narrowest faces that are tried, in whole millimetres [m]."""
    return np.ceil(modules * (least_width(task.rating, 1.0) / _MM) - 1e-9) * _MM


def _repeated(ask: Ask, count: int) -> Ask:
    """Return what is asked of choices, each so many times."""

    def each(value: Any) -> Any:
        numbers = np.asarray(value)
        return np.repeat(numbers, count) if numbers.ndim else value

    return ask._replace(
        teeth=(each(ask.teeth[0]), each(ask.teeth[1])),
        per_tooth=each(ask.per_tooth),
        width_ratio=each(ask.width_ratio),
        speed=each(ask.speed),
        relieved=each(ask.relieved),
        fastest=each(ask.fastest),
    )


def _near(task: Task, ask: Ask, modules: Floats, widths: Floats) -> tuple[Floats, Floats] | None:
    """Return how near sizes come to what all cases ask of a mesh; None: no arrays are rated."""
    torque, speed = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0]), np.asarray(ask.speed)
    loads = [
        Load(part.case, part.torque * torque, ask._replace(speed=part.speed * speed), part.life, part.static)
        for part in task.parts
    ]
    alone = Load("", torque, ask, task.rating.service.life)
    lasting = tuple(load for load in loads if load.life > 0.0) or (alone,)
    others = tuple(load for load in loads if load.life <= 0.0)
    mesh = LoadedMesh(task.rating, modules.ravel(), widths.ravel(), alone, lasting, (0.0, 0.0), others)
    return method_for(task.rating).of_sizes(mesh, ())


def _around(ask: Ask, task: Task, modules: Floats, widths: Floats, *, planets: int) -> Floats:
    """Return about what carries, encloses and cools the gears of sizes [kg]."""
    if task.around is None:
        return np.zeros(len(modules))
    small, large = (np.asarray(teeth) for teeth in ask.teeth)
    teeth, planet = [small, large], np.zeros(1)
    if isinstance(task.stage, Planetary):
        teeth.append(ring_teeth(task, small, large))
        square = large**2 - BEARING_GAP * _inside(large) if task.made else large**2
        planet = task.rating.material.density * math.pi / 4.0 * square * widths * modules**2
    factor = task.factors.get(planets, task.rating.load_factor)
    return around_mass(
        task.around, teeth, modules, widths, planet=planet, planets=planets, factor=factor
    ) + oil_mass(task.around, teeth, modules, widths, planets=planets)  # fmt: skip


def _bodies(task: Task, small: Ints, large: Ints, *, planets: int) -> tuple[dict[str, Ints], Floats]:
    """Return the stage's gears and the mass of its own bodies over b m_n² [kg/m³]."""
    stage, rating = task.stage, task.rating
    cosine = math.cos(rating.helix_angle)
    disc = math.pi / 4.0 * rating.material.density / cosine**2
    wall = rating.rules.rim_thickness_ratio
    if isinstance(stage, Planetary):
        ring = ring_teeth(task, small, large)
        annulus = _annulus(ring, wall)
        teeth = dict(zip(gears_of(task.name, stage), (small, large, ring), strict=True))
        planet = large**2 - BEARING_GAP * _inside(large) if task.made else large**2
        return teeth, np.asarray(disc * (small**2 + planets * planet + annulus), dtype=np.float64)
    pinion, wheel = gears_of(task.name, stage)
    wheel_square = (
        _annulus(large, wall * cosine) if stage.internal else rating.rules.web_ratio * large.astype(float) ** 2
    )
    if task.made and not stage.internal and rating.rules.web_ratio == 1.0:
        wheel_square = large**2 - (1.0 - rating.rules.web_thickness_ratio) * _inside(large)
    squares = {Role.PINION: small.astype(float) ** 2, Role.WHEEL: wheel_square}
    factor: Floats = np.zeros(len(small))
    for side, square in squares.items():
        if stage.shared(side) is None:
            factor = np.asarray(factor + disc * (len(stage.named(side)) * stage.halves) * square, dtype=np.float64)
    return {pinion: small, wheel: large}, factor


def _inside(teeth: Ints) -> Floats:
    """Return (d_i/m)² inside the rim of a gear whose wall is as thick as teeth and their backing ask [-]."""
    return np.asarray(np.maximum(teeth - 2.0 * RIM, 0.0) ** 2, dtype=np.float64)


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
