"""Worker processes of the workbench: questions in order, and long jobs with progress and cancellation."""

import asyncio
import os
import time
from collections import OrderedDict
from collections.abc import AsyncIterator, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import count
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from secrets import token_urlsafe
from threading import Lock
from typing import Any

from gearwright.app.questions import Answer, Progress, Question, Tell, answered
from gearwright.notices import noticed
from gearwright.processes import dismiss, hire

# ----------------------------------------------------------------------------------------------------------------------
# A process that answers questions: nothing that is computed holds up the page, and anything can be stopped.
# ----------------------------------------------------------------------------------------------------------------------


MEMORY = 16 * 2**30
"""Address space that a worker may take, where the system can hold it to that [bytes]."""

MANNERS = 5
"""By how much what takes long gives way to what answers a keystroke, as `nice` counts [-]."""


NEEDED = ("gearwright.sizing", "gearwright.render.answers.design", "gearwright.render.schematic")
"""Modules that every worker needs: where the system can fork, they are loaded once for all of them."""


class Stopped(Exception):
    """The process that was asked is no longer there."""


class Worker:
    """One process; it is started when it is first needed, and again after it was stopped."""

    def __init__(self, *, heirs: bool = False) -> None:
        self._process: BaseProcess | None = None
        self._line: Connection | None = None
        self._lock = Lock()
        self._heirs = heirs
        """Whether it may start processes of its own."""
        self._asked: Question | None = None

    def start(self) -> Connection:
        """Return the line to a process that runs."""
        with self._lock:
            if self._process is None or self._line is None or not self._process.is_alive():
                self._process, self._line = hire(_work, self._heirs, needed=NEEDED, heirs=self._heirs)
            return self._line

    def ask(self, question: Question, seconds: float | None, tell: Tell = lambda _: None) -> Answer:
        """Return the answer to a question.

        Args:
            question: Of a page.
            seconds: After which the process is stopped [s]; None: it may take as long as it takes.
            tell: Takes how far it is.

        Raises:
            Stopped: If it was stopped meanwhile, or had no answer in time.
        """
        line = self.start()
        with self._lock:
            self._asked = question
        try:
            line.send(question)
            while line.poll(seconds):
                told = line.recv()
                if not isinstance(told, Progress):
                    answer: Answer = told
                    return answer
                tell(told)
        except (EOFError, OSError):
            raise Stopped("this computation was stopped") from None
        finally:
            with self._lock:
                self._asked = None
        self.stop()
        raise Stopped(f"this takes longer than {seconds:.0f} s and was stopped; the command line has no such limit")

    def stop(self, question: Question | None = None) -> None:
        """End the process, whatever it does.

        Args:
            question: It is ended only if this is what it is asked; left out: in any case.
        """
        dismiss(self._let_go(question))

    def _let_go(self, question: Question | None = None) -> list[BaseProcess]:
        with self._lock:
            if self._process is None or (question is not None and self._asked is not question):
                return []
            process, self._process = self._process, None
            return [process]


def stop_all(workers: Iterable[Worker]) -> None:
    """End many processes at once.

    Args:
        workers: Whose.
    """
    dismiss(process for worker in workers for process in worker._let_go())


def _work(line: Connection, gives_way: bool) -> None:  # noqa: FBT001 -- arguments of processes go by place
    """Answer until nobody asks any more."""
    if gives_way and hasattr(os, "nice"):
        os.nice(MANNERS)
    _hold_memory()
    with suppress(EOFError, OSError):
        while True:
            line.send(_safely(line.recv(), line.send))


def _safely(question: Question, tell: Tell) -> Answer:
    """Return the answer; an error of gearwright's own is told as one, and the process lives on."""
    done = [0.0]

    def told(now: Progress) -> None:
        done[0] = now.done
        tell(now)

    try:
        with noticed(lambda words: tell(Progress(done[0], words, lasting=True))):
            return answered(question, told)
    except Exception as error:  # what no rule foresaw must not end the workbench
        sentence = f'{{"error": "gearwright failed here ({type(error).__name__}); this is a fault of its own"}}'
        return Answer(sentence.encode(), status=500)


def _hold_memory() -> None:
    with suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


# ----------------------------------------------------------------------------------------------------------------------
# Questions in a row: one is answered at a time, and of those that one page asks of one verb only the newest.
# ----------------------------------------------------------------------------------------------------------------------


MOST_WAITING = 64
"""Questions that may wait [-]."""


class Superseded(Exception):
    """A newer question took the place of this one."""


class Busy(Exception):
    """Too many questions wait."""


class Lane:
    """A worker and those who wait for it."""

    def __init__(self, worker: Worker, *, seconds: float) -> None:
        self.worker = worker
        self._seconds = seconds
        self._turn = asyncio.Lock()
        self._numbers = count()
        self._newest: dict[tuple[str, str], int] = {}
        self._waiting = 0

    async def ask(self, question: Question, page: str) -> Answer:
        """Return the answer to a question.

        Args:
            question: Of a page.
            page: Who asks: two windows do not take each other's place.

        Raises:
            Superseded: If the page has asked again, of the same verb.
            Busy: If too many wait.
        """
        if self._waiting >= MOST_WAITING:
            raise Busy
        key, mine = (page, question.verb), next(self._numbers)
        self._newest[key] = mine
        self._waiting += 1
        try:
            async with self._turn:
                if self._newest[key] != mine:
                    raise Superseded
                return await self._answer(question, key, mine)
        finally:
            self._waiting -= 1

    async def _answer(self, question: Question, key: tuple[str, str], mine: int) -> Answer:
        try:
            return await asyncio.to_thread(self.worker.ask, question, self._seconds)
        except Stopped:
            if self._newest.get(key) != mine:
                raise Superseded from None
            raise
        finally:
            if self._newest.get(key) == mine:
                del self._newest[key]


# ----------------------------------------------------------------------------------------------------------------------
# What takes long: computations in processes of their own, whose events tell how far they are; each can be ended.
# ----------------------------------------------------------------------------------------------------------------------


WORKERS = 2
"""Computations at once [-]."""
MOST_JOBS_WAITING = 8
"""Computations that may wait [-]."""
MOST_KEPT = 24
"""Finished ones whose results are kept [-]."""
YOUNG = 1.5
"""A computation that is replaced comes to its end if it is younger: its process would take as long to start [s]."""
LASTING = frozenset({"study", "resume"})
"""Verbs that a newer question does not replace."""
BEAT = 0.2
"""Least time between two events of one computation [s]."""


@dataclass(eq=False)
class Job:
    """A computation that was asked for."""

    question: Question
    page: str
    """Who asks."""
    name: str = field(default_factory=lambda: token_urlsafe(12))
    events: list[dict[str, Any]] = field(default_factory=list)
    """Of which only the newest progress is kept; each has its number."""
    answer: Answer | None = None
    ended: bool = False
    worker: Worker | None = None
    begun: float = 0.0
    news: asyncio.Event = field(default_factory=asyncio.Event)
    task: asyncio.Task[None] | None = None

    def tell(self, event: Mapping[str, Any]) -> None:
        """Keep an event, in the place of an older progress.

        Args:
            event: What has happened.
        """
        number = self.events[-1]["number"] + 1 if self.events else 1
        if self.events and "done" in self.events[-1]:
            self.events.pop()
        self.events.append({"number": number, **event})
        self.news.set()
        self.news = asyncio.Event()


class Jobs:
    """The processes, those who wait for them, and what they have found."""

    def __init__(self) -> None:
        self._idle: asyncio.Queue[Worker] = asyncio.Queue()
        self.workers = [Worker(heirs=True) for _ in range(WORKERS)]
        for worker in self.workers:
            self._idle.put_nowait(worker)
        self._jobs: OrderedDict[str, Job] = OrderedDict()

    def close(self) -> None:
        """Let go of every computation."""
        for job in self._jobs.values():
            if job.task is not None:
                job.task.cancel()

    def begin(self, question: Question, page: str) -> Job:
        """Return a computation that begins as soon as a process is free; an older one of the page is replaced.

        Args:
            question: Of a page.
            page: Who asks.

        Raises:
            Busy: If too many wait.
        """
        if question.verb not in LASTING:
            for job in list(self._jobs.values()):
                if not job.ended and (job.page, job.question.verb) == (page, question.verb):
                    self._replace(job)
        if sum(not job.ended and job.worker is None for job in self._jobs.values()) >= MOST_JOBS_WAITING:
            raise Busy
        job = Job(question, page)
        self._jobs[job.name] = job
        self._forget()
        job.task = asyncio.create_task(self._run(job))
        return job

    def of(self, name: str) -> Job | None:
        """Return a computation by its name, if it is known.

        Args:
            name: As it was told.
        """
        return self._jobs.get(name)

    async def stop(self, job: Job) -> None:
        """End a computation, whatever it does.

        Args:
            job: Which.
        """
        if not job.ended:
            self._end(job, {"stopped": "this computation was stopped"})
            if job.worker is not None:
                await asyncio.to_thread(job.worker.stop, job.question)

    async def events(self, job: Job, after: int) -> AsyncIterator[dict[str, Any]]:
        """Yield what happens to a computation, from an event on, until it has ended.

        Args:
            job: Which.
            after: Number of the last event that is known.
        """
        while True:
            news = job.news
            for event in [event for event in job.events if event["number"] > after]:
                after = event["number"]
                yield event
            if job.ended:
                return
            await news.wait()

    async def _run(self, job: Job) -> None:
        worker = await self._idle.get()
        try:
            if not job.ended:
                job.worker, job.begun = worker, time.monotonic()
                await self._answered(job, worker)
        finally:
            job.worker = None
            self._idle.put_nowait(worker)

    async def _answered(self, job: Job, worker: Worker) -> None:
        loop, told = asyncio.get_running_loop(), [0.0]

        def tell(progress: Progress) -> None:
            now = time.monotonic()
            if progress.lasting or now - told[0] > BEAT:
                told[0] = now
                loop.call_soon_threadsafe(self._told, job, progress)

        try:
            job.answer = await asyncio.to_thread(worker.ask, job.question, None, tell)
        except Stopped as reason:
            if not job.ended:
                self._end(job, {"stopped": str(reason)})
            return
        if not job.ended:
            self._end(job, {"finished": True, "status": job.answer.status})

    def _told(self, job: Job, progress: Progress) -> None:
        if not job.ended:
            job.tell({"done": progress.done, "words": progress.words})

    def _end(self, job: Job, event: Mapping[str, Any]) -> None:
        job.ended = True
        job.tell(event)

    def _replace(self, job: Job) -> None:
        """End an older computation; one that has just begun comes to its end unseen."""
        self._end(job, {"replaced": True})
        if job.worker is not None and time.monotonic() - job.begun > YOUNG:
            asyncio.get_running_loop().run_in_executor(None, job.worker.stop, job.question)

    def _forget(self) -> None:
        ended = [name for name, job in self._jobs.items() if job.ended]
        for name in ended[: max(0, len(ended) - MOST_KEPT)]:
            del self._jobs[name]
