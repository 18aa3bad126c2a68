"""Every file that gearwright writes goes through `writing`, which writes it whole or not at all."""

import ast
from pathlib import Path

import pytest

SOURCE = Path(__file__).parents[2] / "src"
WRITERS = {"write_text", "write_bytes", "mkdir", "touch", "saveas", "to_netcdf", "to_parquet", "tofile"}
"""Methods that write to a path."""
EITHER = {"savefig", "File", "write_table"}
"""Functions that take a path or a buffer."""
BUFFERS = {"buffer", "out", "image", "'r'"}
"""What they are given here: memory, or the wish to read only."""


def direct(path: Path) -> list[str]:
    """Return the calls of a file that write to a path by themselves."""
    calls = (node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.Call))
    return [ast.unparse(call) for call in calls if isinstance(call.func, ast.Attribute) and writes(call)]


def writes(call: ast.Call) -> bool:
    """Tell whether a call of a method writes to a path."""
    given = {ast.unparse(part) for part in [*call.args, *(keyword.value for keyword in call.keywords)]}
    match call.func.attr:
        case "open" | "fdopen":
            return any(part[0] in "'\"" and set(part) & set("wax+") for part in given)
        case name:
            return name in WRITERS or (name in EITHER and not given & BUFFERS)


@pytest.mark.parametrize("path", sorted(SOURCE.rglob("*.py")), ids=lambda path: str(path.relative_to(SOURCE)))
def test_no_module_writes_a_file_by_itself(path):
    if path.name != "writing.py":
        assert direct(path) == []


def test_a_call_that_writes_is_seen():
    assert len(direct(SOURCE / "gearwright" / "writing.py")) >= 3
