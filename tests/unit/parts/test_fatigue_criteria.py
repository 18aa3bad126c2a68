"""Criteria of fatigue of shafts against the curves that they are, in the plane of mean stress and amplitude."""

import pytest

from gearwright.parts.shaft_fatigue import CRITERIA, FatigueStrength, SectionStress

STRENGTH = FatigueStrength(200e6, 700e6, 560e6)
STRESS = SectionStress(80e6, 150e6, 230e6)
CURVES = {
    "asme": lambda a, m: (a / 200e6) ** 2 + (m / 560e6) ** 2,
    "goodman": lambda a, m: a / 200e6 + m / 700e6,
    "gerber": lambda a, m: a / 200e6 + (m / 700e6) ** 2,
    "soderberg": lambda a, m: a / 200e6 + m / 560e6,
}


@pytest.mark.parametrize("name", CURVES)
def test_stresses_raised_by_their_safety_lie_on_the_curve(name):
    safety = CRITERIA[name](STRESS, STRENGTH)
    assert CURVES[name](safety * STRESS.amplitude, safety * STRESS.mean) == pytest.approx(1.0, rel=1e-12)


def test_every_criterion_has_a_curve_here():
    assert set(CRITERIA) == set(CURVES)


def test_without_a_mean_stress_all_criteria_are_one_and_soderberg_is_never_the_boldest():
    alternating = SectionStress(80e6, 0.0, 80e6)
    assert [criterion(alternating, STRENGTH) for criterion in CRITERIA.values()] == pytest.approx([2.5] * 4)
    found = {name: criterion(STRESS, STRENGTH) for name, criterion in CRITERIA.items()}
    assert found["soderberg"] < found["goodman"] < found["gerber"]
    assert CRITERIA["gerber"](SectionStress(0.0, 350e6, 350e6), STRENGTH) == pytest.approx(2.0)
