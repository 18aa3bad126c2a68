"""Are the equations of motion solved right: closed forms, order of convergence, energy, one method against another."""

import math

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Line, Model, Outputs, Periodic, modes, simulate, statics
from gearwright.dynamics.motion import default_step
from gearwright.errors import SolveError


def oscillator():
    """Return one rotor on a spring: ω = 100 rad/s, ζ = 0.02."""
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.support("spring", "rotor", stiffness=1e4, damping=4.0)
    return model.build()


def chain(length: int = 5, damping: float = 1.0, **mesh):
    """Return a free chain of rotors with a mesh in the middle, driven at one end and braked at the other."""
    model = Model()
    names = [
        model.rotation(f"rotor {i}", inertia=0.01 * (i + 1), speed=100.0 if i == 0 else None) for i in range(length)
    ]
    for i in range(length - 1):
        if i == length // 2:
            model.mesh(
                "mesh", {names[i]: 0.1, names[i + 1]: 0.1}, stiffness=1e7, damping=DampingRatio(0.05 * damping), **mesh
            )
        else:
            model.shaft(f"shaft {i}", names[i], names[i + 1], stiffness=2e4, damping=DampingRatio(0.02 * damping))
    model.load(names[0], constant=30.0)
    model.load(names[-1], constant=30.0)
    return model.build()


@pytest.mark.parametrize("method", ["exact", "runge-kutta"])
def test_a_free_damped_oscillation_follows_the_closed_form(method):
    """q = e^(−ζωt) (cos ω_d t + ζ/√(1−ζ²) sin ω_d t) for q(0) = 1.

    The exact step to rounding, RK4 at h ω = 0.02 to 1e-7.
    """
    omega, zeta = 100.0, 0.02
    trace = simulate(oscillator(), 0.5, method=method, step=2e-4, start=(np.array([1.0]), np.array([0.0])))
    t = trace.samples.time
    damped = omega * math.sqrt(1 - zeta**2)
    wanted = np.exp(-zeta * omega * t) * (np.cos(damped * t) + zeta / math.sqrt(1 - zeta**2) * np.sin(damped * t))
    np.testing.assert_allclose(trace.samples.motion("rotor"), wanted, atol=1e-12 if method == "exact" else 1e-7)


def test_an_error_excites_the_steady_amplitude_of_the_frequency_response():
    """Base excitation through spring and damper: X = E √((1 + (2ζr)²) / ((1 − r²)² + (2ζr)²)), r = Ω/ω."""
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.rotation("clock", inertia=1.0, speed=130.0)
    amplitude, ratio, zeta = 1e-3, 1.3, 0.02
    shake = Periodic({"clock": 1}, (amplitude,))
    model.add(Line("spring", {"rotor": 1.0}, 1e4, damping=4.0, errors=(shake,)))
    system = model.build()
    trace = simulate(system, 20.0, step=1e-3, outputs=Outputs(start=10.0))
    response = math.sqrt((1 + (2 * zeta * ratio) ** 2) / ((1 - ratio**2) ** 2 + (2 * zeta * ratio) ** 2))
    assert trace.method == "exact"
    velocity = trace.velocity.of("rotor")
    # The extremes of samples at 48 per turn miss the true ones by up to (2π/48)²/8 = 0.2 %.
    assert velocity["maximum"][0] == pytest.approx(amplitude * response * 130.0, rel=2e-3)


def test_halving_the_step_divides_the_error_by_sixteen():
    """Fourth order on smooth excitation: observed order 3.8 to 4.2."""
    system = chain(variation=Periodic({"rotor 0": 10}, (0.2, 0.1)))
    ends = [
        simulate(system, 0.02, step=0.02 / steps, outputs=Outputs(windows=((0.0, 0.02),))).windows[0].position[-1]
        for steps in (400, 800, 1600, 25600)
    ]
    errors = [np.max(np.abs(end - ends[-1])) for end in ends[:-1]]
    orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    assert np.all((orders > 3.8) & (orders < 4.2))


def test_exact_and_runge_kutta_steps_agree():
    """RK4 at a tenth of its default step leaves less than 1e-6 of the force."""
    system = chain(errors=[Periodic({"rotor 0": 10}, (1e-5, 2e-6))])
    span = Outputs(windows=((0.0, 0.03),))
    exact = simulate(system, 0.03, step=1e-5, start="rigid", outputs=span).windows[0].force("mesh")
    stepped = (
        simulate(system, 0.03, step=1e-5, start="rigid", outputs=span, method="runge-kutta").windows[0].force("mesh")
    )
    assert np.max(np.abs(exact - stepped)) < 1e-6 * np.max(np.abs(exact))


@pytest.mark.parametrize("changing", [True, False])
def test_energy_adds_up_with_changing_stiffness_and_errors(changing):
    """Input work = output work + dissipated + stored − work of k′(t) and e′(t), within 1e-6 of what moved.

    At half the default step; the imbalance is the method's own error, of fourth order, and rounding for the exact step.
    """
    variation = Periodic({"rotor 0": 10}, (0.2, 0.1)) if changing else None
    system = chain(variation=variation, errors=[Periodic({"rotor 0": 10}, (1e-5,))])
    work = simulate(system, 0.1, start="rigid", step=0.5 * default_step(system.arrays)).work
    assert work.driven > 100.0
    assert work.error != 0.0
    assert (work.stiffness != 0.0) is changing
    assert work.imbalance < (1e-6 if changing else 1e-13)


def test_the_run_stays_at_static_equilibrium_when_nothing_changes():
    """Line forces of statics are those of the run, to rounding."""
    system = chain()
    trace = simulate(system, 0.05, method="runge-kutta")
    wanted = statics(system).force
    np.testing.assert_allclose(trace.samples.line_force, np.tile(wanted, (len(trace.samples.time), 1)), rtol=1e-9)


def test_static_forces_in_a_series_chain_carry_the_torque():
    """Every shaft carries 30 N m; the mesh carries it over its base radius, 300 N."""
    equilibrium = statics(chain())
    forces = dict(zip(equilibrium.labels.lines, equilibrium.force, strict=True))
    assert forces.pop("mesh") == pytest.approx(300.0, rel=1e-10)
    assert list(forces.values()) == pytest.approx([30.0, 30.0, -30.0], rel=1e-10)


def test_statics_finds_which_of_two_stops_carries():
    """A rotor between two one-sided stops: the load closes one and leaves the other open."""
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.mesh("forward", {"rotor": 1.0}, stiffness=1e6, backlash=math.inf)
    model.mesh("backward", {"rotor": -1.0}, stiffness=1e6, backlash=math.inf)
    model.load("rotor", constant=-5.0)
    assert statics(model.build()).force == pytest.approx([0.0, 5.0], abs=1e-9)


def test_statics_crosses_the_backlash():
    """A braking load closes the back flank: δ = −B − F/k, force negative."""
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.mesh("stop", {"rotor": 1.0}, stiffness=1e6, backlash=1e-4)
    model.load("rotor", constant=-5.0)
    equilibrium = statics(model.build())
    assert equilibrium.force == pytest.approx([-5.0])
    assert equilibrium.position == pytest.approx([-1e-4 - 5e-6])


def test_a_body_that_nothing_holds_is_named_with_its_motion():
    model = Model()
    for name in ("motor", "wheel"):
        model.rotation(name, inertia=1.0)
    model.mesh("mesh", {"motor": 0.1, "wheel": 0.2}, stiffness=1e8)
    model.load("motor", constant=7.0)
    with pytest.raises(SolveError, match=r"nothing holds the motion \(motor 1, wheel -0.5\).*leave 7 N m"):
        statics(model.build())


def test_natural_frequencies_by_time_response_and_by_eigenvalues_agree():
    """Released from each mode's shape, the spectrum's peak is that mode's frequency; within a tenth of a percent."""
    system = chain(damping=0.0)
    found, rest = modes(system), statics(system)
    for number in range(found.rigid, len(found.frequency)):
        frequency = found.frequency[number]
        start = (rest.position + 1e-3 * found.shapes[:, number], np.zeros(len(found.shapes)))
        trace = simulate(system, 40 / frequency, step=0.02 / frequency, start=start, method="exact")
        line = np.argmax(found.line_energy[:, number])
        swing = trace.samples.line_force[:, line] - rest.force[line]
        assert _tone(swing, trace.step) == pytest.approx(frequency, rel=1e-3)


def _tone(signal, step):
    """Return the frequency by the mean distance of upward zero crossings, each interpolated."""
    up = np.flatnonzero((signal[:-1] < 0.0) & (signal[1:] >= 0.0))
    times = up - signal[up] / (signal[up + 1] - signal[up])
    return 1.0 / (np.mean(np.diff(times)) * step)
