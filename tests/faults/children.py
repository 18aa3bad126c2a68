"""Children: one process for each fault, some at once; one that hangs is ended, and its fault counts as noticed.

A child hangs by the processor time that it takes, so that what else is at work does not look like it.
"""

from __future__ import annotations

import os
import resource
import signal
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from mutators import Fault

PATIENCE = 5.0
"""A child that takes 20 s and this many times its tests' own time of the processor hangs."""
HANGS, ENDS = "it hangs", "it ends the process"


@dataclass
class Trial:
    """One fault and the tests that may notice it."""

    fault: Fault
    tests: Sequence[str]
    seconds: Mapping[str, float] = field(repr=False)
    """Test -> time that it took [s]."""

    @property
    def limit(self) -> float:
        """Processor time after which a child hangs [s]."""
        return 20.0 + PATIENCE * sum(self.seconds[test] for test in self.tests)


def run_all(trials: Sequence[Trial], jobs: int, work: Callable[[Trial], str]) -> Iterator[tuple[Trial, str]]:
    """Yield each trial with what its work found in a child, or that it hangs, as they end.

    Args:
        trials: To be run.
        jobs: Children at once.
        work: Returns one line: which test is red, or nothing.
    """
    waiting, running = list(reversed(trials)), dict[int, tuple[Trial, int]]()
    while waiting or running:
        while waiting and len(running) < jobs:
            trial = waiting.pop()
            answer = os.open(tempfile.gettempdir(), os.O_TMPFILE | os.O_RDWR)
            running[_child(trial, work, answer)] = (trial, answer)
        child, status = os.wait()
        trial, answer = running.pop(child)
        text = os.pread(answer, 4096, 0).decode()
        os.close(answer)
        hangs = os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL)
        # An error of the injector's own ends a child, too, but with an exit status: no test has noticed anything.
        yield trial, HANGS if hangs else text or (ENDS if os.WIFSIGNALED(status) else "")


def _child(trial: Trial, work: Callable[[Trial], str], answer: int) -> int:
    """Begin the work on a trial in a child and return its number."""
    if child := os.fork():
        return child
    seconds = int(trial.limit)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nowhere, stream)
    try:
        os.pwrite(answer, work(trial).encode(), 0)
        os._exit(0)
    finally:
        # Whatever happens, a child does not go on as its parent.
        os._exit(1)
