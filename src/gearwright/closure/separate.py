"""Critical speeds kept away from operating ones: other teeth or another module of one stage, the lightest that does."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

from gearwright.checks import Check, Status
from gearwright.closure.closed import Round, Step
from gearwright.closure.confirm import changes_of
from gearwright.closure.loop import Settled, settled
from gearwright.closure.proportion import is_tied, proportioned, searched, sizes_of, teeth_of
from gearwright.closure.requirements import requirement_of, wanted
from gearwright.dynamics.vibration import resonance_checks
from gearwright.errors import GearwrightError
from gearwright.identity import Role
from gearwright.sizing import Sizing, size
from gearwright.sizing.rating import STANDARD_MODULES
from gearwright.spec import edited
from gearwright.spec.design import Planetary, module_owners
from gearwright.spec.edit import Value

MOVED = ("critical speeds", "room", "teeth")
"""Requirements that other teeth and modules move."""
SWEEPS = 5
"""Changes that are made one after another [-]."""
CONFIRMED = 3
"""The most promising choices of a sweep that are confirmed [-]."""
TEETH = (-6, -4, -3, -2, -1, 1, 2, 3, 4, 6)
"""By how many teeth the sun or the pinion of a stage is changed [-]."""
MODULES = (1, 2)
"""By how many steps of ISO 54 the module of a stage is changed, upwards: smaller ones do not bear the load [-]."""
LARGER = (1.05, 1.1, 1.15)
"""Factors on the modules of stages on common axes, which have no standard ones [-]."""
_MM = 1e-3


class Candidate(NamedTuple):
    """A settled design beside how far its critical speeds are from where they may be."""

    settled: Settled
    short: float
    """Sum of what all failing checks lack of their limits [-]."""
    near: float
    """The part of critical speeds and of room in it [-]."""

    @property
    def rank(self) -> tuple[float, float]:
        """What meets more comes first, then what is lighter."""
        return round(self.short, 6), self.settled.sizing.mass


def judged(state: Settled) -> Candidate:
    """Return a settled design with what its sizing and its resonances lack.

    Args:
        state: From the loop.
    """
    checks = wanted([*state.sizing.checks, *resonance_checks(state.sizing)], state.task.wishes.left_out)
    lacking = [check for check in checks if check.status is Status.FAILS and not check.waiver]
    near = (check for check in lacking if requirement_of(check) in MOVED)
    return Candidate(state, _sum(lacking), _sum(near))


def _sum(checks: Iterable[Check]) -> float:
    return sum(1.0 - (check.margin or 0.0) for check in checks)


def resonant(sizing: Sizing) -> list[Check]:
    """Return the critical speeds that lie too near.

    Args:
        sizing: As sized.
    """
    return [check for check in resonance_checks(sizing) if check.status is Status.FAILS]


def separated(state: Settled, tell: Callable[[str], None]) -> Settled:
    """Return the lightest design among other teeth and modules whose critical speeds are clear, or the nearest to it.

    Each sweep changes one stage, by teeth or by its module, and proportions and confirms every choice anew.

    Args:
        state: That the loop ended with.
        tell: Called with what is being done.
    """
    best = judged(state)
    for sweep in range(SWEEPS):
        if best.near <= 0.0:
            break
        tell(f"separating critical speeds, sweep {sweep + 1}")
        found = min(_settled_of(best.settled), key=lambda row: row.rank, default=best)
        if found.rank >= best.rank:
            break
        mass, words = found.settled.sizing.mass, _words(found.settled.task.chosen)
        round_ = Round(Step.SEPARATE, mass, 1.0 - found.short, 0.0, words)
        settled_ = replace(found.settled, rounds=(*best.settled.rounds, round_, *found.settled.rounds))
        best = Candidate(settled_, found.short, found.near)
    return best.settled


def _settled_of(state: Settled) -> Iterator[Candidate]:
    """Yield the most promising changes, confirmed, until one meets everything."""
    promising = sorted(_neighbours(state), key=lambda row: row.rank)
    for screened in promising[:CONFIRMED]:
        candidate = judged(settled(screened.settled.task))
        yield candidate
        if candidate.near <= 0.0:
            return


def _neighbours(state: Settled) -> Iterator[Candidate]:
    """Yield every choice of one change that can be sized, with the dynamic factors of what it is a change of."""
    for change in (*_changes(state), *_together(state)):
        try:
            yield _screened(state, change)
        except GearwrightError:
            continue


def _screened(state: Settled, change: Change) -> Candidate:
    """Return a change of one stage, proportioned once; the teeth of the other stages stay."""
    design, sizing = state.task.design, state.sizing
    stays = {path: value for path, value in teeth_of(design, sizing) if not path.startswith(f"{change.table}.")}
    own = {path: value for path, value in state.task.chosen.items() if path not in change.frees}
    task = replace(state.task, chosen={**own, **stays, **change.values})
    stated = edited(task.changed, changes_of(task.design, state.factors))
    first = size(edited(stated, dict(sizes_of(stated, state.proportioned.sizes))))
    found = proportioned(stated, task.wishes, before=first, targets=task.targets)
    return judged(replace(state, task=replace(task, start=first), proportioned=found))


class Change(NamedTuple):
    """A change of one stage."""

    table: str
    """Of the stage in the design file."""
    values: Mapping[str, Value]
    """Path -> value."""
    frees: tuple[str, ...] = ()
    """Paths that were chosen before and are free again: what else follows from the teeth."""


def _changes(state: Settled) -> Iterator[Change]:
    """Yield other numbers of teeth and other modules, stage by stage, where the design leaves them open."""
    design, sizing, chosen = state.task.design, state.sizing, state.task.chosen
    for name in searched(design):
        stage, table = design.simple_stages[name], design.table(name)
        keys = _SET if isinstance(stage, Planetary) else _PAIR
        gear = next(gear for gear in sizing.gears if gear.stage == name)
        if all(getattr(stage, key) is None for key in keys) and gear.role in (Role.SUN, Role.PINION):
            frees = tuple(f"{table}.{key}" for key in keys)
            yield from (Change(table, {frees[0]: gear.teeth + step}, frees) for step in TEETH)
        alone = not is_tied(design, name, module_owners(design))
        if alone and stage.module is None and f"{table}.module_mm" not in chosen:
            series = [value for value in STANDARD_MODULES if value * _MM > gear.module * (1.0 + 1e-9)]
            steps = (step for step in MODULES if step <= len(series))
            yield from (Change("", {f"{table}.module_mm": series[step - 1]}) for step in steps)


def _together(state: Settled) -> Iterator[Change]:
    """Yield larger modules of the stages on common axes, all by one factor, where the design leaves them open."""
    design, owners = state.task.design, module_owners(state.task.design)
    tied = [name for name in searched(design) if is_tied(design, name, owners)]
    modules = {gear.stage: gear.module for gear in state.sizing.gears}
    if tied and all(design.simple_stages[name].module is None for name in tied):
        own = {name: modules[name] for name in tied if owners[name] == name}
        for factor in LARGER:
            yield Change("", {f"{design.table(name)}.module_mm": factor * own[name] / _MM for name in own})


_SET = ("sun_teeth", "planet_teeth", "ring_teeth")
_PAIR = ("pinion_teeth", "wheel_teeth")


def _words(chosen: Mapping[str, Value]) -> str:
    return "; ".join(f"{path} = {value}" for path, value in chosen.items())
