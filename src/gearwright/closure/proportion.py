"""Least module and face width of each stage by its strengths, and their entry in the design."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Role, smallest
from gearwright.closure.requirements import STRENGTH, Wishes, requirement_of, sized, without
from gearwright.sizing import Sizing, Trial, trial_of
from gearwright.sizing.rating import STANDARD_MODULES
from gearwright.spec import Design, edited
from gearwright.spec.design import Pair, Planetary, module_owners
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# Module and face width of one stage: the lightest with which every strength of its teeth just does, both ways.
# ----------------------------------------------------------------------------------------------------------------------


_MM = 1e-3
CLOSE = 1e-5
"""Distance of the governing margin from 1 at which a continuous size counts as found [-]."""
NEAR = 5e-3
"""The same where whole millimetres are looked at afterwards [-]."""
ROUNDING = 1e-9
"""Of a margin, and of a width over another [-]."""
SPARE = 1.02
"""By how much more a size may bear than it did and still be kept [-]."""
SMALL = 50
"""Steps below which diameters are rounded to half a step: to 0.5 mm below 50 mm, to 1 mm above [-]."""
SURELY = 0.98
"""What flanks and roots bear by arrays over what they must bear, below which a module surely does not do [-]."""
MOST_STEPS = 40
"""Steps of the search for a width [-]."""
LARGER = 1
"""Modules above the least one that are looked at, as a narrower face may weigh less [-]."""


class StageSize(NamedTuple):
    """Size of a stage."""

    module: float
    """m_n [m]."""
    face_width: float
    """b [m]."""
    margin: float
    """Of the check that governs, as in `Check.reserve` [-]."""
    governs: str
    """Name of that check."""
    volume: float
    """Of its gears as cylinders [m³]."""


BY_ARRAYS = frozenset({"flank", "root"})
"""Requirements of which arrays of sizes tell."""


class StageTask(NamedTuple):
    """A stage that is proportioned."""

    trial: Trial
    name: str
    left_out: frozenset[str]
    rounded: bool
    """Whole millimetres."""
    target: float = 1.0
    """Margin that is asked of its strengths, above 1 where a flight asks for more than the design's own cases [-]."""

    def widest(self, module: float) -> float:
        """Return the widest face that its rules call usual [m].

        Args:
            module: m_n [m].
        """
        return self.trial.widest(self.name, module)

    def least(self, module: float) -> float:
        """Return the narrowest face that its rules allow [m].

        Args:
            module: m_n [m].
        """
        return self.trial.least(self.name, module)

    def volume(self, module: float, width: float) -> float:
        """Return what its gears fill as cylinders [m³].

        Args:
            module: m_n [m].
            width: b [m].
        """
        return self.trial.volume(self.name, module, width)

    def governing(self, module: float, width: float) -> tuple[float, str]:
        """Return the least margin of its strengths at a size over what is asked [-], and the name of that check.

        Args:
            module: m_n [m].
            width: b [m].
        """
        worst, name = math.inf, ""
        for check in self.trial.checks(self.name, module, width):
            requirement = requirement_of(check)
            counts = requirement in STRENGTH and requirement not in self.left_out
            if counts and check.reserve is not None and check.reserve < worst:
                worst, name = check.reserve, check.name
        return worst / self.target, name

    def near(self, modules: Sequence[float], widths: Sequence[float]) -> Floats | None:
        """Return about what `governing` finds of flanks and roots, of many sizes at once: to begin a search there [-].

        None where its method takes sizes one by one, and where one of the two does not count.

        Args:
            modules: m_n [m].
            widths: b, of as many sizes [m].
        """
        if not self.left_out.isdisjoint(BY_ARRAYS):
            return None
        found = self.trial.near(self.name, np.asarray(modules), np.asarray(widths))
        return None if found is None else np.where(found > 0.0, found, 0.0) / self.target


def sized_at(task: StageTask, module: float) -> StageSize | None:
    """Return the stage at a module with the least face width that does; None where none that is allowed does.

    Args:
        task: The stage.
        module: m_n [m].
    """
    widest = task.widest(module)
    least = min(task.least(module), widest)
    if task.rounded and (guess := _guessed(task, module, least, widest)) is not None:
        return _at(task, module, _whole(task, module, guess))
    if (above := task.governing(module, widest)[0]) < 1.0 - ROUNDING:
        return None
    width = _crossing(task, module, least, (widest, above))
    if task.rounded:
        width = _whole(task, module, width)
        width = widest if width > widest * (1.0 + ROUNDING) else width
    return _at(task, module, width)


def _at(task: StageTask, module: float, width: float) -> StageSize:
    """Return a size with what governs it."""
    margin, governs = task.governing(module, width)
    return StageSize(module, width, margin, governs, task.volume(module, width))


def _guessed(task: StageTask, module: float, least: float, widest: float) -> float | None:
    """Return the least whole millimetres at which flanks and roots do by arrays, if that does in full [m]."""
    first, last = math.ceil(least / _MM - ROUNDING), math.floor(widest / _MM + ROUNDING)
    widths = [count * _MM for count in range(first, last + 1)]
    near = task.near([module] * len(widths), widths) if widths else None
    if near is None or not (near >= 1.0).any():
        return None
    width = widths[int(np.argmax(near >= 1.0))]
    return width if task.governing(module, width)[0] >= 1.0 else None


def _crossing(task: StageTask, module: float, least: float, wide: tuple[float, float]) -> float:
    """Return the width at which the margin is 1, or the least one: by the secant, held in a bracket [m].

    Args:
        task: The stage.
        module: m_n [m].
        least: Width to look down to [m].
        wide: The widest one that does [m], and its margin [-].
    """
    (high, above), low, below, steep = wide, least, 0.0, 1.0
    close = NEAR if task.rounded else CLOSE
    for _ in range(MOST_STEPS):
        if above - 1.0 < close or high <= least:
            break
        width = high * (above / (1.0 + 0.3 * close)) ** (-1.0 / steep)
        if not low < width < high:
            width = math.sqrt(low * high) if below or width > low else low
        margin = task.governing(module, width)[0]
        known = (width, margin)
        if abs(math.log(high / width)) > ROUNDING and above != margin:
            steep = min(max(math.log(above / margin) / math.log(high / width), 0.2), 5.0)
        if margin >= 1.0:
            high, above = known
        else:
            low, below = known
            if high / low - 1.0 < ROUNDING:
                break
    return high


def _whole(task: StageTask, module: float, width: float) -> float:
    """Return the least whole millimetres near a width that do, with one less shown to fail [m]."""
    count, least = math.ceil(width / _MM - 1e-6), task.least(module)
    while task.governing(module, count * _MM)[0] < 1.0 and count * _MM < task.widest(module):
        count += 1
    while (count - 1) * _MM >= least and task.governing(module, (count - 1) * _MM)[0] >= 1.0:
        count -= 1
    return count * _MM


def lightest(task: StageTask, start: float, *, standard: bool) -> StageSize | None:
    """Return the lightest size of a stage among modules from the least that does, searched both ways from a start.

    Args:
        task: The stage.
        start: Module to begin at [m].
        standard: Modules of ISO 54 alone.
    """
    sizes = [size for module in _modules(task, start, standard=standard) if (size := sized_at(task, module))]
    return smallest(sizes, lambda size: size.volume) if sizes else None


def _modules(task: StageTask, start: float, *, standard: bool) -> Iterator[float]:
    """Yield the least module that does at its widest face, and the next larger ones [m]."""
    if not standard:
        yield _least_module(task, start)
        return
    series = [value * _MM for value in STANDARD_MODULES]
    place = _least_place(series, start, [task])
    yield from series[place : place + 1 + LARGER]


def _least_place(series: Sequence[float], start: float, tasks: Sequence[StageTask]) -> int:
    """Return the place of the least module of a series that does for some stages, looked for both ways from a start."""
    place = smallest(range(len(series)), lambda k: abs(math.log(series[k] / start)))
    near = [task.near(series, [task.widest(module) for module in series]) for task in tasks]
    able = np.all([np.ones(len(series), dtype=bool) if own is None else own >= SURELY for own in near], axis=0)

    def do(place: int) -> bool:
        return bool(able[place]) and all(_does(task, series[place]) for task in tasks)

    while place > 0 and do(place - 1):
        place -= 1
    while place < len(series) - 1 and not do(place):
        place += 1
    return place


def _does(task: StageTask, module: float) -> bool:
    return task.governing(module, task.widest(module))[0] >= 1.0


def _least_module(task: StageTask, start: float) -> float:
    """Return the module at which the widest face just does [m]; the load that teeth bear grows with its cube."""
    low = high = start
    while _does(task, low):
        high, low = low, low / 1.2
    while not _does(task, high) and high < 1.0:
        low, high = high, high * 1.2
    while high / low - 1.0 > CLOSE:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if _does(task, middle) else (middle, high)
    return high


# ----------------------------------------------------------------------------------------------------------------------
# Proportion: every stage as light as its strengths allow, and everything that was chosen written into the design.
# ----------------------------------------------------------------------------------------------------------------------


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
    design: Design, wishes: Wishes, *, before: Sizing | None = None, targets: Mapping[str, float] | None = None,
    kept: Mapping[str, StageSize] | None = None, still: bool = False, among: dict[str, Sizing] | None = None,
) -> Proportioned:  # fmt: skip
    """Return a design with the least module and width of every stage, written with teeth, planets and diameters.

    Args:
        design: With the freedoms that are left.
        wishes: What is asked.
        before: Sizing of a round before: its teeth stay, and its modules are where the search begins.
        targets: Stage -> margin that is asked of its strengths, where it is more than 1 [-].
        kept: Stage -> size that it keeps where that just does, so that only what a change moves is searched anew.
        still: Whether open axes stay where they stand first, room or not.
        among: Designs that were sized before, by what they state.

    Raises:
        DesignError: If the design cannot be sized.
    """
    first = sized(design) if before is None else before
    teeth = dict(teeth_of(design, first))
    own = edited(design, teeth) if teeth else design
    sizes = dict(_sizes(trial_of(without(own, wishes.left_out), first), first, wishes, targets or {}, kept or {}))
    written = edited(own, dict(sizes_of(own, sizes)))
    return Proportioned(written, sized(written, still=still, among=among), sizes)


def written_out(found: Proportioned, left_out: frozenset[str] = frozenset(), *, step: float = 0.0) -> Proportioned:
    """Return a design with the diameters of its plain shafts and pins written as sized, too.

    Args:
        found: With modules and widths.
        left_out: Requirements that do not count.
        step: To whose multiples diameters and thicknesses are made larger, small ones to a half of it [m]; 0: to none.
    """
    free = without(found.design, left_out)
    sizing = found.sizing if free is found.design else sized(free)
    changes = {path: _shop(value, step / _MM) for path, value in _diameters(sizing)}
    whole = edited(found.design, changes) if changes else found.design
    return Proportioned(whole, sized(whole) if changes else found.sizing, found.sizes)


def _shop(value: float, step: float) -> float:
    """Return a size as a shop makes it: the next multiple of a step, below fifty steps of a half of it [mm]."""
    if step <= 0.0:
        return value
    part = step if value >= SMALL * step else step / 2.0
    return round(math.ceil(value / part - ROUNDING) * part, 6)


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
    trial: Trial, first: Sizing, wishes: Wishes, targets: Mapping[str, float], kept: Mapping[str, StageSize]
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
        if name in kept and (still := _still_does(task, kept[name], trial.given)) is not None:
            yield name, still
            continue
        standard = wishes.rounded and rating.proportions.standard_modules
        given = f"{name}.module" in trial.given
        module = modules[name]
        found = sized_at(task, module) if given else lightest(task, module, standard=standard)
        yield name, found or _widest(task, module)
    for tasks in _of_one_module(tied, owners, wishes):
        yield from _at_standard(tasks, modules[tasks[0].name])
        tied = [task for task in tied if task not in tasks]
    yield from _together(tied, modules)


def _of_one_module(tied: list[StageTask], owners: Mapping[str, str], wishes: Wishes) -> Iterator[list[StageTask]]:
    """Yield the stages that share an open module, a standard one, and no axes with others."""
    for owner in dict.fromkeys(owners[task.name] for task in tied):
        tasks = [task for task in tied if owners[task.name] == owner]
        design, given = tasks[0].trial.design, tasks[0].trial.given
        proportions = [task.trial.rating(task.name).proportions for task in tasks]
        standard = wishes.rounded and all(one is not None and one.standard_modules for one in proportions)
        axes = {pair.coaxial_with for pair in design.pairs.values()}
        coaxial = any(
            task.name in axes or (task.name in design.pairs and design.pairs[task.name].coaxial_with is not None)
            for task in tasks
        )
        if standard and not coaxial and not any(f"{task.name}.module" in given for task in tasks):
            yield tasks


def _at_standard(tasks: list[StageTask], start: float) -> Iterator[tuple[str, StageSize]]:
    """Yield the sizes of stages at the standard module that fills least of those from the least that does for all."""
    series = [value * _MM for value in STANDARD_MODULES]
    place = _least_place(series, start, tasks)
    found = list[list[tuple[str, StageSize]]]()
    for module in series[place : place + 1 + LARGER]:
        sizes = {task.name: sized_at(task, module) or _widest(task, module) for task in tasks}
        found.append(list(_as_wide(tasks, sizes)))
    yield from smallest(found, lambda rows: sum(size.volume for _, size in rows))


def _still_does(task: StageTask, size: StageSize, given: Mapping[str, float]) -> StageSize | None:
    """Return a size that a stage has, rated anew; None where it does not do any more, or much less would."""
    if given.get(f"{task.name}.module", size.module) != size.module:
        return None
    margin, governs = task.governing(size.module, size.face_width)
    if not 1.0 - ROUNDING <= margin <= max(size.margin, 1.0) * SPARE:
        return None
    return StageSize(size.module, size.face_width, margin, governs, size.volume)


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


def sized_as(design: Design, sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield modules and widths of a sizing that the design leaves open, but for those of bevels and compound sets.

    Args:
        design: With its freedoms.
        sizing: Of it.
    """
    owners, gears = module_owners(design), {gear.stage: gear for gear in sizing.gears}
    for name, stage in design.simple_stages.items():
        if isinstance(stage, Pair) and stage.kind == "bevel":
            continue
        if f"{name}.module" not in sizing.given and owners[name] == name:
            yield f"{design.table(name)}.module_mm", gears[name].module / _MM
        if f"{name}.face_width" not in sizing.given:
            yield f"{design.table(name)}.face_width_mm", gears[name].face_width / _MM


def _diameters(sizing: Sizing) -> Iterator[tuple[str, float]]:
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
