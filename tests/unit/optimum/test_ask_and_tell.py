"""Designs are asked for, evaluated and told; the journal keeps them, and any optimiser can drive."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.optimum.generations import place_of
from gearwright.spec import Study, value_at
from gearwright.spec.studies import Axis

AXES = {
    "motors.electric.speed_rpm": {"from": 4000, "to": 5000},
    "gears.helix_angle_deg": {"from": 0, "to": 25},
    "planetaries.second.planets": {"values": [3, 4, 5]},
}


def asked(**more):
    whole = {
        "name": "light and without loss",
        "designs": ["in-line-h2"],
        "axes": AXES,
        "objectives": {"total_mass": "minimum", "loss": "minimum"},
        "constraints": {"worst_margin": {"minimum": 1.0}},
        "search": {"population": 8, "evaluations": 200, "seed": 3},
    }
    return Study.model_validate(whole | more)


def driven(study, rounds=3, **options):
    with gw.search(study, **options) as search:
        for _ in range(rounds):
            search.tell(search.evaluate(search.ask(8)))
        return search.rows, search.front, search.computed


@pytest.fixture(scope="module")
def plain():
    return driven(asked())


def test_the_same_seed_gives_the_same_rows_bit_for_bit_whatever_the_workers(plain):
    assert driven(asked(), workers=2)[0] == plain[0]
    assert driven(asked(search={"population": 8, "evaluations": 200, "seed": 4}))[0] != plain[0]


def test_rows_are_what_a_study_computes_of_them(plain):
    row = plain[0][5]
    sizing = gw.size(gw.edited(gw.read("in-line-h2"), dict(row.inputs)))
    assert row.number("total_mass") == sizing.mass + sizing.motor_mass
    assert row.number("loss") == pytest.approx(gw.loss_balance(sizing).lost, rel=1e-12)


def test_nothing_of_the_front_is_dominated(plain):
    rows, front, _ = plain
    for row in front:
        for other in rows:
            if not other.problem and other.number("worst_margin") >= 1.0 - 1e-9:
                pair = [(other.number(name), row.number(name)) for name in ("total_mass", "loss")]
                assert not (all(a <= b for a, b in pair) and any(a < b for a, b in pair))


def test_children_get_better_than_points_without_a_plan():
    def by(row):
        speed, helix, planets = (row[path] for path in AXES)
        mass = 100.0 + ((speed - 4400.0) / 100.0) ** 2 + abs(helix - 8.0) + 3.0 * abs(planets - 4)
        return {"total_mass": mass, "mass": mass, "loss": 1.0, "worst_margin": 1.0}

    begun, bred, spread = [], [], []
    for seed in range(10):
        rules = {"population": 12, "evaluations": 400, "seed": seed}
        with gw.search(asked(objectives={"total_mass": "minimum"}, search=rules)) as search:
            search.tell(search.evaluate(search.ask(12), by))
            begun.append(search.front[0].number("total_mass"))
            for _ in range(4):
                search.tell(search.evaluate(search.ask(12), by))
            bred.append(search.front[0].number("total_mass"))
            points = search.evaluate(search.at(np.random.default_rng(seed).random((60, 3))), by)
            spread.append(min(row.number("total_mass") for row in points))
    assert np.mean(bred) - 100.0 < 0.8 * (np.mean(spread) - 100.0) < np.mean(begun) - 100.0


def test_no_design_is_asked_for_twice_as_long_as_there_are_others():
    axes = {
        "planetaries.second.planets": {"values": [3, 4, 5]},
        "planetaries.first.planets": {"values": [3, 4]},
        "gears.pressure_angle_deg": {"values": [20, 22.5, 25, 27.5]},
    }
    answer = {"total_mass": 1.0, "mass": 1.0, "loss": 1.0, "worst_margin": 1.0}
    with gw.search(asked(axes=axes)) as search:
        search.tell(search.evaluate(first := search.ask(8), lambda _: answer))
        rows = search.ask(8)
        search.tell(search.evaluate(rows, lambda _: answer))
        assert not {tuple(row.values()) for row in rows} & {tuple(row.values()) for row in first}
        assert len({tuple(row.values()) for row in rows}) == 8
        assert len(search.ask(40)) == 40, "there are 24 designs: some are repeated"


def test_a_journal_gives_everything_back_and_goes_on(tmp_path, plain):
    file = tmp_path / "search.journal"
    assert driven(asked(), rounds=2, journal=file)[2] == 16
    rows, front, computed = driven(asked(), rounds=3, journal=file)
    assert (rows, front) == plain[:2]
    assert computed == 8


def test_a_journal_of_another_driver_is_refused(tmp_path):
    file = tmp_path / "search.journal"
    driven(asked(), rounds=1, journal=file)
    with gw.search(asked(), journal=file) as search, pytest.raises(DesignError, match="another driver or seed"):
        search.evaluate(search.at([[0.5, 0.5, 0.5]]))
    with pytest.raises(DesignError, match="is of another search"):
        gw.search(asked(name="another"), journal=file)


def test_results_from_elsewhere_are_told_and_kept(tmp_path):
    def by(row):
        calls.append(row)
        return {"total_mass": row["motors.electric.speed_rpm"], "loss": 1.0, "worst_margin": 1.0, "mass": 0.0}

    for expected in (8, 0):
        calls = []
        with gw.search(asked(), journal=tmp_path / "elsewhere.journal") as search:
            search.tell(search.evaluate(search.ask(8), by))
            assert len(calls) == expected
            assert search.front[0].number("total_mass") == min(
                row.inputs["motors.electric.speed_rpm"] for row in search.rows
            )


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda row: row.pop("gears.helix_angle_deg"), "gears.helix_angle_deg is missing"),
        (lambda row: row.update({"gears.helix_angle": 3}), "there is no freedom gears.helix_angle; .*helix_angle_deg"),
        (lambda row: row.update(design="in-line-h2"), "there is no freedom design"),
    ],
)
def test_rows_that_are_none_of_the_search_are_refused(change, message):
    with gw.search(asked()) as search:
        (row,) = search.ask(1)
        change(row)
        with pytest.raises(DesignError, match=message):
            search.evaluate([row])


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"objectives": {}}, "a search needs at least one"),
        ({"axes": {}}, "nothing to vary"),
        ({"objectives": {"total_mas": "minimum"}}, "total_mass"),
        ({"axes": {"motors.electric.sped_rpm": {"from": 1, "to": 2}}}, "speed_rpm"),
    ],
)
def test_searches_that_cannot_be_are_refused(more, message):
    with pytest.raises(DesignError, match=message):
        gw.search(asked(**more))


def test_more_evaluations_than_the_study_says_and_none_are_refused():
    with gw.search(asked(search={"population": 8, "evaluations": 8})) as search:
        search.tell(search.evaluate(search.ask(8)))
        with pytest.raises(DesignError, match=r"raise search\.evaluations"):
            search.evaluate(search.ask(1))
        with pytest.raises(DesignError, match="ask for 1 or more"):
            search.ask(0)
        with pytest.raises(DesignError, match="clip them"):
            search.at([[0.5, 0.5, 1.5]])
        with pytest.raises(DesignError, match=r"\(designs, 3\)"):
            search.at([[0.5, 0.5]])


@pytest.mark.parametrize(
    "written",
    [
        {"from": 3, "to": 9},
        {"from": 1, "to": 100, "distribution": "log-uniform"},
        {"from": 0, "to": 4, "likeliest": 1, "distribution": "triangular"},
        {"mean": 3, "deviation": 0.5, "distribution": "normal"},
    ],
)
def test_places_are_the_inverse_of_values(written):
    axis = Axis.model_validate(written)
    for place in (0.03, 0.2, 0.5, 0.77, 0.98):
        assert place_of("a", axis, value_at("a", axis, place)) == pytest.approx(place, abs=1e-12)


def test_several_designs_are_a_freedom():
    study = asked(
        designs=["in-line-h2", "mixed-h2"], axes={"motors.electric.speed_rpm": AXES["motors.electric.speed_rpm"]}
    )
    with gw.search(study) as search:
        rows = search.ask(8)
        assert {row["design"] for row in rows} == {"in-line-h2", "mixed-h2"}
        assert [row.design for row in search.evaluate(rows)] == [row["design"] for row in rows]


@pytest.mark.extra("pymoo")
def test_pymoo_drives_a_journal(tmp_path):
    from pymoo.algorithms.moo.nsga2 import NSGA2
    from pymoo.optimize import minimize

    from gearwright.exchange.optimisers import pymoo_problem

    fronts = []
    for computed in (36, 0):
        with gw.search(asked(), journal=tmp_path / "pymoo.journal") as search:
            found = minimize(pymoo_problem(search), NSGA2(pop_size=12), ("n_gen", 3), seed=1)
            assert search.computed == computed
            assert len(search.rows) == 36
            fronts.append(search.front)
            best = {tuple(row.number(name) for name in ("total_mass", "loss")) for row in search.front}
        assert {tuple(values) for values in found.F} <= best
    assert fronts[0] == fronts[1]


@pytest.mark.extra("optuna")
def test_optuna_drives_a_journal(tmp_path):
    import optuna

    from gearwright.exchange.optimisers import suggested

    optuna.logging.set_verbosity(optuna.logging.WARNING)
    told = []
    for computed in (12, 0):
        with gw.search(asked(), journal=tmp_path / "optuna.journal") as search:
            study = optuna.create_study(directions=["minimize"] * 2, sampler=optuna.samplers.NSGAIISampler(seed=1))
            for _ in range(12):
                trial = study.ask()
                (row,) = search.evaluate([suggested(search, trial)])
                search.tell([row])
                study.tell(trial, search.judged([row]).values[0].tolist())
            assert search.computed == computed
            told.append(search.rows)
    assert told[0] == told[1]
