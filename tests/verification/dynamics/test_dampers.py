"""A viscous damper: it holds nothing, drags with its slip, and what it loses is counted."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gearwright.dynamics import Model, Outputs, modes, replay, simulate, simulate_many, statics
from gearwright.dynamics.equations import damped_modes, redundancy, slow_position
from gearwright.dynamics.model import Line
from gearwright.errors import DesignError, SolveError

I1, I2, C = 0.3, 0.7, 0.9
RATE = C * (1.0 / I1 + 1.0 / I2)
METHODS = ["exact", "runge-kutta", "runge-kutta generic", "tsit5", "tsit5 generic", "implicit"]


def coupled(*, speeds=(0.0, 0.0), torque=0.0):
    """Return two inertias with nothing but a damper between them."""
    model = Model()
    model.rotation("first", inertia=I1, speed=speeds[0])
    model.rotation("second", inertia=I2, speed=speeds[1])
    model.damper("damper", "first", "second", damping=C)
    for body, sign in (("first", 1.0), ("second", -1.0)) if torque else ():
        model.load(body, constant=sign * torque)
    return model.build()


@pytest.mark.parametrize("method", METHODS)
def test_a_difference_of_speeds_decays_as_it_must(method):
    """ω_1 − ω_2 = ω_0 exp(−c (1/I_1 + 1/I_2) t); 1e-6: the second-order implicit step is the coarsest."""
    trace = simulate(coupled(), 1.0, method=method, step=5e-4, start=(np.zeros(2), np.array([3.0, -1.0])))
    speed = trace.samples.velocity
    assert speed[:, 0] - speed[:, 1] == pytest.approx(4.0 * np.exp(-RATE * trace.samples.time), abs=1e-6)
    assert I1 * speed[:, 0] + I2 * speed[:, 1] == pytest.approx(I1 * 3.0 - I2, abs=1e-12)
    assert trace.work.dissipated == pytest.approx(-trace.work.stored, rel=1e-5)
    assert trace.work.imbalance < 1e-5


@pytest.mark.parametrize("method", METHODS)
def test_speeds_that_differ_in_the_rigid_motion_slip(method):
    """The same two bodies, their speeds told as reference speeds: the same decay, and the same heat."""
    trace = simulate(coupled(speeds=(30.0, -10.0)), 1.0, method=method, step=5e-4, start=(np.zeros(2), np.zeros(2)))
    apart = 40.0 + trace.samples.velocity[:, 0] - trace.samples.velocity[:, 1]
    assert apart == pytest.approx(40.0 * np.exp(-RATE * trace.samples.time), abs=1e-5)
    lost = 0.5 * I1 * I2 / (I1 + I2) * 40.0**2 * (1.0 - np.exp(-2.0 * RATE * trace.duration))
    assert trace.work.dissipated == pytest.approx(lost, rel=5e-6)
    assert trace.work.imbalance < 5e-6
    assert trace.samples.line_force[:, 0] == pytest.approx(C * apart, rel=1e-9)


def test_a_damped_train_with_a_ramp_agrees_with_dop853():
    """Two discs on a shaft, a third behind a damper, speeds that ramp; tsit5 by its tolerance, implicit by (ω h)²."""
    model = Model(profile=((0.0, 1.0), (0.4, 2.2)))
    for name, inertia, speed in (("a", 0.2, 50.0), ("b", 0.4, 50.0), ("c", 0.5, 20.0)):
        model.rotation(name, inertia=inertia, speed=speed)
    model.shaft("shaft", "a", "b", stiffness=4e3, damping=0.5)
    model.damper("damper", "b", "c", damping=2.0)
    model.load("a", constant=100.0)
    system = model.build()

    def slope(time, state):
        (qa, qb, _), (va, vb, vc) = state[:3], state[3:]
        factor = 1.0 + 3.0 * time
        shaft, damper = 4e3 * (qa - qb) + 0.5 * (va - vb), 2.0 * (vb - vc + factor * 30.0)
        return [va, vb, vc, (100.0 - shaft) / 0.2 - 150.0, (shaft - damper) / 0.4 - 150.0, damper / 0.5 - 60.0]

    truth = solve_ivp(slope, (0.0, 0.2), np.zeros(6), method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    for method, room in (("runge-kutta", 1e-6), ("runge-kutta generic", 1e-6), ("tsit5", 5e-5), ("implicit", 2e-4)):
        trace = simulate(system, 0.201, method=method, start=(np.zeros(3), np.zeros(3)), step=1e-4)
        k = int(np.argmin(np.abs(trace.samples.time - 0.2)))
        assert trace.samples.time[k] == pytest.approx(0.2, abs=1e-12)
        reached = np.concatenate([trace.samples.position[k], trace.samples.velocity[k]])
        assert reached == pytest.approx(truth, rel=room, abs=1e-7)


def test_it_holds_nothing_at_rest_and_drags_with_its_slip():
    assert statics(coupled()).force == pytest.approx([0.0], abs=1e-15)
    slipping = coupled(speeds=(5.0, 2.0), torque=3.0 * C)
    assert statics(slipping).force == pytest.approx([3.0 * C], rel=1e-12)
    with pytest.raises(SolveError, match="do not balance"):
        statics(coupled(torque=1.0))


def braced(*, damped):
    """Return a loop of three shafts on a support, with a damper across one, or without."""
    model = Model()
    for name in ("a", "b", "c"):
        model.rotation(name, inertia=0.5)
    for first, second in (("a", "b"), ("b", "c"), ("a", "c")):
        model.shaft(first + second, first, second, stiffness=1e4)
    model.support("housing", "c", stiffness=2e4)
    if damped:
        model.damper("damper", "a", "b", damping=5.0)
    model.load("a", constant=10.0)
    return model.build()


def test_it_closes_no_loop():
    plain, damped = (redundancy(braced(damped=damped)) for damped in (False, True))
    assert damped.count == plain.count == 1
    assert damped.perfect == pytest.approx([*plain.perfect, 0.0], rel=1e-12)
    assert np.abs(damped.states[-1]).max() == 0.0
    positions = [slow_position(braced(damped=damped)) for damped in (False, True)]
    assert positions[1] == pytest.approx(positions[0], rel=1e-12)


def test_undamped_modes_are_as_they_were_and_damped_ones_lose_energy():
    plain, damped = (braced(damped=damped) for damped in (False, True))
    assert modes(damped).frequency == pytest.approx(modes(plain).frequency, rel=1e-12)
    assert modes(damped).line_energy[-1] == pytest.approx(0.0, abs=1e-15)
    assert modes(coupled()).rigid == 2
    rates = [damped_modes(system.arrays).rate for system in (plain, damped)]
    assert np.abs(rates[0].real).max() < 1e-9 * np.abs(rates[0]).max()
    assert rates[1].real.min() < -1.0


def test_a_shaft_beside_it_swings_with_the_damping_of_one_mass():
    """I ẍ + c ẋ + k x = 0: decay c/(2 I) and √(k/I − (c/2I)²)."""
    model = Model()
    model.rotation("disc", inertia=2.0)
    model.rotation("wall", inertia=1e12)
    model.support("anchor", "wall", stiffness=1e15)
    model.shaft("shaft", "disc", "wall", stiffness=800.0)
    model.damper("damper", "disc", "wall", damping=8.0)
    (rate, *_) = damped_modes(model.build().arrays).rate
    assert rate == pytest.approx(-2.0 + 1j * np.sqrt(396.0), rel=1e-6)


def test_several_systems_side_by_side_slip_alike():
    systems = [coupled(speeds=(speed, -10.0)) for speed in (30.0, 20.0)]
    both = simulate_many(systems, 0.05, step=1e-4, start=np.zeros((2, 4)))
    for number, system in enumerate(systems):
        alone = simulate(system, 0.05, step=1e-4, method="runge-kutta", start=(np.zeros(2), np.zeros(2)))
        assert both.maximum[number, 0] == pytest.approx(alone.samples.line_force[:, 0].max(), rel=1e-9)


@pytest.mark.parametrize(
    ("first", "second", "damping", "says"),
    [
        ("a", "b", -1.0, "damping is -1; it must be zero or positive"),
        ("a", "b", 0.0, "needs its damping c, positive"),
        ("a", "b", float("nan"), "damping is nan"),
        ("a", "a", 1.0, "weights are {'a': 0.0}"),
        ("a", "x", 1.0, "no such body: x"),
    ],
)
def test_what_is_no_damper_is_refused(first, second, damping, says):
    model = Model()
    for name in ("a", "b"):
        model.rotation(name, inertia=1.0)
    model.damper("damper", first, second, damping=damping)
    with pytest.raises(DesignError, match=says):
        model.build()


def test_a_shaft_that_begins_where_it_ends_is_refused():
    model = Model()
    model.rotation("a", inertia=1.0)
    model.shaft("shaft", "a", "a", stiffness=1.0)
    with pytest.raises(DesignError, match="weights are"):
        model.build()


def test_a_damper_has_nothing_but_damping():
    model = Model()
    model.rotation("a", inertia=1.0)
    model.add(Line("damper", {"a": 1.0}, 5.0, 1.0, kind="damper"))
    with pytest.raises(DesignError, match="a damper has damping only"):
        model.build()


def test_a_run_that_slips_is_replayed_and_summed_up():
    system = coupled(speeds=(30.0, -10.0))
    still = (np.zeros(2), np.zeros(2))
    trace = simulate(system, 0.1, step=1e-4, method="runge-kutta", outputs=Outputs(start=0.05), start=still)
    part = replay(system, trace, 0.02, 0.03)
    assert part.line_force[0, 0] == pytest.approx(C * 40.0 * np.exp(-RATE * part.time[0]), rel=1e-6)
