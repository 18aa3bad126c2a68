"""The command ``fly``, called as its users call it."""

import json

import typer
from typer.testing import CliRunner

from gearwright.cli.mission import fly

APP = typer.Typer()
APP.command()(fly)


def run(*arguments):
    """Return what a call gives."""
    return CliRunner().invoke(APP, list(arguments))


def test_without_a_design_the_shipped_missions_are_listed():
    result = run()
    assert result.exit_code == 0
    assert "thesis" in result.output
    assert "regional-250nm" in result.output


def test_one_command_tells_fuel_charge_heat_and_the_part_that_fails_first(tmp_path):
    result = run("in-line-h2", "thesis", "--csv", str(tmp_path / "histories.csv"))
    assert result.exit_code == 0
    for word in ("Fuel", "State of charge", "Oil", "First to fail"):
        assert word in result.output
    assert (tmp_path / "histories.csv").read_text(encoding="utf-8").startswith("phase,")


def test_json_is_for_machines():
    result = run("in-line", "regional-250nm", "--json")
    assert json.loads(result.stdout)["balance"]["residual"] < 1e-6


def test_a_flight_with_gears_that_are_not_rated_says_why():
    result = run("face-gear-split-torque", "rotor-schedule")
    assert result.exit_code == 0
    assert "ISO 6336 rates cylindrical gears only" in result.output
    assert "First to fail: " in result.output


def test_a_life_is_bought_with_mass():
    result = run("in-line-h2", "thesis", "--life-h", "2000")
    assert "costs" in result.output


def test_one_command_writes_the_page_of_a_flight(tmp_path):
    page = tmp_path / "flight.html"
    result = run("in-line-h2", "thesis", "--report", str(page))
    assert result.exit_code == 0
    assert "First gear to fail: second.planet" in page.read_text(encoding="utf-8")
