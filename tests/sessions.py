"""Processes that a test starts in sessions of their own, and who of them is left."""

import time
from collections.abc import Callable
from pathlib import Path

PATIENCE = 60.0
"""Time after which what is waited for will not come any more [s]."""


def members(session: int) -> list[int]:
    """Return the processes of a session that still run."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                fields = (entry / "stat").read_text(encoding="utf-8").rpartition(")")[2].split()
            except OSError:
                continue
            if int(fields[3]) == session and fields[0] != "Z":
                found.append(int(entry.name))
    return found


def until(holds: Callable[[], bool], what: str) -> None:
    """Wait until something holds."""
    last = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < last, f"waited in vain for: {what}"
        time.sleep(0.02)
