"""Gear steels: strengths by heat treatment, grade and hardness, and what is refused."""

import pytest

from gearwright.catalogue import gear_steel, gear_steel_names
from gearwright.errors import DesignError


@pytest.mark.parametrize(
    ("name", "grade", "hardness", "contact", "bending"),
    [
        ("case-hardened", "MQ", 700.0, 1500.0, 425.0),
        ("case-hardened-core-30", "MQ", 700.0, 1500.0, 500.0),
        ("case-hardened", "ME", 720.0, 1650.0, 525.0),
        ("nitrided", "MQ", 750.0, 1250.0, 420.0),
        ("through-hardened-alloy", "MQ", 300.0, 766.9, 314.5),
        ("through-hardened-alloy", "ME", 300.0, 923.9, 338.4),
    ],
)
def test_strength_follows_the_lines_of_the_standard(name, grade, hardness, contact, bending):
    """ISO 6336-5:2016, table 1, σ_lim = A x + B; exact."""
    steel = gear_steel(name, grade, hardness)
    assert steel.contact_strength == pytest.approx(contact * 1e6, rel=1e-12)
    assert steel.bending_strength == pytest.approx(bending * 1e6, rel=1e-12)


def test_better_grades_are_never_weaker():
    for name in gear_steel_names():
        found = []
        for grade in ("ML", "MQ", "ME"):
            try:
                found.append(gear_steel(name, grade, 300.0 if "through-hardened-alloy" in name else 700.0))
            except DesignError:
                continue
        strengths = [(steel.contact_strength, steel.bending_strength) for steel in found]
        assert strengths == sorted(strengths)


def test_an_unknown_steel_is_answered_with_the_nearest_name():
    with pytest.raises(DesignError, match="did you mean case-hardened"):
        gear_steel("case-hardend", "MQ", 700.0)


def test_an_unknown_grade_is_refused():
    with pytest.raises(DesignError, match="'MX' is not given"):
        gear_steel("case-hardened", "MX", 700.0)


def test_a_hardness_outside_the_range_names_the_nearest():
    with pytest.raises(DesignError, match="nearest is 660"):
        gear_steel("case-hardened", "MQ", 580.0)
