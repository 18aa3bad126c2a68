"""What cannot be met: the nearest variant in the same sizes, of which less is asked, closes and meets everything."""

import re

import pytest

import gearwright as gw
from gearwright.closure import Wishes, close, eased
from gearwright.closure.requirements import HOUR
from gearwright.spec import design_text, edited, parse
from gearwright.spec.edit import standing_at

NARROW = """
schema = 1
name = "a narrow pair"
shafts = ["fast", "slow"]

[turbines.turbine]
shaft = "fast"
power_kw = 100
speed_rpm = 6000

[propellers.propeller]
shaft = "slow"
speed_rpm = 2000
diameter_m = 2

[pairs.stage]
pinion = "fast"
wheel = "slow"
module_mm = 2.5
face_width_mm = 12

[gears]
rating = "iso6336"
"""
STILL = frozenset({"peaks", "critical speeds"})


@pytest.mark.parametrize(
    ("name", "hours", "left_out", "words"),
    [
        ("in-line-star", 1e6, frozenset(), "gears live 20000 h instead of 1e.06 h, bearings live"),
        ("in-line-h1-star", 3e4, frozenset(), "every speed at 1.03 .*gears live 22500 h instead of 30000 h"),
        ("off-set-h1", 2e4, frozenset(), "every speed at 1.02"),
        ("off-set-h3", 1e5, frozenset(), "every speed at 1.07"),
        ("e-axle", 6e4, frozenset(), "every power at 0.98 .* every speed at 0.98"),
        ("narrow", None, STILL, "every power at 0.[0-9]+"),
    ],
)
def test_what_is_told_as_the_nearest_closes(name, hours, left_out, words):
    design = parse(NARROW) if name == "narrow" else gw.read(name)
    life = None if hours is None else hours * HOUR
    wishes = Wishes(life=life, separate=False, lighten=False, left_out=left_out)
    closed = close(design, wishes=wishes)
    assert closed.unmet
    nearest = eased(closed)
    assert re.match(words, nearest.what), nearest.what
    assert not nearest.worst.fails
    again = close(parse(design_text(nearest.design)), wishes=Wishes(left_out=left_out))
    assert not again.unmet
    stated = edited(closed.design, nearest.changes)
    assert all(standing_at(stated, path).value == pytest.approx(value) for path, value in nearest.changes.items())


def test_nothing_is_eased_where_everything_is_met():
    assert eased(close(gw.read("off-set"), wishes=Wishes(lighten=False))) is None
