"""Limits and defaults of formulas, at and beside the places where one clause ends and the next begins."""

import math

import pytest

from gearwright.errors import DesignError
from gearwright.parts.agma908 import HobbedPair, helical_overlap_factor
from gearwright.parts.bearings.life import Cleanliness, cleanliness_factor
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth
from gearwright.parts.gears import CylindricalGear, GearPair
from gearwright.parts.gears.gear_pair import assembly_room
from gearwright.parts.iso6336 import Treatment
from gearwright.parts.iso6336.steels import knee_curve
from gearwright.parts.iso6336.tooth_strength import contact_size_factor
from gearwright.parts.iso10300 import VirtualPair, tip_loaded_section
from gearwright.parts.planetary import CompoundSet, touching
from gearwright.parts.shaft_fatigue import SteelGroup, blank_factor
from gearwright.parts.shafts import shaft_diameter, shaft_stress


def overlap_by_hand(pair: HobbedPair) -> float:
    """C_ψ of AGMA 908-B89, clause 3.7, for m_F below 1, from radii alone."""
    phi = math.atan(math.tan(pair.pressure_angle) / math.cos(pair.helix_angle))
    r = [0.5 * z / math.cos(pair.helix_angle) for z in pair.teeth]
    base = [x * math.cos(phi) for x in r]
    outside = [x + 1.0 for x in r]
    reach = [math.sqrt(o**2 - b**2) for o, b in zip(outside, base, strict=True)]
    line = sum(r) * math.sin(phi)
    low = reach[0] - math.pi * math.cos(phi) / math.cos(pair.helix_angle)
    middle = 0.5 * (outside[0] + sum(r) - outside[1])
    mean = math.sqrt(middle**2 - base[0] ** 2)
    z = sum(reach) - line
    ratio = mean * (line - mean) * z / (low * (line - low) * math.pi * math.cos(pair.pressure_angle))
    axial = pair.face_width * math.sin(pair.helix_angle) / math.pi
    return math.sqrt(1.0 - axial * (1.0 - ratio))


@pytest.mark.parametrize("axial", [0.2, 0.6, 1.0])
def test_the_helical_overlap_joins_spur_and_helical_gears(axial: float):
    lean = math.radians(15.0)
    pair = HobbedPair((24, 67), helix_angle=lean, face_width=axial * math.pi / math.sin(lean) * (1.0 - 1e-12))
    assert helical_overlap_factor(pair) == pytest.approx(overlap_by_hand(pair), rel=1e-9)
    assert helical_overlap_factor(pair) != pytest.approx(1.0, abs=1e-4)


def test_leaning_teeth_past_one_axial_pitch_and_spur_teeth_have_no_overlap_factor():
    lean = math.radians(15.0)
    assert (
        helical_overlap_factor(HobbedPair((24, 67), helix_angle=lean, face_width=1.1 * math.pi / math.sin(lean))) == 1.0
    )
    assert helical_overlap_factor(HobbedPair((24, 67))) == 1.0


@pytest.mark.parametrize(
    ("kind", "small", "large"),
    [(Cleanliness.EXTREME, 1.0, 1.0), (Cleanliness.HIGH, 0.7, 0.85), (Cleanliness.NORMAL, 0.55, 0.7),
     (Cleanliness.SLIGHT, 0.4, 0.5), (Cleanliness.TYPICAL, 0.2, 0.3), (Cleanliness.SEVERE, 0.05, 0.05)],
)  # fmt: skip
def test_contamination_by_class_is_the_middle_of_the_printed_ranges(kind: Cleanliness, small: float, large: float):
    """ISO 281:2007, table 13: 1; 0.8 … 0.6 and 0.9 … 0.8; 0.6 … 0.5 and 0.8 … 0.6; 0.5 … 0.3; 0.3 … 0.1; 0.1 … 0."""
    assert cleanliness_factor(kind, 99e-3) == small
    assert cleanliness_factor(kind, 101e-3) == large


@pytest.mark.parametrize(
    ("group", "at", "slope"),
    [(SteelGroup.CASE_HARDENED, 16.0, 0.41), (SteelGroup.TEMPERED, 16.0, 0.26), (SteelGroup.NITRIDING, 100.0, 0.23),
     (SteelGroup.STRUCTURAL, 100.0, 0.23), (SteelGroup.NICKEL_CASE_HARDENED, 16.0, 0.26)],
)  # fmt: skip
def test_strength_falls_with_the_blank_by_the_printed_logarithms(group: SteelGroup, at: float, slope: float):
    """DIN 743-2:2012, K_1 = 1 − slope lg(d/d_B), to 150 mm or 300 mm."""
    assert blank_factor(0.999e-3 * at, group, yielding=False) == 1.0
    assert blank_factor(1.3e-3 * at, group, yielding=False) == pytest.approx(1.0 - slope * math.log10(1.3), rel=1e-9)
    last = 150.0 if group is SteelGroup.CASE_HARDENED else 300.0
    assert blank_factor(0.4, group, yielding=False) == pytest.approx(1.0 - slope * math.log10(last / at), rel=1e-9)


@pytest.mark.parametrize("treatment", Treatment)
def test_only_hard_flanks_are_weaker_in_coarse_teeth(treatment: Treatment):
    """DIN 3990-2:1987, table 4."""
    factor = contact_size_factor(20e-3, treatment)
    soft = treatment in (Treatment.STRUCTURAL, Treatment.THROUGH_HARDENED) or "IRON" in treatment.name
    nitrided = "NITR" in treatment.name
    assert factor == pytest.approx(1.0 if soft else 1.08 - 0.22 if nitrided else 0.95, rel=1e-9)


def test_a_line_by_its_knee_begins_where_it_reaches_the_static_factor():
    """N_0 = N_L Z_0^(-p): from 5·10⁷ at p = 13.22 and 1.6 to 10⁵ cycles; at 10^10 what is stated."""
    curve = knee_curve(5e7, 6.0, greatest=2.0, at_1e10=0.9)
    assert curve.cycles == pytest.approx((5e7 / 64.0, 5e7, 1e10))
    assert curve.factors == (2.0, 1.0, 0.9)


def test_a_solid_shaft_is_that_of_a_bore_of_nothing():
    """d³ = 32 √(M² + T²)/(π σ (1 − κ⁴))."""
    solid = shaft_diameter(300.0, 400.0, 100e6)
    assert solid**3 == pytest.approx(32.0 * 500.0 / (math.pi * 100e6), rel=1e-12)
    assert shaft_diameter(300.0, 400.0, 100e6, bore_ratio=0.5) ** 3 == pytest.approx(
        solid**3 / (1.0 - 0.0625), rel=1e-12
    )
    assert shaft_stress(300.0, 400.0, solid) == pytest.approx(100e6, rel=1e-12)


@pytest.mark.parametrize(("width", "limit"), [(34e-3, 33.33), (0.03, None)])
def test_bevel_faces_are_a_third_of_the_cone_or_ten_modules_wide_at_the_most(width: float, limit: float | None):
    """20 and 20 teeth at a right angle: R_e = d_e/√2."""
    module = 0.1 * math.sqrt(2.0) / 20.0  # R_e = 100 mm; 10 modules are 70.7 mm
    if limit is None:
        assert BevelPair((20, 20), module, width).outer_cone_distance == pytest.approx(0.1)
        return
    with pytest.raises(DesignError, match=r"use at most 33\.33 mm"):
        BevelPair((20, 20), module, width)


def test_many_small_bevel_teeth_are_ten_modules_wide_at_the_most():
    """60 and 60 teeth: R_e/3 is 14.1 modules."""
    with pytest.raises(DesignError, match="use at most 20 mm"):
        BevelPair((60, 60), 2e-3, 20.1e-3)
    assert BevelPair((60, 60), 2e-3, 20e-3).face_width == 20e-3


def test_a_shifted_pinion_and_its_mate_have_the_roots_of_each_other_where_the_shift_turns():
    """Equal teeth: the pinion with +x is the wheel with −x."""
    shifted = VirtualPair(BevelPair((25, 25), 4e-3, 20e-3, tooth=BevelTooth(profile_shift=0.2)))
    turned = VirtualPair(BevelPair((25, 25), 4e-3, 20e-3, tooth=BevelTooth(profile_shift=-0.2)))
    assert tip_loaded_section(shifted, 0) == tip_loaded_section(turned, 1)
    assert tip_loaded_section(shifted, 0) != tip_loaded_section(shifted, 1)


def test_a_pinion_of_many_teeth_is_tried_with_all_that_may_touch():
    """The room of a narrow difference of teeth is that of a tooth far from the middle: counted by rolling in steps."""
    pair = GearPair(CylindricalGear(40, 2e-3, 10e-3), CylindricalGear(-60, 2e-3, 10e-3))
    room = assembly_room(pair)
    assert room is not None
    rooms = []
    tip, ring_tip = pair.driver.tip_radius, pair.driven.tip_radius
    for tooth in range(20):
        angle = 2.0 * math.pi * tooth / 40.0 + _half(pair.driver, tip)
        side = tip * math.sin(angle)
        if side > ring_tip or angle > math.pi / 2.0:
            break
        if pair.centre_distance + tip * math.cos(angle) > math.sqrt(ring_tip**2 - side**2):
            space = 2.0 * math.pi * tooth / 60.0 + math.pi / 60.0 - _half(pair.driven, ring_tip)
            rooms.append(ring_tip * math.sin(space) - side)
    assert room.clearance == pytest.approx(min(rooms), rel=1e-9)


def _half(gear: CylindricalGear, radius: float) -> float:
    """Half the angle of a tooth at a radius, without shift [rad]."""
    inv = lambda angle: math.tan(angle) - angle  # noqa: E731
    at = math.acos(gear.base_radius / radius)
    side = 1.0 if gear.teeth > 0 else -1.0
    return math.pi / (2.0 * abs(gear.teeth)) + side * (inv(math.radians(20.0)) - inv(at))


def test_planets_of_one_set_that_mesh_do_not_touch_and_those_of_two_sets_may():
    """Meshed pairs: the planets of a pair touch by their teeth and are left out; neighbours stand 2π/N apart."""
    few = CompoundSet(
        3, {"sun": 30, "ring": -90}, {"in": 18, "out": 18}, {"in": "in", "out": "out"},
        (("sun", "in"), ("in", "out"), ("out", "ring")),
    )  # fmt: skip
    many = CompoundSet(
        8, {"sun": 30, "ring": -90}, {"in": 18, "out": 18}, {"in": "in", "out": "out"},
        (("sun", "in"), ("in", "out"), ("out", "ring")),
    )  # fmt: skip
    assert ("in", "out") not in {pair[:2] for pair in touching(few, {"": 2e-3})}
    apart = 2.0 * 24.0 * 2e-3 * math.sin(math.pi / 8.0)  # inner pins at (30 + 18)/2 modules
    overlaps = {pair[:2]: pair[2] for pair in touching(many, {"": 2e-3})}
    assert overlaps["in", "in"] == pytest.approx(20.0 * 2e-3 - apart, rel=1e-9)
