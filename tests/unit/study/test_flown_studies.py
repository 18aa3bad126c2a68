"""Studies that fly: axes over the mission's paths, results of the flight by name, a life that is asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from gearwright.errors import DesignError
from gearwright.mission import fly, gear_damage, size_for_life
from gearwright.render.tables.variants import study_csv, study_records
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import Study, case_count, edited_mission, mission_changed, parse_study, read, read_mission
from gearwright.study import Table, run
from gearwright.study.cases import refuse_unknown_paths
from gearwright.study.running import resume, run_study

HEAD = 'schema = 1\nname = "s"\ndesigns = ["in-line-h2"]\n[fly]\nmission = "thesis"\n'
COARSE = '[changes]\n"mission.step_s" = 300\n'
DESIGN = read(shipped_design("in-line-h2"))


def study_of(results: str, more: str) -> Study:
    return parse_study(f"results = {results}\n{HEAD}{COARSE}{more}")


def table_of(results: str, more: str = "") -> Table:
    return run(study_of(results, more), {"in-line-h2": DESIGN})


def test_results_of_a_flight_are_those_of_the_verb() -> None:
    results = '["fly.fuel", "fly.charge", "fly.life", "fly.flights", "fly.governing", "fly.cruise.fuel", "mass"]'
    (row,) = table_of(results).rows
    mission = edited_mission(read_mission(shipped_mission("thesis")), {"step_s": 300})
    flight = fly(size(DESIGN), mission)
    worst = gear_damage(flight)[0]
    assert row.number("fly.fuel") == flight.fuel
    assert row.number("fly.charge") == flight.history.state_of_charge[-1]
    assert row.number("fly.life") == worst.life * 3600.0 and row.shown("fly.life") == pytest.approx(worst.life)
    assert row.number("fly.flights") == worst.flights
    assert row.results["fly.governing"].value == f"{worst.gear}, {worst.mode}"
    assert 0.0 < row.number("fly.cruise.fuel") < row.number("fly.fuel")
    assert row.number("mass") == size(DESIGN).mass


def test_more_power_from_the_battery_saves_fuel_and_costs_charge() -> None:
    axis = '[axes]\n"mission.phases.cruise.electric_share" = {from = 0.32, to = 0.4, step = 0.04}\n'
    table = table_of('["fly.fuel", "fly.charge", "fly.electric_share"]', axis)
    assert table.column("fly.fuel") == sorted(table.column("fly.fuel"), reverse=True)
    assert table.column("fly.charge") == sorted(table.column("fly.charge"), reverse=True)
    assert table.column("fly.electric_share") == sorted(table.column("fly.electric_share"))


MISSION_AXES = (
    '[axes]\n"mission.phases.cruise.duration_min" = {distribution = "triangular", from = 30, likeliest = 35, to = 42}\n'
    '"mission.gears.hardness_hv" = {distribution = "normal", mean = 700, deviation = 20}\n'
    '"mission.battery.energy_kwh" = {distribution = "log-uniform", from = 700, to = 900}\n'
    '"mission.gears.grade" = {values = ["MQ", "ME"]}\n"carriers.fill" = {from = 0.5, to = 0.7}\n'
)


@pytest.mark.parametrize(
    ("method", "count", "cases"), [("random", 3, 3), ("sobol", 4, 4), ("latin-hypercube", 3, 3), ("saltelli", 1, 7)]
)
def test_every_way_of_sampling_reaches_the_mission_and_repeats_bit_for_bit(method: str, count: int, cases: int) -> None:
    sampling = f'{MISSION_AXES}[sampling]\nmethod = "{method}"\ncount = {count}\nseed = 5\n'
    first, second = (table_of('["fly.life", "fly.fuel", "mass"]', sampling) for _ in range(2))
    assert len(first.rows) == cases and first.failed == ()
    assert first == second
    if method != "saltelli":
        assert len(set(first.column("fly.life"))) == cases


@pytest.mark.parametrize(("method", "cases"), [("grid", 4), ("list", 2)])
def test_grids_and_lists_join_paths_of_design_and_mission(method: str, cases: int) -> None:
    cruise = '"mission.phases.cruise.duration_min" = {values = [40, 30]}'
    axes = f'[axes]\n"gears.bending_safety" = {{values = [2.5, 2.6]}}\n{cruise}\n'
    table = table_of('["fly.life"]', f'{axes}[sampling]\nmethod = "{method}"\n')
    assert len(table.rows) == cases
    assert len(set(table.column("fly.life"))) == cases


def test_a_life_that_is_asked_for_costs_mass() -> None:
    as_sized = table_of('["mass", "fly.life"]').rows[0]
    parse = study_of('["mass", "fly.life"]', "").model_copy()
    strengthened = run(
        parse.model_copy(update={"fly": parse.fly.model_copy(update={"life": 5e3 * 3600.0})}), {"in-line-h2": DESIGN}
    ).rows[0]
    mission = edited_mission(read_mission(shipped_mission("thesis")), {"step_s": 300})
    assert strengthened.number("mass") == size_for_life(DESIGN, mission, 5e3).sizing.mass
    assert as_sized.number("fly.life") < 5e3 * 3600.0 <= strengthened.number("fly.life")
    assert strengthened.number("mass") > as_sized.number("mass")


def test_the_governing_part_is_a_text_in_tables_and_no_objective() -> None:
    """4223 h are 1.2e10 cycles of the first sun, 3 · 15 500 rpm against its planets: there its line still falls."""
    table = table_of('["fly.governing", "fly.fuel"]')
    assert table.numbers == ("fly.fuel",)
    assert study_records(table)[0]["fly.governing"] == "first.sun, pitting"
    assert '"first.sun, pitting"' in study_csv(table)
    with pytest.raises(DesignError, match="is a name and no number"):
        table.column("fly.governing")


def test_a_journal_holds_the_mission_and_needs_no_file_of_it(tmp_path: Path) -> None:
    axis = '[axes]\n"mission.phases.cruise.duration_min" = {values = [30, 35, 40]}\n'
    mission = tmp_path / "own.toml"
    mission.write_text(shipped_mission("thesis").read_text(encoding="utf-8"), encoding="utf-8")
    text = f'results = ["fly.fuel"]\n{HEAD}{COARSE}{axis}'.replace('"thesis"', '"own.toml"')
    study = parse_study(text, folder=tmp_path)
    mission.unlink()
    table = run_study(study, {"in-line-h2": DESIGN}, journal=tmp_path / "j")
    assert resume(tmp_path / "j") == table == run_study(study, {"in-line-h2": DESIGN}, workers=1)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('results = ["fly.fuel"]\nschema = 1\nname = "s"\ndesigns = ["a"]\n', '[fly] mission = "thesis"'),
        (
            'schema = 1\nname = "s"\ndesigns = ["a"]\n[axes]\n"mission.step_s" = {values = [10]}\n',
            "axes.mission.step_s: nothing says what is flown",
        ),
        (HEAD.replace("thesis", "thesiss"), "did you mean thesis?"),
        (f"{HEAD}[mission]\nname = 'm'\n[mission.phases.a]\naltitude_m = 0\npropeller_speed_rpm = 9\n", "keep one"),
        (f"{HEAD}[axes]\n'mission.phases.cruse.duration_min' = {{values = [30]}}\n", "did you mean cruise?"),
        (f"{HEAD}[axes]\n'mission.phases.cruise.duration' = {{values = [30]}}\n", "did you mean duration_"),
        (f"{HEAD}[axes]\n'mission.bttery.energy_kwh' = {{values = [30]}}\n", "did you mean battery?"),
        (f"{HEAD}[changes]\n'misson.step_s' = 10\n", "there is no misson"),
    ],
)
def test_what_a_study_cannot_fly_is_named_before_it_starts(text: str, said: str) -> None:
    with pytest.raises(DesignError) as raised:
        study = parse_study(text)
        case_count(study)
        refuse_unknown_paths(study, {"in-line-h2": DESIGN})
    assert said in str(raised.value)


def test_what_cannot_be_flown_is_a_row_with_its_reason() -> None:
    axis = '[axes]\n"mission.battery.energy_kwh" = {values = [100, 700]}\n'
    table = table_of('["fly.charge"]', axis)
    assert [bool(row.problem) for row in table.rows] == [True, False]
    assert "battery" in table.failed[0].problem


def test_resume_notices_a_mission_that_has_changed(tmp_path: Path) -> None:
    text = shipped_mission("thesis").read_text(encoding="utf-8")
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    study = parse_study(f'results = ["fly.fuel"]\n{HEAD}'.replace('"thesis"', '"own.toml"'), folder=tmp_path)
    assert not mission_changed(study, tmp_path)
    (tmp_path / "own.toml").write_text(text.replace("duration_min = 40", "duration_min = 41"), encoding="utf-8")
    assert mission_changed(study, tmp_path)
    (tmp_path / "own.toml").unlink()
    assert not mission_changed(study, tmp_path), "the journal has it"
