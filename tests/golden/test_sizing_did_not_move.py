"""The sizing of every shipped design is what it was when its file was written (``python tests/golden/record.py``)."""

import json

import pytest
from record import FOLDER, recorded

from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import read

NOISE = 1e-6
"""Speeds [rad/s] and powers [W] below this are zeros with rounding."""


@pytest.mark.parametrize("name", shipped_designs())
def test_sizing_did_not_move(name):
    stored = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    found = recorded(size(read(shipped_design(name))))
    assert found.keys() == stored["values"].keys()
    moved = {
        path: (was, found[path])
        for path, was in stored["values"].items()
        if found[path] != pytest.approx(was, rel=stored["tolerance"]["rel"], abs=NOISE if "cases." in path else 0.0)
    }
    assert moved == {}


def test_every_stored_file_has_its_design():
    assert {path.stem for path in FOLDER.glob("*.json")} == set(shipped_designs())
