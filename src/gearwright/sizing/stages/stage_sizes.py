"""Module and face width of every stage: what its meshes ask, rounded as its rules say, or as the user gives them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import NamedTuple

from gearwright.parts.bevel import WIDEST, WIDEST_MODULES
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
from gearwright.sizing.stages.idle import refuse_idle_stages
from gearwright.spec.design import module_owners


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
