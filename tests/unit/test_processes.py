"""Processes that die: what they were at is computed again, once."""

import os
import signal
from functools import partial
from pathlib import Path

import pytest

from gearwright.errors import SolveError
from gearwright.processes import computed


def squared(folder: Path, number: int, *, always: bool = False) -> int:
    """Return a square; of three the process dies, the first time or always."""
    met = folder / "met"
    if number == 3 and (always or not met.exists()):
        met.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return number * number


def test_what_a_dead_process_was_at_is_computed_by_others(tmp_path: Path) -> None:
    found = dict(computed(partial(squared, tmp_path), [1, 2, 3, 4], 1))
    assert found == {1: 1, 2: 4, 3: 9, 4: 16}


def test_a_thing_that_kills_every_process_is_told(tmp_path: Path) -> None:
    with pytest.raises(SolveError, match="workers died"):
        list(computed(partial(squared, tmp_path, always=True), [3], 1))
