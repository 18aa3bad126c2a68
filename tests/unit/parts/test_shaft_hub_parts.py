"""Keys, splines, press fits, notches, fatigue, bending lines: closed forms, limits, refusals."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from gearwright.catalogue import key_for_shaft
from gearwright.errors import DesignError
from gearwright.parts.shaft_fatigue import (
    AxialLoad,
    Concentration,
    FatigueStrength,
    Overload,
    SectionLoad,
    ShaftSection,
    ShaftSteel,
    Shoulder,
    SteelGroup,
    asme_safety,
    blank_factor,
    din743_safety,
    endurance_limit,
    goodman_safety,
    section_stress,
    stress_concentration,
    yield_limits,
    yield_safety,
)
from gearwright.parts.shafts import (
    FitPart,
    KeySection,
    PointLoads,
    Sections,
    bearing_length,
    bent_line,
    centrifugal_loss,
    critical_speed,
    diagram,
    fit_interference,
    fit_pressure,
    fit_torque,
    hub_stress,
    influence,
    key_pressure,
    lumped_shaft,
    shaft_fit_stress,
    spline,
    spline_length,
    spline_pressure,
    supported,
)

STEEL = 210e9
KEY = KeySection(14e-3, 9e-3, 5.5e-3, 3.8e-3)


def test_a_key_longer_than_its_hub_is_refused():
    """And the hub's length is named."""
    with pytest.raises(DesignError, match="70 mm is longer than its hub; allowed: up to 60 mm"):
        bearing_length(KEY, 0.07, 0.06)
    with pytest.raises(DesignError, match="allowed: above 14 mm"):
        bearing_length(KEY, 0.014, 0.06)


def test_two_keys_bear_one_and_a_half_times_one():
    """DIN 6892, φ = 0.75."""
    one, two = (key_pressure(500.0, 0.05, KEY, bearing_length=0.056, keys=keys) for keys in (1, 2))
    assert one == pytest.approx(1.5 * two)
    with pytest.raises(DesignError, match="3 given; allowed: 1 or 2"):
        key_pressure(500.0, 0.05, KEY, bearing_length=0.056, keys=3)


@given(st.integers(20, 300), st.sampled_from([1.0, 1.25, 2.0, 3.0, 5.0]))
def test_spline_geometry_closes(diameter, module):
    """d_B = m (z + 2 x + 1.1), with the shift in range, wherever six teeth fit."""
    if diameter / module < 9.0:
        return
    joint = spline(diameter / 1e3, module / 1e3)
    assert joint.pitch_diameter + (2.0 * joint.profile_shift + 1.1) * joint.module == pytest.approx(diameter / 1e3)
    assert -0.051 <= joint.profile_shift <= 0.451
    assert joint.shaft_root < joint.hub_tip < joint.shaft_tip < joint.reference_diameter


def test_spline_pressure_undoes_length():
    """p of the length of p."""
    joint = spline(0.06, 0.002)
    length = spline_length(1000.0, joint, allowable=80e6)
    assert spline_pressure(1000.0, joint, length) == pytest.approx(80e6)


def test_splines_that_do_not_exist_are_refused():
    """With the nearest module, or the number of teeth."""
    with pytest.raises(DesignError, match=r"2.2 mm is not a module of DIN 5480; the nearest is 2 mm"):
        spline(0.05, 0.0022)
    with pytest.raises(DesignError, match="room for 4 teeth of 5 mm; 6 are needed"):
        spline(0.03, 0.005)


def test_a_shaft_that_no_key_is_made_for_is_refused_with_the_range():
    with pytest.raises(DesignError, match="300 mm given; DIN 6885-1 has keys above 6 to 230 mm"):
        key_for_shaft(0.3)


@given(st.floats(1.0, 1e3), st.floats(0.0, 1e3))
def test_a_bore_takes_safety_from_a_shaft(bending, torque):
    load, notch = SectionLoad(bending_amplitude=bending, torque_mean=torque), Concentration(1.7, 1.4)
    solid, hollow = (goodman_safety(section_stress(load, 0.05, notch, bore=bore), STRENGTH) for bore in (0.0, 0.03))
    assert hollow == pytest.approx(solid * (1.0 - 0.6**4), rel=1e-9)


def test_solid_shaft_and_hub_of_one_steel_follow_the_short_form():
    """Lamé for equal materials and a solid shaft: p = U E (1 − Q²)/(2 d)."""
    pressure = fit_pressure(50e-6, 0.05, FitPart(0.0, STEEL), FitPart(0.5, STEEL))
    assert pressure == pytest.approx(50e-6 * STEEL * (1.0 - 0.25) / (2.0 * 0.05))


def test_fit_undoes_itself_and_roughness_takes_its_share():
    """U of p of U; 0.8 of both R_z is lost."""
    shaft, hub = FitPart(0.3, STEEL, roughness=4e-6), FitPart(0.6, STEEL, roughness=6e-6)
    pressure = fit_pressure(60e-6, 0.05, shaft, hub)
    assert fit_interference(pressure, 0.05, shaft, hub) == pytest.approx(60e-6)
    assert fit_interference(0.0, 0.05, shaft, hub) == pytest.approx(8e-6)
    assert fit_torque(pressure, 0.05, 0.04, friction=0.14) == pytest.approx(
        0.025 * math.pi * 0.05 * 0.04 * 0.14 * pressure
    )
    assert hub_stress(pressure, hub) > shaft_fit_stress(pressure, FitPart(0.0, STEEL)) == pressure
    assert shaft_fit_stress(pressure, shaft) == pytest.approx(2.0 * pressure / 0.91)


def test_loose_fits_and_parts_without_walls_are_refused():
    """With what would hold."""
    rough = FitPart(0.0, STEEL, roughness=6e-6)
    with pytest.raises(DesignError, match=r"-5 µm given; the fit holds above 9.6 µm"):
        fit_pressure(-5e-6, 0.05, rough, FitPart(0.5, STEEL, roughness=6e-6))
    with pytest.raises(DesignError, match="1 given; allowed: 0 to below 1"):
        FitPart(1.0, STEEL)


@given(st.floats(0.05, 1.0), st.floats(1.05, 2.0))
def test_sharper_shoulders_raise_more(share, ratio):
    """A smaller fillet never lowers stress, and bending feels it more than torsion."""
    step = 0.04 * (ratio - 1.0) / 2.0
    sharp, round_one = (
        stress_concentration(Shoulder(0.04, 0.04 * ratio, factor * share * step)) for factor in (0.9, 1.0)
    )
    assert sharp.bending > round_one.bending > 1.0
    assert sharp.bending > sharp.torsion


@pytest.mark.parametrize(
    ("shoulder", "message"),
    [
        (Shoulder(0.05, 0.04, 0.001), "40 mm is not above the smaller diameter, 50 mm"),
        (Shoulder(0.04, 0.05, 0.0001), "0.1 mm given; the formulas hold from 0.15 mm on"),
        (Shoulder(0.04, 0.05, 0.0), "0 mm given"),
    ],
)
def test_shoulders_that_cannot_be_made_are_refused(shoulder, message):
    """With the range."""
    with pytest.raises(DesignError, match=message):
        stress_concentration(shoulder)


STRENGTH = FatigueStrength(200e6, 700e6, 500e6)


def test_without_mean_stress_goodman_and_asme_agree():
    """Both are S_e/σ_a then."""
    stress = section_stress(SectionLoad(bending_amplitude=500.0), 0.04)
    assert goodman_safety(stress, STRENGTH) == pytest.approx(asme_safety(stress, STRENGTH))


def test_a_shaft_without_load_is_safe_without_end():
    """And not a division by zero."""
    stress = section_stress(SectionLoad(), 0.04)
    assert (
        goodman_safety(stress, STRENGTH) == asme_safety(stress, STRENGTH) == yield_safety(stress, STRENGTH) == math.inf
    )


def test_unknown_surface_and_reliability_are_both_named():
    """All problems at once."""
    with pytest.raises(DesignError) as caught:
        endurance_limit(700e6, 0.5, surface="polished", reliability=0.97)
    assert [problem.path for problem in caught.value.problems] == ["surface", "reliability", "diameter"]


STEEL_42CRMO4 = ShaftSteel(1100e6, 900e6, 550e6, 330e6, SteelGroup.TEMPERED)
"""42CrMo4+QT at d_B = 16 mm (DIN 743-3)."""
SECTION = ShaftSection(0.040, 0.050, Concentration(1.8, 1.4))


def test_din_743_pure_bending_is_strength_over_stress():
    """Fatigue: σ_bW K_1/K over M/W; K = (β/K_2 + 1/K_F − 1). Written out."""
    load = SectionLoad(bending_amplitude=800.0)
    safety = din743_safety(load, SECTION, STEEL_42CRMO4, greatest=load)
    size = 1.0 - 0.26 * math.log10(50.0 / 16.0)
    rough = 1.0 - 0.22 * (math.log10(1100.0 * size / 20.0) - 1.0)
    total = 1.8 / (1.0 - 0.2 * math.log10(40.0 / 7.5) / math.log10(20.0)) + 1.0 / rough - 1.0
    stress = 800.0 / (math.pi / 32.0 * 0.04**3)
    assert safety.fatigue == pytest.approx(550e6 * size / total / stress)
    assert safety.yielding == pytest.approx(900e6 * (1.0 - 0.34 * math.log10(50.0 / 16.0)) * 1.2 * 1.05 / stress)


def test_din_743_mean_torque_lowers_fatigue_safety():
    """And hardening raises it."""
    bent, twisted = SectionLoad(bending_amplitude=800.0), SectionLoad(bending_amplitude=800.0, torque_mean=2000.0)
    plain = din743_safety(bent, SECTION, STEEL_42CRMO4, greatest=twisted)
    mean = din743_safety(twisted, SECTION, STEEL_42CRMO4, greatest=twisted)
    hard = din743_safety(twisted, SECTION._replace(hardening=1.2), STEEL_42CRMO4, greatest=twisted)
    assert mean.fatigue < plain.fatigue
    assert hard.fatigue > mean.fatigue
    assert mean.yielding == plain.yielding


def test_din_743_yield_limits_of_hollow_and_hard_sections():
    """K_2F: 1.2 full, 1.1 and 1.0 hollow, 1.0 with a hard surface; γ_F: 1 for a mild notch, 1.15 for a sharp one."""
    mild, sharp = SECTION._replace(notch=Concentration(1.2, 1.1)), SECTION._replace(notch=Concentration(3.5, 2.0))
    full = yield_limits(mild, STEEL_42CRMO4)
    hollow = yield_limits(mild._replace(bore=0.02), STEEL_42CRMO4)
    hard = STEEL_42CRMO4._replace(group=SteelGroup.CASE_HARDENED)
    assert hollow == pytest.approx((full.bending * 1.1 / 1.2, full.torsion / 1.2))
    assert yield_limits(mild, hard).bending == pytest.approx(math.sqrt(3.0) * yield_limits(mild, hard).torsion)
    assert yield_limits(sharp, STEEL_42CRMO4) == pytest.approx((1.15 * full.bending, full.torsion))


def test_din_743_at_a_constant_ratio_of_mean_to_amplitude():
    """Case 2: σ_ADK = min(σ_WK/(1 + ψ σ_m/σ_a), σ_FK/(1 + σ_m/σ_a)); twice the load is half as safe."""
    load, case_2 = SectionLoad(bending_amplitude=800.0, bending_mean=500.0), Overload.CONSTANT_RATIO
    double = SectionLoad(bending_amplitude=1600.0, bending_mean=1000.0)
    once, twice = (din743_safety(grown, SECTION, STEEL_42CRMO4, greatest=grown, overload=case_2).fatigue
                   for grown in (load, double))  # fmt: skip
    assert once == pytest.approx(2.0 * twice)
    reversed_ = SectionLoad(bending_amplitude=800.0)
    plain = din743_safety(reversed_, SECTION, STEEL_42CRMO4, greatest=load).fatigue
    limit = plain * 800.0
    ultimate = math.pi / 32.0 * 0.04**3 * 1100e6 * blank_factor(0.050, SteelGroup.TEMPERED, yielding=False)
    assert once == pytest.approx(plain / (1.0 + limit / (2.0 * ultimate - limit) * 500.0 / 800.0))
    # What does not alternate uses up nothing, whatever its mean.
    twisted = reversed_._replace(torque_mean=1e5)
    with pytest.raises(DesignError, match="leaves no fatigue strength"):
        din743_safety(twisted, SECTION, STEEL_42CRMO4, greatest=load)
    steady = SectionLoad(torque_mean=1e5)
    assert din743_safety(steady, SECTION, STEEL_42CRMO4, greatest=load, overload=case_2).fatigue == math.inf


def test_a_hard_surface_has_no_roughness_and_no_support():
    """K_F = 1: S_D is that of R_z 1 µm; K_2F = γ_F = 1 where the soft solid section has 1.2 and 1.05."""
    load = SectionLoad(bending_amplitude=800.0)
    hard = SECTION._replace(hard_surface=True, roughness=25e-6)
    smooth = din743_safety(load, SECTION._replace(roughness=1e-6), STEEL_42CRMO4, greatest=load)
    made = din743_safety(load, hard, STEEL_42CRMO4, greatest=load)
    assert made.fatigue == pytest.approx(smooth.fatigue)
    assert smooth.yielding == pytest.approx(1.2 * 1.05 * made.yielding)


def test_din_743_refuses_a_mean_stress_beyond_strength():
    """Nothing is left for the amplitude."""
    load = SectionLoad(bending_amplitude=1.0, bending_mean=3e4)
    with pytest.raises(DesignError, match="leaves no fatigue strength; take a larger diameter"):
        din743_safety(load, SECTION, STEEL_42CRMO4, greatest=load)


@pytest.mark.parametrize("group", SteelGroup)
@pytest.mark.parametrize("yielding", [True, False])
def test_larger_blanks_are_weaker_within_the_range(group, yielding):
    """1 up to the reference, falling, and constant beyond the end."""
    factors = [blank_factor(size, group, yielding=yielding) for size in (0.005, 0.12, 0.14, 0.3, 0.5)]
    assert factors[0] == 1.0
    assert factors[0] > factors[1] > factors[2] >= factors[3] == factors[4] > 0.4


def plain_shaft(diameter, length):
    """Return a solid shaft of one diameter."""
    return Sections(np.array([0.0, length]), np.array([diameter]), np.zeros(1))


def at_place(line, position):
    """Return deflection and slope at a station of a bent line."""
    place = np.flatnonzero(np.abs(line.position - position) < 1e-9).item()
    return line.deflection[..., place], line.slope[..., place]


def bent(force, places, seats, shaft):
    """Return the bent line of a shaft under forces in one plane."""
    places = np.asarray(places, dtype=float)
    none = np.zeros((1, len(places)))
    loads = PointLoads(places, np.asarray([force], dtype=float), none, none)
    whole = supported(loads, seats, length=float(shaft.edges[-1]))
    return bent_line(diagram(whole), shaft, seats, elastic_modulus=STEEL)


def test_load_in_the_middle_and_overhung():
    """F L³/(48 E I) down with slopes F L²/(16 E I); and F a² (L + a)/(3 E I) at an overhung end."""
    shaft, rigidity = plain_shaft(0.03, 0.8), STEEL * math.pi / 64.0 * 0.03**4
    middle = bent([-1000.0], [0.3], [0.0, 0.6], shaft)
    assert at_place(middle, 0.3)[0] == pytest.approx([-1000.0 * 0.6**3 / (48.0 * rigidity)])
    assert at_place(middle, 0.0)[1] == pytest.approx([-1000.0 * 0.6**2 / (16.0 * rigidity)])
    assert at_place(middle, 0.6)[1] == pytest.approx([1000.0 * 0.6**2 / (16.0 * rigidity)])
    front = bent([-1000.0], [0.0], [0.2, 0.8], shaft)
    assert at_place(front, 0.0)[0] == pytest.approx([-1000.0 * 0.2**2 * 0.8 / (3.0 * rigidity)])
    end = bent([-1000.0], [0.8], [0.0, 0.6], shaft)
    assert at_place(end, 0.8)[0] == pytest.approx([-1000.0 * 0.2**2 * 0.8 / (3.0 * rigidity)])


def test_steps_of_one_diameter_change_nothing_and_thicker_ones_stiffen():
    """Edges alone do not bend a shaft."""
    plain = plain_shaft(0.03, 0.6)
    cut = Sections(np.array([0.0, 0.11, 0.4, 0.6]), np.full(3, 0.03), np.zeros(3))
    thick = Sections(cut.edges, np.array([0.03, 0.06, 0.03]), np.zeros(3))
    deep = [at_place(bent([-1000.0], [0.25], [0.0, 0.6], shaft), 0.25)[0][0] for shaft in (plain, cut, thick)]
    assert deep[1] == pytest.approx(deep[0])
    assert deep[0] < deep[2] < 0.0


@given(st.lists(st.floats(0.02, 0.78), min_size=2, max_size=4, unique_by=lambda x: round(x, 3)))
def test_influence_is_symmetric_and_bounds_hold(places):
    """Maxwell; Dunkerley ≤ exact ≤ Rayleigh."""
    shaft = Sections(np.array([0.0, 0.3, 0.8]), np.array([0.03, 0.04]), np.array([0.0, 0.02]))
    found = influence(shaft, [0.0, 0.8], places, elastic_modulus=STEEL)
    assert found == pytest.approx(found.T, rel=1e-6)
    masses = np.arange(1.0, len(places) + 1.0)
    exact = critical_speed(found, masses)
    sagging = found @ masses
    dunkerley, rayleigh = masses @ np.diag(found), masses @ sagging**2 / (masses @ sagging)
    assert dunkerley**-0.5 <= exact * (1.0 + 1e-9)
    assert exact <= rayleigh**-0.5 * (1.0 + 1e-9)


def test_own_mass_of_a_plain_shaft_reaches_the_closed_form():
    """ω = (π/L)² √(E I/(ρ A)); 40 lumps come within 0.1 %."""
    shaft = plain_shaft(0.03, 0.6)
    places, masses = lumped_shaft(shaft, 7850.0)
    found = critical_speed(influence(shaft, [0.0, 0.6], places, elastic_modulus=STEEL), masses)
    assert found == pytest.approx((math.pi / 0.6) ** 2 * 0.03 / 4.0 * math.sqrt(STEEL / 7850.0), rel=1e-3)
    assert masses.sum() == pytest.approx(7850.0 * math.pi / 4.0 * 0.03**2 * 0.6)


def test_loads_outside_the_shaft_are_refused():
    """With its ends."""
    drawn = diagram(
        supported(
            PointLoads(np.array([0.5]), np.array([[1.0]]), np.zeros((1, 1)), np.zeros((1, 1))), [0.0, 1.0], length=1.0
        )
    )
    with pytest.raises(DesignError, match="1000 mm is outside the shaft; allowed: 0 to 600 mm"):
        bent_line(drawn, plain_shaft(0.03, 0.6), [0.0, 1.0], elastic_modulus=STEEL)
    with pytest.raises(DesignError, match="rests on two bearings at two places"):
        bent_line(drawn, plain_shaft(0.03, 1.0), [0.5, 0.5], elastic_modulus=STEEL)
    with pytest.raises(DesignError, match=r"masses: .* some are above"):
        critical_speed(np.eye(2), [0.0, 0.0])


def test_din_743_at_a_constant_ratio_yields_where_mean_and_amplitude_together_do():
    """σ_ADK = σ_FK/(1 + σ_m/σ_a) where a great mean makes that the lesser: S (σ_a + σ_m) is the yield limit."""
    load = SectionLoad(bending_amplitude=100.0, bending_mean=3000.0)
    safety = din743_safety(load, SECTION, STEEL_42CRMO4, greatest=load, overload=Overload.CONSTANT_RATIO).fatigue
    resist = math.pi / 32.0 * SECTION.diameter**3
    assert safety * (100.0 + 3000.0) / resist == pytest.approx(yield_limits(SECTION, STEEL_42CRMO4).bending)


TURNED = ShaftSteel(1100e6, 900e6, 550e6, 330e6, SteelGroup.TEMPERED)
CUT = ShaftSection(0.042, 0.05, Concentration(1.5286, 1.2674), bore=0.012)


def test_a_pulsating_pull_adds_to_bending_as_din_743_writes_it():
    """1/S_D² = (σ_zda/σ_zdADK + σ_ba/σ_bADK)² + (τ/τ_tADK)², case 1 by hand: d 42/12, 40 ± 30 kN, R_z 10 µm."""
    area, resist = math.pi / 4 * (42**2 - 12**2), math.pi / 32 * 42**3 * (1 - (12 / 42) ** 4)
    size = 1 - 0.26 * math.log10(50 / 16)
    yields = 900 * (1 - 0.34 * math.log10(50 / 16)) * 1.05
    rough = 1 - 0.22 * (math.log10(size * 1100 / 20) - 1)
    mean = 40e3 / area
    tension = size * 0.8 * 550 / (1.5286 + 1 / rough - 1)
    inner = 1 - 0.2 * math.log10(42 / 7.5) / math.log10(20)
    bending = size * 550 / (1.5286 / inner + 1 / rough - 1)
    parts = []
    for limit, reach in ((tension, yields), (bending, 1.1 * yields)):
        parts.append(min(limit - limit / (2 * size * 1100 - limit) * mean, reach - mean))
    by_hand = 30e3 / area / parts[0] + 600e3 / resist / parts[1]
    load = SectionLoad(bending_amplitude=600.0)
    found = din743_safety(load, CUT, TURNED, greatest=load, axial=AxialLoad(30e3, 40e3, 70e3))
    assert found.fatigue == pytest.approx(1 / by_hand, rel=1e-9)
    assert found.yielding == pytest.approx(1 / (70e3 / area / yields + 600e3 / resist / (1.1 * yields)), rel=1e-9)


def test_without_a_force_along_it_a_section_is_what_it_was_and_a_pull_never_helps():
    load = SectionLoad(bending_amplitude=600.0, torque_mean=900.0)
    plain = din743_safety(load, CUT, TURNED, greatest=load)
    assert din743_safety(load, CUT, TURNED, greatest=load, axial=AxialLoad()) == plain
    for overload in Overload:
        free = din743_safety(load, CUT, TURNED, greatest=load, overload=overload).fatigue
        pulls = [AxialLoad(mean=40e3), AxialLoad(amplitude=40e3), AxialLoad(mean=-40e3)]
        held = [din743_safety(load, CUT, TURNED, greatest=load, overload=overload, axial=pull) for pull in pulls]
        assert all(safety.fatigue < free for safety in held)
        assert held[0] == held[2]


def test_a_press_fit_loosens_at_the_speed_of_din_7190():
    """n_ab = 2/(π D) √(2 p/((3 + ν)(1 − Q²) ρ)) of a hub on a solid shaft of one steel; p(n)/p = 1 − (n/n_ab)²."""
    shaft, hub = FitPart(0.0, 206e9), FitPart(0.5, 206e9)
    diameter, overlap = 0.06, 60e-6
    still = fit_pressure(overlap, diameter, shaft, hub)
    outer = diameter / 0.5
    loose = 2 / (math.pi * outer) * math.sqrt(2 * still / (3.3 * (1 - 0.25) * 7850)) * 2 * math.pi
    assert centrifugal_loss(loose, diameter, shaft, hub) == pytest.approx(overlap)
    for part in (0.2, 0.7):
        left = overlap - centrifugal_loss(part * loose, diameter, shaft, hub)
        assert fit_pressure(left, diameter, shaft, hub) == pytest.approx(still * (1 - part**2))


def test_a_hollow_shaft_follows_its_hub_more_than_a_solid_one():
    """A bore in the shaft widens it: (3 + ν)(1/Q_a² − Q_i²) of equal steels."""
    hub = FitPart(0.5, 206e9)
    solid, hollow = (centrifugal_loss(2000.0, 0.06, FitPart(bore, 206e9), hub) for bore in (0.0, 0.6))
    assert hollow / solid == pytest.approx((4.0 - 0.36) / 4.0)
    assert centrifugal_loss(0.0, 0.06, FitPart(0.0, 206e9), hub) == 0.0
