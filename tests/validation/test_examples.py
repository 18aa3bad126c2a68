"""The examples of the documentation run and print what was published."""

import csv
import re
import runpy
from pathlib import Path

import numpy as np
import pytest

import gearwright as gw
from gearwright.validate.trains import LIN_PARKER

EXAMPLES = Path(__file__).parents[2] / "docs" / "examples"


def test_ten_lines_reproduce_lin_and_parker(capsys):
    """Lin & Parker 1999, table 2: 5e-4 is its print rounding; translational modes come in pairs."""
    runpy.run_path(str(EXAMPLES / "lin_parker.py"))
    rows = {
        line.split()[0]: [float(word) for word in line.split()[1:]] for line in capsys.readouterr().out.splitlines()
    }
    assert rows["rotational"] == pytest.approx(LIN_PARKER[4]["rotational"], rel=5e-4)
    assert rows["translational"][::2] == pytest.approx(LIN_PARKER[4]["translational"], rel=5e-4)
    assert rows["planet"] == pytest.approx(LIN_PARKER[4]["planet"], rel=5e-4)


def test_a_mesh_with_backlash_jumps_and_its_page_is_written(capsys, monkeypatch, tmp_path):
    """Two forces at one speed below resonance; the jumps as docs/how-to/gear-dynamics.md prints them."""
    monkeypatch.setattr("sys.argv", ["backlash.py", str(tmp_path)])
    runpy.run_path(str(EXAMPLES / "backlash.py"), run_name="__main__")
    printed = capsys.readouterr().out.splitlines()
    told = (EXAMPLES.parent / "how-to" / "gear-dynamics.md").read_text(encoding="utf-8").splitlines()
    assert printed[0] in told
    first, wanted = (re.findall(r"[\d.]+", line) for line in (printed[1], told[told.index(printed[0]) + 1]))
    assert [float(word) for word in first] == pytest.approx([float(word) for word in wanted], abs=2.0)
    rows = list(csv.DictReader((tmp_path / "backlash.csv").read_text().splitlines()))
    up, down = (np.array([float(row[key]) for row in rows]) for key in ("up", "down"))
    assert np.all(down > 0.99 * up)
    assert any("chaotic" in note for note in gw.load(tmp_path / "backlash.nc").notes)
    assert "<svg" in (tmp_path / "backlash.html").read_text(encoding="utf-8")
