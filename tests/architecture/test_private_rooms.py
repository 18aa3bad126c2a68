"""What a layer derives on its way stays inside it: others read the fields of its results."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2] / "src" / "gearwright"
OF_SIZING = {
    "Context", "Demand", "arrange", "axes_of", "context_of", "demands_of", "given_of", "plan_of", "seats_of",
    "size_gears", "size_meshes", "size_shafts", "stage_sizes",
}  # fmt: skip
"""Names with which sizing derives what `Sizing` keeps."""


def imported_from(path, package):
    """Return every name that a file imports from a package or its rooms, and the rooms that it imports whole."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(package):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.Import):
            names |= {alias.name.rpartition(".")[2] for alias in node.names if alias.name.startswith(package)}
    return names


OTHERS = sorted(path for path in ROOT.rglob("*.py") if path.parts[len(ROOT.parts)] != "sizing")


@pytest.mark.parametrize("path", OTHERS, ids=lambda path: str(path.relative_to(ROOT)))
def test_no_other_layer_sizes_anew(path):
    assert not imported_from(path, "gearwright.sizing") & (OF_SIZING | {"context"})


def test_the_package_offers_no_way_to_size_in_parts():
    assert not imported_from(ROOT / "sizing" / "__init__.py", "gearwright.sizing") & OF_SIZING
