"""Module and face width of stages, including compound stages, unloaded gears and load sharing by size."""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from gearwright.base import DesignError, Problem, Role, refuse
from gearwright.catalogue import LEAST_SHARING
from gearwright.parts.iso6336 import mesh_springs
from gearwright.parts.planetary import clocking_load_factor, path_stiffness, tolerance_load_factor
from gearwright.sizing.rating import Context, Demand, bevel_pair, cylindrical_mesh, load_sharing
from gearwright.sizing.rating.iso6336_inputs import steels_of
from gearwright.sizing.result import GearSizing, MeshSizing
from gearwright.sizing.size_grids import Option, Part, StageSize, options
from gearwright.spec import Epicyclic, Pair, Planetary, case_named, levels_of, shares_of
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
# Module and face width of every stage: the lightest that pass, or as the user gives them.
# ----------------------------------------------------------------------------------------------------------------------


class _Open(NamedTuple):
    """Parts that are sized together by a standard."""

    parts: tuple[Part, ...]
    unit: float
    """Given, or what the heaviest case asks for at the widest face [m]."""
    is_open: bool

    def kind(self, context: Context, demands: Mapping[str, Demand]) -> object:
        """Return what is the same of parts that do the same, such as the stages of equal engines, each in its case."""
        rules = [(context.ratings[part.stage], part.width) for part in self.parts]
        numbers = [
            (
                part.ratio,
                [(context.asks[mesh.name], demands[mesh.name][1:], _loads(context, mesh)) for mesh in part.meshes],
            )
            for part in self.parts
        ]
        return repr((rules, self.is_open, _but_for_rounding((self.unit, numbers))))


def _but_for_rounding(value: object) -> object:
    """Return rows of numbers without the digits by which those of parts that do the same may differ."""
    if isinstance(value, float):
        return float(f"{value:.9g}")
    return [_but_for_rounding(one) for one in value] if isinstance(value, (tuple, list)) else value


def _loads(context: Context, mesh: Mesh) -> list[tuple[float, float, float, bool, tuple[tuple[float, float], ...]]]:
    """Return the loads of a row in order, without names of cases; of limit loads those that exceed the others."""
    design, shares = context.design, shares_of(context.design)
    torques = {case: abs(flow.meshes[mesh.name].multiplier) for case, flow in context.flows.items()}
    limits = {case: case_named(design, case).static for case in torques}
    most = max((torque for case, torque in torques.items() if not limits[case]), default=0.0)
    return sorted(
        (float(f"{torque:.9g}"), float(f"{abs(context.rolling(mesh, case)):.9g}"), shares.get(case, 0.0), limits[case],
         tuple(levels_of(design, case)))
        for case, torque in torques.items() if torque > (most if limits[case] else 0.0)
    )  # fmt: skip


def all_sizes(context: Context, demands: Mapping[str, Demand]) -> dict[str, StageSize]:
    """Return module and face width of every stage and group of a compound set: the lightest that pass.

    Args:
        context: What gear sizing reads.
        demands: Mesh row -> what it asks for.

    Raises:
        DesignError: If nothing loads a stage, or its standard does not cover it.
    """
    closed, open_ = _divided(context, demands)
    found = _lightest(context, tuple(open_), demands) if open_ else ()
    for one, sizes in zip(open_, found, strict=True):
        closed |= {part.name: size for part, size in zip(one.parts, sizes, strict=True)}
    return closed


def combinations(context: Context, demands: Mapping[str, Demand]) -> Iterator[tuple[dict[str, StageSize], float]]:
    """Yield the same in combinations of sizes that pass, the lightest first, and what they weigh by an estimate [kg].

    What follows in closed form is not in the estimate.

    Args:
        context: What gear sizing reads.
        demands: Mesh row -> what it asks for.
    """
    closed, open_ = _divided(context, demands)
    alike = dict[object, list[_Open]]()
    for one in open_:
        alike.setdefault(one.kind(context, demands), []).append(one)
    courses = [_Course(options(context, *ones[0][:2], demands, is_open=ones[0].is_open), []) for ones in alike.values()]
    start = (0,) * len(courses)
    heap, seen = [(0.0, start)], {start}
    while heap:
        _, places = heapq.heappop(heap)
        taken = [course.at(place) for course, place in zip(courses, places, strict=True)]
        sizes, mass = dict(closed), 0.0
        for ones, option in zip(alike.values(), taken, strict=True):
            assert option is not None
            mass += len(ones) * option.mass
            for one in ones:
                sizes |= {part.name: size for part, size in zip(one.parts, option.sizes, strict=True)}
        yield sizes, mass
        for k, course in enumerate(courses):
            after = (*places[:k], places[k] + 1, *places[k + 1 :])
            if after not in seen and course.at(after[k]) is not None:
                seen.add(after)
                found = zip(alike.values(), courses, after, strict=True)
                heavier = sum(len(ones) * own.mass_at(place) for ones, own, place in found)
                heapq.heappush(heap, (heavier, after))


class _Course(NamedTuple):
    """Options as far as they are looked at."""

    left: Iterator[Option]
    found: list[Option]

    def at(self, place: int) -> Option | None:
        """Return an option; None where there are not so many."""
        while len(self.found) <= place:
            if (option := next(self.left, None)) is None:
                return None
            self.found.append(option)
        return self.found[place]

    def mass_at(self, place: int) -> float:
        """Return what an option weighs that there is [kg]."""
        return self.found[place].mass


def _lightest(
    context: Context, open_: tuple[_Open, ...], demands: Mapping[str, Demand]
) -> tuple[tuple[StageSize, ...], ...]:
    """Return the lightest size of all that is open."""
    return tuple(next(options(context, *one[:2], demands, is_open=one.is_open)).sizes for one in open_)


def _divided(context: Context, demands: Mapping[str, Demand]) -> tuple[dict[str, StageSize], list[_Open]]:
    """Return the sizes that follow in closed form, and what a standard sizes, with all that is tied to it."""
    group = module_owners(context.design)
    needed: dict[str, float] = {}
    for mesh in context.train.meshes:
        if mesh.stage not in group:
            continue
        owner = group[mesh.stage]
        needed[owner] = max(needed.get(owner, 0.0), *demands[mesh.name][2:])
    _align(context, needed, group)
    refuse_idle_stages(context, needed)
    tied = _tied(context, group)
    closed, open_ = dict[str, StageSize](), list[_Open]()
    for owners in (*({owner} for owner in needed if not any(owner in owners for owners in tied)), *tied):
        modules = {owner: _module_given(context, owner) for owner in owners}
        plain = [owner for owner in owners if context.ratings[owner].proportions is None]
        apart = len(owners) > 1 and (plain or any(module is not None for module in modules.values()))
        for some in [{owner} for owner in sorted(owners)] if apart else [owners]:
            first = min(some)
            given = needed[first] if apart and modules[first] is None else modules[first]
            if first in plain:
                closed |= _closed_form(context, first, needed[first] if given is None else given)
                continue
            ratios = {owner: 1.0 if owner == first else needed[owner] / needed[first] for owner in sorted(some)}
            parts = [part for owner, ratio in ratios.items() for part in _parts(context, owner, ratio)]
            unit = _unit(context, first, needed[first]) if given is None else given
            open_.append(_Open(tuple(parts), unit, given is None))
    for name in context.design.epicyclics:
        own = _set(context, name, demands)
        if isinstance(own, _Open):
            open_.append(own)
        else:
            closed |= own
    return closed, open_


def _unit(context: Context, owner: str, needed: float) -> float:
    """Return the module that a stage asks for, of bevel gears the outer one [m]."""
    rating = context.ratings[owner]
    if rating.kind != "bevel":
        return needed
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == owner)
    teeth = context.teeth[mesh.gears[0]], context.teeth[mesh.gears[1]]
    return float(bevel_pair(teeth, needed, context.width_ratios[owner] * needed, rating).outer_module)


def _module_given(context: Context, owner: str) -> float | None:
    """Return the module that a stage is given, of bevel gears the outer one [m]; None where it is open."""
    return context.given.get(f"{owner}.module", context.given.get(f"{owner}.outer_module"))


def _closed_form(context: Context, owner: str, module: float) -> dict[str, StageSize]:
    """Return the sizes of stages of one module whose method has a closed form: faces of λ modules."""
    sizes = dict[str, StageSize]()
    for stage, own in module_owners(context.design).items():
        if own == owner:
            width = context.given.get(f"{stage}.face_width", context.width_ratios[stage] * module)
            sizes[stage] = StageSize(module, width, width)
    return sizes


def _parts(context: Context, owner: str, ratio: float) -> list[Part]:
    """Return a stage and those that have its module, whose gears mesh with its own and are no wider."""
    stages = [stage for stage, own in module_owners(context.design).items() if own == owner != stage]
    rows = {stage: tuple(mesh for mesh in context.train.meshes if mesh.stage == stage) for stage in (*stages, owner)}
    return [
        Part(stage, stage, meshes, ratio, context.given.get(f"{stage}.face_width"), "" if stage == owner else owner)
        for stage, meshes in rows.items()
    ]


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


def _span(context: Context, stage: str) -> float:
    """Return a pair's working centre distance over its normal module, (z_1 ± z_2) / (2 cos β) without shift [-]."""
    if (centre := context.ratings[stage].shifts.centre) is not None:
        return centre
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
    pinion, wheel = (context.teeth[gear] for gear in mesh.gears)
    return abs(pinion - mesh.sign * wheel) / (2.0 * math.cos(context.ratings[stage].helix_angle))


# ----------------------------------------------------------------------------------------------------------------------
# Modules and face widths of compound sets: one module for gears that mesh, related to the others by common pins.
# ----------------------------------------------------------------------------------------------------------------------


def _set(context: Context, name: str, demands: Mapping[str, Demand]) -> dict[str, StageSize] | _Open:
    """Return the sizes of the groups of a compound set, or what of them is open."""
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
    needed = max(max(demands[mesh.name][2:]) / ratios[group] for group, meshes in rows.items() for mesh in meshes)
    if unit is None and needed <= 0.0:
        path = next(iter(epicyclic.planets))
        message = "no load case sends power through this set, so that strength asks for no module; write module_mm = 2"
        raise DesignError([Problem(f"{context.design.table(name)}.planets.{path}", message)])
    if context.ratings[name].proportions is None:
        unit, ratio = needed if unit is None else unit, context.width_ratios[name]
        modules = {group: given.get(group, unit * own) for group, own in ratios.items()}
        widths = {group: _width_given(context, meshes) or ratio * modules[group] for group, meshes in rows.items()}
        return {
            meshes[0].sized: StageSize(modules[group], widths[group], widths[group]) for group, meshes in rows.items()
        }
    parts = [
        Part(meshes[0].sized, name, tuple(meshes), given[group] / unit if unit and group in given else ratios[group],
             _width_given(context, meshes))
        for group, meshes in rows.items()
    ]  # fmt: skip
    return _Open(tuple(parts), needed if unit is None else unit, unit is None)


def _width_given(context: Context, meshes: Sequence[Mesh]) -> float | None:
    """Return the least face width that gears of some meshes are given [m]."""
    names = {gear for mesh in meshes for gear in mesh.gears}
    given = [context.given[f"{gear}.face_width"] for gear in names if f"{gear}.face_width" in context.given]
    return min(given, default=None)


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
