"""The first layer: points that fill the axes, sized together in columns, of which each part keeps its best alone.

What cannot be sized together is left out and counted: this layer only says where generations begin.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import GearwrightError
from gearwright.optimum.freedoms import freedoms_of
from gearwright.optimum.judging import Judged, judged, judged_columns
from gearwright.sizing import in_lanes
from gearwright.spec import Design, Study, edited, value_at
from gearwright.spec.studies import Axis, Search
from gearwright.study.answers import Blocks, Row, block_of_columns, blocks_of, crowding, non_dominated

LEAST, MOST = 4096, 131_072
"""Points that are sized at once: the more the quicker each, the fewer the less is lost when it is stopped [-]."""
KEPT = 64
"""Of each part, at most [-]."""
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
    columns = _columns(study, part)
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
    place = place[_best(own)]
    inputs = {path: [values[k] for k in place.tolist()] for path, values in columns.items()}
    results = {name: (found.values[name][place], found.dimensions[name]) for name in study.asked}
    return Screened(block_of_columns(part.design, place + part.number, inputs, results), int(sized.sum()))


def _none(part: Part, columns: Mapping[str, list[object]], why: str) -> Blocks:
    inputs = {path: values[0] for path, values in columns.items()}
    return blocks_of([(part.number, Row(part.design, inputs, {}, why))])  # type: ignore[arg-type]


def _best(own: Judged) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """Return the places of what is kept, in their order; of many those that stand freest."""
    scale = np.maximum(np.ptp(own.values, axis=0), 1e-300)
    order = np.lexsort(((own.values / scale).sum(axis=1), own.violation))
    best = order[non_dominated(own.values[order], own.violation[order])]
    if len(best) > KEPT:
        best = best[np.argsort(-crowding(own.values[best], np.zeros(len(best), dtype=np.int64)), kind="stable")[:KEPT]]
    return np.sort(best)


def _columns(study: Study, part: Part) -> dict[str, list[object]]:
    """Return the values of every axis at the points of a part."""
    assert study.search is not None
    places = _points(len(study.axes), study.search.seed, part)
    return {path: _values(path, axis, places[:, k]) for k, (path, axis) in enumerate(study.axes.items())}


def _points(axes: int, seed: int, part: Part) -> Floats:
    """Return some of a scrambled Sobol' sequence, shape (points, axes)."""
    from scipy.stats import qmc

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
