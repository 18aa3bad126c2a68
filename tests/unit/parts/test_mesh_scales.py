"""Scales of a gear pair, and the closed form of planets with one pin out of place."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gearwright.dynamics import Model, modes
from gearwright.parts.gears import mesh_frequency_scale, mesh_length_scale
from gearwright.parts.planetary import pin_error_share

RADII = (0.0256 * math.cos(math.radians(20.0)), 0.0992 * math.cos(math.radians(20.0)))


def test_frequency_scale_is_the_natural_frequency_of_the_pair_alone():
    """23839 rad/s or 3794 Hz for the split torque's first mesh; the eigenvalue of two rotations on one spring."""
    model = Model()
    model.rotation("pinion", inertia=5e-4, speed=1.0)
    model.rotation("wheel", inertia=0.033)
    model.mesh("mesh", {"pinion": RADII[0], "wheel": -RADII[1]}, stiffness=4e8)
    scale = mesh_frequency_scale(4e8, (5e-4, 0.033), RADII)
    assert scale == pytest.approx(23839.0, abs=0.5)
    assert modes(model.build()).frequency[1] == pytest.approx(scale / (2.0 * np.pi), rel=1e-12)


@pytest.mark.parametrize(("radius", "micrometres"), [(0.0256, 38.4), (RADII[0], 40.9)])
def test_length_scale_as_printed_and_along_the_line_of_action(radius, micrometres):
    assert 1e6 * mesh_length_scale(786.48, radius, 4e8) == pytest.approx(micrometres, abs=0.05)


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
