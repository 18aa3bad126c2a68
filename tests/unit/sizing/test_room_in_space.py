"""How much room bodies have in space: closed forms by hand, symmetry, and against points all over both bodies."""

import math

import numpy as np
import pytest

from gearwright.identity import Kind, PartId
from gearwright.sizing import Body, Direction, Point, Station
from gearwright.sizing.places import box_of, room_between, solid_of, solid_room


def body(origin, direction, *stations, bore=0.0):
    """Return a body of circles (place, radius) about an axis."""
    way = np.array(direction, dtype=float)
    way /= np.linalg.norm(way)
    part = PartId(Kind.SHAFT, "one")
    return Body(part, "one", "", Point(*map(float, origin)), Direction(*way.tolist()),
                tuple(Station(*map(float, each)) for each in stations), bore)  # fmt: skip


def rod(origin, direction, length, radius, bore=0.0):
    return body(origin, direction, (0.0, radius), (length, radius), bore=bore)


def test_parallel_cylinders_beside_before_and_across_a_corner():
    """By hand: 10 − 2 − 3 beside, 7 − 5 before, √(3² + 4²) between edges."""
    one = rod((0, 0, 0), (1, 0, 0), 5, 2)
    assert room_between(one, rod((0, 10, 0), (1, 0, 0), 5, 3)).gap == pytest.approx(5.0)
    assert room_between(one, rod((7, 0, 0), (1, 0, 0), 5, 3)).gap == pytest.approx(2.0)
    assert room_between(one, rod((8, 0, 9), (1, 0, 0), 5, 3)).gap == pytest.approx(5.0)
    assert room_between(one, rod((13, 0, 9), (-1, 0, 0), 5, 3)).gap == pytest.approx(5.0)


def test_cylinders_in_each_other_stand_as_deep_as_the_shortest_way_out():
    """By hand: 1 of a radius beside, 0.5 of a length before."""
    one = rod((0, 0, 0), (1, 0, 0), 5, 2)
    assert room_between(one, rod((0, 4, 0), (1, 0, 0), 5, 3)).gap == pytest.approx(-1.0)
    assert room_between(one, rod((4.5, 1, 0), (1, 0, 0), 5, 3)).gap == pytest.approx(-0.5)


def test_a_shaft_through_a_hollow_one_has_the_difference_of_radii():
    tube = rod((0, 0, 0), (1, 0, 0), 5, 4, bore=3)
    assert room_between(tube, rod((-9, 0.5, 0), (1, 0, 0), 20, 2)).gap == pytest.approx(0.5)
    assert room_between(rod((-9, 0.5, 0), (1, 0, 0), 20, 2), tube).gap == pytest.approx(0.5)
    assert room_between(rod((0, 0, 0), (1, 0, 0), 5, 4), rod((-9, 0, 0), (1, 0, 0), 20, 2)).gap < 0.0


def test_crossed_cylinders_have_the_distance_of_their_axes_less_both_radii():
    """By hand, for axes at any angle: their common normal is 6 long."""
    for angle in (math.pi / 2.0, 1.0, 0.3):
        way = (math.cos(angle), math.sin(angle), 0.0)
        other = rod((-50 * way[0], -50 * way[1], 6), way, 100, 1.5)
        assert room_between(rod((-50, 0, 0), (1, 0, 0), 100, 2), other).gap == pytest.approx(2.5, abs=1e-6)


def test_a_rod_that_points_at_a_disc_has_the_way_to_its_face():
    disc, pin = rod((0, 0, 0), (0, 0, 1), 1, 10), rod((0, 3, 4), (0, 0, 1), 8, 1)
    assert room_between(disc, pin).gap == pytest.approx(3.0)
    assert room_between(disc, rod((0, 14, 0.5), (0, 1, 0), 5, 1)).gap == pytest.approx(4.0, abs=1e-6)


def test_a_cone_beside_a_rod_has_the_way_square_to_its_slant():
    """By hand: a cone from radius 0 to 4 over 4 has a slant of 45°; a point rod at (1, 4) lies (4 − 1)/√2 from it."""
    cone = body((0, 0, 0), (1, 0, 0), (0.0, 0.0), (4.0, 4.0))
    needle = rod((1, 4, -1e-9), (0, 0, 1), 2e-9, 1e-9)
    assert room_between(cone, needle).gap == pytest.approx(3.0 / math.sqrt(2.0), abs=1e-6)


def test_a_box_is_its_corners():
    box, other = box_of((0, 0, 0), (1, 2, 3)), rod((5, 1, 1), (1, 0, 0), 2, 0.5)
    assert solid_room(box, solid_of(other)).gap == pytest.approx(4.0, abs=1e-9)
    assert solid_room(box, solid_of(rod((0.5, 1, 1), (0, 0, 1), 1, 0.25))).gap == pytest.approx(-0.75, abs=1e-6)


def points_on(shape, count):
    """Return points over the surface of a body: circles along its slants, and over both ends."""
    axis, origin = np.array(shape.direction), np.array(shape.origin)
    side = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    side /= np.linalg.norm(side)
    up = np.cross(axis, side)
    first, last = shape.stations[0], shape.stations[-1]
    share = np.linspace(0.0, 1.0, count)
    slant = [(t * last.place, first.radius + t * (last.radius - first.radius)) for t in share]
    ends = [(station.place, t * station.radius) for station in (first, last) for t in share]
    turn = np.linspace(0.0, 2.0 * np.pi, 4 * count, endpoint=False)
    ring = np.cos(turn)[:, None] * side + np.sin(turn)[:, None] * up
    return np.vstack([origin + place * axis + radius * ring for place, radius in (*slant, *ends)])


def within(shape, points, deeper):
    """Tell whether any point lies in a cone or cylinder, deeper than a distance."""
    off = points - np.array(shape.origin)
    along = off @ np.array(shape.direction)
    far = np.linalg.norm(off - along[:, None] * np.array(shape.direction), axis=1)
    first, last = shape.stations[0], shape.stations[-1]
    radius = first.radius + along / last.place * (last.radius - first.radius)
    return bool(np.any((along > deeper) & (along < last.place - deeper) & (far < radius - deeper)))


def nearest(one, other):
    """Return the least distance of two clouds of points."""
    return min(float(np.sqrt(np.min(np.sum((one - point) ** 2, axis=1)))) for point in other)


@pytest.mark.parametrize("seed", range(24))
def test_room_is_that_of_points_all_over_both_bodies(seed):
    """Points are up to 0.6 apart on bodies of 4 to 20; what is apart is never nearer, and hardly farther, than said."""
    random = np.random.default_rng(seed)
    shapes = []
    for _ in range(2):
        length, radii = random.uniform(2, 10), random.uniform(1, 5, 2)
        place = random.uniform(-9, 9, 3)
        shapes.append(body(place, random.normal(size=3), (0.0, radii[0]), (length, radii[1])))
    gap = room_between(*shapes).gap
    clouds = [points_on(shape, 16) for shape in shapes]
    inside = within(shapes[0], clouds[1], 0.0) or within(shapes[1], clouds[0], 0.0)
    if gap > 0.0:
        assert not inside
        assert gap - 1e-6 <= nearest(*clouds) <= gap + 0.6
    else:
        assert inside or gap > -0.3


@pytest.mark.parametrize("seed", range(12))
def test_room_is_the_same_both_ways_and_wherever_the_two_stand_together(seed):
    """Turned and moved as one, and asked the other way round; to what the search leaves open."""
    random = np.random.default_rng(100 + seed)
    shapes = [
        (random.uniform(-9, 9, 3), random.normal(size=3), random.uniform(2, 10), random.uniform(1, 5, 2))
        for _ in range(2)
    ]
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    here, there = (
        [
            body(at(place), at(way) - at(np.zeros(3)), (0.0, ends[0]), (length, ends[1]))
            for place, way, length, ends in shapes
        ]
        for at in (lambda vector: vector, lambda vector: turn @ vector + np.array([30.0, -20.0, 10.0]))
    )
    assert room_between(*here).gap == pytest.approx(room_between(*here[::-1]).gap, abs=2e-3)
    assert room_between(*here).gap == pytest.approx(room_between(*there).gap, abs=2e-3)


def test_quick_answers_never_promise_room_that_there_is_not():
    random = np.random.default_rng(7)
    for _ in range(40):
        shapes = [
            body(random.uniform(-12, 12, 3), random.normal(size=3), (0.0, 2.0), (random.uniform(3, 9), 1.0))
            for _ in range(2)
        ]
        assert room_between(*shapes, enough=0.0).gap <= room_between(*shapes).gap + 2e-3
