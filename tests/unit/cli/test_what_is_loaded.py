"""What a command loads: only what it uses, as a script that sizes many designs waits for every module each time."""

from __future__ import annotations

import subprocess
import sys

import pytest

NUMBERS = {"numpy", "pydantic", "gearwright.sizing"}
HEAVY = {"matplotlib", "pandas", "xarray", "scipy.optimize", "scipy.stats", "h5netcdf"}
COMPILED = {"numba", "llvmlite"}
STATICS = HEAVY | COMPILED | {"scipy.linalg", "scipy.special"}
"""What the equilibrium of an elastic train does without."""
MOTION = STATICS | {"gearwright.dynamics"}
NOTHING = {"scipy", "h5py", "jinja2"}
"""What a train without parallel paths does without, even in part."""
UNUSED = {
    "--help": MOTION | NUMBERS | NOTHING,
    "size single-planetary": MOTION | NOTHING,
    "size ec120b": MOTION,  # its bearings are chosen and loaded by contact
    "size off-set": STATICS,  # parallel paths, whose elastic shares need statics
    "size face-gear-split-torque": STATICS,
    "check off-set": STATICS,
    "modes off-set": STATICS,
    "campbell in-line-h2 --json": STATICS,
    "schema": MOTION,
}
"""Command -> what it must not load."""
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


@pytest.mark.parametrize("command", UNUSED)
def test_a_command_loads_no_more_than_it_uses(command: str) -> None:
    modules = loaded(*command.split())
    assert "gearwright.cli" in modules
    assert not modules & UNUSED[command]


def test_a_worker_of_studies_loads_nothing_of_flights_and_reviews() -> None:
    tell = "import sys, gearwright.study.workers; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", tell], capture_output=True, text=True, check=True)
    others = {f"gearwright.{layer}" for layer in ("dynamics", "mission", "closure", "reviews", "store", "render")}
    assert not set(done.stdout.split()) & (STATICS | others)
