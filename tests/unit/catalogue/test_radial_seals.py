"""Radial shaft seals: sizes, speeds and masses against what SKF prints."""

import math
from itertools import groupby, pairwise

import pytest

from gearwright.catalogue import ELASTOMERS, lip_speed, next_seal_shaft, radial_seals, seals_for

NBR, FKM = ELASTOMERS
PRINTED = {10: (2520, 13655), 20: (3960, 14220), 30: (3660, 12420), 40: (3300, 10860), 55: (2880, 9120)}
"""d_1 [mm] -> rotational speeds that SKF prints for NBR and FKM [1/min]."""
WEIGHED = {(30, 47): (11.9, 13.2), (38, 55): (16.2, 18.6), (45, 62): (17.7, 20.0), (60, 80): (25.2, 29.5)}
"""d_1, d_2 [mm] -> masses that SKF prints for HMS5 of NBR and FKM [g]."""


@pytest.mark.parametrize("shaft", PRINTED)
def test_a_lip_bears_the_rotational_speed_that_is_printed(shaft):
    # Circumferential speeds are printed with one decimal: 4 % of 1.3 m/s.
    for elastomer, printed in zip(ELASTOMERS, PRINTED[shaft], strict=True):
        turning = lip_speed(1e-3 * shaft, elastomer) / (math.pi * 1e-3 * shaft) * 60.0
        assert turning == pytest.approx(printed, rel=0.04)


def test_below_and_beyond_the_table_lips_bear_no_more_than_at_its_ends():
    for elastomer in ELASTOMERS:
        assert lip_speed(5e-3, elastomer) == pytest.approx(lip_speed(10e-3, elastomer) / 2.0)
        assert lip_speed(0.3, elastomer) == lip_speed(0.06, elastomer)


@pytest.mark.parametrize(("shaft", "bore"), WEIGHED)
def test_seals_weigh_what_is_printed_to_a_fifth(shaft, bore):
    seal = next(seal for seal in seals_for(1e-3 * shaft) if abs(seal.bore - 1e-3 * bore) < 1e-6)
    for elastomer, printed in zip(ELASTOMERS, WEIGHED[shaft, bore], strict=True):
        assert 1e3 * seal.mass(elastomer) == pytest.approx(printed, rel=0.2)


def test_sizes_are_in_order_and_thicker_shafts_have_wider_seals_and_bores():
    for one, other in pairwise(radial_seals()):
        assert (one.shaft, one.bore) < (other.shaft, other.bore)
        assert 10e-3 - 1e-9 <= one.bore - one.shaft <= 40e-3 + 1e-9
    standard = (seal for seal in radial_seals() if "ISO" in seal.listed_by)
    smallest = [next(seals) for _, seals in groupby(standard, key=lambda seal: seal.shaft)]
    for one, other in pairwise(smallest):
        assert one.bore <= other.bore and one.width <= other.width


def test_a_shaft_between_two_sizes_has_no_seal_and_is_made_thicker():
    assert not seals_for(0.071)
    assert next_seal_shaft(0.071) == 0.075 and seals_for(0.075)
    assert next_seal_shaft(0.401) is None
