"""Twins of modules: the same source, whose numbers may be lanes.

A twin is compiled from the source of its module with other names for a few built-in functions and for `math`, `cmath`
and `numpy`, so that a formula stands once and is computed for one design or for a batch of them.
"""

from __future__ import annotations

import ast
import importlib
import importlib.util
import sys
import zlib
from collections.abc import Callable, Iterable
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, SourceFileLoader
from pathlib import Path
from types import ModuleType
from typing import Any

PREFIX = "gearwright_lanes"
"""Package under which twins stand beside their modules."""
TWINNED = (
    "parts", "machines", "train", "sizing", "checks", "elementwise", "spec.checks", "spec.design.teeth",
    "catalogue.bearing_choice",
)  # fmt: skip
"""What is computed with lanes; what only holds values is shared."""
_CALLS = {"float", "int", "bool", "complex", "min", "max", "sum", "isinstance"}
_KINDS = {"Enum", "StrEnum", "IntEnum"}
_MODULES = {"math": "functions", "cmath": "complexes"}


def is_twinned(name: str) -> bool:
    """Tell whether a module has a twin.

    Args:
        name: Of a module.
    """
    return any(name == f"gearwright.{part}" or name.startswith(f"gearwright.{part}.") for part in TWINNED)


def twin_name(name: str) -> str:
    """Return the name of a module's twin.

    Args:
        name: Of the module.
    """
    return f"{PREFIX}{name.removeprefix('gearwright')}"


def twin(name: str) -> Any:
    """Return the twin of a module.

    Args:
        name: Of the module, such as ``gearwright.sizing.size``.
    """
    if not any(isinstance(finder, _Finder) for finder in sys.meta_path):
        sys.meta_path.insert(0, _Finder())
    return importlib.import_module(twin_name(name))


Change = Callable[[ModuleType], None]
_CHANGES: dict[str, list[Change]] = {}
"""Module -> what is changed in its twin once it is loaded."""


def change_twins(changes: Iterable[tuple[str, Change]]) -> None:
    """Change twins once they are loaded.

    Args:
        changes: Module, and what is changed in its twin; a module may have several.
    """
    for name, change in changes:
        _CHANGES.setdefault(name, []).append(change)


class _Twinned(ast.NodeTransformer):
    """Gives a source the other names."""

    def __init__(self, module: str) -> None:
        self.module = module

    def visit_ClassDef(self, node: ast.ClassDef) -> Any:
        """Leave kinds as they are: what a design says is one of them."""
        if any(isinstance(base, ast.Name) and base.id in _KINDS for base in node.bases):
            return ast.copy_location(ast.ImportFrom(self.module, [ast.alias(node.name)], 0), node)
        return self.generic_visit(node)

    def visit_Import(self, node: ast.Import) -> Any:
        """Replace modules of numbers."""
        made: list[ast.stmt] = []
        for alias in node.names:
            if alias.name in _MODULES:
                made.append(_from("gearwright.lanes", _MODULES[alias.name], alias.asname or alias.name))
            elif alias.name == "numpy":
                made.append(_from("gearwright.lanes.numeric", "numpy", alias.asname or alias.name))
            else:
                made.append(ast.Import([alias]))
        return [ast.copy_location(ast.fix_missing_locations(entry), node) for entry in made]

    def visit_ImportFrom(self, node: ast.ImportFrom) -> Any:
        """Import from twins, and from modules of numbers that know lanes."""
        if node.module is not None and is_twinned(node.module):
            node.module = twin_name(node.module)
        elif node.module in _MODULES:
            node.module = f"gearwright.lanes.{_MODULES[node.module]}"
        elif node.level == 0 and node.module is not None and node.module.split(".")[0] == "gearwright":
            return [ast.copy_location(_owned(node.module, alias), node) for alias in node.names]
        elif node.module == "functools" and any(alias.name in ("cache", "lru_cache") for alias in node.names):
            own = [alias for alias in node.names if alias.name in ("cache", "lru_cache")]
            rest = [alias for alias in node.names if alias not in own]
            made: list[ast.stmt] = [ast.ImportFrom("gearwright.lanes.builtin", own, 0)]
            made += [ast.ImportFrom("functools", rest, 0)] if rest else []
            return [ast.copy_location(entry, node) for entry in made]
        return node

    def visit_Call(self, node: ast.Call) -> Any:
        """Replace built-in functions where they are called."""
        self.generic_visit(node)
        if isinstance(node.func, ast.Name) and node.func.id in _CALLS:
            node.func = ast.copy_location(ast.Name(f"_lanes_{node.func.id}", ast.Load()), node.func)
        return node


def _owned(module: str, alias: ast.alias) -> ast.stmt:
    """Return the assignment of a name of a shared module, which may come from one that has a twin."""
    call = ast.Call(ast.Name("_lanes_owned", ast.Load()), [ast.Constant(module), ast.Constant(alias.name)], [])
    return ast.fix_missing_locations(ast.Assign([ast.Name(alias.asname or alias.name, ast.Store())], call, lineno=1))


def owned(module: str, name: str) -> Any:
    """Return what a module calls by a name, the twin's own where its home has a twin.

    Args:
        module: That shows it.
        name: Of it.
    """
    shown = importlib.import_module(module)
    if not hasattr(shown, name):
        return importlib.import_module(f"{module}.{name}")
    found = getattr(shown, name)
    home = getattr(found, "__module__", None)
    if isinstance(home, str) and is_twinned(home) and callable(found):
        return getattr(twin(home), found.__name__, found)
    return found


def _from(module: str, name: str, asname: str) -> ast.stmt:
    return ast.ImportFrom(module, [ast.alias(name, asname)], 0)


class _Loader(SourceFileLoader):
    """Compiles twins, and keeps what it compiled beside the bytecode of the modules."""

    def source_to_code(self, data: Any, path: Any, *, _optimize: int = -1) -> Any:  # type: ignore[override]
        """Return the code of a source with other names."""
        tree = _Twinned(self.name.replace(PREFIX, "gearwright", 1)).visit(ast.parse(data, path))
        names = [ast.alias(f"{name}_", f"_lanes_{name}") for name in sorted(_CALLS)]
        start = next(
            k for k, node in enumerate(tree.body)
            if not (isinstance(node, ast.Expr) or (isinstance(node, ast.ImportFrom) and node.module == "__future__"))
        )  # fmt: skip
        own = ast.ImportFrom("gearwright.lanes.twins", [ast.alias("owned", "_lanes_owned")], 0)
        tree.body[start:start] = [ast.ImportFrom("gearwright.lanes.builtin", names, 0), own]
        ast.fix_missing_locations(tree)
        return compile(tree, path, "exec", dont_inherit=True, optimize=_optimize)

    def get_data(self, path: str) -> bytes:
        """Return what a file holds, of bytecode that of the twin."""
        return super().get_data(_kept(path))

    def set_data(self, path: str, data: Any, *, _mode: int = 0o666) -> None:
        """Keep bytecode as that of the twin."""
        super().set_data(_kept(path), data, _mode=_mode)

    def exec_module(self, module: ModuleType) -> None:
        """Run the code, then change what the twin does otherwise."""
        super().exec_module(module)
        for change in _CHANGES.get(module.__name__.replace(PREFIX, "gearwright", 1), ()):
            change(module)


_MADE_BY = f"{zlib.crc32(Path(__file__).read_bytes()):08x}"
"""Which version of this module compiled a twin."""


def _kept(path: str) -> str:
    return f"{path.removesuffix('.pyc')}.lanes-{_MADE_BY}.pyc" if path.endswith(".pyc") else path


class _Finder(MetaPathFinder):
    """Finds twins."""

    def find_spec(self, fullname: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        """Return how a twin is loaded."""
        if fullname.split(".")[0] != PREFIX:
            return None
        name = fullname.replace(PREFIX, "gearwright", 1)
        inside = name.removeprefix("gearwright").removeprefix(".")
        if not is_twinned(name) and not any(part.startswith(inside) for part in TWINNED):
            return None
        if not is_twinned(name):  # a package that only holds twins
            spec = ModuleSpec(fullname, None, is_package=True)
            spec.submodule_search_locations = []
            return spec
        found = importlib.util.find_spec(name)
        assert found is not None and found.origin is not None
        spec = ModuleSpec(fullname, _Loader(fullname, found.origin), origin=found.origin)
        spec.has_location = True
        if found.submodule_search_locations is not None:
            spec.submodule_search_locations = list(found.submodule_search_locations)
        return spec
