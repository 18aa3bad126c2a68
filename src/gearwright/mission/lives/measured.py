"""Measured duty: a file of time, torque or power, speed and temperature, and the load spectrum that it becomes."""

import csv
import math
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import numpy as np

from gearwright.base import (
    CELSIUS,
    INCH,
    POUND_FORCE,
    RPM,
    SUFFIXES,
    DesignError,
    Floats,
    Problem,
    Shown,
    excerpt,
    near,
    refuse,
    verb,
)
from gearwright.files import text_of
from gearwright.parts.shaft_fatigue import LoadCycle, Residue, rainflow
from gearwright.spec import NAME_RULE, is_name

_UNITS: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "time": SUFFIXES["time"],
        "duration": SUFFIXES["time"],
        "torque": {**SUFFIXES["torque"], "nmm": 1e-3, "lbf_in": POUND_FORCE * INCH},
        "power": SUFFIXES["power"],
        "speed": {**SUFFIXES["speed"], "hz": 2.0 * math.pi, "deg_s": math.pi / 180.0},
        "temperature": {"k": 1.0, "c": 1.0, "f": 5.0 / 9.0},
    }
)
COLUMNS: Mapping[str, tuple[str, float]] = MappingProxyType(
    {f"{kind}_{unit}": (kind, factor) for kind, units in _UNITS.items() for unit, factor in units.items()}
)
"""Name in a file's first line -> what it is, and its unit in SI; of temperatures the zero differs, too."""
ZEROS = {"temperature_c": CELSIUS, "temperature_f": CELSIUS - 32.0 * 5.0 / 9.0}
"""Temperature -> its zero [K]."""
SEPARATORS = (";", "\t")
"""Between cells, where the first line has them; else the comma."""
LARGEST = 50_000_000
"""Largest file that is read [bytes]: about a million rows."""
BEYOND = 1e30
"""What no number of a measurement reaches, in whatever unit."""
MOST_SHOWN = 8
"""Lines that are named of a file with many faults [-]."""
_NEEDED = "its first line names the columns, such as time_s, torque_nm, speed_rpm"
_WIDE = 76
"""Characters of a line of a list in a design file [-]."""


@dataclass(frozen=True, repr=False)
class MeasuredDuty(Shown):
    """A record of one shaft, each row lasting until the next; arrays of shape (n,)."""

    time: Floats
    """Start of each row [s]."""
    duration: Floats
    """Until the next row [s]; the last row only ends the one before."""
    torque: Floats
    """[N m]"""
    speed: Floats
    """[rad/s]"""
    temperature: Floats | None
    """[K]; None where the file has none."""

    @property
    def power(self) -> Floats:
        """[W]"""
        return self.torque * self.speed


@dataclass(frozen=True, repr=False)
class DutySpectrum(Shown):
    """Classes of a measured duty."""

    torque: Floats
    """Of each class, without sign, shape (classes,) [N m]."""
    speed: Floats
    """Mean over its time [rad/s]."""
    share: Floats
    """Part of the time [-]."""
    time: float
    """Of the whole record [s]."""

    @property
    def turns(self) -> Floats:
        """Part of all revolutions that are made in each class [-]; of the time, where nothing turns."""
        turned = self.speed * self.share
        return turned / turned.sum() if turned.any() else self.share

    def text(self, machine: str, name: str = "measured") -> str:
        """Return a load case and its spectrum as a design file has them.

        The case has the mean speed, and its spectrum parts of the revolutions: every class keeps its load cycles.

        Args:
            machine: That gave what was measured.
            name: Of case and spectrum.

        Raises:
            DesignError: A name that a design file cannot have.
        """
        named = {"machine": machine, "name": name}
        refuse((Problem(key, f"{excerpt(word)!r}; {NAME_RULE}") for key, word in named.items() if not is_name(word)))
        machine, case = (word if word.isascii() and " " not in word else f'"{word}"' for word in (machine, name))
        top = float(self.torque.max())
        levels = [f"{value:.6g}" for value in self.torque / top]
        shares = [f"{value:.7g}" for value in _whole(self.turns)]
        speed = float((self.speed * self.share).sum())
        return (
            f'[cases.{case}]\nduration_s = {self.time:.9g}\nspectrum = "{name}"\n'
            f"{machine} = {{torque_nm = {top:.9g}, speed_rpm = {speed / RPM:.9g}}}\n\n"
            f"[spectra.{case}]\n{_listed('load', levels)}{_listed('share', shares)}"
        )


@verb
def read_duty(path: str | Path) -> MeasuredDuty:
    """Return a measured duty.

    Args:
        path: Of a CSV file whose first line names its columns with their units: time_s (ms, min, h), or of load bins
            duration_s; torque_nm (knm, nmm, lbf_ft, lbf_in) or power_kw (w, mw, hp); speed_rpm (rad_s, deg_s, hz); if
            it has them temperature_c (k, f).

    Raises:
        DesignError: Columns that are missing or unknown; with their lines: cells that are no finite numbers, missing
            cells, time that does not rise, torque from power at standstill, temperatures below absolute zero.

    Cells are parted by commas, or by semicolons or tabs where the first line has them; decimals have a point.
    """
    rows = _rows(path)
    header = [cell.strip() for cell in rows[0][1]] if rows else []
    refuse(_header_problems(header) if header else [Problem("", "the file is empty; " + _NEEDED)], str(path))
    if len(rows) < (2 if any(COLUMNS[name][0] == "duration" for name in header) else 3):
        refuse([Problem("", "a duty needs two rows at least, below the names of its columns")], str(path))
    problems, numbers = list[Problem](), list[list[float]]()
    for number, cells in rows[1:]:
        problems += _row_problems(number, cells, header)
        fits = len(cells) == len(header)
        numbers.append([_number(cell) for cell in cells] if fits else [math.nan] * len(header))
    table = np.array(numbers)
    columns = {COLUMNS[name][0]: table[:, k] * COLUMNS[name][1] for k, name in enumerate(header)}
    for name in header:
        if name in ZEROS:
            columns["temperature"] = columns["temperature"] + ZEROS[name]
    if "duration" in columns:
        columns["time"] = np.concatenate([[0.0], np.cumsum(columns["duration"])])
    problems += _order_problems([number for number, _ in rows[1:]], columns)
    refuse(_short(problems), str(path))
    return _duty(columns)


def _rows(path: str | Path) -> list[tuple[int, list[str]]]:
    """Return number and cells of every line that is not empty."""
    lines = text_of(path, largest=LARGEST).splitlines()
    first = next((line for line in lines if line.strip()), "")
    separator = next((mark for mark in SEPARATORS if mark in first), ",")
    read = csv.reader(lines, delimiter=separator)
    try:
        return [(read.line_num, cells) for cells in read if any(map(str.strip, cells))]
    except csv.Error as error:
        raise DesignError([Problem(f"line {read.line_num}", f"this is no CSV: {error}")], str(path)) from None


def _duty(columns: Mapping[str, Floats]) -> MeasuredDuty:
    speed = columns["speed"]
    torque = columns.get("torque")
    if torque is None:
        torque = np.divide(columns["power"], speed, out=np.zeros_like(speed), where=speed != 0.0)
    temperature, rows = columns.get("temperature"), len(columns["time"]) - 1  # the last row only ends the one before
    duration = columns.get("duration", np.diff(columns["time"]))
    return MeasuredDuty(
        columns["time"][:-1], duration, torque[:rows], speed[:rows],
        None if temperature is None else temperature[:rows],
    )  # fmt: skip


@verb
def duty_spectrum(duty: MeasuredDuty, *, classes: int = 20) -> DutySpectrum:
    """Return the load spectrum of a measured duty: classes of equal width of the torque, empty ones left out.

    The torque of a class is its upper end, so that no class counts less than what was measured in it; rows without
    torque are a class of none.

    Args:
        duty: As measured.
        classes: Between nothing and the largest torque [-].

    Source: time at level, classes counted at their upper bound (ISO 6336-6:2019, clause 4: load bins).

    Raises:
        DesignError: Fewer than one class, or nothing that turns under torque.
    """
    problems = [] if classes >= 1 else [Problem("classes", f"{classes}; take 1 or more")]
    load, top = np.abs(duty.torque), float(np.abs(duty.torque).max())
    if not top:
        problems.append(Problem("torque", "nothing was measured but zero; there is no load to rate"))
    refuse(problems, "duty")
    place = np.ceil(load / top * classes - 1e-9).astype(int)
    kept = np.unique(place)
    time = np.array([duty.duration[place == k].sum() for k in kept])
    turning = np.array([(np.abs(duty.speed) * duty.duration)[place == k].sum() for k in kept])
    return DutySpectrum(kept / classes * top, turning / time, time / time.sum(), float(time.sum()))


def torque_cycles(duty: MeasuredDuty, *, residue: Residue = "half-cycles") -> tuple[LoadCycle, ...]:
    """Return the cycles of torque that a shaft lives through in a measured duty, the largest range first [N m].

    Args:
        duty: As measured.
        residue: ``half-cycles`` of what closes no loop, or the record ``repeated`` without end.

    Source: ASTM E1049-85 (2017), clauses 5.4.4 and 5.4.5.
    """
    return rainflow(duty.torque.tolist(), residue=residue)


def _listed(key: str, numbers: Sequence[str]) -> str:
    """Return a list of a design file, in lines that a terminal does not fold."""
    whole = f"{key} = [{', '.join(numbers)}]\n"
    if len(whole) <= _WIDE:
        return whole
    return f"{key} = [\n{textwrap.indent(textwrap.fill(', '.join(numbers), _WIDE), '  ')}\n]\n"


def _whole(shares: Floats) -> list[float]:
    """Return shares of seven digits whose sum is 1."""
    rounded = [round(float(share), 7) for share in shares]
    rounded[int(np.argmax(shares))] = round(rounded[int(np.argmax(shares))] + 1.0 - sum(rounded), 7)
    return rounded


def _header_problems(header: Sequence[str]) -> list[Problem]:
    problems = [
        Problem(excerpt(name) or "a column", f"no such column; {near(name, COLUMNS)}")
        for name in header
        if name not in COLUMNS
    ]
    kinds = [COLUMNS[name][0] for name in header if name in COLUMNS]
    problems += [
        Problem(kind, "is given twice; keep one column") for kind in dict.fromkeys(kinds) if kinds.count(kind) > 1
    ]
    if "time" in kinds and "duration" in kinds:
        problems.append(Problem("duration", "give times of rows or durations of load bins, and not both"))
    for kind in ("time", "speed"):
        if kind not in kinds and not (kind == "time" and "duration" in kinds):
            names = [name for name, (what, _) in COLUMNS.items() if what == kind]
            problems.append(Problem(kind, f"there is no such column; give one of {', '.join(names)}"))
    if ("torque" in kinds) == ("power" in kinds):
        problems.append(Problem("torque", "give one column of torque or power, and not both"))
    return problems


def _number(cell: str) -> float:
    """Return the number of a cell; NaN for none, and for what nothing measures."""
    try:
        number = float(cell)
    except ValueError:
        return math.nan
    return number if cell.isascii() and "_" not in cell and abs(number) < BEYOND else math.nan


def _row_problems(number: int, cells: Sequence[str], header: Sequence[str]) -> Iterator[Problem]:
    if len(cells) != len(header):
        comma = "; decimals have a point, or part the cells by semicolons" if len(cells) > len(header) else ""
        yield Problem(f"line {number}", f"has {len(cells)} cells, and {len(header)} columns are named{comma}")
        return
    for name, cell in zip(header, cells, strict=True):
        if not math.isfinite(_number(cell)):
            fix = "fill the gap, or leave the row out"
            pointed = cell.strip().replace(",", ".")
            if pointed != cell.strip() and math.isfinite(_number(pointed)):
                fix = f"decimals have a point: {pointed}"
            yield Problem(f"line {number}, {name}", f"{excerpt(cell.strip())!r} is no finite number; {fix}")


def _order_problems(lines: Sequence[int], columns: Mapping[str, Floats]) -> Iterator[Problem]:
    time, speed = columns["time"], columns["speed"]
    for k in np.flatnonzero(columns.get("duration", np.ones(1)) <= 0.0).tolist():
        yield Problem(f"line {lines[k]}", "a duration that is not above 0; leave the bin out")
    for k in np.flatnonzero(np.diff(time) <= 0.0).tolist() if "duration" not in columns else ():
        message = f"{time[k + 1]:g} s comes after {time[k]:g} s; time has to rise from row to row"
        yield Problem(f"line {lines[k + 1]}", message)
    if "power" in columns:
        for k in np.flatnonzero((columns["power"] != 0.0) & (speed == 0.0)).tolist():
            yield Problem(f"line {lines[k]}", "power without speed has no torque; measure the torque")
    for k in np.flatnonzero(columns.get("temperature", np.ones(1)) <= 0.0).tolist():
        yield Problem(f"line {lines[k]}", "a temperature below absolute zero; look at its unit")


def _short(problems: Sequence[Problem]) -> list[Problem]:
    """Return the first faults, and how many there are more."""
    if len(problems) <= MOST_SHOWN:
        return list(problems)
    return [*problems[:MOST_SHOWN], Problem("", f"and {len(problems) - MOST_SHOWN} more lines like these")]
