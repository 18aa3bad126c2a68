"""The command ``mix``, called as its users call it."""

import json

import pytest
import typer
from typer.testing import CliRunner

from gearwright.cli.commands.flights import mix
from gearwright.errors import DesignError

APP = typer.Typer()
APP.command()(mix)


def run(*arguments, catch=True):
    """Return what a call gives."""
    return CliRunner().invoke(APP, list(arguments), catch_exceptions=catch)


def test_it_tells_what_fails_first_and_which_mission_eats_the_life():
    result = run("in-line-h2", "regional-life")
    assert result.exit_code == 0
    for words in ("does not live all 30000 flights", "bearing of first.planet", "short eats", "MWh from the battery"):
        assert words in result.output


def test_json_is_for_machines_and_its_sums_close():
    told = json.loads(run("in-line-h2", "--json").stdout, parse_constant=pytest.fail)["result"]
    assert sum(row["flights"] for row in told["missions"]) == pytest.approx(told["flights"]) == 30_000
    assert told["fuel_kg"] == pytest.approx(sum(row["flights"] * row["fuel_kg"] for row in told["missions"]))
    assert sum(row["eats"] for row in told["missions"]) == pytest.approx(1.0)
    first, by_mission = told["parts"][0], told["damage_by_mission"]
    assert first["damage"] == told["damage"] == pytest.approx(30_000 / first["flights"])
    assert sum(by_mission["bearing of first.planet, rolling fatigue"].values()) == pytest.approx(told["damage"])


def test_a_mission_that_cannot_be_flown_is_placed_at_its_line(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('schema = 1\nname = "m"\n[missions.hard]\nmission = "regional-aircraft"\ncount = 9\n', "utf-8")
    with pytest.raises(DesignError, match=r"mine\.toml.*\n  line 3: missions\.hard: phases\.take-off"):
        run("in-line-h2", str(path), catch=False)
