"""Grooves of DIN 471 against the loads that a public table of the standard prints for them."""

from itertools import pairwise

import pytest

from gearwright.catalogue import retaining_ring, retaining_rings
from gearwright.catalogue.tables import data_rows

PRINTED = {10: 1.01, 11: 1.4, 12: 1.53, 13: 2.0, 14: 2.15, 15: 2.66, 16: 3.26, 17: 3.46, 18: 4.58, 19: 4.84}
"""d_1 [mm] -> F_N [kN]."""
COLLARS = {10: 0.6, 12: 0.8, 15: 1.1, 16: 1.2, 18: 1.5, 25: 1.7, 30: 2.1, 35: 3.0, 40: 3.8, 50: 4.5, 80: 5.3}
"""d_1 [mm] -> n [mm]."""


@pytest.mark.parametrize("shaft", PRINTED)
def test_a_groove_bears_what_is_printed(shaft):
    # Printed loads are rounded, and of nominal diameters: 2 %.
    assert retaining_ring(1e-3 * shaft).capacity == pytest.approx(1e3 * PRINTED[shaft], rel=0.02)


@pytest.mark.parametrize("shaft", COLLARS)
def test_the_shaft_goes_on_beyond_the_groove_as_printed(shaft):
    ring = retaining_ring(1e-3 * shaft)
    assert ring.room - ring.groove_width == pytest.approx(1e-3 * COLLARS[shaft], abs=0.06e-3)  # printed to 0.1 mm


def test_grooves_deepen_and_rings_thicken_with_the_shaft():
    rings = retaining_rings()
    for one, other in pairwise(rings):
        assert one.shaft < other.shaft and one.groove < other.groove and one.thickness <= other.thickness
        assert one.groove_width > one.thickness


def test_every_bore_of_a_bearing_up_to_300_mm_has_its_ring():
    bores = {float(row["bore_mm"]) for row in data_rows("bearing_sizes.csv")}
    assert all(retaining_ring(1e-3 * bore) is not None for bore in bores)


def test_a_diameter_without_a_ring_has_none():
    assert retaining_ring(0.0715) is None
