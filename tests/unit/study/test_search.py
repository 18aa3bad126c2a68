"""Pareto fronts, the search for them, sensitivities and exports, each against what is known in closed form."""

from __future__ import annotations

from pathlib import Path

import h5netcdf
import numpy as np
import pytest
from scipy.stats import sobol_indices

from gearwright.errors import DesignError, SolveError
from gearwright.shipped import shipped_design
from gearwright.sizing import Named
from gearwright.spec import Study, parse_study, read
from gearwright.study import run
from gearwright.study.answers import sensitivity
from gearwright.study.cases import Case, cases, generations
from gearwright.study.running import resume, run_study, table_of
from gearwright.study.tables import Row, Table, pareto_front, ranks, write_table


def study_of(text: str, *, axes: int = 2, designs: str = '"d"', low: float = 0.0, high: float = 1.0) -> Study:
    given = "\n".join(f'"x.{k}" = {{from = {low}, to = {high}}}' for k in range(axes))
    return parse_study(f'schema = 1\nname = "s"\ndesigns = [{designs}]\n[axes]\n{given}\n{text}')


def row_of(case: Case, results: dict[str, float]) -> Row:
    return Row(case.design, case.inputs, {name: Named(value, "ratio") for name, value in results.items()})


def searched(study: Study, function) -> list[Row]:  # type: ignore[no-untyped-def]
    """Return the rows of a search on a function of a case."""
    rows: list[Row] = []
    search = generations(study)
    batch = next(search)
    while True:
        found = [row_of(case, function(case)) for case in batch]
        rows += found
        try:
            batch = search.send(found)
        except StopIteration:
            return rows


def schaffer(case: Case) -> dict[str, float]:
    """Schaffer's first problem: minima of x² and (x − 2)²; its front is 0 ≤ x ≤ 2."""
    x = float(case.inputs["x.0"])
    return {"f": x**2, "g": (x - 2.0) ** 2, "c": x}


TWO = '[objectives]\nf = "minimum"\ng = "minimum"\n[sampling]\nmethod = "nsga2"\ncount = {}\npopulation = 40\n'


def test_the_search_finds_schaffers_front() -> None:
    """√f + √g = 2 on the front (Deb et al. 2002, table I: SCH); a hundredth off in x is 0.5 % of its length."""
    study = study_of(TWO.format(1200), axes=1, low=-10.0, high=10.0)
    rows = searched(study, schaffer)
    front = pareto_front(study, table_of(study, rows))
    f, g = (np.array([row.results[name].value for row in front]) for name in ("f", "g"))
    assert len(rows) == 1200
    off = np.abs(np.sqrt(f) + np.sqrt(g) - 2.0)
    assert np.mean(off < 0.02) > 0.95, "all but the ends, beyond which nothing beats a point yet"
    assert f.min() < 0.02 and f.max() > 3.6, "both ends are reached"
    assert np.diff(np.sqrt(np.sort(f))).max() < 0.25, "without a gap"


def test_a_constraint_holds_on_the_front() -> None:
    study = study_of(TWO.format(600) + "[constraints]\nc = {minimum = 1.0}\n", axes=1, low=-3.0, high=3.0)
    front = pareto_front(study, table_of(study, searched(study, schaffer)))
    x = [row.results["c"].value for row in front]
    assert min(x) >= 1.0
    assert min(x) < 1.02 and max(x) > 1.9


def test_the_choice_of_a_design_is_searched_too() -> None:
    study = study_of(TWO.format(200), axes=1, designs='"bad", "good"', low=0.0, high=3.0)
    rows = searched(study, lambda case: {k: v + (case.design == "bad") for k, v in schaffer(case).items()})
    assert {row.design for row in rows} == {"bad", "good"}
    assert {row.design for row in pareto_front(study, table_of(study, rows))} == {"good"}


def test_ranks_are_those_of_a_hand_made_set() -> None:
    values = np.array([[1.0, 4.0], [2.0, 2.0], [4.0, 1.0], [3.0, 3.0], [4.0, 4.0], [0.0, 0.0]])
    broken = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.1])
    assert ranks(values, broken).tolist() == [0, 0, 0, 1, 2, 3]


def test_a_front_needs_objectives_and_a_design_that_holds() -> None:
    drawn = '[sampling]\nmethod = "random"\ncount = 4\n'
    study = study_of(drawn, axes=1)
    with pytest.raises(DesignError, match="objectives"):
        pareto_front(study, Table("s", "", (), ()))
    bound = study_of(f'{drawn}[objectives]\nf = "minimum"\n[constraints]\nc = {{maximum = -1.0}}\n', axes=1)
    rows = [row_of(Case(0, "d", {"x.0": 1.0}), {"f": 1.0, "c": 0.0})]
    with pytest.raises(DesignError, match="relax one"):
        pareto_front(bound, Table("s", "", (), tuple(rows)))


def test_a_search_that_was_stopped_finds_the_same_front(tmp_path: Path) -> None:
    text = Path(__file__).with_name("search.toml").read_text(encoding="utf-8")
    study, designs = parse_study(text), {name: read(shipped_design(name)) for name in ("in-line-h2", "in-line-h1")}
    whole = run(study, designs)

    def stop(progress) -> None:  # type: ignore[no-untyped-def]
        if progress.done == 17:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_study(study, designs, journal=tmp_path / "j", watch=stop)
    assert resume(tmp_path / "j") == whole
    front = pareto_front(study, whole)
    assert {row.design for row in front} <= {"in-line-h1", "in-line-h2"}
    masses = [row.results["mass"].value for row in front]
    assert masses == sorted(masses)


def ishigami(case: Case) -> float:
    a, b, c = (float(case.inputs[f"x.{k}"]) for k in range(3))
    return np.sin(a) + 7.0 * np.sin(b) ** 2 + 0.1 * c**4 * np.sin(a)


def test_sensitivities_are_ishigamis() -> None:
    """Ishigami and Homma 1990 with a = 7, b = 0.1: S = 0.3139, 0.4424, 0; S_T = 0.5576, 0.4424, 0.2437."""
    study = study_of('[sampling]\nmethod = "saltelli"\ncount = 1024\n', axes=3, low=-np.pi, high=np.pi)
    study = study.model_copy(update={"results": ["f"]})
    rows = [row_of(case, {"f": ishigami(case)}) for case in cases(study)]
    found = {each.axis: each for each in sensitivity(study, table_of(study, rows), "f")}
    exact = {"x.0": (0.3139, 0.5576), "x.1": (0.4424, 0.4424), "x.2": (0.0, 0.2437)}
    for axis, (first, total) in exact.items():
        # 1024 Sobol' points leave some 0.02; the interval must hold the exact value but for one in twenty.
        assert found[axis].first == pytest.approx(first, abs=0.03)
        assert found[axis].total == pytest.approx(total, abs=0.03)
        low, high = found[axis].total_interval
        assert low <= found[axis].total <= high
        assert high - low < 0.25
    assert [each.axis for each in sensitivity(study, table_of(study, rows), "f")] == ["x.0", "x.1", "x.2"]
    assert sensitivity(study, table_of(study, rows), "f") == tuple(found.values()), "the seed gives the intervals, too"


def test_sensitivities_are_scipys_to_rounding() -> None:
    """scipy.stats.sobol_indices has the same estimators; its bootstrap takes no seed."""
    study = study_of('[sampling]\nmethod = "saltelli"\ncount = 64\n', axes=3, low=-np.pi, high=np.pi)
    rows = [row_of(case, {"f": ishigami(case)}) for case in cases(study)]
    blocks = np.array([row.number("f") for row in rows]).reshape(5, 1, 64)
    wanted = sobol_indices(func={"f_A": blocks[0], "f_B": blocks[1], "f_AB": blocks[2:]}, n=64)
    found = {each.axis: each for each in sensitivity(study, table_of(study, rows), "f")}
    for k in range(3):
        assert found[f"x.{k}"].first == pytest.approx(float(np.ravel(wanted.first_order)[k]), abs=1e-12)
        assert found[f"x.{k}"].total == pytest.approx(float(np.ravel(wanted.total_order)[k]), abs=1e-12)


def test_no_sensitivity_without_its_sample_or_with_failed_cases() -> None:
    grid = study_of('[sampling]\nmethod = "random"\ncount = 4\n', axes=1)
    with pytest.raises(DesignError, match="saltelli"):
        sensitivity(grid, Table("s", "", ("f",), ()), "f")
    study = study_of('[sampling]\nmethod = "saltelli"\ncount = 4\n', axes=2)
    rows = [row_of(case, {"mass": 1.0}) for case in cases(study)]
    with pytest.raises(SolveError, match="does not vary"):
        sensitivity(study, Table("s", "", ("mass",), tuple(rows)), "mass")
    rows[3] = Row("d", {}, {}, "why")
    with pytest.raises(SolveError, match="1 of 16 cases"):
        sensitivity(study, Table("s", "", ("mass",), tuple(rows)), "mass")


def test_a_table_is_read_back_from_netcdf_with_its_units(tmp_path: Path) -> None:
    text = 'schema = 1\nname = "s"\ndesigns = ["in-line-h2"]\n[axes]\n"planetaries.second.planets" = {values = [5, 9]}'
    table = run(parse_study(text), {"in-line-h2": read(shipped_design("in-line-h2"))})
    write_table(tmp_path / "t.nc", table)
    with h5netcdf.File(tmp_path / "t.nc", "r") as file:
        mass = file["mass"]
        assert mass.attrs["units"] == "kg"
        assert mass[0] == table.rows[0].results["mass"].value
        assert np.isnan(mass[1])
        assert list(file["planetaries.second.planets"][:]) == [5.0, 9.0]
        assert "9 planets do not fit" in file["problem"][1].decode()
    with pytest.raises(DesignError, match=r"\.nc or \.parquet"):
        write_table(tmp_path / "t.txt", table)
