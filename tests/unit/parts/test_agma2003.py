"""Bevel gears by AGMA 2003: the tooth traced once more by hand, and every factor's limits, steps and directions."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.agma2003 import (
    BENDING,
    BENDING_CRITICAL,
    CONTACT,
    OVERHUNG,
    STRADDLE,
    UNCROWNED,
    AgmaBevelDuty,
    AgmaBevelMaking,
    BevelEdition,
    BevelSteel,
    bevel_geometry,
    bevel_strength,
    lengthwise_curvature,
    load_distribution,
    rate_agma_bevel,
    size_factor_bending,
    size_factor_contact,
    temperature_factor,
)
from gearwright.parts.agma2003_geometry import MeanSection, effective_face, load_point, weakest_section
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth, mean_thickness
from gearwright.parts.iso6336 import life_factor

PSI = 6894.757
SPIRAL = BevelPair((14, 39), 4.5e-3, 25e-3, math.radians(35.0), tooth=BevelTooth(profile_shift=0.4))
STRAIGHT = BevelPair((20, 60), 3e-3, 28e-3, tooth=BevelTooth(profile_shift=0.3))
MITER = BevelPair((25, 25), 5e-3, 27e-3)
STEEL = bevel_strength(BevelSteel.CARBURISED, 1)
MAKING = AgmaBevelMaking((STEEL, STEEL))
DUTY = AgmaBevelDuty(150.0, 180.0, 3600.0 * 1000.0)
PAIRS = pytest.mark.parametrize("pair", [SPIRAL, STRAIGHT, MITER])


def traced_fillet(section, gear, points=20001):
    """The fillet of one tooth: the tool's tip circle carried by its rack, turned back by the gear's roll."""
    pair, radius = section.bevel, section.normal_radii[gear]
    alpha, tool = pair.pressure_angle, pair.tooth.edge_radii[gear] * pair.mean_module
    deep = pair.dedenda[gear] - tool
    across = 0.5 * mean_thickness(pair, gear) + pair.dedenda[gear] * math.tan(alpha)
    across += tool * (1.0 / math.cos(alpha) - math.tan(alpha))
    turn = np.linspace(0.0, across / radius + 3.0 * deep / radius, points)
    # In space the rack moves by r ζ, its tip circle's centre lies at (across − r ζ, r − deep); the gear turns by ζ.
    x, y = across - radius * turn, np.full_like(turn, radius - deep)
    away = np.hypot(x, y - radius)  # from the rolling point (0, r), through which every normal passes
    x, y = x + tool * x / away, y + tool * (y - radius) / away
    return x * np.cos(turn) + y * np.sin(turn), y * np.cos(turn) - x * np.sin(turn)


@PAIRS
@pytest.mark.parametrize("gear", [0, 1])
def test_the_weakest_section_is_where_the_traced_fillet_leaves_the_smallest_parabola(pair, gear):
    """Lewis: of all parabolas from the load through points of the fillet, s²/h is least where one only touches it."""
    section = MeanSection(pair)
    rise = 0.5 * pair.mean_module
    x, y = traced_fillet(section, gear)
    height = section.normal_radii[gear] + rise - y
    below = y < section.normal_radii[gear] - 0.3 * pair.mean_module
    strength = np.where(below & (x > 0.0), x**2 / height, np.inf)
    at = int(np.argmin(strength))
    found = weakest_section(section, gear, rise)
    assert found.half_chord**2 / found.height == pytest.approx(strength[at], rel=1e-6)
    assert (found.half_chord, found.height) == pytest.approx((x[at], height[at]), rel=2e-3)


@PAIRS
def test_geometry_factors_do_not_ask_for_size(pair):
    twice = replace(pair, outer_module=2.0 * pair.outer_module, face_width=2.0 * pair.face_width)
    ours, theirs = bevel_geometry(pair), bevel_geometry(twice)
    assert theirs.pitting.factor == pytest.approx(ours.pitting.factor, rel=1e-8)
    for one, other in zip(ours.bending, theirs.bending, strict=True):
        assert other.factor == pytest.approx(one.factor, rel=1e-9)


def test_both_gears_of_a_straight_miter_pair_are_alike():
    first, second = bevel_geometry(MITER).bending
    assert first == second
    assert MeanSection(MITER).location == 0.0


def test_straight_teeth_are_loaded_at_the_ends_of_single_contact():
    """y_3 = p_b from the mate's tip, and the lowest point of single contact lies as far from the other end."""
    section = MeanSection(STRAIGHT)
    assert load_point(section, concave=True).along_path == pytest.approx(section.base_pitch, rel=1e-12)
    found = bevel_geometry(STRAIGHT).pitting
    assert found.place == pytest.approx(0.5 * section.action - section.base_pitch, rel=1e-12)
    assert found.sharing == pytest.approx(1.0, abs=1e-12)


def test_the_contact_ratios_of_straight_teeth_are_those_of_the_back_cone():
    """ε_α = g_α/p_b of spur gears with z/cos δ teeth; no overlap."""
    section = MeanSection(STRAIGHT)
    assert section.profile_ratio == pytest.approx(section.action / section.base_pitch, rel=1e-12)
    assert section.face_ratio == 0.0
    assert section.base_sine == pytest.approx(0.0, abs=1e-7)


def test_the_spiral_pitting_point_is_the_worst_near_the_middle():
    from gearwright.parts.agma2003_geometry import _at

    section = MeanSection(SPIRAL)
    found = bevel_geometry(SPIRAL).pitting
    reach = math.sqrt(section.ellipse)
    near = [_at(section, found.place + part * reach).factor for part in np.linspace(-0.1, 0.1, 41)]
    assert found.factor <= min(near) + 1e-12


@pytest.mark.parametrize("spiral", [1e-6, 0.5])
def test_bending_is_continuous_from_straight_to_spiral_and_pitting_falls_there(spiral):
    """J has no step. I has one: spiral teeth are judged where I is least, straight ones at single contact."""
    lean = replace(STRAIGHT, spiral_angle=math.radians(spiral))
    straight, leaning = bevel_geometry(STRAIGHT), bevel_geometry(lean)
    for one, other in zip(straight.bending, leaning.bending, strict=True):
        assert other.factor == pytest.approx(one.factor, rel=1e-5 + 1e-2 * spiral)
    assert 0.93 * straight.pitting.factor < leaning.pitting.factor <= straight.pitting.factor * (1.0 + 0.01 * spiral)


def test_a_larger_tool_radius_strengthens_the_root_and_not_the_flank():
    found = [
        bevel_geometry(replace(SPIRAL, tooth=replace(SPIRAL.tooth, edge_radii=(edge, edge))))
        for edge in (0.1, 0.2, 0.3)
    ]
    for gear in (0, 1):
        factors = [one.bending[gear].factor for one in found]
        assert factors == sorted(factors)
    assert len({round(one.pitting.factor, 12) for one in found}) == 1


def test_shift_strengthens_the_pinion_at_the_cost_of_the_wheel():
    found = [bevel_geometry(replace(STRAIGHT, tooth=BevelTooth(profile_shift=shift))) for shift in (0.1, 0.3, 0.5)]
    assert [one.bending[0].factor for one in found] == sorted(one.bending[0].factor for one in found)
    assert [one.bending[1].factor for one in found] == sorted((one.bending[1].factor for one in found), reverse=True)


def test_few_teeth_in_contact_cost_inertia_unless_they_do_not_run():
    section, resting = MeanSection(SPIRAL), MeanSection(SPIRAL, is_static=True)
    assert section.inertia == pytest.approx(2.0 / section.modified_ratio)
    assert resting.inertia == 1.0
    long = MeanSection(replace(SPIRAL, teeth=(30, 45), outer_module=6e-3, face_width=45e-3))
    assert long.modified_ratio > 2.0
    assert long.inertia == 1.0


@pytest.mark.parametrize(
    ("edition", "width", "factor"),
    [
        (BevelEdition.D19, 5e-3, 0.5), (BevelEdition.D19, 12.7e-3, 0.5), (BevelEdition.D19, 50.8e-3, 0.6875),
        (BevelEdition.D19, 79.8e-3, 0.8302), (BevelEdition.D19, 200e-3, 0.8302), (BevelEdition.B97, 114.3e-3, 1.0),
        (BevelEdition.B97, 200e-3, 1.0), (BevelEdition.B97, 50.8e-3, 0.6875),
    ],
)  # fmt: skip
def test_size_for_pitting(edition, width, factor):
    """0.5 up to 0.5 in; 0.125 F + 0.4375; 0.83 from 79.8 mm (D19) or 1 from 4.5 in (B97)."""
    assert size_factor_contact(width, edition) == pytest.approx(factor, abs=1e-4)


def test_size_for_bending_begins_at_one_half():
    assert size_factor_bending(1.5e-3) == 0.5
    assert size_factor_bending(1.6e-3) == pytest.approx(0.5, abs=2e-4)
    assert size_factor_bending(25.4e-3) == pytest.approx(0.4867 + 0.2132)


def test_load_distribution_grows_with_the_square_of_the_width_and_ends_at_14_inches():
    assert load_distribution(0.0, STRADDLE) == STRADDLE
    assert load_distribution(50.8e-3, OVERHUNG) - OVERHUNG == pytest.approx(4.0 * 0.0036)
    with pytest.raises(DesignError, match=r"eq. 20 holds up to 356 mm"):
        load_distribution(360e-3, OVERHUNG)


def test_lengthwise_curvature_is_held_between_1_and_1_15():
    angle, cone = math.radians(35.0), 0.1
    radii = np.linspace(0.01, 0.3, 60)
    factors = [lengthwise_curvature(angle, radius, cone) for radius in radii]
    assert factors[0] == 1.15
    assert factors[-1] == 1.0
    assert all(one >= other for one, other in itertools.pairwise(factors))
    assert lengthwise_curvature(angle, cone, cone) == 1.0
    assert lengthwise_curvature(0.0, 0.01, cone) == 1.0
    assert lengthwise_curvature(angle, math.inf, cone) == 1.0
    by_hand = 0.211 * 0.8 ** (0.279 / math.log10(math.sin(angle))) + 0.789
    assert lengthwise_curvature(angle, 0.8 * cone, cone) == pytest.approx(by_hand)


def test_temperature_counts_from_250_fahrenheit():
    limit = (250.0 - 32.0) / 1.8
    assert temperature_factor(20.0) == temperature_factor(limit) == 1.0
    assert temperature_factor(limit + 10.0) == pytest.approx(1.0 + 18.0 / 710.0)


def test_cycle_factors_fall_without_steps_and_are_held_at_few_cycles():
    cycles = np.logspace(0, 10, 2001)
    for curve, most in ((CONTACT, 2.0), (BENDING, 2.7), (BENDING_CRITICAL, 2.7)):
        values = life_factor(curve, cycles)
        assert values[0] == most
        assert np.all(np.diff(values) < 1e-12)
        assert np.max(-np.diff(np.log(values))) < 0.1192 * math.log(cycles[1] / cycles[0]) + 1e-12
    assert life_factor(CONTACT, 0.0) == pytest.approx(2.0, rel=1e-12)
    assert life_factor(BENDING_CRITICAL, 1e9) < life_factor(BENDING, 1e9)


@pytest.mark.parametrize(
    ("steel", "grade", "hardness", "bending", "contact"),
    [
        (BevelSteel.THROUGH_HARDENED, 2, 300.0, 20380.0, 138640.0), (BevelSteel.CARBURISED, 3, 0.0, 40e3, 250e3),
        (BevelSteel.NITRIDED_4140, 2, 0.0, 22e3, 145e3), (BevelSteel.NITRALLOY, 2, 0.0, 24e3, 160e3),
    ],
)  # fmt: skip
def test_rows_of_the_strength_tables(steel, grade, hardness, bending, contact):
    """Tables 3 and 5 in psi; grade 2: 48 HB + 5980 and 363.6 HB + 29 560 (Shigley, eqs 15-22, 15-23)."""
    found = bevel_strength(steel, grade, hardness)
    assert (found.bending / PSI, found.contact / PSI) == pytest.approx((bending, contact), rel=1e-6)


@pytest.mark.parametrize(
    ("steel", "grade", "hardness", "told"),
    [
        (BevelSteel.THROUGH_HARDENED, 3, 300.0, "has 1 and 2"), (BevelSteel.NITRALLOY, 1, 0.0, "has 2"),
        (BevelSteel.CARBURISED, 4, 0.0, "has 1 and 2 and 3"), (BevelSteel.THROUGH_HARDENED, 1, 179.0, "180 to 400"),
        (BevelSteel.THROUGH_HARDENED, 1, 401.0, "180 to 400"),
    ],
)  # fmt: skip
def test_grades_and_hardnesses_that_there_are_not(steel, grade, hardness, told):
    with pytest.raises(DesignError, match=told):
        bevel_strength(steel, grade, hardness)


@PAIRS
def test_stresses_follow_the_load(pair):
    ours, theirs = (rate_agma_bevel(pair, replace(DUTY, torque=torque), MAKING) for torque in (150.0, 600.0))
    for one, other in zip(ours.gears, theirs.gears, strict=True):
        assert other.bending_stress == pytest.approx(4.0 * one.bending_stress)
        assert other.contact_stress == pytest.approx(2.0 * one.contact_stress)
        assert other.bending_safety == pytest.approx(one.bending_safety / 4.0)
        assert other.contact_safety == pytest.approx(one.contact_safety / 2.0)


def test_a_rating_by_hand():
    """Eqs 1, 2, 5 and 6 with the factors that the rating shows."""
    making = replace(MAKING, crowning=UNCROWNED, mounting=OVERHUNG, reliability=0.999, temperature=150.0, quality=8)
    duty = replace(DUTY, overload=1.25, meshes_per_turn=(2.0, 1.0), is_reversed=(False, True))
    rated = rate_agma_bevel(SPIRAL, duty, making)
    mesh, (pinion, wheel) = rated.mesh, rated.gears
    force = 2.0 * 150.0 / (14 * 4.5e-3)
    turns = 180.0 * 3600e3 / (2.0 * math.pi)
    assert mesh.cycles == pytest.approx((2.0 * turns, turns * 14 / 39))
    load = force * 1.25 * mesh.dynamic * (1.25 + 0.0036 * (25.0 / 25.4) ** 2)
    size = 0.125 * 25.0 / 25.4 + 0.4375
    assert pinion.contact_stress == wheel.contact_stress
    assert pinion.contact_stress == pytest.approx(
        mesh.elastic * math.sqrt(load * size * 2.0 / (25e-3 * 14 * 4.5e-3 * rated.pitting.factor))
    )
    hot = (492.0 + 1.8 * 150.0) / 710.0
    assert mesh.reliability_bending == pytest.approx(1.25)
    for gear, one in enumerate(rated.gears):
        root = load * (0.4867 + 0.2132 * 4.5 / 25.4) / (25e-3 * 4.5e-3 * rated.tooth_root[gear].factor)
        assert one.bending_stress == pytest.approx(root)
        limit = 30e3 * PSI * mesh.bending_cycles[gear] * (0.7 if gear else 1.0) / (hot * 1.25)
        assert one.bending_limit == pytest.approx(limit, rel=1e-6)
        assert one.contact_limit == pytest.approx(
            200e3 * PSI * mesh.contact_cycles[gear] / (hot * math.sqrt(1.25)), rel=1e-6
        )


def test_a_softer_wheel_hardens_under_its_pinion():
    """C_H = 1 + (0.00898 · 1.5 − 0.00829)(39/14 − 1)."""
    steels = tuple(bevel_strength(BevelSteel.THROUGH_HARDENED, 1, hardness) for hardness in (360.0, 240.0))
    rated = rate_agma_bevel(SPIRAL, DUTY, AgmaBevelMaking(steels, hardnesses=(360.0, 240.0)))
    assert rated.mesh.hardness_ratio == pytest.approx((1.0, 1.0 + (0.00898 * 1.5 - 0.00829) * (39 / 14 - 1.0)))


def test_straight_teeth_that_lose_contact_are_refused():
    with pytest.raises(DesignError, match=r"eq. C.24 asks straight teeth for more than 1"):
        MeanSection(replace(MITER, tooth=BevelTooth(addendum=0.5)))


def test_known_geometry_is_used_as_it_is():
    known = bevel_geometry(replace(SPIRAL, outer_module=1.0, face_width=25.0 / 4.5))
    by_scale, own = rate_agma_bevel(SPIRAL, DUTY, MAKING, known), rate_agma_bevel(SPIRAL, DUTY, MAKING)
    for one, other in zip(by_scale.gears, own.gears, strict=True):
        assert one.bending_safety == pytest.approx(other.bending_safety, rel=1e-9)
        assert one.contact_safety == pytest.approx(other.contact_safety, rel=1e-9)


def test_annex_c_by_hand():
    """Eqs C.7, C.25, C.26, C.42, C.47, C.52 to C.56 and C.106 to C.116, of 14/39 with 35°, 25 mm of 93.2 mm."""
    section, b = MeanSection(SPIRAL), 25e-3
    cone = 4.5e-3 * math.hypot(14, 39) / 2.0
    k = 25.0 / (3.2 * 39.0 + 4.0 * 14.0)
    x = b / cone
    kz, tan = x * (2.0 - x) / (2.0 * (1.0 - x)), math.tan(math.radians(35.0))
    assert section.location == pytest.approx(k, rel=1e-12)
    assert section.face_ratio == pytest.approx(
        (kz * tan - (kz * tan) ** 3 / 3.0) * cone / (math.pi * 4.5e-3), rel=1e-12
    )
    g, cos2, sin, square = section.action, section.base_cosine**2, section.base_sine, section.ellipse
    place = section.base_pitch - math.sqrt(square) / 2.0
    chord = math.sqrt(square - 4.0 * place**2)
    for concave, side in ((True, 1.0), (False, -1.0)):
        load = load_point(section, concave=concave)
        path = g / 2.0 + (g**2 * place * cos2 + side * b * g * chord * k * sin) / square
        face = (b * g * chord * k * cos2 - side * g**2 * place * sin) / square
        assert (load.along_path, load.along_face) == pytest.approx((path, face), rel=1e-12)
        line, lean, h = b * g * chord * cos2 / square, math.cos(math.radians(35.0)), 5e-3
        toe, heel = (b - line) / (2.0 * lean) + face / lean, (b - line) / (2.0 * lean) - face / lean
        toe, heel = (toe, heel) if heel > 0.0 else (toe + heel, 0.0)
        spread = h * lean * (math.atan(toe / h) + math.atan(heel / h)) + line
        assert effective_face(section, load, h) == pytest.approx(spread / b, rel=1e-12)


def test_the_load_is_shared_by_the_cubes_of_all_lines_in_the_ellipse():
    """Eqs C.41, C.42: other lines lie whole base pitches away; by chords of the ellipse, (g² − 4 (y ± k p)²)^1.5."""
    wide = MeanSection(replace(SPIRAL, teeth=(30, 45), outer_module=6e-3, face_width=45e-3))
    for place in (0.0, 0.1 * wide.base_pitch, -0.3 * wide.base_pitch):
        cubes = [max(wide.ellipse - 4.0 * (place + step * wide.base_pitch) ** 2, 0.0) ** 1.5 for step in range(-6, 7)]
        assert wide.sharing(place) == pytest.approx(cubes[6] / sum(cubes), rel=1e-12)
        assert wide.sharing(place) == pytest.approx(wide.sharing(-place), rel=1e-12)
    assert wide.sharing(0.0) < 1.0


def test_straight_teeth_just_above_a_contact_ratio_of_1_are_rated():
    assert 1.0 < MeanSection(replace(MITER, tooth=BevelTooth(addendum=0.56))).profile_ratio < 1.01
    with pytest.raises(DesignError, match=r"0.971 given"):
        MeanSection(replace(MITER, tooth=BevelTooth(addendum=0.54)))
