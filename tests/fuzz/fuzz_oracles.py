"""What must hold of every answer: refusals that can be read, and results that are numbers."""

import dataclasses
import math
import typing
from collections.abc import Iterator, Mapping
from enum import Enum
from functools import cache

import numpy as np
from pydantic import BaseModel

from gearwright.errors import DesignError, GearwrightError
from gearwright.sizing import Sizing
from gearwright.units import Quantity

LONGEST_LINE = 2000
"""Most characters of one problem: what a terminal shows and a person reads."""
MOST_LINES = 2000
ENDLESS = (
    ".damage", ".margin", ".bearings[].life", ".bearings[].static_safety", "[].value", ".search.next_mass",
    ".search.next_sized_mass",
)  # fmt: skip
"""Fields that may be infinite: beyond the static limit a tooth lives for no cycle, a bearing without load for ever, and
there may be no second choice of teeth."""
ABSENT = ".runs_on.standing_mass"
"""Mass that may be none: films, and rollers that run on the pin itself, have no inner rings."""


def mute(error: GearwrightError) -> str | None:
    """Return what is wrong with a refusal: no sentence, too long a one, or one that a terminal obeys."""
    text = str(error)
    lines = text.split("\n")
    if isinstance(error, DesignError) and not (error.problems and all(each.message.strip() for each in error.problems)):
        return "says nothing"
    if not text.strip():
        return "says nothing"
    if len(lines) > MOST_LINES or max(map(len, lines)) > LONGEST_LINE:
        return f"message of {len(lines)} lines and {max(map(len, lines))} characters in one of them"
    if any(not each.isprintable() for each in lines):
        return "message with characters that no terminal prints"
    return None


def unsound(value: object, at: str = "", dimension: str = "") -> Iterator[str]:
    """Yield the place of everything in a result that is no number, or is not positive where physics says so."""
    if isinstance(value, bool | str | bytes | Enum | BaseModel | None):  # records are what the user wrote
        return
    if isinstance(value, int | float | np.floating):
        if not math.isfinite(value) and not (value == math.inf and at.endswith(ENDLESS)):
            yield f"{at} is {value}"
        elif dimension == "mass" and not value > 0.0 and not (value == 0.0 and at.endswith(ABSENT)):
            yield f"{at} is not positive"
        elif dimension == "inertia" and value < 0.0:  # a design may say that a shaft has none
            yield f"{at} is negative"
    elif isinstance(value, np.ndarray):
        if value.dtype.kind in "fc" and not np.isfinite(value).all():
            yield f"{at} is not finite"
    elif isinstance(value, Mapping):
        for each in value.values():
            yield from unsound(each, f"{at}[]", dimension)
    elif isinstance(value, list | tuple) and not hasattr(value, "_fields"):
        for each in value:
            yield from unsound(each, f"{at}[]", dimension)
    elif hasattr(value, "_fields"):
        for name, each in zip(value._fields, value, strict=True):
            yield from unsound(each, f"{at}.{name}", "")
    elif dataclasses.is_dataclass(value):
        for name, dimension_of in _fields(type(value)):
            yield from unsound(getattr(value, name), f"{at}.{name}", dimension_of)


@cache
def _fields(kind: type) -> tuple[tuple[str, str], ...]:
    """Return (name, dimension) of the fields of a dataclass, and of the mass that a sizing sums up."""
    hints = typing.get_type_hints(kind, include_extras=True)
    found = [(each.name, _dimension(hints.get(each.name))) for each in dataclasses.fields(kind)]
    found += [("mass", "mass")] if kind is Sizing else []
    return tuple(found)


def _dimension(hint: object) -> str:
    marks = getattr(hint, "__metadata__", ())
    return next((mark.dimension for mark in marks if isinstance(mark, Quantity)), "")
