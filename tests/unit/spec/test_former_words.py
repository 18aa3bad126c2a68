"""Words of earlier versions in files: still read, each with one sentence that says what is written now."""

from __future__ import annotations

import sys

import pytest

from gearwright import cli
from gearwright.errors import DesignError
from gearwright.spec import parse_mission, parse_study
from gearwright.spec.record import FORMER, FormerWord
from gearwright.spec.studies import Bound

STUDY = """name = "s"
designs = ["single-planetary"]
results = ["fly.least_charge"]
[objectives]
mass = "least"
power_density = "most"
[constraints]
worst_margin = {least = 0.5, most = 2.0}
[fly]
mission = "regional-250nm"
"""
TODAY = STUDY.replace("least_charge", "minimum_charge").replace("least", "minimum").replace("most", "maximum")
MISSION = """schema = 1
name = "m"
propeller_map = "none"
[battery]
energy_kwh = 10
{key} = 0.2
[phases.cruise]
altitude_m = 0
cas_kt = 100
duration_s = 60
power_kw = 100
propeller_speed_rpm = 1000
"""


def test_a_study_in_former_words_is_the_same_study() -> None:
    with pytest.warns(FormerWord):
        former = parse_study(STUDY)
    assert former == parse_study(TODAY)
    assert former.objectives == {"mass": "minimum", "power_density": "maximum"}
    assert former.constraints == {"worst_margin": Bound(minimum=0.5, maximum=2.0)}
    assert former.results == ["fly.minimum_charge"]


def test_each_former_word_is_told_with_its_place_and_the_word_of_today() -> None:
    with pytest.warns(FormerWord) as told:
        parse_study(STUDY)
    said = {str(warning.message) for warning in told}
    assert "constraints.worst_margin.least: 'least' is a word of an earlier version; write 'minimum'" in said
    assert "results: 'fly.least_charge' is a word of an earlier version; write 'fly.minimum_charge'" in said
    assert {word for word in FORMER if any(f"{word!r} is" in sentence for sentence in said)} == {
        "least", "most", "fly.least_charge"}  # fmt: skip


def test_a_battery_is_read_by_its_former_key() -> None:
    with pytest.warns(FormerWord, match=r"battery\.least_charge: 'least_charge' .*; write 'minimum_charge'"):
        former = parse_mission(MISSION.format(key="least_charge"))
    assert former == parse_mission(MISSION.format(key="minimum_charge"))


def test_a_path_into_a_mission_is_read_by_its_former_name() -> None:
    axis = '[axes]\n"mission.battery.least_charge" = {values = [0.1, 0.2]}\n'
    with pytest.warns(FormerWord, match=r"axes: 'mission\.battery\.least_charge'"):
        assert list(parse_study(TODAY + axis).axes) == ["mission.battery.minimum_charge"]


def test_a_former_word_beside_the_one_of_today_is_given_twice() -> None:
    both = TODAY.replace("minimum = 0.5", "minimum = 0.5, least = 0.5")
    with pytest.warns(FormerWord), pytest.raises(DesignError, match="minimum is given twice"):
        parse_study(both)


def test_a_word_of_no_version_is_refused_with_what_is_allowed() -> None:
    with pytest.raises(DesignError, match="'smallest' is not known; allowed: 'minimum' or 'maximum'"):
        parse_study(TODAY.replace('mass = "minimum"', 'mass = "smallest"'))


def test_a_terminal_shows_one_sentence_a_word_without_the_source(tmp_path, monkeypatch, capsys) -> None:
    (tmp_path / "s.toml").write_text(STUDY.replace('results = ["fly.least_charge"]\n', "").split("[fly]")[0])
    monkeypatch.setattr(sys, "argv", ["gearwright", "study", str(tmp_path / "s.toml")])
    monkeypatch.setattr("warnings.filters", [])
    monkeypatch.setattr("warnings.showwarning", None)
    with pytest.raises(SystemExit) as end:
        cli.main()
    out, err = capsys.readouterr()
    lines = err.splitlines()
    assert end.value.code == 0, (out, err)
    assert "objectives.mass: 'least' is a word of an earlier version; write 'minimum'" in lines
    assert not any("former.py" in line or "Warning" in line for line in lines)
