"""A gearbox is closed with its shafts in bearings: modes, speeds of bearings and room as they then are."""

import json
import math
from functools import cache

import numpy as np
import pytest

import gearwright as gw
from designs import PAIR
from gearwright.cli import main
from gearwright.closure import ClosedArrangement, Wishes, close_arranged, has_open_sizes
from gearwright.closure.close_arranged import shafts_as_they_stand
from gearwright.closure.proportion import sized_as, teeth_of
from gearwright.dynamics.assembly import assemble
from gearwright.parts.shafts import torsional_stiffness
from gearwright.sizing.bearing_arrangement import bare_shafts
from gearwright.spec.design import PRELIMINARY

HOURS = 3600.0


@cache
def closed(**changes: float) -> ClosedArrangement:
    """Return the pair of a turbine and a propeller with other values, ``table__key``, closed in bearings."""
    edits = {path.replace("__", "."): value for path, value in changes.items()}
    return close_arranged(gw.edited(gw.parse(PAIR), edits), wishes=Wishes(life=2000.0 * HOURS))


@cache
def in_bearings(name: str):
    return gw.arrange(gw.at_level(gw.read(name), PRELIMINARY)).sizing


def as_sized(design):
    """Return a design with the teeth, modules and widths that its sizing chooses."""
    sizing = gw.size(design)
    return gw.edited(design, {**dict(teeth_of(design, sizing)), **dict(sized_as(design, sizing))})


# ----------------------------------------------------------------------------------------------------------------------
# What a shaft in bearings twists by.
# ----------------------------------------------------------------------------------------------------------------------


def test_a_built_shaft_twists_between_the_gears_on_it_and_not_over_its_ends():
    """Springs in series by hand, π G (d⁴ − d_i⁴)/(32 l), between the middles of wheel and pinion of a layshaft."""
    sizing = in_bearings("off-set")
    shaft = next(one for one in sizing.built_shafts if one.name == "left")
    places, shear = sizing.arrangement.plans["left"].places, sizing.design.shaft_material.shear_modulus
    low, high = places["first.wheel"], places["second.pinion"]
    twist = 0.0
    for step in shaft.steps:
        length = min(step.end, high) - max(step.start, low)
        twist += max(length, 0.0) * 32.0 / (math.pi * shear * (step.diameter**4 - shaft.bore**4))
    system = assemble(sizing, "rated")
    (line,) = [k for k, name in enumerate(system.labels.lines) if name == "left shaft"]
    assert system.arrays.stiffness[line] == pytest.approx(1.0 / twist, rel=1e-9)
    whole = next(one.stiffness for one in sizing.shafts if one.name == "left")
    assert system.arrays.stiffness[line] > 2.0 * whole


def test_a_stiffness_between_places_is_that_of_the_whole_from_end_to_end_and_of_one_step_within_it():
    sizing = in_bearings("off-set")
    shear = sizing.design.shaft_material.shear_modulus
    for shaft in sizing.built_shafts:
        whole = next(one.stiffness for one in sizing.shafts if one.name == shaft.name)
        ends = shaft.steps[0].start, shaft.steps[-1].end
        assert shaft.stiffness_between(*ends, shear) == pytest.approx(whole, rel=1e-9)
        assert shaft.stiffness_between(*ends[::-1], shear) == pytest.approx(whole, rel=1e-9)
        step = shaft.steps[0]
        one = torsional_stiffness(step.diameter, step.end - step.start, shear, bore=shaft.bore)
        assert shaft.stiffness_between(step.start, step.end, shear) == pytest.approx(one, rel=1e-9)
        assert shaft.stiffness_between(ends[0], ends[0], shear) == math.inf


@pytest.mark.parametrize("name", ["off-set", "mixed"])
def test_a_design_told_of_its_shafts_has_the_modes_of_the_one_in_bearings(name):
    """Within 2 %, as gears lose what lies inside shafts; not of the short shafts of a first sizing, a fifth away."""
    stands, design = in_bearings(name), as_sized(gw.at_level(gw.read(name), PRELIMINARY))
    told = gw.size(gw.edited(design, dict(shafts_as_they_stand(design, stands))))
    lowest = [
        gw.modes(assemble(sizing, next(iter(sizing.flows)))).frequency[1:4]
        for sizing in (stands, told, gw.size(design))
    ]
    np.testing.assert_allclose(lowest[1], lowest[0], rtol=0.02)
    assert abs(lowest[2] / lowest[0] - 1.0).max() > 0.2


def test_what_a_design_gives_of_a_shaft_is_not_told_anew():
    design = gw.edited(gw.at_level(gw.read("off-set"), PRELIMINARY), {"layout.left.inertia_kg_m2": 0.01})
    told = dict(shafts_as_they_stand(design, in_bearings("off-set")))
    assert "layout.left.inertia_kg_m2" not in told
    assert "layout.right.inertia_kg_m2" in told


# ----------------------------------------------------------------------------------------------------------------------
# Oil to fast bearings.
# ----------------------------------------------------------------------------------------------------------------------


def test_oil_comes_through_the_shaft_where_jets_do_not_let_bearings_turn_as_fast():
    """Mixed: n d_m of 1.6e6 mm/min at 20 000 rpm, of which jets allow 1.5e6 and feeding under the race 3e6."""
    sizing = in_bearings("mixed")
    assert sizing.design.bearing_rules.lubrication == "under-race"
    assert not [check.name for check in sizing.checks if check.mode == "speed factor" and check.fails]


def test_oil_that_the_design_states_stays():
    design = gw.edited(gw.at_level(gw.read("mixed"), PRELIMINARY), {"bearing_rules.lubrication": "jet"})
    found = gw.arrange(design)
    assert found.design.bearing_rules.lubrication == "jet"
    assert {check.mode for check in found.worse} == {"speed factor"}


# ----------------------------------------------------------------------------------------------------------------------
# The loop.
# ----------------------------------------------------------------------------------------------------------------------


def test_a_gearbox_that_passes_is_closed_and_stands_in_bearings():
    found = closed()
    assert found.passes and not found.failing
    assert not bare_shafts(found.sizing)
    assert gw.review(gw.parse(found.text)).failing == ()
    assert found.mass > found.rounds[0].before


def test_it_is_the_best_of_its_rounds():
    found = closed()
    assert found.mass == pytest.approx(min(one.mass for one in found.rounds if not one.worst), rel=1e-12)


def test_the_same_comes_out_twice():
    again = close_arranged(gw.parse(PAIR), wishes=Wishes(life=2000.0 * HOURS))
    assert again.text == closed().text


def test_diameters_that_a_closure_wrote_are_not_kept_and_those_that_are_given_are_told_to_it():
    """A first sizing's diameters are too thin for shafts between bearings."""
    assert closed().closed.design.layout["fast"].diameter is not None
    assert closed().design.layout["fast"].diameter is None


def test_shafts_that_find_no_bearings_are_named():
    found = closed(propellers__propeller__thrust_kn=2000.0)
    assert found.arranged is None
    assert found.without_bearings.startswith("fast, slow (bearings.slow")
    assert not found.passes


def test_the_best_so_far_is_told_as_it_is_found():
    kept = []
    found = close_arranged(gw.parse(PAIR), wishes=Wishes(life=2000.0 * HOURS), keep=kept.append)
    assert kept[-1].text == found.text


def test_a_design_whose_sizes_are_given_leaves_nothing_to_close():
    given = gw.edited(gw.parse(PAIR), {"pairs.stage.module_mm": 3.0, "pairs.stage.face_width_mm": 40.0})
    assert has_open_sizes(gw.parse(PAIR)) and not has_open_sizes(given)


# ----------------------------------------------------------------------------------------------------------------------
# On the command line.
# ----------------------------------------------------------------------------------------------------------------------


def test_the_command_closes_what_is_open_and_says_which_round_is_kept(monkeypatch, capsys, tmp_path):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pair.toml").write_text(PAIR, encoding="utf-8")
    monkeypatch.setattr("sys.argv", ["gearwright", "arrange", "pair.toml", "--life-h", "2000", "--json"])
    with pytest.raises(SystemExit) as ended:
        main()
    result = json.loads(capsys.readouterr().out)["result"]
    assert not ended.value.code
    assert [row["worst"] for row in result["rounds"]][-1] == ""
    assert result["rounds"][-1]["mass_kg"] == pytest.approx(closed().mass, rel=1e-6)
    assert result["failing"] == []


def test_an_interruption_leaves_the_best_so_far(monkeypatch, capsys, tmp_path):
    from gearwright.cli.commands import designs
    from gearwright.closure import close_arranged as module

    def interrupted(design, *, wishes, tell, keep):
        keep(closed())
        raise KeyboardInterrupt

    assert callable(module)
    monkeypatch.setattr("gearwright.closure.close_arranged", interrupted)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pair.toml").write_text(PAIR, encoding="utf-8")
    with pytest.raises(designs.typer.Exit) as left:
        designs._closed_in_bearings(gw.parse(PAIR), Wishes(), tmp_path / "out.toml", PAIR, lambda _: None)
    assert left.value.exit_code == 130
    assert "best so far" in capsys.readouterr().err
    assert gw.review(gw.read(tmp_path / "out-interrupted.toml")).failing == ()
