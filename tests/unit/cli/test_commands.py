"""Every command does its verb, speaks JSON where asked, and ends with a code that scripts can use."""

import json
import subprocess
import sys
from types import SimpleNamespace

import pytest

from designs import HYBRID, PAIR, changed
from gearwright import __version__
from gearwright.cli import app, main
from gearwright.errors import SolveError
from gearwright.shipped import (
    shipped_design,
    shipped_designs,
    shipped_mission,
    shipped_missions,
    shipped_mixes,
    shipped_notebooks,
    shipped_studies,
    shipped_study,
)

DONE, FAILED, WRONG = 0, 1, 2


@pytest.fixture
def call(monkeypatch, capsys, tmp_path):
    """Run the command line in an empty folder; gives code, out and err."""
    monkeypatch.chdir(tmp_path)

    def run(*words):
        monkeypatch.setattr(sys, "argv", ["gearwright", *map(str, words)])
        with pytest.raises(SystemExit) as ended:
            main()
        printed = capsys.readouterr()
        return SimpleNamespace(code=ended.value.code or 0, out=printed.out, err=printed.err)

    return run


@pytest.fixture
def design(tmp_path):
    """A conventional pair in a file."""
    path = tmp_path / "design.toml"
    path.write_text(PAIR, encoding="utf-8")
    return path


def test_every_command_explains_itself(call):
    for command in app.registered_commands:
        name = command.name or command.callback.__name__
        done = call(name, "--help")
        assert done.code == DONE
        assert name in done.out


def test_help_lists_every_command_once_with_its_whole_first_sentence(call):
    listed = " ".join(call("--help").out.split())
    for command in app.registered_commands:
        if not command.hidden:
            sentence = " ".join(command.callback.__doc__.partition("\n\n")[0].split()).removesuffix(".")
            assert listed.count(f" {command.callback.__name__} {sentence}") == 1


def test_the_module_runs_as_a_command(tmp_path):
    """What the entry point of the package does: a code for the shell, nothing but the message on standard error."""
    done = subprocess.run(
        [sys.executable, "-c", "from gearwright.cli import main; main()", "check", "none.toml"],
        capture_output=True, text=True, check=False, cwd=tmp_path,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (WRONG, "")
    assert done.stderr.startswith("none.toml: 1 problem\n  there is no such file")
    assert "Traceback" not in done.stderr


def test_version(call):
    assert call("--version").out.strip() == f"gearwright {__version__}"


def headed(kind, path):
    """Return what `new` writes: the line for editors, which names the schema beside it, and the shipped file."""
    return f"#:schema ./gearwright-{kind}.schema.json\n".encode() + path.read_bytes()


def test_new_lists_and_copies_and_does_not_overwrite(call, tmp_path):
    listed = call("new")
    assert all(name in listed.out for name in shipped_designs())
    assert call("new", "in-line").code == DONE
    target = tmp_path / "in-line.toml"
    assert target.read_bytes() == headed("design", shipped_design("in-line"))
    beside = json.loads((tmp_path / "gearwright-design.schema.json").read_text(encoding="utf-8"))
    assert beside["$id"] == "urn:gearwright:file:design:1"
    target.write_text("mine", encoding="utf-8")
    refused = call("new", "in-line")
    assert refused.code == WRONG
    assert "the file is there already" in refused.err
    assert target.read_text(encoding="utf-8") == "mine"
    assert call("new", "in-line", "--force").code == DONE
    assert target.read_bytes() == headed("design", shipped_design("in-line"))


def test_new_lists_and_copies_missions_and_studies_too(call, tmp_path):
    """Under headings; every file is written as it is shipped, and told how it is used; names are unique."""
    listed = call("new").out.splitlines()
    titles = ["designs", "missions", "mixes", "studies", "notebooks"]
    assert [line for line in listed if line in titles] == titles
    names = [*shipped_designs(), *shipped_missions(), *shipped_mixes(), *shipped_studies(), *shipped_notebooks()]
    assert [line.split()[0] for line in listed if " " in line] == names
    assert len(set(names)) == len(names)
    assert "next: gearwright fly DESIGN thesis.toml" in call("new", "thesis").out
    assert (tmp_path / "thesis.toml").read_bytes() == headed("mission", shipped_mission("thesis"))
    assert "next: gearwright study motor-speed.toml" in call("new", "motor-speed").out
    assert (tmp_path / "motor-speed.toml").read_bytes() == headed("study", shipped_study("motor-speed"))
    assert "did you mean thesis?" in call("new", "thesiss").err


def test_new_names_the_nearest_design(call):
    refused = call("new", "inline-h2")
    assert refused.code == WRONG
    assert "did you mean in-line-h2?" in refused.err


def test_new_into_a_folder_that_is_not_there(call, tmp_path):
    refused = call("new", "in-line", tmp_path / "none" / "file.toml")
    assert refused.code == WRONG
    assert "No such file or directory" in refused.err


def test_check_says_that_all_is_well(call, design):
    done = call("check", design)
    assert done.code == DONE
    assert "one pair: no problems; 2 kinds of gears, 2 shafts" in done.out


def test_check_tells_what_the_dynamic_model_leaves_out_of_what_is_sized(call, design):
    """Kuang and Yang's fit ends at 50 teeth: peaks are not assessed then, and sizing is as it is."""
    design.write_text(f'{PAIR}[dynamics]\nmesh_stiffness = "kuang-yang"\n', encoding="utf-8")
    assert call("size", design).code == DONE
    done = call("check", design)
    assert (done.code, "no problems" in done.out) == (DONE, True)
    assert "not assessed, as the dynamic model ends there: dynamics.mesh_stiffness: stage:" in done.err


def test_check_names_every_problem_with_its_line(call, design):
    design.write_text(
        changed(changed(PAIR, "power_kw = 100", "power_kw = -1"), '"slow"\n', '"slov"\n'), encoding="utf-8"
    )
    done = call("check", design)
    assert done.code == WRONG
    assert f"{design}: 2 problems" in done.err
    assert "line 7: turbines.turbine.power_kw: -1 kW" in done.err
    assert done.out == ""


def test_what_only_sizing_sees_has_its_line_too(call, design):
    design.write_text(PAIR + "pinion_teeth = 20\nwheel_teeth = 40\n", encoding="utf-8")
    done = call("check", design)
    assert done.code == WRONG
    assert "line 10: propellers.propeller.speed: 2000 rpm is asked, but the teeth" in done.err


def test_a_shipped_design_is_known_by_its_name(call):
    assert call("check", "in-line").code == DONE


def test_a_folder_is_refused(call, tmp_path):
    assert "this is a folder" in call("check", tmp_path).err


def test_size_prints_tables_or_json(call, design):
    assert "pinion" in call("size", design).out
    done = call("size", design, "--json")
    assert done.code == DONE
    assert json.loads(done.out)["design"] == "one pair"


def test_modes_print_tables_or_json(call, design):
    assert call("modes", design).code == DONE
    assert json.loads(call("modes", design, "--json").out)


def test_an_unknown_case_is_refused(call, design):
    done = call("modes", design, "--case", "cruse")
    assert done.code == WRONG
    assert "cruse" in done.err


def test_simulate_writes_a_run_that_report_shows(call, tmp_path):
    path = tmp_path / "hybrid.toml"
    path.write_text(HYBRID, encoding="utf-8")
    done = call("simulate", path, "--duration", "0.001", "--stiffness", "constant", "--output", "run.nc", "--json")
    assert done.code == DONE
    assert json.loads(done.out)
    assert (tmp_path / "run.nc").stat().st_size > 0
    done = call("report", path, "--results", "run.nc", "--out", "page.html")
    assert done.code == DONE
    assert "<html" in (tmp_path / "page.html").read_text(encoding="utf-8")
    refused = call("report", "in-line", "--results", "run.nc")
    assert refused.code == WRONG
    assert "this is a run of another design" in refused.err


def test_reports_of_two_designs_do_not_meet(call, design, tmp_path):
    (tmp_path / "other.toml").write_text(PAIR.replace("one pair", "another"), encoding="utf-8")
    assert "wrote design-report.html" in call("report", design).out
    assert "wrote other-report.html" in call("report", "other.toml").out
    assert "<title>one pair" in (tmp_path / "design-report.html").read_text(encoding="utf-8")


def test_run_leaves_report_run_and_sizing(call, design, tmp_path):
    done = call("run", design, "--duration", "0.001", "--stiffness", "constant", "--out", "results")
    assert done.code == DONE
    assert {path.name for path in (tmp_path / "results").iterdir()} == {"report.html", "run.nc", "sizing.json"}
    assert json.loads((tmp_path / "results" / "sizing.json").read_text(encoding="utf-8"))["design"] == "one pair"


@pytest.mark.parametrize("duration", ["0", "-1", "nan", "inf", "soon"])
def test_a_time_that_is_none_is_refused(call, design, duration):
    assert call("simulate", design, "--duration", duration).code == WRONG


def test_schema_is_json(call):
    assert json.loads(call("schema").out)["title"] == "gearwright design"


def test_an_unknown_command_is_refused(call):
    assert call("weigh", "in-line").code == WRONG


def test_a_computation_that_fails_ends_with_one(call, monkeypatch, design):
    def fails(_):
        raise SolveError("line 'stage': gap 3 mm at t = 0.4 s")

    monkeypatch.setattr("gearwright.sizing.size", fails)
    done = call("check", design)
    assert done.code == FAILED
    assert done.err == "line 'stage': gap 3 mm at t = 0.4 s\n"


def test_a_word_that_is_no_choice_is_told_without_the_words_of_a_library(monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["gearwright", "size", "in-line-h2", "--level", "nonsense"])
    with pytest.raises(SystemExit) as end:
        main()
    told = capsys.readouterr().err
    assert end.value.code == 2
    assert "Invalid value for '--level': 'nonsense' is not one of 'concept', 'preliminary'" in told


def test_a_life_is_asked_of_a_sizing_that_knows_fatigue(call):
    """Of one that does not, it would have no effect."""
    done = call("size", "in-line", "--level", "preliminary", "--life-h", "20000")
    assert "limit 20000 h (ISO 281:2007)" in done.out
    refused = call("size", "in-line", "--life-h", "20000")
    assert refused.code != 0 and "service: has no effect without a rated part" in refused.err
