"""The commands ``engines`` and ``mass``."""

import json

import pytest
import typer
from typer.testing import CliRunner

from gearwright import complete_mass, read, size
from gearwright.cli.commands import flights as cli_weights
from gearwright.errors import DesignError

app = typer.Typer()
app.command()(cli_weights.engines)
app.command()(cli_weights.mass)

PW127 = ["mass", "--power-kw", "2051", "--engine-rpm", "20204", "--propeller-rpm", "1212"]


def run(*arguments):
    return CliRunner().invoke(app, list(arguments), env={"COLUMNS": "150"}, catch_exceptions=False)


def test_mass_shows_the_methods_side_by_side():
    result = run(*PW127)
    assert result.exit_code == 0
    assert "136.5 kg" in result.output
    assert "Taken from here on: 136.5 kg" in result.output


def test_mass_writes_a_report_and_prints_json(tmp_path, capsys):
    page = tmp_path / "out.html"
    app([*PW127, "--mass-kg", "190", "--origin", "weighed", "--report", str(page), "--json"], standalone_mode=False)
    assert "Table 1.15" in page.read_text(encoding="utf-8")
    assert json.loads(capsys.readouterr().out)["result"]["taken"]["mass_kg"] == 190.0


def test_a_mass_without_origin_and_an_origin_without_mass_are_refused():
    with pytest.raises(DesignError, match="needs its origin"):
        run(*PW127, "--mass-kg", "190")
    with pytest.raises(DesignError, match="add --mass-kg"):
        run(*PW127, "--origin", "weighed")


def test_the_mass_of_a_design_is_a_row_of_its_own():
    result = run(*PW127, "--design", "in-line-h2", "--json")
    found = json.loads(result.stdout)["result"]
    sizing = size(read("in-line-h2"))
    whole = complete_mass(sizing)
    assert found["bottom_up"]["mass_kg"] == pytest.approx(whole.total)
    assert f"gears, shafts and carriers {whole.train:.3g} kg" in found["bottom_up"]["origin"]
    assert found["taken"]["mass_kg"] == pytest.approx(136.5, abs=0.1)
    assert "This design" in run(*PW127, "--design", "in-line-h2").output


def test_engines_filters_and_sorts():
    result = run("engines", "--manufacturer", "GE", "--kind", "turboprop", "--sort", "power", "--json")
    assert result.exit_code == 0
    powers = [row["power_kw"] for row in json.loads(result.stdout)["result"]["rows"]]
    assert len(powers) == 27
    assert powers == sorted(powers)


def test_engines_writes_csv(tmp_path):
    path = tmp_path / "engines.csv"
    run("engines", "--min-power-kw", "3000", "--csv", str(path))
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) == 1 + 3
    assert lines[1].startswith("1.3,PW100,")


def test_a_design_states_power_and_speeds_itself():
    """What is given beside it wins; 20 000 rpm is that of its turbine, the power that of turbine and motor."""
    own = json.loads(run("mass", "--design", "in-line-h2", "--json").stdout)["result"]["requirement"]
    assert own["power_kw"] == pytest.approx(2051.0)
    assert own["engine_speed_rpm"] == pytest.approx(20000.0)
    assert own["propeller_speed_rpm"] == pytest.approx(1212.0, rel=0.01)
    more = json.loads(run("mass", "--design", "in-line-h2", "--power-kw", "3000", "--json").stdout)["result"]
    assert more["requirement"] == {**own, "power_kw": 3000.0, "beta": more["requirement"]["beta"]}


def test_without_a_design_what_is_left_out_is_told_at_once():
    with pytest.raises(DesignError) as told:
        run("mass", "--power-kw", "2051")
    assert [problem.path for problem in told.value.problems] == ["--engine-rpm", "--propeller-rpm"]
    assert "--design" in told.value.problems[0].message
