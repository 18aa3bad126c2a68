"""Which load case is looked at where none is named: the one that sizes, and those that fail."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.vibration import answer
from gearwright.reviews import review_of
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import governing_case, size, telling_cases
from gearwright.sizing.losses import loss_balance
from gearwright.spec import parse
from shipped_work import sized


@pytest.mark.parametrize("name", shipped_designs())
def test_the_governing_case_has_the_least_margin_and_stands_first_of_equals(name):
    sizing = sized(name)
    margins = {}
    for check in sizing.checks:
        if check.case and check.margin is not None:
            margins[check.case] = min(check.margin, margins.get(check.case, np.inf))
    governing = governing_case(sizing)
    assert margins[governing] == pytest.approx(min(margins.values()), rel=1e-6)
    before = list(sizing.design.cases)[: list(sizing.design.cases).index(governing)] if sizing.design.cases else []
    assert all(margins.get(case, np.inf) > margins[governing] * (1.0 + 1e-6) for case in before)


def test_a_gearbox_is_simulated_in_the_case_that_sizes_it_and_not_in_the_first_of_its_file():
    """in-line-h2 writes cruise, which loads it less, before the rated case that sizes every part of it."""
    sizing = sized("in-line-h2")
    assert next(iter(sizing.design.cases)) == "cruise"
    assert governing_case(sizing) == "rated"
    np.testing.assert_array_equal(
        assemble(sizing).arrays.loads.constant, assemble(sizing, "rated").arrays.loads.constant
    )


def test_cases_that_fail_beside_the_governing_one_are_told_in_the_order_of_the_file():
    sizing = sized("ravigneaux-automatic")
    margins = {"reverse": 0.8, "first": 0.9, "third": 0.7, "second": 1.2}
    loaded = {check.case: check for check in sizing.checks if check.margin is not None and check.limit}
    checks = [
        replace(loaded[case], at_most=True, value=1.0, limit=margin, exponent=1.0) for case, margin in margins.items()
    ]
    assert telling_cases(replace(sizing, checks=tuple(checks))) == ("third", "first", "reverse")


def test_a_case_in_which_nothing_turns_governs_no_run():
    sizing = sized("e-axle")
    parked = next(check for check in sizing.checks if check.case == "parked" and check.limit is not None)
    worse = replace(parked, at_most=True, value=1.0, limit=0.1, exponent=1.0)
    assert telling_cases(replace(sizing, checks=(*sizing.checks, worse))) == ("launch",)


def test_the_teeth_of_a_compound_set_err_in_the_phases_of_the_case_that_was_assembled():
    """In reverse the planets turn the other way against the carrier, and so do the phases of their meshes."""
    sizing = sized("ravigneaux-automatic")
    system, row = assemble(sizing, "reverse"), "gear.long-ring"
    own = answer(sizing, system, row, case="reverse").line_force
    other = answer(sizing, system, row, case="second").line_force
    assert np.max(np.abs(own - other)) > 0.1 * np.max(np.abs(own))


@pytest.mark.parametrize("name", ["ravigneaux-automatic", "e-axle"])
def test_a_shaft_turns_as_fast_as_in_the_case_that_its_row_names(name):
    sizing = sized(name)
    assert len({shaft.case for shaft in sizing.shafts}) > 1 or name == "e-axle"
    assert all(shaft.speed == sizing.flows[shaft.case].speeds[shaft.name] for shaft in sizing.shafts)


def test_the_oil_carries_away_the_heat_of_the_hottest_case_that_lasts():
    """The rated case under another name no longer speaks for the design, yet the oil has to bear it."""
    text = shipped_design("in-line-h2").read_text(encoding="utf-8").replace("cases.rated", "cases.full")
    sizing = size(parse(text))
    assert sizing.reference.case == "cruise"
    hottest = loss_balance(sizing, "full").lost
    assert hottest > 1.1 * loss_balance(sizing, "cruise").lost
    assert review_of(sizing).facts["heat"].value == pytest.approx(hottest, rel=1e-12)
