"""Notices of what takes long once, such as compiling: said while it takes so long, to whoever asked for it.

Who shows words, a command or the workbench, hears them; where nobody does, they are not said.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

_HEARERS = list[Callable[[str], None]]()


def notice(words: str) -> None:
    """Say something to who hears this process.

    Args:
        words: What takes long, and how long.
    """
    if _HEARERS:
        _HEARERS[-1](words)


@contextmanager
def noticed(tell: Callable[[str], None]) -> Iterator[None]:
    """Hear what is said while a block runs, the same words once.

    Args:
        tell: Takes the words.
    """
    known = set[str]()

    def once(words: str) -> None:
        if words not in known:
            known.add(words)
            tell(words)

    _HEARERS.append(once)
    try:
        yield
    finally:
        _HEARERS.remove(once)
