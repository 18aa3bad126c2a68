"""Which roughness a loss takes where [losses] leaves it out, and when methods of rating are told to differ."""

import pytest

from designs import PAIR
from gearwright.sizing import size
from gearwright.sizing.insight import _differ as differ  # of several methods, which a sizing seldom has
from gearwright.sizing.losses import oil_of_design
from gearwright.spec import parse

near = pytest.approx
RATED = {
    "iso6336": '[gears]\nrating = "iso6336"\n[gears.iso6336]\nflank_roughness_um = 6\noil_type = "polyglycol"\n',
    "agma2001": '[gears]\nrating = "agma2001"\n[gears.agma2001]\nflank_roughness_um = 0.8\n',
}


def flanks(rating, losses=""):
    return oil_of_design(size(parse(PAIR + RATED.get(rating, "") + losses))).of_stages


def test_flanks_are_as_rough_as_their_rating_has_them_where_losses_say_nothing():
    """R_a of ISO's R_z over 6, AGMA's own R_a, else 0.4 µm; X_L of ISO's oil, else 1."""
    plain = flanks("lewis-hertz")
    for rating, roughness in (("iso6336", 1e-6), ("agma2001", 0.8e-6)):
        found = flanks(rating)
        assert [flank.roughness for flank in found.values()] == [near(roughness)]
        assert found != plain
    assert {flank.lubricant_factor for flank in flanks("agma2001").values()} == {1.0}


@pytest.mark.parametrize("rating", RATED)
def test_what_losses_say_of_flanks_holds_whatever_rates_them(rating):
    found = flanks(rating, "[losses]\nroughness_um = 0.5\nlubricant_factor = 1.1\n")
    assert [(flank.roughness, flank.lubricant_factor) for flank in found.values()] == [(near(0.5e-6), 1.1)]


def test_methods_differ_by_more_than_half_a_percent_or_in_what_they_tell():
    assert not differ([(100.0, 2.0), (100.4, 2.0), (99.6, 2.0)])
    assert differ([(100.0, 2.0), (100.6, 2.0)])
    assert differ([(100.0, 2.0), (100.0, 2.02), (100.0, 2.0)])
    assert differ([(100.0,), (100.0,), (-100.0,)])
    assert differ([(100.0, 2.0), (100.0,)])
