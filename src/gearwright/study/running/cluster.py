"""Compute cases on a Dask cluster: a scheduler and workers on any machines, with nothing on them but gearwright.

The scheduler repeats what a dead worker was at; a chunk that has killed several is split, and a case that does so
alone becomes a row with the reason. The journal stays with the runner, so that a dead scheduler costs
what was being computed, nothing else.
"""

from __future__ import annotations

import json
import logging
import shlex
from collections import deque
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from ipaddress import ip_address
from itertools import islice
from pathlib import Path
from typing import Any

from gearwright.errors import DesignError, Problem, SolveError, install, refuse
from gearwright.spec import Design, Study
from gearwright.study.answers import Row
from gearwright.study.cases import Case, evaluated, goes_together
from gearwright.study.journal.made_with import changes_of, made_with
from gearwright.study.running.workers import PARTS, Compute, Finished

CHUNK, TOGETHER = 32, 512
"""Cases of one task, long beside the scheduler's 1 ms a task; and of cases that are sized together."""
SHARES = 64
"""Tasks at least into which cases go that are sized together."""
AHEAD = 3
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
        many = min(TOGETHER, count // SHARES) if goes_together(study) else CHUNK
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
        return AHEAD * max(1, sum(threads.values()))

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
