"""Faces at the ends of gears: their triangles cover what lies between teeth and bore once, and no gap."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.shape.solids import Solid, teeth_apart
from shipped_work import sized


def spread(corners):
    """Return the signed area of triangles in a plane [m²]."""
    one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return 0.5 * (one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])


@pytest.mark.parametrize("name", ["in-line-h2", "ec120b", "off-set"])
def test_no_triangle_of_an_end_lies_over_a_gap_or_over_another(name):
    """Where triangles reach out of a face, others must be turned over to make up for it: areas of one sign do not."""
    scene = gw.scene(sized(name))
    looked = 0
    for key, solid in scene.solids.items():
        if (
            not isinstance(solid, Solid)
            or not solid.sections
            or len(solid.sections[0].radius) < 60
            or np.ptp(solid.sections[-1].height) > 1e-12
        ):
            continue
        surface, height = scene.surfaces[key], solid.sections[-1].height[0]
        places = surface.points[surface.triangles]
        flat = places[np.all(np.abs(places[:, :, 2] - height) < 1e-12, axis=1)][:, :, :2]
        areas = spread(flat)
        assert np.all(areas > -1e-15), key
        looked += 1
    assert looked >= 3


def test_teeth_are_cut_off_along_the_chords_of_their_roots():
    """Three points a tooth between two of its roots: two triangles, of the tooth alone."""
    radius = np.tile([1.0, 1.2, 1.2, 1.0], 8)
    base, triangles = teeth_apart(radius)
    assert list(base[:4]) == [0, 3, 4, 7] and len(base) == 16
    assert len(triangles) == 2 * 8
    assert {(0, 1, 3), (1, 2, 3)} <= {tuple(sorted(row.tolist())) for row in triangles}
    assert all(row.max() - row.min() <= 3 for row in triangles)


def test_a_loop_without_teeth_is_left_as_it_is():
    base, triangles = teeth_apart(np.array([1.0, 1.4, 1.0, 1.4, 1.0, 1.4, 1.0, 1.4]))
    assert list(base) == list(range(8)) and len(triangles) == 0
