"""What a layer derives on its way stays inside it: others read the fields of its results."""

import ast

from sources import MODULES, ROOT, breaking, tree

OF_SIZING = {
    "Context", "Demand", "arrange", "axes_of", "context_of", "demands_of", "given_of", "plan_of", "seats_of",
    "size_gears", "size_meshes", "size_shafts", "stage_sizes",
}  # fmt: skip
"""Names with which sizing derives what `Sizing` keeps."""


def imported_from(path, package):
    """Return every name that a file imports from a package or its rooms, and the rooms that it imports whole."""
    names = set()
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(package):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.Import):
            names |= {alias.name.rpartition(".")[2] for alias in node.names if alias.name.startswith(package)}
    return names


def test_no_other_layer_sizes_anew():
    others = {name: path for name, path in MODULES.items() if not name.startswith("sizing/")}
    assert breaking(lambda path: imported_from(path, "gearwright.sizing") & (OF_SIZING | {"context"}), others) == {}


def test_the_package_offers_no_way_to_size_in_parts():
    assert not imported_from(ROOT / "sizing" / "__init__.py", "gearwright.sizing") & OF_SIZING
