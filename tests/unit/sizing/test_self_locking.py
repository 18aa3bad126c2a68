"""Efficiencies forwards and backwards in the answers of a sizing; self-locking by name, and a case that meets it."""

import math

import pytest

from designs import changed
from gearwright.reviews import review_of
from gearwright.shipped import shipped_design
from gearwright.sizing import named_results, passing, size
from gearwright.spec import parse

WOLFROM = shipped_design("wolfrom-reducer").read_text(encoding="utf-8")
IN_LINE = shipped_design("in-line").read_text(encoding="utf-8")
POOR = changed(WOLFROM, "mesh_efficiency = 0.99", "mesh_efficiency = 0.97")
DRIVEN = """
[cases.rated]
motor = { balances = true, speed_rpm = 3240 }
flap = { power_kw = 0.1, drives = true }
"""


def test_a_wolfrom_reducer_tells_both_efficiencies():
    """0.710437 and 0.598514 by an independent program."""
    sizing = size(parse(WOLFROM))
    [row] = passing(sizing)
    assert (row.part, row.driving, row.driven, row.locking) == ("wolfrom", "fast", "slow", "")
    assert (row.forwards, row.backwards) == pytest.approx((0.710437, 0.598514), rel=1e-6)
    results = named_results(sizing)
    assert results["efficiency"].value == pytest.approx(row.forwards, rel=1e-12)
    assert results["efficiency_backwards"].value == pytest.approx(row.backwards, rel=1e-12)


def test_a_reducer_of_poor_meshes_says_that_it_is_self_locking():
    sizing = size(parse(POOR))
    [row] = passing(sizing)
    assert row.locking == "self-locking: slow cannot drive it, only fast can"
    assert row.backwards < 0.0 < row.forwards
    assert not [check for check in sizing.checks if check.mode == "self-locking"]


def test_a_case_that_drives_a_self_locking_reducer_from_its_driven_side_fails_by_name():
    """The flap gives 0.1 kW, and the motor has to give 0.02 kW more instead of taking some."""
    sizing = size(parse(changed(POOR, "balances = false", "balances = true") + DRIVEN))
    [check] = [check for check in sizing.checks if check.mode == "self-locking"]
    assert check.fails and check.case == "rated" and str(check.part) == "wolfrom"
    assert check.why == "slow cannot drive it, only fast can"
    assert check.value == pytest.approx(100.0 * 1.209135, rel=1e-5)
    assert check in review_of(sizing).failing


def test_a_gearbox_of_two_sets_in_a_row_passes_what_each_passes_of_the_other():
    sizing = size(parse(changed(IN_LINE, "[gears]", "[gears]\nmesh_efficiency = 0.99")))
    whole, *sets = [row for row in passing(sizing) if row.case == sizing.reference.case]
    assert whole.part == "gearbox" and len(sets) == 2
    assert whole.forwards == pytest.approx(math.prod(row.forwards for row in sets), rel=1e-12)
    assert whole.backwards == pytest.approx(math.prod(row.backwards for row in sets), rel=1e-12)
    assert 0.9 < whole.backwards < 1.0
