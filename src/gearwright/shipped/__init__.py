"""Design and study files that come with gearwright; `gearwright new` copies the designs."""

from __future__ import annotations

from pathlib import Path

from gearwright.errors import DesignError, Problem, near

_DESIGNS = Path(__file__).parent / "designs"
_STUDIES = Path(__file__).parent / "studies"


def shipped_designs() -> tuple[str, ...]:
    """Return the names of all shipped designs."""
    return tuple(sorted(path.stem for path in _DESIGNS.glob("*.toml")))


def shipped_design(name: str) -> Path:
    """Return the path of a shipped design file.

    Args:
        name: Such as ``in-line-h2``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    if name not in shipped_designs():
        raise DesignError([Problem("name", f"there is no shipped design {name!r}; {near(name, shipped_designs())}")])
    return _DESIGNS / f"{name}.toml"


def shipped_studies() -> tuple[str, ...]:
    """Return the names of all shipped studies."""
    return tuple(sorted(path.stem for path in _STUDIES.glob("*.toml")))


def shipped_study(name: str) -> Path:
    """Return the path of a shipped study file.

    Args:
        name: Such as ``motor-speed``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    if name not in shipped_studies():
        raise DesignError([Problem("name", f"there is no shipped study {name!r}; {near(name, shipped_studies())}")])
    return _STUDIES / f"{name}.toml"
