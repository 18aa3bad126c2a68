"""Functions of `cmath` for numbers and for lanes of them, each lane by the function itself."""

from __future__ import annotations

import cmath
from typing import Any

from gearwright.lanes.functions import in_lanes


def __getattr__(name: str) -> Any:
    value = getattr(cmath, name)
    found = in_lanes(value) if callable(value) else value
    globals()[name] = found
    return found
