"""Corners of methods in sizing: what the smaller of two reserves is, rims that are none, the least width."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from designs import PAIR
from gearwright.identity import Role
from gearwright.parts.agma2003 import BevelEdition
from gearwright.sizing import size
from gearwright.sizing.rating import METHODS, Factor, rim_below_roots
from gearwright.sizing.rating.agma import limited
from gearwright.sizing.rating.geometry import narrowest
from gearwright.spec import parse


@pytest.mark.parametrize("method", ["agma2003", "agma2001", "iso6336", "iso10300"])
def test_loads_may_grow_by_the_root_or_by_the_square_of_the_flank_whichever_is_less(method):
    """σ_H goes with √F, σ_F with F."""
    for bending, contact, reserve in ((1.3, 1.2, 1.3), (1.6, 1.2, 1.44)):
        assert METHODS[method].reserve(
            SimpleNamespace(bending_margin=bending, contact_margin=contact)  # type: ignore[arg-type]
        ) == pytest.approx(reserve, rel=1e-12)


def test_rims_of_wheels_and_rings_below_their_roots():
    """Rim ratio 0.8 of h_t = 2.25 m_n; a ring's wall of 3.95 m_n less 1.25; a pinion has none, unless it is a ring."""
    rating = SimpleNamespace(rules=SimpleNamespace(rim_thickness_ratio=3.95, rim_ratio=0.8))
    assert rim_below_roots(rating, Role.WHEEL) == pytest.approx(1.8)  # type: ignore[arg-type]
    assert rim_below_roots(rating, Role.PINION) is None  # type: ignore[arg-type]
    assert rim_below_roots(rating, Role.RING, internal=True) == pytest.approx(2.7)  # type: ignore[arg-type]


def test_the_least_width_is_a_whole_millimetre_and_never_less_than_one():
    assert narrowest(0.2e-3, 0.6e-3, lambda width: 2.0) == pytest.approx(1e-3)
    assert narrowest(2.2e-3, 9e-3, lambda width: width / 5.5e-3) == pytest.approx(6e-3)
    assert narrowest(2.2e-3, 9e-3, lambda width: 0.5) == pytest.approx(9e-3)


def test_every_clamp_of_agma_2003_is_named_at_its_value_and_nowhere_else():
    rows = [("mesh", "size contact", 0.5), ("mesh", "size bending", 0.5), ("mesh", "curvature", 1.0),
            ("mesh", "curvature", 1.15), ("mesh", "contact cycles", 2.0), ("mesh", "bending cycles", 2.7),
            ("mesh", "temperature", 1.0), ("pitting", "inertia", 1.0), ("tooth root", "inertia", 1.0)]  # fmt: skip
    for chapter, quantity, value in rows:
        row = Factor(chapter, quantity, "", (value,), "ratio", "")
        at, beside = limited([row, replace(row, values=(value * 1.001,))], BevelEdition.D19)
        assert at.limit
        assert beside.limit == ""


def test_a_cutter_too_round_for_its_ring_is_refused_by_name():
    text = f'{PAIR}internal = true\npinion_teeth = 24\nwheel_teeth = 71\n[gears]\nrating = "iso6336"\n'
    tool = "[gears.iso6336.ring_cutter]\nteeth = {}\ntip_radius = {}\n"
    size(parse(text + tool.format(30, 0.2)))
    with pytest.raises(Exception, match="ring_cutter"):
        size(parse(text + tool.format(71, 0.2)))
    with pytest.raises(Exception, match="ring_cutter"):
        size(parse(text + tool.format(30, 0.6)))


@pytest.mark.parametrize("method", ["agma2001", "iso6336"])
def test_every_safety_of_a_gear_is_a_check_of_that_gear(method):
    """Part, mode and values: two gears, each with its S_H and its S_F against the asked ones."""
    text = f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n[gears]\nrating = "{method}"\n'
    sizing = size(parse(text))
    rated = sizing.meshes[0].rating
    for place, gear in enumerate(("stage.pinion", "stage.wheel")):
        checks = {check.mode: check for check in sizing.checks if str(check.part) == gear}
        assert (checks["pitting"].value, checks["pitting"].limit) == (rated.pitting[place], 1.2)
        assert (checks["tooth root"].value, checks["tooth root"].limit) == (rated.bending[place], 1.6)
