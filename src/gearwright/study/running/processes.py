"""One function of many things, in processes of this machine; what is finished comes at once, in any order."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from typing import TypeVar

from gearwright.errors import SolveError

A = TypeVar("A")
B = TypeVar("B")
Finished = tuple[A, B]
"""A thing and what the function made of it."""
TRIES = 2
"""Times that all that is left is begun: a process may die by no fault of its own."""


def computed(function: Callable[[A], B], things: Sequence[A], workers: int) -> Iterator[Finished[A, B]]:
    """Yield each thing with what a function makes of it, as soon as it is there.

    What a process was at that died is computed again by others, once.

    Args:
        function: That a process can be sent.
        things: To be computed.
        workers: Processes; 0 computes here.

    Raises:
        SolveError: If a process dies again.
    """
    if workers == 0:
        yield from ((thing, function(thing)) for thing in things)
        return
    left = dict(enumerate(things))
    for tries in range(TRIES, 0, -1):
        try:
            for number, found in _by_processes(function, left, workers):
                yield left.pop(number), found
            return
        except BrokenProcessPool:
            if tries == 1:
                said = "workers died, perhaps for want of memory; fewer workers may do, and what is kept stays"
                raise SolveError(said) from None


def _by_processes(function: Callable[[A], B], things: Mapping[int, A], workers: int) -> Iterator[tuple[int, B]]:
    """Yield number and answer of each thing."""
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(min(workers, len(things) or 1), mp_context=context, initializer=_leave_to_the_parent)
    try:
        futures = {pool.submit(function, thing): number for number, thing in things.items()}
        for future in as_completed(futures):
            yield futures[future], future.result()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _leave_to_the_parent() -> None:
    """Let Ctrl-C end the parent alone, which then ends its workers."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
