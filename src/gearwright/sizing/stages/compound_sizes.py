"""Modules and face widths of compound sets: one module for gears that mesh, related to the others by common pins."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial

from gearwright.errors import DesignError, Problem
from gearwright.sizing.rating import CORRECTIONS, Context, Demand, narrowest, row_reserve, strong_enough, whole
from gearwright.sizing.stages.stage_sizes import StageSize, rounded
from gearwright.spec.design import relative_modules
from gearwright.train import Mesh


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
    return {meshes[0].sized: _size(context, meshes, modules[group]) for group, meshes in rows.items()}


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
        return min(_gap(context, meshes, module, width_of(width_ratio * module)) for meshes, module in modules)

    for _ in range(CORRECTIONS):
        needed /= math.cbrt(gap(needed))
    bears = partial(gap, width_of=whole) if rating.width_is_open else gap
    return strong_enough(rounded(context, name, needed), bears, standard=rating.proportions.standard_modules)


def _size(context: Context, meshes: list[Mesh], module: float) -> StageSize:
    """Return a group's size: its module, and the width that is given, or the least that serves."""
    stage = meshes[0].stage
    rating, width = context.ratings[stage], context.width_ratios[stage] * module
    if rating.width_is_open:
        width = narrowest(module, width, partial(_gap, context, meshes, module))
    names = {gear for mesh in meshes for gear in mesh.gears}
    given = [context.given[f"{gear}.face_width"] for gear in names if f"{gear}.face_width" in context.given]
    width = min(given, default=width)
    return StageSize(module, width, width)


def _gap(context: Context, meshes: list[Mesh], module: float, width: float) -> float:
    """Return by what factor the loads of some meshes could grow [-]; 1 where nothing loads them."""
    reserves = [row_reserve(context, mesh, module, width) for mesh in meshes]
    return min((reserve for reserve in reserves if reserve is not None), default=1.0)
