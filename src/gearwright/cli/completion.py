"""What a shell completes: names of shipped designs, missions, mixes, studies and notebooks, and files beside them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path


def designs(incomplete: str) -> list[str]:
    """Return designs that begin so: shipped ones, and TOML files.

    Args:
        incomplete: What stands on the command line.
    """
    from gearwright.shipped import shipped_designs

    return _beginning(incomplete, shipped_designs())


def missions(incomplete: str) -> list[str]:
    """Return missions that begin so: shipped ones, and TOML files.

    Args:
        incomplete: What stands on the command line.
    """
    from gearwright.shipped import shipped_missions

    return _beginning(incomplete, shipped_missions())


def mixes(incomplete: str) -> list[str]:
    """Return mixes that begin so: shipped ones, and TOML files.

    Args:
        incomplete: What stands on the command line.
    """
    from gearwright.shipped import shipped_mixes

    return _beginning(incomplete, shipped_mixes())


def studies(incomplete: str) -> list[str]:
    """Return studies that begin so: shipped ones, and TOML files.

    Args:
        incomplete: What stands on the command line.
    """
    from gearwright.shipped import shipped_studies

    return _beginning(incomplete, shipped_studies())


def shipped(incomplete: str) -> list[str]:
    """Return everything shipped that begins so.

    Args:
        incomplete: What stands on the command line.
    """
    from gearwright.shipped import (
        shipped_designs,
        shipped_missions,
        shipped_mixes,
        shipped_notebooks,
        shipped_studies,
    )

    names = (*shipped_designs(), *shipped_missions(), *shipped_mixes(), *shipped_studies(), *shipped_notebooks())
    return [name for name in names if name.startswith(incomplete)]


def _beginning(incomplete: str, names: Iterable[str]) -> list[str]:
    """Return names, TOML files and folders that begin so; a file may stand in a folder."""
    place = Path(incomplete) if incomplete.endswith("/") else Path(incomplete).parent
    try:
        beside = sorted(place.iterdir())
    except OSError:
        beside = []
    files = [f"{path}/" if path.is_dir() else str(path) for path in beside if path.suffix == ".toml" or path.is_dir()]
    return [name for name in (*names, *files) if name.startswith(incomplete)]
