"""Faults anew: a child imports the faulty module, and all that computes with it, as if it had always been faulty.

A fault is noticed by a test that fails, by a test module that cannot be imported, or if the faulty module itself cannot
be imported. Any other end of pytest says nothing: tests that are not found, none collected, an error of its own.
"""

from __future__ import annotations

import importlib
import importlib.abc
import importlib.machinery
import sys
from collections.abc import Sequence
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

import pytest
from children import Trial, run_all
from in_place import ROOT, RULES
from mutators import Fault


class Loader(importlib.machinery.SourceFileLoader):
    """Loads one module with a fault in it."""

    def __init__(self, fault: Fault, path: str) -> None:
        super().__init__(fault.module, path)
        self.fault = fault

    def get_code(self, fullname: str) -> CodeType:
        """Return the faulty code."""
        return compile(self.fault.tree(Path(self.path).read_text(encoding="utf-8")), self.path, "exec")


class Finder(importlib.abc.MetaPathFinder):
    """Finds the faulty module."""

    def __init__(self, fault: Fault) -> None:
        self.fault = fault

    def find_spec(self, name: str, path: Any, target: ModuleType | None = None) -> Any:
        """Return the faulty module in place of the sound one."""
        spec = importlib.machinery.PathFinder.find_spec(name, path) if name == self.fault.module else None
        if spec is not None and spec.origin is not None:
            spec.loader = Loader(self.fault, spec.origin)
        return spec


UNIMPORTABLE = "it cannot be imported"


class _Red:
    """Notes the first test, or test module, that is red; runs the tests that are asked for, of those that there are."""

    def __init__(self, tests: Sequence[str]) -> None:
        self.first = ""
        self.place = {test: place for place, test in enumerate(tests)}

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Keep what is asked for, in its order: a fault may rename tests that are named by a table."""
        items[:] = sorted((item for item in items if item.nodeid in self.place), key=lambda i: self.place[i.nodeid])

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Note a red test."""
        self.first = self.first or (report.nodeid if report.failed else "")

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Note a module that cannot be imported."""
        self.first = self.first or (report.nodeid if report.failed else "")


def noticed_anew(trials: Sequence[Trial], jobs: int) -> dict[str, str]:
    """Return fault -> the test that notices it, or nothing.

    Args:
        trials: Faults and their tests.
        jobs: Children at once.
    """
    own = (str(ROOT / "src"), str(ROOT / "tests"))
    for name, module in list(sys.modules.items()):
        faults = Path(str(getattr(module, "__file__", ""))).parent == Path(__file__).parent
        if str(getattr(module, "__file__", "")).startswith(own) and not faults and name != "__main__":
            del sys.modules[name]
    noticed = {}
    for number, (trial, red) in enumerate(run_all(trials, jobs, _faulty), start=1):
        noticed[str(trial.fault)] = red
        print(f"{number}/{len(trials)} {trial.fault} -- {red or 'SURVIVED'}", flush=True)
    telling = sorted({red for red in noticed.values() if red.partition("::")[0].endswith(".py")})
    if telling:
        seconds = {test: own for trial in trials for test, own in trial.seconds.items()} | dict.fromkeys(telling, 10.0)
        for _, red in run_all([Trial(trials[0].fault, telling, seconds)], 1, _sound):
            if red:
                raise pytest.UsageError(f"red without any fault: {red}")
    return noticed


def _faulty(trial: Trial) -> str:
    if not trial.tests:
        return ""
    sys.meta_path.insert(0, Finder(trial.fault))
    try:
        importlib.import_module(trial.fault.module)
    except Exception:
        return UNIMPORTABLE
    return _sound(trial)


def _sound(trial: Trial) -> str:
    """Return the first red test of a trial, or the test module that cannot be imported."""
    red = _Red(trial.tests)
    files = list(dict.fromkeys(test.partition("::")[0] for test in trial.tests))
    pytest.main([*RULES, *files], plugins=[red])
    return red.first
