"""The command ``duty``, called as its users call it."""

import json
import tomllib
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

import gearwright as gw
from gearwright.cli.commands.flights import duty
from gearwright.errors import DesignError

APP = typer.Typer()
APP.command()(duty)
BENCH = "time_s,torque_nm,speed_rpm,temperature_c\n0,100,600,20\n10,-200,600,30\n30,0,0,40\n60,0,0,40\n"


@pytest.fixture
def bench(tmp_path):
    """Return the path of a record."""
    path = tmp_path / "bench.csv"
    path.write_text(BENCH, encoding="utf-8")
    return str(path)


def run(*arguments, catch=True):
    """Return what a call gives."""
    return CliRunner().invoke(APP, list(arguments), catch_exceptions=catch)


def test_it_tells_the_rule_and_what_is_not_used(bench):
    shown = run(bench)
    assert shown.exit_code == 0
    for words in ("upper end", "ISO 6336-6", "are not used", "Torque changes its sign", "[spectra.measured]"):
        assert words in shown.output


def test_its_lines_are_toml_that_a_design_reads(bench, tmp_path):
    name = next(name for name, machine in gw.read("single-planetary").machines.items() if machine.drives)
    out = tmp_path / "measured.toml"
    assert run(bench, "--machine", name, "--name", "bench", "--classes", "50", "--out", str(out)).exit_code == 0
    text = Path(gw.shipped_design("single-planetary")).read_text(encoding="utf-8") + "\n" + out.read_text("utf-8")
    design = gw.parse(text)
    assert design.cases["bench"].duration == 60.0 and "bench" in gw.size(design).flows


def test_json_and_screen_have_the_same_lines(bench):
    answer = json.loads(run(bench, "--json").stdout)["result"]
    assert answer["text"].strip() in run(bench).output
    assert tomllib.loads(answer["text"])["cases"]["measured"]["MACHINE"]["torque_nm"] == 200.0
    assert sum(row["time_s"] for row in answer["classes"]) == pytest.approx(answer["duration_s"]) == 60.0
    assert sum(row["turns"] for row in answer["classes"]) == pytest.approx(300.0)
    assert answer["work_kwh"] == pytest.approx((100.0 * 10.0 - 200.0 * 20.0) * 62.83185307 / 3.6e6)


def test_a_file_that_is_not_there_is_told():
    with pytest.raises(DesignError, match="there is no such file"):
        run("nowhere.csv", catch=False)
