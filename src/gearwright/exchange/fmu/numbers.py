"""Numbers of a system as constants of C: hexadecimal, so that none is rounded."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model import PROPELLER, Arrays, Entries, Schedules, Series, System
from gearwright.exchange.fmu.ports import MachinePort, Port, body_number, has_factor, inputs_start, kinds_of

WIDTH = 6
"""Numbers in a line of text."""


def numbers_text(
    system: System, machines: Sequence[MachinePort], ports: Sequence[Port], *, start: Floats, step: float
) -> str:
    """Return all that `model.h` reads of a system, but version and token.

    Args:
        system: Bodies, lines, loads, drives.
        machines: Whose torques or speeds are given from outside.
        ports: Its variables.
        start: State at time 0: q, q̇, states of drives.
        step: Of the integration [s].
    """
    arrays, drives = system.arrays, system.arrays.drives
    kinds, names = kinds_of(drives), [port.name for port in ports if port.causality == "input"]
    counts = {
        "COORDINATES": len(arrays.mass),
        "LINE_COUNT": len(arrays.stiffness),
        "TONE_COUNT": len(arrays.tone_rate),
        "MACHINE_COUNT": len(machines),
        "SCHEDULE_COUNT": len(arrays.loads.schedules.dof),
        "GYROSCOPIC_COUNT": len(arrays.gyroscopic.value),
        "CENTRIPETAL_COUNT": len(arrays.centripetal.value),
        "PROFILE_COUNT": len(arrays.profile.time),
        "FACTOR_INPUT": int(has_factor(system)),
        "DRIVE_COUNT": len(kinds),
        "DRIVE_STATES": len(drives.start),
        "DRIVE_INPUT_COUNT": len(drives.inputs.dof),
    }
    lines = [f"#define {name} {count}" for name, count in counts.items()]
    lines += [f"static const double STEP = {_number(step)}; /* {step!r} s */"]
    lines += _system(arrays)
    lines += _doubles("DRIVE", drives.table[2:]) + _doubles("START", start) if kinds else _doubles("START", start)
    lines += _integers("DRIVE_WARNS", [int(kind == PROPELLER) for kind in kinds])
    lines += _schedule("READ", drives.inputs)
    lines += _integers("MACHINE_DOF", [body_number(system, machine) for machine in machines])
    lines += _doubles("INPUT_START", inputs_start(system, machines))
    lines += [f"static const char *const INPUT_NAME[] = {{{', '.join(map(_text, names)) or '0'}}};"]
    return "\n".join(lines) + "\n"


def _system(arrays: Arrays) -> list[str]:
    loads, profile = arrays.loads, arrays.profile
    return [
        *_doubles("MASS", arrays.mass),
        *_doubles("SPEED", arrays.speed),
        *_integers("LINE_START", arrays.line_start),
        *_integers("LINE_DOF", arrays.line_dof),
        *_doubles("LINE_WEIGHT", arrays.line_weight),
        *_doubles("STIFFNESS", arrays.stiffness),
        *_doubles("DAMPING", arrays.damping),
        *_doubles("SLIP", arrays.slip),
        # A line without backlash carries on both sides: its dead zone has no width.
        *_doubles("BACKLASH", arrays.backlash),
        *_doubles("TONE_RATE", arrays.tone_rate),
        *_series("VARIATION", arrays.variation),
        *_series("ERROR", arrays.error),
        *_entries("GYROSCOPIC", arrays.gyroscopic),
        *_entries("CENTRIPETAL", arrays.centripetal),
        *_doubles("LOAD", loads.constant),
        *_doubles("LOAD_DAMPING", loads.damping),
        *_doubles("LOAD_QUADRATIC", loads.quadratic),
        *_integers("SCHEDULE_DOF", loads.schedules.dof),
        *_schedule("SCHEDULE", loads.schedules),
        *_doubles("PROFILE", profile.factor),
        *([] if len(profile.time) == 1 else _doubles("PROFILE_TIME", profile.time)),
        *([] if len(profile.time) == 1 else _doubles("PROFILE_TRAVEL", profile.travel)),
    ]


def _series(name: str, series: Series) -> list[str]:
    return [
        *_integers(f"{name}_START", series.start),
        *_integers(f"{name}_TONE", series.tone),
        *_doubles(f"{name}_COSINE", series.cosine),
        *_doubles(f"{name}_SINE", series.sine),
    ]


def _entries(name: str, entries: Entries) -> list[str]:
    return [
        *_integers(f"{name}_ROW", entries.row),
        *_integers(f"{name}_COLUMN", entries.column),
        *_doubles(name, entries.value),
    ]


def _schedule(name: str, schedules: Schedules) -> list[str]:
    return [
        *_integers(f"{name}_START", schedules.start),
        *_doubles(f"{name}_TIME", schedules.time),
        *_doubles(name, schedules.value),
    ]


def _doubles(name: str, values: Iterable[float] | Floats) -> list[str]:
    return _array("double", name, [_number(float(value)) for value in np.ravel(np.asarray(values))])


def _integers(name: str, values: Iterable[int]) -> list[str]:
    return _array("int", name, [str(int(value)) for value in values])


def _array(kind: str, name: str, values: list[str]) -> list[str]:
    """Return an array; C has none without numbers, so that one stands for them."""
    values = values or ["0"]
    rows = [", ".join(values[first : first + WIDTH]) for first in range(0, len(values), WIDTH)]
    return [f"static const {kind} {name}[{len(values)}] = {{", *(f"    {row}," for row in rows), "};"]


def _number(value: float) -> str:
    if math.isnan(value):
        return "NAN"
    return value.hex() if math.isfinite(value) else "INFINITY" if value > 0.0 else "-INFINITY"


def _text(name: str) -> str:
    """Return a name as a text of C, also of one that a message's format would take for its own."""
    letters = (chr(byte) if 32 <= byte < 127 and chr(byte) not in '"\\%?' else _escaped(byte) for byte in name.encode())
    return f'"{"".join(letters)}"'


def _escaped(byte: int) -> str:
    return "%%" if byte == ord("%") else f"\\{byte:03o}"
