"""The closed form of planets with one pin out of place."""

from __future__ import annotations

import math

import pytest

from gearwright.parts.planetary import pin_error_share


@pytest.mark.parametrize(
    ("planets", "floating", "share"),
    [
        (3, True, 0.333333),
        (3, False, 0.471118),
        (4, True, 0.301669),
        (4, False, 0.405008),
        (5, True, 0.282671),
        (5, False, 0.365342),
        (6, True, 0.270005),
        (6, False, 0.338898),
    ],
)
def test_pin_error_shares(planets, floating, share):
    """Ligata, Kahraman & Singh 2009 for N = 4, by projection for the others; six digits."""
    found = pin_error_share(
        planets, 1e-5, 4e4, stiffness=(5e8, 5e8), pressure_angle=math.radians(24.6), floating=floating
    )
    assert found == pytest.approx(share, abs=5e-7)
