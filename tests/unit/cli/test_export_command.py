"""The command that writes a sized design for other tools."""

import typing
import zipfile

import pytest
from typer.testing import CliRunner

import gearwright as gw
from designs import PAIR
from gearwright.cli import app
from gearwright.cli.commands.exchange import export as export_command
from gearwright.errors import DesignError
from gearwright.formats import FORMATS


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Return a folder with a design, in which commands run."""
    (tmp_path / "pair.toml").write_text(PAIR, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def export(*words):
    """Run the command; what it refuses is raised."""
    return CliRunner().invoke(app, ["export", *words], catch_exceptions=False)


def test_a_glb_file_is_written_beside_the_design(folder):
    answer = export("pair.toml", "--to", "glb")
    assert answer.exit_code == 0
    assert (folder / "pair-gearbox.glb").read_bytes()[:4] == b"glTF"
    assert "wrote pair-gearbox.glb: 75 bodies" in answer.output


def test_coarse_solids_make_a_smaller_file(folder):
    """Of its gears; housing and screws have the same triangles in both."""
    export("pair.toml", "--to", "glb", "--out", "fine.glb")
    export("pair.toml", "--to", "glb", "--detail", "coarse", "--out", "coarse.glb")
    assert (folder / "coarse.glb").stat().st_size < 0.75 * (folder / "fine.glb").stat().st_size


def test_the_sizing_is_written_as_a_value_that_is_loaded_again(folder):
    export("pair.toml", "--to", "json")
    assert gw.load("pair-gearbox.json").gears == gw.size(gw.read("pair.toml")).gears


def test_a_page_is_written(folder):
    export("pair.toml", "--to", "html", "--detail", "coarse")
    assert (folder / "pair-gearbox.html").read_text(encoding="utf-8").startswith("<!doctype html>")


@pytest.mark.parametrize(
    ("format_", "begins"), [("csv", b"\xef\xbb\xbftable,row,"), ("svg", b"<svg"), ("dxf", b"  0\n")]
)
def test_tables_and_the_general_arrangement_are_written(folder, format_, begins):
    assert export("pair.toml", "--to", format_).exit_code == 0
    assert (folder / f"pair-gearbox.{format_}").read_bytes().startswith(begins)


def test_without_xlsxwriter_the_workbook_is_refused_with_what_to_install(folder, monkeypatch):
    monkeypatch.setattr("gearwright.exchange.tables.find_spec", lambda name: None)
    with pytest.raises(DesignError, match=r"XlsxWriter.*pip install.*\[xlsx\].*or use csv"):
        export("pair.toml", "--to", "xlsx")


@pytest.mark.parametrize(("format_", "version"), [("rexs", b'version="1.7"'), ("rexs-1.6", b'version="1.6"')])
def test_a_rexs_file_is_written_and_what_is_not_in_it_is_said(folder, format_, version):
    answer = export("pair.toml", "--to", format_)
    assert "wrote pair-gearbox.rexs: REXS" in answer.output
    assert "rules of rating, sizing and dynamics" in answer.output
    assert version in (folder / "pair-gearbox.rexs").read_bytes()


@pytest.mark.parametrize("version", ["", "-3.0"])
def test_an_fmu_is_written_and_it_is_said_what_is_inside(folder, version):
    answer = export("pair.toml", "--to", f"fmu{version}", "--step", "1e-6")
    assert (folder / "pair-gearbox.fmu").read_bytes()[:2] == b"PK"
    assert f"FMI {version[1:] or '2.0'} co-simulation" in answer.output
    assert "steps of 1e-06 s" in answer.output


def test_a_window_of_a_mission_is_written_as_an_fmu_with_its_drives(folder):
    answer = export("in-line-h2", "--to", "fmu", "--mission", "thesis", "--window", "motor-cut")
    assert "wrote in-line-h2-gearbox.fmu: FMI 2.0 co-simulation" in answer.output
    with zipfile.ZipFile(folder / "in-line-h2-gearbox.fmu") as archive:
        described = archive.read("modelDescription.xml").decode()
    assert 'name="propeller.pitch"' in described and 'modelName="motor-cut"' in described


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("pair.toml", "--to", "gbl"), r"'gbl' is not written; did you mean glb"),
        (("pair.toml", "--to", "json", "--step", "1e-6"), r"--step: it is of fmu and fmu-3.0"),
        (("pair.toml", "--to", "csv", "--detail", "coarse"), r"--detail: it is of glb and html; leave it out with csv"),
        (("pair.toml", "--to", "fmu", "--window", "gust"), r"--window: --mission and --window belong together"),
        (
            ("pair.toml", "--to", "fmu", "--case", "rated", "--mission", "thesis", "--window", "gust"),
            r"or --case, or ne",
        ),
        (("in-line-h2", "--to", "fmu", "--mission", "thesis", "--window", "gusst"), r"gust"),
        (("pair.toml", "--to", "fmu", "--case", "cruse"), r"no case 'cruse'"),
        (("pair.toml", "--to", "glb", "--out", "no-folder/x.glb"), r"no-folder"),
        (("broken.toml", "--to", "glb"), r"turbine"),
    ],
)
def test_what_cannot_be_exported_is_refused_with_the_way_out(folder, words, said):
    (folder / "broken.toml").write_text(PAIR.replace('shaft = "fast"', 'shaft = "fst"'), encoding="utf-8")
    with pytest.raises(DesignError, match=said):
        export(*words)


def test_help_names_every_format_that_is_written():
    told = typing.get_type_hints(export_command, include_extras=True)["to"].__metadata__[0].help
    named = {word for part in told.split(";") for word in part.partition(":")[0].replace(" ", "").split(",")}
    assert named == set(FORMATS)


@pytest.mark.parametrize(
    ("to", "name", "said"),
    [
        ("html", "page.glb", "'page.glb' ends as glb does; write .html, or --to glb"),
        ("glb", "solids.STEP", "'solids.STEP' ends as step does; write .glb, or --to step"),
        ("fmu-3.0", "model.json", "'model.json' ends as json does; write .fmu, or --to json"),
    ],
)
def test_a_file_is_not_named_as_those_of_another_format(folder, to, name, said):
    with pytest.raises(DesignError) as refused:
        export("pair.toml", "--to", to, "--out", name)
    assert said in str(refused.value) and not (folder / name).exists()


def test_a_name_with_an_ending_of_ones_own_is_taken(folder):
    assert export("pair.toml", "--to", "json", "--out", "pair.2026").exit_code == 0
    assert (folder / "pair.2026").exists()
