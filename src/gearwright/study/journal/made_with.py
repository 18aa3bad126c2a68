"""What results are computed with: gearwright's own files, and the libraries whose rounding reaches the results."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from functools import cache
from importlib.metadata import version
from pathlib import Path

from gearwright.version import __version__, digest

LIBRARIES = ("numpy", "scipy", "numba", "llvmlite")
"""Libraries that compute."""


@cache
def made_with() -> Mapping[str, str]:
    """Return what computes here: name -> version, with a digest of every installed file of gearwright.

    The digest notices an edited file under an unchanged version.
    """
    libraries = {name: version(name) for name in LIBRARIES}
    program = f"{__version__}, files {digest(Path(__file__).parents[2])}"
    return {"gearwright": program, "python": f"{sys.version_info.major}.{sys.version_info.minor}", **libraries}


def changes_of(begun: Mapping[str, str], now: Mapping[str, str]) -> list[tuple[str, str, str]]:
    """Return what differs between two sets of versions.

    Args:
        begun: With what a study was begun.
        now: What computes now.

    Returns:
        Name, version then, version now.
    """
    names = dict.fromkeys([*begun, *now])
    pairs = [(name, begun.get(name, "none"), now.get(name, "none")) for name in names]
    return [pair for pair in pairs if pair[1] != pair[2]]
