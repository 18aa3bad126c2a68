"""The command that reads a gearbox of another tool."""

import pytest
from typer.testing import CliRunner

import gearwright as gw
from gearwright.cli import app
from gearwright.errors import DesignError
from rexs_database import EXAMPLES
from shipped_work import sized


def import_(*words):
    """Run the command; what it refuses is raised."""
    return CliRunner().invoke(app, ["import", *map(str, words)], catch_exceptions=False)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_design_is_written_and_what_was_assumed_and_not_read_is_said(folder):
    answer = import_(EXAMPLES / "sew_3stage_1.0.rexs")
    assert "wrote sew_3stage_1.0.toml: REXS 1.0 of FVA Workbench 5.0.4" in answer.output
    assert "assumed:" in answer.output and "gears have no material" in answer.output
    assert "not read:" in answer.output and "rolling_bearing_with_catalog_geometry[32] and 4 more" in answer.output
    assert gw.read("sew_3stage_1.0.toml") == gw.from_rexs(EXAMPLES / "sew_3stage_1.0.rexs").design


def test_a_file_that_is_there_is_replaced_only_if_that_is_asked_for(folder):
    words = (EXAMPLES / "fva_planetary_1.1.rexs", "--out", "mine.toml")
    import_(*words)
    with pytest.raises(DesignError, match="--force"):
        import_(*words)
    assert import_(*words, "--force").exit_code == 0


def test_nothing_is_written_of_a_file_that_is_refused(folder):
    with pytest.raises(DesignError):
        import_(EXAMPLES / "fva_worm_1.4.rexs", "--out", "worm.toml")
    assert list(folder.iterdir()) == []


def test_safeties_that_the_file_states_are_printed_beside_ours(folder):
    (folder / "axle.rexs").write_bytes(gw.to_rexs(sized("e-axle")).content)
    first = next(mesh for mesh in sized("e-axle").meshes if mesh.name == "first").rating.pitting[0]
    said = f"first.pinion with first.wheel: S_H {first:.3f} by ISO 6336:2019, {first:.3f} here"
    assert said in import_("axle.rexs").output


FVA = (EXAMPLES / "fva_2stage_1.4.rexs").read_text(encoding="utf-8-sig")
HOUSING = """<model version="1.7" applicationId="x" applicationVersion="1" date="2026-01-01"><relations/>
<components><component id="1" type="gear_unit"/><component id="2" type="gear_casing"/></components></model>"""
WRONG = {
    "truncated": (FVA[:20_000], r"no whole XML file"),
    "empty": ("", r"no whole XML file"),
    "another version": (FVA.replace('version="1.4"', 'version="3.9"'), r"REXS 1.0 to 1.7 is read"),
    "entities": ('<!DOCTYPE x [<!ENTITY a "aa"><!ENTITY b "&a;&a;">]><model>&b;</model>', r"document type"),
    "a file from elsewhere": (
        '<!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/passwd">]><model>&a;</model>',
        r"document type",
    ),
    "a housing only": (HOUSING, r"no cylindrical, bevel or planetary stage"),
    "a missing unit": (FVA.replace(' unit="mm">4.5<', ">4.5<"), r"normal_module: has no unit; allowed: mm"),
    "a wrong unit": (FVA.replace('unit="mm">4.5<', 'unit="kg">4.5<'), r"normal_module: is in 'kg'; allowed: mm"),
    "no number": (FVA.replace('unit="mm">4.5<', 'unit="mm">nan<'), r"normal_module: is 'nan'; give a number"),
    "truncated JSON": ('{"model": {', r"no whole JSON file"),
    "JSON of another version": ('{"model": {"version": "3.9"}}', r"REXS 1.0 to 1.7 is read"),
    "a broken archive": ("PK\x03\x04", r"the archive cannot be unpacked"),
    "too much": ("<model>" + " " * 10_000_000, r"more than 10,000,000 bytes"),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_file_that_is_wrong_is_refused_with_what_to_do(folder, what):
    text, said = WRONG[what]
    (folder / "gearbox.rexs").write_text(text, encoding="utf-8")
    with pytest.raises(DesignError, match=said):
        import_("gearbox.rexs")
    assert not (folder / "gearbox.toml").exists()
