"""Triangles of plane faces with holes: they fill the face once, and pass every edge of its loops once."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from gearwright.arrays import Floats
from gearwright.shape.surfaces import plane_triangles


def circle(middle: tuple[float, float], radius: float, corners: int, wide: float = 1.0) -> Floats:
    angle = 2.0 * math.pi * np.arange(corners) / corners
    return np.asarray(middle) + radius * np.stack([wide * np.cos(angle), np.sin(angle)], axis=1)


def area(loop: Floats) -> float:
    return float(np.sum(loop[:, 0] * np.roll(loop[:, 1], -1) - np.roll(loop[:, 0], -1) * loop[:, 1]) / 2.0)


def check(loops: list[Floats]) -> None:
    points, triangles = np.concatenate(loops), plane_triangles(loops)
    one, two, three = (points[triangles[:, k]] for k in range(3))
    side, other = two - one, three - one
    areas = 0.5 * (side[:, 0] * other[:, 1] - side[:, 1] * other[:, 0])
    assert areas.min() > -1e-13
    assert areas.sum() == pytest.approx(area(loops[0]) - sum(map(area, loops[1:])), rel=1e-12)
    edges = {(int(triangle[k]), int(triangle[k - 2])) for triangle in triangles for k in range(3)}
    start = 0
    for loop in loops:
        numbers = np.arange(start, start + len(loop))
        ring = set(zip(numbers.tolist(), np.roll(numbers, -1).tolist(), strict=True))
        assert ring <= edges or {pair[::-1] for pair in ring} <= edges
        start += len(loop)


@settings(max_examples=60, deadline=None)
@given(st.integers(2, 20), st.integers(5, 24), st.integers(0, 10**6))
def test_holes_anywhere(holes: int, corners: int, seed: int) -> None:
    rng, kept = np.random.default_rng(seed), list[tuple[Floats, float]]()
    for _ in range(400):
        middle, radius = rng.uniform(-0.4, 0.4, 2) * (1.0, 0.6), float(rng.uniform(0.005, 0.06))
        if (middle[0] / 0.43) ** 2 + (middle[1] / 0.23) ** 2 < 1.0 and all(
            np.hypot(*(middle - there)) > radius + wide + 1e-3 for there, wide in kept
        ):
            kept.append((middle, radius))
        if len(kept) == holes:
            break
    check([circle((0, 0), 0.3, 48, 1.7), *(circle(tuple(middle), radius, corners) for middle, radius in kept)])


@pytest.mark.parametrize("count", [3, 6, 24])
def test_a_circle_of_screws_around_a_bore(count: int) -> None:
    angle = 2.0 * math.pi * np.arange(count) / count
    screws = [circle((0.25 * math.cos(a), 0.25 * math.sin(a)), 0.01, 12) for a in angle]
    check([circle((0, 0), 0.3, 48), circle((0, 0), 0.2, 48), *screws])


def test_holes_in_rows_whose_sides_lie_on_one_line() -> None:
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    windows = [0.1 * square + (0.1 + 0.2 * k, 0.1 + 0.2 * j) for k in range(4) for j in range(4)]
    check([square, *windows])
