"""The nearest variant of a gearbox that does not meet everything: as it is written, with less asked of it."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple

from gearwright.base import Check, GearwrightError, Mass, Shown, accepted, verb, worst
from gearwright.closure.requirements import FATIGUE, HOUR, Closed, Outcome, wanted
from gearwright.dynamics.sharing import sharing_checks
from gearwright.dynamics.vibration import motion_checks
from gearwright.sizing import Sizing, size
from gearwright.sizing.making import built_checks
from gearwright.sizing.mass import complete_mass
from gearwright.spec import Design, edited
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# What may be asked less of: the life, the power of all machines, or their speeds, where critical ones lie too near.
# ----------------------------------------------------------------------------------------------------------------------


SHORTER = (0.9, 0.75, 0.5, 0.35, 0.2, 0.1, 0.05, 0.02)
"""Parts of the life that are tried, one after another [-]."""
WEAKER = (0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.35, 0.25)
"""Parts of the power that are tried [-]."""
HALVINGS = 3
"""Of the range between the last that does not pass and the first that does [-]."""
LESS = 0.75
"""Part of the lives that is asked where speeds alone do not do [-]."""
FURTHEST = 8
"""Per cent by which speeds are changed at most [-]."""
GEARS, BEARINGS = "service.life_h", "service.bearing_life_h"
_LIVE = {GEARS: "gears live", BEARINGS: "bearings live"}
LIVES = ("life", "bearing life")
"""Modes of checks that a shorter life of bearings meets."""
_DIGITS = 9


class Way(NamedTuple):
    """One thing, or several together, of which less or something else may be asked."""

    asked: Callable[[float], _Demand]
    """What a part of it is."""
    parts: tuple[float, ...]
    """That are tried, the nearest to all of it first [-]."""
    shakes: bool = False
    """Whether it moves critical speeds, so that each is held against all checks."""


@dataclass(frozen=True, repr=False)
class Eased(Shown):
    """A closed design of which less is asked, so that it passes as it is written: sized, and all its checks made."""

    what: str
    """What is asked, in words."""
    changes: Mapping[str, Value]
    """Path -> value, in the unit of the path."""
    design: Design
    """The closed design with them."""
    mass: Mass
    """Of everything in it [kg]."""
    worst: Check
    """Of its checks."""


@verb
def eased(closed: Closed) -> Eased | None:
    """Return the nearest variant that passes in the sizes that were found: for less life, less power, or other speeds.

    A shorter life is looked for where lives end too early, less power where that does not do, and then both; other
    speeds, per cent by per cent up and down, where critical ones lie too near, alone and with less life and power.

    Args:
        closed: What a closure came to.

    Returns:
        None where it meets everything, where none of these does, and where flights are asked for.
    """
    if closed.outcome is Outcome.CLOSED or any(check.mode in _FLOWN for check in closed.checks):
        return None
    for way in _ways(closed):
        if (part := _part(closed, way)) is not None:
            asked = way.asked(part)
            design = edited(closed.design, asked.changes)
            sizing = size(design)
            found = worst(_checks(closed, sizing, whole=True))
            assert found is not None
            return Eased(asked.words, asked.changes, design, complete_mass(sizing).total, found)
    return None


_FLOWN = ("pitting life", "bending life", "oil temperature")


def _ways(closed: Closed) -> Iterator[Way]:
    """Yield what may help with what is not met, a shorter life first."""
    modes, service = {row.check.mode for row in closed.unmet}, closed.design.service
    lives = {GEARS: service.life / HOUR, BEARINGS: service.bearing_life / HOUR}
    powers, speeds = _stated(closed, "power", "torque"), _stated(closed, "speed")
    if any(row.requirement == "critical speeds" for row in closed.unmet):
        beside = tuple(1.0 + sign * step / 100.0 for step in range(1, FURTHEST + 1) for sign in (1, -1))
        if speeds:
            yield Way(lambda part: _Demand(speeds=speeds, speed=part), beside, shakes=True)
            yield Way(lambda part: _Demand(lives, LESS, powers, min(part, 1.0), speeds, part), beside, shakes=True)
        return
    asked = [GEARS] * bool(modes & set(FATIGUE)) + [BEARINGS] * bool(modes & set(LIVES))
    if asked:
        yield Way(lambda part: _Demand({path: lives[path] for path in asked}, part), SHORTER)
    if powers:
        yield Way(lambda part: _Demand(powers=powers, power=part), WEAKER)
        yield Way(lambda part: _Demand(lives, part, powers, part), WEAKER)


class _Demand(NamedTuple):
    """What is asked of a variant."""

    lives: Mapping[str, float] = MappingProxyType({})
    """Path -> value of the design [h]."""
    life: float = 1.0
    """Part of it [-]."""
    powers: Mapping[str, float] = MappingProxyType({})
    """Path -> value, of torques alike."""
    power: float = 1.0
    speeds: Mapping[str, float] = MappingProxyType({})
    speed: float = 1.0

    @property
    def changes(self) -> dict[str, Value]:
        """Path -> value."""
        rows = ((self.lives, self.life), (self.powers, self.power), (self.speeds, self.speed))
        return {path: round(part * value, _DIGITS) for own, part in rows if part != 1.0 for path, value in own.items()}

    @property
    def words(self) -> str:
        """What that is."""
        rows = (("power", self.powers, self.power), ("speed", self.speeds, self.speed))
        words = [f"every {name} at {part:.2f} of what is asked" for name, own, part in rows if own and part != 1.0]
        lives = self.lives.items() if self.life != 1.0 else ()
        words += [f"{_LIVE[path]} {self.life * hours:.6g} h instead of {hours:.6g} h" for path, hours in lives]
        return ", ".join(words)


def _stated(closed: Closed, *names: str) -> dict[str, float]:
    """Return the numbers that machines and cases of a closed design state of some quantities: path -> value."""
    machines, key = closed.design.machines, re.compile(rf"(\w+_)?({'|'.join(names)})(_[a-z]+)?")
    tables = tomllib.loads(closed.text)
    own = {name: table for name, table in tables.items() if name == "cases" or _is_of(table, machines)}
    return {path: value for path, value in _numbers(own) if value and key.fullmatch(path.rpartition(".")[2])}


def _is_of(table: object, machines: Mapping[str, object]) -> bool:
    return isinstance(table, dict) and bool(table) and table.keys() <= machines.keys()


def _numbers(table: Mapping[str, object], before: str = "") -> Iterator[tuple[str, float]]:
    """Yield path and value of every number in tables."""
    for name, value in table.items():
        if isinstance(value, dict):
            yield from _numbers(value, f"{before}{name}.")
        elif isinstance(value, int | float) and not isinstance(value, bool):
            yield f"{before}{name}", float(value)


# ----------------------------------------------------------------------------------------------------------------------
# How much less: the largest part, in hundredths, with which the written sizes pass every check.
# ----------------------------------------------------------------------------------------------------------------------


def _part(closed: Closed, way: Way) -> float | None:
    """Return the part of what is asked, nearest to all of it, with which everything passes; None where none does."""
    high = 1.0
    for part in way.parts:
        if _passes(closed, way, part, whole=way.shakes):
            break
        high = part
    else:
        return None
    low = part
    for _ in range(0 if way.shakes else HALVINGS):
        middle = _hundredths(math.sqrt(low * high))
        if not low < middle < high:
            break
        low, high = (middle, high) if _passes(closed, way, middle, whole=False) else (low, middle)
    return next((part for part in (low, _hundredths(0.9 * low)) if _passes(closed, way, part, whole=True)), None)


def _hundredths(part: float) -> float:
    """Return a part in hundredths, below a tenth in thousandths, downwards [-]."""
    step = 100.0 if part >= 0.1 else 1000.0
    return math.floor(part * step + 1e-6) / step


def _passes(closed: Closed, way: Way, part: float, *, whole: bool) -> bool:
    """Tell whether a part of what is asked passes: as sized, or with what shakes it, too."""
    try:
        sizing = size(edited(closed.design, way.asked(part).changes))
        if any(check.fails for check in _checks(closed, sizing, whole=False)):
            return False
        return not whole or not any(check.fails for check in _checks(closed, sizing, whole=True))
    except GearwrightError:
        return False


def _checks(closed: Closed, sizing: Sizing, *, whole: bool) -> list[Check]:
    checks = [*sizing.checks, *built_checks(sizing)]
    if whole:
        checks += [*sharing_checks(sizing), *motion_checks(sizing)]
    return list(accepted(wanted(checks, closed.wishes.left_out), sizing.design.waivers))
