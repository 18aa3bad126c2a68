"""The command ``rotor``, called as its users call it."""

import json

import pytest
import typer
from typer.testing import CliRunner

from gearwright.cli.commands.flights import rotor
from gearwright.errors import DesignError

APP = typer.Typer()
APP.command()(rotor)
CRAFT = ("--mass-kg", "1600", "--diameter-m", "10", "--rpm", "406", "--solidity", "0.057")
TAIL = ("--tail-diameter-m", "0.75", "--tail-rpm", "4567", "--tail-arm-m", "6", "--tail-solidity", "0.4")


def run(*arguments, catch=True):
    """Return what a call gives."""
    return CliRunner().invoke(APP, [*CRAFT, *arguments], catch_exceptions=catch)


def test_it_shows_thrust_power_and_the_speeds_that_stand_out():
    shown = run(*TAIL, "--flat-plate-area-m2", "0.9")
    assert shown.exit_code == 0
    for words in ("tail thrust", "parasite", "Figure of merit in hover 0.62", "Least power", "farthest at"):
        assert words in shown.output
    assert "tail" not in run().output


def test_its_json_has_every_speed():
    rows = json.loads(run("--speeds-m-s", "0:60:20", "--json").output)["result"]["rows"]
    assert [row["airspeed_m_s"] for row in rows] == [0.0, 20.0, 40.0, 60.0]
    assert rows[0]["power_kw"] > rows[1]["power_kw"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--tail-rpm", "4567"), "--tail-arm-m: a tail rotor is given without it"),
        (("--speeds-m-s", "0:200:50"), "of the tips' speed"),
        (("--speeds-m-s", "fast"), "is not first:last:step"),
        (("--altitude-m", "12000"), "stall beyond"),
        (("--rate-of-climb-m-s", "-9", "--speeds-m-s", "0:10:5"), "into its own wake"),
    ],
)
def test_what_cannot_be_is_told(arguments, said):
    with pytest.raises(DesignError, match=said):
        run(*arguments, catch=False)
