"""Every design's sizing and assembled system are what they were when its file was written by ``record.py``."""

import json

import pytest
from record import FOLDER, designs, recorded, same, sized

DESIGNS = designs()


@pytest.mark.parametrize("name", DESIGNS)
def test_sizing_did_not_move(name):
    stored = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    found = recorded(sized(name))
    assert found.keys() == stored["values"].keys()
    moved = {path: (was, found[path]) for path, was in stored["values"].items() if not same(path, was, found[path])}
    assert moved == {}


def test_every_stored_file_has_its_design():
    assert {path.stem for path in FOLDER.glob("*.json")} == set(DESIGNS)
