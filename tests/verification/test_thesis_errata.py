"""The corrections to Pulvirenti (2023) that a line of algebra, a balance or a limit case decides, one test for each.

Names begin with the equation, as `gearwright.replays.pulvirenti.claims` quotes them.
"""

import math

import numpy as np
import pytest
import scipy.linalg

from gearwright.dynamics import modes
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations import damped_modes
from gearwright.dynamics.model import DampingRatio, Model, line_matrix
from gearwright.machines import motor_mass_ndarc, motor_mass_power_law
from gearwright.parts.carriers import pin_diameter
from gearwright.parts.gears import (
    HERTZ_COEFFICIENT,
    bending_stress_lewis,
    disc_inertia,
    disc_mass,
    hertz_coefficient,
    least_teeth,
    lewis_form_factor,
    module_lewis,
)
from gearwright.parts.planetary import assembles, even_positions, most_planets, neighbours_clear
from gearwright.parts.shafts import shaft_stress
from gearwright.parts.stiffness import cut_square_wave, stiffness_at
from gearwright.replays.pulvirenti.flight import relative_planets
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.rating import width_ratio
from gearwright.spec import edited, read
from gearwright.units import RPM
from gearwright.weights import bracket_epicyclic, bracket_planetary, lightest_planet, mass_afdd00, mass_wate2

ROUNDING = 1e-12
"""A few operations in double precision."""
POWER, ENGINE, PROPELLER = 2051e3, 20204.0 * RPM, 1212.0 * RPM
"""PW127 as in table 1.3 of the thesis, with the ratio 16.67 of its series."""


@pytest.fixture(scope="module")
def off_set():
    return size(read(shipped_design("off-set")))


@pytest.fixture(scope="module")
def in_line_h2():
    return size(read(shipped_design("in-line-h2")))


@pytest.fixture(scope="module")
def mixed_h1():
    return size(read(shipped_design("mixed-h1")))


def gear(sizing, name):
    return next(one for one in sizing.gears if one.name == name)


def test_1_2_needs_the_propeller_speed_below():
    """As printed, the engine's speed in both places; 183.5 kg is in table 1.3 and 19 kg is no gearbox of 2 MW."""
    printed = 54.6311 * (POWER / 1e3) ** 0.78137 * (ENGINE / RPM) ** (0.09899 - 0.80686)
    assert printed == pytest.approx(19.0, abs=0.5)
    assert mass_afdd00(POWER, ENGINE, PROPELLER) == pytest.approx(183.5, abs=0.2)


def test_1_3_needs_the_output_torque():
    """Printed: input torque. The other methods give 88 to 224 kg for a PW127."""
    correct = mass_wate2(POWER, ENGINE, PROPELLER)
    pound_feet = POWER / ENGINE / 1.3558179483
    printed = 0.453592 * (0.0174 * pound_feet + 45.0) * math.sqrt(0.118 * ENGINE / PROPELLER)
    assert correct == pytest.approx(160.6, abs=0.5)
    assert printed == pytest.approx(36.4, abs=0.5)


@pytest.mark.parametrize(("ratio", "fit"), [(5.0, 4), (16.67, 2)])
def test_1_4_gives_more_planets_than_fit(ratio, fit):
    """Pitch circles of neighbours touch at N = π/asin((GR − 2)/GR); tips at fewer. Both readings of 1.1736."""
    sine = (ratio - 1.0) / (ratio + 1.0)
    printed = 16.3677 / (3.0 * math.asin(sine) * 1.1736)
    assert math.floor(math.pi / math.asin((ratio - 2.0) / ratio)) == fit
    assert printed > fit + 1.0
    sun = 20
    planet = round(sun * (ratio - 2.0) / 2.0)
    assert most_planets(0.5 * (sun + planet), 0.5 * planet + 1.0) <= fit


def test_1_5_is_the_optimum_of_the_bracket_for_a_star():
    """d/dm_s of the bracket vanishes there, with M_r = GR; a central difference of 1e-5 is good to 1e-8."""
    ratio, planets, step = 5.0, 4, 1e-5
    best = lightest_planet(ratio, planets)
    assert 2.0 * best**3 + best**2 == pytest.approx((0.4 * ratio**2 + 1.0) / planets, rel=1e-9)
    slope = (bracket_epicyclic(best + step, ratio, planets) - bracket_epicyclic(best - step, ratio, planets)) / (
        2.0 * step
    )
    assert abs(slope) < 1e-7


def test_1_6_is_the_sum_over_all_gears():
    """Σ F d² of sun, N planets and 0.4 of a ring, from K = F_t/(F d) (m + 1)/m, for arbitrary numbers."""
    torque, k_factor, planets, planet, ring, sun = 500.0, 4e6, 3, 1.4, 3.8, 0.07
    force = 2.0 * torque / (planets * sun)
    width = force / (k_factor * sun) * (planet + 1.0) / planet
    total = width * (sun**2 + planets * (planet * sun) ** 2 + 0.4 * (ring * sun) ** 2)
    assert total == pytest.approx(2.0 * torque / k_factor * bracket_epicyclic(planet, ring, planets), rel=ROUNDING)


def printed_bracket(ratio, planet, planets):
    """The bracket of (1.6) as it stands, GR_z read as GR_s."""
    return 1.0 / planets + 1.0 / (planets * planet) + planet + planet**2 + 0.4 * ratio**2 / (planets * planet)


def test_1_6_as_printed_is_too_small_for_a_star():
    """GR 4 to 12, three to five planets, m_s by geometry: 0.67 to 0.79.

    Of a planetary set 0.69 to 0.96, as GR in place of GR − 1 helps.
    """
    cases = [(ratio, planets) for ratio in np.linspace(4.0, 12.0, 17) for planets in (3, 4, 5)]
    star = [printed_bracket(g, (g - 1.0) / 2.0, n) / bracket_epicyclic((g - 1.0) / 2.0, g, n) for g, n in cases]
    planetary = [printed_bracket(g, (g - 2.0) / 2.0, n) / bracket_planetary(g, n) for g, n in cases]
    assert (round(min(star), 2), round(max(star), 2)) == (0.67, 0.79)
    assert (round(min(planetary), 2), round(max(planetary), 2)) == (0.69, 0.96)


def test_2_1_is_a_cube_root():
    """Put the module back into Lewis's stress: F_t/(b m Y) gives the allowable only with the cube root."""
    torque, teeth, width, allowable = 499.43 / 3.0, 54, 10.0, 314e6
    factor = float(lewis_form_factor(teeth))
    module = float(module_lewis(torque / teeth, factor, width, allowable=allowable))
    printed = 1e-3 * math.sqrt(2e3 * torque / (width * teeth * factor * allowable / 1e6))
    stresses = [
        bending_stress_lewis(2.0 * torque / (m * teeth), width * m, m, form_factor=factor) for m in (module, printed)
    ]
    assert stresses[0] == pytest.approx(allowable, rel=ROUNDING)
    assert stresses[1] < 0.5 * allowable
    assert 1e3 * printed == pytest.approx(2.18, abs=0.005)
    assert 1e3 * module == pytest.approx(1.68, abs=0.005)


def test_2_1_has_the_inverse_of_lewis_form_factor():
    """Fewer teeth, larger Y, says the text: 1/Y_Lewis falls from 4.1 at 12 teeth to 2.1 at 400."""
    inverse = 1.0 / lewis_form_factor(np.array([12.0, 20.0, 50.0, 400.0]))
    assert np.all(np.diff(inverse) < 0.0)
    assert inverse[[0, -1]] == pytest.approx([4.08, 2.08], abs=0.01)


def test_2_2_has_0_418():
    """√(1/(2π(1 − 0.09))) = 0.4182; 0.4118 is 1.5 % low in stress and 3 % in load."""
    exact = hertz_coefficient(0.3)
    assert pytest.approx(exact, rel=5e-4) == HERTZ_COEFFICIENT
    assert 1.0 - 0.4118 / exact == pytest.approx(0.015, abs=5e-4)
    assert (exact / 0.4118) ** 2 - 1.0 == pytest.approx(0.031, abs=1e-3)


def test_2_3_fixes_the_width_of_helical_gears(off_set):
    """λ = 1.15 π/sin 20° = 10.56."""
    rules = off_set.design.gears
    assert width_ratio(rules, math.radians(20.0)) == pytest.approx(10.56, abs=0.005)


@pytest.mark.parametrize(("helix", "error"), [(20.0, -0.015), (30.0, -0.038)])
def test_2_6_is_a_good_approximation(helix, error):
    """Printed with α_n and cos³ β, exact with α_t and cos β."""
    angle, normal = math.radians(helix), math.radians(20.0)
    printed = 2.0 * math.cos(angle) ** 3 / math.sin(normal) ** 2
    exact = least_teeth(1.0, pressure_angle=normal, helix_angle=angle)
    assert printed / exact - 1.0 == pytest.approx(error, abs=1e-3)


def test_p29_each_mesh_of_the_first_pinion_has_a_quarter(off_set):
    """Four meshes in all: two wheels, two halves."""
    flow = off_set.flows["rated"]
    meshes = [mesh for mesh in off_set.train.meshes if mesh.stage == "first"]
    assert sum(mesh.count for mesh in meshes) == 4
    for mesh in meshes:
        share = flow.meshes[mesh.name]
        torque = share.torques[mesh.gears.index("first.pinion")] / mesh.count
        assert abs(torque / flow.machine_torques["gas-turbine"]) == pytest.approx(0.25, rel=ROUNDING)
        assert abs(share.tooth_power / mesh.count) == pytest.approx(0.25 * 2051e3, rel=ROUNDING)


def test_2_9_has_the_pitch_radius_of_a_helical_gear(off_set):
    """d = m_n z/cos β: 6 % more than m_n z at 20°."""
    pinion = gear(off_set, "first.pinion")
    assert pinion.pitch_diameter * math.cos(math.radians(20.0)) == pytest.approx(pinion.module * 15, rel=ROUNDING)


def test_2_18_lacks_the_width_and_a_factor_of_four():
    """The volume of a cylinder; the printed (π/4)(m z/2)² times the width is a quarter of it."""
    module, teeth, width, density = 3e-3, 40, 0.03, 7850.0
    printed = math.pi / 4.0 * (module * teeth / 2.0) ** 2 * width * density
    assert disc_mass(module * teeth, width, density) == pytest.approx(4.0 * printed, rel=ROUNDING)


def test_2_40_closes_the_power_only_with_the_torque_of_the_sun(in_line_h2):
    """T_s2 ω_s2 is the whole power; T_prop ω_s2 is τ_2 times it."""
    flow, teeth = in_line_h2.flows["rated"], in_line_h2.teeth
    speed = flow.speeds["intermediate"]
    second = 1.0 + teeth["second.ring"] / teeth["second.sun"]
    propeller = abs(flow.machine_torques["propeller"])
    into_sun = abs(next(each.torques[0] for name, each in flow.meshes.items() if name == "second.sun-planet"))
    assert into_sun * speed == pytest.approx(2051e3, rel=1e-11)
    assert propeller * speed == pytest.approx(second * 2051e3, rel=1e-11)


def test_p36_torque_per_tooth_is_the_same_on_both_gears(in_line_h2):
    """F_t acts on both: |T_a|/z_a = |T_b|/z_b in every mesh."""
    flow = in_line_h2.flows["rated"]
    for mesh in in_line_h2.train.meshes:
        torques = flow.meshes[mesh.name].torques
        per_tooth = [abs(torques[side]) / in_line_h2.teeth[mesh.gears[side]] for side in (0, 1)]
        assert per_tooth[0] == pytest.approx(per_tooth[1], rel=1e-11)


@pytest.mark.parametrize(("sun", "most"), [(18, 4.31), (20, 4.37), (45, 4.64)])
def test_2_22_five_planets_bound_the_ratio(sun, most):
    """The largest τ = 2 (z_s + z_p)/z_s with tips clear: z_p + 2 = (z_s + z_p) sin 36°; two digits."""
    sine = math.sin(math.pi / 5)
    planet = (sun * sine - 2.0) / (1.0 - sine)
    assert 2.0 * (sun + planet) / sun == pytest.approx(most, abs=0.005)
    teeth = np.arange(12, 120)
    fitting = teeth[neighbours_clear(sun, teeth, 5)]
    assert fitting.max() == math.floor(planet)
    assert np.any(assembles(sun, sun + 2 * fitting, 5))


def test_2_43_the_pinion_between_two_wheels_is_not_bent(off_set):
    """Forces of opposite wheels cancel: bending is rounding beside the torsion."""
    shaft = next(one for one in off_set.shafts if one.name == "input")
    assert shaft.bending_moment < 1e-9 * shaft.torque


def test_2_47_is_trescas_stress():
    """Twice the largest shear of Mohr's circle, at the surface of a round shaft."""
    bending, torque, diameter = 1000.0, 700.0, 0.04
    sigma, tau = 32.0 * bending / (math.pi * diameter**3), 16.0 * torque / (math.pi * diameter**3)
    principal = np.linalg.eigvalsh([[sigma, tau], [tau, 0.0]])
    assert shaft_stress(bending, torque, diameter) == pytest.approx(principal[1] - principal[0], rel=ROUNDING)


def test_p42_a_pin_has_the_forces_of_both_meshes(in_line_h2):
    """T_c/(N r_c) = 2 F_t, as the planet is in balance."""
    for carrier in in_line_h2.carriers:
        mesh = next(one for one in in_line_h2.meshes if one.name == f"{carrier.stage}.sun-planet")
        assert carrier.tangential_force == pytest.approx(2.0 * mesh.tangential_force, rel=1e-11)
        width = gear(in_line_h2, f"{carrier.stage}.planet").face_width
        assert carrier.pin_diameter == pytest.approx(pin_diameter(carrier.pin_force, width, 785e6 / 2.0), rel=1e-9)


def test_2_50_h1_has_one_layshaft_speed_and_one_centre_distance():
    """Both first stages of Off-Set H1 drive the same wheels' shafts, and their pinions are coaxial."""
    sizing = size(
        edited(read(shipped_design("off-set-h1")), {"motors.electric.speed_rpm": 10000, "teeth.hunting": False})
    )
    speeds, distances = [], []
    for stage, speed in (("first", 20000.0), ("motor-stage", 10000.0)):
        pinion, wheel = gear(sizing, f"{stage}.pinion"), gear(sizing, f"{stage}.wheel")
        speeds.append(speed * pinion.teeth / wheel.teeth)
        distances.append((pinion.pitch_diameter + wheel.pitch_diameter) / 2.0)
    assert speeds[0] == pytest.approx(speeds[1], rel=0.025), "stage ratios may miss by 2.5 %"
    assert distances[0] == pytest.approx(distances[1], rel=1e-9)


def test_2_58_closes_the_power_of_h2():
    """T_EM/2 · z_6/z_7 on each of the two pinions 6, with the turbine's half: twice T_6 ω_6 is the whole power."""
    sizing = size(read(shipped_design("off-set-h2")))
    flow, teeth = sizing.flows["rated"], sizing.teeth
    turbine, motor = flow.machine_torques["gas-turbine"], flow.machine_torques["electric"]
    pinion = turbine / 2.0 * teeth["first.wheel"] / teeth["first.pinion"]
    pinion += motor / 2.0 * teeth["second.pinion"] / teeth["motor-stage.pinion"]
    assert 2.0 * abs(pinion * flow.speeds["left"]) == pytest.approx(2051e3, rel=1e-11)
    least = {rpm: math.ceil(15 * rpm / abs(flow.speeds["left"] / RPM)) for rpm in (10000, 20000)}
    assert least == {10000: 31, 20000: 61}


def test_2_65_is_the_torque_of_the_propeller(in_line_h2):
    """[T_GT (1 + z_r1/z_s1) + T_EM] (1 + z_r2/z_s2)."""
    flow, teeth = in_line_h2.flows["rated"], in_line_h2.teeth
    first, second = (1.0 + teeth[f"{stage}.ring"] / teeth[f"{stage}.sun"] for stage in ("first", "second"))
    torque = (flow.machine_torques["gas-turbine"] * first + flow.machine_torques["electric"]) * second
    assert torque == pytest.approx(abs(flow.machine_torques["propeller"]), rel=1e-11)


def test_2_66_as_printed_loses_torque(mixed_h1):
    """Option 1, a motor as fast as the turbine on a pinion of its own: the wheel has P/ω; the print has 37 % less."""
    flow = mixed_h1.flows["rated"]
    turbine, motor = flow.machine_torques["gas-turbine"], flow.machine_torques["electric"]
    wheel = abs(flow.speeds["intermediate"])
    ratio = 20000.0 * RPM / wheel
    assert (turbine * ratio + motor * ratio) * wheel == pytest.approx(2051e3, rel=1e-3), (
        "the speeds yield to whole teeth"
    )
    assert 1.0 - (turbine * ratio + motor) / ((turbine + motor) * ratio) == pytest.approx(0.367, abs=0.005)


def test_3_13_a_shaft_line_has_the_damping_ratio_that_is_asked():
    """Two inertias on a shaft: c = 2 ζ √(K J) with 1/J = 1/J_1 + 1/J_2 gives the mode just ζ."""
    model = Model()
    model.rotation("a", inertia=2.0)
    model.rotation("b", inertia=0.5)
    model.shaft("line", "a", "b", stiffness=1e4, damping=DampingRatio(0.05))
    (value,), _ = damped_modes(model.build().arrays)
    assert -value.real / abs(value) == pytest.approx(0.05, rel=1e-9)


def test_appendix_inertia_of_a_disc():
    """∫ r² dm over a solid disc; the printed 0.5 m d² is four times it."""
    mass, diameter = 12.0, 0.3
    edges = np.linspace(0.0, diameter / 2.0, 2001)
    middle, thick = (edges[1:] + edges[:-1]) / 2.0, np.diff(edges)
    summed = np.sum(middle**2 * 2.0 * math.pi * middle * thick) * mass / (math.pi * diameter**2 / 4.0)
    assert disc_inertia(mass, diameter) == pytest.approx(summed, rel=1e-6), "midpoint rule with 2000 rings"
    assert disc_inertia(mass, diameter) == pytest.approx(0.5 * mass * diameter**2 / 4.0, rel=ROUNDING)


def test_appendix_motor_is_four_times_lighter_than_ndarcs():
    """1005 kW at 4500 rpm: 23 and 99 kg."""
    torque = 1005e3 / (4500.0 * RPM)
    assert motor_mass_ndarc(torque) / motor_mass_power_law(torque) == pytest.approx(4.26, abs=0.05)


def test_3_57_is_the_absolute_speed_of_a_planet(in_line_h2):
    """|ω_p| = ω_s z_s/(2 z_p) with the ring fixed; relative to the carrier it is ω_c more."""
    flow, teeth = in_line_h2.flows["rated"], in_line_h2.teeth
    sun, carrier = flow.speeds["input"], flow.speeds["intermediate"]
    planet = next(
        flow.speeds[node]
        for mesh in in_line_h2.train.meshes
        if mesh.name == "first.sun-planet"
        for node in mesh.nodes[1:2]
    )
    printed = sun * teeth["first.sun"] / (2.0 * teeth["first.planet"])
    assert abs(planet) == pytest.approx(abs(printed), rel=1e-11)
    relative = (sun - carrier) * teeth["first.sun"] / teeth["first.planet"]
    assert abs(relative) == pytest.approx(abs(printed) + abs(carrier), rel=1e-11)


@pytest.mark.parametrize("planets", [3, 5])
def test_3_34_puts_the_last_planet_onto_the_first(planets):
    """N − 1 steps of 360°/(N − 1) are a full turn; of 360°/N they leave one step."""
    printed = [n * 2.0 * math.pi / (planets - 1) for n in range(planets)]
    assert printed[-1] - printed[0] == pytest.approx(2.0 * math.pi, rel=ROUNDING)
    steps = np.diff([*even_positions(planets), 2.0 * math.pi])
    assert steps == pytest.approx(np.full(planets, 2.0 * math.pi / planets), rel=ROUNDING)


def test_3_35_is_a_square_wave_of_a_quarter():
    """(1/π) Σ sin(nφ)/n over odd n is ±1/4; to the fifth harmonic its mean over a half wave is 0.233."""
    curve = cut_square_wave(1e8)
    phase = (np.arange(2000) + 0.5) * math.pi / 2000
    swing = np.array([stiffness_at(curve, each) for each in phase]) / 1e8 - 1.0
    expected = 2.0 / math.pi**2 * sum(1.0 / n**2 for n in (1, 3, 5))
    assert abs(np.mean(swing)) == pytest.approx(expected, rel=1e-5)
    assert expected == pytest.approx(0.25, rel=0.07)


def test_figure_3_9_ties_a_planets_inertia_to_the_carrier(in_line_h2):
    """Modes of the lines in relative angles θ_c − θ_p, with M as printed, by scipy; with T^T M T the right ones.

    In-Line H2 in cruise: the third to fifth elastic modes fall by 11 and 12 % and rise by 15 % (1e-6 of a Hz apart).
    """
    system = assemble(in_line_h2, "cruise")
    tied = relative_planets(system, in_line_h2)
    names, mass = system.labels.coordinates, np.diag(system.arrays.mass)
    turn = np.eye(len(names))
    for place, name in enumerate(names):
        if ".planet-" in name:
            turn[place, place], turn[place, names.index(f"{name.split('.')[0]}.carrier")] = -1.0, 1.0
    lines = line_matrix(system.arrays) @ turn
    spring = lines.T @ np.diag(system.arrays.stiffness) @ lines
    assert line_matrix(tied.arrays) == pytest.approx(lines, abs=1e-15)
    assert turn @ tied.arrays.speed == pytest.approx(system.arrays.speed, rel=1e-11)
    for shown, inertia in ((system, turn.T @ mass @ turn), (tied, mass)):
        squares = scipy.linalg.eigh(spring, inertia, eigvals_only=True)
        assert modes(shown).frequency[1:] == pytest.approx(np.sqrt(squares[1:]) / (2.0 * math.pi), rel=1e-7)
    assert modes(tied).frequency[3] / modes(system).frequency[3] == pytest.approx(319.034 / 356.521, rel=1e-4)
