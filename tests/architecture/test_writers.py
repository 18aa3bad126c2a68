"""Every file that gearwright writes goes through `files`, which writes it whole or not at all."""

import ast
from pathlib import Path

from sources import MODULES, breaking, tree

WRITERS = {"write_text", "write_bytes", "mkdir", "touch", "saveas", "to_netcdf", "to_parquet", "tofile"}
"""Methods that write to a path."""
EITHER = {"savefig", "File", "write_table"}
"""Functions that take a path or a buffer."""
BUFFERS = {"buffer", "out", "image", "'r'"}
"""What they are given here: memory, or the wish to read only."""


def direct(path: Path) -> list[str]:
    """Return the calls of a file that write to a path by themselves."""
    calls = (node for node in ast.walk(tree(path)) if isinstance(node, ast.Call))
    return [ast.unparse(call) for call in calls if isinstance(call.func, ast.Attribute) and writes(call)]


def writes(call: ast.Call) -> bool:
    """Tell whether a call of a method writes to a path."""
    given = {ast.unparse(part) for part in [*call.args, *(keyword.value for keyword in call.keywords)]}
    match call.func.attr:
        case "open" | "fdopen":
            return any(part[0] in "'\"" and set(part) & set("wax+") for part in given)
        case name:
            return name in WRITERS or (name in EITHER and not given & BUFFERS)


def test_no_module_writes_a_file_by_itself():
    assert list(breaking(direct)) == ["files.py"]


def test_a_call_that_writes_is_seen():
    assert len(direct(MODULES["files.py"])) >= 3
