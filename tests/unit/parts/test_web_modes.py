"""Modes and bending of webs: against tables of plates, finite elements of rings, and plate theory."""

import math

import numpy as np
import pytest

from gearwright.catalogue import materials
from gearwright.parts.webs import Web, frequency_number, tilting_factor, tilting_stress, web_frequency

LEISSA = {
    0.1: (4.237, 3.482, 5.627, 12.45),
    0.3: (6.660, 6.552, 7.956, 13.27),
    0.5: (13.02, 13.29, 14.70, 18.56),
    0.7: (36.95, 37.50, 39.28, 42.65),
}
"""Hub over outer radius -> λ² of none to three diameters, held inside, free outside, ν = 0.3; Leissa, NASA SP-160."""
ROARK = {0.1: 9.36, 0.2: 4.41, 0.3: 2.66, 0.4: 1.73, 0.5: 1.146, 0.6: 0.749, 0.7: 0.467, 0.8: 0.262}
"""Trunnion over outer radius -> β of σ = β M/(a t²), held outside; Roark's Formulas for Stress and Strain, case 21."""
STEEL = materials()["carburised-9310"]
THIN = Web(outer_radius=0.40, hub_radius=0.08, thickness=5e-3, rim_mass=20.0)
"""Of a wheel of 361 teeth and 0.84 m that turns at 1212 rpm."""
TURNS = 1212.0 / 60.0


def by_elements(ratio, diameters, rim, elements=60):
    """Return λ² by finite elements: rings with Hermite's cubics along the radius, integrated at four points each."""
    edges, n, nu = np.linspace(ratio, 1.0, elements + 1), diameters, 0.3
    size = 2 * (elements + 1)
    stiffness, mass = np.zeros((size, size)), np.zeros((size, size))
    points, weights = np.polynomial.legendre.leggauss(4)
    whole, odd = (2.0 * math.pi, 0.0) if n == 0 else (math.pi, math.pi)
    for k in range(elements):
        low, length = edges[k], edges[k + 1] - edges[k]
        at = slice(2 * k, 2 * k + 4)
        for point, weight in zip(points, weights, strict=True):
            s = 0.5 * (point + 1.0)
            r, part = low + s * length, 0.5 * weight * length
            shape = np.array([1 - 3 * s**2 + 2 * s**3, length * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3,
                              length * (s**3 - s**2)])  # fmt: skip
            slope = np.array([-6 * s + 6 * s**2, length * (1 - 4 * s + 3 * s**2), 6 * s - 6 * s**2,
                              length * (3 * s**2 - 2 * s)]) / length  # fmt: skip
            bent = np.array([-6 + 12 * s, length * (-4 + 6 * s), 6 - 12 * s, length * (6 * s - 2)]) / length**2
            hoop = slope / r - n**2 * shape / r**2
            twist = n * (slope / r - shape / r**2)
            energy = np.outer(bent, bent) + np.outer(hoop, hoop) + nu * (np.outer(bent, hoop) + np.outer(hoop, bent))
            stiffness[at, at] += part * r * (whole * energy + 2 * (1 - nu) * odd * np.outer(twist, twist))
            mass[at, at] += part * r * whole * np.outer(shape, shape)
    mass[-2, -2] += rim * math.pi * (1.0 - ratio**2) * whole / (2.0 * math.pi)
    free = slice(2, size)  # held at the hub
    values = np.linalg.eigvals(np.linalg.solve(mass[free, free], stiffness[free, free]))
    return math.sqrt(values.real.min())


@pytest.mark.parametrize(("ratio", "diameters"), [(ratio, n) for ratio in LEISSA for n in range(4)])
def test_bare_plates_are_those_of_the_tables(ratio, diameters):
    assert frequency_number(ratio, diameters) == pytest.approx(LEISSA[ratio][diameters], rel=1e-3)


@pytest.mark.parametrize("ratio", [0.1, 0.2, 0.5, 0.8])
@pytest.mark.parametrize("rim", [0.0, 0.3, 3.0])
def test_a_rim_lowers_modes_as_finite_elements_say(ratio, rim):
    for diameters in range(9):
        expected = by_elements(ratio, diameters, rim)
        assert frequency_number(ratio, diameters, rim) == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize(("thickness", "failing"), [(5e-3, [1, 2, 3, 4, 5, 6]), (8e-3, [2]), (12e-3, [])])
def test_a_thin_wheel_has_waves_that_stand_in_space(thickness, failing):
    web = THIN._replace(thickness=thickness)
    assert [n for n in range(1, 7) if web_frequency(web, n, STEEL) < 1.3 * n * TURNS] == failing


def test_frequencies_of_the_thin_wheel():
    """By the estimate that a third of the plate moves with the rim: 18 and 26, 34 and 49, 58, 82 and 156 Hz."""
    found = [[web_frequency(THIN._replace(thickness=t), n, STEEL) for n in (1, 2, 3)] for t in (5e-3, 8e-3, 12e-3)]
    assert found[0][:2] == pytest.approx([18.0, 26.0], rel=0.10)
    assert found[1][:2] == pytest.approx([34.0, 49.0], rel=0.10)
    assert found[2] == pytest.approx([58.0, 82.0, 156.0], rel=0.10)


def test_a_heavier_rim_never_raises_a_mode_and_a_thicker_web_never_lowers_one():
    for n in range(9):
        rims = [web_frequency(THIN._replace(rim_mass=mass), n, STEEL) for mass in (0.0, 5.0, 20.0, 80.0)]
        webs = [web_frequency(THIN._replace(thickness=t), n, STEEL) for t in (3e-3, 5e-3, 8e-3, 12e-3)]
        assert rims == sorted(rims, reverse=True)
        assert webs == sorted(webs)


@pytest.mark.parametrize("ratio", ROARK)
def test_bending_under_a_moment_is_that_of_the_tables(ratio):
    assert tilting_factor(ratio) == pytest.approx(ROARK[ratio], rel=2e-3)


def test_bending_of_a_web_by_hand():
    """β = 4.41 at 0.2: 4.41 · 500 N m/(0.4 m · (5 mm)²) = 220 MPa."""
    assert tilting_stress(THIN, 500.0) == pytest.approx(220.4e6, rel=2e-3)
