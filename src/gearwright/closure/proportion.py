"""Proportion: every stage as light as its strengths allow, and everything that was chosen written into the design."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from gearwright.closure.requirements import without
from gearwright.closure.stage_search import ROUNDING, StageSize, StageTask, lightest, sized_at
from gearwright.closure.wishes import Wishes
from gearwright.identity import Role
from gearwright.sizing import Sizing, size
from gearwright.sizing.insight import Trial, trial_of
from gearwright.spec import Design, edited
from gearwright.spec.design import Pair, Planetary, module_owners
from gearwright.spec.edit import Value

_MM = 1e-3
MOST_SCALINGS = 12
"""Times that modules of stages on common axes are made larger together [-]."""
SLIGHTLY = 1.001
"""The least factor by which they are [-]."""
_TEETH = {
    Role.PINION: "pinion_teeth", Role.WHEEL: "wheel_teeth",
    Role.SUN: "sun_teeth", Role.PLANET: "planet_teeth", Role.RING: "ring_teeth",
}  # fmt: skip


class Proportioned(NamedTuple):
    """A design of which everything is written, and its sizing."""

    design: Design
    sizing: Sizing
    sizes: Mapping[str, StageSize]
    """Stage -> what the search found, of those that were searched."""


def proportioned(
    design: Design, wishes: Wishes, *, before: Sizing | None = None, targets: Mapping[str, float] | None = None
) -> Proportioned:
    """Return a design with the least module and width of every stage, written with teeth, planets and diameters.

    Args:
        design: With the freedoms that are left.
        wishes: What is asked.
        before: Sizing of a round before: its teeth stay, and its modules are where the search begins.
        targets: Stage -> margin that is asked of its strengths, where it is more than 1 [-].

    Raises:
        DesignError: If the design cannot be sized.
    """
    first = size(design) if before is None else before
    own = edited(design, dict(teeth_of(design, first)))
    sizes = dict(_sizes(trial_of(without(own, wishes.left_out), first), first, wishes, targets or {}))
    written = edited(own, dict(sizes_of(own, sizes)))
    return Proportioned(written, size(written), sizes)


def written_out(found: Proportioned, left_out: frozenset[str] = frozenset()) -> Proportioned:
    """Return a design with the diameters of its plain shafts and pins written as sized, too.

    Args:
        found: With modules and widths.
        left_out: Requirements that do not count.
    """
    free = without(found.design, left_out)
    whole = edited(found.design, dict(_diameters(found.sizing if free is found.design else size(free))))
    return Proportioned(whole, size(whole), found.sizes)


def searched(design: Design) -> list[str]:
    """Return the stages whose module or width the search chooses: cylindrical ones that a standard rates.

    Args:
        design: With its rules.
    """
    return [name for name, stage in design.simple_stages.items() if _cylindrical(stage) and _is_open(stage)]


def _cylindrical(stage: Pair | Planetary) -> bool:
    return isinstance(stage, Planetary) or stage.kind == "cylindrical"


def _is_open(stage: Pair | Planetary) -> bool:
    return stage.face_width is None


def _sizes(
    trial: Trial, first: Sizing, wishes: Wishes, targets: Mapping[str, float]
) -> Iterator[tuple[str, StageSize]]:
    """Yield the size of every stage that is searched; one that nothing does has its widest face."""
    owners, tied = module_owners(trial.design), list[StageTask]()
    modules = _on_axes(trial, first)
    for name in searched(trial.design):
        rating = trial.rating(name)
        if rating.proportions is None or f"{name}.face_width" in trial.given:
            continue
        task = StageTask(trial, name, wishes.left_out, wishes.rounded, targets.get(name, 1.0))
        if is_tied(trial.design, name, owners):
            tied.append(task)
            continue
        standard = wishes.rounded and rating.proportions.standard_modules
        given = f"{name}.module" in trial.given
        module = modules[name]
        found = sized_at(task, module) if given else lightest(task, module, standard=standard)
        yield name, found or _widest(task, module)
    yield from _together(tied, modules)


def _on_axes(trial: Trial, first: Sizing) -> dict[str, float]:
    """Return stage -> module to begin at [m]: as sized or given, so that pairs on common axes have one distance."""
    given, of_gears = _given(trial), {gear.name: gear.module for gear in first.gears}
    sized = {mesh.stage: of_gears[mesh.gears[0]] for mesh in first.meshes}
    spans = {mesh.stage: mesh.centre_distance / sized[mesh.stage] for mesh in first.meshes}
    modules = sized | given
    for name, pair in trial.design.pairs.items():
        if pair.coaxial_with is not None:
            tied = (name, pair.coaxial_with)
            distance = max(modules[one] * spans[one] for one in tied if one in given or not given.keys() & set(tied))
            modules |= {one: distance / spans[one] for one in tied if one not in given}
    return modules


def _given(trial: Trial) -> dict[str, float]:
    """Return stage -> module that the design gives [m]."""
    names = trial.design.simple_stages
    return {name: trial.given[f"{name}.module"] for name in names if f"{name}.module" in trial.given}


def _together(tasks: list[StageTask], modules: Mapping[str, float]) -> Iterator[tuple[str, StageSize]]:
    """Yield the sizes of stages that share a module or their axes: their modules grow together until all do."""
    scale, sizes = 1.0, dict[str, StageSize]()
    free = all(f"{task.name}.module" not in task.trial.given for task in tasks)
    for _ in range(MOST_SCALINGS):
        scaled = {task.name: scale * modules[task.name] for task in tasks}
        sizes = {task.name: sized_at(task, scaled[task.name]) or _widest(task, scaled[task.name]) for task in tasks}
        least = min((size.margin for size in sizes.values()), default=1.0)
        if least >= 1.0 - ROUNDING or not free:
            break
        scale *= max(least**-0.5, SLIGHTLY)
    yield from _as_wide(tasks, sizes)


def _as_wide(tasks: list[StageTask], sizes: Mapping[str, StageSize]) -> Iterator[tuple[str, StageSize]]:
    """Yield sizes with the widest face of all stages that share gears: teeth mesh over the narrower of two faces."""
    for task in tasks:
        owners, own = module_owners(task.trial.design), sizes[task.name]
        width = max(size.face_width for name, size in sizes.items() if owners[name] == owners[task.name])
        margin, governs = task.governing(own.module, width)
        yield task.name, StageSize(own.module, width, margin, governs, task.volume(own.module, width))


def is_tied(design: Design, stage: str, owners: Mapping[str, str]) -> bool:
    """Tell whether other stages have the same module or the same axes.

    Args:
        design: With its stages.
        stage: One of them.
        owners: Stage -> the stage whose module it has.
    """
    axes = {pair.coaxial_with for pair in design.pairs.values()}
    own = design.pairs.get(stage)
    shared = list(owners.values()).count(owners[stage]) > 1
    return shared or stage in axes or (own is not None and own.coaxial_with is not None)


def _widest(task: StageTask, module: float) -> StageSize:
    """Return the widest face of a module that does not do."""
    width = task.widest(module)
    return StageSize(module, width, *task.governing(module, width), task.volume(module, width))


def teeth_of(design: Design, sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield teeth and planets as they were chosen, where a design leaves them open, without what only asked for them.

    Args:
        design: That leaves some open.
        sizing: With the choice.
    """
    for name, stage in design.simple_stages.items():
        table = design.table(name)
        gears = [gear for gear in sizing.gears if gear.stage == name]
        if all(getattr(stage, _TEETH[gear.role]) == gear.teeth for gear in gears):
            continue
        yield from ((f"{table}.{_TEETH[gear.role]}", gear.teeth) for gear in gears)
        if stage.ratio is not None:
            yield f"{table}.ratio", None
        if "ratio_split" in stage.model_fields_set:
            yield f"{table}.ratio_split", None
        if isinstance(stage, Planetary):
            yield f"{table}.planets", sizing.design.planetaries[name].planets


def sizes_of(design: Design, sizes: Mapping[str, StageSize]) -> Iterator[tuple[str, Value]]:
    """Yield modules and widths of the stages that were searched, where a design leaves them open.

    Args:
        design: With its freedoms.
        sizes: Stage -> what was found.
    """
    owners = module_owners(design)
    for name, found in sizes.items():
        if design.simple_stages[name].module is None and owners[name] == name:
            yield f"{design.table(name)}.module_mm", found.module / _MM
        yield f"{design.table(name)}.face_width_mm", found.face_width / _MM


def _diameters(sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield diameters of plain shafts and pins and thicknesses of plates, where the design leaves them open."""
    design = sizing.design
    built = {shaft.name for shaft in sizing.built_shafts}
    for shaft in sizing.shafts:
        if shaft.name not in built and f"{shaft.name}.diameter" not in sizing.given:
            yield f"layout.{shaft.name}.diameter_mm", shaft.diameter / _MM
    for carrier in sizing.carriers:
        stands = design.planetaries.get(carrier.stage)
        if stands is not None and stands.planet_bearing is not None:
            continue  # pins and plates follow from what the planets turn on
        for key in ("pin_diameter", "plate_thickness", "eye_wall"):
            if f"{carrier.stage}.{key}" not in sizing.given:
                yield f"{design.table(carrier.stage)}.{key}_mm", getattr(carrier, key) / _MM
