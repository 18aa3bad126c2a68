"""How many cases make a chunk: long beside a message, short beside patience, and large where cases go together."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.study.cases import LEAST as LEAST_TOGETHER

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
