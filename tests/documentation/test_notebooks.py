"""The notebooks run from the first cell to the last, and what each cell ends with can be shown.

They are scripts in the percent format, which notebook editors open; nothing of theirs is needed to run them.
"""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import gearwright as gw

NOTEBOOKS = sorted((Path(__file__).parents[2] / "docs" / "notebooks").glob("*.py"))


def cells(text):
    """Yield the code cells."""
    for part in f"\n{text}".split("\n# %%")[1:]:
        if not part.startswith(" [markdown]"):
            yield part


def run(cell, names):
    """Run a cell and return the value that it ends with, as a notebook does."""
    tree = ast.parse(cell)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_from_top_to_bottom(notebook, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {"__name__": "__main__"}
    shown = [run(cell, names) for cell in cells(notebook.read_text(encoding="utf-8"))]
    values = [value for value in shown if value is not None]
    assert len(values) >= 3
    pages = [value._repr_html_() for value in values if hasattr(value, "_repr_html_")]
    assert sum("<svg" in page for page in pages) >= 2
    assert all(len(repr(value)) < 1000 for value in values)


def test_there_is_one_for_each_kind_of_user():
    """An engineer of preliminary design, a researcher, a student."""
    assert len(NOTEBOOKS) == 5
    for notebook in NOTEBOOKS:
        assert "\n# For " in notebook.read_text(encoding="utf-8")


def test_a_cell_that_fails_is_noticed():
    with pytest.raises(gw.DesignError):
        run("import gearwright as gw\ngw.read('nowhere.toml')", {})


def test_the_readme_runs(tmp_path, monkeypatch, capsys):
    """Its Python, on the design that it writes."""
    monkeypatch.chdir(tmp_path)
    page = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    Path("mine.toml").write_bytes(gw.shipped_design("in-line-h2").read_bytes())
    names = {}
    exec(page.partition("```python\n")[2].partition("```")[0], names)
    assert names["sizing"] == gw.size(gw.read("in-line-h2"))
    assert "kg, teeth" in capsys.readouterr().out and Path("report.html").stat().st_size > 10_000
