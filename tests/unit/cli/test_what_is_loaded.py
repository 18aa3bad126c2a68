"""What a command loads: only what it uses, as a script that sizes many designs waits for every module each time."""

from __future__ import annotations

import subprocess
import sys

import pytest

HEAVY = {"matplotlib", "pandas", "xarray", "scipy.optimize", "scipy.stats", "h5netcdf"}
MOTION = {"numba", "scipy.linalg", "gearwright.dynamics"}
TELL = """
import sys
sys.argv = ["gearwright", *sys.argv[1:]]
from gearwright.cli import main
try:
    main()
finally:
    print(*sys.modules, file=sys.stderr)
"""


def loaded(*arguments: str) -> set[str]:
    """Return the modules that a command has loaded at its end."""
    done = subprocess.run([sys.executable, "-c", TELL, *arguments], capture_output=True, text=True, check=True)
    return set(done.stderr.split())


def test_help_loads_no_numbers() -> None:
    assert not loaded("--help") & {*HEAVY, *MOTION, "numpy", "pydantic", "gearwright.sizing"}


@pytest.mark.parametrize(("design", "unused"), [("single-planetary", HEAVY | MOTION), ("off-set", HEAVY)])
def test_sizing_loads_no_more_than_it_uses(design: str, unused: set[str]) -> None:
    """The off-set gearbox has parallel paths, whose elastic shares need statics."""
    modules = loaded("size", design)
    assert "gearwright.sizing" in modules
    assert not modules & unused
