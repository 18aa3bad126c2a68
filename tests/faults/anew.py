"""Faults anew: a child imports the faulty module, and all that computes with it, as if it had always been faulty."""

from __future__ import annotations

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


class _Red:
    """Notes the first test, or test module, that is red."""

    def __init__(self) -> None:
        self.first = ""

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
    for number, (trial, red) in enumerate(run_all(trials, jobs, _run), start=1):
        noticed[str(trial.fault)] = red
        print(f"{number}/{len(trials)} {trial.fault} -- {red or 'SURVIVED'}", flush=True)
    return noticed


def _run(trial: Trial) -> str:
    if not trial.tests:
        return ""
    red = _Red()
    sys.meta_path.insert(0, Finder(trial.fault))
    status = pytest.main([*RULES, *trial.tests], plugins=[red])
    return red.first or ("while it was imported" if status else "")
