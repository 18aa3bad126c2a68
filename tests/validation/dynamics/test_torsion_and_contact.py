"""Torsional systems, stability charts, backlash and resonance against closed forms and exact piecewise solutions."""

import math

import numpy as np
import pytest
from scipy.special import mathieu_a, mathieu_b

from gearwright.dynamics import Model, Outputs, modes, periodic, simulate
from gearwright.dynamics.model import Periodic

DRILL = {"length": 800.0, "outer": 0.78, "inner": 0.65, "modulus": 75e9, "density": 8000.0}
DRILL_EXACT = (1.91033229, 3.82066476, 5.73099757, 7.64133089, 9.5516649)
"""tan(kL) of the continuous shaft with end inertias 200 and 10 kg m² [Hz]; Friswell et al. 2010, problem 9.9."""


def drill(segments):
    length, outer, inner, modulus, density = DRILL.values()
    moment = math.pi / 32.0 * (outer**4 - inner**4)
    part = length / segments
    inertias = [density * moment * part * (0.5 if number in (0, segments) else 1.0) for number in range(segments + 1)]
    inertias[0] += 200.0
    inertias[-1] += 10.0
    model = Model()
    for number, inertia in enumerate(inertias):
        model.rotation(f"{number}", inertia=inertia)
    for number in range(segments):
        model.shaft(f"shaft {number}", f"{number}", f"{number + 1}", stiffness=modulus * moment / part)
    return modes(model.build()).frequency[1:]


def test_a_drill_string_has_the_frequencies_of_the_continuous_shaft():
    np.testing.assert_allclose(drill(400)[:5], DRILL_EXACT, rtol=1e-4)


def test_fifty_lumped_segments_of_a_drill_string_err_as_another_program_does():
    """openTorsion, test of problem 9.9: four frequencies of 50 lumped segments."""
    np.testing.assert_allclose(drill(50)[:4], (1.910018, 3.818151, 5.722517, 7.621236), rtol=1e-6)


def test_a_wind_turbines_drive_line_of_three_inertias():
    """openTorsion's example after doi 10.1109/TIE.2010.2087301: 0, 58.34 and 1034.11 rad/s."""
    model = Model()
    for name, inertia in (("rotor", 1e7), ("gears", 5770.0), ("generator", 97030.0)):
        model.rotation(name, inertia=inertia)
    model.shaft("slow", "rotor", "gears", stiffness=3.67e8)
    model.shaft("fast", "gears", "generator", stiffness=5.496e9)
    found = 2.0 * np.pi * modes(model.build()).frequency
    np.testing.assert_allclose(found, (0.0, 58.3401619, 1034.11472), rtol=1e-7, atol=1e-9)


def mesh(speed, *, swing=0.0, error=0.0, damping=0.0, backlash=0.0, load=1.0):
    """One mesh of natural frequency 1 rad/s on a unit mass that an order of ``speed`` shakes."""
    model = Model()
    model.rotation("clock", inertia=1e30, speed=speed)
    model.rotation("gear", inertia=1.0, speed=0.0)
    model.mesh("mesh", {"gear": 1.0}, stiffness=1.0, damping=2.0 * damping, backlash=backlash,
               variation=Periodic({"clock": 1}, cosine=[swing]) if swing else None,
               errors=[Periodic({"clock": 1}, cosine=[error])] if error else [])  # fmt: skip
    model.load("gear", constant=load)
    return model.build()


def boundaries(swing):
    """Return Ω/ω_n of the first two instabilities of k(1 + ε cos Ωt), from a_r(q) and b_r(q) of Abramowitz & Stegun."""
    found = []
    for curve, order in ((mathieu_a, 1), (mathieu_b, 1), (mathieu_b, 2), (mathieu_a, 2)):
        low, high = 1.6 / order, 2.5 / order
        for _ in range(80):
            middle = 0.5 * (low + high)
            a = 4.0 / middle**2
            low, high = (middle, high) if a > curve(order, 0.5 * a * swing) else (low, middle)
        found.append(middle)
    return found


def test_the_boundaries_of_mathieus_chart_are_the_tabulated_ones():
    expected = (1.8475591, 2.1469989, 0.9812739, 1.0037097)
    np.testing.assert_allclose(sorted(boundaries(0.3)), sorted(expected), rtol=1e-6)


@pytest.mark.parametrize("place", [1.8475591, 2.1469989, 0.9812739, 1.0037097])
def test_stability_changes_at_the_boundaries_of_mathieus_chart(place):
    """Two in a thousand to either side of a boundary the verdicts differ, with next to no damping."""
    verdicts = [periodic(mesh(place * side, swing=0.3, damping=1e-7)).stable for side in (0.998, 1.002)]
    assert verdicts[0] is not verdicts[1]


KAHRAMAN_SINGH = {
    0.5: (0.1, 0.1166298, 0.0833702), 0.8: (0.1, 0.1867722, 0.0132278), 0.9: (0.0519809, 0.2975815, -0.1607511),
    1.0: (0.0731147, 0.2692554, -0.1047121), 1.2: (0.093828, 0.2286165, -0.0366819),
    1.35: (0.0993247, 0.2072271, -0.0080713),
}  # fmt: skip
"""Ω/ω_n -> mean, largest and smallest deflection over half the gap, of the branch reached from rest: exact
piecewise-linear solution of the equation of Kahraman & Singh 1990 (ζ = 0.05, F = 0.1, E = 0.05, gap 2)."""


@pytest.mark.parametrize("speed", KAHRAMAN_SINGH)
def test_contact_loss_of_a_gear_pair_follows_the_exact_piecewise_motion(speed):
    """δ = x − e: an error of −E cos Ωt shakes with +E Ω² cos Ωt; damping acts in the gap too, as here."""
    period = 2.0 * math.pi / speed
    system = mesh(speed, error=-0.05, damping=0.05, backlash=2.0, load=0.1)
    end = 80.0 * period
    trace = simulate(system, end, step=period / 800.0, method="runge-kutta",
                     outputs=Outputs(samples=2, windows=((end - period, end),)))  # fmt: skip
    window = trace.windows[0]
    place = window.position[:, system.labels.coordinates.index("gear")]
    deflection = place + 0.05 * np.cos(speed * window.time)
    mean, largest, smallest = KAHRAMAN_SINGH[speed]
    assert [np.max(deflection), np.min(deflection)] == pytest.approx([largest, smallest], abs=1e-4)
    assert np.mean(deflection[:-1]) == pytest.approx(mean, abs=1e-4)


@pytest.mark.parametrize("damping", [0.05, 0.02])
def test_a_lightly_damped_mesh_resonates_as_high_as_its_damping_lets_it(damping):
    """X = E/(2 ζ) at Ω = ω_n, of the deflection of the teeth."""
    period, error = 2.0 * math.pi, 0.002
    end = (8.0 / (2.0 * math.pi * damping) + 10.0) * period
    system = mesh(1.0, swing=1e-9, error=error, damping=damping)
    trace = simulate(system, end, outputs=Outputs(samples=2, windows=((end - 2.0 * period, end),)))
    window = trace.windows[0]
    place = window.position[:, system.labels.coordinates.index("gear")]
    deflection = place - error * np.cos(window.time)
    assert 0.5 * np.ptp(deflection) == pytest.approx(error / (2.0 * damping), rel=0.01)


@pytest.mark.parametrize(
    ("place", "expected"),
    [(2.0, (-1.2649114, -0.7905692)), (1.9, (-1.20691872, -0.82855621)), (1.0, (1.05404372, 0.94872725))],
)
def test_multipliers_of_mathieus_equation_are_those_of_an_independent_solver(place, expected):
    """ε = 0.3 without damping, by an integrator at 1e-13; product one."""
    found = np.sort(periodic(mesh(place, swing=0.3, damping=1e-9)).multipliers.real)
    np.testing.assert_allclose([value for value in found if abs(value - 1.0) > 1e-4], np.sort(expected), rtol=1e-4)


FLOQUET = {
    56365.1961: (1.178632, 0.956681), 68313.0051: (1.192667, 1.192667), 111757.0192: (1.198831, 0.983562),
    62339.1006: (0.970729, 0.970729), 90035.0121: (0.979638, 0.979638),
}  # fmt: skip
"""Mesh frequency [rad/s] at twice w1, w2, w3, at w1 + w2 and w2 + w3 -> largest moduli, by an independent program."""


def four_planets(mesh_rate):
    """Rotations of a set by their paths: sun 0.5, carrier with planets 8, four planets 0.6 kg; meshes in phase."""
    model = Model()
    model.rotation("clock", inertia=1e30, speed=mesh_rate)
    model.rotation("sun", inertia=0.5, speed=0.0)
    model.rotation("carrier", inertia=8.0, speed=0.0)
    for number in range(4):
        planet = f"planet {number}"
        model.rotation(planet, inertia=0.6, speed=0.0)
        model.mesh(f"sun {number}", {"sun": 1.0, planet: 1.0, "carrier": -1.0}, stiffness=3e8, damping=177.899836,
                   variation=Periodic({"clock": 1}, cosine=[0.3]))  # fmt: skip
        model.mesh(f"ring {number}", {planet: -1.0, "carrier": -1.0}, stiffness=4e8, damping=298.834947,
                   variation=Periodic({"clock": 1}, cosine=[0.25]))  # fmt: skip
    model.load("sun", constant=10.0)
    model.load("carrier", constant=-20.0)
    return model.build()


@pytest.mark.parametrize("mesh_rate", FLOQUET)
def test_phasing_decides_which_instabilities_of_a_planetary_set_there_are(mesh_rate):
    """Lin & Parker 2002: in phase no combination of rotational and planet modes is unstable, every single one is."""
    found = np.sort(np.abs(periodic(four_planets(mesh_rate)).multipliers))[::-1]
    moving = [value for value in found if abs(value - 1.0) > 1e-6]
    np.testing.assert_allclose(moving[:2], FLOQUET[mesh_rate], atol=2e-4)


def test_stability_is_told_without_a_load_as_well():
    """The multipliers of a linear system do not know its load; nothing is divided by a motion that stands still."""
    still, loaded = (
        np.sort(periodic(mesh(1.9, swing=0.3, damping=0.01, load=load)).multipliers.real) for load in (0.0, 1.0)
    )
    np.testing.assert_allclose(still, loaded, rtol=1e-6)
