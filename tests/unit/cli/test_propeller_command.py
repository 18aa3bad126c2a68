"""The command ``propeller``, called as its users call it."""

import json

import pytest
import typer
from typer.testing import CliRunner

from gearwright.catalogue import read_propeller_map
from gearwright.cli.commands.flights import propeller
from gearwright.errors import DesignError

APP = typer.Typer()
APP.command()(propeller)
COARSE = ("--ratios", "0:2:0.5", "--angles-deg", "0:50:10")
POINT = ("--rpm", "1212", "--tas-m-s", "140", "--altitude-m", "6000", "--incidence-deg", "3")


def run(*arguments, catch=True):
    """Return what a call gives."""
    return CliRunner().invoke(APP, [*COARSE, *arguments], catch_exceptions=catch)


def test_it_shows_efficiency_idle_and_the_keys_that_a_design_takes():
    shown = run("--blades", "6", *POINT, "--power-kw", "1600")
    assert shown.exit_code == 0
    for words in ("6 blades, activity factor 115", "idle angle", "in_plane_force_n = ", "hub_moment_nm = "):
        assert words in shown.output


def test_its_json_has_the_map_and_the_loads():
    answer = json.loads(run(*POINT, "--blade-angle-deg", "38", "--json").output)["result"]
    assert len(answer["rows"]) == 5 * 6
    assert answer["flight"]["blade_angle_deg"] == pytest.approx(38.0)
    assert answer["flight"]["hub_moment_nm"] > 0.0
    lines = run("--jsonl").output.splitlines()
    assert len(lines) == 1 + 5 * 6


def test_its_map_is_a_missions_file(tmp_path):
    path = tmp_path / "map.csv"
    assert run("--tip-mach", "0.4", "--tip-mach", "0.7", "--out", str(path)).exit_code == 0
    assert read_propeller_map(path).tip_mach.tolist() == [0.4, 0.7]
    figure = tmp_path / "map.svg"
    assert run("--figure", str(figure)).exit_code == 0
    assert figure.read_text(encoding="utf-8").startswith("<svg")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--ratios", "0:2"), "is not first:last:step"),
        (("--ratios", "0:2:0"), "is not first:last:step"),
        (("--angles-deg", "40:0:10"), "is not first:last:step"),
        (("--by", "charts", "--tip-mach", "0.5"), "without compressibility"),
        (("--blades", "9", "--by", "charts"), "give 2 to 8"),
        ((*POINT, "--power-kw", "90000"), "before they stall"),
        (POINT, "give either power or blade_angle"),
        ((*POINT, "--blade-angle-deg", "30", "--incidence-deg", "80"), "at most 30"),
        (("no-blade.csv",), "there is no such file"),
    ],
)
def test_what_cannot_be_made_is_refused(arguments, said):
    with pytest.raises(DesignError, match=said):
        run(*arguments, catch=False)
