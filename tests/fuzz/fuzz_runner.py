"""Feeds many files in worker processes: limits time and memory, resumes, shortens what fails and keeps it."""

import json
import multiprocessing
import os
import re
import resource
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from multiprocessing.connection import Connection, wait
from pathlib import Path

from fuzz_files import Case
from fuzz_stages import LONGEST, Finding, fed, made

MEMORY = 2 * 1024**3
"""What a worker may take beyond what it begins with [bytes]."""
GRACE, PATIENCE = 2.0, 900.0
"""Compiled code hears no alarm: after so many times `LONGEST` of its processor time, or after so long a wait on the
clock [s], a worker that gives no sign of life is ended."""
CHUNKS = {"read": 2000, "check": 200, "size": 200, "modes": 100, "simulate": 50, "fly": 25}
"""Files that one worker process takes."""
TRIALS, TRIAL_TIME = 400, 60.0
"""Most files tried to shorten one that fails, and the time for it [s]."""


@dataclass
class Run:
    """One run of a stage: what is asked, and what was found so far."""

    stage: str
    seed: int
    count: int
    folder: Path | None
    finished: set[int] = field(default_factory=set)
    """First numbers of the chunks that are done."""
    outcomes: Counter = field(default_factory=Counter)
    findings: Counter = field(default_factory=Counter)
    """Signature -> number of files."""

    @property
    def file(self) -> Path | None:
        """Where it is kept, so that it can go on."""
        return self.folder / f"{self.stage}-{self.seed}.json" if self.folder else None

    def load(self) -> None:
        """Take up what an earlier run has done."""
        if self.file is not None and self.file.exists():
            kept = json.loads(self.file.read_text(encoding="utf-8"))
            self.finished = set(kept["finished"])
            self.outcomes, self.findings = Counter(kept["outcomes"]), Counter(kept["findings"])

    def keep(self) -> None:
        """Write down what is done."""
        if self.file is not None:
            self.file.parent.mkdir(parents=True, exist_ok=True)
            kept = {"finished": sorted(self.finished), "outcomes": self.outcomes, "findings": self.findings}
            self.file.write_text(json.dumps(kept), encoding="utf-8")

    def told(self) -> str:
        """Return the counts in one line."""
        fed_files = sum(self.outcomes.values())
        parts = ", ".join(f"{count:,} {name}" for name, count in sorted(self.outcomes.items()))
        return f"{self.stage}, seed {self.seed}: {fed_files:,} of {self.count:,} files: {parts}"


@dataclass
class Worker:
    """A process at work on the files from one number up to another."""

    process: multiprocessing.process.BaseProcess
    pipe: Connection
    number: int
    """That it is at."""
    end: int
    chunk: int
    heard: float
    """When it gave a sign of life [s]."""
    used: float = 0.0
    """Processor time that it had taken then [s]."""


def run(asked: Run, workers: int, say: Callable[[str], None]) -> Counter:
    """Feed all files of a run; return the findings by signature.

    Args:
        asked: What to feed; counts and findings are added to it.
        workers: Processes at work at once.
        say: Takes lines of progress.
    """
    context = multiprocessing.get_context("fork")
    size = CHUNKS[asked.stage]
    waiting = [(k, k, min(k + size, asked.count)) for k in range(0, asked.count, size) if k not in asked.finished][::-1]
    active: list[Worker] = []
    began = shown = time.monotonic()
    while waiting or active:
        while waiting and len(active) < workers:
            chunk, number, end = waiting.pop()
            near, far = context.Pipe()
            process = context.Process(target=_work, args=(far, asked, number, end), daemon=True)
            process.start()
            far.close()
            active.append(Worker(process, near, number, end, chunk, time.monotonic()))
        wait([each.pipe for each in active], timeout=1.0)
        for worker in list(active):
            state = _heard(asked, worker, say)
            if state != "busy":
                active.remove(worker)
                worker.process.join()
                worker.pipe.close()
            if state == "dead" and worker.number + 1 < worker.end:
                waiting.append((worker.chunk, worker.number + 1, worker.end))
            elif state != "busy":
                asked.finished.add(worker.chunk)
                asked.keep()
        if time.monotonic() - shown > 10.0:
            shown = time.monotonic()
            say(f"{asked.told()} after {shown - began:.0f} s")
    asked.keep()
    return asked.findings


def _heard(asked: Run, worker: Worker, say: Callable[[str], None]) -> str:
    """Take what a worker has sent; return whether it is busy, done or dead."""
    try:
        while worker.pipe.poll():
            kind, what = worker.pipe.recv()
            worker.heard, worker.used = time.monotonic(), _processor_time(worker.process.pid)
            if kind == "at":
                worker.number = what
            elif kind == "done":
                return "done"
            elif kind == "outcomes":
                asked.outcomes.update(what)
            else:
                _noted(asked, *what, say=say)
    except (EOFError, ConnectionError):
        worker.process.join()
        return _lost(asked, worker, f"died with exit code {worker.process.exitcode}", say)
    worked = _processor_time(worker.process.pid) - worker.used
    if worked > GRACE * LONGEST or time.monotonic() - worker.heard > PATIENCE:
        worker.process.kill()
        return _lost(asked, worker, "ended: it heard no alarm", say)
    return "busy"


def _lost(asked: Run, worker: Worker, how: str, say: Callable[[str], None]) -> str:
    finding = Finding(f"{asked.stage}-worker-{how}-{worker.number}", "workers", how)
    asked.outcomes["finding"] += 1
    _noted(asked, finding, made(asked.stage, asked.seed, worker.number), worker.number, say=say)
    return "dead"


def _noted(asked: Run, finding: Finding, fuzzed: Case, number: int, *, say: Callable[[str], None]) -> None:
    """Count a finding, and keep the file of the first of its kind."""
    asked.findings[finding.signature] += 1
    if asked.findings[finding.signature] > 1:
        return
    last = finding.told.strip().splitlines()[-1]
    say(f"FOUND {finding.signature} ({fuzzed.kind}, number {number} of seed {asked.seed}): {last:.200}")
    if asked.folder is not None:
        folder = asked.folder / finding.area.removesuffix(".py")
        folder.mkdir(parents=True, exist_ok=True)
        name = f"{re.sub(r'[^A-Za-z0-9.]+', '-', finding.signature)[:150]}.{fuzzed.kind}"
        (folder / f"{name}.toml").write_bytes(fuzzed.text.encode())
        head = f"from {fuzzed.base}, number {number} of seed {asked.seed}\n"
        (folder / f"{name}.txt").write_text(head + finding.told, encoding="utf-8", errors="replace")


def _work(pipe: Connection, asked: Run, first: int, end: int) -> None:
    """Feed the files of a chunk, in a process of its own."""
    limit = _address_space() + MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    outcomes: Counter = Counter()
    known, last = set(asked.findings), 0.0
    for number in range(first, end):
        if time.monotonic() - last > 0.2 or asked.stage != "read":
            pipe.send(("outcomes", outcomes))
            pipe.send(("at", number))
            outcomes, last = Counter(), time.monotonic()
        fuzzed = made(asked.stage, asked.seed, number)
        answer = fed(asked.stage, fuzzed)
        outcomes[answer if isinstance(answer, str) else "finding"] += 1
        if isinstance(answer, Finding):
            if answer.signature not in known:
                known.add(answer.signature)
                fuzzed = shortened(asked.stage, fuzzed, answer, lambda at=number: pipe.send(("at", at)))
            pipe.send(("finding", (answer, fuzzed, number)))
    pipe.send(("outcomes", outcomes))
    pipe.send(("done", None))


def _processor_time(process: int | None) -> float:
    """Return the processor time of a process [s]; none where it has gone."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _address_space() -> int:
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    return pages * resource.getpagesize()


def shortened(stage: str, fuzzed: Case, finding: Finding, alive: Callable[[], None]) -> Case:
    """Return the file without the lines that the finding does not need (Zeller's delta debugging).

    Args:
        stage: That it was found in.
        fuzzed: The file.
        finding: What the shorter file must still show.
        alive: Called before each trial.
    """
    if "-Hang-" in finding.signature or "-MemoryError-" in finding.signature:
        return fuzzed
    lines, size = fuzzed.text.split("\n"), max(fuzzed.text.count("\n") // 2, 1)
    trials, began = 0, time.monotonic()
    while size:
        start = 0
        while start < len(lines) and trials < TRIALS and time.monotonic() - began < TRIAL_TIME:
            fewer = lines[:start] + lines[start + size :]
            alive()
            answer = fed(stage, fuzzed._replace(text="\n".join(fewer)))
            trials += 1
            if isinstance(answer, Finding) and answer.signature == finding.signature:
                lines = fewer
            else:
                start += size
        size //= 2
    return fuzzed._replace(text="\n".join(lines))
