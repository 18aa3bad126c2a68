"""Compile the source of an FMU, where there is a C compiler."""

from __future__ import annotations

import platform
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from gearwright.errors import excerpt
from gearwright.processes import run_program
from gearwright.writing import write_bytes

COMPILERS = ("cc", "gcc", "clang")
"""Names by which they are looked for."""
FLAGS = ("-std=c99", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-ffp-contract=off")
"""What they are given: numbers agree with those of `simulate` only if products and sums are rounded apart."""
LONGEST = 300
"""Seconds that a compiler may take."""
_SYSTEMS = {"linux": "linux", "darwin": "darwin", "win32": "windows"}
_SHORT = {"linux": "linux64", "darwin": "darwin64", "windows": "win64"}
_SUFFIX = {"linux": ".so", "darwin": ".dylib", "windows": ".dll"}
_MACHINES = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "aarch64", "arm64": "aarch64"}


class Binary(NamedTuple):
    """A shared library for this platform, or why there is none."""

    content: bytes
    """Empty where there is none."""
    place: str
    """In the FMU."""
    platform: str
    """Such as ``x86_64-linux``."""
    missing: str = ""
    """Why there is none."""


def compiled(sources: Mapping[str, bytes], main: str, identifier: str, *, version: str) -> Binary:
    """Return the shared library of a source for this platform.

    Args:
        sources: Name -> file, all in one folder.
        main: File to compile.
        identifier: Of the model, the name of the library.
        version: Of FMI, which names platforms in its own way.
    """
    system, machine = _SYSTEMS.get(sys.platform, ""), _MACHINES.get(platform.machine().lower(), "")
    name = f"{machine}-{system}"
    compiler = next((path for path in map(shutil.which, COMPILERS) if path), None)
    if not system or not machine:
        return Binary(b"", "", name, f"FMI has no name for the platform {sys.platform}, {platform.machine()}")
    if compiler is None:
        return Binary(b"", "", name, f"there is no C compiler ({', '.join(COMPILERS)})")
    folder = name if version == "3.0" else _SHORT[system]
    with tempfile.TemporaryDirectory() as place:
        for file, content in sources.items():
            write_bytes(Path(place, file), content)
        library = Path(place, identifier + _SUFFIX[system])
        try:
            command = [compiler, *FLAGS, main, "-o", library.name, "-lm"]
            run = run_program(command, seconds=LONGEST, folder=Path(place))
        except (OSError, subprocess.TimeoutExpired) as error:
            return Binary(b"", "", name, f"{compiler} failed: {excerpt(str(error))}")
        if run.returncode or not library.is_file():
            return Binary(b"", "", name, f"{compiler} failed: {excerpt(run.stderr or run.stdout)}")
        return Binary(library.read_bytes(), f"binaries/{folder}/{library.name}", name)
