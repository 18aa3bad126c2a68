"""The page of a study answers first, and draws what its method gives."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from gearwright.render import style as theme
from gearwright.render.figures.study import contour_figure, draw_ranges, figure_of, parallel_figure, study_figure
from gearwright.render.pages.studies import study_page
from gearwright.render.tables.variants import reasons, spread
from gearwright.render.vector.figure import Curve
from gearwright.render.words.study import answer
from gearwright.shipped import shipped_design
from gearwright.sizing import Named
from gearwright.spec import Study, parse_study, read
from gearwright.study import Row, Table, run

HEAD = 'schema = 1\nname = "s"\ndesigns = ["in-line-h1", "in-line-h2"]\nresults = ["mass", "efficiency"]\n'
FILL = '[axes]\n"carriers.fill" = {from = 0.4, to = 0.8}\n"planetaries.second.planets" = {values = [3, 4, 9]}\n'


def page_of(text: str) -> tuple[Study, Table, str]:
    study = parse_study(text)
    designs = {name: read(shipped_design(name)) for name in study.designs}
    table = run(study, designs)
    page = study_page(study, table, designs)
    return study, table, re.sub(r"<svg.*?</svg>", "<svg/>", page, flags=re.DOTALL)


def test_the_page_says_which_design_wins_by_how_much_and_how_surely() -> None:
    sampling = '[sampling]\nmethod = "sobol"\ncount = 16\n[objectives]\nmass = "minimum"\nefficiency = "maximum"\n'
    _, table, page = page_of(HEAD + FILL.replace(", 9]", "]") + sampling)
    one, two = (table.column("mass")[16 * k : 16 * (k + 1)] for k in (0, 1))
    assert all(second < first for first, second in zip(one, two, strict=True)), "H2 is lighter at equal inputs"
    assert "in-line-h2 wins" in page and "next is in-line-h1" in page
    assert "It is first in 16 of 16 cases with equal inputs, 100 % (95 % confidence: 81 % to 100 %)." in page
    less = 100.0 * (1.0 - float(np.median(np.array(two) / np.array(one))))
    assert f"better in train as sized {less:.2g} % less (16 of 16 better)" in page
    assert page.count("<svg/>") == 4, "trade, weights, winner and next"


def test_a_design_that_often_fails_does_not_win_and_like_reasons_count_together() -> None:
    sampling = '[sampling]\nmethod = "sobol"\ncount = 16\n[objectives]\nmass = "minimum"\n'
    _, table, page = page_of(HEAD + FILL + sampling)
    assert table.failed
    assert "9 planets do not fit" not in page and "… planets do not fit" in page


def good(table: Table, design: str) -> list:  # type: ignore[type-arg]
    return [row for row in table.rows if row.design == design and not row.problem]


@pytest.mark.parametrize(
    ("more", "drawn"),
    [
        (
            '[sampling]\nmethod = "nsga2"\ncount = 24\npopulation = 8\n'
            '[objectives]\nmass = "minimum"\nmotor_mass = "minimum"',
            {"Pareto front": 2, "Spread": 1, "The chosen designs": 2},
        ),
        ("", {"Cases": 1}),
    ],
)
def test_every_method_has_its_figures(more: str, drawn: dict[str, int]) -> None:
    axes = '[axes]\n"carriers.fill" = {values = [0.5, 0.6]}\n'
    _, _, page = page_of(HEAD + axes + more)
    sections = re.findall(r"<section.*?<h2[^>]*>(.*?)</h2>(.*?)</section>", page, flags=re.DOTALL)
    assert {head: count for head, body in sections if (count := body.count("<svg/>"))} == drawn


def test_a_sensitivity_study_has_a_tornado_and_says_what_does_not_vary() -> None:
    axes = '[axes]\n"carriers.fill" = {from = 0.4, to = 0.8}\n"gears.bending_safety" = {from = 2.4, to = 2.6}\n'
    text = HEAD.replace('"in-line-h1", ', "") + axes
    _, _, page = page_of(text + '[sampling]\nmethod = "saltelli"\ncount = 8\n')
    assert "efficiency: efficiency does not vary" in page
    assert page.count("<svg/>") == 3, "tornado, distributions, contour"


def test_figures_are_the_same_each_time_and_leave_out_what_is_constant() -> None:
    _, table, _ = page_of(
        HEAD.replace('"in-line-h1", ', "") + '[axes]\n"carriers.fill" = {from = 0.4, to = 0.8}\n'
        '"motors.electric.speed_rpm" = {from = 4000, to = 5000}\n[sampling]\nmethod = "sobol"\ncount = 16\n'
    )
    drawn = parallel_figure(table)
    assert drawn.axes[0].x.names[-1] == "train as sized\n[kg]"
    assert theme.to_svg(contour_figure(table, "mass")) == theme.to_svg(contour_figure(table, "mass"))
    assert contour_figure(table, "mass").axes[0].x.label == "carriers.fill"


def test_the_spread_is_that_of_the_numbers() -> None:
    _, table, _ = page_of(HEAD + FILL + '[sampling]\nmethod = "random"\ncount = 6\n')
    mass = [row.results["mass"].value for row in table.rows if not row.problem]
    line = spread(table)[0]
    assert (line.result, line.unit) == ("mass", "kg")
    assert line.values[0] == f"{min(mass):.2f}" and line.values[-1] == f"{max(mass):.2f}"
    assert len(reasons(table)) <= 3


OBJECTIVES = '[objectives]\nmass = "minimum"\nmotor_mass = "maximum"\n'


@pytest.mark.parametrize(
    ("head", "more", "label"),
    [
        (HEAD, "", "train as sized [kg]"),
        (HEAD.replace('"in-line-h1", ', ""), OBJECTIVES, "train as sized [kg]: minimum"),
    ],
)
def test_the_figure_suits_the_method(head: str, more: str, label: str) -> None:
    study, table, _ = page_of(head + FILL + '[sampling]\nmethod = "sobol"\ncount = 8\n' + more)
    assert figure_of(study, table).axes[0].x.label == label


def test_designs_at_equal_inputs_are_a_trade_objective_by_objective() -> None:
    study, table, _ = page_of(HEAD + FILL + '[sampling]\nmethod = "sobol"\ncount = 8\n' + OBJECTIVES)
    panels = figure_of(study, table).axes
    assert [panel.title for panel in panels] == [
        "train as sized\n[kg]\nlower is better",
        "motors [kg]\nhigher is better",
    ]
    assert set(panels[0].y.names) == {"in-line-h1", "in-line-h2"}


def test_axes_that_were_changed_together_are_one_line_with_the_ends_of_the_trade() -> None:
    speeds = '"motors.electric.speed_rpm" = {values = [4000, 4200, 4400]}'
    axes = f'[axes]\n"carriers.fill" = {{values = [0.4, 0.6, 0.8]}}\n{speeds}\n'
    _, table, page = page_of(HEAD.replace('"in-line-h1", ', "") + axes + '[sampling]\nmethod = "list"\n' + OBJECTIVES)
    assert table.free == ("motors.electric.speed_rpm",)
    assert "From motors.electric.speed_rpm = 4000 to 4400: train as sized" in page
    assert study_figure(table).axes[0].of(Curve)[0].x.tolist() == [4000, 4200, 4400]


@pytest.mark.parametrize("designs", [("in-line-h2", "mixed-h2", "in-line"), ("in-line-h2",)])
@pytest.mark.parametrize("method", ['method = "sobol"\ncount = 4\n', 'method = "list"\n'])
@pytest.mark.parametrize("more", ["", '[objectives]\nmass = "minimum"\n"modes.lowest_critical_speed" = "maximum"\n'])
def test_results_without_an_end_are_written_so_and_break_no_figure(
    designs: tuple[str, ...], method: str, more: str
) -> None:
    """A lowest critical speed is infinite where nothing is excited; warnings count as errors here."""
    listed = ", ".join(f'"{name}"' for name in designs)
    head = f'schema = 1\nname = "s"\ndesigns = [{listed}]\nresults = ["mass", "modes.lowest_critical_speed"]\n'
    study = parse_study(f'{head}{more}[axes]\n"carriers.fill" = {{values = [0.5, 0.6, 0.7]}}\n[sampling]\n{method}')
    rows = [
        Row(name, {"carriers.fill": fill}, {
            "mass": Named(40.0 + k + fill, "mass"),
            "modes.lowest_critical_speed": Named(math.inf if k == 1 or fill > 0.55 else 200.0 + k, "speed"),
        })
        for k, name in enumerate(designs)
        for fill in (0.5, 0.6, 0.7)
    ]  # fmt: skip
    table = Table("s", "", study.asked, tuple(rows), tied=study.sampling.method == "list")
    page = study_page(study, table, {name: read(shipped_design(name)) for name in designs})
    assert "nan" not in re.sub(r"<svg.*?</svg>", "", page, flags=re.DOTALL)
    assert figure_of(study, table)


def test_one_life_of_nothing_leaves_an_axis_over_decades_logarithmic() -> None:
    """Quantiles are drawn: a gear that does not live at all in one case of fifty is not among them."""
    lives = [np.array([0.0, *np.geomspace(1.0, 100.0, 49)]), np.geomspace(1e4, 1e7, 50)]
    panel = theme.sheet(80.0, 40.0).panel()
    draw_ranges(panel, lives)
    assert panel.x.log


def test_what_makes_no_difference_has_no_number_of_more_or_less() -> None:
    objectives = '[objectives]\nmass = "minimum"\nefficiency = "maximum"\n'
    study = parse_study(HEAD + FILL + objectives + '[sampling]\nmethod = "sobol"\ncount = 8\n')
    rows = [
        Row(name, {"carriers.fill": 0.5 + 0.01 * k}, {
            "mass": Named(50.0 - 10.0 * place, "mass"), "efficiency": Named(0.97 + 0.01 * ((k + place) % 2), ""),
        })
        for place, name in enumerate(study.designs)
        for k in range(8)
    ]  # fmt: skip
    said = " ".join(answer(study, Table("s", "", study.asked, tuple(rows))))
    assert (
        "in-line-h2 against in-line-h1, medians at equal inputs: better in train as sized 20 % less (8 of 8 better);"
        in said
    )
    assert "no difference to tell in efficiency (4 of 8 better)." in said


def test_the_best_of_an_objective_keeps_the_constraints() -> None:
    axes = '[axes]\n"carriers.fill" = {values = [0.4, 0.6, 0.8]}\n[objectives]\nmass = "minimum"\n'
    head = HEAD.replace('"in-line-h1", ', "")
    _, table, page = page_of(f"{head}{axes}[constraints]\nmass = {{minimum = 43.5}}\n")
    assert table.rows[0].shown("mass") < 43.5 < table.rows[1].shown("mass")
    assert "Minimum train as sized: in-line-h2 at carriers.fill = 0.6" in page
    assert "train as sized ≥ 43.5 kg is kept in 2 of 3 cases." in page
