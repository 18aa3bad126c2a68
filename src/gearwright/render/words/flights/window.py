"""A dynamic window in words: what every speed, torque, force and the pitch did in it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from gearwright.dynamics import Trace
from gearwright.dynamics.motion import Error, Statistics
from gearwright.mission.windows import DynamicWindow
from gearwright.render.words.headline import energy_text
from gearwright.units import margin_text, shown, unit


class Range(NamedTuple):
    """What one quantity did in a window, in SI."""

    name: str
    dimension: str
    """Its unit, as `units` knows it."""
    start: float
    """Mean of the first time bin."""
    minimum: float
    """Of every step."""
    maximum: float
    """Of every step."""
    end: float
    """Mean of the last time bin."""


def ranges(window: DynamicWindow) -> tuple[Range, ...]:
    """Return what speeds, torques, pitch and line forces did.

    Args:
        window: As flown.
    """
    return (*_drives(window.trace), *_lines(window.trace))


_DIMENSIONS = {"torque": "torque", "speed": "speed", "slip": "speed", "pitch": "angle"}


def _drives(trace: Trace) -> Iterator[Range]:
    if trace.drive is None:
        return
    for name, owner in zip(trace.labels.drives, trace.labels.drive_owners, strict=True):
        dimension = _DIMENSIONS.get(owner.what)
        if dimension:
            yield _range(trace.drive, name, dimension)


def _lines(trace: Trace) -> Iterator[Range]:
    for name, line_unit in zip(trace.labels.lines, trace.labels.line_units, strict=True):
        if line_unit == "rad":
            yield _range(trace.force, name, "torque")
    for name, line_unit in zip(trace.labels.lines, trace.labels.line_units, strict=True):
        if line_unit == "m":
            yield _range(trace.force, name, "force")


def _range(statistics: Statistics, name: str, dimension: str) -> Range:
    history = statistics.of(name)
    return Range(
        name,
        dimension,
        float(history["mean"][0]),
        float(np.min(history["minimum"])),
        float(np.max(history["maximum"])),
        float(history["mean"][-1]),
    )


def window_text(window: DynamicWindow) -> str:
    """Return what happened in a window as lines of text.

    Args:
        window: As flown.
    """
    trace, rules = window.trace, window.rules
    event = "nothing but the mission" if rules.event == "none" else f"{rules.event} after {rules.event_at:g} s"
    lines = [
        f"{window.name}: {trace.duration:.4g} s of {rules.phase} from {window.start:.0f} s of the mission; {event}",
        "",
        f"{'':28} {'start':>11} {'minimum':>11} {'maximum':>11} {'end':>11}",
        *(_line(row) for row in ranges(window)),
        "",
        *_peaks(window),
        window_verdict(window),
        f"Steps of {trace.step * 1e6:.3g} µs; {Error(trace.error, trace.rms_error).words()}; energies close"
        f" {energy_text(trace.work.imbalance)}",
    ]
    return "\n".join([*lines, *trace.notes[1:]])


def _peaks(window: DynamicWindow) -> Iterator[str]:
    """Yield the peak of every mesh row and shaft beside what it is sized for."""
    yield f"{'peak beside what it is sized for':32} {'peak':>9} {'sized for':>9} {'':3}  margin left"
    for load in window.meshes:
        numbers = f"{shown(load.peak_force, 'force'):9.5g} {shown(load.rated_force, 'force'):9.5g} {unit('force'):3}"
        margins = f"bending {margin_text(load.bending_margin)}, contact {margin_text(load.contact_margin)}"
        yield f"{f'{load.mesh}, tangential':32} {numbers}  {margins}"
    for shaft in window.shafts:
        torques = " ".join(f"{shown(value, 'torque'):9.5g}" for value in (shaft.peak_torque, shaft.rated_torque))
        yield f"{f'{shaft.shaft} shaft':32} {torques} {unit('torque'):3}  yield {margin_text(shaft.margin)}"
    yield ""


def _line(row: Range) -> str:
    numbers = " ".join(f"{shown(value, row.dimension):11.5g}" for value in row[2:])
    return f"{row.name:28} {numbers} {unit(row.dimension)}"


def _stopped(window: DynamicWindow) -> str:
    """Return whether a sudden stop comes to rest."""
    assert window.trace.drive is not None  # every window has drives
    speed = abs(float(window.trace.drive.of("brake speed")["mean"][-1])) * 30.0 / math.pi
    if window.rest is not None:
        after = window.rest - window.rules.event_at
        return f"At rest {after:.3g} s after the event, but for {speed:.2g} rpm that friction needs to hold it"
    return (
        f"Not at rest: what is held still turns at {speed:.4g} rpm; give a longer window, more torque, or lag_s for"
        " machines that fail"
    )


def window_verdict(window: DynamicWindow) -> str:
    """Return whether the governor comes to rest in a window.

    Args:
        window: As flown.
    """
    cycle = window.limit_cycle
    if window.rules.event == "sudden-stop":
        return _stopped(window)
    if cycle is None:
        return "The governor does not limit-cycle"
    return (
        f"The governor limit-cycles at {cycle.frequency:.3g} Hz with {cycle.amplitude:.3g} rad/s"
        f" ({cycle.amplitude * 30.0 / math.pi:.3g} rpm); lower its gain, or give a faster actuator"
    )
