"""A search finds what is best, says why, and gives the same answer however it is computed."""

import re

import numpy as np
import pytest

import gearwright as gw
from gearwright.cli.options import axis_of, bound_of
from gearwright.errors import DesignError
from gearwright.optimum import Optimum, hypervolume
from gearwright.optimum.course import Archive, _places, parts_of, screened
from gearwright.optimum.generations import judged_rows
from gearwright.optimum.optimise import nearest, study_for
from gearwright.spec import Study

SPEED, WIDTH = "motors.electric.speed_rpm", "gears.face_width_ratio"
AXES = {
    SPEED: {"from": 4000, "to": 5000},
    WIDTH: {"from": 7, "to": 14},
    "planetaries.second.planets": {"values": [3, 4, 5]},
}
SMALL = {"screened": 256, "population": 12, "evaluations": 160, "polished": 2, "samples": 16, "seed": 3}
UNCERTAIN = {"gears.contact_safety": {"distribution": "normal", "mean": 1.5, "deviation": 0.05}}


def study(**more) -> Study:
    whole = {
        "name": "light and without loss",
        "designs": ["in-line-h2"],
        "axes": AXES,
        "objectives": {"total_mass": "minimum", "loss": "minimum"},
        "constraints": {"worst_margin": {"minimum": 1.0}},
        "search": SMALL,
        "uncertain": UNCERTAIN,
    }
    return Study.model_validate(whole | more)


@pytest.fixture(scope="module")
def found() -> Optimum:
    return gw.optimise(study())


def test_the_answer_is_the_same_whatever_the_workers_and_however_often_it_was_stopped(tmp_path):
    """Begun alone and stopped three times, gone on with by two processes and alone in turn."""
    little = study(
        designs=["single-planetary"],
        axes={WIDTH: AXES[WIDTH], "gears.contact_safety": {"from": 1.2, "to": 1.6}},
        objectives={"mass": "minimum"},
        search={"screened": 64, "population": 8, "evaluations": 40, "polished": 1, "samples": 8, "seed": 3},
        uncertain={"gears.bending_safety": UNCERTAIN["gears.contact_safety"]},
    )
    undisturbed = gw.optimise(little)
    assert undisturbed.prices and undisturbed.regrets

    class Stopped(Exception):
        pass

    def stopping(at):
        def tell(said):
            if said.startswith(at):
                raise Stopped

        return tell

    for at, workers in (("screened", 0), ("generation 2", 2), ("what limits", 0)):
        with pytest.raises(Stopped):
            gw.optimise(little, journal=tmp_path / "search.journal", workers=workers, tell=stopping(at))
    assert gw.optimise(little, journal=tmp_path / "search.journal", workers=2) == undisturbed


def test_nothing_of_the_front_is_dominated_and_all_of_it_keeps_the_constraints(found):
    values = np.array([[best.row.number(name) for name in found.objectives] for best in found.front])
    for k, own in enumerate(values):
        others = np.delete(values, k, axis=0)
        assert not ((others <= own).all(axis=1) & (others < own).any(axis=1)).any()
    assert all(best.row.number("worst_margin") >= 1.0 - 1e-9 for best in found.front)
    assert found.chosen == nearest(values)


def test_every_design_of_the_front_is_what_sizing_makes_of_it(found):
    for best in found.front:
        sizing = gw.size(gw.edited(gw.read("in-line-h2"), dict(best.inputs)))
        assert sizing.mass + sizing.motor_mass == best.row.number("total_mass")
        assert sizing.worst_margin == best.row.number("worst_margin")
        nearest_check = min(check.margin for check in sizing.checks if check.ratio is not None)
        assert best.binds[0].margin == pytest.approx(nearest_check, abs=1e-6)


def test_the_best_of_a_grid_is_found():
    """All that a fine grid of the same freedoms has, and a little more: what is between its lines."""
    speeds, widths, planets = np.meshgrid(np.linspace(4000, 5000, 21), np.linspace(7, 14, 15), [3, 4, 5])
    grid = gw.size_many(
        gw.read("in-line-h2"),
        {SPEED: speeds.ravel(), WIDTH: widths.ravel(), "planetaries.second.planets": planets.ravel()},
        results=["total_mass", "worst_margin"],
    )
    keeps = grid.columns["worst_margin"] >= 1.0 - 1e-9
    least = float(np.nanmin(np.where(keeps, grid.columns["total_mass"], np.nan)))
    one = gw.optimise(study(objectives={"total_mass": "minimum"}, uncertain={}, search=SMALL | {"polished": 1}))
    assert one.best.row.number("total_mass") <= least
    assert one.best.row.number("total_mass") > 0.97 * least


def test_the_first_layer_keeps_the_best_of_its_points():
    asked = study(search=SMALL | {"screened": 300})
    (part,) = parts_of(asked, asked.search)
    kept = screened(asked, {"in-line-h2": gw.read("in-line-h2")}, part)
    masses = [row.number("total_mass") for _, row in kept.blocks]
    assert 0 < len(kept.blocks) < kept.sized <= 300
    for number, row in kept.blocks:
        sizing = gw.size(gw.edited(gw.read("in-line-h2"), dict(row.inputs)))
        assert (sizing.mass + sizing.motor_mass, number < 300) == (row.number("total_mass"), True)
    with gw.search(study()) as search:
        others = search.evaluate(search.at(np.random.default_rng(0).random((40, 3))))
    good = [row.number("total_mass") for row in others if not row.problem and row.number("worst_margin") >= 1 - 1e-9]
    assert min(masses) < np.quantile(good, 0.1)


def test_the_first_layer_looks_at_the_ends_of_ranges_and_keeps_the_best_of_every_section_and_list():
    asked = study(objectives={"total_mass": "minimum"}, search=SMALL | {"screened": 512})
    (part,) = parts_of(asked, asked.search)
    places = _places(asked, part)
    ends = (places == 0.0) | (places == 1.0)
    assert 512 / 2 / 4 < ends[:, :2].any(axis=1).sum() < 512 / 2, "of every second point a sixth at either end"
    assert not ends[:, 2].any() and not ends[0::2].any()
    rows = [row for _, row in screened(asked, {"in-line-h2": gw.read("in-line-h2")}, part).blocks]
    assert {row.inputs["planetaries.second.planets"] for row in rows} == {3, 4, 5}
    speeds = np.array([row.inputs[SPEED] for row in rows])
    assert len(np.unique(np.floor((speeds - 4000.0) / 125.0))) >= 8 and {4000.0, 5000.0} <= set(speeds.tolist())


def test_the_best_with_other_values_of_lists_than_the_front_are_known():
    asked = study(objectives={"total_mass": "minimum"})
    archive = Archive(asked)
    with gw.search(asked) as search:
        rows = search.evaluate(search.at(np.random.default_rng(0).random((40, 3))))
    archive.add(rows, judged_rows(asked, rows))
    kinds = [row.inputs["planetaries.second.planets"] for row in [*archive.rows, *archive.beside(5)]]
    assert sorted(kinds) == [3, 4, 5]
    masses = [row.number("total_mass") for row in [*archive.rows, *archive.beside(5)]]
    assert masses == sorted(masses)


def test_a_stronger_flank_costs_mass_and_a_weaker_one_gives_it_back(found):
    price = next(price for price in found.prices if price.limit == "gears.contact_safety")
    assert price.changes["total_mass"] < 0.0
    influence = found.influences[0]
    assert (influence.path, influence.low < influence.high) == ("gears.contact_safety", True)
    assert influence.changes["total_mass"] > 0.0


def test_regret_is_of_the_chosen_first_and_never_negative(found):
    assert found.regrets[0].place == found.chosen
    assert sum(regret.best for regret in found.regrets) == pytest.approx(1.0)
    assert all(0.0 <= regret.mean <= regret.late + 1e-12 for regret in found.regrets)
    low, high = found.regrets[0].spread["total_mass"]
    assert low < found.best.row.number("total_mass") < high


def test_as_built_a_design_at_its_limit_keeps_it_in_about_half_of_what_may_come(found):
    """The safety that is asked scatters about the one for which flanks were made: half of it is above."""
    at_limit = [
        regret for regret in found.regrets if any("contact" in own.name for own in found.front[regret.place].binds)
    ]
    assert at_limit and all(0.3 <= regret.keeps <= 0.7 for regret in at_limit)


def test_constraints_bind_and_impossible_ones_are_refused():
    tight = study(constraints={"worst_margin": {"minimum": 1.0}, "loss": {"maximum": 12.2}}, uncertain={},
                  objectives={"total_mass": "minimum"})  # fmt: skip
    optimum = gw.optimise(tight)
    assert optimum.best.row.shown("loss") <= 12.2 * (1 + 1e-9)


def test_where_no_design_is_good_the_nearest_says_what_it_misses_and_which_checks_fail():
    small = SMALL | {"screened": 0, "evaluations": 12, "polished": 0}
    with pytest.raises(DesignError) as refused:
        gw.optimise(study(constraints={"total_mass": {"maximum": 10.0}, "loss": {"maximum": 1e6}}, search=small))
    mass, where = refused.value.problems
    assert mass.path == "constraints.total_mass"
    reached, share = re.search(
        r"at most 10 is asked, and the nearest design has (\S+), (\S+) % off", mass.message
    ).groups()
    assert float(share) == pytest.approx(10.0 * (float(reached) - 10.0), abs=1.0)
    assert mass.message.endswith("none comes nearer: relax it")
    assert re.search(rf"in-line-h2: {SPEED} = 4[0-9.]+, .*: free what these depend on", where.message)
    narrow = {"gears.bending_safety": 3.0, "planetaries.first.module_mm": 1.0}
    with pytest.raises(
        DesignError, match=r"(?s)worst_margin: at least 1 is asked.*its sizing fails first\.\S+ .*of what is asked"
    ):
        gw.optimise(study(changes=narrow, search=small))


@pytest.mark.parametrize(
    ("points", "reference", "expected"),
    [
        ([[1.0]], [3.0], 2.0),
        ([[1.0, 2.0], [2.0, 1.0]], [3.0, 3.0], 3.0),
        ([[1.0, 2.0], [2.0, 1.0], [2.5, 2.5], [9.0, 0.0]], [3.0, 3.0], 3.0),
        ([[0.0, 0.0, 0.0]], [1.0, 2.0, 3.0], 6.0),
        ([[0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]], [2.0, 2.0, 2.0], 4.0),
    ],
)
def test_hypervolumes_that_are_known(points, reference, expected):
    assert hypervolume(np.array(points), np.array(reference)) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("objectives", [2, 3, 4])
def test_a_hypervolume_is_the_part_of_points_that_are_dominated(objectives):
    points = np.random.default_rng(objectives).random((30, objectives))
    drawn = np.random.default_rng(9).random((40000, objectives))
    part = float((points[:, None, :] <= drawn).all(axis=2).any(axis=0).mean())
    assert hypervolume(points, np.ones(objectives)) == pytest.approx(part, abs=0.012)


def test_axes_and_bounds_are_read_as_they_are_written():
    path, axis = axis_of("motors.electric.speed_rpm = 4000..6000")
    assert (path, axis.first, axis.last) == ("motors.electric.speed_rpm", 4000, 6000)
    assert axis_of("gears.material=a, b")[1].values == ["a", "b"]
    assert bound_of("loss <= 12.5")[1].maximum == 12.5
    for text in ("x", "x=", "=3", "x=a..b", "x=1..inf"):
        with pytest.raises(DesignError, match="--free"):
            axis_of(text)
    for text in ("loss<12", "loss=12", "<=3", "loss>=a"):
        with pytest.raises(DesignError, match="--keep"):
            bound_of(text)


def test_a_design_alone_leaves_motors_planets_and_widths_free():
    own = study_for("in-line-h2", gw.read("in-line-h2"))
    assert list(own.axes) == [SPEED, "planetaries.first.planets", "planetaries.second.planets", WIDTH]
    assert own.objectives == {"total_mass": "minimum", "loss": "minimum"}


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"axes": {}}, "nothing to vary"),
        ({"objectives": {}}, "needs at least one"),
        ({"uncertain": {SPEED: {"from": 1, "to": 2}}}, "is an axis, too"),
        ({"uncertain": {"gears.contact_safety": {"distribution": "normal"}}}, "needs mean and deviation"),
        ({"objectives": {"lightness": "minimum"}}, "lightness"),
    ],
)
def test_searches_that_cannot_be_are_refused(more, message):
    with pytest.raises(DesignError, match=message):
        gw.optimise(study(**more))


def test_a_study_that_searches_is_not_run_as_cases():
    with pytest.raises(DesignError, match="gearwright optimise"):
        gw.study(study())
