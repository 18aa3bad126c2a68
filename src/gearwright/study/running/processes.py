"""One function of many things, in processes of this machine; what is finished comes at once, in any order."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from typing import TypeVar

from gearwright.errors import SolveError

A = TypeVar("A")
B = TypeVar("B")
Finished = tuple[A, B]
"""A thing and what the function made of it."""


def computed(function: Callable[[A], B], things: Sequence[A], workers: int) -> Iterator[Finished[A, B]]:
    """Yield each thing with what a function makes of it, as soon as it is there.

    Args:
        function: That a process can be sent.
        things: To be computed.
        workers: Processes; 0 computes here.

    Raises:
        SolveError: If a process dies.
    """
    if workers == 0:
        yield from ((thing, function(thing)) for thing in things)
        return
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(min(workers, len(things) or 1), mp_context=context, initializer=_leave_to_the_parent)
    try:
        futures = {pool.submit(function, thing): thing for thing in things}
        for future in as_completed(futures):
            yield futures[future], future.result()
    except BrokenProcessPool:
        said = "a worker died, perhaps for want of memory; fewer workers may do, and what is kept stays"
        raise SolveError(said) from None
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _leave_to_the_parent() -> None:
    """Let Ctrl-C end the parent alone, which then ends its workers."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
