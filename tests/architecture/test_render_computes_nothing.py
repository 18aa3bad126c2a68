"""Writing a report reads results: while it is rendered, nothing of a gearbox is computed.

What of these layers may run is a method or property of a record, which reads its own fields; a function of a module, or
a method of anything else, computes.
"""

import dataclasses
import importlib
import inspect
import sys
from enum import Enum

import pytest
from sources import ROOT

from gearwright.cli.commands.designs import report
from gearwright.spec.record import Record

LAYERS = ("closure", "machines", "mission", "parts", "shape", "sizing")
"""Those that compute a gearbox; of `dynamics`, names of orders and bodies are looked up."""


class Rendering:
    """Notes the functions of some layers that run on behalf of `render`, each with who in `render` led there.

    What runs while a module is loaded is on nobody's behalf.
    """

    def __init__(self):
        self.led = {}
        self._asking = []

    def __call__(self, frame, event, _):
        file = frame.f_code.co_filename
        if not file.startswith(f"{ROOT}/") or event not in ("call", "return"):
            return
        name = f"{file.removeprefix(f'{ROOT}/')}: {frame.f_code.co_qualname}"
        loads = name.endswith(": <module>")
        if loads or name.startswith("render/"):
            if event == "call":
                self._asking.append("" if loads else name)
            elif self._asking:
                self._asking.pop()
        elif event == "call" and self._asking and self._asking[-1] and name.startswith(LAYERS):
            self.led.setdefault(name, self._asking[-1])


def is_record(kind):
    """Tell whether a class is a record: its instances are values, or members of an enumeration."""
    named = issubclass(kind, tuple) and hasattr(kind, "_fields")
    return named or dataclasses.is_dataclass(kind) or issubclass(kind, Enum | Record)


def computes(name):
    """Tell whether a function of a module is none of a record's own."""
    path, _, function = name.partition(": ")
    kind = getattr(importlib.import_module(f"gearwright.{path[:-3].replace('/', '.')}"), function.partition(".")[0])
    return not (inspect.isclass(kind) and is_record(kind))


@pytest.mark.parametrize("name", ["in-line-h2", "ec120b"])
def test_nothing_is_computed_while_a_report_is_rendered(name, tmp_path):
    rendering = Rendering()
    sys.setprofile(rendering)
    try:
        report(name, tmp_path / "report.html")
    finally:
        sys.setprofile(None)
    assert (tmp_path / "report.html").stat().st_size > 100_000
    assert {function: asked for function, asked in rendering.led.items() if computes(function)} == {}
