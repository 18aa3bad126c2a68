"""Every public verb tells who gives it something else than it asks for, and who names what is not there."""

from __future__ import annotations

import functools
import importlib
import inspect
import re
from collections.abc import Callable
from pathlib import Path
from types import UnionType
from typing import Union, get_args, get_origin, get_type_hints

import numpy as np
import pytest

import gearwright as gw
from gearwright import dynamics, mission, study
from gearwright.catalogue import propeller_map
from gearwright.dynamics.sharing import (
    elastic_shares,
    load_sharing,
    shaft_displacement,
    sharing_problem,
    sharing_study,
    support_sweep,
)
from gearwright.dynamics.vibration import critical_speeds, run_up, waterfall
from gearwright.errors import DesignError
from gearwright.mission import fly, mesh_spectrum, shaft_spectrum
from gearwright.mission.gearbox import gearbox_of
from gearwright.mission.windows import fly_window, window_rules
from gearwright.render.figures.dynamics import response_figure, waterfall_figure
from gearwright.render.figures.motion import mesh_frequencies, orbit_figure, phase_figure, transmission_error_figure
from gearwright.render.schematic import power_flow_figure, schematic_figure
from gearwright.shipped import (
    find_mission,
    find_mix,
    find_study,
    shipped_file,
    shipped_mission,
    shipped_mix,
    shipped_study,
)
from gearwright.sizing import named_results, pick
from gearwright.sizing.losses import Oil
from gearwright.spec import edited, edited_mission, read_mission, read_study
from shipped_work import flown

REFERENCE = Path(__file__).parents[2] / "docs" / "reference" / "api.md"
SHOWN_ELSEWHERE = (
    critical_speeds, run_up, elastic_shares, load_sharing, sharing_problem, sharing_study, support_sweep,
    shaft_displacement, fly_window, window_rules, response_figure, waterfall_figure, mesh_frequencies,
    find_mission, find_mix, find_study, shipped_file, shipped_mission, shipped_study, pick,
    edited_mission, read_mission, read_study,
)  # fmt: skip
"""Verbs of the how-to pages and of the commands beside those of the reference."""


INNER = {"compiled", "refuse_not_finite", "common_period"}
"""What layers export for each other and no page shows."""


def reference() -> list[Callable[..., object]]:
    """Every function that the reference of Python shows."""
    found = []
    for path in re.findall(r"^::: (\S+)$", REFERENCE.read_text(encoding="utf-8"), flags=re.MULTILINE):
        module, _, name = path.rpartition(".")
        found.append(getattr(importlib.import_module(module), name))
    return found


def public_verbs() -> dict[str, Callable[..., object]]:
    exported = [getattr(gw, name) for name in gw.__all__]
    exported += [getattr(layer, name) for layer in (dynamics, mission, study) for name in layer.__all__]
    every = [*exported, *reference(), *SHOWN_ELSEWHERE]
    shown = [verb for verb in every if inspect.isfunction(verb) and verb.__name__ not in INNER]
    return {f"{verb.__module__}.{verb.__name__}": verb for verb in shown}


VERBS = public_verbs()
ARGUMENTS = [
    (name, argument)
    for name, verb in VERBS.items()
    for argument, parameter in inspect.signature(verb).parameters.items()
    if parameter.annotation not in ("object", object)  # what `save` takes is seen by what it holds: tests of `store`
]


class Wrong:
    """Something that no verb asks for."""


def test_the_walk_meets_the_verbs():
    assert {"gearwright.sizing.size.size", "gearwright.dynamics.motion.simulate.simulate"} <= set(VERBS)
    assert len(VERBS) > 50


def allowed(name, argument):
    """Return the types that a verb takes for an argument, by its annotation; whole numbers are numbers."""
    hint = get_type_hints(VERBS[name])[argument]
    types = set(get_args(hint) if get_origin(hint) in (Union, UnionType) else (hint,))
    return types | {int} if types & {float, complex} else types


WRONG = [
    pytest.param(name, argument, given, id=f"{name}-{argument}-{type(given).__name__}")
    for name, argument in ARGUMENTS
    for given in (None, "in-lin", 7, Wrong())
    if type(given) not in allowed(name, argument)
]


@pytest.mark.parametrize(("name", "argument", "given"), WRONG)
def test_every_argument_of_a_wrong_type_is_named_with_what_came_and_what_is_allowed(name, argument, given):
    with pytest.raises(DesignError) as caught:
        VERBS[name](**{argument: given})
    assert [problem.path for problem in caught.value.problems] == [argument]
    assert re.search(rf" of type {type(given).__name__}; give |'in-lin' is none of ", str(caught.value))


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: gw.size("in-line"), r"'in-line' is of type str; give a Design, from gw.read\(path or shipped name\)"),
        (lambda: gw.modes(sizing()), r"of type Sizing; give a System, from gw.assemble\(sizing, case\)"),
        (lambda: gw.simulate(sizing().design), r"of type Design; give a System, from gw.assemble\(sizing, case\)"),
        (lambda: gw.assemble(sizing().design), r"of type Design; give a Sizing, from gw.size\(design\)"),
        (lambda: gw.report(trace()), r"of type Trace; give a Sizing, from gw.size\(design\)"),
        (lambda: gw.read(sizing()), r"of type Sizing; give a text or a path"),
        (
            lambda: fly(sizing(), "thesis"),
            r"'thesis' is of type str; give a Mission, from gw.read_mission\(path or shipped name\)",
        ),
        (lambda: gw.simulate(system(), "0.01"), r"duration: '0.01' is of type str; give a number"),
        (lambda: gw.Outputs(samples="many"), r"samples: 'many' is of type str; give a whole number"),
        (lambda: dynamics.simulate_many([sizing()], 0.01), r"give a sequence, each member a System"),
        (lambda: phase_figure(trace().samples, "first.sun-planet-1"), r"give a sequence, each member a text"),
    ],
)
def test_sentence_names_the_call_that_makes_the_right_thing(call, sentence):
    with pytest.raises(DesignError, match=sentence):
        call()


def test_numbers_of_any_library_are_numbers():
    run = gw.simulate(system(), np.float32(0.001), outputs=gw.Outputs(samples=np.int64(10)))
    assert run.duration == pytest.approx(0.001, rel=1e-2)


@functools.cache
def sizing(name="single-planetary"):
    return gw.size(gw.read(name))


@functools.cache
def system():
    return gw.assemble(sizing())


@functools.cache
def trace():
    return gw.simulate(system(), 0.001)


@functools.cache
def split():
    return sharing_problem(sizing("face-gear-split-torque"))


@functools.cache
def flight():
    return flown()


@functools.cache
def response():
    return dynamics.frequency_response(system(), [100.0, 200.0])


def run_up_of(lines):
    return run_up(sizing(), system(), np.array([0.9, 1.0]), lines=lines, settle=0.001, window=0.002)


UNKNOWN = {
    "gw.assemble case": lambda: gw.assemble(sizing(), "rate"),
    "gw.assemble stiffness": lambda: gw.assemble(sizing(), stiffness="constan"),
    "gw.to_fmu case": lambda: gw.to_fmu(sizing(), "rate"),
    "gw.to_fmu version": lambda: gw.to_fmu(sizing(), version="2"),
    "gw.read path": lambda: gw.read("in-lin"),
    "gw.report case": lambda: gw.report(sizing(), case="rate"),
    "gw.report others": lambda: gw.report(sizing(), others={"rate": trace()}),
    "gw.save case": lambda: gw.save(gw.StoredRun(sizing().design, "rate", trace()), "never.nc"),
    "gw.shipped_design name": lambda: gw.shipped_design("in-lin"),
    "gw.simulate method": lambda: gw.simulate(system(), 0.001, method="runge"),
    "gw.simulate start": lambda: gw.simulate(system(), 0.001, start="statics"),
    "gw.simulate orders": lambda: gw.simulate(system(), 0.001, outputs=gw.Outputs(orders=("first.sun",))),
    "critical_speeds cases": lambda: critical_speeds(sizing(), cases=["rate"]),
    "edited changes": lambda: edited(sizing().design, {"gears.profile_shif": 0.1}),
    "edited_mission changes": lambda: edited_mission(read_mission("thesis"), {"phases.cruis.duration_s": 1.0}),
    "elastic_shares case": lambda: elastic_shares(sizing("off-set"), "rate"),
    "at_level level": lambda: gw.at_level(gw.read("in-line"), "preliminar"),
    "find_mission name": lambda: find_mission("thesi"),
    "answer row": lambda: gw.response(sizing(), system(), "first.sun-plane"),
    "answer case": lambda: gw.response(sizing(), system(), "first.sun-planet", case="rate"),
    "compare changes": lambda: gw.compare({"mine": sizing().design}, changes={"gears.profile_shif": 0.1}),
    "engines kind": lambda: gw.engines(kind="turbojet"),
    "engines manufacturer": lambda: gw.engines(manufacturer="pratts"),
    "engines model": lambda: gw.engines(model="127Z"),
    "engines series": lambda: gw.engines(series="PW1000"),
    "find_mix name": lambda: find_mix("regional-lif"),
    "find_study name": lambda: find_study("motor-spee"),
    "fly_window name": lambda: fly_window(flight(), "cruis"),
    "frequency_response errors": lambda: dynamics.frequency_response(system(), [9.0], errors={"first": 1e-6}),
    "frequency_response loads": lambda: dynamics.frequency_response(system(), [9.0], loads={"first": 1.0}),
    "gearbox_of propeller": lambda: gearbox_of(sizing(), "propelle", Oil(353.15, 4e-7, {})),
    "gw.loss_balance case": lambda: gw.loss_balance(sizing(), "rate"),
    "load_sharing lines": lambda: load_sharing(split().system, ["second.lef"]),
    "load_sharing method": lambda: load_sharing(split().system, split().lines, method="quasi"),
    "mesh_frequencies case": lambda: mesh_frequencies(sizing(), "rate"),
    "mesh_spectrum mesh": lambda: mesh_spectrum(flight(), "first.sun"),
    "orbit_figure centres": lambda: orbit_figure(trace().samples, [("sun.y", "sun.z")]),
    "phase_figure lines": lambda: phase_figure(trace().samples, ["first.sun"]),
    "pick name": lambda: pick(named_results(sizing()), "mas"),
    "power_flow_figure case": lambda: power_flow_figure(sizing(), "nope"),
    "propeller_map name": lambda: propeller_map("nope"),
    "read_mission path": lambda: read_mission("thesi"),
    "read_mix path": lambda: gw.read_mix("regional-lif"),
    "read_study path": lambda: read_study("motor-spee"),
    "response_figure lines": lambda: response_figure(response(), ["first.sun"], title="errors"),
    "run_up lines": lambda: run_up_of(["first.sun"]),
    "schema of": lambda: gw.schema("desig"),
    "shaft_displacement shaft": lambda: shaft_displacement(split(), "inpu", np.zeros((1, len(split().lines)))),
    "shaft_spectrum shaft": lambda: shaft_spectrum(flight(), "outpu"),
    "sharing_problem case": lambda: sharing_problem(sizing(), case="rate"),
    "sharing_problem stage": lambda: sharing_problem(sizing(), "firs"),
    "sharing case": lambda: gw.sharing(sizing(), case="rate"),
    "sharing method": lambda: gw.sharing(sizing("face-gear-split-torque"), method="quasi"),
    "sharing stage": lambda: gw.sharing(sizing(), "firs"),
    "sharing_study method": lambda: sharing_study(split(), method="quasi"),
    "fly_many scatter": lambda: gw.fly_many(
        sizing().design, read_mission("thesis"), {"mission.isa_offst_k": {"from": 0.0, "to": 1.0}}, 2
    ),
    "size_many axes": lambda: gw.size_many(sizing().design, {"gears.face_width_rati": [1.0]}),
    "sheets names": lambda: gw.draw(sizing(), ["shaf"]),
    "notebook name": lambda: gw.notebook("a-first-architectur"),
    "shipped_file name": lambda: shipped_file("thesi"),
    "shipped_mission name": lambda: shipped_mission("thesi"),
    "shipped_mix name": lambda: shipped_mix("regional-lif"),
    "shipped_study name": lambda: shipped_study("motor-spee"),
    "statics balance": lambda: dynamics.statics(system(), balance="require"),
    "support_sweep shaft": lambda: support_sweep(sizing("face-gear-split-torque"), "inpu", [1e7]),
    "support_sweep stage": lambda: support_sweep(sizing("face-gear-split-torque"), "input", [1e7], stage="secon"),
    "support_sweep case": lambda: support_sweep(sizing("face-gear-split-torque"), "input", [1e7], case="rate"),
    "transmission_error_figure lines": lambda: transmission_error_figure(
        trace().samples, ["first.sun"], mesh_frequency=1e3
    ),
    "validate pattern": lambda: gw.validate("planetary sat"),
    "waterfall_figure line": lambda: waterfall_figure(
        run_up_of(["first.sun-planet-1"]), "first.sun", speed=1.0, shaft="sun"
    ),
    "window_rules name": lambda: window_rules(flight(), "cruis"),
}
"""Verb and argument -> call with a name that is not there."""
FREE = {
    "source", "title", "text", "results", "designs", "beside", "tell",
    "path of load", "path of save", "shaft of waterfall_figure", "name of bending_shaft",
    "path of read_duty", "path of read_blades", "path of from_rexs", "file of notebook",
    "lives of mixed_life", "shares of mixed_life", "chosen of bearing_lives",
    "bearings of durability",
}  # fmt: skip
"""Texts that are no names of what is there."""


@pytest.mark.parametrize("what", UNKNOWN)
def test_an_unknown_name_gets_the_nearest_or_all(what):
    with pytest.raises(DesignError, match=r"did you mean|allowed: |add \[supports|series: |sources: "):
        UNKNOWN[what]()


def test_every_argument_that_is_a_name_has_its_unknown():
    """Who adds a verb that takes a name says above what happens when it is not there."""
    covered = {tuple(key.removeprefix("gw.").split()) for key in UNKNOWN}
    named = {
        (verb.__name__, argument.name)
        for verb in VERBS.values()
        for argument in inspect.signature(verb).parameters.values()
        if re.search(r"\bstr\b|Method|Balance", str(argument.annotation)) and argument.name not in FREE
        and f"{argument.name} of {verb.__name__}" not in FREE
    }  # fmt: skip
    assert named - covered == set()


def test_results_that_are_asked_by_name_tell_the_nearest():
    for ask in (
        lambda: trace().samples.force("first.sun-planet"),
        lambda: trace().samples.motion("first.su"),
        lambda: trace().force.of("first.sun-planet"),
        lambda: response().force("first.sun-planet"),
    ):
        with pytest.raises(DesignError, match="did you mean"):
            ask()


def test_shipped_names_are_read_as_the_commands_read_them(tmp_path, monkeypatch):
    """A file of that name in the working folder comes first, there as here."""
    monkeypatch.chdir(tmp_path)
    assert gw.read("in-line") == gw.read(gw.shipped_design("in-line"))
    assert gw.read(Path("in-line")) == gw.read("in-line")
    Path("in-line").write_bytes(gw.shipped_design("off-set").read_bytes())
    assert gw.read("in-line") == gw.read("off-set")


def test_schematic_takes_a_train_or_a_sizing_only():
    assert schematic_figure(sizing().train) is not None
    with pytest.raises(DesignError, match=r"give a Train or a Sizing, from gw.size\(design\)"):
        schematic_figure("single-planetary")


def test_waterfall_refuses_what_is_no_signal():
    with pytest.raises(DesignError, match=r"give a Samples, from trace\.samples"):
        waterfall(trace(), np.zeros(100))
