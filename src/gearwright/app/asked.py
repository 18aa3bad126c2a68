"""Questions of the workbench page, their answers, and the cache of sized designs."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from gearwright.errors import DesignError, Problem, by_name, refuse
from gearwright.memo import Memo

if TYPE_CHECKING:
    from gearwright.arrays import Floats
    from gearwright.sizing import Sizing


# ----------------------------------------------------------------------------------------------------------------------
# What the page may ask: verb -> module of this folder that has a function of that name. It loads nothing itself.
# ----------------------------------------------------------------------------------------------------------------------


QUICK = {
    "edit": "verbs",
    "flow": "verbs",
    "form": "verbs",
    "influences": "verbs",
    "meaning": "verbs",
    "model": "verbs",
    "schematic": "verbs",
    "size": "verbs",
}
"""What answers at once."""
BESIDE = {"form": "form", "meaning": "form", "influences": "influences"}
"""Those that need no sizing, or take seconds where a standard rates gears -> a process in which no number waits."""
LIMITS = {"form": 60.0, "influences": 900.0}
"""After which an answer of such a process is no longer waited for [s]."""
LONG = {
    "campbell": "motions",
    "close": "trials",
    "export": "verbs",
    "fly": "motions",
    "mission": "motions",
    "modes": "motions",
    "moved": "trials",
    "report": "verbs",
    "resume": "trials",
    "review": "verbs",
    "rows": "trials",
    "runup": "motions",
    "simulate": "motions",
    "study": "trials",
    "variant": "trials",
    "window": "motions",
}
"""Jobs, which tell how far they are, in processes that can be ended."""


# ----------------------------------------------------------------------------------------------------------------------
# What a page asks and what it is told: questions and answers that travel between processes, sizings that are kept.
# ----------------------------------------------------------------------------------------------------------------------


_SIZINGS = Memo[tuple[str, str], "Sizing"](32)
"""The latest sizings, by text and folder."""


@dataclass(frozen=True)
class Question:
    """What a page asks."""

    verb: str
    text: str
    """Of the design."""
    folder: str
    """Where the files that it names are looked for."""
    options: Mapping[str, Any] = field(default_factory=dict)

    def words(self, name: str) -> str:
        """Return an option that is a text.

        Args:
            name: Of the option.

        Raises:
            DesignError: If it is none.
        """
        value = self.options.get(name)
        if not isinstance(value, str):
            raise DesignError([Problem(name, "a text is needed")])
        return value

    def number(self, name: str, usual: float, most: float) -> float:
        """Return an option that is a positive number.

        Args:
            name: Of the option.
            usual: Where it is left out.
            most: Largest that is allowed.

        Raises:
            DesignError: If it is none, or too large.
        """
        value = self.options.get(name, usual)
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0.0 < value <= most:
            raise DesignError([Problem(name, f"a number above 0 and at most {most:g} is needed")])
        return float(value)


class Answer(NamedTuple):
    """What it is told."""

    content: bytes
    kind: str = "application/json"
    status: int = 200


class Progress(NamedTuple):
    """How far a computation is."""

    done: float
    """Part of it, from 0 to 1."""
    words: str = ""
    lasting: bool = False
    """Whether it is to be shown even if another has just been, as nothing follows for a while."""


Tell = Callable[[Progress], None]
"""Takes how far a computation is."""


def as_json(value: object) -> bytes:
    """Return a plain value as JSON.

    Args:
        value: Without numbers that are not finite.
    """
    return json.dumps(value, ensure_ascii=False, allow_nan=False).encode("utf-8", "backslashreplace")


def packed(head: dict[str, Any], columns: Mapping[str, Floats]) -> Answer:
    """Return words and long columns of numbers: length of the words in four bytes, the words as JSON, the columns.

    Args:
        head: Plain; it is told where each column stands.
        columns: Name -> numbers, which travel in single precision, little-endian.
    """
    import numpy as np

    at, places = 0, dict[str, list[int]]()
    for name, values in columns.items():
        places[name] = [at, int(np.size(values))]
        at += int(np.size(values))
    words = as_json({**head, "columns": places})
    words += b" " * (-len(words) % 4)
    data = b"".join(np.ascontiguousarray(values, dtype="<f4").tobytes() for values in columns.values())
    return Answer(len(words).to_bytes(4, "little") + words + data, "application/octet-stream")


def sized(question: Question) -> Sizing:
    """Return the sizing of a text; one that names files is sized anew each time, as those may change.

    Args:
        question: With the text.
    """
    from gearwright.sizing import size
    from gearwright.spec import parse, placed

    key = (question.text, question.folder)
    if (known := _SIZINGS.get(key)) is not None:
        return known
    design = parse(question.text, folder=Path(question.folder))
    try:
        sizing = size(design)
    except DesignError as error:
        raise DesignError(placed(error.problems, question.text)) from None
    return sizing if "file" in question.text else _SIZINGS.keep(key, sizing)


def case_of(question: Question, sizing: Sizing) -> str:
    """Return the load case that is asked for, or the governing one.

    Args:
        question: With its case.
        sizing: Of the design.
    """
    from gearwright.sizing import governing_case

    name = question.options.get("case") or governing_case(sizing)
    if not isinstance(name, str):
        refuse([Problem("case", "a name is needed")])
    by_name(name, sizing.flows, "case")
    return str(name)
