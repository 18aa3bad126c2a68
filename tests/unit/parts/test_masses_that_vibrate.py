"""What a mesh moves, where it resounds, and what tip relief leaves of it: closed forms, limits and joints."""

import math
from statistics import NormalDist

import numpy as np
import pytest

from gearwright.parts.iso6336 import (
    SOLID,
    GearSteel,
    MeshDeviations,
    MeshDuty,
    MeshGeometry,
    MeshQuality,
    MeshSprings,
    MovingBody,
    Neighbour,
    ReliefRule,
    TipRelief,
    Treatment,
    dynamic_factor,
    idler_masses,
    mesh_springs,
    moving_mass,
    rate_mesh,
    reduced_mass,
    relief_for,
    relief_term,
    resonance_begins,
    running_in_relief,
    usual_class,
)
from gearwright.parts.iso6336.loads import load_deflection
from gearwright.parts.planetary import clocking_load_factor, path_stiffness, tolerance_load_factor

SUN = MeshGeometry((20, 60), 3e-3, 30e-3, 120e-3, (33e-3, 93e-3))
RING = MeshGeometry((40, -100), 3e-3, 30e-3, 90e-3, (63e-3, 147e-3))
STEEL = 7830.0
HARD = GearSteel("hard", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 461e6)
SPRINGS = MeshSprings(14e9, 20e9, 17e9)


def near(value):
    return pytest.approx(value, rel=1e-12)


def mass_by_hand(tip, root, base, inside=0.0):
    """J/r_b² of a disc of the mean diameter with a bore, per width; of a ring inside is its outer diameter."""
    mean = (tip + root) / 2.0
    inertia = math.pi / 32.0 * STEEL * abs(mean**4 - inside**4)
    return inertia / (0.5 * base) ** 2


def alone(mesh, gear, inside=None):
    return float(moving_mass(mesh, gear, STEEL, MovingBody(inside)))


def test_a_gear_moves_by_its_inertia_over_the_square_of_its_base_radius():
    """ISO 6336-1:2006, clause 6.5.9: 20 teeth of 3 mm, d_a 66, d_f 52.5; a ring of 100, d_a 294, d_f 307.5, d_e 340."""
    base = 60e-3 * math.cos(math.radians(20.0))
    assert alone(SUN, 0) == near(mass_by_hand(66e-3, 52.5e-3, base))
    assert alone(SUN, 0, 30e-3) == near(mass_by_hand(66e-3, 52.5e-3, base, 30e-3))
    wall = mass_by_hand(294e-3, 307.5e-3, 300e-3 * math.cos(math.radians(20.0)), 340e-3)
    assert alone(RING, 1, 340e-3) == near(wall)


@pytest.mark.parametrize("planets", [1.0, 2.0, 3.0, 5.0, 7.0])
def test_a_sun_with_p_planets_moves_like_a_p_th_of_its_mass(planets):
    """m_s m_p/(m_s + p m_p), of p = 1 the pair: ISO 6336-1:2006, clause 6.5.9."""
    sun, planet = alone(SUN, 0), alone(SUN, 1)
    found = reduced_mass(SUN, (STEEL, STEEL), (MovingBody(meshes=planets), SOLID))
    assert found == near(sun * planet / (sun + planets * planet))
    if planets == 1.0:
        assert found == near(reduced_mass(SUN, (STEEL, STEEL)))


@pytest.mark.parametrize("planets", [3.0, 5.0])
def test_a_ring_that_grows_heavy_leaves_the_planet_alone_as_does_one_that_is_held(planets):
    """m_p m_r/(m_r + p m_p) → m_p with m_r → ∞; a held ring moves not at all."""
    planet, ring = alone(RING, 0), alone(RING, 1, 340e-3)
    turning = reduced_mass(RING, (STEEL, STEEL), (SOLID, MovingBody(340e-3, planets)))
    assert turning == near(planet * ring / (ring + planets * planet))
    heavy = reduced_mass(RING, (STEEL, 1e12 * STEEL), (SOLID, MovingBody(340e-3, planets)))
    held = reduced_mass(RING, (STEEL, STEEL), (SOLID, MovingBody(340e-3, planets, held=True)))
    assert heavy == pytest.approx(planet, rel=1e-9)
    assert held == near(planet)
    assert turning < held


def test_a_standing_sun_leaves_the_planet_alone():
    found = reduced_mass(SUN, (STEEL, STEEL), (MovingBody(meshes=3.0, held=True), SOLID))
    assert found == near(alone(SUN, 1))


def test_two_equal_masses_on_a_wall_vibrate_at_their_closed_frequencies():
    """ω² = (3 ± √5)/2 c/m: 0.3820 and 2.6180."""
    slow, fast = idler_masses(1.0 / 2.5, 1.0 / 2.5, 0.0)
    assert (2.5 / slow, 2.5 / fast) == (near((3.0 - math.sqrt(5.0)) / 2.0), near((3.0 + math.sqrt(5.0)) / 2.0))
    assert (round(2.5 / float(slow), 4), round(2.5 / float(fast), 4)) == (0.3820, 2.6180)


def test_the_vibrations_of_an_idler_are_the_roots_of_three_masses_in_a_row():
    """Stiffness over mass of 1 – 2 – 3 with two equal springs, by eigenvalues; one of the three is rigid motion."""
    masses = np.array([0.7, 1.9, 1.1])
    sides = np.array([[1.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 1.0]])
    squares = np.sort(np.linalg.eigvals(sides / masses[:, None]).real)
    found = [1.0 / float(mass) for mass in idler_masses(*(1.0 / masses))]
    assert squares[0] == pytest.approx(0.0, abs=1e-12)
    assert found == pytest.approx(list(squares[1:]), rel=1e-12)


def test_a_mesh_with_an_idler_vibrates_with_one_of_the_two_masses_of_three_gears_in_a_row():
    """20, 60 and 20 teeth of one module: N by c_γα over either mass, another than that of the pair alone."""
    duty = MeshDuty(300.0, 900.0, 4e6)
    quality = MeshQuality(4, beyond=(None, Neighbour(20, STEEL)))
    found = rate_mesh(SUN, (HARD, HARD), duty, quality=quality).dynamic
    own = [1.0 / float(moving_mass(SUN, gear, STEEL)) for gear in (0, 1)]
    both = [float(mass) for mass in idler_masses(own[0], own[1], own[0])]
    springs = mesh_springs(SUN, 300.0 / 30e-3 / 30e-3)
    ratios = [900.0 * 20 / math.sqrt(float(springs.mesh) / mass) for mass in both]
    alone_each = [
        dynamic_factor(
            SUN, springs, MeshDeviations(0.0, 0.0, 0.0), specific_load=300.0 / 30e-3 / 30e-3, pinion_speed=900.0,
            masses=(mass,),
        ).resonance_ratio
        for mass in both
    ]  # fmt: skip
    assert alone_each == [near(ratio) for ratio in ratios]
    assert float(found.reduced_mass) in [near(mass) for mass in both]
    pair = rate_mesh(SUN, (HARD, HARD), duty, quality=MeshQuality(4)).dynamic
    assert found.resonance_ratio != pytest.approx(pair.resonance_ratio, rel=1e-3)


def test_of_two_vibrations_the_larger_factor_counts_in_every_place_of_an_array():
    """One mass in resonance, one far above it: the first gives the larger K_V; with both far below, the heavier."""
    resonant = 20e9 / (20 * 700.0) ** 2
    speeds = np.array([700.0, 70.0])
    args = (SUN, SPRINGS, MeshDeviations(6e-6, 9e-6))
    both = dynamic_factor(*args, specific_load=3e5, pinion_speed=speeds, masses=(resonant, 9.0 * resonant))
    each = [
        dynamic_factor(*args, specific_load=3e5, pinion_speed=speeds, masses=(mass,)).factor
        for mass in (resonant, 9.0 * resonant)
    ]
    assert each[0][0] > each[1][0] and each[0][1] < each[1][1]
    assert list(both.factor) == [each[0][0], each[1][1]]
    assert list(both.reduced_mass) == [near(resonant), near(9.0 * resonant)]


@pytest.mark.parametrize(("load", "begins"), [(1e6, 0.85), (100e3, 0.85), (25e3, 0.675), (9e3, 0.605), (0.0, 0.5)])
def test_the_main_resonance_begins_earlier_under_light_loads(load, begins):
    """N_S = 0.5 + 0.35 √(w/100 N/mm), 0.85 from 100 N/mm on: ISO 6336-1:2019, clause 6.5.3."""
    assert resonance_begins(load) == near(begins)


def test_relief_of_a_class_5_spur_pair_at_500_n_per_mm_is_35_micrometres():
    """C_eff = 500/14 = 35.7 µm, rounded down; 5 mm module would allow 100 µm; ±15 % of 35 are 5.25 µm."""
    spur = MeshGeometry((20, 60), 5e-3, 20e-3, 0.2, (0.055, 0.155))
    deflection = load_deflection(spur, SPRINGS, 500e3, 500e3)
    made = relief_for(deflection, 5e-3, 2e-6)
    assert deflection == near(500e3 / 14e9)
    assert (made.amount, made.tolerance) == (near(35e-6), near(5.25e-6))


def test_relief_is_capped_by_the_module_and_never_below_running_in():
    """0.02 m_n of 1 mm are 20 µm; a deflection of 0.8 µm leaves the 2 µm of running in, ±3 µm."""
    assert relief_for(35.7e-6, 1e-3, 2e-6).amount == near(20e-6)
    small = relief_for(0.8e-6, 1e-3, 2e-6)
    assert (small.amount, small.tolerance) == (2e-6, 3e-6)


def test_leaning_teeth_with_an_overlap_are_relieved_for_the_stiffness_of_the_mesh():
    """ISO/TS 6336-20: c_γα of ε_β ≥ 1, c′ of spur gears; half the load below 100 N/mm has teeth softer by ½^¼."""
    wide = MeshGeometry((20, 60), 2e-3, 40e-3, 0.083, (0.023, 0.064), math.radians(15.0))
    assert wide.overlap_ratio > 1.0
    assert load_deflection(wide, SPRINGS, 4e5, 2e5) == near(2e5 / 20e9)
    assert load_deflection(SUN, SPRINGS, 4e5, 50e3) == near(50e3 / (14e9 * 0.5**0.25))


@pytest.mark.parametrize(("strength", "relief"), [(1500e6, 2.00e-6), (1789.65e6, 1.5e-6)])
def test_running_in_leaves_the_printed_relief(strength, relief):
    """(σ_Hlim/97 − 18.45)²/18 + 1.5 µm: a report prints 2.00 µm at 1500 MPa; 97 · 18.45 has 1.5 µm."""
    steel = GearSteel("hard", Treatment.CASE_HARDENED, "MQ", 700.0, strength, 461e6)
    assert running_in_relief((steel, steel)) == pytest.approx(relief, abs=0.005e-6)


def test_running_in_of_two_steels_is_the_mean_of_both():
    soft = GearSteel("soft", Treatment.THROUGH_HARDENED, "MQ", 300.0, 700e6, 310e6)
    own = 1e-6 * ((700.0 / 97.0 - 18.45) ** 2 / 18.0 + 1.5)
    assert running_in_relief((HARD, soft)) == near(0.5 * (running_in_relief((HARD, HARD)) + own))
    assert 8.4e-6 < own < 8.6e-6  # printed: 8.50 µm


def test_what_relief_leaves_is_that_of_each_load_at_the_worse_end_of_its_tolerance():
    """|1 − C_a/C_eff| + ΔC/C_eff: none at its own load but the tolerance, four times at a fifth of it."""
    sharp = TipRelief(30e-6, 30e-6, stiffness=14e9)
    own = 14e9 * 30e-6
    assert relief_term(sharp, own, grade=5) == pytest.approx(0.0, abs=1e-15)
    assert relief_term(sharp, own / 5.0, grade=5) == near(4.0)
    assert relief_term(sharp, 3.0 * own, grade=5) == near(2.0 / 3.0)
    usual = TipRelief(30e-6, 30e-6, 4.5e-6, 14e9)
    assert relief_term(usual, own, grade=5) == near(0.15)
    assert relief_term(TipRelief(0.0, 30e-6, stiffness=14e9), own, grade=5) == 1.0


def test_a_stated_tight_tolerance_leaves_a_tenth_and_a_coarse_class_leaves_all():
    own = 14e9 * 30e-6
    tight = TipRelief(30e-6, 30e-6, 0.5e-6, 14e9, stated=True)
    assert relief_term(tight, own, grade=5) == 0.1
    assert relief_term(tight, own, grade=6) == relief_term(tight, own, grade=8) == 1.0
    assert list(relief_term(tight, np.array([own, own]), grade=np.array([5.0, 6.0]))) == [0.1, 1.0]


@pytest.mark.parametrize(("speed", "own"), [(80.0, 4), (60.0, 5), (60.1, 4), (15.0, 5), (14.9, 6), (0.0, 6)])
def test_the_usual_class_is_by_speed(speed, own):
    """Above 60 m/s 4, from 15 m/s on 5, below 6."""
    assert usual_class(speed) == own


def test_a_mesh_without_a_stated_class_or_relief_takes_those_of_its_greatest_speed_and_worst_load():
    """v = 0.03 m · 900/s = 27 m/s: class 5, 4 where it once runs at 90 m/s; relief of the load that wears."""
    quality = MeshQuality(None, tip_relief=None)

    def rated(**told):
        return rate_mesh(SUN, (HARD, HARD), MeshDuty(300.0, 900.0, 4e6, **told), quality=quality)

    one, fast, half = rated(), rated(fastest=3000.0), rated(relief_torque=150.0)
    assert (one.grade, fast.grade, half.grade) == (5.0, 4.0, 5.0)
    load = 300.0 / 30e-3 / 30e-3
    single = float(mesh_springs(SUN, load).single)
    assert one.relief.deflection == near(load / single)
    assert one.relief.amount == near(1e-6 * math.floor(1e6 * load / single))
    assert half.relief.deflection == near(0.5 * load / single)
    assert half.dynamic.relief_term > one.dynamic.relief_term


def test_no_relief_stands_only_where_zero_is_written():
    """0 is 0; left out it is made for the load, or what running in leaves."""
    duty = MeshDuty(300.0, 900.0, 4e6)

    def amount(**told):
        return rate_mesh(SUN, (HARD, HARD), duty, quality=MeshQuality(5, **told)).relief.amount

    assert amount(tip_relief=0.0) == 0.0
    assert amount(tip_relief=None, relief_rule=ReliefRule.RUN_IN) == near(running_in_relief((HARD, HARD)))
    assert amount(tip_relief=None) > running_in_relief((HARD, HARD))
    faint = rate_mesh(SUN, (HARD, HARD), MeshDuty(1.0, 900.0, 4e6), quality=MeshQuality(5, tip_relief=None))
    assert faint.relief.deflection < faint.relief.amount == near(running_in_relief((HARD, HARD)))


def test_a_blank_factor_softens_every_stiffness_alike():
    """C_R of webbed gears: ISO 6336-1, clause 9; printed 0.862 of a set, 0.898 of a pair."""
    solid, webbed = mesh_springs(SUN, 4e5), mesh_springs(SUN, 4e5, blank=0.862)
    for value in ("single", "mesh", "face"):
        assert getattr(webbed, value) == near(0.862 * getattr(solid, value))


@pytest.mark.parametrize("planets", [4, 5, 6, 7, 8, 9])
def test_99_of_100_sets_share_better_than_their_tolerances_say(planets):
    """Random pins, of which a floating sun takes up the mean and both shifts: 57 mm, 20 N/(mm µm), 28.5 kN, 18 µm."""
    stiffness = path_stiffness(20e9, 57e-3, bearing=1e9, pressure_angle=math.radians(20.0))
    meshes = 20e9 * 57e-3 * math.cos(math.radians(20.0)) ** 2
    assert stiffness == near(1.0 / (1.0 / meshes + 2.0 / 1e9))
    found = tolerance_load_factor(planets, 18e-6, 28.5e3, stiffness=stiffness, floating=True)
    places = np.random.default_rng(1).normal(0.0, 18e-6, (200_000, planets))
    angles = 2.0 * np.pi * np.arange(planets) / planets
    free, _ = np.linalg.qr(np.column_stack([np.ones(planets), np.cos(angles), np.sin(angles)]))
    left = places - (places @ free) @ free.T
    drawn = 1.0 + np.quantile(left.max(axis=1), 0.99) * stiffness / 28.5e3
    assert -0.003 < found - drawn < 0.03


def test_five_pins_of_ten_micrometres_share_as_level_3_of_agma_6123_has_it():
    """1.19, within 0.03."""
    assert tolerance_load_factor(5, 10e-6, 28.5e3, stiffness=334e6, floating=True) == pytest.approx(1.19, abs=0.03)


def test_three_planets_around_a_floating_sun_share_whatever_their_tolerances():
    held, free = (tolerance_load_factor(3, 2e-5, 2e4, stiffness=3e8, floating=float_) for float_ in (False, True))
    assert free == 1.0
    assert held == near(1.0 + NormalDist().inv_cdf(1.0 - 0.01 / 3.0) * math.sqrt(2.0 / 3.0) * 0.3)


def test_clocking_counts_less_the_more_torque_comes_in():
    """53 % in one of two paths within 0.8 mrad at 367 N m (Krantz & Delgado 1996): 1.06; a tenth of it at 3670 N m."""
    assert clocking_load_factor(0.8e-3, 367.0) == near(1.06)
    assert clocking_load_factor(0.8e-3, 3670.0) == near(1.006)


ROWS = [tuple(row) for row in np.random.default_rng(6336).uniform(0.05, 20.0, (12, 3)).tolist()]
"""1/m* of three gears in a row at random [m/kg]."""


@pytest.mark.parametrize(("first", "idler", "last"), ROWS)
def test_three_gears_in_a_row_vibrate_alike_from_both_ends_and_a_far_gear_of_no_mass_leaves_the_pair(
    first, idler, last
):
    """ω² of both lie around those of either pair alone: 1/m_1 + 1/m_2 ≤ ω²/c, and no slower than both masses apart."""
    slow, fast = idler_masses(first, idler, last)
    assert (slow, fast) == (near(idler_masses(last, idler, first)[0]), near(idler_masses(last, idler, first)[1]))
    assert 1.0 / slow + 1.0 / fast == near(first + 2.0 * idler + last)
    pairs = sorted((first + idler, last + idler))
    assert 1.0 / slow <= pairs[0] * (1.0 + 1e-12) and 1.0 / fast >= pairs[1] * (1.0 - 1e-12)
    assert float(idler_masses(first, idler, 1e9)[0]) == pytest.approx(1.0 / (first + idler), rel=1e-6)
    assert idler_masses(first, 0.0, last)[0] == near(1.0 / min(first, last))  # an idler that stands parts them


@pytest.mark.parametrize("held", [False, True])
@pytest.mark.parametrize("planets", [2.0, 3.0, 5.0, 8.0])
def test_a_set_of_one_planet_is_rated_as_a_pair_and_more_planets_are_lighter_and_twist_the_sun_more(planets, held):
    """All load factors of one planet are the pair's; of p a lighter mesh, N falls by √((m_s + m_p)/(m_s + p m_p))."""
    quality = MeshQuality(5, tip_relief=None, bodies=(SOLID, MovingBody(held=held)))

    def rated(meshes):
        return rate_mesh(SUN, (HARD, HARD), MeshDuty(300.0, 300.0, 4e6, meshes_per_turn=(meshes, 1.0)), quality=quality)

    pair = rate_mesh(SUN, (HARD, HARD), MeshDuty(300.0, 300.0, 4e6), quality=quality)
    one, many = rated(1.0), rated(planets)
    assert one.loads == pair.loads and one.dynamic == pair.dynamic and one.face == pair.face
    sun, planet = alone(SUN, 0), math.inf if held else alone(SUN, 1)
    lighter = (1.0 / sun + 1.0 / planet) / (planets / sun + 1.0 / planet)
    assert many.dynamic.reduced_mass / pair.dynamic.reduced_mass == near(lighter)
    assert many.dynamic.resonance_ratio / pair.dynamic.resonance_ratio == near(math.sqrt(lighter))
    assert many.face.deflection > pair.face.deflection
    assert many.relief == pair.relief  # tips are made for the force of one mesh


@pytest.mark.parametrize("load", [3e3, 3e4, 3e5, 3e6])
def test_teeth_without_relief_have_its_whole_term_and_run_quietly_only_where_they_stand(load):
    """B_k = 1 at C_a = 0 under every load; K_V → 1 with N → 0, whatever the errors."""
    assert relief_term(TipRelief(0.0, load / 14e9, stiffness=14e9), load, grade=5) == 1.0
    full = TipRelief(load / 14e9, load / 14e9, stiffness=14e9)
    assert relief_term(full, load, grade=5) == pytest.approx(0.0, abs=1e-12)
    slow = dynamic_factor(
        SUN, SPRINGS, MeshDeviations(6e-6, 9e-6), specific_load=load, pinion_speed=1e-6, masses=(5.0,)
    )  # fmt: skip
    assert slow.factor == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("planets", [3, 4, 5, 7])
def test_pins_in_place_or_heavy_loads_share_alike(planets):
    """K_γ → 1 with s → 0 and with F_t → ∞, and grows with the stiffness that errors meet."""

    def factor(spread=18e-6, force=28.5e3, stiffness=3e8):
        return tolerance_load_factor(planets, spread, force, stiffness=stiffness, floating=False)

    assert factor(spread=0.0) == 1.0
    assert factor(force=28.5e9) == pytest.approx(1.0, abs=1e-5)
    assert factor(spread=36e-6) - 1.0 == near(2.0 * (factor() - 1.0))
    assert factor(force=57e3) - 1.0 == near(0.5 * (factor() - 1.0))
    assert factor(stiffness=6e8) - 1.0 == near(2.0 * (factor() - 1.0))
