"""The first layer: points that fill the axes and their ends, sized together in columns, of which each part keeps few.

What is kept is the front, the best of every section of every range, and the best with any values of lists: what is best
in the end may lie in another valley than the best of the points. Every second point is drawn apart, so that ranges have
points at their ends, where what is best often lies. What cannot be sized together is left out and counted: this layer
only says where generations begin.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.errors import GearwrightError
from gearwright.optimum.freedoms import freedoms_of, is_continuous
from gearwright.optimum.judging import Judged, judged, judged_columns
from gearwright.signals import heard_after
from gearwright.sizing import in_lanes
from gearwright.spec import Design, Study, edited, value_at
from gearwright.spec.studies import Axis, Search, axis_length
from gearwright.study.answers import Blocks, Row, block_of_columns, blocks_of, crowding, non_dominated

LEAST, MOST = 4096, 131_072
"""Points that are sized at once: the more the quicker each, the fewer the less is lost when it is stopped [-]."""
KEPT = 64
"""Of the front of each part, and of its values of lists, at most [-]."""
SECTIONS = 8
"""Of every range, beside its two ends [-]."""
APART = 1.5
"""By which every second point is drawn apart: a sixth of them stands at either end of a range [-]."""
NONE = "none of this part can be sized together with others, or all are refused"
"""Reason of the row that stands for a part without any."""


class Part(NamedTuple):
    """Some of the points of one design."""

    design: str
    number: int
    """Of its first case in the journal."""
    first: int
    """Its first point in the sequence."""
    points: int


class Screened(NamedTuple):
    """What a part keeps."""

    blocks: Blocks
    sized: int
    """Points that were sized [-]."""


def parts_of(study: Study, search: Search) -> Iterator[Part]:
    """Yield the parts of the first layer.

    Args:
        study: With designs.
        search: Its table.
    """
    size = min(max(LEAST, 1 << max(search.screened // 8 - 1, 1).bit_length()), MOST)
    for place, name in enumerate(study.designs):
        for first in range(0, search.screened, size):
            yield Part(name, place * search.screened + first, first, min(size, search.screened - first))


def screened(study: Study, designs: Mapping[str, Design], part: Part) -> Screened:
    """Return the best of a part: of those that keep the constraints, or break them least, what none dominates.

    Args:
        study: With axes, objectives and constraints.
        designs: Name -> design.
        part: Which points.
    """
    places = _places(study, part)
    columns = {path: _values(path, axis, places[:, k]) for k, (path, axis) in enumerate(study.axes.items())}
    try:
        base = edited(
            designs[part.design], {path: value for path, value in study.changes.items() if path not in columns}
        )
    except GearwrightError as error:
        return Screened(_none(part, columns, str(error)), 0)
    found, _ = in_lanes(base, columns, study.asked, count=part.points)
    sized = found.done.copy()
    for name in study.asked:
        sized &= ~np.isnan(found.values.get(name, np.full(part.points, np.nan)))
    place = np.flatnonzero(sized)
    if not len(place):
        return Screened(_none(part, columns, NONE), 0)
    own = judged_columns(study, {name: (found.values[name][place], found.dimensions[name]) for name in study.asked})
    place = place[_best(own, _cells(study, places[place]))]
    inputs = {path: [values[k] for k in place.tolist()] for path, values in columns.items()}
    results = {name: (found.values[name][place], found.dimensions[name]) for name in study.asked}
    return Screened(block_of_columns(part.design, place + part.number, inputs, results), int(sized.sum()))


def _none(part: Part, columns: Mapping[str, list[object]], why: str) -> Blocks:
    inputs = {path: values[0] for path, values in columns.items()}
    return blocks_of([(part.number, Row(part.design, inputs, {}, why))])  # type: ignore[arg-type]


def _best(own: Judged, cells: Sequence[Ints]) -> Ints:
    """Return which are kept, in their order: the front (of a large one those that stand freest), the best of cells."""
    scale = np.maximum(np.ptp(own.values, axis=0), 1e-300)
    order = np.lexsort(((own.values / scale).sum(axis=1), own.violation))
    best = order[non_dominated(own.values[order], own.violation[order])]
    if len(best) > KEPT:
        best = best[np.argsort(-crowding(own.values[best], np.zeros(len(best), dtype=np.int64)), kind="stable")[:KEPT]]
    for cell in cells:
        _, first = np.unique(cell[order], return_index=True)
        best = np.union1d(best, order[np.sort(first)[:KEPT]])
    return best


def _cells(study: Study, places: Floats) -> list[Ints]:
    """Return the section of every range in which points lie, ends apart, and the number of their values of lists."""
    ranges, listed = list[Ints](), np.zeros(len(places), dtype=np.int64)
    for (path, axis), own in zip(study.axes.items(), places.T, strict=True):
        if is_continuous(axis):
            ranges.append((np.floor(own * SECTIONS) + (own > 0.0)).astype(np.int64))
        else:
            length = axis_length(path, axis)
            listed = listed * length + np.minimum(own * length, length - 1).astype(np.int64)
    return [*ranges, listed]


def _places(study: Study, part: Part) -> Floats:
    """Return the points of a part in the unit cube, shape (points, axes)."""
    assert study.search is not None
    places = _points(len(study.axes), study.search.seed, part)
    ranges = [is_continuous(axis) and axis.distribution != "normal" for axis in study.axes.values()]
    apart = np.clip(APART * (places[1::2] - 0.5) + 0.5, 0.0, 1.0)
    places[1::2] = np.where(ranges, apart, places[1::2])
    return places


def _points(axes: int, seed: int, part: Part) -> Floats:
    """Return some of a scrambled Sobol' sequence, shape (points, axes)."""
    from scipy.stats import qmc

    with heard_after():  # its first numbers are read in C, which swallows what is raised in it
        sequence = qmc.Sobol(axes, rng=np.random.default_rng(seed))
    if part.first:
        sequence.fast_forward(part.first)
    return np.asarray(sequence.random(1 << (part.points - 1).bit_length()))[: part.points]


def _values(path: str, axis: Axis, places: Floats) -> list[object]:
    """Return the values of an axis at some places, with the bits of `value_at`."""
    if axis.values is None and axis.step is None and axis.distribution == "uniform":
        low, high = float(axis.first or 0.0), float(axis.last or 0.0)
        return (low + (high - low) * places).tolist()  # type: ignore[no-any-return]
    return [value_at(path, axis, place) for place in places.tolist()]


def screening(study: Study, designs: Mapping[str, Design]) -> partial[Screened]:
    """Return what screens a part, for processes.

    Args:
        study: With axes, objectives and constraints.
        designs: Name -> design.
    """
    return partial(screened, study, designs)


def starts(study: Study, blocks: Blocks) -> tuple[Floats, Judged]:
    """Return places and judgement of the designs that the first layer kept, in the order of their cases.

    Args:
        study: With axes, objectives and constraints.
        blocks: Of all parts.
    """
    numbers, own = judged(study, blocks)
    order = np.argsort(numbers, kind="stable")
    rows = [{"design": row.design, **row.inputs} for _, row in blocks]
    return freedoms_of(study).places(rows)[order], own.take(order)
