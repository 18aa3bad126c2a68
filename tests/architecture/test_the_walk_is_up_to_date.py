"""docs/architecture.md names files and functions that there are, and every layer of the import law."""

import ast
import re
import tomllib
from pathlib import Path

import pytest
from sources import MODULES, tree

HOUSE = Path(__file__).parents[2]
TEXT = (HOUSE / "docs" / "architecture.md").read_text(encoding="utf-8").replace("\n", " ")
NAMED = sorted(set(re.findall(r"`([\w/]+\.py)(?:: (\w+))?", TEXT)))
WALK = TEXT[TEXT.index("## Three numbers") : TEXT.index("## Many designs at once")]


@pytest.mark.parametrize(("file", "name"), NAMED)
def test_a_file_and_a_function_that_the_page_names_are_there(file, name):
    if file.startswith(("docs/", "tests/")):
        assert (HOUSE / file).is_file()
        return
    assert file in MODULES
    known = {node.name for node in ast.walk(tree(MODULES[file])) if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    known |= {node.id for node in ast.walk(tree(MODULES[file])) if isinstance(node, ast.Name)}
    assert not name or name in known


def test_the_walk_of_three_numbers_names_where_each_is_computed():
    """A turbine's power to a planet's mesh force, a module to S_H, an altitude to a bearing's life: ten stations."""
    assert len(re.findall(r"`[\w/]+\.py", WALK)) >= 10


def test_every_layer_of_the_law_has_a_line_in_the_table():
    rules = tomllib.loads((HOUSE / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]
    law = next(rule for rule in rules if rule["name"].startswith("The import law"))
    layers = {name.strip().removeprefix("gearwright.") for line in law["layers"] for name in line.split("|")}
    told = set(re.findall(r"\| `(\w+)` \|", TEXT))
    assert layers - {"version", "verbs"} <= told
