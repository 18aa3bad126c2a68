"""A label is made from fields and never taken apart: who needs a stage, a row or a number has it as a field."""

import ast
import re

import pytest
from sources import MODULES, breaking, tree

TAKING_APART = {"startswith", "endswith", "partition", "rpartition", "split", "rsplit", "removeprefix", "removesuffix"}
"""Methods with which a text is taken apart."""
ALLOWED = {
    # The reader of files: what users write, and tables of data.
    "spec/": "design, mission and study files: paths, units in keys, names of shared gears",
    "catalogue/": "columns and printed digits of data files",
    "store.py": "files of runs and values",
    "cli/": "arguments of commands, and text on the screen",
    "app/": "requests, names of files, titles of the schema, lines of a design file",
    "former_names.py": "names of modules and classes in files",
    "formats.py": "versions in names of formats",
    "exchange/openmdao.py": "paths of a design file, as names of variables",
    "exchange/rexs/arrangement.py": "names of components in files of other tools",
    "exchange/rexs/files.py": "lines of JSON texts, how files of each form begin",
    "exchange/step.py": "packages in names of Open CASCADE's classes, name of a Python module",
    "study/tables.py": "numbers in the reason of a failed case",
    "study/cases.py": "paths that a study varies",
    "study/results.py": "names of results that a study asks for",
    "shipped/gallery.py": "heading of a notebook",
    "replays/colibri/report.py": "keys and digits of the report's own table",
    "replays/colibri/pages.py": "indices of printed symbols",
    "replays/colibri/replay.py": "headings of the report",
    "replays/pulvirenti/claims.py": "a maker's family of engines",
    "validate/cases.py": "author of a source",
    # Layout of text, markup.
    "render/grid.py": "what a spreadsheet takes for a formula",
    "render/terminal.py": "lines and words of a cell",
    "render/tables/sizing.py": "words of a source",
    "dynamics/vibration/critical_speeds.py": "lines of a message",
    "render/schematic.py": "lines of a caption",
    "render/style.py": "lines of a text, markup of SVG and templates",
    "render/vector/": "lines and symbols of a text, markup of SVG",
    "render/answers/": "docstrings and names of fields",
    "closure/": "paths of a design file, modes of checks",
    "render/words/design_file.py": "docstrings of records, paths of a design file",
    "render/pages/flight.py": "paths of a mission file",
    "render/pages/report.py": "anchors of a page",
    "render/diagrams.py": "keys of a design file",
    "render/drawings/entities.py": "subscripts of a text",
    "render/drawings/paper.py": "lines of a text",
    "render/pages/page.py": "markup of templates and formulas",
    # Names of fields, files, modules, addresses.
    "sizing/result.py": "names of fields",
    "lanes/twins.py": "names of Python modules",
    "dynamics/code_cache.py": "name of a Python module",
    "dynamics/codegen/generate.py": "a list of registers",
    "study/journal.py": "statements of SQL",
    "study/running.py": "parts of a study as a user names them",
    "study/workers.py": "names of loggers, addresses",
}
"""Room or module -> what text it takes apart, which is no label."""
NAMED_BY_HAND = re.compile(r"\.(sun|planet|ring|pinion|wheel|carrier)\b|sun-planet|planet-ring")
"""A piece of a label that `identity` makes."""


def taken_apart(module):
    """Return the calls of a module that take a text apart, and its use of regular expressions."""
    calls = [node for node in ast.walk(module) if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)]
    found = [ast.unparse(call) for call in calls if call.func.attr in TAKING_APART and not is_of_arrays(call)]
    imports = [node for node in ast.walk(module) if isinstance(node, ast.Import)]
    return found + [ast.unparse(node) for node in imports if any(alias.name == "re" for alias in node.names)]


def is_of_arrays(call):
    """Tell whether a call is one of numpy's."""
    return isinstance(call.func.value, ast.Name) and call.func.value.id == "np"


def made_by_hand(module):
    """Return the pieces of f-strings of a module that are pieces of a label."""
    joined = [node for node in ast.walk(module) if isinstance(node, ast.JoinedStr)]
    pieces = [piece.value for node in joined for piece in node.values if isinstance(piece, ast.Constant)]
    return [piece for piece in pieces if NAMED_BY_HAND.search(piece)]


def outside(rooms):
    """Return the modules that stand in none of some rooms."""
    return {name: path for name, path in MODULES.items() if not name.startswith(rooms)}


def test_no_label_is_taken_apart():
    assert breaking(lambda path: taken_apart(tree(path)), outside(tuple(ALLOWED))) == {}


def test_labels_of_gears_meshes_and_carriers_are_made_in_one_place():
    assert breaking(lambda path: made_by_hand(tree(path)), outside(("identity.py", "spec/"))) == {}


def test_what_is_allowed_is_needed():
    needed = breaking(lambda path: taken_apart(tree(path)))
    assert [room for room in ALLOWED if not any(name.startswith(room) for name in needed)] == []


@pytest.mark.parametrize("text", ['name.partition(".")', 'line.startswith(f"{row}-")', "label.split()[0]", "import re"])
def test_taking_apart_is_seen(text):
    assert taken_apart(ast.parse(text))


def test_a_label_by_hand_is_seen():
    assert made_by_hand(ast.parse('teeth[f"{stage}.sun"]')) and made_by_hand(ast.parse('f"{stage}.sun-planet-{k}"'))
    assert not made_by_hand(ast.parse('f"{path}.wheel_teeth"'))
