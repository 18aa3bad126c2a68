"""Which modules get faults, and which tests are concerned by a fault; all found by walking, none by a path."""

from __future__ import annotations

import ast
import importlib
import importlib.util
import json
import pkgutil
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path

from mutators import Fault

ROOT = "gearwright"
PACKAGES = ("gearwright.parts", "gearwright.train", "gearwright.sizing")
"""Packages whose modules all get faults."""
DYNAMICS = "gearwright.dynamics"
ASSEMBLY = "assemble"
"""Function of the dynamics whose module gets faults, with all modules of the dynamics that it imports."""
ALSO = ("error_sources",)
"""Functions of the dynamics whose modules get faults by themselves."""


def targets() -> list[str]:
    """Return the dotted names of the modules that get faults; compiled ones are left out."""
    names = {name for package in PACKAGES for name in _modules(package)}
    dynamics = list(_modules(DYNAMICS))
    home = {function: _home(dynamics, function) for function in (ASSEMBLY, *ALSO)}
    names |= _needed(home[ASSEMBLY]) | {home[function] for function in ALSO}
    return sorted(name for name in names if "from numba" not in source_of(name))


def _modules(package: str) -> Iterator[str]:
    for module in pkgutil.walk_packages(importlib.import_module(package).__path__, f"{package}."):
        if not module.ispkg:
            yield module.name


def _home(modules: Sequence[str], function: str) -> str:
    """Return the module that defines a function."""
    return next(name for name in modules if f"\ndef {function}(" in source_of(name))


def _needed(module: str) -> set[str]:
    """Return a module of the dynamics and what it imports of them, directly or not."""
    known, new = set[str](), {module}
    while new:
        known |= new
        trees = [ast.parse(source_of(name)) for name in new]
        imports = {node.module or "" for tree in trees for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        new = {name for name in imports if name.startswith(f"{DYNAMICS}.")} - known
    return known


def source_of(module: str) -> str:
    """Return the text of a module."""
    return Path(str(importlib.util.find_spec(module).origin)).read_text(encoding="utf-8")  # type: ignore[union-attr]


@dataclass(frozen=True)
class Calls:
    """Which test calls which functions, written ``file:qualified name``."""

    seconds: Mapping[str, float]
    """Test -> how long it took."""
    tests: Mapping[str, Sequence[str]]
    """Function -> its tests; those first that call little else and are quick."""
    readers: Mapping[str, set[str]]
    """Name -> functions of the package whose text has it."""

    @classmethod
    def read(cls, path: Path, slowest: float) -> Calls:
        """Read the recorder's file.

        Args:
            path: Of the file.
            slowest: Tests that took longer are left out [s].
        """
        record = {test: own for test, own in json.loads(path.read_text()).items() if own["seconds"] <= slowest}
        tests: dict[str, list[str]] = {}
        for test in sorted(record, key=lambda test: (record[test]["seconds"] + 0.05) * len(record[test]["calls"])):
            for function in record[test]["calls"]:
                tests.setdefault(function, []).append(test)
        return cls({test: own["seconds"] for test, own in record.items()}, tests, _readers())

    def concerned(self, fault: Fault, budget: float) -> list[str]:
        """Return the tests that call the faulty function, or a reader of the faulty constant or class.

        Args:
            fault: That they may notice.
            budget: Time that all of them may take together [s]; the most telling ones come first.
        """
        file = f"{fault.module.removeprefix(f'{ROOT}.').replace('.', '/')}.py"
        own = [name for name in self.tests if name == f"{file}:{fault.function}" or name.startswith(f"{file}:{fault.function}.")]
        if fault.function == "<module>" or fault.function in self.readers and fault.function.strip("_")[:1].isupper():
            # A constant, or the default of a field.
            own = sorted(self.readers.get(fault.name or fault.function, set()))
        if not any(name in self.tests for name in own):
            own = [name for name in self.tests if name.startswith(f"{file}:")]
        rank = {test: place for name in own for place, test in enumerate(self.tests.get(name, ()))}
        tests = sorted(rank, key=rank.__getitem__)
        spent = accumulate(self.seconds[test] for test in tests)
        return [test for test, time in zip(tests, spent, strict=True) if time <= budget]


def _readers() -> dict[str, set[str]]:
    home = Path(importlib.import_module(ROOT).__path__[0])
    readers: dict[str, set[str]] = {}
    for path in home.rglob("*.py"):
        for function, node in _functions(ast.parse(path.read_text(encoding="utf-8")), ""):
            for part in ast.walk(node):
                name = getattr(part, "id", None) or getattr(part, "attr", None)
                if name:
                    readers.setdefault(name, set()).add(f"{path.relative_to(home).as_posix()}:{function}")
    return readers


def _functions(tree: ast.AST, prefix: str) -> Iterator[tuple[str, ast.AST]]:
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield f"{prefix}{node.name}", node
            yield from _functions(node, f"{prefix}{node.name}.")
