"""Taking: what a run keeps of a block of rows, in translated Python: statistics, samples, crests, contact losses."""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from gearwright.base import Floats, Ints
from gearwright.dynamics.codegen import AFTER, BEFORE
from gearwright.dynamics.codegen.loops import at, call, floats

LEAD = BEFORE + AFTER
"""Rows of the block before that the next one needs."""
RUNAWAY = 1e12
"""Line force at which a run has diverged [N or N m]: no gear comes near it."""
INFINITE = float("inf")
TAKEN, DIVERGED, OUTSIDE = 0, 1, 2
"""How a block was: as it should be, with forces that nothing bears, with a propeller outside its map."""
STRETCH = 5
"""Numbers of a stretch of rows that are kept: next step, its end, stride, rows that were taken, where they go."""


class Taking(NamedTuple):
    """Arrays and sizes that a block is taken into; rows are (q, q̇, line forces, deflections, drives)."""

    steps: int
    width: int
    """Numbers in a row, filled up to whole vectors."""
    size: int
    """Coordinates."""
    lines: int
    past: int
    """Numbers in a row."""
    record: Floats
    """The block; before it stand the last rows of the one before."""
    summary: Floats
    """Of the block, shape (4, width)."""
    part: Floats
    """Of a part of it, shape (4, width)."""
    summarise: int
    """Address of code."""
    crests_code: int
    """Address of code."""
    edges: Ints
    """Steps at which bins begin and end, shape (bins + 1,)."""
    bins: int
    places: Ints
    """Bin in which counting is, in which crests are, and rows of marks that were taken."""
    sums: Floats
    """Sums and sums of squares of the columns after q, shape (2, bins, columns)."""
    minimum: Floats
    """Shape (bins, columns)."""
    maximum: Floats
    """Shape (bins, columns)."""
    stretches: int
    kept: Ints
    """Shape (stretches, STRETCH)."""
    gaps: int
    """Lines with backlash."""
    loose: Ints
    """Columns of their deflections."""
    lost: Ints
    """Step at which each first lost contact, or -1."""
    stride: int
    """Steps between marks."""
    marks: Floats
    """Deflections, shape (marks, gaps)."""
    flags: int
    """Propellers with a map."""
    outside: Ints
    """Columns of their flags."""
    ends: Floats
    """Line forces of the first step that counts, and of the last, shape (2, lines)."""
    first_places: int
    """Places beside the beginning of the run in which crests are looked for."""
    first_rows: int
    """Rows that tell them."""
    first_ways: Floats
    """Weights of these rows at the places, and of all but the last of them, shape (2, places, rows)."""
    last_places: int
    """The same beside its end."""
    last_rows: int
    last_ways: Floats
    end_bound: Floats
    """Greatest absolute value beside the ends, with what it may be off by, shape (lines,)."""
    room: int
    """Lines, filled up to whole vectors."""
    crests: Floats
    """As `blank_crests` makes them, shape (5, room)."""
    high: Floats
    """Crests of each bin, shape (bins, room)."""
    low: Floats
    """Shape (bins, room)."""


def blank(summary: Floats, width: int) -> None:
    """Clear a summary."""
    for j in range(width):
        summary[j] = INFINITE
        summary[width + j] = -INFINITE
        summary[2 * width + j] = 0.0
        summary[3 * width + j] = 0.0


def take(c: Taking, first: int, count: int) -> int:
    """Take the block that stands in the record; say how it was."""
    width, start = c.width, 2 * c.size
    blank(c.summary, width)
    call(c.summarise, count, c.record, c.summary, width)
    for j in range(start, start + 2 * c.lines):
        held = c.summary[width + j] < RUNAWAY and c.summary[j] > -RUNAWAY
        if not (held and c.summary[3 * width + j] < INFINITE):
            return DIVERGED
    for k in range(c.flags):
        if c.summary[width + c.outside[k]] > 0.0:
            return OUTSIDE
    keep(c, first, count)
    count_bins(c, first, count)
    watch(c, first, count)
    look_between(c, first, count)
    forces = at(c.record, start)
    for j in range(c.lines):
        c.ends[c.lines + j] = forces[(count - 1) * width + j]
        if first <= c.edges[0] and c.edges[0] < first + count:
            c.ends[j] = forces[(c.edges[0] - first) * width + j]
    if first == 0 and c.edges[0] == 0:
        look_at_end(c, 0, c.first_places, forces, width, c.first_rows, c.first_ways)
    if first == c.steps:
        look_at_end(c, c.bins - 1, c.last_places, forces, -width, c.last_rows, c.last_ways)
    for j in range(LEAD * width):
        c.record[j - LEAD * width] = c.record[(count - LEAD) * width + j]
    return TAKEN


def keep(c: Taking, first: int, count: int) -> None:
    """Keep the rows that fall on evenly spaced steps."""
    for k in range(c.stretches):
        one = at(c.kept, STRETCH * k)
        table = floats(one[4])
        step, taken = one[0], one[3]
        while step < first:  # a replay begins behind them: their rows are nowhere
            step += one[2]
        while step < one[1] and step < first + count:
            row, kept = at(c.record, (step - first) * c.width), at(table, taken * c.past)
            for j in range(c.past):
                kept[j] = row[j]
            taken += 1
            step += one[2]
        one[0] = step
        one[3] = taken


def count_bins(c: Taking, first: int, count: int) -> None:
    """Add the block to the statistics of its bins."""
    columns, width, place, end = c.past - c.size, c.width, c.places[0], first + count
    while place < c.bins and c.edges[place] < end:
        low, high = max(c.edges[place], first), min(c.edges[place + 1], end)
        if low < high:
            summary = at(c.summary, c.size)
            if high - low < count:
                blank(c.part, width)
                call(c.summarise, high - low, at(c.record, (low - first) * width), c.part, width)
                summary = at(c.part, c.size)
            total, square = at(c.sums, place * columns), at(c.sums, (c.bins + place) * columns)
            least, most = at(c.minimum, place * columns), at(c.maximum, place * columns)
            for j in range(columns):
                total[j] += summary[2 * width + j]
                square[j] += summary[3 * width + j]
                least[j] = min(least[j], summary[j])
                most[j] = max(most[j], summary[width + j])
        if c.edges[place + 1] > end:
            break
        place += 1
    c.places[0] = place


def watch(c: Taking, first: int, count: int) -> None:
    """Note the first contact loss of each line with backlash, and mark where lines are."""
    for k in range(c.gaps):
        if c.lost[k] < 0 and c.summary[c.loose[k]] <= 0.0:
            row = 0
            while c.record[row * c.width + c.loose[k]] > 0.0:
                row += 1
            c.lost[k] = first + row
    if c.gaps:
        for row in range((c.stride - first % c.stride) % c.stride, count, c.stride):
            mark = at(c.marks, c.places[2] * c.gaps)
            for k in range(c.gaps):
                mark[k] = c.record[row * c.width + c.loose[k]]
            c.places[2] += 1


def look_between(c: Taking, first: int, count: int) -> None:
    """Look for crests of line forces between rows, bin by bin."""
    start = max(first - AFTER, BEFORE, c.edges[0])
    stop = min(first + count - AFTER, c.edges[c.bins])
    place, room = c.places[1], c.room
    while start < stop:
        while c.edges[place + 1] <= start:
            place += 1
        end, high, low = min(c.edges[place + 1], stop), at(c.high, place * room), at(c.low, place * room)
        for j in range(room):
            c.crests[j] = high[j]
            c.crests[room + j] = low[j]
        rows = at(c.record, (start - first - BEFORE) * c.width + 2 * c.size)
        call(c.crests_code, end - start, rows, c.crests, c.width, room)
        for j in range(room):
            high[j] = c.crests[j]
            low[j] = c.crests[room + j]
        start = end
    c.places[1] = place


def look_at_end(c: Taking, place: int, places: int, rows: Floats, stride: int, count: int, ways: Floats) -> None:
    """Look for crests in the outermost intervals, the end first: rows on one side are too few for the others' way."""
    high, low = at(c.high, place * c.room), at(c.low, place * c.room)
    for theta in range(places):
        through, less = at(ways, theta * count), at(ways, (places + theta) * count)
        for j in range(c.lines):
            force, other = 0.0, 0.0
            for row in range(count):
                force += through[row] * rows[row * stride + j]
                other += less[row] * rows[row * stride + j]
            high[j] = max(high[j], force)
            low[j] = min(low[j], force)
            c.end_bound[j] = max(c.end_bound[j], abs(force) + abs(other - force))


def promise(c: Taking, bins: int, steps: float, late: float, promised: Floats) -> None:
    """Fill peak, root mean square, what a peak between steps may be above, and what a sum of whole steps is off by.

    The sum over steps counts the first instant whole and the last not at all; each should count half.
    """
    columns, width = c.past - c.size, c.lines
    for j in range(c.lines):
        peak, total = 0.0, 0.0
        for place in range(bins):
            column = place * columns + c.size + j
            low, high = min(c.minimum[column], c.low[place * c.room + j]), c.maximum[column]
            peak = max(peak, abs(low), abs(max(high, c.high[place * c.room + j])))
            total += c.sums[c.bins * columns + column]
        bound = max(c.crests[2 * c.room + j], -c.crests[3 * c.room + j], c.end_bound[j])
        mean, first, last = total / steps, c.ends[j], c.ends[width + j]
        rms = sqrt(max(mean + (last * last - first * first) / (2.0 * steps), 0.0))
        missed = late * max(peak * peak - mean, mean) / max(2.0 * rms, 1e-300)
        promised[j] = peak
        promised[width + j] = rms
        promised[2 * width + j] = max(bound - peak, 0.0)
        promised[3 * width + j] = abs(rms - sqrt(mean)) + missed


FUNCTIONS = (blank, keep, count_bins, watch, look_between, look_at_end, take, promise)
"""To be compiled together."""
