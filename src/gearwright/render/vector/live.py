"""What a page needs to draw a figure anew where a reader points and zooms: panels as plain records, numbers as arrays.

Each array is kept once, in whole steps of a 16 383rd of its range, with what lies between two pixels left out as in
the still figure, but on a grid twice as fine.
"""

import base64
import json
import math
import struct
import zlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gearwright.base import Floats
from gearwright.render.vector import figure as m
from gearwright.render.vector.figure import NAMES, Axes, Axis, Figure, Parallel, Slot, css_value
from gearwright.render.vector.layout import Frame, key_rows, laid_out, scales_of, words_overhang
from gearwright.render.vector.svg import COLUMN, extremes

LEAST = 8
"""Points of a curve that is worth a pointer."""
STEPS, GAP = 16383, 16384
"""Steps of an array's range, and what stands where it has no number."""
NARROWEST = 1e-8
"""Length of a live axis over its larger end, at least [-]."""
PIXELS = 96.0 / 25.4
"""Of a page in one mm."""
WIDER = 1.2
"""Letters on a page over those of a still figure."""
FINER = 0.5
"""Columns of live curves over those of still ones."""

Record = dict[str, Any]


@dataclass
class Numbers:
    """The arrays of a page."""

    ranges: list[tuple[float, ...]] = field(default_factory=list)
    """How many, least, greatest; and a 1 where these are powers of ten."""
    chunks: list[bytes] = field(default_factory=list)
    known: dict[bytes, int] = field(default_factory=dict)

    def add(self, values: Floats, *, log: bool = False) -> int:
        """Keep an array and return its place.

        Args:
            values: Not a number parts a curve.
            log: In steps of their logarithm; what is not positive is no number.
        """
        if log:
            values = np.log10(np.where(values > 0.0, values, np.nan))
        fine = np.isfinite(values)
        low, high = (float(np.min(values[fine])), float(np.max(values[fine]))) if fine.any() else (0.0, 1.0)
        steps = np.full(len(values), GAP, dtype=np.uint16)
        span = high - low or 1.0
        steps[fine] = np.round((values[fine] - low) / span * STEPS).astype(np.uint16)
        key = steps.tobytes() + repr((low, high, log)).encode()
        if key not in self.known:
            self.known[key] = len(self.ranges)
            self.ranges.append((len(values), *_short((low, low + span), 9), *([1] if log else [])))
            self.chunks.append(np.diff(steps, prepend=np.uint16(0)).astype("<u2").tobytes())
        return self.known[key]

    def packed(self, figures: Mapping[str, list[Record]], scripts: Sequence[str]) -> str:
        """Return figures, scripts and all steps, deflated, in base 85: length of what is JSON, JSON, steps.

        Args:
            figures: Name -> its panels.
            scripts: That draw them.
        """
        given = {"ranges": self.ranges, "figures": figures, "scripts": scripts}
        head = json.dumps(given, ensure_ascii=False, separators=(",", ":")).encode()
        # Each step less the one before, all low bytes before all high ones.
        steps = np.frombuffer(b"".join(self.chunks), dtype=np.uint8).reshape(-1, 2)
        whole = struct.pack("<I", len(head)) + head + np.ascontiguousarray(steps.T).tobytes()
        return base64.b85encode(zlib.compress(whole, 9)).decode("ascii")


def live_panels(figure: Figure, numbers: Numbers) -> list[Record]:
    """Return the panels of a figure as records; none where there is no curve to follow.

    Args:
        figure: As drawn.
        numbers: Where its arrays are kept.
    """
    if figure.parallel is not None:
        return [_parallel(figure.parallel, numbers)]
    panels = [slot.axes for slot in figure.slots if not slot.axes.off]
    marks = [mark for axes in panels for mark in _all_marks(axes)]
    followed = any(isinstance(mark, m.Curve) and _is_series(mark) and len(mark.x) >= LEAST for mark in marks)
    kept_still = figure.bare or any(isinstance(mark, m.Picture | m.Shape) for mark in marks)
    if not followed or kept_still or any(axes.aspect or not _all_wide(axes) for axes in panels):
        return []
    frames = laid_out(figure)
    return [
        {**_place(slot, frame), **_panel(slot.axes, frame, numbers)}
        for slot, frame in zip(figure.slots, frames, strict=True)
        if slot.axes.marks
    ]


def _parallel(lines: Parallel, numbers: Numbers) -> Record:
    """Return parallel axes: their names, an array of each with all cases, which are drawn and which stand out."""
    arrays = [numbers.add(column) for column in lines.values.T]
    return {"k": "parallel", "n": list(lines.names), "v": arrays, "i": list(lines.drawn), "e": list(lines.chosen)}


def _place(slot: Slot, frame: Frame) -> Record:
    """Return column and height of a panel, and the room of words above and to the right of it [px]."""
    _, _, right, above = words_overhang(slot.axes, frame)
    around = [round(WIDER * above * PIXELS), round(WIDER * right * PIXELS)]
    height = round((frame[3] - frame[1]) * PIXELS)
    return {"c": slot.column, "h": height, "o": around, **({"off": 1} if slot.axes.off else {})}


def _all_marks(axes: Axes) -> list[m.Mark]:
    return [*axes.marks, *(axes.twin.marks if axes.twin is not None else ())]


def _all_wide(axes: Axes) -> bool:
    """Tell whether every axis has ends that doubles tell apart well: what lies between is rounding else."""
    sides = [axes.x, axes.y, *([axes.twin.y] if axes.twin is not None else [])]
    return all(
        abs(high - low) > NARROWEST * max(abs(low), abs(high)) for low, high in (side.limits() for side in sides)
    )


def _is_series(curve: m.Curve) -> bool:
    """Tell whether a pointer can follow a curve: it runs to the right."""
    fine = curve.x[np.isfinite(curve.x)]
    return len(fine) == len(curve.x) > 1 and bool(np.all(np.diff(fine) >= 0.0)) and fine[-1] > fine[0]


def _panel(axes: Axes, frame: Frame, numbers: Numbers) -> Record:
    twin = axes.twin
    layers = [(mark, 0) for mark in axes.marks] + [(mark, 1) for mark in (twin.marks if twin else ())]
    record: Record = {"t": axes.title, "x": _axis(axes.x), "y": _axis(axes.y), "m": []}
    if twin is not None:
        record["z"] = _axis(twin.y)
    named = {id(row) for row in key_rows(axes)} if axes.key or any(mark.label for mark in axes.marks) else set()
    for mark, side in sorted(layers, key=lambda layer: layer[0].layer):
        scale = scales_of(axes, frame)[0]
        record["m"] += [
            {**part, **({"z": 1} if side else {}), **({"n": mark.label} if id(mark) in named else {})}
            for part in _mark(mark, scale.places, numbers, (axes.x, (twin or axes).y if side else axes.y))
        ]
    return record


def _axis(axis: Axis) -> Record:
    low, high = axis.limits()
    finer = math.ceil(math.log10(max(abs(low), abs(high)) / abs(high - low)))  # ends of 0.99999 and 1.00001 are two
    record: Record = {"l": axis.label, "a": _short((low, high), 6 + max(finer, 0))}
    if axis.log:
        record["g"] = 1
    if not axis.numbers:
        record["q"] = 1
    if axis.values is not None:
        record["v"], record["w"] = axis.values, axis.names or [f"{value:.6g}" for value in axis.values]
    return record


def _near(values: Floats, axis: Axis) -> Floats:
    """Return values that leave the axis by no more than its own length."""
    low, high = sorted(axis.limits())
    ends = (low * low / high, high * high / low) if axis.log else (2.0 * low - high, 2.0 * high - low)
    near: Floats = np.clip(values, *ends)
    return near


def _mark(mark: m.Mark, places: Any, numbers: Numbers, sides: tuple[Axis, Axis]) -> Iterable[Record]:
    if isinstance(mark, m.Curve):
        yield from _curve(mark, places, numbers, sides)
    elif isinstance(mark, m.Fill):
        keep = _kept(places(mark.x), mark.low, mark.high)
        arrays = {
            name: numbers.add(getattr(mark, part)[keep]) for name, part in (("x", "x"), ("y", "low"), ("u", "high"))
        }
        yield {"k": "fill", **arrays, "f": _colour(mark.colour), **_alpha(mark.alpha)}
    elif isinstance(mark, m.Box) and (mark.label or (mark.width and mark.height)) and np.isfinite(mark.box).all():
        yield {"k": "box", "b": _short(mark.box), "f": _colour(mark.fill), **_alpha(mark.alpha)}
    elif isinstance(mark, m.Rule):
        span = _short((mark.low, mark.high))
        yield {"k": "rule", "o": mark.axis, "b": span, **_pen(mark.pen)}
    elif isinstance(mark, m.Dots) and len(mark.x):
        radius = np.sqrt(mark.area / np.pi)
        yield {"k": "dots", "x": numbers.add(mark.x), "y": numbers.add(mark.y), "s": _short(radius),
               "f": [_colour(face) for face in dict.fromkeys(mark.faces)], "i": _places_of(mark.faces),
               "e": _colour(mark.edge), **_alpha(mark.alpha)}  # fmt: skip
    elif isinstance(mark, m.TextMark) and np.isfinite([mark.x, mark.y]).all():
        leader = {} if mark.leader is None else {"d": _short(mark.leader), "e": _colour(mark.leader_colour)}
        yield {"k": "word", **leader, "s": mark.text, "b": [*_short((mark.x, mark.y)), *_short(mark.shift)],
               "o": [frame[0] for frame in mark.frames], "j": [mark.across, mark.up, mark.turned, mark.size],
               "f": _colour(mark.colour)}  # fmt: skip


def _places_of(faces: Sequence[str]) -> list[int]:
    order = list(dict.fromkeys(faces))
    return [] if len(order) == 1 else [order.index(face) for face in faces]


def _curve(mark: m.Curve, places: Any, numbers: Numbers, sides: tuple[Axis, Axis]) -> Iterable[Record]:
    if not len(mark.x):
        if mark.label:  # a sample for the legend alone
            yield {"k": "key", **_pen(mark.pen), **_marker(mark)}
        return
    kind = "line" if _is_series(mark) else "path"
    keep = _kept(places(mark.x), mark.y) if kind == "line" else slice(None)
    yield {
        "k": kind, "x": numbers.add(mark.x[keep], log=sides[0].log),
        "y": numbers.add(_near(mark.y[keep], sides[1]), log=sides[1].log),
        **_pen(mark.pen), **_marker(mark), **({"i": mark.name} if mark.name else {}),
    }  # fmt: skip


def _marker(mark: m.Curve) -> Record:
    if not mark.marker:
        return {}
    edge = {"e": _colour(mark.edge)} if mark.edge else {}
    return {"p": mark.marker, "r": round(mark.size / 2.0, 2), "f": _colour(mark.face), **edge}


def _kept(across: Floats, *rows: Floats) -> np.ndarray:
    """Return which points differ where a column is a quarter of a still figure's."""
    stretched = across * (1.0 / FINER)
    kept: set[int] = set()
    for values in rows:
        fine = np.flatnonzero(np.isfinite(values))
        points = np.stack([stretched[fine], values[fine], fine.astype(float)], axis=1)
        if len(fine) <= 2 * int(np.ptp(points[:, 0]) / COLUMN + 1.0) if len(fine) else True:
            kept.update(range(len(across)))
            continue
        kept.update(extremes(points)[:, 2].astype(int).tolist())
        kept.update(np.flatnonzero(~np.isfinite(values)).tolist())
    return np.array(sorted(kept), dtype=int)


def _pen(pen: m.Pen) -> Mapping[str, Any]:
    dash = {} if pen.dash == "-" else {"d": pen.dash}
    return {"s": _colour(pen.colour), "w": round(pen.width, 2), **dash, **_alpha(pen.alpha)}


def _alpha(alpha: float) -> Record:
    return {} if alpha >= 1.0 else {"a": round(alpha, 3)}


def _short(values: Iterable[float], digits: int = 6) -> list[float]:
    """Return numbers with a few digits, whole ones as integers."""
    short = [float(f"{value:.{digits}g}") for value in values]
    return [int(value) if value.is_integer() and abs(value) < 1e15 else value for value in short]


def _colour(colour: str) -> str:
    """Return the name of a colour that a page changes, or what it is."""
    known = css_value(colour) if colour else None
    return NAMES.get(colour, colour if known is None else known[1])
