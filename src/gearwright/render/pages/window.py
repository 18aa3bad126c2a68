"""A dynamic window as one self-contained HTML page: what every speed, torque and force did, beside what is sized."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields

from gearwright.dynamics.motion import Error
from gearwright.dynamics.vibration import DynamicLoad, ShaftLoad
from gearwright.mission.windows import DynamicWindow
from gearwright.render.figures.flights.window import window_figure
from gearwright.render.grid.table import Table, table
from gearwright.render.pages.page import (
    UNSTAMPED,
    Number,
    Page,
    Section,
    Stamp,
    Tone,
    Verdict,
    figure,
    quantity,
    set_page,
)
from gearwright.render.words.flights.window import ranges, window_verdict
from gearwright.render.words.headline import energy_text
from gearwright.sizing import Sizing
from gearwright.units import margin_text, shown, unit, written


@dataclass(frozen=True)
class _Span:
    """What one quantity did, in the units of the screen."""

    quantity: str
    start: float
    minimum: float
    maximum: float
    end: float
    unit: str


def window_page(window: DynamicWindow, sizing: Sizing, *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the page; it makes no request to anywhere, and the same input gives the same bytes.

    Args:
        window: As flown.
        sizing: That flew.
        stamp: Date of the page.
    """
    caption = f"Window {window.name}: speeds, pitch, bands from least to greatest, and its end at every step."
    seen = figure(window_figure(window), "window", caption)
    drawn = Section("What happened", figures=(seen,), tables=(_spans(window),))
    peaks = Section("Peaks beside what is sized for", tables=tuple(_peaks(window)))
    steps = Section("How it was computed", notes=tuple(_steps(window)))
    rules = window.rules
    event = "nothing but the mission" if rules.event == "none" else f"{rules.event} after {rules.event_at:g} s"
    told = f"{window.trace.duration:.4g} s of {rules.phase} from {window.start:.0f} s of the mission; {event}."
    return set_page(
        Page("Dynamic window", f"{window.name}: {sizing.design.name}", told, _verdict(window), tuple(_numbers(window)),
             (drawn, peaks, steps), design=sizing.design, stamp=stamp)
    )  # fmt: skip


def _margins(window: DynamicWindow) -> dict[str, float]:
    """Return part -> the least margin that its peak leaves."""
    meshes = {load.mesh: min(load.bending_margin, load.contact_margin) for load in window.meshes}
    return meshes | {f"{load.shaft} shaft": load.margin for load in window.shafts}


def _verdict(window: DynamicWindow) -> Verdict:
    margins = _margins(window)
    broken = sorted((margin, part) for part, margin in margins.items() if margin < 1.0)
    said = f"{window_verdict(window)}."
    if broken:
        words = f"{len(broken)} of {len(margins)} meshes and shafts break a margin, most of all {broken[0][1]}."
        return Verdict(Tone.BAD, "Fails", f"{words} {said}")
    if window.limit_cycle is not None or (window.rules.event == "sudden-stop" and window.rest is None):
        return Verdict(Tone.OPEN, "Holds, but does not settle", said)
    return Verdict(Tone.GOOD, "Holds", said)


def _numbers(window: DynamicWindow) -> Iterator[Number]:
    margins = _margins(window)
    if margins:
        part = min(margins, key=lambda name: margins[name])
        yield Number(f"least margin: {part}", margin_text(margins[part]), "", margins[part])
    if window.meshes:
        load = max(window.meshes, key=lambda mesh: mesh.peak_over_mean)
        yield Number(f"peak over mean: {load.mesh}", written(load.peak_over_mean, 3), "", load.peak_over_mean)
        force = max(window.meshes, key=lambda mesh: mesh.peak_force)
        yield quantity(f"largest tangential force: {force.mesh}", force.peak_force, "force")
    if window.shafts:
        shaft = max(window.shafts, key=lambda row: row.peak_torque)
        yield quantity(f"largest torque: {shaft.shaft}", shaft.peak_torque, "torque")
    yield quantity("flown", window.trace.duration, "time")


def _spans(window: DynamicWindow) -> Table:
    rows = [
        _Span(
            row.name,
            shown(row.start, row.dimension),
            shown(row.minimum, row.dimension),
            shown(row.maximum, row.dimension),
            shown(row.end, row.dimension),
            unit(row.dimension),
        )
        for row in ranges(window)
    ]
    return table("Start, least, greatest and end", rows, tuple(field.name for field in fields(_Span)))


def _peaks(window: DynamicWindow) -> Iterator[Table]:
    yield table("Meshes", window.meshes, tuple(field.name for field in fields(DynamicLoad)))
    yield table("Shafts", window.shafts, tuple(field.name for field in fields(ShaftLoad)))


def _steps(window: DynamicWindow) -> Iterator[str]:
    trace = window.trace
    yield (
        f"Steps of {trace.step * 1e6:.3g} µs, {trace.method}; {Error(trace.error, trace.rms_error).words()}; energies"
        f" close {energy_text(trace.work.imbalance)}."
    )
    yield from trace.notes
