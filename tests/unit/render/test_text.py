import io
import re

import pytest
from rich.console import Console

from gearwright.dynamics import Outputs, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.particulars import particulars
from gearwright.render.answers.design import size_answer
from gearwright.render.answers.motion import modes_answer, simulate_answer
from gearwright.render.answers.schema import plain
from gearwright.render.tables.dynamics import dynamic_table
from gearwright.render.tables.weights import summary
from gearwright.render.words.sizing import modes_text, sizing_text, trace_text
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.mass import complete_mass
from gearwright.spec import read
from gearwright.units import text


def on_screen(what, width=100) -> str:
    console = Console(file=io.StringIO(), width=width)
    console.print(what)
    return console.file.getvalue()


def test_the_terminal_report_tells_what_an_engineer_asks(in_line_h2) -> None:
    words = on_screen(sizing_text(particulars(in_line_h2)))
    for asked in ("46.27 kW/kg", "Margins, worst first", "499.4", "16035", "first.planet", "Carriers",
                  "Speeds that deviate from those asked", "Not in the mass: housing", "~ estimated"):  # fmt: skip
        assert asked in words, asked


def test_no_line_of_the_report_is_wider_than_the_terminal(in_line_h2) -> None:
    assert max(len(line) for line in on_screen(sizing_text(particulars(in_line_h2)), width=80).splitlines()) <= 80


def test_a_narrow_terminal_shows_every_number_whole(in_line_h2) -> None:
    wide, narrow = (on_screen(sizing_text(particulars(in_line_h2)), width=width) for width in (400, 60))
    numbers = re.compile(r"[−\d.e+-]*\d")
    assert set(numbers.findall(wide)) - set(numbers.findall(narrow)) == set()
    assert "continued" in narrow
    assert "continued" not in wide


def test_motors_are_named_only_where_there_are_some(designs) -> None:
    assert "Motors" in summary(particulars(designs["mixed"]))
    assert "Motors" not in summary(particulars(designs["star"]))


def test_groups_that_are_named_add_up_to_the_mass_that_is_told_and_the_complete_one_comes_first() -> None:
    sizing = size(read(shipped_design("hybrid-turboprop")))
    words = summary(particulars(sizing))
    complete = complete_mass(sizing)
    assert words.startswith(f"Complete mass {text(complete.total, 'mass', 3)}, 68 % from ")
    whole, *groups = (
        float(number) for number in re.findall(r"([\d.]+) kg", words.split("Train as sized ")[1].split(")")[0])
    )
    assert len(groups) == 4
    assert sum(groups) == pytest.approx(whole, rel=1e-3)


def test_the_answer_of_a_sizing_has_units_in_its_keys(in_line_h2) -> None:
    read = plain(size_answer(particulars(in_line_h2)))
    sun = read["gears"][0]
    assert sun["face_width_mm"] == 1e3 * in_line_h2.gears[0].face_width
    assert set(read["cases"]) == {"rated", "cruise"}
    assert read["mass_kg"] == in_line_h2.mass


def test_a_run_interrupted_before_its_statistics_begin_is_told_all_the_same(in_line_h2) -> None:
    """Statistics of the command begin at a quarter of the duration."""

    def stop(_: float) -> None:
        raise KeyboardInterrupt

    trace = simulate(assemble(in_line_h2), 0.1, outputs=Outputs(start=0.025), progress=stop)
    text = on_screen(trace_text(trace))
    assert "interrupted at" in text
    assert "its statistics had not begun" in text
    assert "Energy" in text
    assert not dynamic_table(in_line_h2, trace).rows


def test_modes_and_runs_are_told_in_words_and_as_answers(modal, run) -> None:
    assert "first.mesh" in on_screen(modes_text(modal))
    assert "peaks of line forces are right to" in on_screen(trace_text(run))
    assert plain(modes_answer(modal, "rated"))["modes"][0]["frequency_hz"] == 0.0
    assert plain(simulate_answer({"rated": run}))["energy"]["imbalance"] < 1e-6
