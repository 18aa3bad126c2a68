"""The command ``window``: lists, flies, saves, draws."""

import json

from typer.testing import CliRunner

from gearwright.cli import app
from gearwright.shipped import shipped_mission
from gearwright.store import load

SHORT = '\n[windows.short]\nphase = "cruise"\nduration_s = 0.2\nevent = "motor-cut"\nevent_at_s = 0.1\n'


def run(*arguments):
    """Return what a command prints."""
    result = CliRunner().invoke(app, ["window", *arguments])
    assert result.exit_code == 0, result.output
    return result.output


def test_windows_of_a_mission_are_listed():
    assert "hybrid-to-turbine" in run("in-line-h2", "thesis")


def test_a_window_is_flown_saved_and_drawn(tmp_path):
    mission = tmp_path / "mission.toml"
    mission.write_text(shipped_mission("thesis").read_text(encoding="utf-8") + SHORT, encoding="utf-8")
    output, figure = tmp_path / "run.nc", tmp_path / "window.svg"
    words = run("in-line-h2", str(mission), "short", "--output", str(output), "--figure", str(figure))
    assert "motor-cut after 0.1 s" in words
    assert "The governor does not limit-cycle" in words
    assert "second.sun-planet, tangential" in words
    assert "output shaft" in words.partition("peak beside what it is sized for")[2]
    assert "propeller pitch" in load(output).trace.labels.drives
    assert figure.read_text(encoding="utf-8").startswith("<svg")


def test_a_window_is_printed_as_json(tmp_path):
    mission = tmp_path / "mission.toml"
    mission.write_text(shipped_mission("thesis").read_text(encoding="utf-8") + SHORT, encoding="utf-8")
    found = json.loads(run("in-line-h2", str(mission), "short", "--stiffness", "constant", "--json"))["result"]
    assert found["limit_cycle"] is None
    assert {row["name"] for row in found["ranges"]} >= {"propeller speed", "output shaft", "second.sun-planet-5"}
    assert {row["mesh"] for row in found["meshes"]} >= {"first.sun-planet", "second.planet-ring"}
    assert {row["shaft"] for row in found["shafts"]} == {"input", "intermediate", "output"}
