"""Stages beside each other: kind, ratio and meshes of designs whose numbers can be told from their teeth."""

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.summaries import stage_summaries
from gearwright.spec import read


@pytest.mark.parametrize(
    ("name", "ratios", "meshes"),
    [
        (
            "in-line-h2",
            lambda z: [1 + z["first.ring"] / z["first.sun"], 1 + z["second.ring"] / z["second.sun"]],
            [3, 5],
        ),
        ("star", lambda z: [z["first.ring"] / z["first.sun"]], None),
        ("off-set", lambda z: [z["first.wheel"] / z["first.pinion"], z["second.wheel"] / z["second.pinion"]], [4, 2]),
    ],
)
def test_ratios_are_those_of_the_teeth(name, ratios, meshes):
    sizing = size(read(shipped_design(name)))
    rows = list(stage_summaries(sizing, name))
    expected = ratios(sizing.teeth)
    assert [row.ratio for row in rows][: len(expected)] == [pytest.approx(ratio) for ratio in expected]
    assert meshes is None or [row.meshes for row in rows] == meshes
