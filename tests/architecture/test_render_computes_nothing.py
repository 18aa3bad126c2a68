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

import gearwright as gw
from gearwright.cli.commands.designs import report, size
from gearwright.dynamics.sharing import floating, planet_counts, sharing_problem, sharing_study
from gearwright.particulars import particulars
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.pages.motion import sharing_page, turning
from gearwright.shape import glb
from gearwright.spec.record import Record

LAYERS = (
    "closure",
    "dynamics/equations",
    "dynamics/sharing/of_design",
    "machines",
    "mission",
    "parts",
    "shape",
    "sizing",
)
"""Those that compute a gearbox; of the rest of `dynamics`, names of orders and bodies are looked up."""


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


def computed_while(command):
    """Return what is computed on behalf of `render` while a command runs, each with who led there."""
    rendering = Rendering()
    sys.setprofile(rendering)
    try:
        command()
    finally:
        sys.setprofile(None)
    return {function: asked for function, asked in rendering.led.items() if computes(function)}


@pytest.mark.parametrize("name", ["in-line-h2", "ec120b"])
def test_nothing_is_computed_while_a_report_is_rendered(name, tmp_path):
    assert computed_while(lambda: report(name, tmp_path / "report.html")) == {}
    assert (tmp_path / "report.html").stat().st_size > 100_000


@pytest.mark.parametrize("json", [False, True])
def test_nothing_is_computed_while_a_sizing_is_told(json, capsys):
    assert computed_while(lambda: size("off-set", json, factors=True, methods=True, wish=1.1)) == {}
    assert len(capsys.readouterr().out) > 10_000


def test_the_page_on_which_a_gearbox_turns_computes_nothing():
    sizing = gw.size(gw.read("in-line-h2"))
    facts, built = particulars(sizing), gw.scene(sizing, detail="coarse")
    model = glb(built)
    assert computed_while(lambda: turning(facts, built, model)) == {}


def test_the_page_on_sharing_computes_nothing():
    sizing = gw.size(gw.read("face-gear-split-torque"))
    problem = sharing_problem(sizing)
    study, floats, counts = sharing_study(problem), floating(sizing), planet_counts(sizing, problem)
    given = [] if counts is None else [counts]
    assert computed_while(lambda: sharing_page(sizing, [study], counts=given, floats=floats)) == {}


def test_what_is_computed_is_told_with_who_led_there():
    """Sheets are given solids, and cut them."""
    sizing = gw.size(gw.read("star"))
    solids = gw.scene(sizing, detail="coarse")
    computed = computed_while(lambda: sheets(sizing, ["arrangement"], solids=solids))
    assert "shape/chambers.py: cut_chamber" in computed and "shape/scene.py: scene" not in computed
