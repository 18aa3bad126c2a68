"""Every design's sizing and assembled system are what they were when its file was written by ``record.py``."""

import json

import pytest
from record import FOLDER, designs, recorded

from gearwright.sizing import size

DESIGNS = designs()

NOISE = 1e-6
"""Speeds [rad/s], powers [W] and, in diagrams, forces [N] and moments [N m] below this are zeros with rounding."""
CLOSING = ("cases.", ".diagram.", ".bearings.", ".bending_moment", ".tangential_force")
"""What closes to zero by subtraction."""
ORDER = 1e-9
"""What sums of unlike signs may differ by, over the sum of their sizes [-]."""


@pytest.mark.parametrize("name", DESIGNS)
def test_sizing_did_not_move(name):
    stored = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    found = recorded(size(DESIGNS[name]))
    assert found.keys() == stored["values"].keys()
    moved = {
        path: (was, found[path])
        for path, was in stored["values"].items()
        if found[path] != pytest.approx(was, rel=stored["tolerance"]["rel"], abs=_noise(path))
    }
    assert moved == {}


def _noise(path):
    if path.startswith("arrays."):
        return ORDER
    return NOISE if any(part in path for part in CLOSING) else 0.0


def test_every_stored_file_has_its_design():
    assert {path.stem for path in FOLDER.glob("*.json")} == set(DESIGNS)
