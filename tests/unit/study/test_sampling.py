"""Cases follow from the study alone; distributions are those that are asked for; what cannot be drawn is refused."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.spec import Axis, Study, case_count, edited, parse_study, read, value_at
from gearwright.study.cases import cases, refuse_unknown_paths, unit_sample


def study_of(method: str, *, count: int = 64, axes: str = "") -> Study:
    given = axes or '"a.b" = {from = 1, to = 3}\n"a.c" = {values = ["x", "y"]}'
    return parse_study(
        f'schema = 1\nname = "s"\ndesigns = ["d"]\n[axes]\n{given}\n'
        f'[sampling]\nmethod = "{method}"\ncount = {count}\nseed = 3\n'
    )


@pytest.mark.parametrize("method", ["random", "sobol", "latin-hypercube", "saltelli"])
def test_the_same_seed_gives_the_same_cases(method: str) -> None:
    study = study_of(method)
    drawn = list(cases(study))
    assert drawn == list(cases(study))
    assert [case.number for case in drawn] == list(range(case_count(study)))
    other = study.model_copy(update={"sampling": study.sampling.model_copy(update={"seed": 4})})
    assert drawn != list(cases(other))


@pytest.mark.parametrize("method", ["sobol", "latin-hypercube"])
def test_samples_fill_every_stratum_once(method: str) -> None:
    """Latin hypercubes by definition; the first 2^k Sobol' points by their (0, 1) nets in each axis."""
    sample = unit_sample(study_of(method))
    for column in sample.T:
        assert sorted(np.floor(column * 64).astype(int)) == list(range(64))


def test_a_saltelli_sample_exchanges_one_column_at_a_time() -> None:
    sample = unit_sample(study_of("saltelli", count=8)).reshape(4, 8, 2)
    first, second, one, two = sample
    assert np.array_equal(one, np.column_stack([second[:, 0], first[:, 1]]))
    assert np.array_equal(two, np.column_stack([first[:, 0], second[:, 1]]))


def test_a_list_takes_the_values_of_all_axes_together() -> None:
    study = study_of("list", axes='"a.b" = {values = [1, 2]}\n"a.c" = {from = 0, to = 10, step = 10}')
    assert [case.inputs for case in cases(study)] == [{"a.b": 1, "a.c": 0}, {"a.b": 2, "a.c": 10}]


def test_steps_of_whole_numbers_stay_whole() -> None:
    study = study_of("grid", axes='"planetaries.second.planets" = {from = 3, to = 5, step = 1}')
    values = [case.inputs["planetaries.second.planets"] for case in cases(study)]
    assert values == [3, 4, 5]
    assert all(isinstance(value, int) for value in values)


@pytest.mark.parametrize(
    ("written", "mean", "deviation"),
    [
        ({"from": 2.0, "to": 4.0}, 3.0, 2.0 / 12**0.5),
        ({"distribution": "normal", "mean": 5.0, "deviation": 0.5}, 5.0, 0.5),
        # Triangle: mean (a + b + c)/3, variance (a² + b² + c² − ab − ac − bc)/18.
        ({"from": 0.0, "to": 4.0, "likeliest": 1.0, "distribution": "triangular"}, 5.0 / 3.0, (13.0 / 18.0) ** 0.5),
        # Log-uniform: mean (b − a)/ln(b/a), mean square (b² − a²)/(2 ln(b/a)).
        ({"from": 1.0, "to": np.e, "distribution": "log-uniform"}, np.e - 1.0,
         ((np.e**2 - 1.0) / 2.0 - (np.e - 1.0) ** 2) ** 0.5),
    ],
)  # fmt: skip
def test_a_distribution_has_its_moments(written: dict[str, object], mean: float, deviation: float) -> None:
    """20 000 midpoints of equal probability: their moments differ by the tails that are cut, below 0.1 %."""
    axis = Axis.model_validate(written)
    values = [value_at("a", axis, (k + 0.5) / 20_000) for k in range(20_000)]
    assert np.mean(values) == pytest.approx(mean, rel=1e-4)
    assert np.std(values) == pytest.approx(deviation, rel=1e-3)


def test_the_ends_of_the_unit_interval_have_values() -> None:
    normal = Axis.model_validate({"distribution": "normal", "mean": 0.0, "deviation": 1.0})
    assert np.isfinite([value_at("a", normal, 0.0), value_at("a", normal, 1.0)]).all()
    assert value_at("a", Axis(values=["x", "y"]), 1.0) == "y"


@pytest.mark.parametrize(
    ("method", "axes", "said"),
    [
        ("sobol", '"a.b" = {from = 3, to = 3}', "from must be below to"),
        ("sobol", '"a.b" = {from = 3}', "from and to, or a normal"),
        ("sobol", '"a.b" = {from = -1, to = 3, distribution = "log-uniform"}', "has no logarithm"),
        ("sobol", '"a.b" = {distribution = "normal", mean = 3}', "needs mean and deviation"),
        ("sobol", '"a.b" = {from = 0, to = 1, likeliest = 2, distribution = "triangular"}', "not between 0 and 1"),
        ("list", '"a.b" = {values = [1]}\n"a.c" = {values = [1, 2]}', "axes of equal length"),
        ("grid", '"a.b" = {from = 0, to = 1e12, step = 1}', "1,000,000,000,001 values; at most"),
        ("grid", '"a.b" = {from = 0, to = 1}', "a range needs"),
        ("nsga2", '"a.b" = {from = 0, to = 1}', "a search needs at least one"),
        ("saltelli", '"a.b" = {from = 0, to = 1}', "give two or more"),
        ("sobl", '"a.b" = {from = 0, to = 1}', "'sobl' is not known"),
    ],
)
def test_what_cannot_be_drawn_is_refused(method: str, axes: str, said: str) -> None:
    with pytest.raises(DesignError) as raised:
        study = study_of(method, axes=axes)
        case_count(study)
        list(cases(study))
    assert said in str(raised.value)


def test_a_path_that_no_design_has_is_refused_with_the_nearest() -> None:
    study = study_of("sobol", axes='"motors.electric.sped_rpm" = {from = 1, to = 3}')
    with pytest.raises(DesignError, match="did you mean speed_rpm"):
        refuse_unknown_paths(study, {"d": read(shipped_design("in-line-h2"))})


def test_the_name_of_a_gear_with_a_dot_is_found_in_a_path() -> None:
    design = read(shipped_design("face-gear-split-torque"))
    changed = edited(design, {"errors.first.pinion.eccentricity_um": 40})
    assert changed.errors["first.pinion"].eccentricity == pytest.approx(40e-6)
    assert changed.errors["first.wheel.left"] == design.errors["first.wheel.left"]
    with pytest.raises(DesignError, match=r"did you mean first\.pinion"):
        edited(design, {"errors.first.pinon.eccentricity_um": 40})
