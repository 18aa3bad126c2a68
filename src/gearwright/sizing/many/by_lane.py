"""Batch sizing steps computed design by design: searches, positions and planet bearings."""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, is_dataclass, replace
from types import ModuleType
from typing import Any

import numpy as np

from gearwright.base import Ints
from gearwright.catalogue import bearing_friction
from gearwright.lanes import Diverged, Lanes, Unsupported, change_twins, chosen, each, lanes_of
from gearwright.lanes.twins import PREFIX
from gearwright.parts.bearings import THINNEST, life_modification
from gearwright.parts.iso6336 import endured_cycles
from gearwright.sizing.many.twinned import gathered
from gearwright.sizing.planets import on_rollers
from gearwright.spec import Record, replaced

# ----------------------------------------------------------------------------------------------------------------------
# What the twins of sizing do otherwise for bearings of planets: each lane takes its own of the catalogue.
# ----------------------------------------------------------------------------------------------------------------------


class Names(str):
    """The names of what each lane has; as a text the first of them, as words are for one design alone."""

    __slots__ = ("kinds", "place")
    kinds: tuple[str, ...]
    """Every name that occurs."""
    place: Ints
    """Of every lane, which of them it has."""

    @classmethod
    def of(cls, kinds: Sequence[str], place: Ints) -> Names:
        """Return the names of lanes.

        Args:
            kinds: Every name that occurs.
            place: Of every lane, which of them it has.
        """
        made = cls(kinds[0])
        made.kinds, made.place = tuple(kinds), place
        return made


def each_of(records: Sequence[Any], place: Ints) -> Any:
    """Return a record with the numbers that every lane has of one of some records of a kind.

    Args:
        records: Records, numbers, or texts.
        place: Of every lane, which of them it has.
    """
    first = records[0]
    if all(record == first for record in records):
        return first
    if isinstance(first, str):
        return Names.of(records, place)
    if is_dataclass(first) and not isinstance(first, type):
        own = {part.name: each_of([getattr(record, part.name) for record in records], place) for part in fields(first)}
        return replace(first, **own)
    return gathered(list(records), place.tolist())


def of_catalogue(module: ModuleType) -> None:
    """Try the bearings of the catalogue in all lanes: those that have theirs wait for the others.

    Args:
        module: Twin of the choice of bearings.
    """
    alone: Callable[..., Any] = module._of_catalogue

    def in_lanes(task: Any) -> Any:
        if type(task.room) is not Lanes:
            return alone(task)
        kind, count = task.asked.kind, task.asked.side_by_side
        sizes, best, place = module.cylindrical(), lanes_of(-np.inf), lanes_of(0)
        for k, size in enumerate(sizes):
            fits = lanes_of(best < 1.0) & lanes_of(module.fits(task, size))
            if fits.data.any():
                nearness = lanes_of(module.min_margin(task, on_rollers(kind, size, count)))
                better = fits & (nearness > best)
                best, place = lanes_of(chosen(better, nearness, best)), lanes_of(chosen(better, k, place))
        if bool(best == -np.inf):
            raise Unsupported("planets without room for a bearing")
        taken, own = np.unique(place.data, return_inverse=True)
        return each_of([on_rollers(kind, sizes[k], count) for k in taken.tolist()], own)

    module._of_catalogue = in_lanes  # type: ignore[attr-defined]
    module.at_most = lambda task, fitting: np.full(len(fitting), np.inf)  # type: ignore[attr-defined]


def friction(module: ModuleType) -> None:
    """Look the friction of the series of every lane's bearing up.

    Args:
        module: Twin of the oil of bearings.
    """

    def friction_of(bearing: Any) -> Any:
        names = bearing.designation
        if not isinstance(names, Names):
            return bearing_friction(bearing)
        found = [bearing_friction(replace(bearing, designation=name)) for name in names.kinds]
        return gathered(found, names.place.tolist())

    module.bearing_friction = friction_of  # type: ignore[attr-defined]


def lives(module: ModuleType) -> None:
    """Find the modification of the life of every lane by itself: its ranges differ.

    Args:
        module: Twin of modified lives.
    """
    alone: Callable[..., Any] = module.life_modification

    def modified(clean_share: Any, viscosity_ratio: Any, kind: Any) -> Any:
        if type(clean_share) is not Lanes and type(viscosity_ratio) is not Lanes:
            return alone(clean_share, viscosity_ratio, kind)
        thin = lanes_of(viscosity_ratio < THINNEST)
        if bool(thin):  # which has no life
            raise Unsupported("oil that is too thin")
        return Lanes(each(lambda share, ratio: life_modification(share, ratio, kind), clean_share, viscosity_ratio))

    module.life_modification = modified  # type: ignore[attr-defined]


# ----------------------------------------------------------------------------------------------------------------------
# What the twins of sizing compute for every lane by the function of one design: searches, and places in arrays.
# ----------------------------------------------------------------------------------------------------------------------


def each_lane(function: Callable[..., Any], usual: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function of arrays, or of tuples of them, that is called for those of every lane.

    Args:
        function: Of one design.
        usual: What is called where there are no lanes.
    """

    def computed(*values: Any) -> Any:
        counts = [len(lanes.data) for value in values for lanes in _lanes_in(value)]
        if not counts:
            return usual(*values)
        return stacked_lanes([function(*(of_lane(value, k) for value in values)) for k in range(max(counts))])

    return computed


def holds_lanes(value: Any) -> bool:
    """Tell whether there are lanes in a value.

    Args:
        value: A number, or a collection or record.
    """
    return next(_lanes_in(value), None) is not None


def _lanes_in(value: Any) -> Iterator[Lanes]:
    if type(value) is Lanes:
        yield value
    else:
        for part in _parts(value):
            yield from _lanes_in(part)


def _parts(value: Any) -> Iterator[Any]:
    """Yield what a collection or a record consists of."""
    if isinstance(value, tuple | list):
        yield from value
    elif isinstance(value, dict):
        yield from value.values()
    elif isinstance(value, Record):
        yield from value.__dict__.values()
    elif is_dataclass(value):
        yield from (getattr(value, part.name) for part in fields(value))


def of_lane(value: Any, k: int) -> Any:
    """Return what one lane holds of a value.

    Args:
        value: Lanes, or a collection or record of which parts may be.
        k: Which lane.
    """
    if type(value) is Lanes:
        own = value.data[k if len(value.data) > 1 else 0]
        return own.item() if own.ndim == 0 else own.copy()
    if isinstance(value, tuple | list):
        parts = [of_lane(part, k) for part in value]
        return type(value)._make(parts) if hasattr(value, "_make") else type(value)(parts)
    if isinstance(value, dict):
        return {name: of_lane(part, k) for name, part in value.items()}
    if isinstance(value, Record):
        varied = {name: part for name, part in value.__dict__.items() if holds_lanes(part)}
        return replaced(value, {(name,): of_lane(part, k) for name, part in varied.items()}) if varied else value
    if is_dataclass(value) and not isinstance(value, type):
        own = {part.name: getattr(value, part.name) for part in fields(value)}
        varied = {name: part for name, part in own.items() if holds_lanes(part)}
        return replace(value, **{name: of_lane(part, k) for name, part in varied.items()}) if varied else value
    return value


def stacked_lanes(results: list[Any]) -> Any:
    """Return the results of all lanes in lanes; arrays of different shapes part them.

    Args:
        results: Numbers, arrays, or tuples of them.
    """
    first = results[0]
    if isinstance(first, tuple):
        parts = [stacked_lanes(list(entries)) for entries in zip(*results, strict=True)]
        return type(first)._make(parts) if hasattr(first, "_make") else tuple(parts)
    rows = [np.asarray(result) for result in results]
    if len({row.shape for row in rows}) > 1:
        raise Diverged(np.array([str(row.shape) for row in rows]))
    return Lanes(np.stack(rows))


def _own(module: ModuleType) -> Any:
    """Return the module of a twin."""
    return importlib.import_module(module.__name__.replace(PREFIX, "gearwright", 1))


def _in_each_lane(*names: str) -> Callable[[ModuleType], None]:
    """Return the change of a twin that has functions called for the arrays of every lane."""

    def changed(module: ModuleType) -> None:
        for name in names:
            setattr(module, name, each_lane(getattr(_own(module), name), getattr(module, name)))

    return changed


def _rated(module: ModuleType) -> None:
    """Search the modules of a mesh in all lanes: each has one number of each kind."""
    alone: Callable[..., Any] = module.by_teeth

    def by_teeth(ask: Any, search: Callable[..., Any]) -> Any:
        numbers = (ask.per_tooth, ask.speed, ask.width_ratio, *ask.teeth)
        if not any(type(number) is Lanes for number in numbers):
            return alone(ask, search)
        torque = lanes_of(ask.per_tooth * ask.teeth[0])
        if not bool(torque > module._LEAST_TORQUE):
            return torque * 0.0, torque * 0.0
        return search(tuple(ask.teeth), torque, ask.speed, ask.width_ratio)

    module.by_teeth = by_teeth  # type: ignore[attr-defined]


def _widths(module: ModuleType) -> None:
    """Search modules and face widths of all lanes at once: those that are done wait for the others."""

    def next_standard(needed: Any) -> Any:
        needed, standards = lanes_of(needed).data, np.array([size * module._MM for size in module.STANDARD_MODULES])
        place = np.searchsorted(standards, needed * (1.0 - 1e-9))
        return Lanes(np.where(place < len(standards), standards[np.minimum(place, len(standards) - 1)], needed))

    def under_spectrum(size: Any, ratio: Any, gap: Any, rounded: Any = None) -> Any:
        active = lanes_of(np.True_)
        for _ in range(module.CORRECTIONS):
            before = size
            size = chosen(active, size / module.math.cbrt(gap(size, ratio * size)), size)
            if rounded is None:
                continue
            left = module.LEFT * abs(size - before)
            near = lanes_of(left < size / 2.0)
            left = chosen(near, left, 0.0)
            active = active & ~(near & (rounded(size - left) == rounded(size + left)))
            if not active.data.any():
                break
        return size

    def strong_enough(size: Any, gap: Any, *, standard: bool) -> Any:
        weak, found, left = size, size, lanes_of(np.True_)
        for tried in module._tries(size, standard=standard):
            met = left & lanes_of(gap(tried) >= 1.0 - module.JUST)
            found, left = chosen(met, tried, found), left & ~met
            if not left.data.any():
                break
            weak = chosen(left, tried, weak)
        return found if standard else least(chosen(left, size, weak), found, gap)

    def least(weak: Any, strong: Any, gap: Any) -> Any:
        while (active := lanes_of(strong - weak > module.JUST * strong)).data.any():
            middle = chosen(active, (weak + strong) / 2.0, strong)
            bears = lanes_of(gap(middle) >= 1.0)
            weak, strong = chosen(active & ~bears, middle, weak), chosen(active & bears, middle, strong)
        return strong

    def narrowest(least: Any, widest: Any, gap: Any) -> Any:
        least, widest = np.broadcast_arrays(lanes_of(least).data, lanes_of(widest).data)
        low = Lanes(np.ceil(np.minimum(least, widest) / module._MM - 1e-9).astype(np.int64))
        high = Lanes(np.maximum(np.floor(widest / module._MM + 1e-9).astype(np.int64), 1))
        while (active := low < high).data.any():
            middle = chosen(active, (low + high) // 2, high)
            met = lanes_of(gap(middle * module._MM) >= 1.0)
            high, low = chosen(active & met, middle, high), chosen(active & ~met, middle + 1, low)
        return high * module._MM

    for changed in (next_standard, under_spectrum, strong_enough, narrowest):
        setattr(module, changed.__name__, changed)


def _lives(module: ModuleType) -> None:
    """Look every lane's life up on its own line of the S-N curve."""
    alone: Callable[..., Any] = module.endurable_cycles

    def endurable_cycles(curve: Any, factor: Any) -> Any:
        if type(factor) is not Lanes:
            return alone(curve, factor)
        left, cycles = ~lanes_of(factor > curve.factors[0]), chosen(factor > curve.factors[0], 0.0, math.inf)
        for start, greatest, least, longer, weaker in curve.lines:
            own = left & (factor > least)
            exponent = longer * module.math.log(greatest / chosen(own, factor, greatest)) / weaker
            ends = exponent < module.ENDLESS
            life = start * module.math.exp(chosen(ends, exponent, 0.0))
            cycles, left = chosen(own, chosen(ends, life, math.inf), cycles), left & ~own
        return cycles

    module.endurable_cycles = endurable_cycles  # type: ignore[attr-defined]


def _damages(module: ModuleType) -> None:
    """Find the safety of a spectrum in all lanes at once: those that are done wait for the others."""

    def damage_part(cycles: Any, factor: Any, curve: Any) -> Any:
        loaded = lanes_of(factor > 0.0)
        endured = chosen(loaded, module.endurable_cycles(curve, lanes_of(chosen(loaded, factor, 1.0))), math.inf)
        return chosen(endured > 0.0, cycles / chosen(endured > 0.0, endured, 1.0), math.inf)

    def lasts_in(loads: Any, reference: Any, curve: Any) -> Any:
        if holds_lanes(curve):
            return sum((damage_part(cycles, stress / reference, curve) for stress, cycles in loads), start=0.0) <= 1.0
        columns = [lanes_of(column).data for load in loads for column in (load[1], load[0] / reference)]
        level = np.broadcast_arrays(*columns)  # all levels in one go, as if each were lanes of its own
        cycles, factors = (Lanes(np.concatenate(level[k::2])) for k in (0, 1))
        return Lanes(sum(damage_part(cycles, factors, curve).data.reshape(len(loads), -1), start=0.0) <= 1.0)

    def near(loads: Any, reference: Any, curve: Any, start: Any) -> Any:
        return start if holds_lanes(curve) else _about_one(loads, reference, curve, start, steps=module.STEPS)

    def unit_root(lasts: Any, near: Any, *ends: Any) -> Any:
        low, high = (lanes_of(end) for end in ends)
        about = lanes_of(near())
        about = chosen((about > low) & (about < high), about, low)
        holds, fails = about * (1.0 - _BESIDE), about * (1.0 + _BESIDE)
        holds, fails = chosen(lasts(holds), holds, low), chosen(lasts(fails), high, fails)
        while (active := high / low > 1.0 + 1e-12).data.any():
            middle = chosen(active, (low * high) ** 0.5, low)
            lasting, told = lanes_of(middle <= holds), active & (middle > holds) & (middle < fails)
            if told.data.any():
                lasting = lasting | told & lanes_of(lasts(middle))
            low, high = chosen(active & lasting, middle, low), chosen(active & ~lasting, middle, high)
        return low

    module.damage_part, module._lasts = damage_part, lasts_in  # type: ignore[attr-defined]
    module._near, module._unit_root = near, unit_root  # type: ignore[attr-defined]


_BESIDE = 1e-10
"""How far beside the factor that secants find it is looked for, over it; farther where it is not there [-]."""


@np.errstate(all="ignore")  # what is no number is no place to look beside
def _about_one(loads: Any, reference: Any, curve: Any, start: Any, *, steps: int) -> Lanes:
    """Return about the factor at which Miner's sum is 1 in every lane, by secants in double logarithmic scale."""
    stress, cycles, last = np.broadcast_arrays(
        *(np.stack(np.broadcast_arrays(*(lanes_of(column).data for column in columns)))
          for columns in ([load[0] / reference for load in loads], [load[1] for load in loads], [start]))
    )  # fmt: skip
    at, value, moved = np.log(last[0]), np.zeros(last.shape[1]), np.ones(last.shape[1])
    slope = np.full(last.shape[1], max((longer / weaker for *_, longer, weaker in curve.lines), default=1.0))
    for step in range(steps):
        before, value = value, np.log((cycles / endured_cycles(curve, np.exp(at) * stress)).sum(axis=0))
        moves = (value != before) & (step > 0)
        slope = np.where(moves, (value - before) / np.where(moved == 0.0, 1.0, moved), slope)
        moved = np.where(value == 0.0, 0.0, -value / slope)
        at = at + moved
    return Lanes(np.exp(at))


def _orders(module: ModuleType) -> None:
    """Take the order on an axis as one design does, which remembers it: it depends on names alone."""
    module.best_way = _own(module).best_way  # type: ignore[attr-defined]


def _rooms(module: ModuleType) -> None:
    """Hold the bodies of every lane against each other apart, where lanes differ in which are nearest."""
    together, checked, own = module._meetings, module.room_checks, _own(module)

    def apart(bodies: Any, rules: Any) -> Any:
        count = max(len(lanes.data) for body in bodies for lanes in _lanes_in(body))
        rules, alone = replace(rules, known=[]), list[Any]()
        for k in range(count):
            alone.append(own._meetings([of_lane(body, k) for body in bodies], of_lane(rules, k)))
        found, nearest, labels = list[Any](), list[Any](), list[str]()
        for met_of in alone:
            into = {key: met for key, met in met_of.items() if met.room.gap < -module._TOUCH}
            clear = [(key, met) for key, met in met_of.items() if key not in into]
            found.append(into)
            nearest.append(min(clear, key=lambda pair: round(pair[1].room.gap, 8), default=None))
            labels.append(str([(key, met.names) for key, met in sorted(into.items())] + [nearest[-1] is None]))
        if len(set(labels)) > 1:
            raise Diverged(np.array(labels))
        rooms = {key: stacked_lanes([into[key].room for into in found]) for key in found[0]}
        whole = {key: met._replace(room=rooms[key]) for key, met in found[0].items()}
        if nearest[0] is not None:
            key, first = nearest[0]
            whole[key] = first._replace(room=stacked_lanes([met.room for _, met in nearest]))
        return whole

    def meetings_of(bodies: Any, rules: Any) -> Any:
        try:
            return together(bodies, rules)
        except Diverged:
            return apart(bodies, rules)

    def room_checks(arrangement: Any, rules: Any) -> Any:
        try:
            return checked(arrangement, rules)
        except Diverged:
            rules.known[:] = [(arrangement.bodies, apart(arrangement.bodies, rules))]
            return checked(arrangement, rules)

    module._meetings, module.room_checks = meetings_of, room_checks  # type: ignore[attr-defined]


def _unproven(module: ModuleType) -> None:
    """Tell by directions alone whether bodies stand into each other: points within them are looked for one by one."""
    module._share_a_ball = lambda *_: False  # type: ignore[attr-defined]


def _roots(module: ModuleType) -> None:
    """Go on with tangent points until those of all lanes are found."""
    module._any = lambda moving: bool(lanes_of(moving).data.any())  # type: ignore[attr-defined]


def _outlines(module: ModuleType) -> None:
    """Find the area of a tooth once for each that occurs: they repeat."""
    alone: Callable[..., Any] = _own(module).outline_area

    def outline_area(tooth: Any) -> Any:
        counts = [len(lanes.data) for lanes in _lanes_in(tooth)]
        if not counts:
            return alone(tooth)
        teeth = [of_lane(tooth, k) for k in range(max(counts))]
        known = {one: alone(one) for one in dict.fromkeys(teeth)}
        return Lanes(np.array([known[one] for one in teeth]))

    module.outline_area = outline_area  # type: ignore[attr-defined]


def _alone_known(module: ModuleType) -> None:
    """Keep nothing of meshes: lanes are no keys."""
    module.once = lambda _context, _rating, _key, computed: computed()  # type: ignore[attr-defined]


def _unordered(module: ModuleType) -> None:
    """Leave parts as they came: their order differs from lane to lane, their sums are rounded once."""
    module.ordered = tuple  # type: ignore[attr-defined]


change_twins((
    ("gearwright.sizing.rating.context", _alone_known),
    ("gearwright.sizing.stage_sizes", _in_each_lane("_lightest")),
    ("gearwright.sizing.axis_order", _orders),
    ("gearwright.sizing.places.positioning", _rooms),
    ("gearwright.sizing.places.frames", _unproven),
    ("gearwright.parts.gears.tooth_form", _outlines),
    ("gearwright.parts.iso6336.geometry", _roots),
    ("gearwright.parts.iso6336.steels", _lives),
    ("gearwright.parts.iso6336.steels", _damages),
    ("gearwright.sizing.rating.geometry", _widths),
    ("gearwright.sizing.rating.protocol", _rated),
    ("gearwright.sizing.planets", of_catalogue),
    ("gearwright.catalogue.bearing_choice", friction),
    ("gearwright.parts.bearings.life", lives),
    ("gearwright.sizing.mass.record", _unordered),
    ("gearwright.sizing.housing_shell", _in_each_lane("_around")),
    ("gearwright.sizing.casing", _in_each_lane("_module", "spline", "_pieces")),
    ("gearwright.sizing.inner_walls", _in_each_lane("_walls")),
    ("gearwright.sizing.loads", _in_each_lane("_worst_direction", "_at")),
    ("gearwright.sizing.shafts.carriers", _in_each_lane("stiff_frame")),
))  # fmt: skip
