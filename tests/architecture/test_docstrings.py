"""What is public says what it takes, in which unit, and where it comes from."""

import ast
import importlib
import pkgutil
import re
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import get_args, get_origin, get_type_hints

from sources import MODULES, ROOT, breaking, functions, tree

from gearwright.units import SUFFIXES, Origin, Quantity

KERNELS = {"dynamics"}
"""Layers whose compiled functions share one list of arguments, described where its type is."""
UNIT = re.compile(r"\[[^\]]+\]")
NUMBER = re.compile(r"\b(?:float|int|Array|NDArray|Quantity)\b")


def public_functions(path):
    """Return the public functions of a module."""
    return [node for node in tree(path).body if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")]


def arguments(function):
    """Return name -> annotation of a function's arguments."""
    every = [*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs]
    return {each.arg: ast.unparse(each.annotation) for each in every if each.annotation}


def described(docstring):
    """Return argument -> text of the Args section; several may share a line."""
    section = re.search(r"^Args:\n(.*?)(?=^\S|\Z)", docstring, re.MULTILINE | re.DOTALL)
    texts = {}
    for entry in re.split(r"\n(?=    \S)", section[1] if section else ""):
        names, _, text = entry.strip().partition(":")
        for name in re.split(r",\s*", names):
            texts[name.strip("* ")] = text
    return texts


def test_what_is_described_is_an_argument():
    """Of methods and private functions, too: a renamed argument takes its description along."""

    def strange(path):
        plain = [node for node in functions(path) if not (node.args.vararg or node.args.kwarg)]
        return [
            node.name for node in plain if not set(described(ast.get_docstring(node) or "")) <= {"", *arguments(node)}
        ]

    assert breaking(strange) == {}


def test_every_public_function_describes_every_argument():
    def silent(path):
        if path.relative_to(ROOT).parts[0] in ("cli", *KERNELS):
            return [node.name for node in public_functions(path) if not ast.get_docstring(node)]
        texts = {node.name: ast.get_docstring(node) or "" for node in public_functions(path)}
        return [
            node.name
            for node in public_functions(path)
            if not texts[node.name] or not set(arguments(node)) <= set(described(texts[node.name]))
        ]

    assert breaking(silent) == {}
    assert [name for name, path in MODULES.items() if not ast.get_docstring(tree(path))] == []


def test_every_formula_has_units_and_a_source():
    def unsourced(path):
        return [node.name for node in public_functions(path) if "Source:" not in (ast.get_docstring(node) or "")]

    def unmeasured(path):
        return [
            f"{node.name}({name}): no unit in brackets"
            for node in public_functions(path)
            for name, annotation in arguments(node).items()
            if re.search(r"\b(?:float|ArrayLike)\b", annotation)
            and not UNIT.search(described(ast.get_docstring(node) or "").get(name, ""))
        ]

    parts = {name: path for name, path in MODULES.items() if name.startswith("parts/")}
    assert breaking(unsourced, parts) == {}
    assert breaking(unmeasured, parts) == {}


def result_records():
    """Return every dataclass of the layers that compute."""
    for layer in ("parts", "machines", "train", "sizing", "dynamics"):
        package = importlib.import_module(f"gearwright.{layer}")
        for found in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            module = importlib.import_module(found.name)
            for name, value in vars(module).items():
                own = isinstance(value, type) and value.__module__ == module.__name__
                if own and is_dataclass(value) and not name.startswith("_"):
                    yield value


RECORDS = sorted(set(result_records()), key=lambda record: (record.__module__, record.__name__))


def undocumented(record):
    """Return the numbers of a record that no line documents, and the record itself if it says nothing."""
    path = Path(importlib.import_module(record.__module__).__file__)
    node = next(
        node for node in ast.walk(tree(path)) if isinstance(node, ast.ClassDef) and node.name == record.__name__
    )
    after = dict(zip(node.body, [*node.body[1:], None], strict=True))
    numbers = [
        entry
        for entry in node.body
        if isinstance(entry, ast.AnnAssign) and NUMBER.search(ast.unparse(entry.annotation))
    ]
    silent = [
        entry.target.id
        for entry in numbers
        if not (isinstance(after[entry], ast.Expr) and isinstance(after[entry].value, ast.Constant))
    ]
    return silent if ast.get_docstring(node) else ["the record", *silent]


def test_every_number_of_a_record_has_a_line_of_documentation():
    found = {f"{record.__module__}.{record.__name__}": undocumented(record) for record in RECORDS}
    assert {name: silent for name, silent in found.items() if silent} == {}


def marks(hint):
    """Return the marks of a type, also inside a union."""
    return [
        *getattr(hint, "__metadata__", ()),
        *(mark for part in get_args(hint) for mark in getattr(part, "__metadata__", ())),
    ]


def test_every_origin_belongs_to_a_quantity_that_users_can_be_shown():
    count = 0
    for record in RECORDS:
        hints = get_type_hints(record, include_extras=True)
        for field in fields(record):
            found = marks(hints[field.name])
            quantities = [mark for mark in found if isinstance(mark, Quantity)]
            for origin in [mark for mark in found if isinstance(mark, Origin)]:
                count += 1
                assert quantities, f"{record.__name__}.{field.name}"
                assert origin.equation and origin.source
    assert count > 20


def test_every_computed_quantity_of_a_sizing_has_an_origin():
    """Loads and given values have none: their field says so by a plain type."""
    from gearwright.sizing import result

    for name in ("GearSizing", "MeshSizing", "ShaftSizing", "CarrierSizing", "MachineSizing"):
        record = getattr(result, name)
        hints = get_type_hints(record, include_extras=True)
        for field in fields(record):
            found = marks(hints[field.name])
            plain = hints[field.name] in GIVEN or get_origin(hints[field.name]) is tuple
            if any(isinstance(mark, Quantity) for mark in found) and not plain:
                assert any(isinstance(mark, Origin) for mark in found), f"{name}.{field.name}"


GIVEN = {value for name, value in vars(importlib.import_module("gearwright.units")).items() if marks(value)}


def test_every_dimension_that_is_written_can_be_shown():
    from gearwright.units import shown, unit

    for dimension in SUFFIXES:
        assert isinstance(unit(dimension), str)
        assert shown(1.0, dimension) > 0.0
