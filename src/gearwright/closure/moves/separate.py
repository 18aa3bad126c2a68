"""Critical speeds kept away from operating ones: other teeth or another module of one stage, the lightest that does."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from gearwright.closure.closed import Round, Step
from gearwright.closure.loop import Settled
from gearwright.closure.moves.neighbours import (
    TEETH,
    Candidate,
    Change,
    confirmed_anew,
    judged,
    open_modules,
    other_teeth,
    screened,
    standard_modules,
    words_of,
)
from gearwright.closure.proportion import is_tied, searched
from gearwright.closure.wishes import Wishes
from gearwright.spec.design import module_owners

SWEEPS = 5
"""Changes that are made one after another [-]."""
CONFIRMED = 3
"""The most promising choices of a sweep that are confirmed [-]."""
STEPS = (-14, -12, -10, -8, *TEETH, 8, 10, 12, 14)
"""By how many teeth the sun or the pinion of a stage is changed: far enough to step over its main resonance [-]."""
MODULES = (1, 2)
"""By how many steps of ISO 54 the module alone is changed, upwards: smaller ones do not bear the load [-]."""
BESIDE = (-1, 0, 1)
"""By how many steps of ISO 54 it is changed together with the teeth [-]."""
LARGER = (1.05, 1.1, 1.15)
"""Factors on the modules of stages on common axes, which have no standard ones [-]."""
ROUNDING = 1e-6
"""Of what a design lacks [-]."""
_MM = 1e-3


def separated(state: Settled, tell: Callable[[str], None]) -> Settled:
    """Return the lightest design among other teeth and modules whose critical speeds are clear, or the nearest to it.

    Each sweep changes one stage, by its teeth, its module or both, and proportions and confirms every choice anew. What
    was met before, such as lives of planet bearings, is met afterwards. Where changes of given teeth, which are free,
    lead nowhere, it is tried once more without them: what they save is for what makes a design lighter to find.

    Args:
        state: That the loop ended with.
        tell: Called with what is being done.
    """
    lacks = _others(judged(state))
    best, wishes = _separated(state, lacks, tell), state.task.wishes
    if _clear(best, lacks) or "teeth" not in wishes.free:
        return best.settled
    fewer = replace(wishes, free=tuple(name for name in wishes.free if name != "teeth"))
    other = _separated(_wishing(state, fewer), lacks, tell)
    return _wishing(min(best, other, key=lambda row: row.rank).settled, wishes)


def _wishing(state: Settled, wishes: Wishes) -> Settled:
    return replace(state, task=replace(state.task, wishes=wishes))


def _separated(state: Settled, lacks: float, tell: Callable[[str], None]) -> Candidate:
    """Return what up to five changes lead to, each the best of its sweep."""
    best = judged(state)
    for sweep in range(SWEEPS):
        if _clear(best, lacks):
            break
        tell(f"separating critical speeds, sweep {sweep + 1}")
        found = min(_settled_of(best.settled, lacks), key=lambda row: row.rank, default=best)
        if found.rank >= best.rank:
            break
        mass, words = found.settled.sizing.mass, words_of(found.settled.task.chosen)
        round_ = Round(Step.SEPARATE, mass, 1.0 - found.short, 0.0, words)
        settled_ = replace(found.settled, rounds=(*best.settled.rounds, round_, *found.settled.rounds))
        best = Candidate(settled_, found.short, found.near)
    return best


def _others(candidate: Candidate) -> float:
    """Return what checks other than critical speeds and room lack [-]."""
    return candidate.short - candidate.near


def _clear(candidate: Candidate, lacks: float) -> bool:
    """Tell whether no critical speed is near, and nothing else lacks more than it may [-]."""
    return candidate.near <= 0.0 and candidate.short <= lacks + ROUNDING


def _settled_of(state: Settled, lacks: float) -> Iterator[Candidate]:
    """Yield the most promising changes, confirmed, until one is clear and lacks no more than it may [-]."""
    rows = map(judged, screened(state, (*_changes(state), *_together(state))))
    for near in sorted(rows, key=lambda row: row.rank)[:CONFIRMED]:
        candidate = confirmed_anew(near.settled)
        yield candidate
        if _clear(candidate, lacks):
            return


def _changes(state: Settled) -> Iterator[Change]:
    """Yield other numbers of teeth, other modules, and both at once, stage by stage, where they are open."""
    design, owners = state.task.design, module_owners(state.task.design)
    alone = (entry for entry in open_modules(state).items() if not is_tied(design, entry[0], owners))
    open_ = {design.table(name): own for name, own in alone}
    for change in other_teeth(state, STEPS):
        yield change
        values = standard_modules(open_[change.table], BESIDE) if change.table in open_ else ()
        yield from (_with_module(change, change.table, value) for value in values)
    for table, own in open_.items():
        if f"{table}.module_mm" not in state.task.chosen:
            yield from (_with_module(Change("", {}), table, value) for value in standard_modules(own, MODULES))


def _with_module(change: Change, table: str, value: float) -> Change:
    return change._replace(values={**change.values, f"{table}.module_mm": value})


def _together(state: Settled) -> Iterator[Change]:
    """Yield larger modules of the stages on common axes, all by one factor, where the design leaves them open."""
    design, owners = state.task.design, module_owners(state.task.design)
    tied = [name for name in searched(design) if is_tied(design, name, owners)]
    modules = {gear.stage: gear.module for gear in state.sizing.gears}
    if tied and all(design.simple_stages[name].module is None for name in tied):
        own = {name: modules[name] for name in tied if owners[name] == name}
        for factor in LARGER:
            yield Change("", {f"{design.table(name)}.module_mm": factor * own[name] / _MM for name in own})
