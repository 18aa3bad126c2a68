"""Tooth ratios that a stage's own entries give."""

import pytest

from gearwright.spec.design import Pair, Planetary
from gearwright.train.kinematics import asked_tooth_ratio, given_tooth_ratio


def pair(**entries):
    return Pair(pinion="a", wheel="b", **entries)


def planetary(**entries):
    return Planetary(sun="a", ring="ground", carrier="b", **entries)


@pytest.mark.parametrize(
    ("stage", "ratio"),
    [
        (pair(pinion_teeth=20, wheel_teeth=50), 2.5),
        (pair(pinion_teeth=20), None),
        (pair(wheel_teeth=20), None),
        (planetary(sun_teeth=24, planet_teeth=33), 90 / 24),
        (planetary(sun_teeth=24, ring_teeth=90), 90 / 24),
        (planetary(planet_teeth=33, ring_teeth=90), 90 / 24),
        (planetary(sun_teeth=24), None),
        (planetary(ring_teeth=90), None),
        (planetary(planet_teeth=33), None),
    ],
)
def test_teeth_give_a_ratio_where_two_numbers_stand(stage, ratio):
    assert given_tooth_ratio(stage) == (None if ratio is None else pytest.approx(ratio))
    assert asked_tooth_ratio(stage) == given_tooth_ratio(stage)


def test_an_asked_ratio_of_a_pair_is_that_of_its_teeth_and_of_a_set_one_more():
    assert asked_tooth_ratio(pair(ratio=3.2)) == pytest.approx(3.2)
    assert asked_tooth_ratio(planetary(ratio=4.5)) == pytest.approx(3.5)
    assert asked_tooth_ratio(pair(ratio=3.2, pinion_teeth=20, wheel_teeth=50)) == 2.5
