"""Every command's JSON is one envelope, valid against its schema, with a unit in the key of every quantity."""

import json
import re
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from designs import HYBRID, PAIR
from gearwright import __version__
from gearwright.cli import app, main
from gearwright.cli.answers import ANSWERS, answer_schema, schema_id
from gearwright.render.answers.schema import plain
from gearwright.shipped import shipped_designs, shipped_mission
from json_schema import faults

STUDY = """\
schema = 1
name = "fills of a carrier"
designs = ["hybrid.toml"]
results = ["mass", "power_density", "worst_margin"]
[axes]
"carriers.fill" = {from = 0.4, to = 0.8}
[sampling]
method = "sobol"
count = 4
"""
MISSION = (
    shipped_mission("thesis").read_text(encoding="utf-8")
    + """
[windows.cut]
phase = "cruise"
at_min = 10
event = "motor-cut"
event_at_s = 0.2
duration_s = 0.5
"""
)
DUTY = "time_s,torque_nm,speed_rpm\n0,10,100\n1,20,100\n2,0,0\n"
SHORT = "--duration 0.001 --stiffness constant"
LINES = {
    "new": "new",
    "run": f"run hybrid.toml {SHORT}",
    "check": "check hybrid.toml",
    "size": "size hybrid.toml",
    "close": "close pair.toml --crossings",
    "arrange": "arrange pair.toml",
    "architectures": "architectures pair.toml --stages 1 --close 0 --workers 0",
    "optimise": "optimise hybrid.toml --free carriers.fill=0.4..0.8 --screened 0 --evaluations 24 --workers 0",
    "review": "review hybrid.toml",
    "modes": "modes hybrid.toml",
    "simulate": f"simulate hybrid.toml {SHORT}",
    "campbell": "campbell pair.toml",
    "response": "response hybrid.toml",
    "runup": "runup pair.toml --speeds 2",
    "sharing": "sharing face-gear-split-torque --target 55/45",
    "fly": "fly in-line-h2 thesis --life-h 2000",
    "mix": "mix in-line-h2 regional-life",
    "propeller": "propeller --ratios 0:2:0.5 --angles-deg 0:40:10 --rpm 1212 --blade-angle-deg 30",
    "turboshaft": "turboshaft --power-kw 835 --fuel-kg-kwh 0.35 --air-flow-kg-s 3.6 --pressure-ratio 9 --n1-rpm 43000"
    " --altitudes-m 0:3000:3000 --machs 0:0.3:0.3 --slam-kw 300:400 --slam-s 0.5",
    "rotor": "rotor --mass-kg 1600 --diameter-m 10 --rpm 406 --solidity 0.057 --speeds-m-s 0:60:20",
    "duty": "duty duty.csv",
    "window": "window in-line-h2 short.toml cut",
    "compare": "compare in-line star",
    "compare closed": "compare pair.toml --life-h 300",
    "study": "study small.toml --workers 0",
    "study reduced": "study reduced.toml --workers 0",
    "resume": "resume journal --workers 0",
    "status": "status journal",
    "mass": "mass --power-kw 2051 --engine-rpm 20204 --propeller-rpm 1212 --design in-line-h2",
    "engines": "engines --series PW100",
    "validate": "validate Timoshenko",
    "replay colibri": "replay colibri --part shaft-1",
}
WITH_LINES = [command for command, (_, row) in ANSWERS.items() if row]


@pytest.fixture
def call(monkeypatch, capsys, tmp_path):
    """Run the command line in a folder with designs, a mission and a study; gives code, out, err, new files."""
    monkeypatch.chdir(tmp_path)
    files = {
        "pair.toml": PAIR,
        "hybrid.toml": HYBRID,
        "small.toml": STUDY,
        "reduced.toml": f"{STUDY}\n[reduced]\n",
        "short.toml": MISSION,
        "duty.csv": DUTY,
    }
    for name, text in files.items():
        Path(name).write_text(text, encoding="utf-8")

    def run(line):
        before = set(tmp_path.iterdir())
        monkeypatch.setattr(sys, "argv", ["gearwright", *line.split()])
        with pytest.raises(SystemExit) as ended:
            main()
        printed = capsys.readouterr()
        new = {path.name for path in set(tmp_path.iterdir()) - before}
        return SimpleNamespace(code=ended.value.code or 0, out=printed.out, err=printed.err, new=new)

    return run


def finished(call, command):
    if command in ("resume", "status"):
        assert call("study small.toml --workers 0 --journal journal").code == 0


@pytest.mark.parametrize("command", ANSWERS)
def test_the_json_of_a_command_fits_its_schema_and_leaves_no_file(call, command):
    finished(call, command)
    done = call(f"{LINES[command]} --json")
    failing = command == "review"  # in resonance, which is an answer
    assert (done.code, done.err, done.new) == (int(failing), "", set()), done.err
    answer = json.loads(done.out)
    assert list(answer) == ["schema", "version", "design", "command", "result"]
    assert (answer["schema"], answer["version"], answer["command"]) == (schema_id(command), __version__, command)
    assert faults(answer, answer_schema(command)) == []


@pytest.mark.parametrize("command", WITH_LINES)
def test_json_lines_are_the_envelope_and_then_a_row_a_line(call, command):
    finished(call, command)
    done = call(f"{LINES[command]} --jsonl")
    assert (done.code, done.err, done.new) == (0, "", set()), done.err
    head, *rows = map(json.loads, done.out.splitlines())
    schema = answer_schema(command)
    result = schema["$defs"][schema["properties"]["result"]["$ref"].rpartition("/")[2]]
    result["required"] = [key for key in result["required"] if key != "rows"]
    assert faults(head, schema) == []
    assert "rows" not in head["result"]
    assert rows
    for row in rows:
        assert faults(row, {**schema["rows"], "$defs": schema["$defs"]}) == []


@pytest.mark.parametrize("design", shipped_designs())
def test_the_size_of_every_shipped_design_fits_its_schema(call, design):
    answer = json.loads(call(f"size {design} --json").out)
    assert faults(answer, answer_schema("size")) == []


def test_every_command_that_knows_json_is_in_the_table_of_answers():
    """And what it takes is a mark, not a file."""
    knows = {
        entry.callback.__name__
        for entry in app.registered_commands
        if not entry.hidden and "json" in entry.callback.__wrapped__.__annotations__
    }
    assert knows == {command for command in ANSWERS if " " not in command}
    assert set(LINES) == set(ANSWERS)


def test_a_failing_check_answers_too_and_keeps_its_exit_code(call):
    weak = PAIR + '\n[overrides]\n"stage.module_mm" = 1.0\n'
    Path("weak.toml").write_text(weak, encoding="utf-8")
    done = call("check weak.toml --json")
    answer = json.loads(done.out)
    assert (done.code, done.err, answer["result"]["holds"]) == (1, "", False)
    assert answer["result"]["failing"]
    assert faults(answer, answer_schema("check")) == []


def test_what_is_not_finite_is_null():
    assert plain((1.0, float("inf"), float("nan")), "length") == [1000.0, None, None]


def quantities(schema):
    """Yield every key of a schema that has a unit."""
    for record in schema["$defs"].values():
        for key, entry in record["properties"].items():
            if entry.get("unit"):
                yield key, entry["unit"]


def test_every_key_of_a_quantity_ends_in_its_unit():
    """In the letters of the unit, as in design files: kW is kw, kg m² is kg_m2."""
    seen = 0
    for command in ANSWERS:
        for key, unit in quantities(answer_schema(command)):
            letters = re.sub(r"[^a-z0-9]", "", unit.replace("²", "2").replace("³", "3").replace("µ", "u").lower())
            letters = {"": "deg" if unit == "°" else "percent", "c": "degc", "mpa": "mpa"}.get(letters, letters)
            letters = "nmi" if unit == "NM" else letters
            assert key.replace("_", "").replace("sqrt", "").endswith(letters), (command, key, unit)
            seen += 1
    assert seen > 300


def test_the_schema_of_an_answer_says_what_every_key_means_and_where_it_comes_from(call):
    schema = json.loads(call("schema --answer size").out)
    assert schema["$id"] == schema_id("size")
    module = schema["$defs"]["GearSizing"]["properties"]["module_mm"]
    assert (module["unit"], module["description"]) == ("mm", "Normal module m_n.")
    assert schema["$defs"]["GearSizing"]["properties"]["pitch_diameter_mm"]["source"] == "ISO 21771:2007"


def test_a_command_without_json_has_no_schema_and_the_nearest_is_named(call):
    done = call("schema --answer sise")
    assert done.code == 2
    assert "did you mean size" in done.err
