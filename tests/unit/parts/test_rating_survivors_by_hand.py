"""Formulas of gear rating in the places where faults once went unnoticed, written out a second time."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from gearwright.parts.gears import ToothShift
from gearwright.parts.iso6336 import (
    MeshDeviations,
    MeshGeometry,
    MeshSprings,
    ToothProportions,
    Treatment,
    balanced_shift,
    dynamic_factor,
    load_sharing_factor,
    outer_single_contact,
    root_section,
    shifted_mesh,
    specific_slidings,
)
from gearwright.parts.iso6336.rating import sliding_balance, strength_balance
from gearwright.parts.iso6336.tooth_strength import contact_size_factor

PAIR = MeshGeometry((18.0, 43.0), 2.0, 20.0, 62.0, (20.9, 45.6))
"""Unequal teeth at a centre distance of 62, lengths in mm."""


def near(value: float) -> object:
    return pytest.approx(value, rel=1e-12)


def test_specific_sliding_at_both_ends_of_an_unequal_pair():
    """ζ_f1 = 1 − ρ_A2/(u ρ_A1), ζ_f2 = 1 − u ρ_E1/ρ_E2 with radii from base circles of 18 and 43 mm cos 20°."""
    cosine = math.cos(math.radians(20.0))
    first, second = 18.0 * cosine, 43.0 * cosine
    line = math.sqrt(62.0**2 - (first + second) ** 2)
    tips = math.sqrt(20.9**2 - first**2), math.sqrt(45.6**2 - second**2)
    ratio = 43.0 / 18.0
    expected = tips[1] / (ratio * (line - tips[1])) - 1.0, ratio * tips[0] / (line - tips[0]) - 1.0
    assert specific_slidings(PAIR) == tuple(near(value) for value in expected)
    assert sliding_balance(PAIR) == near(expected[0] - expected[1])


def test_a_tip_past_the_mates_involute_slides_without_bound():
    """A wheel tip of 50 mm ends beyond the tangent point on the pinion; the pinion's own tip does not."""
    first, second = specific_slidings(MeshGeometry((18.0, 43.0), 2.0, 20.0, 62.0, (20.9, 50.0)))
    assert first == math.inf
    assert second == near(specific_slidings(PAIR)[1])


def test_strength_is_balanced_where_form_and_notch_of_both_gears_multiply_to_the_same():
    first, second = (root_section(outer_single_contact(PAIR, gear)) for gear in (0, 1))
    products = [float(section.form) * float(section.stress_correction) for section in (first, second)]
    assert strength_balance(PAIR) == near(math.log(products[0] / products[1]))
    assert abs(strength_balance(PAIR)) > 0.01


@pytest.mark.parametrize("limits", [(-0.3, 0.9), (0.05, 0.65)])
def test_a_balanced_shift_balances_to_four_decimals(limits):
    """The balance changes its sign within half of the last decimal, wherever the search began."""

    def shape(shift: float) -> MeshGeometry:
        shifts = ToothShift(shift), ToothShift(-shift)
        return shifted_mesh((18.0, 43.0), shifts, None, pressure_angle=math.radians(20.0))

    found = balanced_shift(shape, *limits, by="sliding")
    assert found == round(found, 4)
    assert sliding_balance(shape(found - 6e-5)) > 0.0 > sliding_balance(shape(found + 6e-5))


def test_a_shifted_ring_has_its_tip_where_its_own_addendum_ends():
    """r_a2 = 36 − (1 + x_2 + k_2) m_n of a ring of 72 teeth with x_2 = −0.3 and k_2 = 0.1: 0.8 modules inside."""
    mesh = shifted_mesh(
        (24.0, -72.0), (ToothShift(0.3), ToothShift(-0.3, 0.1)), None, pressure_angle=math.radians(20.0), module=2.0
    )
    assert mesh.tip_radii == (near(24.0 + 1.3 * 2.0), near(72.0 - 0.8 * 2.0))


@pytest.mark.parametrize(
    ("treatment", "module", "expected"),
    [
        (Treatment.NITRIDED, 5.0, 1.0),
        (Treatment.NITRIDED, 10.0, 0.97),
        (Treatment.NITRIDED, 20.0, 0.86),
        (Treatment.NITRIDED, 40.0, 0.75),
        (Treatment.CASE_HARDENED, 10.0, 1.0),
        (Treatment.CASE_HARDENED, 20.0, 0.95),
        (Treatment.INDUCTION_HARDENED, 35.0, 0.90),
        (Treatment.THROUGH_HARDENED, 30.0, 1.0),
        (Treatment.STRUCTURAL, 30.0, 1.0),
    ],
)
def test_the_size_factor_of_flanks_by_din_3990(treatment, module, expected):
    """1.08 − 0.011 m_n nitrided, 1.05 − 0.005 m_n case- and induction-hardened, both constant from 30 mm."""
    assert float(contact_size_factor(module * 1e-3, treatment)) == pytest.approx(expected, rel=1e-12)


def dynamic_by_hand(ratio: float, overlap: float, terms: tuple[float, float, float]) -> float:
    """K_V of ISO 6336-1, clause 6.5, for loads above 100 N/mm, from its table of C_v."""
    pitch, profile, relief = terms
    if overlap <= 2.0:
        c2, c3, c4, c6 = 0.34, 0.23, 0.90, 0.47
    else:
        c2, c3 = 0.57 / (overlap - 0.3), 0.096 / (overlap - 1.56)
        c4, c6 = (0.57 - 0.05 * overlap) / (overlap - 1.44), 0.12 / (overlap - 1.74)
    c7 = 0.75 if overlap <= 1.5 else 1.0 if overlap > 2.5 else 0.125 * math.sin(math.pi * (overlap - 2.0)) + 0.875
    resonant = 0.32 * pitch + c2 * profile + c4 * relief + 1.0
    above = 0.47 * pitch + c6 * profile + c7
    if ratio <= 0.85:
        return ratio * (0.32 * pitch + c2 * profile + c3 * relief) + 1.0
    if ratio <= 1.15:
        return resonant
    return above if ratio >= 1.5 else above + (resonant - above) * (1.5 - ratio) / 0.35


@pytest.mark.parametrize("ratio", [0.3, 0.84, 0.86, 1.0, 1.2, 1.4, 1.6, 3.0])
@pytest.mark.parametrize("width", [0.0, 0.3, 0.9, 1.2, 2.1])
def test_the_dynamic_factor_in_every_region_and_overlap(ratio, width):
    """A pair of 20/60 teeth; its face width gives the overlap ratio that is asked for."""
    helix = math.radians(15.0)
    pitch = 2e-3 / math.cos(helix)
    mesh = MeshGeometry(
        (20.0, 60.0), 2e-3, max(width, 0.1) * math.pi * 2e-3 / math.sin(helix), 40.0 * pitch,
        (10.0 * pitch + 2e-3, 30.0 * pitch + 2e-3), helix_angle=helix if width else 0.0,
    )  # fmt: skip
    mesh = mesh if width else MeshGeometry((20.0, 60.0), 2e-3, 0.02, 0.08, (0.022, 0.062))
    springs, mass, load = MeshSprings(14e9, 20e9, 17e9), 2.0, 3e5
    speed = ratio * math.sqrt(20e9 / mass) / 20.0
    found = dynamic_factor(
        mesh, springs, MeshDeviations(6e-6, 9e-6, 0.44), specific_load=load, pinion_speed=speed, masses=(mass,)
    )
    terms = (14e9 * 6e-6 / load, 14e9 * 9e-6 / load, 0.44)
    assert float(found.factor) == near(dynamic_by_hand(ratio, float(mesh.total_contact_ratio), terms))


@pytest.mark.parametrize(
    ("overlap", "ratio", "expected"),
    [(0.0, 1.9, 1.0), (0.0, 2.2, 0.7), (0.4, 1.9, math.sqrt(0.6 + 0.4 / 1.9)), (0.4, 2.2, math.sqrt(0.3 + 0.4 / 2.2)),
     (1.0, 2.2, 1.0 / math.sqrt(2.2)), (2.0, 1.6, 1.0 / math.sqrt(1.6))],
)  # fmt: skip
def test_load_sharing_on_both_sides_of_two_pairs_in_contact(overlap, ratio, expected):
    """ISO 6336-3:2019, clause 6.2: from ε_αn = 2 on two pairs halve the spur part of the load."""
    mesh = SimpleNamespace(transverse_contact_ratio=ratio, base_helix_angle=0.0, overlap_ratio=overlap)
    assert float(load_sharing_factor(mesh)) == near(expected)


def test_proportions_of_a_made_pair_are_the_racks():
    mesh = shifted_mesh((18.0, 43.0), (ToothShift(0.1), ToothShift(-0.1)), None, pressure_angle=0.35)
    assert mesh.proportions == (ToothProportions(profile_shift=0.1), ToothProportions(profile_shift=-0.1))
    assert np.isclose(float(mesh.centre_distance), 30.5)
