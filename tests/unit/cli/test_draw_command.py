"""The command that draws."""

import os
import subprocess
import sys

from gearwright.cli import main


def run(monkeypatch, capsys, *words):
    """Return exit code and everything that the command writes."""
    monkeypatch.setattr("sys.argv", ["gearwright", "draw", *words])
    code = 0
    try:
        main()
    except SystemExit as end:
        code = int(end.code or 0)
    written = capsys.readouterr()
    return code, written.out + written.err


def test_sheets_are_written_in_the_formats_that_are_asked_for(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    code, text = run(monkeypatch, capsys, "off-set", "--what", "arrangement,shaft-left", "--format", "svg")
    assert code == 0 and "wrote 2 sheets as svg to off-set-drawings" in text
    assert sorted(path.name for path in (tmp_path / "off-set-drawings").iterdir()) == [
        "arrangement.svg",
        "shaft-left.svg",
    ]


def test_dxf_is_written_too(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    code, _ = run(monkeypatch, capsys, "off-set", "--what", "shaft-left", "--out", "made")
    assert code == 0 and {path.suffix for path in (tmp_path / "made").iterdir()} == {".svg", ".dxf"}


def test_every_process_writes_the_same_file(tmp_path):
    """Whatever the order of Python's sets."""
    start = "from gearwright.cli import main; main()"
    call = [sys.executable, "-c", start, "draw", "off-set", "--what", "shaft-left"]
    for seed in ("1", "2"):
        subprocess.run([*call, "--out", seed], cwd=tmp_path, env={**os.environ, "PYTHONHASHSEED": seed}, check=True)
    for name in ("shaft-left.dxf", "shaft-left.svg"):
        assert (tmp_path / "1" / name).read_bytes() == (tmp_path / "2" / name).read_bytes()


def test_without_ezdxf_svg_is_written_and_one_line_says_what_is_not(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    code, text = run(monkeypatch, capsys, "off-set", "--what", "shaft-left")
    assert code == 0 and text.count("DXF is not written") == 1 and "pip install ezdxf" in text
    assert [path.name for path in (tmp_path / "off-set-drawings").iterdir()] == ["shaft-left.svg"]


def test_without_ezdxf_dxf_alone_is_refused_and_leaves_nothing(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    code, text = run(monkeypatch, capsys, "off-set", "--what", "shaft-left", "--format", "dxf")
    assert code == 2 and "pip install ezdxf" in text
    assert list(tmp_path.iterdir()) == []


def test_a_form_or_sheet_that_there_is_not_is_named(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    code, text = run(monkeypatch, capsys, "off-set", "--format", "dwg")
    assert code == 2 and "'dwg' is not drawn; allowed: dxf, svg" in text
    code, text = run(monkeypatch, capsys, "off-set", "--format", "svg,pdf")
    assert code == 2 and "'pdf' is not drawn; allowed: dxf, svg; browsers print svg to PDF" in " ".join(text.split())
    code, text = run(monkeypatch, capsys, "off-set", "--what", "shaft-lift")
    assert code == 2 and "did you mean shaft-left?" in text
