"""The notebooks run from the first cell to the last, and what each cell ends with can be shown.

They are notebook files of the package; nothing of Jupyter's is needed to run them.
"""

from __future__ import annotations

import importlib.util
import json
import sys
from pathlib import Path

import pytest

import gearwright as gw
from gearwright.shipped import shipped_notebook, shipped_notebooks

DOCS = Path(__file__).parents[2] / "docs"
NOTEBOOKS = [shipped_notebook(name) for name in shipped_notebooks()]


@pytest.fixture(scope="module")
def gallery():
    spec = importlib.util.spec_from_file_location("docs_gallery", DOCS / "gallery.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_from_top_to_bottom_and_is_a_page_with_what_it_shows(notebook, gallery):
    run = gallery.executed(notebook)
    values = [cell.value for cell in run if cell.value is not None]
    assert len(values) >= 3
    text, shown = gallery.page(notebook, run)
    assert sum("<svg" in html for html in shown) >= 2
    assert all(len(repr(value)) < 1000 for value in values)
    assert text.startswith("# ") and text.count("```python") == sum(cell.is_code for cell in run)
    assert all(text.count(gallery.mark(place)) == 1 for place in range(len(shown)))


def test_there_is_one_for_each_kind_of_user():
    """An engineer of preliminary design, a researcher, a student."""
    assert len(NOTEBOOKS) == 5
    for notebook in NOTEBOOKS:
        first, *_ = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
        assert any(line.startswith("For ") for line in first["source"])


def test_one_is_written_as_it_is_shipped_not_run_and_leaves_what_is_there(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name, title in gw.notebook().items():
        written = gw.notebook(name)
        book = json.loads(written.read_text(encoding="utf-8"))
        assert written == Path(f"{name}.ipynb") and book["cells"][0]["source"][0] == f"# {title}\n"
        assert (book["nbformat"], book["nbformat_minor"]) == (4, 5)
        assert len({cell["id"] for cell in book["cells"]}) == len(book["cells"])
        code = [cell for cell in book["cells"] if cell["cell_type"] == "code"]
        assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in code)
    Path("mine.ipynb").write_text("mine", encoding="utf-8")
    with pytest.raises(gw.DesignError, match=r"there already; .*replace=True"):
        gw.notebook("a-measured-duty", "mine.ipynb")
    assert Path("mine.ipynb").read_text(encoding="utf-8") == "mine"
    assert gw.notebook("a-measured-duty", "mine.ipynb", replace=True).stat().st_size > 1000
    with pytest.raises(gw.DesignError, match="did you mean a-measured-duty"):
        gw.notebook("a_measured_duty", "other.ipynb")
    assert not Path("other.ipynb").exists()


def test_a_cell_that_fails_is_noticed(gallery):
    with pytest.raises(gw.DesignError):
        gallery.run(gallery.Cell(is_code=True, source="import gearwright as gw\ngw.read('nowhere.toml')"), {})


def test_the_readme_runs(tmp_path, monkeypatch, capsys):
    """Its Python, on the design that it writes."""
    monkeypatch.chdir(tmp_path)
    page = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    Path("mine.toml").write_bytes(gw.shipped_design("in-line-h2").read_bytes())
    names = {}
    exec(page.partition("```python\n")[2].partition("```")[0], names)
    assert names["sizing"] == gw.size(gw.read("in-line-h2"))
    assert "kg, teeth" in capsys.readouterr().out and Path("report.html").stat().st_size > 10_000
