"""Signals that ask a program to end: who hears them for a while, and that what they raise arrives."""

import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from threading import current_thread, main_thread
from types import FrameType
from typing import Any

ENDING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name))
"""Those that the system has."""
AGAIN = 0.05
"""Until an interruption is raised again that has not arrived [s]."""
_IMPORTING = vars(sys.modules["_frozen_importlib"])
"""Globals of what imports modules."""
_asked = list[int]()
"""Signals whose interruption has not been answered."""


@contextmanager
def heard_by(handler: Callable[[int, FrameType | None], Any], numbers: Iterable[int]) -> Iterator[None]:
    """Let a handler hear some signals while a block runs; each then has the one that it had.

    Args:
        handler: As for `signal.signal`; in the main thread.
        numbers: Signals whose handlers Python has set.
    """
    before = {number: signal.signal(number, handler) for number in numbers}
    try:
        yield
    finally:
        for number, own in before.items():
            signal.signal(number, own)


@contextmanager
def heard_after(meanwhile: Callable[[], None] = lambda: None) -> Iterator[None]:
    """Hear what ends this process after what is within, which would be left half done, or swallow it.

    Args:
        meanwhile: Called at once when a signal comes.
    """

    def hear(number: int, _: FrameType | None) -> None:
        came.append(number)
        meanwhile()

    came: list[int] = []
    heard = ENDING if current_thread() is main_thread() else ()
    ours = [number for number in heard if signal.getsignal(number) not in (None, signal.SIG_IGN)]
    try:
        with heard_by(hear, ours):
            yield
    finally:
        if came:
            signal.raise_signal(came[0])


def interrupt(number: int, frame: FrameType | None) -> None:
    """Raise `KeyboardInterrupt`, again and again until it is answered: libraries in C swallow what is raised in them.

    The handler of a signal. While a module is imported it waits: half a module helps nobody, and an interpreter in
    which source is executed as text meanwhile ends by itself later. Where the system has no timer, it is raised once.

    Args:
        number: Of the signal.
        frame: Where it is heard; whatever runs there is interrupted.
    """
    _asked.append(number)
    if hasattr(signal, "setitimer"):
        signal.signal(signal.SIGALRM, _interrupt_again)
        signal.setitimer(signal.ITIMER_REAL, AGAIN, AGAIN)
        if _imports(frame):
            return
    raise KeyboardInterrupt


def _imports(frame: FrameType | None) -> bool:
    """Tell whether a module is being imported."""
    while frame is not None and frame.f_globals is not _IMPORTING:
        frame = frame.f_back
    return frame is not None


def answered() -> None:
    """Tell that an interruption has arrived, where the program goes on behind it."""
    if _asked:
        _asked.clear()
        if hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_REAL, 0.0)


def _interrupt_again(*_: object) -> None:
    """Raise an interruption again, unless it is on its way, through blocks that put away what was begun."""
    way = sys.exception()
    while way is not None and not isinstance(way, KeyboardInterrupt):
        way = way.__context__
    if way is None and _asked:
        signal.raise_signal(_asked[0])
