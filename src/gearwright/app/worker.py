"""A process that answers questions: nothing that is computed holds up the page, and anything can be stopped."""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from threading import Lock

from gearwright.app.asked import Answer, Progress, Question, Tell
from gearwright.app.verbs import answered
from gearwright.notices import noticed
from gearwright.processes import dismiss, hire

MEMORY = 16 * 2**30
"""Address space that a worker may take, where the system can hold it to that [bytes]."""

MANNERS = 5
"""By how much what takes long gives way to what answers a keystroke, as `nice` counts [-]."""


NEEDED = ("gearwright.sizing", "gearwright.render.answers.design", "gearwright.render.schematic.schematic")
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
