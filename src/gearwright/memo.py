"""Results that are kept by key, so that what is asked again of a computation is not computed again."""

from collections import OrderedDict
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import wraps
from threading import Lock
from typing import Any, Generic, TypeVar

Key = TypeVar("Key", bound=Hashable)
Result = TypeVar("Result")
Value = TypeVar("Value")
_MISSING: Any = object()
_LOCK = Lock()
"""Held while a result is kept: threads take turns."""


class Memo(Generic[Key, Result]):
    """The latest results of a computation by key, so many at most; beyond them the earliest goes.

    >>> lengths = Memo[str, int](2)
    >>> [lengths.of(word, lambda: len(word)) for word in ("sun", "planet", "ring")]
    [3, 6, 4]
    >>> lengths.get("sun"), lengths.get("ring")
    (None, 4)
    """

    __slots__ = ("_kept", "_most")

    def __init__(self, most: int) -> None:
        self._most, self._kept = most, OrderedDict[Key, Result]()

    def get(self, key: Key) -> Result | None:
        """Return what is kept under a key; None where nothing is.

        Args:
            key: Of the result.
        """
        return self._kept.get(key)

    def keep(self, key: Key, result: Result) -> Result:
        """Keep a result, and return it.

        Args:
            key: Of the result.
            result: It is not changed afterwards by those who ask.
        """
        with _LOCK:
            self._kept[key] = result
            while len(self._kept) > self._most:
                self._kept.popitem(last=False)
        return result

    def of(self, key: Key, make: Callable[[], Result]) -> Result:
        """Return what is kept under a key, or make and keep it; what is refused is refused anew.

        Args:
            key: Of the result: all that it depends on.
            make: Makes it.
        """
        result: Result = self._kept.get(key, _MISSING)
        return self.keep(key, make()) if result is _MISSING else result


def of_latest(most: int) -> Callable[[Callable[[Value], Result]], Callable[[Value], Result]]:
    """Return what makes of a function of one value one that keeps what it gave of the latest values.

    Values are told apart by which object they are: equal ones that are two objects are computed twice. A function whose
    value takes turns with another, as a design with its edited one, keeps two.

    Args:
        most: Values that are kept [-].

    >>> asked = []
    >>> length = of_latest(1)(lambda words: asked.append(words) or len(words))
    >>> words = ("sun", "planet")
    >>> length(words), length(words), length(("sun", "planet")[:1]), len(asked)
    (2, 2, 1, 2)
    """

    def keeping(function: Callable[[Value], Result]) -> Callable[[Value], Result]:
        memo = Memo[int, tuple[Value, Result]](most)  # with its value, which thus lives and shares its number with none

        @wraps(function)
        def asked(value: Value) -> Result:
            return (memo.get(id(value)) or memo.keep(id(value), (value, function(value))))[1]

        return asked

    return keeping


class SharedMemo(Generic[Key, Result]):
    """A memo that all within a ``with`` share; without one, everybody who asks has a memo of their own."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._shared: ContextVar[Memo[Key, Result] | None] = ContextVar("shared", default=None)

    @contextmanager
    def sharing(self) -> Iterator[None]:
        """Let all within share one memo, that of a block around it where there is one."""
        token = self._shared.set(self.now())
        try:
            yield
        finally:
            self._shared.reset(token)

    def now(self) -> Memo[Key, Result]:
        """Return the memo that is shared here, or a new one."""
        shared = self._shared.get()
        return Memo(self._most) if shared is None else shared
