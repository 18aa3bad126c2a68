"""What the twins of sizing do otherwise than their modules, because they do it for many designs at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import wraps
from types import ModuleType
from typing import Any

import numpy as np

from gearwright.base import ALIKE, ROUNDING, Ints, Status
from gearwright.lanes import Diverged, Lanes, Unsupported, change_twins, chosen, lanes_of, twin
from gearwright.memo import Memo
from gearwright.spec.design import stage_shifts

Matrix = tuple[bytes, tuple[int, ...]]
"""Content and shape."""
KEPT = 20_000
"""Matrices of which the results are kept [-]."""
SOME, MANY = 16, 512
"""New matrices that are computed with sooner together; and those that are not kept [-]."""


def _remembered(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Return a function of one matrix that looks every lane up by its own."""
    kept, latest = Memo[Matrix, Any](KEPT), Memo[Matrix, Any](1)

    @wraps(function)
    def looked_up(matrix: Any) -> Any:
        data = np.ascontiguousarray(lanes_of(matrix).data)
        whole = (data.tobytes(), data.shape) if len(data) >= MANY else (b"", ())
        if (found := latest.get(whole)) is not None:
            return found
        first, place = _distinct(data)
        own, shape = data[first], data.shape[1:]
        keys = [(content.tobytes(), shape) for content in own]
        results: list[Any] = [kept.get(key) for key in keys]
        missing = [k for k, result in enumerate(results) if result is None]
        if len(missing) == len(keys) >= MANY:
            return latest.keep(whole, _spread(_together(function, own, place), place, len(own)))
        if len(missing) >= SOME:
            found = _together(function, own[missing], np.searchsorted(missing, place))
            made = [_lane(found, n) for n in range(len(missing))]
        else:
            made = [_plain(function(own[k])) for k in missing]
        for k, result in zip(missing, made, strict=True):
            results[k] = kept.keep(keys[k], result)
        if not isinstance(results[0], tuple):
            return _gathered(results, place)
        return tuple(_gathered([result[k] for result in results], place) for k in range(len(results[0])))

    return looked_up


def _together(function: Callable[[Any], Any], matrices: Any, place: Ints) -> Any:
    """Return what a function gives of many matrices in lanes; where they part, so do the lanes that have them."""
    try:
        return function(Lanes(matrices))
    except Diverged as parted:
        labels = np.broadcast_to(np.asarray(parted.labels), (len(matrices),))
        raise Diverged(labels[np.minimum(place, len(labels) - 1)]) from parted


def _spread(found: Any, place: Ints, count: int) -> Any:
    """Return of every lane the result of the matrix that it has."""
    if isinstance(found, tuple):
        return tuple(_spread(part, place, count) for part in found)
    data = lanes_of(found).data
    return Lanes(data[place] if len(data) == count > 1 else data)


def _lane(found: Any, place: int) -> Any:
    """Return the result of one of many matrices."""
    if isinstance(found, tuple):
        return tuple(_lane(part, place) for part in found)
    data = lanes_of(found).data
    return data[place if len(data) > 1 else 0]


def _distinct(data: Any) -> tuple[Ints, Ints]:
    """Return the lanes whose matrices occur first, and of every lane which of them it has, bit for bit."""
    bits = np.ascontiguousarray(data).reshape(len(data), -1).view(np.uint64)
    varied = bits[:, (bits != bits[0]).any(axis=0)]
    if not varied.shape[1]:
        return np.zeros(1, dtype=np.int64), np.zeros(len(bits), dtype=np.int64)
    _, first, place = np.unique(varied @ _odd(varied.shape[1]), return_index=True, return_inverse=True)
    if (varied != varied[first[place]]).any():  # two matrices of one sum
        _, first, place = np.unique(varied, axis=0, return_index=True, return_inverse=True)
    return first, place.ravel()


def _odd(count: int) -> Any:
    """Return odd numbers without a pattern, to tell matrices apart by one sum each."""
    return np.random.default_rng(count).integers(1 << 62, size=count, dtype=np.uint64) * np.uint64(2) + np.uint64(1)


def _plain(found: Any) -> Any:
    """Return arrays without their one lane."""
    if isinstance(found, tuple):
        return tuple(map(_plain, found))
    return found.data[0] if isinstance(found, Lanes) else found


def _gathered(results: list[Any], place: Ints) -> Lanes:
    """Return the result of every lane; lanes whose results differ in shape part."""
    if len(results) == 1:
        return Lanes(results[0][None])
    shapes = [str(result.shape) for result in results]
    if len(set(shapes)) > 1:
        raise Diverged(np.array(shapes)[place])
    return Lanes(np.stack(results)[place])


def _memory(module: ModuleType) -> None:
    module.remembered = _remembered  # type: ignore[attr-defined]


def _gate(module: ModuleType) -> None:
    """Let the gate look at all lanes; those that it does not let pass are told apart."""
    alone: Callable[..., bool] = module._is_number

    def is_number(value: Any, *, endless: bool = False) -> bool:
        if type(value) is not Lanes:
            return alone(value, endless=endless)
        good = ~np.isnan(value.data) if endless else np.isfinite(value.data)
        whole = good.reshape(len(good), -1).all(axis=1)
        return bool(Lanes(whole))

    module._is_number = is_number  # type: ignore[attr-defined]


def _checks(module: ModuleType) -> None:
    """Leave checks in the order in which they are made: which is worst differs from design to design."""

    def accepted(checks: Iterable[Any], waivers: Mapping[str, str]) -> Any:
        named = ((check, waivers.get(check.name, "")) for check in checks)
        return tuple(
            replace(check, waiver=why) if why and check.status is Status.FAILS else check for check, why in named
        )

    module.accepted = accepted  # type: ignore[attr-defined]


def _interference(module: ModuleType) -> None:
    """Let the tips of every lane pass until its own are beyond the ring."""
    room_of = module.Room

    def assembly_room(pair: Any) -> Any:
        halves, active, best = module.tip_halves(pair), lanes_of(np.True_), None
        last = lanes_of(pair.driver.teeth // 2)
        for j in range(int(last.data.max()) + 1):
            reaches, room = module.passing_tip(pair, j, halves)
            active = active & reaches & (last >= j)
            if not active.data.any():
                break
            if best is None:
                if not bool(active):
                    return None
                best = room
                continue
            better = active & (room.clearance < best.clearance)
            best = room_of(*(chosen(better, one, other) for one, other in zip(room, best, strict=True)))
        return best

    module.assembly_room = assembly_room  # type: ignore[attr-defined]


def _by_teeth(module: ModuleType) -> None:
    """Find shifts of teeth once for each teeth that occur: they repeat."""
    in_lanes: Callable[..., Any] = module.stage_shifts

    def stage_shifts_of(design: Any, name: str, teeth: Mapping[Any, Any]) -> Any:
        columns = [lanes_of(number).data for number in teeth.values()]
        count = max(map(len, columns))
        rows = list(zip(*(np.broadcast_to(column, (count,)).tolist() for column in columns), strict=True))
        places = dict[tuple[int, ...], int]()
        place = [places.setdefault(row, len(places)) for row in rows]
        try:
            results = [stage_shifts(design, name, dict(zip(teeth, row, strict=True))) for row in places]
        except TypeError:  # lanes in what it reads
            return in_lanes(design, name, teeth)
        return gathered(results, place)

    module.stage_shifts = stage_shifts_of  # type: ignore[attr-defined]


def gathered(results: list[Any], place: list[int]) -> Any:
    """Return what each lane has of some results; lanes part where they are of different kinds.

    Args:
        results: Numbers, texts or nothing, or tuples of them.
        place: Of every lane, which of them it has.
    """
    first = results[0]
    if all(result == first for result in results):
        return first
    kinds = [type(result) for result in results]
    if len(set(kinds)) > 1 or isinstance(first, str):
        words = isinstance(first, str)
        labels = [str(result) if words else kind.__name__ for result, kind in zip(results, kinds, strict=True)]
        raise Diverged(np.array(labels)[place])
    if isinstance(first, tuple):
        parts = [gathered(list(entries), place) for entries in zip(*results, strict=True)]
        return first._make(parts) if hasattr(first, "_make") else tuple(parts)
    if not isinstance(first, int | float):
        raise Unsupported(f"lanes of {type(first).__name__}")
    return Lanes(np.array(results)[place])


def _tooth_checks(module: ModuleType) -> None:
    """Take of every lane the gear that is nearest to undercut; the check is named by the first."""
    alone: Callable[..., Any] = module._undercut

    def undercut(context: Any, gears: list[Any]) -> Any:
        external = [gear for gear in gears if gear.name not in context.train.internal]
        best, room = alone(context, external[:1]), None
        for gear in external:
            check, spare = alone(context, [gear]), gear.teeth - module.fewest_uncut(context, gear)
            if room is None:
                room = spare
                continue
            nearer = spare < room
            best = replace(
                best, value=chosen(nearer, check.value, best.value), limit=chosen(nearer, check.limit, best.limit)
            )
            room = chosen(nearer, spare, room)
        return best

    module._undercut = undercut  # type: ignore[attr-defined]


def _search(module: ModuleType) -> None:
    """Take the heaviest load of every lane."""

    def heaviest(loads: Iterable[tuple[Any, Any]]) -> tuple[Any, Any]:
        torque, rolling = 0.0, 1.0
        for load, speed in loads:
            heavier = load > torque * (1.0 + ALIKE)
            torque, rolling = chosen(heavier, load, torque), chosen(heavier, speed, rolling)
        return torque, rolling

    module.heaviest = heaviest  # type: ignore[attr-defined]


def _named(module: ModuleType) -> None:
    """Find the worst margin of every lane."""
    totals = {**module._TOTALS, "worst_margin": lambda sizing: module.Named(worst_margin(sizing.checks), "ratio")}
    module._TOTALS = totals  # type: ignore[attr-defined]


_NEAR = 2e-9
"""Margins that are nearer may be one in the order of checks, which rounds them to nine digits [-]."""


def worst_margin(checks: Iterable[Any]) -> Any:
    """Return the margin of the worst check of every lane [-].

    Args:
        checks: Of lanes, without waivers.
    """
    assessed = [check for check in checks if check.ratio is not None and not check.waiver]
    if not assessed:
        return math.inf
    assessed.sort(key=lambda check: (str(check.part), check.what))
    ranks = [np.where(lanes_of(check.ratio >= 1.0 - ROUNDING).data, 4.0, 0.0) + (check.reserve is None)
             for check in assessed]  # fmt: skip
    margins = [lanes_of(check.margin).data for check in assessed]
    rank, margin = (np.stack(np.broadcast_arrays(*columns)) for columns in (ranks, margins))
    margin = np.where(rank == rank.min(axis=0), margin, np.inf)
    close = margin <= margin.min(axis=0) + _NEAR
    unnamed = np.array([check.mode in _CHOSEN for check in assessed])
    if (parted := (close.sum(axis=0) > 1) & close[unnamed].any(axis=0)).any():
        raise Unsupported("checks that are one but for rounding") if parted.all() else Diverged(parted)
    first = close & (np.cumsum(close, axis=0) == 1)
    worst = margin[first.argmax(axis=0), np.arange(margin.shape[1])]
    for own, near in zip(margin, close & ~first, strict=True):
        place = np.flatnonzero(near)
        lower = place[_rounded(own[place]) < _rounded(worst[place])]
        worst[lower] = own[lower]
    return Lanes(worst)


_CHOSEN = ("undercut", "room between bodies")
"""Modes of checks of which each lane has its own part or place."""


def _rounded(values: Any) -> Any:
    return np.array([round(value, DIGITS) for value in values.tolist()])


DIGITS = 9
"""To which the order of checks rounds margins [-]."""


change_twins((
    ("gearwright.sizing.answers", _named),
    ("gearwright.sizing.stages", _tooth_checks),
    ("gearwright.sizing.teeth.search", _search),
    ("gearwright.parts.gears.gear_pair", _interference),
    ("gearwright.spec.design.teeth.profile_shifts", _by_teeth),
    ("gearwright.train.graph", _memory),
    ("gearwright.sizing.result", _gate),
    ("gearwright.checks", _checks),
))  # fmt: skip


def twinned(name: str) -> Any:
    """Return the twin of a module of sizing.

    Args:
        name: Of the module.
    """
    return twin(name)
