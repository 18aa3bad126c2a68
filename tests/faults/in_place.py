"""Faults in place: all tests are collected once; a child exchanges the code of the faulty function and runs some."""

from __future__ import annotations

import ast
import functools
import gc
import os
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

import pytest
from children import HANGS, Trial, run_all
from mutators import Fault

ROOT = Path(__file__).resolve().parents[2]
RULES = [
    "-x",
    "-q",
    "--assert=plain",
    "--capture=sys",
    "-p",
    "no:xdist",
    "--rootdir",
    str(ROOT),
    "-c",
    str(ROOT / "pyproject.toml"),
]


def noticed_in_place(trials: Sequence[Trial], jobs: int) -> dict[str, str]:
    """Return fault -> the test that notices it; those that none notices are left out.

    Args:
        trials: Faults and their tests.
        jobs: Children at once.
    """
    tests = sorted({test for trial in trials for test in trial.tests})
    plugin = _Loop(trials, jobs)
    os.chdir(ROOT)
    if tests:
        pytest.main([*RULES, *sorted({test.partition("::")[0] for test in tests})], plugins=[plugin])
    return plugin.noticed


class _Loop:
    """In place of the loop over all tests: a loop over faults."""

    def __init__(self, trials: Sequence[Trial], jobs: int) -> None:
        self.trials = trials
        self.jobs = jobs
        self.noticed: dict[str, str] = {}
        self.red = ""
        self.items: dict[str, pytest.Item] = {}
        self.functions: dict[tuple[str, str, int], list[FunctionType]] = {}
        self.caches: list[Any] = []

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Run every fault, then the tests that noticed any once more without."""
        self.items = {item.nodeid: item for item in session.items}
        for thing in gc.get_objects():
            if isinstance(thing, FunctionType):
                self.functions.setdefault(_key(thing.__code__), []).append(thing)
            elif isinstance(thing, functools._lru_cache_wrapper):
                self.caches.append(thing)
        gc.freeze()
        gc.disable()  # A child lives for seconds; a collection would copy the parent's memory.
        for number, (trial, red) in enumerate(run_all(self.trials, self.jobs, self.faulty), start=1):
            print(
                f"{number}/{len(self.trials)} {trial.fault} -- {red or 'not noticed in place'}",
                file=sys.__stdout__,
                flush=True,
            )
            if red and red != HANGS:
                self.noticed[str(trial.fault)] = red
        telling = sorted({red for red in self.noticed.values() if red in self.items})
        for _, red in run_all([Trial(self.trials[0].fault, telling, self.trials[0].seconds)], 1, self.sound):
            if red:
                raise pytest.UsageError(f"red without any fault: {red}")
        return True

    def sound(self, trial: Trial) -> str:
        """Return the test that is red without any fault."""
        return self.run(trial.tests)

    def faulty(self, trial: Trial) -> str:
        """Return the test that notices a fault."""
        return self.run(trial.tests) if self.exchange(trial.fault) else ""

    def run(self, tests: Sequence[str]) -> str:
        """Return the first test that is red."""
        items = [self.items[test] for test in tests if test in self.items]
        for item, after in zip(items, [*items[1:], None], strict=False):
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=after)
            if self.red:
                return self.red
        return ""

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Note a red test."""
        if report.failed:
            self.red = report.nodeid

    def exchange(self, fault: Fault) -> bool:
        """Put the faulty code into all functions that have the sound one; tell whether there are any."""
        if fault.module not in sys.modules:
            return False
        path = sys.modules[fault.module].__file__ or ""
        tree = fault.tree(Path(path).read_text(encoding="utf-8"))
        changed = _constants(fault, tree) if fault.name else False
        for code in _inside(compile(tree, path, "exec")):
            for function in self.functions.get(_key(code), ()):
                if function.__code__ != code and len(function.__code__.co_freevars) == len(code.co_freevars):
                    function.__code__ = code
                    changed = True
        for cache in self.caches if changed else ():
            cache.cache_clear()
        return changed


def _constants(fault: Fault, tree: ast.Module) -> bool:
    """Put the faulty constant, and those made of it, wherever the sound one stands under its name; tell whether any."""
    space, stale = vars(sys.modules[fault.module]), {fault.name}
    for statement in tree.body:
        target = statement.targets[0] if isinstance(statement, ast.Assign) else getattr(statement, "target", None)
        value = getattr(statement, "value", None)
        if isinstance(target, ast.Name) and value is not None and target.id in space:
            read = {part.id for part in ast.walk(value) if isinstance(part, ast.Name)}
            if target.id == fault.name or read & stale:
                stale.add(target.id)
                _put(target.id, space[target.id], eval(compile(ast.Expression(value), fault.module, "eval"), space))
    return fault.name in space


def _put(name: str, old: object, new: object) -> None:
    for module in list(sys.modules.values()):
        if getattr(module, "__dict__", {}).get(name, module) is old:
            setattr(module, name, new)


def _key(code: CodeType) -> tuple[str, str, int]:
    return code.co_filename, code.co_qualname, code.co_firstlineno


def _inside(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _inside(constant)
