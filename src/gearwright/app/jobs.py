"""What takes long: computations in processes of their own, whose events tell how far they are; each can be ended."""

from __future__ import annotations

import asyncio
import time
from collections import OrderedDict
from collections.abc import AsyncIterator, Mapping
from dataclasses import dataclass, field
from secrets import token_urlsafe
from typing import Any

from gearwright.app.asked import Answer, Progress, Question
from gearwright.app.lane import Busy
from gearwright.app.worker import Stopped, Worker

WORKERS = 2
"""Computations at once [-]."""
MOST_WAITING = 8
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
        if sum(not job.ended and job.worker is None for job in self._jobs.values()) >= MOST_WAITING:
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
