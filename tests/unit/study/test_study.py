"""Studies: axes, failed variants as rows, designs fitted to another engine, and what a study file may not say."""

from __future__ import annotations

from pathlib import Path

import pytest

from gearwright.errors import DesignError
from gearwright.render.tables.variants import study_csv, study_records
from gearwright.shipped import shipped_design, shipped_studies, shipped_study
from gearwright.sizing import named_results, size
from gearwright.spec import Study, axis_values, case_count, edited, read, read_study
from gearwright.study import for_engine, run
from gearwright.study.cases import refuse_unknown_paths
from gearwright.study.tables import kind_of
from gearwright.units import RPM

HEAD = 'schema = 1\nname = "s"\ndesigns = ["in-line-h2"]\n'


def study_of(tmp_path: Path, text: str) -> Study:
    file = tmp_path / "study.toml"
    file.write_text(text, encoding="utf-8")
    return read_study(file)


@pytest.mark.parametrize("name", shipped_studies())
def test_every_shipped_study_runs_without_a_failed_case(name: str) -> None:
    """Of samples the first two, of all axes at once: the others are drawn from the same ranges."""
    study = read_study(shipped_study(name))
    if study.sampling.count:
        few = study.sampling.model_copy(update={"count": min(2, study.sampling.count)})
        study = study.model_copy(update={"sampling": few})
    table = run(study, {each: read(shipped_design(each)) for each in study.designs})
    assert len(table.rows) == case_count(study)
    assert table.failed == ()


def test_the_last_axis_is_the_fastest(tmp_path: Path) -> None:
    planets = '"planetaries.first.planets" = {values = [3, 4]}'
    fill = '"carriers.fill" = {from = 0.4, to = 0.6, step = 0.1}'
    study = study_of(tmp_path, f"{HEAD}[axes]\n{planets}\n{fill}\n")
    table = run(study, {"in-line-h2": read(shipped_design("in-line-h2"))})
    inputs = [tuple(row.inputs.values()) for row in table.rows]
    assert inputs[:4] == [(3, 0.4), (3, 0.5), (3, pytest.approx(0.6)), (4, 0.4)]


def test_a_variant_that_fails_is_a_row_with_its_reason(tmp_path: Path) -> None:
    study = study_of(tmp_path, HEAD + '[axes]\n"planetaries.second.planets" = {values = [5, 9]}\n')
    table = run(study, {"in-line-h2": read(shipped_design("in-line-h2"))})
    assert [bool(row.problem) for row in table.rows] == [False, True]
    assert "9 planets do not fit" in table.failed[0].problem
    assert study_records(table)[1]["mass [kg]"] is None
    assert study_csv(table).count("\n") == 3


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "required"),
        (HEAD + '[axes]\n"a.b" = {from = 3, to = 3, step = 1}\n', "line 5: axes.a.b: from 3 to 3 there is no length"),
        (HEAD + '[axes]\n"a.b" = {values = []}\n', "give at least one"),
        (HEAD + '[axes]\n"a.b" = {values = [1], from = 2, to = 3, step = 1}\n', "keep one of them"),
        (
            HEAD + '[axes]\n"a.b" = {from = 1, to = 1e3, step = 1e-3}\n"c.d" = {from = 1, to = 1e3, step = 1e-3}\n',
            "998,002,998,001 cases; at most 10,000,000 are run: take larger steps or fewer axes, or draw samples",
        ),
        (HEAD + '[axes]\n"a.b" = {from = 3, to = 3}\n[sampling]\nmethod = "sobol"\ncount = 4\n', "line 5: axes.a.b"),
        (HEAD + '[axes]\n"errors.first.sn.axial_um" = {values = [1]}\n', "did you mean first.sun?"),
        (HEAD + '[axes]\n"errors.first.sun.axal_um" = {values = [1]}\n', "did you mean axial_um?"),
        (HEAD + '[axes]\n"layout.outpt.bore_ratio" = {values = [0.2]}\n', "did you mean output?"),
        (HEAD + 'results = ["mass", "fly.feul"]\n[fly]\nmission = "thesis"\n', "did you mean fly.fuel?"),
        (HEAD + '[fly]\nmission = "thesis"\n[objectives]\n"fly.governing" = "minimum"\n', "is a name and no number"),
        (HEAD + '[axes]\n"a.b" = {from = 3, to = 1, step = 1}\n', "exchange them"),
        (HEAD + '[axes]\n"a.b" = {from = 3}\n', "all of from, to and step"),
        (HEAD + '[axes]\n"a.b" = {from = 0, to = 1e9, step = 1}\n', "1,000,000,001 values; at most 1,000,000"),
        (HEAD + "axs = 1\n", "did you mean axes?"),
        (HEAD + '[axes]\n"a.b" = {values = [1]}\n', "there is no a"),
        (HEAD + 'results = ["mas"]\n', "did you mean mass?"),
        (HEAD + '[changes]\n"gears.materal" = "x"\n', "did you mean material?"),
    ],
)
def test_what_a_study_cannot_do_is_named(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(DesignError) as raised:
        study = study_of(tmp_path, text)
        designs = {"in-line-h2": read(shipped_design("in-line-h2"))}
        refuse_unknown_paths(study, designs)
        run(study, designs)
    assert said in str(raised.value)


def test_steps_include_the_last_value() -> None:
    study = read_study(shipped_study("motor-speed"))
    (axis,) = study.axes.values()
    values = axis_values("speed", axis)
    assert (values[0], values[-1], len(values)) == (3500.0, 5500.0, 21)


def test_a_design_is_fitted_to_another_engine() -> None:
    design = for_engine(
        read(shipped_design("in-line-h2")), power=1000e3, engine_speed=30000 * RPM, propeller_speed=1700 * RPM
    )
    flow = size(design).flows["rated"]
    assert sum(power for power in flow.machine_powers.values() if power > 0) == pytest.approx(1000e3, rel=1e-12)
    assert flow.speeds["input"] == pytest.approx(30000 * RPM)
    assert abs(flow.speeds["output"]) == pytest.approx(1700 * RPM, rel=0.05)
    assert design.cases["cruise"].machines["electric"].power == pytest.approx(470.7e3 * 1000 / 2051, rel=1e-12)


def test_a_motor_as_fast_as_the_turbine_stays_so() -> None:
    design = for_engine(read(shipped_design("in-line-h1")), engine_speed=26000 * RPM)
    assert design.motors["electric"].speed == pytest.approx(26000 * RPM)


def test_efficiency_is_power_out_over_power_in() -> None:
    """Two planetary stages in line: each mesh loses 1 % of its tooth power, so 1 − η is some 2 %."""
    design = edited(read(shipped_design("in-line-h2")), {"gears.mesh_efficiency": 0.99})
    sizing = size(design)
    flow = sizing.flows["rated"]
    given = sum(power for power in flow.machine_powers.values() if power > 0.0)
    taken = -sum(power for power in flow.machine_powers.values() if power < 0.0)
    assert named_results(sizing)["efficiency"].value == pytest.approx(taken / given, rel=1e-12)
    assert 0.96 < taken / given < 0.99


def test_every_problem_of_a_study_file_is_told_at_once(tmp_path: Path) -> None:
    with pytest.raises(DesignError) as raised:
        study_of(tmp_path, HEAD + '[axes]\n"a.b" = {from = 3}\n"c.d" = {from = 2, to = 2, step = 1}\n')
    assert [(each.line, each.path) for each in raised.value.problems] == [(5, "axes.a.b"), (6, "axes.c.d")]


def test_errors_and_layout_may_be_varied_where_the_design_states_none(tmp_path: Path) -> None:
    axes = (
        '"errors.first.sun.eccentricity_um" = {values = [0, 20]}\n"layout.output.bore_ratio" = {values = [0.2, 0.5]}\n'
    )
    study = study_of(tmp_path, f'results = ["shaft_mass"]\n{HEAD}[axes]\n{axes}')
    designs = {"in-line-h2": read(shipped_design("in-line-h2"))}
    assert "first.sun" not in designs["in-line-h2"].errors and not designs["in-line-h2"].layout
    refuse_unknown_paths(study, designs)
    mass = run(study, designs).column("shaft_mass")
    assert mass[0] == mass[2] > mass[1] == mass[3]


@pytest.mark.parametrize(
    ("reasons", "kind"),
    [
        (
            ["cases.cruise.gas-turbine.power: needs 1469.2 kW, and gives 1468.9 kW",
             "cases.cruise.gas-turbine.power: needs 900 kW, and gives 850 kW"],
            "cases.cruise.gas-turbine.power: needs … kW, and gives … kW",
        ),
        (["layout.in-line-h2.length_mm: -3 mm", "layout.in-line-h2.length_mm: 1.2e-05 mm"],
         "layout.in-line-h2.length_mm: … mm"),
        (["bearing-2a: n = 20000. Take 3 (ISO 6336-3, ISO 281)", "bearing-2a: n = 9. Take 12 (ISO 6336-3, ISO 281)"],
         "bearing-2a: n = …. Take … (ISO 6336-3, ISO 281)"),
    ],
)  # fmt: skip
def test_reasons_that_differ_by_their_numbers_alone_are_one_and_names_stay_whole(reasons: list[str], kind: str) -> None:
    assert {kind_of(reason) for reason in reasons} == {kind}


def test_a_study_gives_the_same_rows_with_workers(tmp_path: Path) -> None:
    study = study_of(tmp_path, HEAD + '[axes]\n"carriers.fill" = {values = [0.4, 0.5]}\n')
    alone, helped = run(study), run(study, workers=1)
    assert helped == alone and len(helped.rows) == 2
