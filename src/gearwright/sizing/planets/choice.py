"""Which bearing a planet gets: the smallest that lives, bears and leaves its pin strong, within the room of its rim."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import cache
from typing import NamedTuple, NoReturn

import numpy as np

from gearwright.catalogue import Bearing, bearings, check_bearing
from gearwright.errors import DesignError, Problem
from gearwright.parts.bearings import BearingKind, life_exponent, pair_factor
from gearwright.sizing.bearings import as_made, highest_speed_factor, oiled_life, planet_duty, running_of
from gearwright.sizing.pinned import PlanetBearingSizing
from gearwright.sizing.planets.films import design_oil, film_margin, judged, on_film
from gearwright.sizing.planets.rollers import integral, on_rollers, roller_of
from gearwright.sizing.planets.task import Task

SIZES = 48
"""Pins that are tried, equally far in their logarithm [-]."""
SLIMMEST = 0.1
"""The thinnest of them over the room [-]."""
_HALVINGS = 16
"""Between the last that does not serve and the first that does [-]."""
_NARROW = 1e-9
ROLLERS = "cylindrical roller bearing of the catalogue"
"""What has no room, in the words of a refusal."""

Made = Callable[[float], PlanetBearingSizing | None]
"""Diameter of a pin -> the bearing on it; None where there is none."""


class Tried(NamedTuple):
    """A size with the least of what it has over what it must have."""

    runs_on: PlanetBearingSizing
    margin: float
    """[-]"""


def chosen(task: Task) -> PlanetBearingSizing:
    """Return what a planet turns on: as named, or the smallest that serves; where none does, the one nearest to it.

    Args:
        task: The planet.

    Raises:
        DesignError: No size has room in the planet.
    """
    asked = task.asked
    if asked.designation is not None:
        return on_rollers(asked.kind, as_made(asked, asked.designation), asked.side_by_side)
    if asked.is_fitted:
        return _of_catalogue(task)
    return _by_diameter(task, lambda pin: _made(task, pin))


def _of_catalogue(task: Task) -> PlanetBearingSizing:
    """Return the first cylindrical roller bearing that serves, by outside and width."""
    count = task.asked.side_by_side
    fitting = [on_rollers(task.asked.kind, size, count) for size in cylindrical() if fits(task, size)]
    if not fitting:
        refuse_catalogue(task)
    tried = (Tried(size, margin(task, size)) for size in fitting)
    return _first(list(_until_one_serves(tried)))


@cache
def cylindrical() -> tuple[Bearing, ...]:
    """Return the cylindrical roller bearings of the catalogue, by outside, width and bore."""
    rollers = [size for size in bearings().values() if size.kind is BearingKind.CYLINDRICAL]
    return tuple(sorted(rollers, key=lambda size: (size.outer_diameter, size.width, size.bore)))


def fits(task: Task, size: Bearing) -> bool:
    """Tell whether bearings have room in a planet, on the pin that the design gives.

    Args:
        task: The planet.
        size: Of the bearings.
    """
    bore, width = _pin(task), task.asked.side_by_side * size.width
    within = (size.outer_diameter <= task.room + _NARROW) & (width <= task.width + _NARROW)
    return within if bore is None else within & (abs(size.bore - bore) < _NARROW)


def _by_diameter(task: Task, made: Made) -> PlanetBearingSizing:
    """Return the bearing on the thinnest pin that serves, or on the one that is given."""
    given = _pin(task)
    if given is not None:
        if (runs_on := made(given)) is None:
            _refuse_room(task, f"{task.asked.kind} bearing on a pin of {1e3 * given:.4g} mm")
        return runs_on
    pins = np.geomspace(SLIMMEST * task.room, task.room, SIZES).tolist()
    tried = list(_until_one_serves(_sizes(task, pins, made)))
    if not tried:
        _refuse_room(task, f"{task.asked.kind} bearing")
    best = _first(tried)
    if tried[-1].margin < 1.0 or len(tried) == 1:
        return best
    return _refined(task, tried[-2], tried[-1], made)


def _sizes(task: Task, pins: list[float], made: Made) -> Iterator[Tried]:
    for pin in pins:
        runs_on = made(pin)
        if runs_on is not None and runs_on.outer_diameter <= task.room:
            yield Tried(runs_on, margin(task, runs_on))


def _until_one_serves(tried: Iterator[Tried]) -> Iterator[Tried]:
    for one in tried:
        yield one
        if one.margin >= 1.0:
            return


def min_margin(task: Task, runs_on: PlanetBearingSizing) -> float:
    """Return the margin of a bearing, none above 1: what serves is as good as any [-].

    Args:
        task: The planet.
        runs_on: Its bearing.
    """
    return min(margin(task, runs_on), 1.0)


def _first(tried: list[Tried]) -> PlanetBearingSizing:
    """Return the one that serves, or comes nearest to it."""
    return max(tried, key=lambda one: min(one.margin, 1.0)).runs_on


def _refined(task: Task, short: Tried, enough: Tried, made: Made) -> PlanetBearingSizing:
    """Return a size that just serves, between one that does not and one that does."""
    low, best = short.runs_on.pin_diameter, enough
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + best.runs_on.pin_diameter)
        runs_on = made(middle)
        if runs_on is not None and margin(task, runs_on) >= 1.0:
            best = Tried(runs_on, 1.0)
        else:
            low = middle
    return best.runs_on


def _made(task: Task, pin: float) -> PlanetBearingSizing | None:
    """Return rollers or a film on a pin; None where too few rollers have room."""
    asked = task.asked
    if asked.kind == "plain":
        return on_film(asked, pin, task.width, task.fastest)
    roller = roller_of(asked.kind, pin, asked.roller_diameter)
    rollers = integral(asked.kind, pin, roller, width=task.width / asked.side_by_side)
    return None if rollers is None else on_rollers(asked.kind, rollers, asked.side_by_side)


def margin(task: Task, runs_on: PlanetBearingSizing) -> float:
    """Return the least of what a bearing has over what it must have [-].

    Lives count by the load that they could bear more, (L/L_asked)^(1/p).

    Args:
        task: The planet.
        runs_on: Its bearing.
    """
    load = task.load(runs_on)
    pin = task.pin_margin(runs_on.pin_diameter, load)
    if runs_on.journal is not None:
        oil = design_oil(task.context.design, task.asked)
        films = judged(runs_on.journal, load, task.asked, oil)
        return min([pin, *(film_margin(film, runs_on.journal, task.asked, oil) for film in films)])
    assert runs_on.bearing is not None
    design, made = task.context.design, runs_on.bearing
    duty = planet_duty(task.context, task.seat, made, load)
    check = check_bearing(made, duty)
    oiled = oiled_life(design, made, duty, path=task.path) if design.bearing_rules.life == "modified" else None
    life = (check.life if oiled is None else oiled.life) / duty.life
    fast = running_of(made, duty).speed_factor
    slow = highest_speed_factor(made.kind, design) / fast if fast else pin
    static = check.static_margin * _static_share(runs_on)
    return float(min(pin, life ** (1.0 / life_exponent(made.kind)), static, slow))


def _static_share(runs_on: PlanetBearingSizing) -> float:
    """Return what equal bearings side by side bear at rest over what they do in life [-]."""
    assert runs_on.bearing is not None
    return runs_on.side_by_side / pair_factor(runs_on.bearing.kind, runs_on.side_by_side)


def _refuse_room(task: Task, what: str, least: str = "") -> NoReturn:
    message = (
        f"no {what} has room: its bore may have {1e3 * task.room:.4g} mm and its width {1e3 * task.width:.4g} mm;"
        f" {least}take another kind, larger or fewer planets, or thinner rims (gears.rim_thickness_ratio)"
    )
    raise DesignError([Problem(task.path, message)])


def refuse_catalogue(task: Task) -> NoReturn:
    """Raise where no bearing of the catalogue has room, with what has it: the diameter and number of planets.

    Args:
        task: The planet.

    Raises:
        DesignError: Always.
    """
    if (bore := _pin(task)) is not None and not any(abs(size.bore - bore) < _NARROW for size in cylindrical()):
        bores = sorted({size.bore for size in cylindrical()}, key=lambda known: abs(known - bore))[:2]
        near = " and ".join(f"{1e3 * known:g}" for known in sorted(bores))
        message = f"no {ROLLERS} sits on a pin of {1e3 * bore:.4g} mm; the nearest are for {near} mm"
        raise DesignError([Problem(task.path, message)])
    _refuse_room(task, ROLLERS, _with_room(task))


def _with_room(task: Task) -> str:
    """Return which bearing comes nearest to having room, and the planets in which it has: its teeth keep their number.

    Fewer planets bear more each, and their module grows with the cube root of that.
    """
    bore, planet, count = _pin(task), task.planet, task.asked.side_by_side
    sizes = [size for size in cylindrical() if bore is None or abs(size.bore - bore) < _NARROW]
    size = min(sizes, key=lambda size: max(size.outer_diameter / task.room, count * size.width / task.width))
    larger, wide = size.outer_diameter / task.room, count * size.width
    fewer = math.floor(planet.bodies / larger**3 + 1e-9)
    which = f", which {fewer} planets ask for" if 1 < fewer < planet.bodies else ""
    asked = [
        f"planets of {1e3 * larger * planet.pitch_diameter:.4g} mm in place of {1e3 * planet.pitch_diameter:.4g} mm (a"
        f" module of {1e3 * larger * planet.module:.4g} mm{which})"
    ] if larger > 1.0 else []  # fmt: skip
    asked += [f"a face of {1e3 * wide:.4g} mm"] if wide > task.width else []
    return f"{size.designation}, {1e3 * size.outer_diameter:g} mm outside, has it with {' and '.join(asked)}; or "


def _pin(task: Task) -> float | None:
    """Return the diameter of the pin that the design gives [m]; None where it is left open."""
    return task.asked.diameter or task.context.given.get(f"{task.planet.stage}.pin_diameter")
