"""Module and face width of stages, including compound stages, unloaded gears and load sharing by size."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import NamedTuple

from gearwright.base import DesignError, Problem, Role, refuse
from gearwright.catalogue import LEAST_SHARING
from gearwright.parts.bevel_geometry import WIDEST, WIDEST_MODULES
from gearwright.parts.iso6336 import mesh_springs
from gearwright.parts.planetary import clocking_load_factor, path_stiffness, tolerance_load_factor
from gearwright.sizing.rating import (
    CORRECTIONS,
    JUST,
    Context,
    Demand,
    Gap,
    bevel_module,
    bevel_pair,
    bevel_width,
    cone_ratio,
    cylindrical_mesh,
    load_sharing,
    mean_module,
    narrowest,
    next_standard,
    overlap_width,
    row_reserve,
    scuffing_ratio,
    strong_enough,
    under_spectrum,
    whole,
)
from gearwright.sizing.rating.iso6336_inputs import steels_of
from gearwright.sizing.result import GearSizing, MeshSizing
from gearwright.spec import Epicyclic, Pair, Planetary
from gearwright.spec.design import module_owners, relative_modules, split_levels
from gearwright.train import INTERNAL, Mesh

# ----------------------------------------------------------------------------------------------------------------------
# Gears that no load case loads: strength asks nothing of them, so that they have no size but a given one.
# ----------------------------------------------------------------------------------------------------------------------


NOTHING = 1e-9
"""Torque over the largest of its kind below which it is rounding [-]."""


def refuse_idle_stages(context: Context, needed: Mapping[str, float]) -> None:
    """Raise where nothing loads the gears of a stage whose module is not given.

    Args:
        context: What gear sizing reads.
        needed: Stage -> module that its meshes, or a stage on the same axes, ask for [m].

    Raises:
        DesignError: For every such stage, with what to give.
    """
    largest = max(needed.values(), default=0.0)
    if not math.isfinite(largest):
        return
    problems = []
    for stage, module in needed.items():
        is_given = f"{stage}.module" in context.given or f"{stage}.outer_module" in context.given
        if module > math.cbrt(NOTHING) * largest or is_given:
            continue
        table = "pairs" if stage in context.design.pairs else "planetaries"
        key = "outer_module_mm" if context.ratings[stage].kind == "bevel" else "module_mm"
        message = (
            "no load case sends power through these gears, so that strength asks for no module; write one here, such as"
            f" {key} = 2, or a case that loads them"
        )
        problems.append(Problem(f"{table}.{stage}", message))
    refuse(problems)


# ----------------------------------------------------------------------------------------------------------------------
# Module and face width of every stage: what its meshes ask, rounded as its rules say, or as the user gives them.
# ----------------------------------------------------------------------------------------------------------------------


class StageSize(NamedTuple):
    """Size of one stage."""

    module: float
    """m_n, of bevel gears m_mn [m]."""
    face_width: float
    """b, as far as it can carry [m]."""
    asked_width: float
    """b as the user gives it, which may be more than a bevel gear can have [m]."""

    def planes(self, count: int) -> StageSize:
        """Return the size of a gear that lies in several planes of one face width each.

        Args:
            count: Planes [-].
        """
        return self._replace(face_width=count * self.face_width)


def stage_sizes(context: Context, demands: Mapping[str, Demand]) -> dict[str, StageSize]:
    """Return module and face width of every stage: the largest that a mesh of its group asks for.

    Args:
        context: What gear sizing reads.
        demands: Mesh row -> what it asks for.

    Raises:
        DesignError: If nothing loads a stage, or its standard does not cover it.
    """
    group = module_owners(context.design)
    needed: dict[str, float] = {}
    for mesh in context.train.meshes:
        if mesh.stage not in group:
            continue
        owner = group[mesh.stage]
        needed[owner] = max(needed.get(owner, 0.0), *demands[mesh.name][2:])
    _align(context, needed, group)
    refuse_idle_stages(context, needed)
    for tied in _tied(context, group):
        _bear_together(context, needed, tied)
    sizes = {owner: _size(context, owner, value, demands) for owner, value in needed.items()}
    return {stage: _like(context, stage, owner, sizes[owner]) for stage, owner in group.items()}


def _like(context: Context, stage: str, owner: str, size: StageSize) -> StageSize:
    """Return the size of a stage that has its owner's module, and its own face width."""
    if stage == owner:
        return size
    width = context.width_ratios[stage] * size.module
    if context.ratings[stage].width_is_open:  # a gear of both is as wide as its owner's
        width = min(width, size.face_width)
    width = context.given.get(f"{stage}.face_width", width)
    return StageSize(size.module, width, width)


def _align(context: Context, needed: dict[str, float], group: Mapping[str, str]) -> None:
    """Raise modules until pairs on the same axes have the larger one's centre distance."""
    for links in _links(context):
        spans = {tied: _span(context, tied) for tied in links}
        distance = max(_asked(context, needed, group[tied]) * span for tied, span in spans.items())
        for tied, span in spans.items():
            needed[group[tied]] = distance / span


def _links(context: Context) -> list[tuple[str, str]]:
    """Return every pair that stands on the axes of another one, with that one."""
    pairs = context.design.pairs.items()
    return [(name, pair.coaxial_with) for name, pair in pairs if pair.coaxial_with is not None]


def _asked(context: Context, needed: Mapping[str, float], stage: str) -> float:
    return context.given.get(f"{stage}.module", needed[stage])


def _tied(context: Context, group: Mapping[str, str]) -> list[set[str]]:
    """Return the stages whose modules are in a fixed ratio, as they stand on common axes; those that share one once."""
    found = list[set[str]]()
    for links in _links(context):
        own = {group[tied] for tied in links}
        apart = [tied for tied in found if not tied & own]
        found = [*apart, own.union(*(tied for tied in found if tied & own))]
    return found


def _bear_together(context: Context, needed: dict[str, float], tied: set[str]) -> None:
    """Scale the modules of stages on common axes until all bear their loads with whole millimetres of width."""
    if any(context.ratings[stage].proportions is None or f"{stage}.module" in context.given for stage in tied):
        return
    for number in range(2 * CORRECTIONS):
        sizes = ((stage, needed[stage], _widest(context, stage, needed[stage])) for stage in sorted(tied))
        least = min(_of_group(context, stage, _gap)(module, width) for stage, module, width in sizes)
        # Down at first, too; then up alone, as a width that loses a millimetre may lose what is asked.
        factor = 1.0 / math.cbrt(least) if number < CORRECTIONS else max(1.0, math.sqrt(1.0 / least))
        for stage in tied:
            needed[stage] = needed[stage] * factor


def _widest(context: Context, stage: str, module: float) -> float:
    """Return the face width of a stage at its most [m]."""
    return context.given.get(f"{stage}.face_width", _most(context, stage, module))


def _most(context: Context, stage: str, module: float) -> float:
    """Return the greatest face width of a stage of cylindrical gears, in whole millimetres where it is open [m]."""
    widest = context.width_ratios[stage] * module
    return whole(widest) if context.ratings[stage].width_is_open else widest


def _span(context: Context, stage: str) -> float:
    """Return a pair's working centre distance over its normal module, (z_1 ± z_2) / (2 cos β) without shift [-]."""
    if (centre := context.ratings[stage].shifts.centre) is not None:
        return centre
    pinion, wheel = _teeth(context, stage)
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
    return abs(pinion - mesh.sign * wheel) / (2.0 * math.cos(context.ratings[stage].helix_angle))


def _teeth(context: Context, stage: str) -> tuple[int, int]:
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
    return context.teeth[mesh.gears[0]], context.teeth[mesh.gears[1]]


def _size(context: Context, stage: str, needed: float, demands: Mapping[str, Demand]) -> StageSize:
    rating, given, ratio = context.ratings[stage], context.given, context.width_ratios[stage]
    if rating.proportions is None:
        module = given.get(f"{stage}.module", needed)
        width = given.get(f"{stage}.face_width", ratio * module)
        return StageSize(module, width, width)
    if rating.kind != "bevel" and {f"{stage}.module", f"{stage}.face_width"} <= given.keys():
        width = given[f"{stage}.face_width"]
        return StageSize(given[f"{stage}.module"], width, width)
    bevel, gap = rating.kind == "bevel", _of_group(context, stage, _gap)
    made = partial(_outer_module if bevel else _made_module, context, stage)
    on_axes = any(stage in tied for tied in _tied(context, module_owners(context.design)))
    module = made(needed if on_axes else under_spectrum(needed, ratio, gap, made))
    if bevel:
        return _bevel_size(context, stage, module, ratio)
    size = _cylinder(context, stage, _strong(context, stage, module, gap), ratio)
    return _against_scuffing(context, stage, size, demands) if rating.width_is_open else size


def _strong(context: Context, stage: str, module: float, gap: Gap) -> float:
    """Return a module of a stage, or a larger one that meets what is asked; one that is given or tied stays [m]."""
    rules, tied = context.ratings[stage].proportions, any(stage in links for links in _links(context))
    if rules is None or tied or f"{stage}.module" in context.given:
        return module
    return strong_enough(
        module, lambda tried: gap(tried, _most(context, stage, tried)), standard=rules.standard_modules
    )


def _gap(context: Context, stage: str, module: float, width: float) -> float:
    """Return by what factor the loads of a stage could grow [-]; 1 where nothing loads it."""
    rows = [mesh for mesh in context.train.meshes if mesh.stage == stage]
    reserves = [row_reserve(context, mesh, module, width) for mesh in rows]
    return min((reserve for reserve in reserves if reserve is not None), default=1.0)


def _of_group(context: Context, stage: str, alone: Callable[[Context, str, float, float], float]) -> Gap:
    """Return the gap of a stage and of those that have its module, whose gears mesh with its own."""
    others = [name for name, owner in module_owners(context.design).items() if owner == stage != name]

    def gap(module: float, width: float) -> float:
        size = StageSize(module, width, width)
        rest = (alone(context, name, module, _like(context, name, stage, size).face_width) for name in others)
        return min(alone(context, stage, module, width), *rest)

    return gap if others else partial(alone, context, stage)


def _room(context: Context, stage: str, module: float, width: float) -> float:
    """Return the same as far as it tells whether a stage bears its loads: the first row that does not is enough [-]."""
    least = math.inf
    for mesh in context.train.meshes:
        if mesh.stage == stage and (reserve := row_reserve(context, mesh, module, width)) is not None:
            least = min(least, reserve)
            if least < 1.0:
                break
    return least


def _against_scuffing(context: Context, stage: str, size: StageSize, demands: Mapping[str, Demand]) -> StageSize:
    """Return a size that neither scuffs nor is too weak: wider, or of a larger module; as it is where none is near."""

    def alone(_: Context, name: str, module: float, width: float) -> float:
        rows = (mesh for mesh in context.train.meshes if mesh.stage == name)
        return min(scuffing_ratio(context, mesh, module, width, demands[mesh.name][2:]) for mesh in rows)

    if f"{stage}.face_width" in context.given or (cool := _of_group(context, stage, alone))(*size[:2]) >= 1.0:
        return size
    bears = _of_group(context, stage, _gap)
    module = _strong(context, stage, size.module, lambda *tried: min(bears(*tried), cool(*tried)))
    widest = _most(context, stage, module)
    if min(bears(module, widest), cool(module, widest)) < 1.0 - JUST:
        return size
    own = _cylinder(context, stage, module, context.width_ratios[stage])
    width = narrowest(own.face_width, widest, partial(cool, module))
    return StageSize(module, width, width)


def _made_module(context: Context, stage: str, needed: float) -> float:
    """Return the module of a stage of cylindrical gears: given, or the standard one that is needed [m]."""
    return context.given.get(f"{stage}.module", rounded(context, stage, needed))


def _cylinder(context: Context, stage: str, module: float, ratio: float) -> StageSize:
    """Return a module and the whole millimetres of face width that meet the safeties with it."""
    rating, width = context.ratings[stage], ratio * module
    if rating.width_is_open:
        width = narrowest(overlap_width(rating, module), width, partial(_of_group(context, stage, _room), module))
    width = context.given.get(f"{stage}.face_width", width)
    return StageSize(module, width, width)


def rounded(context: Context, stage: str, needed: float) -> float:
    """Return the next standard module where the rules ask for one; pairs on common axes keep theirs [m].

    Args:
        context: What gear sizing reads.
        stage: Whose rules they are.
        needed: Module that its meshes ask for [m].
    """
    rules = context.ratings[stage].proportions
    if any(stage in links for links in _links(context)) or rules is None or not rules.standard_modules:
        return needed
    return next_standard(needed)


def _outer_module(context: Context, stage: str, needed: float) -> float:
    """Return the outer module of a bevel stage: given, or the standard one that is needed [m]."""
    outer = context.given.get(f"{stage}.outer_module")
    if outer is not None:
        return outer
    rating, wide = context.ratings[stage], context.width_ratios[stage] * needed
    return rounded(context, stage, bevel_pair(_teeth(context, stage), needed, wide, rating).outer_module)


def _bevel_size(context: Context, stage: str, outer: float, ratio: float) -> StageSize:
    """Return mean normal module and face width of a bevel stage of an outer module."""
    rating, given, teeth = context.ratings[stage], context.given, _teeth(context, stage)
    gap = partial(_gap, context, stage)
    if f"{stage}.outer_module" not in given:
        outer = bevel_module(teeth, outer, ratio, rating, gap)
    width = bevel_width(teeth, outer, ratio, rating, gap)
    asked = given.get(f"{stage}.face_width", width)
    width = min(asked, min(WIDEST * float(cone_ratio(*teeth)), WIDEST_MODULES) * outer)
    return StageSize(mean_module(teeth, outer, width, rating), width, asked)


# ----------------------------------------------------------------------------------------------------------------------
# Modules and face widths of compound sets: one module for gears that mesh, related to the others by common pins.
# ----------------------------------------------------------------------------------------------------------------------


def compound_sizes(context: Context, demands: Mapping[str, Demand]) -> dict[str, StageSize]:
    """Return module and face width of every group of gears of every compound set, by the label of the group.

    Args:
        context: What gear sizing reads.
        demands: Mesh row -> what it asks for.

    Raises:
        DesignError: If nothing loads a set whose modules are not given.
    """
    return {key: size for name in context.design.epicyclics for key, size in _set(context, name, demands).items()}


def _set(context: Context, name: str, demands: Mapping[str, Demand]) -> dict[str, StageSize]:
    epicyclic = context.design.epicyclics[name]
    ratios = relative_modules(epicyclic)
    rows: dict[str, list[Mesh]] = {}
    for mesh in context.train.meshes:
        if mesh.stage == name:
            rows.setdefault(mesh.group, []).append(mesh)
    given = {
        epicyclic.group(gear): context.given[f"{name}.{gear}.module"]
        for gear in epicyclic.toothed
        if f"{name}.{gear}.module" in context.given
    }
    unit = next((module / ratios[group] for group, module in given.items()), None)
    if unit is None:
        unit = _unit(context, name, rows, ratios, demands)
    modules = {group: given.get(group, unit * ratio) for group, ratio in ratios.items()}
    return {meshes[0].sized: _compound_size(context, meshes, modules[group]) for group, meshes in rows.items()}


def _unit(
    context: Context, name: str, rows: Mapping[str, list[Mesh]], ratios: Mapping[str, float],
    demands: Mapping[str, Demand],
) -> float:  # fmt: skip
    """Return the module of the first group with which every mesh of the set is strong enough [m]."""
    needed = max(max(demands[mesh.name][2:]) / ratios[group] for group, meshes in rows.items() for mesh in meshes)
    if needed <= 0.0:
        path = next(iter(context.design.epicyclics[name].planets))
        message = "no load case sends power through this set, so that strength asks for no module; write module_mm = 2"
        raise DesignError([Problem(f"{context.design.table(name)}.planets.{path}", message)])
    rating, width_ratio = context.ratings[name], context.width_ratios[name]
    if rating.proportions is None:
        return needed

    def gap(unit: float, width_of: Callable[[float], float] = lambda width: width) -> float:
        modules = ((meshes, unit * ratios[group]) for group, meshes in rows.items())
        return min(_compound_gap(context, meshes, module, width_of(width_ratio * module)) for meshes, module in modules)

    for _ in range(CORRECTIONS):
        needed /= math.cbrt(gap(needed))
    bears = partial(gap, width_of=whole) if rating.width_is_open else gap
    return strong_enough(rounded(context, name, needed), bears, standard=rating.proportions.standard_modules)


def _compound_size(context: Context, meshes: list[Mesh], module: float) -> StageSize:
    """Return a group's size: its module, and the width that is given, or the least that serves."""
    stage = meshes[0].stage
    rating, width = context.ratings[stage], context.width_ratios[stage] * module
    if rating.width_is_open:
        width = narrowest(module, width, partial(_compound_gap, context, meshes, module))
    names = {gear for mesh in meshes for gear in mesh.gears}
    given = [context.given[f"{gear}.face_width"] for gear in names if f"{gear}.face_width" in context.given]
    width = min(given, default=width)
    return StageSize(module, width, width)


def _compound_gap(context: Context, meshes: list[Mesh], module: float, width: float) -> float:
    """Return by what factor the loads of some meshes could grow [-]; 1 where nothing loads them."""
    reserves = [row_reserve(context, mesh, module, width) for mesh in meshes]
    return min((reserve for reserve in reserves if reserve is not None), default=1.0)


# ----------------------------------------------------------------------------------------------------------------------
# K_γ that follows from the sizes of gears and their loads: by tolerances of pins, by the clocking of two paths.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 8
"""Times that gears are sized anew with the K_γ of their sizes, at most [-]."""
STILL = 1e-3
"""Change of K_γ that counts as none [-]."""
BEARING = 1e9
"""Radial stiffness of a planet's bearing on its pin where none is given [N/m], an estimate."""
LARGEST = 3.0
"""K_γ at most, as where it is given [-]: beyond, planets do not all carry."""


def sharing_of_sizes(
    context: Context, gears: Sequence[GearSizing], meshes: Sequence[MeshSizing]
) -> Mapping[str, float]:
    """Return stage -> K_γ by the sizes of its gears, where the design asks for that [-].

    Args:
        context: What gear sizing reads.
        gears: As sized.
        meshes: As sized.
    """
    found = dict[str, float]()
    for name, stage in context.design.stages.items():
        if load_sharing(context.design, name).by_size:
            own = [mesh for mesh in meshes if mesh.stage == name]
            if isinstance(stage, Pair):
                factor = _by_clocking(context, name, stage, own)
            else:
                factor = max(_by_tolerances(context, stage, gears, mesh) for mesh in own)
            found[name] = min(max(factor, 1.0), LARGEST)
    return found


def _by_clocking(context: Context, name: str, pair: Pair, meshes: Sequence[MeshSizing]) -> float:
    """Return K_γ of clocked paths by the torque that comes in where they part, in the case that loads them most."""
    case = meshes[0].case
    rows = [row for row in context.train.meshes if row.stage == name]
    multiplier = sum(abs(context.flows[case].meshes[row.name].multiplier) for row in rows)
    split = 0 if len(pair.named(Role.WHEEL)) >= len(pair.named(Role.PINION)) else 1
    torque = multiplier * context.teeth[rows[0].gears[split]]
    assert pair.clocking is not None
    return float(clocking_load_factor(pair.clocking, torque) ** split_levels(context.design)[name])


def _by_tolerances(
    context: Context, stage: Planetary | Epicyclic, gears: Sequence[GearSizing], mesh: MeshSizing
) -> float:
    """Return K_γ of a set by the places of its pins, in the case that loads a mesh most."""
    rating = context.ratings[mesh.stage]
    first, second = (next(gear for gear in gears if gear.name == name) for name in mesh.gears)
    row = next(row for row in context.train.meshes if row.name == mesh.name)
    width = min(first.face_width, second.face_width)
    pair = cylindrical_mesh(
        (first.teeth, second.teeth), first.module, width, context.rating(row), internal=row.sign == INTERNAL
    )
    springs = mesh_springs(pair, steels=steels_of(rating, (first.role, second.role)))
    pin = stage.bearings.pin if isinstance(stage, Planetary) else None
    stiffness = path_stiffness(
        float(springs.mesh), width, bearing=pin or BEARING, pressure_angle=mesh.working_pressure_angle
    )
    planets = stage.planets if isinstance(stage, Planetary) else stage.sets
    assert stage.pin_position is not None
    force = mesh.tangential_force / mesh.load_factor
    factor = tolerance_load_factor(planets, stage.pin_position, force, stiffness=stiffness, floating=True)
    return max(factor, LEAST_SHARING)
