"""Children: one process for each fault, some at once; one that hangs is ended, and its fault counts as noticed."""

from __future__ import annotations

import os
import signal
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from mutators import Fault

PATIENCE = 10.0
"""A child that takes a minute and this many times its tests' own time hangs."""
HANGS = "it hangs"


@dataclass
class Trial:
    """One fault and the tests that may notice it."""

    fault: Fault
    tests: Sequence[str]
    seconds: Mapping[str, float] = field(repr=False)
    """Test -> time that it took [s]."""

    @property
    def limit(self) -> float:
        """When a child hangs [s]."""
        return 60.0 + PATIENCE * sum(self.seconds[test] for test in self.tests)


def run_all(trials: Sequence[Trial], jobs: int, work: Callable[[Trial], str]) -> Iterator[tuple[Trial, str]]:
    """Yield each trial with what its work found in a child, or that it hangs, as they end.

    Args:
        trials: To be run.
        jobs: Children at once.
        work: Returns one line: which test is red, or nothing.
    """
    waiting, running = list(reversed(trials)), dict[int, tuple[Trial, float, int]]()
    while waiting or running:
        while waiting and len(running) < jobs:
            trial = waiting.pop()
            answer = os.open(tempfile.gettempdir(), os.O_TMPFILE | os.O_RDWR)
            running[_child(trial, work, answer)] = (trial, time.monotonic(), answer)
        time.sleep(0.01)
        for child, (trial, start, answer) in list(running.items()):
            hangs = time.monotonic() - start > trial.limit
            if hangs:
                os.kill(child, signal.SIGKILL)
            ended, status = os.waitpid(child, 0 if hangs else os.WNOHANG)
            if ended:
                del running[child]
                text = os.pread(answer, 4096, 0).decode()
                os.close(answer)
                yield trial, HANGS if hangs else text or ("it ends the process" if status else "")


def _child(trial: Trial, work: Callable[[Trial], str], answer: int) -> int:
    """Begin the work on a trial in a child and return its number."""
    if child := os.fork():
        return child
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nowhere, stream)
    os.pwrite(answer, work(trial).encode(), 0)
    os._exit(0)
