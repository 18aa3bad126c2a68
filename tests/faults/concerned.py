"""Which modules get faults, and which tests are concerned by a fault; all found by walking, none by a path."""

from __future__ import annotations

import ast
import importlib
import importlib.util
import json
import pkgutil
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import accumulate
from pathlib import Path

from mutators import Fault

ROOT = "gearwright"
TARGETS = (
    "gearwright.parts",
    "gearwright.train",
    "gearwright.sizing",
    "gearwright.dynamics.assembly",
    "gearwright.dynamics.model",
    "gearwright.dynamics.sharing.solutions",
)
"""Packages, whose modules all get faults, and modules."""


def targets() -> list[str]:
    """Return the dotted names of the modules that get faults; compiled ones are left out."""
    names = {name for target in TARGETS for name in _modules(target)}
    return sorted(name for name in names if "from numba" not in source_of(name))


def _modules(target: str) -> Iterator[str]:
    paths = getattr(importlib.import_module(target), "__path__", None)
    if paths is None:
        yield target
    for module in pkgutil.walk_packages(paths or [], f"{target}."):
        if not module.ispkg:
            yield module.name


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
    def read(cls, paths: Iterable[Path], slowest: float) -> Calls:
        """Read the recorder's files.

        Args:
            paths: Of the files; what a later one says of a test counts.
            slowest: Tests that took longer are left out [s].
        """
        whole = {test: own for path in paths for test, own in json.loads(path.read_text()).items()}
        record = {test: own for test, own in whole.items() if own["seconds"] <= slowest and _is_there(test)}
        tests: dict[str, list[str]] = {}
        for test in sorted(record, key=lambda test: (record[test]["seconds"] + 0.05) * len(record[test]["calls"])):
            for function in record[test]["calls"]:
                tests.setdefault(function, []).append(test)
        return cls({test: own["seconds"] for test, own in record.items()}, tests, _readers())

    def concerned(self, fault: Fault, budget: float) -> list[str]:
        """Return the tests that call the faulty function, or a reader of the faulty constant or class.

        Args:
            fault: That they may notice.
            budget: Time that all of them may take together [s]. First come those whose file imports from the faulty
                module or its room, then those that compare every number of a design with golden ones.
        """
        file = f"{fault.module.removeprefix(f'{ROOT}.').replace('.', '/')}.py"
        own = [
            name
            for name in self.tests
            if name == f"{file}:{fault.function}" or name.startswith(f"{file}:{fault.function}.")
        ]
        beside = [name for name in self.tests if name.startswith(f"{file}:")] if not own else []
        if fault.function == "<module>" or (fault.function in self.readers and fault.function.strip("_")[:1].isupper()):
            # A constant, or the default of a field: who reads it, and then who calls anything beside it.
            own = sorted(self.readers.get(fault.name or fault.function, set()))
            beside = [name for name in self.tests if name.startswith(f"{file}:")]
        rank: dict[str, tuple[int, int]] = {}
        for group, names in enumerate((own, beside)):
            for name in names:
                for place, test in enumerate(self.tests.get(name, ())):
                    rank[test] = min(rank.get(test, (group, place)), (group, place))
        # A test that reads a constant, or a default, calls nothing: its file has the name.
        named = fault.name if fault.function == "<module>" else f"{fault.function}." if _is_default(fault) else ""
        reading = {test for test in self.seconds if named and named in _text(test.partition("::")[0])}
        rank |= dict.fromkeys(reading, (0, 0))

        def order(test: str) -> tuple[bool, int, tuple[int, int], float]:
            return test not in reading, _distance(test, fault.module), rank[test], self.seconds[test]

        tests = sorted(rank, key=order)
        spent = accumulate(self.seconds[test] for test in tests)
        return [test for test, time in zip(tests, spent, strict=True) if time <= budget]


def _is_default(fault: Fault) -> bool:
    """Tell whether a fault is in the default of an argument, or of a field."""
    in_class = fault.function.rpartition(".")[2].strip("_")[:1].isupper()
    return in_class or any(field in ("defaults", "kw_defaults") for field, _ in fault.path)


def _distance(test: str, module: str) -> int:
    """Return how far a test is from a module: 0 if its file imports it, 1 a room around it, 2 golden, 3 any other."""
    file = test.partition("::")[0]
    imported = _imported(file)
    if module in imported:
        return 0
    parts = module.split(".")
    if any(".".join(parts[:depth]) in imported for depth in range(3, len(parts))):
        return 1
    return 2 if file.startswith("tests/golden") else 3


@cache
def _imported(file: str) -> frozenset[str]:
    """Return the modules that a file imports from, and those that it imports."""
    nodes = [node for node in ast.walk(ast.parse(_text(file))) if isinstance(node, ast.Import | ast.ImportFrom)]
    found: set[str] = set()
    for node in nodes:
        names = [alias.name for alias in node.names]
        if isinstance(node, ast.ImportFrom):
            found |= {node.module or "", *(f"{node.module}.{name}" for name in names)}
        else:
            found |= set(names)
    return frozenset(found)


@cache
def _text(file: str) -> str:
    return (Path(__file__).parents[2] / file).read_text(encoding="utf-8")


def _is_there(test: str) -> bool:
    """Tell whether the file of a test is there still: a recording may be older than the tests."""
    return (Path(__file__).parents[2] / test.partition("::")[0]).is_file()


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
