"""Worker processes that compute cases, and go on when one of them dies.

Every worker has its own pipe and at most two chunks of cases, so that it is known what a dead one was at. A chunk whose
worker died is done again in smaller ones; a case that kills its worker alone a second time becomes a row with the
reason.
"""

from __future__ import annotations

import gc
import time
from collections import Counter, deque
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from itertools import islice
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from multiprocessing.reduction import ForkingPickler
from typing import NamedTuple

from gearwright.errors import SolveError
from gearwright.notices import notice, noticed
from gearwright.processes import TRIES, dismiss, hire
from gearwright.spec import Design, Study
from gearwright.study.answers import Blocks, Row
from gearwright.study.cases import LEAST, TOGETHER, Case, evaluate, evaluated, fly_together, goes_together
from gearwright.study.running.pace import LARGEST, Pace

AHEAD = 2
"""Chunks that a worker holds: one at work, one waiting, so that it never idles; of large ones it holds one."""
SMALL = 1 << 13
"""Message that a pipe takes from the runner while its worker is at work, on every system: two processes that send each
other more than it holds would wait for each other for ever [bytes]."""
FAILED_STARTS = 3
"""Workers in a row that may die before they are ready."""

PARTS = 16
"""Into how many smaller chunks one goes whose worker died."""

Chunk = list[Case]
Finished = Blocks | list[tuple[int, Row]]
"""Pairs of number and row."""
Function = Callable[[Study, Design, Case], Row]
"""What computes a case."""
Compute = Callable[[Iterator[Case], int], Iterator[Finished]]
"""What takes cases and their number, and yields finished ones, several at a time, in any order."""


class Given(NamedTuple):
    """What a worker needs to know."""

    study: Study
    """Results that are asked for."""
    designs: Mapping[str, Design]
    """Name -> design."""
    function: Function
    """What computes a case."""

    @property
    def pace(self) -> Pace:
        """How large chunks are."""
        together = self.function is evaluate and goes_together(self.study)
        return Pace(together=together, least=TOGETHER if self.flies else 1)

    @property
    def flies(self) -> bool:
        """Whether flights are found together."""
        return self.function is evaluate and fly_together(self.study)

    def finished(self, chunk: Chunk) -> Finished:
        """Return the numbers and rows of cases.

        Args:
            chunk: The cases.
        """
        if self.function is evaluate:
            return evaluated(self.study, self.designs, chunk)
        return [(case.number, self.function(self.study, self.designs[case.design], case)) for case in chunk]


@contextmanager
def local(
    study: Study, designs: Mapping[str, Design], workers: int, *, function: Function = evaluate
) -> Iterator[Compute]:
    """Hold worker processes of this machine; they start with the first cases and serve until the end.

    Args:
        study: Results that are asked for.
        designs: Name -> design.
        workers: Processes; 0 computes in this one.
        function: What computes a case; it must be importable by name.

    Yields:
        A function of cases and their number, which yields finished ones, several at a time, as they are done. It
        raises `SolveError` if workers die before they are ready.
    """
    crew = _Crew(Given(study, designs, function), workers)
    try:
        yield crew.work if workers else partial(_here, Given(study, designs, function))
    finally:
        crew.dismiss()


def _here(given: Given, cases: Iterator[Case], count: int) -> Iterator[Finished]:
    pace = given.pace
    while chunk := list(islice(cases, pace.size)):
        start = time.process_time()
        size = TOGETHER if given.flies else 1
        size = len(chunk) if pace.together and len(chunk) >= LEAST else size
        for first in range(0, len(chunk), size):
            yield given.finished(chunk[first : first + size])
        pace.note(len(chunk), time.process_time() - start)


def _serve(pipe: Connection, given: Given) -> None:
    """Answer chunks with their rows, and with what is said meanwhile, until the pipe closes: the life of a worker."""
    gc.freeze()  # what is loaded now stays: the collector need not look at it after every few cases
    answer: object = None
    while True:
        try:
            pipe.send(answer)
            chunk: Chunk = pipe.recv()
        except (EOFError, OSError):  # the runner is gone, perhaps with an answer unread or a chunk half sent
            return
        start = time.process_time()
        with noticed(pipe.send):
            rows = given.finished(chunk)
        answer = (rows, time.process_time() - start)


@dataclass(eq=False)
class _Worker:
    """One process, its pipe, and what it has been given."""

    process: BaseProcess
    pipe: Connection
    chunks: deque[Chunk] = field(default_factory=deque)
    ready: bool = False


class _Crew:
    """The workers of one run."""

    def __init__(self, given: Given, workers: int) -> None:
        self.given, self.workers = given, workers
        self.cases: Iterator[Case] = iter(())
        self.again: deque[Chunk] = deque()
        self.deaths: Counter[int] = Counter()
        self.members: list[_Worker] = []
        self.failed_starts = 0
        self.pace, self.left = given.pace, 0

    def work(self, cases: Iterator[Case], count: int) -> Iterator[Finished]:
        """Yield finished cases; of no more workers than cases."""
        self.cases, self.left = cases, count
        for _ in range(len(self.members), min(self.workers, count)):
            self.members.append(self._hire())
        while self._give():
            for pipe in wait([worker.pipe for worker in self.members]):
                worker = next(member for member in self.members if member.pipe is pipe)
                finished = self._take(worker)
                if finished:
                    yield finished

    def _hire(self) -> _Worker:
        return _Worker(*hire(_serve, self.given))

    def _give(self) -> bool:
        """Fill up every ready worker; tell whether anything is left to wait for."""
        for _ in range(AHEAD):
            for worker in self.members:
                if worker.ready and len(worker.chunks) < (AHEAD if self.pace.size <= LARGEST else 1):
                    self._hand(worker)
        return any(worker.chunks for worker in self.members) or self._has_more()

    def _hand(self, worker: _Worker) -> None:
        chunk = self._next()
        if not chunk:
            return
        message = ForkingPickler.dumps(chunk)
        if worker.chunks and len(message) > SMALL:
            self.again.appendleft(chunk)
            return
        worker.chunks.append(chunk)
        try:
            worker.pipe.send_bytes(message)
        except OSError:
            return  # its death is seen at the next wait

    def _next(self) -> Chunk:
        if self.again:
            return self.again.popleft()
        chunk = list(islice(self.cases, self.pace.next_of(self.left, AHEAD * len(self.members))))
        self.left -= len(chunk)
        return chunk

    def _has_more(self) -> bool:
        if not self.again:
            self.again.extend([case] for case in islice(self.cases, 1))
        return bool(self.again)

    def _take(self, worker: _Worker) -> Finished:
        """Return what a worker has finished, or see to its death."""
        try:
            message = worker.pipe.recv()
        except (EOFError, OSError):  # OSError: it died within its answer
            return self._bury(worker)
        if isinstance(message, str):
            notice(message)
            return []
        if message is None:
            worker.ready, self.failed_starts = True, 0
            return []
        rows: Finished = message[0]
        worker.chunks.popleft()
        self.pace.note(len(rows), message[1])
        return rows

    def _bury(self, worker: _Worker) -> Finished:
        """Hire another one; the chunk that the dead one was at is suspect, the one behind it is not."""
        worker.process.join()
        self.members.remove(worker)
        if not worker.ready:
            self.failed_starts += 1
            if self.failed_starts >= FAILED_STARTS:
                raise SolveError(
                    f"{FAILED_STARTS} worker processes died while they started, the last with exit code"
                    f" {worker.process.exitcode}; a script must guard its start with if __name__ == '__main__',"
                    " or use --workers 0"
                )
        self.members.append(self._hire())
        suspect = worker.chunks.popleft() if worker.chunks else []
        self.again.extend(worker.chunks)
        if len(suspect) != 1:
            step = max(1, len(suspect) // PARTS)
            self.again.extend(suspect[first : first + step] for first in range(0, len(suspect), step))
            return []
        case = suspect[0]
        self.deaths[case.number] += 1
        if self.deaths[case.number] < TRIES:
            self.again.append(suspect)
            return []
        reason = f"its worker died {TRIES} times, the last with exit code {worker.process.exitcode}"
        return [(case.number, Row(case.design, case.inputs, {}, reason))]

    def dismiss(self) -> None:
        """End every worker; what they are at is lost, what they have sent is not."""
        for worker in self.members:
            worker.pipe.close()
        dismiss(worker.process for worker in self.members)
