"""The headline tells the worst of all that a page shows."""

from dataclasses import replace

import pytest

from gearwright.dynamics import Outputs, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.vibration import critical_speeds
from gearwright.render.pages.report import report
from gearwright.render.tables.dynamic_load import dynamic_loads
from gearwright.render.words.headline import energy_text, resonances, worst_margin
from gearwright.render.words.text import summary


@pytest.fixture(scope="module")
def trace(in_line_h2):
    return simulate(assemble(in_line_h2, stiffness="varying"), 0.002, outputs=Outputs(start=0.0005))


def test_peaks_below_the_rated_margin_are_the_headline(in_line_h2, trace) -> None:
    peak = min(min(load.bending_margin, load.contact_margin) for load in dynamic_loads(in_line_h2, trace))
    assert peak < in_line_h2.worst_margin
    assert f"worst margin {peak:.3f} (" in summary(in_line_h2, trace)
    assert "1.000 at the rated loads" in worst_margin(in_line_h2, trace)
    assert f"<dd>{peak:.3f} (" in report(in_line_h2, trace=trace)


def test_without_a_run_the_headline_is_the_rated_margin(in_line_h2) -> None:
    assert worst_margin(in_line_h2) == "1.000"


def test_a_resonance_is_in_the_numbers_and_the_warnings_of_the_page(in_line_h2) -> None:
    """One excited critical speed 1.11 % above the operating speed, and one that is not excited."""
    case = critical_speeds(in_line_h2, cases=["cruise"])[0]
    first = replace(case.critical[0], margin=0.0111, dynamic_force=0.5)
    silent = replace(first, margin=0.001, dynamic_force=0.0)
    near = replace(case, critical=(first, silent))
    (words,) = resonances([near])
    assert "1.11% above the operating speed (case cruise)" in words
    assert "more" not in words
    assert resonances([replace(case, critical=(silent,))]) == ()
    assert report(in_line_h2, campbell=[near]).count("1.11% above the operating speed") >= 2


def test_an_energy_book_that_closes_says_so() -> None:
    assert energy_text(0.0) == "to rounding"
    assert energy_text(3.2e-7) == "within 3.2e-07"
