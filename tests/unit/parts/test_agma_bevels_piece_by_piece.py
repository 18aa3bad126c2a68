"""AGMA 2003 of a spiral pair whose gears differ: annex C quantity by quantity, and stresses with no factor of 1."""

import math
from dataclasses import replace
from types import SimpleNamespace

import pytest

from gearwright.parts.agma2003 import AgmaBevelDuty, AgmaBevelMaking, BevelStrength, bevel_factors, rate_with_factors
from gearwright.parts.agma2003_geometry import (
    MeanSection,
    bending_geometry,
    effective_face,
    load_point,
    pitting_geometry,
)
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth

TEETH, LEAN, ALPHA = (14, 39), math.radians(35.0), math.radians(20.0)
OUTER = 4.5e-3 * math.hypot(*TEETH) / 2.0
MEAN = OUTER - 12.5e-3
CONES = math.atan2(14, 39), math.atan2(39, 14)
MODULE = 4.5e-3 * math.cos(LEAN) * MEAN / OUTER
SPIRAL = BevelPair(TEETH, 4.5e-3, 25e-3, LEAN, tooth=BevelTooth(profile_shift=0.4, thickness_shifts=(0.05, -0.05)))
SHIFTS = (0.4, -0.4)


def near(value: float) -> object:
    return pytest.approx(value, rel=1e-10)


def hand() -> SimpleNamespace:
    """Eqs C.10 to C.29 from tooth numbers, outer module, face width and spiral angle."""
    own = SimpleNamespace()
    own.transverse = [4.5e-3 * z * MEAN / OUTER / (2.0 * math.cos(d)) for z, d in zip(TEETH, CONES, strict=True)]
    own.normal = [r / math.cos(LEAN) ** 2 for r in own.transverse]
    own.base = [r * math.cos(ALPHA) for r in own.normal]
    tips = [r + (1.0 + x) * MODULE for r, x in zip(own.normal, SHIFTS, strict=True)]
    own.tangents = [math.sqrt(tip**2 - base**2) for tip, base in zip(tips, own.base, strict=True)]
    own.actions = [t - r * math.sin(ALPHA) for t, r in zip(own.tangents, own.normal, strict=True)]
    own.pitch = math.pi * MODULE * math.cos(ALPHA)
    own.cos_b = math.cos(math.asin(math.sin(LEAN) * math.cos(ALPHA)))
    own.sin_b = math.sin(LEAN) * math.cos(ALPHA)
    own.ellipse = (sum(own.actions) * own.cos_b**2) ** 2 + (25e-3 * own.sin_b) ** 2
    # C.12, C.24: p_2 = π m_mn/cos α/(cos² β + tan² α)
    own.profile = sum(own.actions) * (math.cos(LEAN) ** 2 + math.tan(ALPHA) ** 2) * math.cos(ALPHA) / (math.pi * MODULE)
    part = 25e-3 / OUTER
    lean = part * (2.0 - part) / (2.0 * (1.0 - part)) * math.tan(LEAN)
    own.face = (lean - lean**3 / 3.0) * OUTER / (math.pi * 4.5e-3)
    return own


def test_the_mean_section_has_the_radii_paths_and_ratios_of_annex_c():
    section, own = MeanSection(SPIRAL), hand()
    assert section.mean_scale == near(MEAN / OUTER)
    for found, expected in (
        (section.transverse_radii, own.transverse), (section.normal_radii, own.normal), (section.base_radii, own.base),
        (section.tip_tangents, own.tangents), (section.addendum_actions, own.actions),
    ):  # fmt: skip
        assert found == pytest.approx(expected, rel=1e-10)
    assert section.action == near(sum(own.actions))
    assert section.base_pitch == near(own.pitch)
    assert (section.base_cosine, section.base_sine) == (near(own.cos_b), near(own.sin_b))
    assert (section.profile_ratio, section.face_ratio) == (near(own.profile), near(own.face))
    assert section.modified_ratio == near(math.hypot(own.profile, own.face))
    assert section.inertia == near(max(2.0 / math.hypot(own.profile, own.face), 1.0))
    assert section.ellipse == near(own.ellipse)
    assert section.location == near(25.0 / (3.2 * 39.0 + 4.0 * 14.0))


def test_the_pitting_factor_of_a_spiral_pair_is_its_curvature_line_and_share():
    """Eqs C.1, C.35 to C.42 at the place that is found; places beside it have a larger I."""
    section, own = MeanSection(SPIRAL), hand()
    found = pitting_geometry(section)

    def factor(y: float) -> tuple[float, float, float]:
        chord = math.sqrt(own.ellipse - 4.0 * y**2)
        g = sum(own.actions)
        way = (g**2 * y * own.cos_b**2 + 25e-3 * g * chord * section.location * own.sin_b) / own.ellipse
        moved = 0.5 * g + way - own.actions[1]
        radii = [r * math.sin(ALPHA) / own.cos_b**2 for r in own.transverse]
        first, second = radii[0] + moved, radii[1] - moved
        curvature, line = first * second / (first + second), 25e-3 * g * chord * own.cos_b / own.ellipse
        lines = [max(own.ellipse - 4.0 * (y + k * own.pitch) ** 2, 0.0) ** 1.5 for k in range(-5, 6)]
        value = line * curvature * math.cos(LEAN) * math.cos(ALPHA) * MEAN / OUTER
        return value * sum(lines) / lines[5] / (25e-3 * 4.5e-3 * 14 * section.inertia), curvature, line

    assert (found.factor, found.curvature, found.contact_line) == pytest.approx(factor(found.place), rel=1e-9)
    for beside in (-1e-4, 1e-4):
        assert factor(found.place + beside)[0] > found.factor


@pytest.mark.parametrize("gear", [0, 1])
def test_the_bending_factor_is_made_of_form_notch_share_and_places(gear):
    """Eqs C.43, C.44, C.58 to C.69 and C.82 from the weakest section that is found."""
    section, own = MeanSection(SPIRAL), hand()
    found, load = bending_geometry(section, gear), load_point(section, concave=gear == 0)
    reach = load.along_path + sum(own.normal) * math.sin(ALPHA) - own.tangents[1 - gear]
    loaded = math.atan(reach / own.base[gear])
    thickness = MODULE * (math.pi / 2.0 + 2.0 * ((0.05, -0.05)[gear] + SHIFTS[gear] * math.tan(ALPHA)))
    angle = loaded - (thickness / (2.0 * own.normal[gear]) - (math.tan(loaded) - loaded) + math.tan(ALPHA) - ALPHA)
    assert found.load_angle == near(angle)
    rise = own.base[gear] / math.cos(angle) - own.normal[gear]
    deep = (1.25 - SHIFTS[gear] - 0.3) * MODULE
    radius = deep**2 / (own.normal[gear] + deep) + 0.3 * MODULE
    assert found.fillet_radius == near(radius)
    beam = found.height / found.half_chord**2 - math.tan(angle) / (3.0 * found.half_chord)
    assert found.form == near(2.0 / (3.0 * 4.5e-3 * beam))
    chord = 2.0 * found.half_chord
    notch = 0.18 + (chord / radius) ** 0.15 * (chord / found.height) ** 0.45
    assert found.stress_correction == pytest.approx(notch, rel=2e-6)  # printed to three digits at 20°
    arm = 1.0 + load.along_face / MEAN + rise / own.transverse[gear]
    assert (found.load_radius, found.sharing) == (near(arm), load.sharing)
    assert found.effective_face == near(effective_face(section, load, found.height))
    whole = found.form / (found.stress_correction * load.sharing * section.inertia) * arm
    assert found.factor == near(whole * found.effective_face * MEAN / OUTER)


def test_teeth_of_another_pressure_angle_have_their_own_notch():
    """Dolan and Broghamer: H, L and M are 0.22, 0.20, 0.40 at 14.5° and 0.14, 0.11, 0.50 at 25°, to two digits."""
    for degrees, constants in ((14.5, (0.22, 0.20, 0.40)), (25.0, (0.14, 0.11, 0.50))):
        pair = replace(SPIRAL, pressure_angle=math.radians(degrees))
        found = bending_geometry(MeanSection(pair), 0)
        chord = 2.0 * found.half_chord
        expected = constants[0] + (chord / found.fillet_radius) ** constants[1] * (chord / found.height) ** constants[2]
        assert found.stress_correction == pytest.approx(expected, rel=0.02)


def test_stresses_of_agma_2003_with_no_factor_of_one():
    """Eqs 1, 2, 5 and 6: every factor on its side of the fraction."""
    given = {
        "tangential_force": 9e3, "overload": 1.3, "dynamic": 1.2, "distribution": 1.4, "elastic": 190e3,
        "size_contact": 0.6, "crowning": 1.5, "curvature": 1.1, "size_bending": 0.55, "temperature": 1.05,
        "reliability_bending": 1.25, "reliability_contact": 1.12, "bending_cycles": (0.9, 0.95),
        "contact_cycles": (1.05, 1.15), "reversal": (1.0, 0.7), "hardness_ratio": (1.0, 1.06),
    }  # fmt: skip
    geometry = SimpleNamespace(
        pitting=SimpleNamespace(factor=0.1), bending=(SimpleNamespace(factor=0.25), SimpleNamespace(factor=0.3))
    )
    strengths = (BevelStrength(200e6, 1300e6), BevelStrength(180e6, 1200e6))
    rated = rate_with_factors(SPIRAL, SimpleNamespace(**given), geometry, strengths)  # type: ignore[arg-type]
    load = 9e3 * 1.3 * 1.2 * 1.4
    contact = 190e3 * math.sqrt(load * 0.6 * 1.5 / (25e-3 * 4.5e-3 * 14 * 0.1))
    for gear, (j, s_at, s_ac, k_l, c_l, turned, hard) in enumerate(
        [(0.25, 200e6, 1300e6, 0.9, 1.05, 1.0, 1.0), (0.3, 180e6, 1200e6, 0.95, 1.15, 0.7, 1.06)]
    ):
        found = rated.gears[gear]
        bending = load * 0.55 / (25e-3 * 4.5e-3 * 1.1 * j)
        assert (found.bending_stress, found.contact_stress) == (near(bending), near(contact))
        limits = s_at * k_l * turned / (1.05 * 1.25), s_ac * c_l * hard / (1.05 * 1.12)
        assert (found.bending_limit, found.contact_limit) == (near(limits[0]), near(limits[1]))
        assert (found.bending_safety, found.contact_safety) == (near(limits[0] / bending), near(limits[1] / contact))


def test_the_speed_of_a_bevel_pinion_is_that_of_its_outer_pitch_circle():
    """V = 0.063 m · 180 rad/s / 2 = 5.67 m/s = 1116 ft/min; Q_v = 11: B = 0.25, A = 92: K_v = ((92 + √V)/92)^0.25."""
    making = AgmaBevelMaking((BevelStrength(200e6, 1e9),) * 2)
    found = bevel_factors(SPIRAL, AgmaBevelDuty(150.0, -180.0, 3.6e6), making)
    assert found.speed == near(5.67)
    assert found.tangential_force == near(2.0 * 150.0 / 0.063)
    assert found.dynamic == near(((92.0 + math.sqrt(5.67 / (0.3048 / 60.0))) / 92.0) ** 0.25)
