"""Freedoms and bounds as a user writes them on the command line."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from gearwright.errors import DesignError, Problem, refuse

if TYPE_CHECKING:
    from gearwright.spec.studies import Axis, Bound, Value


def axis_of(text: str) -> tuple[str, Axis]:
    """Return path and axis of a text such as ``motors.electric.speed_rpm=4000..6000`` or ``gears.material=a,b``.

    Args:
        text: As a user wrote it.

    Raises:
        DesignError: If it is neither a range nor a list.

    >>> axis_of("planetaries.first.planets=3,4,5")[1].values
    [3, 4, 5]
    """
    from gearwright.spec.studies import Axis

    path, equals, written = (part.strip() for part in text.partition("="))
    low, dots, high = written.partition("..")
    if not path or not equals or not written:
        raise DesignError([Problem("--free", f"{text!r} is no freedom; write PATH=FROM..TO, or PATH=VALUE,VALUE")])
    if not dots:
        return path, Axis.model_validate({"values": [_value(part) for part in written.split(",")]})
    ends = [_value(low), _value(high)]
    refuse(
        Problem("--free", f"{path}: {end!r} is no number; a range is FROM..TO, such as 4000..6000")
        for end in ends
        if not isinstance(end, int | float) or not math.isfinite(end)
    )
    return path, Axis.model_validate({"from": ends[0], "to": ends[1]})


def _value(text: str) -> Value:
    """Return a number or a word."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return text.strip()


def bound_of(text: str) -> tuple[str, Bound]:
    """Return result and bound of a text such as ``envelope.length<=400``, in the unit of the tables.

    Args:
        text: As a user wrote it.

    Raises:
        DesignError: If it is none.

    >>> bound_of("envelope.length<=400")
    ('envelope.length', Bound(minimum=None, maximum=400.0))
    """
    from gearwright.spec.studies import Bound

    found = re.fullmatch(r"\s*([\w.\-]+)\s*(<=|>=)\s*([-+0-9.eE]+)\s*", text)
    limit = _value(found[3]) if found else ""
    if found is None or not isinstance(limit, int | float):
        raise DesignError([Problem("--keep", f"{text!r} is no bound; write RESULT>=NUMBER or RESULT<=NUMBER")])
    side = "minimum" if found[2] == ">=" else "maximum"
    return found[1], Bound.model_validate({side: limit})
