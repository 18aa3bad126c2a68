"""A design's K_γ against the number of its planets, beside the closed form."""

from __future__ import annotations

import functools

import pytest

from gearwright.dynamics.sharing import influences, planet_counts, sharing_problem, sharing_study
from gearwright.render.figures.dynamics import planets_figure, planets_text
from gearwright.render.pages.motion import sharing_page
from gearwright.render.style import to_svg
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read

ERRORS = '\n[errors."first.planet-1"]\npin_tangential_um = 10\n'


@functools.cache
def sized(path):
    return size(read(path))


@pytest.fixture
def misplaced(tmp_path):
    """The shipped set of two planets, one pin 10 µm out of place."""
    path = tmp_path / "misplaced.toml"
    path.write_text(shipped_design("single-planetary").read_text(encoding="utf-8") + ERRORS, encoding="utf-8")
    return sized(path)


def test_the_closed_form_of_a_design_is_what_its_own_pin_does(misplaced):
    """Two planets on a fixed sun: b changes by N (N − 1)/N K e/F. The train's shafts are outside the loop; rounding."""
    problem = sharing_problem(misplaced)
    (own,) = influences(problem.train, problem.sources, problem.places)
    found = planet_counts(misplaced, problem, planets=(2,))
    assert found.fixed[2] - 1.0 == pytest.approx(own.effect, rel=1e-9)


def test_the_closed_form_ends_where_a_planet_loses_its_load(tmp_path):
    """40 µm: K e/F = 1.3 on a fixed sun; floating, the neighbour of one of four loses as much, of three nothing."""
    path = tmp_path / "worse.toml"
    text = shipped_design("single-planetary").read_text(encoding="utf-8") + ERRORS.replace("10", "40")
    path.write_text(text, encoding="utf-8")
    found = planet_counts(sized(path), sharing_problem(sized(path)))
    assert found.fixed == {}
    assert list(found.floating) == [3]
    assert found.floating[3] == pytest.approx(1.0, abs=1e-12)


def test_a_design_without_planet_errors_has_no_counts():
    sizing = sized(shipped_design("single-planetary"))
    assert planet_counts(sizing, sharing_problem(sizing)) is None


def test_tables_of_standards_stand_beside_the_computed_factors(misplaced):
    found = planet_counts(misplaced, sharing_problem(misplaced))
    columns = [str(column.header) for column in planets_text(found).renderables[0].table.columns]
    assert columns[0] == "planets"
    assert {"one pin, floating", "IEC 61400-4:2012, wind turbine", "AGMA 6123-B06, level 4"} < set(columns)
    assert "IEC 61400-4:2012" in to_svg(planets_figure(found))


def test_the_page_shows_the_counts_that_it_is_given(misplaced):
    problem = sharing_problem(misplaced)
    study, found = sharing_study(problem), planet_counts(misplaced, problem, seed=2)
    assert "Planets of stage first" in sharing_page(misplaced, [study], counts=[found])
    assert "Planets of stage" not in sharing_page(misplaced, [study])
