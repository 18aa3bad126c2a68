"""What commands compute is computed once: later ones find it in a folder, by the function and what it was given.

The tests of the terminal run each command in many ways that differ in how it prints, not in what it computes.
Remembered are pure functions alone; what was given tells by its pickle whether it is the same. A call that raises is
made again, as is one whose arguments cannot be pickled, as a bar of progress.
"""

from __future__ import annotations

import functools
import hashlib
import importlib
import os
import pickle
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

PURE = (
    "gearwright.dynamics:campbell",
    "gearwright.dynamics.sharing:sharing_study",
    "gearwright.dynamics.vibration:critical_speeds",
    "gearwright.dynamics.vibration:run_up",
    "gearwright.mission:fly",
    "gearwright.render.pages.report:report",
    "gearwright.replays.pulvirenti.claims:claims",
    "gearwright.replays.wang.claims:split_torque_claims",
    "gearwright.reviews:review_of",
    "gearwright.sizing:size",
    "gearwright.study.cases:results_of",
    "gearwright.study.cases:unit_sample",
    "gearwright.validate.case:check",
)
"""Module and name of what takes most of the time of the commands and neither reads, writes nor prints."""


def remember(folder: Path) -> None:
    """Let every module that has one of the pure functions have one that remembers in its place.

    Args:
        folder: Where answers are kept.
    """
    for place in PURE:
        module, name = place.split(":")
        pure = getattr(importlib.import_module(module), name)
        kept = _remembering(pure, folder)
        for loaded in [module for key, module in sys.modules.items() if key.partition(".")[0] == "gearwright"]:
            for known in [key for key, value in vars(loaded).items() if value is pure]:
                setattr(loaded, known, kept)


def _remembering(pure: Callable[..., Any], folder: Path) -> Callable[..., Any]:
    """Return the function as it is, but for a second call with the same arguments."""

    @functools.wraps(pure)
    def kept(*given: Any, **named: Any) -> Any:
        try:
            asked = pickle.dumps((pure.__module__, pure.__qualname__, given, named))
        except (pickle.PicklingError, AttributeError, TypeError):
            return pure(*given, **named)
        place = folder / hashlib.sha256(asked).hexdigest()
        if not place.exists():
            _write(place, pickle.dumps(pure(*given, **named)))
        return pickle.loads(place.read_bytes())

    return kept


def _write(place: Path, answer: bytes) -> None:
    """Write a file that others may look for at the same time."""
    own = place.with_name(f"{place.name}.{os.getpid()}")
    own.write_bytes(answer)
    own.replace(place)
