"""Beams on two bearings: balance, overhang, couples, and what is refused."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

from gearwright.errors import DesignError
from gearwright.parts.shafts import PointLoads, bearing_reactions, diagram, supported


def loads(position, force, couple=None, torque=None):
    """Return point loads; what is left out is zero."""
    force = np.asarray(force, dtype=float)
    couple = np.zeros_like(force) if couple is None else np.asarray(couple, dtype=float)
    torque = np.zeros_like(force) if torque is None else np.asarray(torque, dtype=float)
    return PointLoads(np.asarray(position, dtype=float), force, couple, torque)


values = st.floats(-1e4, 1e4)
point = st.tuples(st.floats(0.0, 0.5), values, values, values, values)


@given(st.lists(point, min_size=1, max_size=6), st.floats(0.0, 0.2), st.floats(0.25, 0.5))
def test_reactions_balance_and_moments_vanish_at_both_ends(points, first, second):
    """Equilibrium in both planes; 1e-12 of the largest load is rounding of a dozen additions over a span of L/10."""
    position, y, z, couple_y, couple_z = np.array(points).T
    given_loads = loads(position, [y, z], [couple_y, couple_z])
    whole = supported(given_loads, (first, second), length=0.5)
    scale = 1.0 + np.abs(whole.force).max() + np.abs(whole.couple).max()
    assert np.abs(whole.force.sum(axis=-1)).max() < 1e-12 * scale
    assert np.abs(whole.force @ whole.position + whole.couple.sum(axis=-1)).max() < 1e-12 * scale
    ends = diagram(whole)
    assert np.abs(ends.bending[..., [0, -1]]).max() < 1e-12 * scale
    assert np.abs(ends.shear[..., [0, -1]]).max() < 1e-12 * scale


def test_an_overhung_load_bends_the_shaft_over_its_near_bearing():
    """Force F at distance c outside the bearing: M = −F c there, reactions −F c/L and F (1 + c/L)."""
    whole = supported(loads([0.0], [-100.0]), (0.1, 0.3), length=0.4)
    assert whole.force[1:].tolist() == pytest.approx([150.0, -50.0], rel=1e-14)
    drawn = diagram(whole)
    assert drawn.bending.tolist() == pytest.approx([0.0, 0.0, -10.0, -10.0, 0.0, 0.0], abs=1e-13)


def test_a_couple_makes_the_bending_moment_jump_and_its_reactions_a_pair():
    """Couple C in mid-span L: reactions ±C/L, moment from +C/2 to −C/2; exact in binary."""
    whole = supported(loads([0.5], [0.0], [8.0]), (0.0, 1.0), length=1.0)
    assert whole.force[1:].tolist() == [8.0, -8.0]
    assert diagram(whole).bending.tolist() == [0.0, 0.0, 4.0, -4.0, 0.0, 0.0]


def test_the_bearings_may_be_named_in_either_order():
    one = loads([0.2], [-60.0])
    assert bearing_reactions(one, (0.0, 0.3)) == pytest.approx(bearing_reactions(one, (0.3, 0.0))[::-1])


def test_planes_and_cases_do_not_touch_each_other():
    """One call over three cases and two planes gives what six calls give; the sums differ at most in their order."""
    rng = np.random.default_rng(4)
    position, force, couple = rng.uniform(0.0, 1.0, 5), rng.normal(size=(3, 2, 5)), rng.normal(size=(3, 2, 5))
    together = diagram(supported(loads(position, force, couple), (0.1, 0.8), length=1.0))
    for index in np.ndindex(3, 2):
        alone = diagram(supported(loads(position, force[index], couple[index]), (0.1, 0.8), length=1.0))
        assert together.bending[index] == pytest.approx(alone.bending, rel=1e-12, abs=1e-13)


def test_torsion_runs_between_the_torques_also_where_two_stand_at_one_place():
    """A hub and a machine at the same end exchange their torque there: the station between them shows it."""
    drawn = diagram(loads([0.3, 0.0, 0.3], [0.0, 0.0, 0.0], torque=[50.0, 20.0, -70.0]))
    assert drawn.position.tolist() == [0.0, 0.0, 0.3, 0.3, 0.3, 0.3]
    assert drawn.torsion.tolist() == [0.0, 20.0, 20.0, 70.0, 70.0, 0.0]


@pytest.mark.parametrize("bearings", [(0.1,), (0.1, 0.2, 0.3), (0.1, 0.1)])
def test_a_shaft_without_two_bearings_at_two_places_is_refused(bearings):
    with pytest.raises(DesignError, match="bearings"):
        bearing_reactions(loads([0.2], [1.0]), bearings)


@pytest.mark.parametrize(("position", "bearings", "named"), [(0.6, (0.0, 0.5), "loads: 600 mm"),
                                                             (0.2, (-0.01, 0.5), "bearings: -10 mm")])  # fmt: skip
def test_what_stands_outside_the_shaft_is_refused(position, bearings, named):
    with pytest.raises(DesignError, match=named):
        supported(loads([position], [1.0]), bearings, length=0.5)
