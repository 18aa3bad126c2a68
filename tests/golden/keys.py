"""What every key of a design file moves, and some together: designs with changed keys, and a number for each.

``PYTHONPATH=tests python tests/golden/keys.py`` writes the numbers of ``keys.json`` anew; with ``--search`` it looks
for the changes first: each key of the schema, wherever a design has its table, with a few values that it may take, in
the first two designs that can be sized so, quickly, and differ from what they were.
"""

from __future__ import annotations

import json
import random
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import UnionType
from typing import Any, Literal, Union, get_args, get_origin
from zlib import crc32

import numpy as np
from record import designs, recorded

from gearwright.errors import GearwrightError
from gearwright.sizing import size
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

SHAKEN = 4
"""Of every so many changes one has its critical speeds in the number: they take as long as all else."""

Change = Mapping[str, Any]


def fingerprint(design: Design, place: int = 0) -> float:
    """Return one number that every number of a sizing and of its assembled system moves.

    asinh weighs small and large numbers alike and takes a zero with rounding for zero.

    Args:
        design: What is sized.
        place: Of the change among all; each `SHAKEN`-th has critical speeds, too.
    """
    values = recorded(size(design), shaken=place % SHAKEN == 0)
    weights = np.cos([crc32(path.encode()) for path in values])
    return float(weights @ np.arcsinh(list(values.values())))


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


def _mark(design: Design, change: Change) -> float | None:
    start = time.process_time()
    try:
        mark = fingerprint(edited(design, dict(change)))
    except GearwrightError:
        return None
    return mark if time.process_time() - start < LONGEST else None


def searched() -> Iterator[dict[str, Any]]:
    """Yield design, change and number of every change that shows something."""
    shown: Counter[str] = Counter()
    for name, design in designs().items():
        usual, useful = fingerprint(design), []
        for key, change in changes(design):
            if shown[key] >= TWICE or (mark := _mark(design, change)) is None or mark == usual:
                continue
            shown[key] += 1
            useful.append(change)
            yield {"design": name, "change": change, "number": mark}
        rng = random.Random(name)
        for _ in range(TOGETHER if len(useful) >= 3 else 0):
            change = {path: value for one in rng.sample(useful, 3) for path, value in one.items()}
            if (mark := _mark(design, change)) is not None:
                yield {"design": name, "change": change, "number": mark}


def numbered() -> Iterator[dict[str, Any]]:
    """Yield the stored changes with the numbers that they have now."""
    known = designs()
    for place, row in enumerate(json.loads(FILE.read_text(encoding="utf-8"))):
        yield row | {"number": fingerprint(edited(known[row["design"]], row["change"]), place)}


if __name__ == "__main__":
    if "--search" in sys.argv:
        FILE.write_text(json.dumps(list(searched())), encoding="utf-8")
    lines = ",\n".join(map(json.dumps, numbered()))
    FILE.write_text(f"[\n{lines}\n]\n", encoding="utf-8")
