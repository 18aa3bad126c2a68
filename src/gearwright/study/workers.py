"""Worker processes and Dask clusters that compute cases, and the size of their chunks."""

import gc
import json
import logging
import shlex
import time
from collections import Counter, deque
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache, partial
from ipaddress import ip_address
from itertools import islice
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from multiprocessing.reduction import ForkingPickler
from pathlib import Path
from typing import Any, NamedTuple

from gearwright.base import DesignError, Problem, SolveError, install, refuse
from gearwright.notices import notice, noticed
from gearwright.processes import TRIES, dismiss, hire
from gearwright.spec import Design, Study
from gearwright.study.cases import (
    LEAST,
    LEAST as LEAST_TOGETHER,
    TOGETHER,
    Case,
    evaluate,
    evaluated,
    fly_together,
    goes_together,
)
from gearwright.study.journal import changes_of, made_with
from gearwright.study.tables import Blocks, Row

# ----------------------------------------------------------------------------------------------------------------------
# How many cases make a chunk: long beside a message, short beside patience, and large where cases go together.
# ----------------------------------------------------------------------------------------------------------------------


CHUNK_TIME, TOGETHER_TIME = 0.1, 3.0
"""Processor time that a chunk should take [s]: beside a message of 0.1 ms; and of cases sized together, the more the
quicker each."""
LARGEST, LARGEST_TOGETHER = 256, 8192
"""Cases of a chunk at most [-]."""
LAST = 256
"""Cases of those last chunks that are made smaller, so that all workers end at once [-]."""


@dataclass
class Pace:
    """The size of the next chunk: twice the last one at most, so that a slow study is noticed in time.

    The first have one case, or as many as are sized sooner together, if there are enough for all workers.
    """

    together: bool
    """True where cases are sized together."""
    size: int = 1
    """Cases of the next chunk [-]."""
    least: int = 1
    """Cases of a chunk at least, however long they take: flights that are found together [-]."""

    known: bool = False
    """Whether any chunk was finished."""

    def __post_init__(self) -> None:
        """Begin with the least."""
        self.size = max(self.size, self.least, LEAST_TOGETHER if self.together else 1)

    def note(self, count: int, seconds: float) -> None:
        """Take account of a finished chunk.

        Args:
            count: Its cases.
            seconds: Of processor time that it took.
        """
        self.known = True
        aim, largest = (TOGETHER_TIME, LARGEST_TOGETHER) if self.together else (CHUNK_TIME, LARGEST)
        seconds_per_case = max(seconds / max(count, 1), 1e-6)
        self.size = max(self.least, min(int(aim / seconds_per_case), largest, 2 * self.size))

    def next_of(self, left: int, chunks: int) -> int:
        """Return the cases of the next chunk [-].

        Args:
            left: Cases that are left at most.
            chunks: That are in hand at once.
        """
        return min(self.size, max(LAST if self.known else self.least, left // max(chunks, 1)))


# ----------------------------------------------------------------------------------------------------------------------
# Worker processes that compute cases, and go on when one of them dies.
#
# Every worker has its own pipe and at most two chunks of cases, so that it is known what a dead one was at. A chunk
# whose worker died is done again in smaller ones; a case that kills its worker alone a second time becomes a row with
# the reason.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Compute cases on a Dask cluster: a scheduler and workers on any machines, with nothing on them but gearwright.
#
# The scheduler repeats what a dead worker was at; a chunk that has killed several is split, and a case that does so
# alone becomes a row with the reason. The journal stays with the runner, so that a dead scheduler costs
# what was being computed, nothing else.
# ----------------------------------------------------------------------------------------------------------------------


CHUNK, CHUNK_TOGETHER = 32, 512
"""Cases of one task, long beside the scheduler's 1 ms a task; and of cases that are sized together."""
SHARES = 64
"""Tasks at least into which cases go that are sized together."""
TASKS_AHEAD = 3
"""Tasks in flight for each thread of the cluster, so that none idles."""
PATIENCE = 10.0
"""Time in which a scheduler must answer [s]."""

_NOISY = ("distributed", "tornado", "asyncio")
"""Libraries that log what they lose."""
_NO_PAGES = "--no-dashboard --dashboard-address 127.0.0.1:0"
"""Dask's own pages would be there for all who reach the machine."""
Tls = tuple[Path, Path, Path]
"""Certificate of the authority, certificate, and key, in PEM form."""
GONE = "the scheduler is gone; what is finished is kept: start it again and `gearwright resume` the journal"


def commands(host: str, processes: int, tls: Tls | None = None) -> tuple[str, str, str]:
    """Return the commands that start a scheduler, workers on any machine that reaches it, and a study on them.

    Args:
        host: Name or address of the scheduler's machine.
        processes: Workers to start on one machine.
        tls: Files of authority, certificate and key; left out: none, which only this machine itself allows.

    Raises:
        DesignError: If others could reach the scheduler, and no files are given.
    """
    this_machine = _is_loopback(host)
    if tls is None and not this_machine:
        message = (
            f"whoever reaches a scheduler at {host} runs code on all machines of the cluster; give --tls CA CERT KEY,"
            " or leave --host out and keep to this machine"
        )
        raise DesignError([Problem("--host", message)])
    address = f"{'tcp' if tls is None else 'tls'}://{shlex.quote(host)}:8786"
    quoted = [shlex.quote(str(path)) for path in tls or ()]
    options = zip(("--tls-ca-file", "--tls-cert", "--tls-key"), quoted, strict=False)
    files = "".join(f" {option} {path}" for option, path in options)
    bound = f" --host {host}" if this_machine else ""
    return (
        f"dask scheduler --host {shlex.quote(host)} {_NO_PAGES}{files}",
        f"dask worker {address} --nworkers {processes} --nthreads 1{bound} {_NO_PAGES}{files}",
        f"gearwright study STUDY.toml --journal STUDY.journal --cluster {address}"
        + (f" --tls {' '.join(quoted)}" if quoted else ""),
    )


def _is_loopback(host: str) -> bool:
    """Tell whether nothing but the machine itself reaches a host."""
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


@dataclass(frozen=True)
class Cluster:
    """A Dask cluster; called with study, designs and workers it holds a connection as `local` holds processes."""

    address: str
    """Of its scheduler, such as ``tcp://127.0.0.1:8786`` or ``tls://10.0.0.1:8786``."""
    tls: Tls | None = None
    """Files of authority, certificate and key, for an address that begins with ``tls://``."""

    @contextmanager
    def __call__(self, study: Study, designs: Mapping[str, Design], workers: int) -> Iterator[Compute]:
        """Hold a connection; the cluster has its own number of workers.

        Raises:
            DesignError: If Dask is not installed, files are missing, or no scheduler answers.
        """
        client = _client(self.address, self.tls)
        with _quiet(), client:
            yield lambda cases, count: _Tasks(client, study, designs, cases, count).work()


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep what Dask logs of a lost scheduler, tracebacks among it, from the terminal: the error says it."""
    names = [name for name in logging.root.manager.loggerDict if name.partition(".")[0] in _NOISY]
    loggers = [logging.getLogger(name) for name in names]
    before = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, before, strict=True):
            logger.setLevel(level)


def _client(address: str, tls: Tls | None) -> Any:
    try:
        from distributed import Client
        from distributed.security import Security
    except ImportError:
        message = f"Dask is not here; {install('cluster')}"
        raise DesignError([Problem("--cluster", message)]) from None
    _refuse_files(address, tls)
    names = ("tls_ca_file", "tls_client_cert", "tls_client_key")
    files = dict(zip(names, map(str, tls), strict=True)) if tls else {}
    try:
        security = Security(require_encryption=True, **files) if files else None
        return Client(address, timeout=PATIENCE, security=security)
    except (OSError, ValueError, RuntimeError):
        accepts = ", or it does not accept the files of --tls" if tls else ""
        message = f"no scheduler answers at {address}{accepts}; `gearwright cluster` prints how to start one"
        raise DesignError([Problem("--cluster", message)]) from None


def _refuse_files(address: str, tls: Tls | None) -> None:
    """Raise if address and files do not belong together, or a file is not there."""
    problems = [Problem("--tls", f"there is no file {path}") for path in tls or () if not path.is_file()]
    if address.startswith("tls:") != (tls is not None):
        problems.append(
            Problem("--cluster", f"{address}: an address that begins with tls:// goes with --tls CA CERT KEY")
        )
    refuse(problems)


class _Tasks:
    """The chunks of one run, in flight and to come."""

    def __init__(
        self, client: Any, study: Study, designs: Mapping[str, Design], cases: Iterator[Case], count: int
    ) -> None:
        texts = {name: _text(design) for name, design in designs.items()}
        self.client, self.given, self.cases = client, (dict(made_with()), _text(study), json.dumps(texts)), cases
        many = min(CHUNK_TOGETHER, count // SHARES) if goes_together(study) else CHUNK
        self.chunk = max(CHUNK, many)
        self.again: deque[list[Case]] = deque()
        self.flying: dict[str, list[Case]] = {}

    def work(self) -> Iterator[Finished]:
        """Yield finished cases; wherever the connection is lost, the scheduler is gone."""
        try:
            yield from self._work()
        except OSError:
            raise SolveError(GONE) from None

    def _work(self) -> Iterator[Finished]:
        from distributed import as_completed

        first = [future for future in (self._fly() for _ in range(self._room())) if future is not None]
        landed = as_completed(first)
        for future in landed:
            yield self._landed(future)
            for _ in range(max(1, self._room() - len(self.flying))):
                following = self._fly()
                if following is not None:
                    landed.add(following)
        if self.flying or self.again:
            raise SolveError(GONE)

    def _room(self) -> int:
        threads: Mapping[str, int] = self.client.nthreads()
        return TASKS_AHEAD * max(1, sum(threads.values()))

    def _fly(self) -> Any:
        chunk = self.again.popleft() if self.again else list(islice(self.cases, self.chunk))
        if not chunk:
            return None
        future = self.client.submit(_rows, *self.given, chunk, pure=False)
        self.flying[future.key] = chunk
        return future

    def _landed(self, future: Any) -> Finished:
        from distributed import KilledWorker
        from distributed.client import FutureCancelledError

        chunk = self.flying.pop(future.key)
        try:
            found: Finished = future.result()
        except KilledWorker:
            if len(chunk) > 1:
                step = max(1, len(chunk) // PARTS)
                self.again.extend(chunk[first : first + step] for first in range(0, len(chunk), step))
                return []
            case = chunk[0]
            return [(case.number, Row(case.design, case.inputs, {}, "it killed every worker that tried it"))]
        except FutureCancelledError:
            raise SolveError(GONE) from None
        return found


def _text(record: Study | Design) -> str:
    return record.model_dump_json(by_alias=True, exclude_unset=True)


def _rows(made: Mapping[str, str], study: str, designs: str, chunk: list[Case]) -> Finished:
    """Return the rows of a chunk: the task of a worker, which needs no file."""
    differences = [f"{name} {here} where the study has {asked}" for name, asked, here in changes_of(made, made_with())]
    if differences:
        message = f"a worker has {', '.join(differences)}; install the same on all machines"
        raise DesignError([Problem("--cluster", message)])
    read, known = _read(study, designs)
    return evaluated(read, known, chunk)


@lru_cache(maxsize=1)
def _read(study: str, designs: str) -> tuple[Study, dict[str, Design]]:
    texts = json.loads(designs)
    return Study.model_validate_json(study), {name: Design.model_validate_json(text) for name, text in texts.items()}
