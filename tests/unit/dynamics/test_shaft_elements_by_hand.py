"""One element of a round shaft against Przemieniecki's closed matrices, Cowper's coefficient and rigid motions."""

import math

import numpy as np
import pytest

from gearwright.dynamics.model import Segment
from gearwright.dynamics.model.rotors import element

near = pytest.approx
SEGMENTS = [Segment(0.12, 0.05), Segment(0.03, 0.06, bore=0.04), Segment(0.4, 0.02, bore=0.005)]


def parts(segment):
    """Return E I, Φ, ρ A, ρ I and the length, all written out."""
    outer, inner = segment.diameter, segment.bore
    area, second = math.pi / 4.0 * (outer**2 - inner**2), math.pi / 64.0 * (outer**4 - inner**4)
    ratio, nu = inner / outer, segment.poisson
    square = (1.0 + ratio**2) ** 2
    cowper = 6.0 * (1.0 + nu) * square / ((7.0 + 6.0 * nu) * square + (20.0 + 12.0 * nu) * ratio**2)
    shear = segment.elasticity / (2.0 * (1.0 + nu))
    softness = 12.0 * segment.elasticity * second / (cowper * area * shear * segment.length**2)
    return segment.elasticity * second, softness, segment.density * area, segment.density * second, segment.length


def test_a_solid_and_a_thin_round_section_bear_shear_as_cowper_gives_them():
    """6 (1 + ν)/(7 + 6 ν) = 0.886 solid, 2 (1 + ν)/(4 + 3 ν) = 0.531 thin, at ν = 0.3."""
    assert Segment(0.1, 0.05).shear_coefficient == near(7.8 / 8.8)
    assert Segment(0.1, 0.05, bore=0.05 - 1e-9).shear_coefficient == near(2.6 / 4.9, rel=1e-6)
    half = 6.0 * 1.3 * 1.5625 / (8.8 * 1.5625 + 23.6 * 0.25)
    assert Segment(0.1, 0.05, bore=0.025).shear_coefficient == near(half)


@pytest.mark.parametrize("segment", SEGMENTS)
def test_stiffness_is_that_of_przemieniecki_with_shear(segment):
    """Theory of Matrix Structural Analysis (1968), equation 5.116."""
    bending, soft, _, _, length = parts(segment)
    closed = bending / (length**3 * (1.0 + soft)) * np.array([
        [12.0, 6.0 * length, -12.0, 6.0 * length],
        [6.0 * length, (4.0 + soft) * length**2, -6.0 * length, (2.0 - soft) * length**2],
        [-12.0, -6.0 * length, 12.0, -6.0 * length],
        [6.0 * length, (2.0 - soft) * length**2, -6.0 * length, (4.0 + soft) * length**2],
    ])  # fmt: skip
    assert element(segment).stiffness == near(closed, rel=1e-9)


@pytest.mark.parametrize("segment", SEGMENTS)
def test_rigid_motions_feel_no_stiffness_and_the_whole_mass_and_inertia(segment):
    """Moved by one: ρ A L; turned about its first end: ρ A L³/3 + ρ I L; spinning: 2 ρ I L of a common slope."""
    _, _, mass, tilting, length = parts(segment)
    found = element(segment)
    moved, turned = np.array([1.0, 0.0, 1.0, 0.0]), np.array([0.0, 1.0, length, 1.0])
    scale = float(np.abs(found.stiffness).max())
    assert found.stiffness @ moved == near(0.0, abs=1e-9 * scale)
    assert found.stiffness @ turned == near(0.0, abs=1e-9 * scale * max(length, 1.0))
    assert moved @ found.mass @ moved == near(mass * length)
    assert turned @ found.mass @ turned == near(mass * length**3 / 3.0 + tilting * length)
    assert moved @ found.mass @ turned == near(mass * length**2 / 2.0)
    assert turned @ found.polar @ turned == near(2.0 * tilting * length)
    assert moved @ found.polar @ moved == near(0.0, abs=1e-12)


def test_a_slender_element_has_the_consistent_mass_of_eulers_beam():
    """ρ A L/420 (156, 22 L, 54, −13 L; …), which shear and the sections' tilting change by 1e-4 here."""
    segment = Segment(1.0, 0.01)
    _, _, mass, _, length = parts(segment)
    euler = mass * length / 420.0 * np.array([
        [156.0, 22.0, 54.0, -13.0], [22.0, 4.0, 13.0, -3.0], [54.0, 13.0, 156.0, -22.0], [-13.0, -3.0, -22.0, 4.0],
    ])  # fmt: skip
    assert element(segment).mass == near(euler, rel=1e-3)


def test_the_middle_of_a_thick_element_moves_by_the_exact_static_shape():
    """N_1(1/2) = 1/2 and N_2(1/2) = L/8 whatever Φ: of the mass's coupling with a slope only shear's part is left."""
    segment = Segment(0.05, 0.05)
    _, soft, mass, tilting, length = parts(segment)
    x = np.linspace(0.0, 1.0, 20001)
    shape = (1.0 - 3.0 * x**2 + 2.0 * x**3 + soft * (1.0 - x)) / (1.0 + soft)
    slope = 6.0 * (x**2 - x) / (length * (1.0 + soft))
    whole = mass * length * np.trapezoid(shape**2, x) + tilting * length * np.trapezoid(slope**2, x)
    assert element(segment).mass[0, 0] == near(whole, rel=1e-7)
