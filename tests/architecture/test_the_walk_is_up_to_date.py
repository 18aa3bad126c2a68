"""docs/architecture.md names files and functions that there are, and every layer of the import law.

That its walks and rooms are those of today, `tests/documentation/test_site.py` asks of every made page.
"""

import ast
import importlib.util
import re
import sys
import tomllib
from pathlib import Path

import pytest
from sources import MODULES, tree

HOUSE = Path(__file__).parents[2]
TEXT = (HOUSE / "docs" / "architecture.md").read_text(encoding="utf-8").replace("\n", " ")
NAMED = sorted(set(re.findall(r"`([\w/]+\.py)(?:: (\w+))?", TEXT)))


def beside(name):
    """Return a script of the documentation's folder, which is no package."""
    spec = importlib.util.spec_from_file_location(f"docs_{name}", HOUSE / "docs" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


walks = beside("walks")


@pytest.mark.parametrize(("file", "name"), NAMED)
def test_a_file_and_a_function_that_the_page_names_are_there(file, name):
    if file.startswith(("docs/", "tests/")):
        assert (HOUSE / file).is_file()
        return
    assert file in MODULES
    known = {node.name for node in ast.walk(tree(MODULES[file])) if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    known |= {node.id for node in ast.walk(tree(MODULES[file])) if isinstance(node, ast.Name)}
    assert not name or name in known


def test_each_walk_has_five_to_nine_stations():
    """A turbine's power to a planet's mesh force, a module to S_H, an altitude to a bearing's life."""
    assert len(walks.WALKS) == 3 and all(5 <= len(walk.stations) <= 9 for walk in walks.WALKS)


def test_a_station_that_is_not_entered_is_told():
    walk = walks.Walk("nothing", lambda: None, frozenset({"power_flow"}))
    with pytest.raises(ValueError, match="nothing: entered in no module or in several: power_flow"):
        walks.entered(walk)


def test_every_layer_of_the_law_has_a_line_in_the_table():
    rules = tomllib.loads((HOUSE / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]
    law = next(rule for rule in rules if rule["name"].startswith("The import law"))
    layers = {name.strip().removeprefix("gearwright.") for line in law["layers"] for name in line.split("|")}
    told = set(re.findall(r"\| `(\w+)` \|", TEXT))
    assert layers - {"version", "verbs"} <= told
