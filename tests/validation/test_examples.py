"""The examples of the documentation run and print what was published."""

import runpy
from pathlib import Path

import pytest

from gearwright.validate.planetary_sets import LIN_PARKER

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
