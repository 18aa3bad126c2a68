"""What every key of a design file moves, and some together: designs with changed keys, and results of each by name.

``PYTHONPATH=tests python tests/golden/keys.py`` writes the results in ``keys.json`` anew; with ``--search`` it looks
for the changes first: each key of the schema, wherever a design has its table, with a few values that it may take, in
the first two designs that can be sized so, quickly, and differ from what they were.

A change keeps its mass, its worst margin and the part that has it, up to `NAMED` results that it moves most, and the
total over all parts of every quantity that it moves: masses of all gears, values of all checks of one mode. A total
that it does not have is that of the design without the change.
"""

from __future__ import annotations

import json
import random
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cache
from math import isfinite
from pathlib import Path
from types import UnionType
from typing import Any, Literal, NamedTuple, Union, get_args, get_origin

from record import CLOSING, designs, noise, recorded, same
from told import Group, Moved, written

from gearwright.checks import worst
from gearwright.errors import GearwrightError
from gearwright.sizing import Sizing, size
from gearwright.spec import Design, Record, edited, keys_of

FILE = Path(__file__).with_name("keys.json")
TWICE = 2
"""Designs that show one value of a key."""
TOGETHER = 8
"""Changes of three keys at once in every design."""
LONGEST = 0.1
"""Processor time [s] that a kept change may take."""
NUDGE = 1.13
"""What a number is multiplied by: small enough to be allowed, large enough to change a choice."""
NAMED = 5
"""Results that a change has beside mass and worst margin."""
LARGE = 1.0
"""Size in SI units above which what closes to zero by subtraction is no rounding."""
ZERO = 1e-12
"""Up to where a result is a zero: inertias of small parts are above it."""
ROUNDING = 1e-5
"""What rounding may add up to in a total, over the sum of the sizes of its numbers [-]."""
MOVES = 0.1 * ROUNDING
"""From what difference on, over the same, a change moves a total [-]."""
FIGURES = 8
"""Of a total."""
SHAKEN = 4
"""Of every so many changes one has its critical speeds in the sums: they take as long as all else."""

Change = Mapping[str, Any]
Row = dict[str, Any]


class Total(NamedTuple):
    """All numbers of one quantity."""

    value: float = 0.0
    """Their sum."""
    size: float = 0.0
    """Sum of their sizes."""
    noise: float = 0.0
    """Up to where it is a zero with rounding."""

    def is_near(self, other: float, share: float) -> bool:
        """Tell whether it is another number, but for a share of its size and for rounding."""
        return abs(self.value - other) <= max(share * self.size, self.noise)


def quantity(path: str) -> str:
    """Return the quantity of a number: ``gears.mass``, ``checks.pitting.value``, ``cases.speeds``; an array is its own.

    Args:
        path: As recorded.
    """
    room, *inner = path.split(".")
    if room in ("arrays", "answers"):
        return path
    if room in ("teeth", "cases"):
        return ".".join([room, *inner[1:2]] if room == "cases" else [room])
    if room == "checks":
        return f"{room}.{inner[0]}.{inner[-1]}"
    return f"{room}.{next(name for name in reversed(inner) if not name.isdigit())}"


def totals(values: Mapping[str, float]) -> dict[str, Total]:
    """Return quantity -> all its numbers.

    Args:
        values: Path -> number, as recorded.
    """
    found: dict[str, Total] = {}
    for path, value in values.items():
        one = found.get(quantity(path), Total())
        own = max(noise(path), ZERO)
        found[quantity(path)] = Total(one.value + value, one.size + abs(value), one.noise + own)
    return found


@cache
def usual_totals(name: str) -> dict[str, Total]:
    """Return the totals of a design that is not changed, without critical speeds."""
    return totals(recorded(size(designs()[name]), shaken=False))


def moved_totals(name: str, values: Mapping[str, float]) -> dict[str, float]:
    """Return the totals that a change moves.

    Args:
        name: Of the design.
        values: Path -> number, as recorded of the changed one.
    """
    was, now = usual_totals(name), totals(values)
    return {
        of: float(f"{now.get(of, Total()).value:.{FIGURES}g}")
        for of in sorted(was.keys() | now.keys())
        if not now.get(of, Total()).is_near(was.get(of, Total()).value, MOVES) or (of in now) != (of in was)
    }


def results(sizing: Sizing) -> Group:
    """Return the results that every change has.

    Args:
        sizing: Of a changed design.
    """
    first = worst(sizing.checks)
    part = {} if first is None else {"worst part": str(first.part)}
    margin = {"worst margin": sizing.worst_margin} if isfinite(sizing.worst_margin) else {}
    return {"mass": sizing.mass, **margin, **part}


def by_name(sizing: Sizing, values: Mapping[str, float]) -> dict[str, float]:
    """Return the results that a change may name: as recorded, but checks by part and mode, not by their labels.

    Args:
        sizing: Of a changed design.
        values: What is recorded of it.
    """
    found = {path: value for path, value in values.items() if not path.startswith(("checks.", "answers."))}
    for check in sizing.checks:
        for kind, value in (("value", check.value), ("limit", check.limit)):
            if value is not None and isfinite(value):
                found.setdefault(f"checks.{check.name}.{kind}", float(value))
    return found


@cache
def usual(name: str) -> dict[str, float]:
    """Return the results of a design that is not changed."""
    return by_name(sizing := size(designs()[name]), recorded(sizing, shaken=False))


def most_moved(name: str, values: Mapping[str, float]) -> list[str]:
    """Return names of results that a change moves most beside their size, each of another quantity.

    Those that say little stand last: checks, places in arrays, and what closes to zero by subtraction.

    Args:
        name: Of the design.
        values: Name -> number, of the changed one.
    """
    moves: dict[str, tuple[bool, float]] = {}
    for path, value in values.items():
        was = usual(name).get(path, 0.0)
        closing = any(part in path for part in CLOSING)
        if not same(path, was, value) and (not closing or abs(value) > LARGE):
            last = closing or path.endswith(".order") or path.startswith("checks.")
            moves[path] = last, -round(abs(value - was) / max(abs(value), abs(was)), 6)
    found: dict[str, str] = {}
    for path in sorted(moves, key=lambda path: (moves[path], path)):
        found.setdefault(path.removesuffix(".size").rpartition(".")[2], path)
    return list(found.values())[:NAMED]


def told(row: Row, place: int) -> Row:
    """Return a change with what it moves now; what it names stays named while it is there.

    Args:
        row: Design and change, and what they moved when they were written.
        place: Of the change among all; each `SHAKEN`-th has critical speeds, too.
    """
    sizing = size(edited(designs()[row["design"]], row["change"]))
    values = recorded(sizing, shaken=place % SHAKEN == 0)
    known, named = by_name(sizing, values), list(row.get("moves", ()))
    if not named or not known.keys() >= set(named):
        named = most_moved(row["design"], known)
    return {
        "design": row["design"],
        "change": row["change"],
        "results": results(sizing),
        "moves": {path: known[path] for path in named},
        "totals": moved_totals(row["design"], values),
    }


def compare(moved: Moved, row: Row, place: int) -> None:
    """Note how what a change moves differs from what it moved.

    Args:
        moved: What is found is noted here.
        row: As stored.
        place: Of the change among all.
    """
    title = f"{row['design']}: {', '.join(f'{path} = {json.dumps(value)}' for path, value in row['change'].items())}"
    try:
        sizing = size(edited(designs()[row["design"]], row["change"]))
    except GearwrightError as error:
        moved.removed.append(f"{title}: {str(error).splitlines()[0]}")
        return
    values = recorded(sizing, shaken=place % SHAKEN == 0)
    known = by_name(sizing, values)
    now = {path: known[path] for path in row["moves"] if path in known}
    for kept, group in ((row["results"], results(sizing)), (row["moves"], now)):
        for name in kept | group:
            one = ({name: own[name]} if name in own else {} for own in (kept, group))
            moved.compare(title, *one, zero=ZERO)
    beside, found = usual_totals(row["design"]), totals(values)
    for of in sorted(row["totals"].keys() | found.keys()):
        was, now_all = row["totals"].get(of, beside.get(of, Total()).value), found.get(of, Total())
        if not now_all.is_near(was, ROUNDING):
            moved.changed.append(f"{title} [total of {of}]: {written(was)} -> {written(now_all.value)}")


def _unmoved(row: Row, place: int) -> bool:
    compare(moved := Moved(), row, place)
    return not moved


def changes(design: Design) -> Iterator[tuple[str, Change]]:
    """Yield every change of one key that may be tried: the key, with * for names, and path -> value.

    Args:
        design: What is changed.
    """
    yield from _of_record(design, Design, "", "")


def _of_record(record: Record | None, kind: type[Record], path: str, key: str) -> Iterator[tuple[str, Change]]:
    usual = {meant.field: (name, meant) for name, meant in reversed(list(keys_of(kind).items()))}
    for name, info in kind.model_fields.items():
        if (info.alias or name) not in usual or name in ("schema_version", "name"):
            continue
        written, meant = usual[info.alias or name]
        usually = None if info.is_required() else info.get_default(call_default_factory=True)
        value = getattr(record, name) if record is not None else usually
        at, of = (f"{before}.{written}" if before else written for before in (path, key))
        annotation = _plain(info.annotation)
        if isinstance(annotation, type) and issubclass(annotation, Record):
            yield from _of_record(value, annotation, at, of)
        elif get_origin(annotation) is dict and _is_record(get_args(annotation)[1]):
            for entry, member in (value or {}).items():
                yield from _of_record(member, type(member), f"{at}.{entry}", f"{of}.*")
        else:
            for other in _others(annotation, value, meant):
                yield f"{of}={other if not isinstance(other, float) else 'number'}", {at: other}


def _others(annotation: Any, value: Any, meant: Any) -> Iterator[Any]:
    """Yield values of a key that it does not have."""
    if get_origin(annotation) is Literal:
        yield from (option for option in get_args(annotation) if option != value)
    elif isinstance(value, bool) or annotation is bool:
        yield not value
    elif isinstance(value, int) or annotation is int:
        yield from (value + 1, value + 3) if value is not None else (1, 2, 3)
    elif isinstance(value, float):
        yield from (meant.written(value) * factor for factor in (NUDGE, 1.0 / NUDGE) if value)
        yield from () if value else (0.13, 2.3)
    elif value is None and annotation is not str:
        yield from (0.13, 1.3, 13.0, 130.0)


def _plain(annotation: Any) -> Any:
    while get_origin(annotation) in (Union, UnionType) or hasattr(annotation, "__metadata__"):
        parts = (annotation.__origin__,) if hasattr(annotation, "__metadata__") else get_args(annotation)
        annotation = next(part for part in parts if part is not type(None))
    return annotation


def _is_record(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, Record)


def _mark(design: Design, change: Change) -> dict[str, float] | None:
    start = time.process_time()
    try:
        mark = recorded(size(edited(design, dict(change))))
    except GearwrightError:
        return None
    return mark if time.process_time() - start < LONGEST else None


def searched() -> Iterator[Row]:
    """Yield design and change of every change that shows something."""
    shown: Counter[str] = Counter()
    for name, design in designs().items():
        before, useful = recorded(size(design)), []
        for key, change in changes(design):
            if shown[key] >= TWICE or (mark := _mark(design, change)) is None or mark == before:
                continue
            shown[key] += 1
            useful.append(change)
            yield {"design": name, "change": change}
        rng = random.Random(name)
        for _ in range(TOGETHER if len(useful) >= 3 else 0):
            change = {path: value for one in rng.sample(useful, 3) for path, value in one.items()}
            if _mark(design, change) is not None:
                yield {"design": name, "change": change}


def write(rows: list[Row]) -> None:
    """Write changes with what they move now; what is the same but for rounding stays as it was written.

    Args:
        rows: Design and change of each, with what they moved where that is known.
    """
    kept = (row if "totals" in row and _unmoved(row, place) else told(row, place) for place, row in enumerate(rows))
    lines = ",\n".join(map(_text, kept))
    FILE.write_text(f"[\n{lines}\n]\n", encoding="utf-8")


def _text(row: Row) -> str:
    """Return a row in three lines: design and change, its results, the totals that it moves."""
    head = f'{{"design": {json.dumps(row["design"])}, "change": {json.dumps(row["change"])}'
    results, moves, totals = (
        f'"{name}": {{{", ".join(f"{json.dumps(of)}: {written(value)}" for of, value in row[name].items())}}}'
        for name in ("results", "moves", "totals")
    )
    return f"{head},\n {results}, {moves},\n {totals}}}"


if __name__ == "__main__":
    if "--search" in sys.argv:
        write(list(searched()))
    else:
        write(json.loads(FILE.read_text(encoding="utf-8")))
