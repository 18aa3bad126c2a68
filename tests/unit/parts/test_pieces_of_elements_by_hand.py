"""Blanks, rolling bearings' weights and reference speeds, DIN 743's laws of size and tension, pins: by hand."""

import math

import pytest
from scipy.optimize import brentq

from gearwright.parts.bearings import BearingGeometry, BearingKind
from gearwright.parts.bearings.rolling_bearing import (
    CERAMIC_DENSITY,
    reference_heat,
    rolling_weights,
    thermal_reference_speed,
    turning_inertia,
)
from gearwright.parts.bevel_geometry import BevelPair, bevel_volume, lightened_web
from gearwright.parts.carriers import pin_bore, pin_diameter, pin_mass, pin_stress
from gearwright.parts.gears import Blank, TransverseTooth, blank_volume, face_crown, face_reach, revolved_volume
from gearwright.parts.shaft_fatigue import (
    AxialLoad,
    Concentration,
    SectionLoad,
    ShaftSection,
    ShaftSteel,
    SteelGroup,
    blank_factor,
    din743_safety,
)

near = pytest.approx
PI = math.pi


def test_a_webbed_blank_is_rim_hub_and_web():
    """π ((50² − 42²) 20 + (18² − 12²) 20 + (42² − 18²) 5) mm³, and a solid one (50² − 12²) 20."""
    blank = Blank(0.050, 0.042, 0.018, 0.012, 0.020, 0.005)
    rim, hub, web = 50**2 - 42**2, 18**2 - 12**2, 42**2 - 18**2
    assert blank_volume(blank) == near(PI * (20 * rim + 20 * hub + 5 * web) * 1e-9)
    met = blank._replace(rim_radius=0.018)
    assert met.is_solid and not blank.is_solid
    assert blank_volume(met) == near(PI * (50**2 - 12**2) * 20 * 1e-9)
    assert blank_volume(met._replace(bore_radius=0.06)) == 0.0


def test_a_chain_of_lines_sweeps_frusta_of_cones():
    """A frustum of 20 and 10 mm, 30 mm long, with a bore of 5 mm: π/3 · 30 · (400 + 200 + 100) − π 25 · 30 mm³."""
    way = [(0.0, 0.005), (0.0, 0.020), (0.030, 0.010), (0.030, 0.005)]
    for corners in (way, way[::-1]):
        assert revolved_volume(corners) == near(PI * (10 * 700 - 25 * 30) * 1e-9)


def test_teeth_of_face_gears_are_trapezia_as_high_as_the_pinion_is_deep():
    """Half a pitch thick at half their height on the pitch cylinder, of which 3 mm are taken: z (π m/2) 2.25 m b."""
    pinion, teeth = TransverseTooth(60, 2e-3), 240
    thin = 3e-3
    inner, outer = face_reach(pinion, teeth, thin)
    assert (inner, outer) == near((0.24 - thin / 2.0, 0.24 + thin / 2.0))
    half = 0.5 * (1.25 - 1.0) * math.tan(math.radians(20.0)) * 2.0  # 1.125 m of depth above the middle, 1 m of it tip
    assert face_crown(pinion, teeth, thin) == near(teeth * (PI / 2.0 + half) * 2.25 * 4e-6 * thin, rel=5e-3)


def test_a_wheel_lightened_by_its_web_fills_its_share_of_the_whole():
    pair = BevelPair((14, 43), 9e-3, 0.06, math.radians(35.0))
    whole = bevel_volume(pair, 1, 0.04, 2.0)
    for share in (0.6, 0.8):
        assert bevel_volume(pair, 1, 0.04, lightened_web(pair, 1, 0.04, share)) == near(share * whole, rel=1e-5)
    assert bevel_volume(pair, 1, 0.04, lightened_web(pair, 1, 0.04, 0.01)) > 0.01 * whole  # the rim stays


BALLS = BearingGeometry(BearingKind.DEEP_GROOVE, 9, 0.010, 0.0465)
ROLLERS = BearingGeometry(BearingKind.CYLINDRICAL, 13, 0.010, 0.050, roller_length=0.012, rows=2)


def test_a_ball_bearing_weighs_its_rings_balls_and_cage():
    """30 × 63 × 15 mm: raceways at 36.5 and 56.5 mm, nine balls of 10 mm, 40 % of the rest of a ring 10 mm wide."""
    weights = rolling_weights(BALLS, 0.030, 0.063, 0.015)
    quarter = PI / 4.0 * 1e-9 * 7850.0
    balls = 9 * PI / 6.0 * 10**3
    assert weights.inner_ring == near(quarter * (36.5**2 - 30**2) * 15)
    assert weights.outer_ring == near(quarter * (63**2 - 56.5**2) * 15)
    assert weights.elements == near(7850e-9 * balls)
    assert weights.cage == near(0.4 * 7850e-9 * (PI / 4.0 * (56.5**2 - 36.5**2) * 10 - balls))
    assert weights.total == near(weights.inner_ring + weights.outer_ring + weights.elements + weights.cage)


def test_rollers_in_two_rows_of_ceramic_between_planet_and_pin_have_no_rings():
    """The shaft is one raceway and the bore the other: rings of no thickness, never less than none."""
    weights = rolling_weights(ROLLERS, 0.041, 0.059, 0.026, density=CERAMIC_DENSITY)
    rollers = 2 * 13 * PI / 4.0 * 10**2 * 12
    assert (weights.inner_ring, weights.outer_ring) == (0.0, 0.0)
    assert weights.elements == near(3200e-9 * rollers)
    assert weights.cage == near(0.4 * 7850e-9 * (2 * PI / 4.0 * (60**2 - 40**2) * 12 - rollers))


def test_what_turns_with_an_outer_ring_is_the_ring_and_half_as_fast_the_elements():
    """m (D² + d²)/8 of the ring; elements and cage at D_pw turn at (1 + γ)/2, γ = 10/46.5."""
    weights = rolling_weights(BALLS, 0.030, 0.063, 0.015)
    share = (1.0 + 10.0 / 46.5) / 2.0
    ring = weights.outer_ring * (0.063**2 + 0.0565**2) / 8.0
    inner = (weights.elements + weights.cage) * (0.0465 / 2.0) ** 2 * share**2
    assert turning_inertia(weights, BALLS, 0.063) == near(ring + inner)


@pytest.mark.parametrize(("bore", "outer", "width"), [(30.0, 62.0, 16.0), (150.0, 320.0, 65.0)])
def test_reference_speeds_balance_heat_as_iso_15312_writes_it(bore, outer, width):
    """π n/(30·10³) (1e-7 f_0r (ν_r n)^(2/3) d_m³ + f_1r P_1r d_m) = q_r A_r in mm, N and W; solved by bracketing."""
    surface, mean, load = PI * width * (outer + bore), 0.5 * (bore + outer), 0.05 * 11.2e3
    heat = 0.016 * surface * (surface / 50e3) ** -0.34 if surface > 50e3 else 0.016 * surface
    assert (surface > 50e3) == (bore > 100.0)
    assert reference_heat(1e-3 * bore, 1e-3 * outer, 1e-3 * width) == near(heat)

    def excess(turns):
        moment = 1e-7 * 1.7 * (12.0 * turns) ** (2.0 / 3.0) * mean**3 + 2e-4 * load * mean
        return PI * turns / 30e3 * moment - heat

    speed = thermal_reference_speed(
        1e-3 * bore, 1e-3 * outer, 1e-3 * width, static_rating=11.2e3, oil_factor=1.7, load_factor=2e-4
    )
    assert speed * 30.0 / PI == near(brentq(excess, 10.0, 1e6, xtol=1e-9), rel=1e-9)


@pytest.mark.parametrize(
    ("group", "strength", "yields", "end"),
    [
        ("STRUCTURAL", (100.0, 0.23), (32.0, 0.26), 300.0),
        ("NITRIDING", (100.0, 0.23), (100.0, 0.23), 300.0),
        ("TEMPERED", (16.0, 0.26), (16.0, 0.34), 300.0),
        ("NICKEL_CASE_HARDENED", (16.0, 0.26), (16.0, 0.26), 300.0),
        ("CASE_HARDENED", (16.0, 0.41), (16.0, 0.41), 150.0),
    ],
)
def test_steels_lose_strength_with_size_as_din_743_2_prints_it(group, strength, yields, end):
    """K_1 = 1 − slope lg(d_eff/d_B): one up to d_B, constant from the end on; DIN 743-2:2012, equations 11 to 14."""
    steel = SteelGroup[group]
    for (start, slope), yielding in ((strength, False), (yields, True)):
        at = {size: blank_factor(1e-3 * size, steel, yielding=yielding) for size in (10.0, start, 120.0, end, 400.0)}
        assert at[10.0] == at[start] == 1.0
        assert at[120.0] == near(1.0 - slope * math.log10(120.0 / start))
        assert at[400.0] == at[end] == near(1.0 - slope * math.log10(end / start))


STEEL = ShaftSteel(1000e6, 800e6, 500e6, 300e6, SteelGroup.TEMPERED, tension_fatigue=420e6)


def test_a_pull_alone_meets_its_own_notch_strength_and_hardening():
    """S_D = σ_zdADK/σ_a: σ_zdW K_1 K_V/(β_σ + 1/K_F − 1) less ψ σ_m; d_eff 40 mm, R_z 10 µm, K_V 1.2, β_σ 1.8."""
    notch = Concentration(2.2, 1.6)
    section = ShaftSection(0.030, 0.040, notch, hardening=1.2, tension_notch=1.8)
    size = 1.0 - 0.26 * math.log10(40.0 / 16.0)
    rough = 1.0 - 0.22 * (math.log10(size * 1000.0 / 20.0) - 1.0)
    limit = size * 420e6 / (1.8 + 1.0 / rough - 1.0) * 1.2
    area = PI / 4.0 * 0.030**2
    amplitude, mean = 50e3 / area, 20e3 / area
    held = limit - limit / (2.0 * size * 1000e6 - limit) * mean
    none = SectionLoad()
    found = din743_safety(none, section, STEEL, greatest=none, axial=AxialLoad(50e3, 20e3, 70e3))
    assert found.fatigue == near(held / amplitude, rel=1e-9)
    yields = 800e6 * (1.0 - 0.34 * math.log10(40.0 / 16.0)) * 1.1  # γ_F of β_σ = 2.2
    assert found.yielding == near(yields * area / 70e3, rel=1e-9)


def test_pins_bend_as_cantilevers_and_a_bore_keeps_the_section_modulus():
    """d³ = 16 F b/(π σ); κ⁴ = 1 − (20/25)³; never above 0.8; m = π/4 ρ b (d² − d_i²)."""
    diameter = pin_diameter(10e3, 0.030, 300e6)
    assert diameter == near((16.0 * 10e3 * 0.030 / (PI * 300e6)) ** (1.0 / 3.0))
    assert pin_stress(10e3, 0.030, diameter) == near(300e6)
    bore = pin_bore(0.025, 0.020)
    assert bore == near(0.025 * (1.0 - 0.8**3) ** 0.25 if (1.0 - 0.8**3) ** 0.25 < 0.8 else 0.020)
    assert pin_bore(0.025, 0.0235) == near(0.025 * (1.0 - 0.94**3) ** 0.25)
    assert pin_stress(10e3, 0.030, 0.025, bore=pin_bore(0.025, 0.0235)) == near(pin_stress(10e3, 0.030, 0.0235))
    assert pin_bore(0.025, 0.001) == near(0.8 * 0.025)
    assert pin_bore(0.020, 0.020) == 0.0
    assert pin_mass(0.025, 0.030, 7850.0, bore=0.010) == near(7850.0 * 0.030 * PI / 4.0 * (0.025**2 - 0.010**2))


def test_a_pull_adds_to_the_mean_of_bending_and_torsion():
    """σ_mv = √((σ_bm + σ_zdm)² + 3 τ_tm²) lowers σ_bADK = σ_bWK − ψ σ_mv; d 30/40 mm, β_σ 2.2, K_V 1."""
    section = ShaftSection(0.030, 0.040, Concentration(2.2, 1.6))
    size, inner = 1.0 - 0.26 * math.log10(40.0 / 16.0), 1.0 - 0.2 * math.log10(30.0 / 7.5) / math.log10(20.0)
    rough = 1.0 - 0.22 * (math.log10(size * 1000.0 / 20.0) - 1.0)
    limit = size * 500e6 / (2.2 / inner + 1.0 / rough - 1.0)
    resist, area = PI / 32.0 * 0.030**3, PI / 4.0 * 0.030**2
    mean = math.hypot(150.0 / resist + 40e3 / area, math.sqrt(3.0) * 200.0 / (2.0 * resist))
    held = limit - limit / (2.0 * size * 1000e6 - limit) * mean
    load = SectionLoad(bending_amplitude=100.0, bending_mean=150.0, torque_mean=200.0)
    found = din743_safety(load, section, STEEL, greatest=load, axial=AxialLoad(0.0, 40e3, 40e3))
    assert found.fatigue == near(held / (100.0 / resist), rel=1e-9)
