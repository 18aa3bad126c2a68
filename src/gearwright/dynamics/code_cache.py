"""numba's functions with code that is kept between runs, as `kept_code` keeps it."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

from numba import njit
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from gearwright.dynamics.kept_code import COMPILING, folder, read_code, write_code
from gearwright.notices import notice

Given = ParamSpec("Given")
Result = TypeVar("Result")


def compiled(function: Callable[Given, Result]) -> Callable[Given, Result]:
    """Return a function that is compiled for its arguments when it is first called, or taken from the cache.

    Args:
        function: In the part of Python that numba compiles.
    """
    dispatcher: Any = njit(error_model="numpy")(function)
    dispatcher._cache = CodeCache(function)
    return dispatcher  # type: ignore[no-any-return]


class CodeCache:
    """What numba asks before it compiles a function, and gives what it has compiled."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self.name = f"{function.__module__}.{function.__qualname__}"

    @property
    def cache_path(self) -> str:
        """Where code is kept; empty for nowhere."""
        return str(folder() or "")

    def load_overload(self, signature: Any, target: Any) -> Any:
        """Return the code for arguments; none if it is not there, or not to be trusted: then it is compiled next.

        Args:
            signature: Kinds of the arguments.
            target: What numba compiles for.
        """
        target.refresh()
        path = self._path(signature, target.codegen())
        content = None if path is None else read_code(path)
        if content is None:
            notice(COMPILING)
            return None
        return CompileResult._rebuild(target, *pickle.loads(content))  # type: ignore[no-untyped-call]

    def save_overload(self, signature: Any, result: Any) -> None:
        """Keep what has been compiled; code with addresses of this process in it, and a full disk, keep nothing.

        Args:
            signature: Kinds of the arguments.
            result: numba's, compiled.
        """
        path = self._path(signature, result.codegen)
        if path is None or result.lifted or result.library.has_dynamic_globals:
            return
        content: bytes = dumps(result._reduce())  # type: ignore[no-untyped-call]
        write_code(path, content)

    def _path(self, signature: Any, codegen: Any) -> Path | None:
        home = folder()
        key = sha256(repr((self.name, str(signature), codegen.magic_tuple())).encode()).hexdigest()
        return None if home is None else home / f"{self.name.rpartition('.')[2]}-{key[:32]}"
