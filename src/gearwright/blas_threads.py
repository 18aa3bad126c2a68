"""Threads of BLAS, the library beneath numpy's and scipy's linear algebra: one is enough for matrices of a gear train.

From some fifty rows on BLAS shares a matrix among as many threads as there are processors. Of a few hundred rows the
shares are so small that threads spend their time on waiting for each other, which takes all processors.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from threading import Lock
from typing import Any

_BRING = ("numpy", "scipy.linalg")
"""Modules that bring a BLAS each; scipy's is loaded when it is first needed."""
_LOCK = Lock()
_INSIDE = list[int]()
"""A mark for every block that runs now, of all threads: the limit is the process's."""
_BEFORE = dict[str, tuple[Any, int]]()
"""File of a BLAS -> the BLAS, and the threads that it had before the first of these blocks [-]."""


@contextmanager
def one_blas_thread() -> Iterator[None]:
    """Limit BLAS to one thread while a block runs; after the last of all that run at once it has its own again.

    A block that loads scipy's BLAS enters anew once it is loaded.
    """
    with _LOCK:
        _INSIDE.append(1)
        for library in _libraries(tuple(name in sys.modules for name in _BRING)):
            if library.filepath not in _BEFORE:
                _BEFORE[library.filepath] = library, library.get_num_threads()
                library.set_num_threads(1)
    try:
        yield
    finally:
        with _LOCK:
            _INSIDE.pop()
            while _BEFORE and not _INSIDE:
                library, threads = _BEFORE.popitem()[1]
                library.set_num_threads(threads)


@cache
def _libraries(_loaded: tuple[bool, ...]) -> list[Any]:
    """Return every BLAS of the process, looked for once for the modules that are loaded."""
    from threadpoolctl import ThreadpoolController  # with what it looks through, 10 ms, which one never pays by help

    return list(ThreadpoolController().select(user_api="blas").lib_controllers)
