"""Plugin for pytest: which functions of the package every test calls, and how long it takes.

    pytest -p recorder --calls calls.json tests/unit

Functions, not lines: `sys.settrace` that looks at calls alone costs a third of a test's time, and a test that calls the
faulty function is a test that may notice. What a test module calls while it is collected counts for all of its tests.
A test that takes longer than `--longest` is broken off and left out, as no fault could afford it.
"""

from __future__ import annotations

import json
import signal
import sys
import threading
import time
from pathlib import Path
from types import CodeType, FrameType

import pytest

import gearwright

PACKAGE = str(Path(gearwright.__file__).parent)
CACHING = ("gearwright.parts", "gearwright.sizing.rating", "gearwright.catalogue.materials")
"""Modules whose cached functions are quick."""


class Recorder:
    """Collects the functions that run, test by test."""

    def __init__(self, out: Path, longest: float) -> None:
        self.out = out
        self.longest = longest
        self.running: set[CodeType] = set()
        self.collected: dict[str, set[CodeType]] = {}
        self.calls: dict[str, set[CodeType]] = {}
        self.seconds: dict[str, float] = {}
        self.red: set[str] = set()

    def called(self, frame: FrameType, event: str, _: object) -> None:
        """Note a call; as nothing is returned, the lines of the function are not traced."""
        if frame.f_code.co_filename.startswith(PACKAGE):
            self.running.add(frame.f_code)

    @pytest.hookimpl(hookwrapper=True)
    def pytest_make_collect_report(self, collector: pytest.Collector):
        """Note what a test module calls while it is imported: by whoever looks for examples, or for tests in it."""
        if isinstance(collector, pytest.File):
            self.running = self.collected.setdefault(collector.nodeid, set())
            sys.settrace(self.called)
        yield
        sys.settrace(None)

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item):
        """Run one test, and its fixtures, under the tracer."""
        _forget()
        self.running, start = set(), time.process_time()
        sys.settrace(self.called)
        threading.settrace(self.called)
        yield
        sys.settrace(None)
        threading.settrace(None)  # type: ignore[arg-type]
        self.calls[item.nodeid], self.seconds[item.nodeid] = self.running, time.process_time() - start

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_call(self):
        """Break a test off that takes too long; what it shares with others is made before, and may take its time."""
        signal.setitimer(signal.ITIMER_PROF, self.longest)
        yield
        signal.setitimer(signal.ITIMER_PROF, 0.0)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Leave out what is red, or skipped, without any fault."""
        if not report.passed:
            self.red.add(report.nodeid)

    def pytest_sessionfinish(self) -> None:
        """Write what was seen: test -> seconds and functions as ``module.py:qualified name``."""
        tests = {
            test: {
                "seconds": round(self.seconds[test], 3),
                "calls": sorted(map(_label, codes | self.collected.get(test.partition("::")[0], set()))),
            }
            for test, codes in self.calls.items()
            if test not in self.red
        }
        self.out.write_text(json.dumps(tests))


def _forget() -> None:
    """Empty the caches of formulas: a test that finds a number in one calls its function all the same."""
    for name, module in list(sys.modules.items()):
        if name.startswith(CACHING):
            for thing in vars(module).values():
                if hasattr(thing, "cache_clear"):
                    thing.cache_clear()


def _break_off(*_: object) -> None:
    raise TimeoutError("it takes longer than --longest")


def _label(code: CodeType) -> str:
    module = Path(code.co_filename).relative_to(PACKAGE).as_posix()
    return f"{module}:{code.co_qualname.replace('.<locals>', '')}"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--calls", type=Path, required=True, help="Where to write which test calls what")
    parser.addoption("--longest", type=float, default=10.0, help="Tests that take longer are broken off [s]")


def pytest_configure(config: pytest.Config) -> None:
    signal.signal(signal.SIGPROF, _break_off)
    config.pluginmanager.register(Recorder(config.getoption("--calls"), config.getoption("--longest")))
