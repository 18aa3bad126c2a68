"""What planets turn on, where a design leaves it open: the lightest kind that lives, wider planets included."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

from gearwright.checks import Check, Status
from gearwright.closure.closed import Round, Step
from gearwright.closure.confirm import changes_of
from gearwright.closure.loop import Settled, Task, settled
from gearwright.closure.proportion import Proportioned, proportioned, teeth_of
from gearwright.closure.requirements import requirement_of, wanted
from gearwright.errors import GearwrightError
from gearwright.sizing import Sizing, size
from gearwright.sizing.rating import STANDARD_MODULES
from gearwright.spec import edited
from gearwright.spec.edit import Value

OF_PLANETS = ("bearings", "room of planets", "carriers")
"""Requirements that they must meet in their set."""
ROLLING = (("cylindrical", 1), ("cylindrical", 2), ("integral", 1), ("needle", 1), ("ceramic", 1))
"""Kinds and numbers side by side that are tried first."""
FILM = (("plain", 1),)
"""Tried where no rolling bearing does: it asks for pressed oil from the start."""
SMALLER = 3
"""Steps of ISO 54 by which the module is made smaller, the planet with it, and the face wider, where none does [-]."""
_MM = 1e-3


class Tried(NamedTuple):
    """A set with one kind of bearing."""

    changes: Mapping[str, Value]
    """Path -> value."""
    short: float
    """What its checks lack of their limits [-]."""
    rank: int
    """Rolling ones first [-]."""
    mass: float
    """Of gears, shafts and carriers [kg]."""

    @property
    def order(self) -> tuple[float, int, float]:
        """What meets more comes first, then rolling bearings, then what is lighter."""
        return round(self.short, 6), self.rank, self.mass


def borne(state: Settled, tell: Callable[[str], None]) -> Settled:
    """Return the design with a bearing in the planets of every set that leaves it open, proportioned anew.

    Args:
        state: From the loop.
        tell: Called with what is being done.
    """
    chosen: dict[str, Value] = {}
    for stage in open_sets(state):
        tell(f"choosing what the planets of {stage} turn on")
        best = min(_tried(state, stage), key=lambda row: row.order, default=None)
        if best is not None:
            chosen |= best.changes
    if not chosen:
        return state
    words = "; ".join(f"{path} = {value}" for path, value in chosen.items())
    round_ = Round(Step.BEAR, state.sizing.mass, 1.0, 0.0, words)
    again = settled(replace(state.task, chosen={**state.task.chosen, **chosen}, start=None, factors=state.task.factors))
    return replace(again, rounds=(*state.rounds, round_, *again.rounds))


def open_sets(state: Settled) -> list[str]:
    """Return the planetary sets whose design names no bearing, and for which none is chosen.

    Args:
        state: From the loop.
    """
    design, chosen = state.task.design, state.task.chosen
    open_ = [name for name, stage in design.planetaries.items() if "planet_bearing" not in stage.model_fields_set]
    return [name for name in open_ if f"{design.table(name)}.planet_bearing.kind" not in chosen]


def short_of(sizing: Sizing, stage: str, left_out: frozenset[str]) -> float:
    """Return what planets, pins and bearings of a set lack of their limits [-].

    Args:
        sizing: As sized.
        stage: The set.
        left_out: Requirements that do not count.
    """
    counted = wanted(sizing.checks, left_out)
    return sum(1.0 - (check.margin or 0.0) for check in counted if _lacks(check, stage))


def _lacks(check: Check, stage: str) -> bool:
    return check.part.name == stage and check.status is Status.FAILS and requirement_of(check) in OF_PLANETS


def _tried(state: Settled, stage: str) -> Iterator[Tried]:
    """Yield every kind at the size as it is, and on smaller modules with wider faces until one kind serves."""
    for module, own in _sizes(state, stage):
        rows = [*_kinds(own, stage, module, state.task)]
        yield from rows
        if any(row.short <= 0.0 for row in rows):
            return


def _sizes(state: Settled, stage: str) -> Iterator[tuple[float | None, Proportioned]]:
    """Yield the set as it is and with smaller modules [mm]."""
    yield None, state.proportioned
    design, sizing, task = state.task.design, state.sizing, state.task
    if stage not in state.proportioned.sizes or design.planetaries[stage].module is not None:
        return
    module = state.proportioned.sizes[stage].module
    smaller = [value for value in STANDARD_MODULES if value * _MM < module * (1.0 - 1e-9)]
    for value in reversed(smaller[-SMALLER:]):
        change = {**dict(teeth_of(task.changed, sizing)), f"planetaries.{stage}.module_mm": value}
        stated = edited(edited(task.changed, change), changes_of(design, state.factors))
        own = proportioned(stated, task.wishes, before=sizing, targets=task.targets)
        if own.sizes[stage].margin < 1.0:
            return
        yield value, own


def _kinds(own: Proportioned, stage: str, module: float | None, task: Task) -> Iterator[Tried]:
    """Yield a set on every kind of bearing."""
    path = f"planetaries.{stage}"
    for rank, (kind, count) in enumerate(ROLLING + FILM):
        changes: dict[str, Value] = {f"{path}.planet_bearing.kind": kind}
        if count > 1:
            changes[f"{path}.planet_bearing.side_by_side"] = count
        if stage in task.planets and kind != "plain":
            changes[f"{path}.planet_bearing.life_h"] = task.planets[stage]
        try:
            sizing = size(edited(own.design, changes))
        except GearwrightError:
            continue
        if module is not None:
            changes[f"{path}.module_mm"] = module
        yield Tried(changes, short_of(sizing, stage, task.wishes.left_out), int(rank >= len(ROLLING)), sizing.mass)
