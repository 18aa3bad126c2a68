"""Taper bearings bear at their pressure centres: as if they stood there."""

import re

import pytest

import gearwright as gw
from gearwright.catalogue import bearing, pressure_centre
from gearwright.reviews import review_of
from gearwright.sizing import bearings as pressure_centres
from gearwright.sizing.shafts import centred_bearings
from shipped_work import sized


def test_a_load_acts_where_the_normals_of_the_cup_meet_the_axis():
    """33115: d = 75, D = 125, T = 37, C = 29 mm, e = 0.4: 100/2 · 0.4/1.5 − (37 − 29)/2 = 9.33 mm."""
    assert pressure_centre(bearing("33115")) == pytest.approx((50.0 * 0.4 / 1.5 - 4.0) * 1e-3, rel=1e-12)
    assert pressure_centre(bearing("6209")) == 0.0


def test_at_the_middles_of_their_widths_bearings_live_as_sized(monkeypatch):
    monkeypatch.setattr(pressure_centres, "pressure_centre", lambda standard: 0.0)
    sizing = sized("ec120b")
    lives = {found.name: found.life for found in sizing.bearings}
    found = {centred.name: centred.life for centred in centred_bearings(sizing)}
    assert found == {name: lives[name] for name in ("mast-lower", "mast-upper")}  # to the bit: one computation


def test_bearings_live_as_those_that_stand_at_the_pressure_centres():
    """Each inner ring has its back towards the other bearing, so both centres lie inwards."""
    sizing = sized("ec120b")
    text = gw.shipped_design("ec120b").read_text(encoding="utf-8")
    for name, sign in (("mast-lower", 1.0), ("mast-upper", -1.0)):
        taken = next(found for found in sizing.bearings if found.name == name)
        place = 1e3 * (taken.position + sign * pressure_centre(taken.bearing))
        text = re.sub(
            rf"(\[bearings\.{name}\].*?)position_mm = [\d.]+",
            rf'\g<1>position_mm = {place!r}\ndesignation = "{taken.designation}"', text, count=1, flags=re.DOTALL,
        )  # fmt: skip
    lives = {found.name: found.life for found in gw.size(gw.parse(text)).bearings}
    for centred in centred_bearings(sizing):
        assert centred.life == pytest.approx(lives[centred.name], rel=1e-6)
        assert centred.life < next(found.life for found in sizing.bearings if found.name == centred.name)


def test_a_review_lists_lives_at_pressure_centres():
    listed = {check.name for check in review_of(sized("ec120b")).checks}
    assert {f"{name} life with its load at the pressure centre" for name in ("mast-lower", "mast-upper")} <= listed
