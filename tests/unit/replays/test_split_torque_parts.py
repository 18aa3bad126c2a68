"""The face-gear split torque is known by its train and its data."""

from __future__ import annotations

import re

import pytest

from gearwright.replays.wang.claims import SplitTorque, split_torque
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.spec import parse, read

TEXT = shipped_design("face-gear-split-torque").read_text(encoding="utf-8")


def test_parts_of_the_shipped_design():
    assert split_torque(parse(TEXT)) == SplitTorque("first", "second", "input", ("left", "right"), "output")


def test_names_of_shafts_and_stages_do_not_matter():
    names = {"input": "one", "left": "two", "right": "three", "output": "four", "first": "faces", "second": "join"}
    renamed = re.sub(rf"\b({'|'.join(names)})\b", lambda found: names[found[0]], TEXT)
    assert split_torque(parse(renamed)) == SplitTorque("faces", "join", "one", ("two", "three"), "four")


def test_no_other_shipped_design_is_one():
    others = [name for name in shipped_designs() if name != "face-gear-split-torque"]
    assert [name for name in others if split_torque(read(shipped_design(name)))] == []


@pytest.mark.parametrize(
    ("update", "part"),
    [({"supports": {}}, "supports"), ({"errors": {}}, "errors")],
)
def test_figures_are_not_asked_of_a_design_without_their_data(update, part):
    design = parse(TEXT)
    assert getattr(design, part)
    assert split_torque(design.model_copy(update=update)) is None
