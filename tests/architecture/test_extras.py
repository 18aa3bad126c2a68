"""What only an extra makes run is run: its tests carry a mark, and the checks ask for it with every extra there."""

import ast
import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_the_checks_install_every_extra_and_run_what_needs_one():
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    lines = (ROOT / ".ci" / "run").read_text(encoding="utf-8").splitlines()
    installed = [set(match[1].split(",")) for match in (re.search(r'-e "\.\[(.+)\]"', line) for line in lines) if match]
    assert set(extras) in installed
    assert any("pytest" in line and "--extras" in line for line in lines)


def test_no_test_skips_for_want_of_a_module_without_the_mark():
    """A skip of its own is one that no check undoes."""
    for path in (ROOT / "tests").rglob("test_*.py"):
        names = {node.attr for node in ast.walk(ast.parse(path.read_text("utf-8"))) if isinstance(node, ast.Attribute)}
        assert "importorskip" not in names, path
