"""The sizing of every shipped design is what it was when its file was written (``python tests/golden/record.py``)."""

import json

import pytest
from record import FOLDER, recorded

from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import read

NOISE = 1e-6
"""Speeds [rad/s], powers [W] and, in diagrams, forces [N] and moments [N m] below this are zeros with rounding."""
CLOSING = ("cases.", ".diagram.", ".bearings.", ".bending_moment")
"""What closes to zero by subtraction."""


@pytest.mark.parametrize("name", shipped_designs())
def test_sizing_did_not_move(name):
    stored = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    found = recorded(size(read(shipped_design(name))))
    assert found.keys() == stored["values"].keys()
    moved = {
        path: (was, found[path])
        for path, was in stored["values"].items()
        if found[path] != pytest.approx(was, rel=stored["tolerance"]["rel"], abs=_noise(path))
    }
    assert moved == {}


def _noise(path):
    return NOISE if any(part in path for part in CLOSING) else 0.0


def test_every_stored_file_has_its_design():
    assert {path.stem for path in FOLDER.glob("*.json")} == set(shipped_designs())
