"""Values at a prompt, in a notebook, and as labelled arrays and tables of other packages."""

from __future__ import annotations

import functools
import inspect
import subprocess
import sys
import typing

import numpy as np
import pytest

import gearwright as gw

LONGEST = 900
"""Characters that fit a prompt [-]."""


@functools.cache
def value(name):
    return MAKE[name]()


MAKE = {
    "Design": lambda: gw.read("single-planetary"),
    "Sizing": lambda: gw.size(value("Design")),
    "Scene": lambda: gw.scene(value("Sizing"), detail="coarse"),
    "System": lambda: gw.assemble(value("Sizing")),
    "Modes": lambda: gw.modes(value("System")),
    "Trace": lambda: gw.simulate(value("System"), 0.001),
    "Samples": lambda: value("Trace").samples,
    "Campbell": lambda: gw.campbell(value("System"), [0.5, 1.0, 1.5]),
    "SpeedCase": lambda: gw.critical_speeds(value("Sizing"), factors=(0.5, 1.0, 1.5))[0],
    "Response": lambda: gw.response(value("Sizing"), value("System"), "first.sun-planet"),
    "RunUp": lambda: gw.runup(value("Sizing"), value("System"), [0.9, 1.0], settle=0.001, window=0.002),
    "SharingStudy": lambda: gw.sharing(gw.size(gw.read("face-gear-split-torque"))),
    "Review": lambda: gw.review(value("Design")),
    "Mission": lambda: gw.read_mission("thesis"),
    "Flight": lambda: gw.fly(gw.size(gw.read("in-line-h2")), value("Mission")),
    "Durability": lambda: gw.durability(value("Flight")),
    "Study": lambda: gw.read_study("motor-speed"),
    "Table": lambda: gw.study(value("Study")),
    "LossBalance": lambda: gw.loss_balance(value("Sizing")),
    "RexsFile": lambda: gw.to_rexs(value("Sizing")),
    "MeshInfluences": lambda: gw.influences(value("Sizing"))[0],
    "Comparison": lambda: gw.mass(2051e3, 2116.0, 127.0),
}
DRAWN = ("Design", "Sizing", "Modes", "Campbell", "SpeedCase", "Trace", "Flight", "Table")


@pytest.mark.parametrize("name", MAKE)
def test_a_value_is_a_few_lines_that_begin_with_what_it_is(name):
    told = repr(value(name))
    assert told.startswith(name)
    assert len(told) < LONGEST and told.count("\n") < 10


@pytest.mark.parametrize("name", MAKE)
def test_a_notebook_shows_the_same_words_and_a_figure_where_there_is_one(name):
    page = value(name)._repr_html_()
    assert page.startswith(f"<pre>{name}")
    assert ("<svg" in page) == (name in DRAWN)


def test_the_lines_hold_the_key_numbers_with_units():
    sizing, table = value("Sizing"), value("Table")
    assert f"worst margin {sizing.worst_margin:.3f}" in repr(sizing) and f"{sizing.mass:.4g} kg" in repr(sizing)
    assert f"{gw.review(value('Design')).verdict}" in repr(value("Review"))
    masses = [row.shown("mass") for row in table.good]
    assert f"mass {min(masses):.4g} to {max(masses):.4g} kg" in repr(table)


def test_a_value_without_a_figure_is_told_which_have_one():
    with pytest.raises(gw.DesignError, match=r"of type System there is no figure; give one of Design, Sizing"):
        gw.figure(value("System"))


def test_words_at_a_prompt_load_no_matplotlib(tmp_path):
    code = "import sys, gearwright as gw; repr(gw.read('in-line')); print(*({'matplotlib', 'numba'} & {*sys.modules}))"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=tmp_path).stdout
    assert told.split() == []


@pytest.mark.extra("xarray")
def test_a_run_is_a_dataset_with_names_and_one_unit_a_variable():
    trace = value("Trace")
    data = trace.to_xarray()
    line = data.force.sel(line="first.sun-planet-1")
    assert np.array_equal(line, trace.samples.force("first.sun-planet-1"))
    assert np.array_equal(data.time, trace.samples.time)
    units = {name: array.attrs["units"] for name, array in data.items()}
    assert units["force"] == "N" and units["deflection"] == "m" and data.time.attrs["units"] == "s"
    labels = trace.labels
    metres = [name for name, unit in zip(labels.lines, labels.line_units, strict=True) if unit == "m"]
    assert list(data.line.values) == metres
    shafts = [name for name, unit in zip(labels.lines, labels.line_units, strict=True) if unit == "rad"]
    for shaft in shafts:
        assert np.array_equal(data.torque.sel(shaft=shaft), trace.samples.force(shaft))
    assert not shafts or units["torque"] == "N m"


@pytest.mark.extra("pandas")
def test_results_are_frames_with_units():
    trace, flight, campbell, table = (value(name) for name in ("Trace", "Flight", "Campbell", "Table"))
    run = trace.to_dataframe()
    assert np.array_equal(run["first.sun-planet-1"], trace.samples.force("first.sun-planet-1"))
    assert run.attrs["units"]["first.sun-planet-1"] == "N" and run.index.name == "time"
    flown = flight.to_dataframe()
    assert np.array_equal(flown["fuel_flow"], flight.history.fuel_flow) and list(flown["phase"]) == list(flight.phase)
    assert flown.attrs["units"]["propeller_power"] == "W" and len(flown) == len(flight.phase)
    assert campbell.to_dataframe().to_numpy() == pytest.approx(campbell.frequency)
    shown = table.to_dataframe()
    assert list(shown["mass"]) == [row.shown("mass") for row in table.rows]
    assert shown.attrs["units"]["power_density"] == table.unit("power_density")


def test_without_pandas_a_sentence_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(gw.DesignError, match=r'this needs pandas, which is not here; .*pip install ".\[pandas\]"'):
        value("Campbell").to_dataframe()


def test_every_value_of_a_public_verb_shows_itself_in_a_notebook():
    """Named tuples show themselves as Python does."""
    for name in dir(gw):
        verb = getattr(gw, name)
        if inspect.isfunction(verb):
            for kind in _kinds(typing.get_type_hints(verb).get("return")):
                if inspect.isclass(kind) and kind.__module__.startswith("gearwright") and not issubclass(kind, tuple):
                    assert hasattr(kind, "_repr_html_"), f"{name} returns {kind.__name__}"


def _kinds(hint):
    inside = typing.get_args(hint)
    return [kind for part in inside for kind in _kinds(part)] if inside else [hint]
