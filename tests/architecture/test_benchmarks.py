"""Benchmarks are run by hand: here they are only held to the functions that they call, so that none rots unseen."""

import ast
import importlib
import inspect
import sys
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[2] / "benchmarks"
NAMES = sorted(path.stem for path in FOLDER.glob("*.py"))


@pytest.fixture
def alone(monkeypatch):
    """Import benchmarks by their short names as they do each other, and forget them again."""
    before = dict(sys.modules)
    monkeypatch.syspath_prepend(str(FOLDER))
    for name in NAMES:
        monkeypatch.delitem(sys.modules, name, raising=False)
    yield importlib.import_module
    for name in NAMES:
        sys.modules.pop(name, None)
        if name in before:
            sys.modules[name] = before[name]


def misfits(module, tree):
    """Yield each call of a function that the module knows whose arguments do not fit, with its line."""
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        if any(isinstance(part, ast.Starred) for part in call.args) or any(word.arg is None for word in call.keywords):
            continue
        called = known(module, call.func)
        if not inspect.isfunction(called) or called.__module__.split(".")[0] not in {"gearwright", *NAMES}:
            continue
        try:
            inspect.signature(called).bind(*call.args, **{word.arg: word.value for word in call.keywords})
        except TypeError as error:
            yield f"line {call.lineno}: {called.__name__}: {error}"


def known(module, node):
    """Return what a name, or a part of one, stands for in a module; None for what only a run makes."""
    if isinstance(node, ast.Attribute):
        return getattr(known(module, node.value), node.attr, None)
    return getattr(module, node.id, None) if isinstance(node, ast.Name) else None


@pytest.mark.parametrize("name", NAMES)
def test_a_benchmark_is_imported_and_calls_functions_as_they_are(name, alone):
    try:
        module = alone(name)
    except ModuleNotFoundError as missing:
        if (missing.name or "").split(".")[0] in {"gearwright", *NAMES}:
            raise
        pytest.skip(f"{missing.name} comes with an extra or is a peer")
    assert not list(misfits(module, ast.parse((FOLDER / f"{name}.py").read_text(encoding="utf-8"))))


def test_a_call_that_does_not_fit_is_seen(alone):
    """As one that stood in two benchmarks after the function had got another argument."""
    module = alone("integrators")
    assert list(misfits(module, ast.parse("reference(case)")))
    assert not list(misfits(module, ast.parse("reference(system, case)")))


def test_the_cost_of_ensembles_is_told_for_both_precisions(alone):
    head, rule, row = alone("ensembles").growth(1, (20,))[-3:]
    cells = [cell.strip() for cell in row.strip("|").split("|")]
    assert head.count("|") == rule.count("|") == row.count("|")
    assert cells[0] == "20"
    assert all(float(cell) > 0.0 for cell in cells[1:])
