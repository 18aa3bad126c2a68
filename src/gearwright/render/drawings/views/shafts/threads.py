"""Threads of lock nuts on a shaft: their lines on the outline (ISO 6410-1) and the table of their data."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.catalogue import thread_chamfer, thread_run_out
from gearwright.render.drawings.sheet.entities import Entity, Layer, Path, millimetres
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.views.shaft_parts import MM, thread_name
from gearwright.render.drawings.views.shaft_view import Axis
from gearwright.sizing.shafts import Thread


def thread_lines(axis: Axis, thread: Thread) -> Iterator[Entity]:
    """Yield the core of a thread as thin lines, and where its full turns end; turns that run out lean.

    Args:
        axis: Of the shaft.
        thread: On it.
    """
    radius, core = MM * thread.nut.thread / 2.0, MM * thread.nut.core / 2.0
    foot, first, last = MM * thread.foot, MM * thread.first, MM * thread.last
    for side in (1.0, -1.0):
        yield Path((axis.at(first, side * core), axis.at(last, side * core)), Layer.THIN)
        if thread.undercut is None:
            yield Path((axis.at(foot, side * radius), axis.at(first, side * core)), Layer.THIN)
    if thread.undercut is None:
        yield Path((axis.at(first, -radius), axis.at(first, radius)), Layer.OUTLINE)


def thread_grid(thread: Thread) -> Grid:
    """Return the data of a thread.

    Args:
        thread: On a shaft.
    """
    nut, (low, high) = thread.nut, thread.turns
    rows = [
        ("Nominal diameter", "d", millimetres(MM * nut.thread)),
        ("Pitch", "P", millimetres(MM * nut.pitch)),
        ("Minor diameter", "d_{3}", f"{MM * nut.core:.3f}"),
        ("Full turns", "", millimetres(MM * (high - low))),
    ]
    if thread.undercut is None:
        rows.append(("Run-out, at most 2.5 P", "x_{1}", millimetres(MM * thread_run_out(nut.pitch))))
    else:
        cut = thread.undercut
        rows += [
            (f"Undercut {cut.designation}", "d_{g}", millimetres(MM * thread.bottom)),
            ("its width, flanks of 30°", "g_{2}", millimetres(MM * cut.width)),
            ("its radius", "r", millimetres(MM * cut.radius)),
        ]
    rows.append(("Chamfer at its start", "", f"{millimetres(MM * thread_chamfer(nut.pitch))} × 45°"))
    return Grid(f"Thread: {thread_name(thread)}", tuple(rows))
