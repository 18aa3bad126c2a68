"""Questions in a row: one is answered at a time, and of those that one page asks of one verb only the newest."""

from __future__ import annotations

import asyncio
from itertools import count

from gearwright.app.asked import Answer, Question
from gearwright.app.worker import Stopped, Worker

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
