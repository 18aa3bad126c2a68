"""The commands campbell, response, runup and validate, as a shell calls them."""

import json
import re

import pytest
from typer.testing import CliRunner

from gearwright.cli import app
from gearwright.errors import DesignError


def run(*words):
    """Return what a command prints; what it raises, raises."""
    result = CliRunner().invoke(app, list(words), catch_exceptions=False)
    assert result.exit_code == 0
    return result.stdout


def test_campbell_prints_critical_speeds_and_assumptions_and_writes_the_figure(tmp_path):
    figure = tmp_path / "campbell.svg"
    text = run("campbell", "in-line-h2", "--figure", str(figure))
    assert "Critical speeds, case rated, cruise" in text and "Assumptions of the dynamic model" in text
    assert "in resonance" in text
    assert figure.read_text(encoding="utf-8").startswith("<svg")


def test_campbell_as_json_has_units_in_its_keys(tmp_path):
    answer = json.loads(run("campbell", "star", "--json", "--figure", str(tmp_path / "c.svg")))
    first = answer["result"]["cases"][0]["critical_speeds"][0]
    margin = {"separation_margin_percent", "limit_percent", "verdict"}
    assert set(first) == {"order", "mode", "frequency_hz", "speed_rpm", "dynamic_force_percent"} | margin
    assert (tmp_path / "c.svg").exists()


def test_response_prints_peaks_and_writes_the_figure(tmp_path):
    figure = tmp_path / "response.png"
    text = run("response", "off-set", "--mesh", "second.left", "--figure", str(figure))
    assert "Peaks" in text and "second.left" in text
    assert figure.read_bytes().startswith(b"\x89PNG")


def test_runup_prints_the_loudest_speeds_and_writes_the_waterfall(tmp_path):
    figure = tmp_path / "runup.svg"
    words = ("--speeds", "3", "--lowest", "0.9", "--highest", "1.1", "--line", "first.left", "--figure", str(figure))
    assert "first.left" in run("runup", "off-set", *words)
    assert figure.exists()


def test_validate_prints_case_source_and_verdict_and_chooses_by_words():
    rows = json.loads(run("validate", "Friswell", "--json"))["result"]["rows"]
    assert len(rows) == 71
    assert all(row["holds"] is True and "Friswell" in row["source"] for row in rows)
    assert all(row["error"] * row["expected"] == pytest.approx(row["got"] - row["expected"]) for row in rows)


def test_validate_fits_a_terminal_of_80_columns_and_breaks_no_number(monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    shown = run("validate", "planetary set")
    assert "Lin & Parker 1999, J. Vib. Acoust. 121, table 2" in shown
    assert max(len(line) for line in shown.splitlines()) <= 80
    for words in (
        r"11775\.3 +11775\.27 +-2\.9e-06 +Hz +planetary set, N = 3",
        r"0\.9296 +0\.9295744 +-2\.8e-05 +√\(k_p/m_p\)",
    ):
        assert re.search(words, shown)
    assert shown.rstrip().endswith("published numbers come out within their tolerance.")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("campbell", "in-line-h2", "--case", "climb"), "no case 'climb'"),
        (("campbell", "in-line-h2", "--figure", "campbell.doc"), "is not drawn"),
        (("response", "in-line-h2", "--mesh", "third"), "no mesh 'third'"),
        (("runup", "off-set", "--line", "nothing"), "no such line"),
        (("validate", "nobody"), "no case or source contains 'nobody'"),
    ],
)
def test_a_call_that_is_wrong_says_so(words, message):
    with pytest.raises(DesignError, match=message):
        CliRunner().invoke(app, list(words), catch_exceptions=False)


def test_a_figure_that_cannot_be_drawn_is_refused_before_anything_is_computed(monkeypatch, tmp_path):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    monkeypatch.setattr("gearwright.sizing.size", lambda *_: pytest.fail("it was computed"))
    for name, words in (("a.png", r"PNG needs matplotlib.*\[png\]"), ("a.pdf", r"end the name with \.svg or \.png")):
        with pytest.raises(DesignError, match=words):
            run("campbell", "star", "--figure", str(tmp_path / name))
