"""What no run can follow is told in a sentence, by every verb: no NaN, no advice that does not help."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gearwright.dynamics import (
    Accuracy,
    DampingRatio,
    Model,
    Periodic,
    System,
    frequency_response,
    periodic,
    simulate,
    speed_map,
)
from gearwright.errors import DesignError, SolveError

OMEGA = 1e4
"""Of the mesh mode, and of what shakes it [rad/s]."""


def mesh(*, zeta: float = 0.05, load: float = 1.0, backlash: float = 0.0) -> System:
    """Return a mesh that its error shakes at its own frequency."""
    model = Model()
    model.rotation("clock", inertia=1.0, speed=OMEGA)
    model.rotation("rotor", inertia=1.0, speed=0.0)
    shake = [Periodic({"clock": 1}, (1e-6,))]
    damping = DampingRatio(zeta) if zeta else 0.0
    model.mesh("mesh", {"rotor": 1.0}, stiffness=OMEGA**2, damping=damping, backlash=backlash, errors=shake)
    model.load("rotor", constant=load)
    return model.build()


def swept(system: System, factors: object = (1.0,)):
    """Return a short speed map."""
    return speed_map(system, factors, settle=0.001, duration=0.01)


@pytest.mark.parametrize("method", ["exact", "runge-kutta"])
def test_a_mode_without_damping_that_is_met_is_told(method):
    """Its force grows by k e ω t/2: after 0.01 s by 50 times the 100 N of the error at rest, and on."""
    trace = simulate(mesh(zeta=0.0), 0.01, method=method)
    assert any(note.startswith("the mode at 1592 Hz has no damping") for note in trace.notes)
    assert trace.force.maximum[0, 0] == pytest.approx(50.0 * OMEGA**2 * 1e-6, rel=0.05)
    assert any(
        "trajectory 0: the mode at 1592 Hz has no damping" in note for note in swept(mesh(zeta=0.0)).forces.notes
    )


def test_one_that_is_damped_or_not_met_is_not():
    assert not any("no damping" in note for note in simulate(mesh(), 0.01).notes)
    assert not any("no damping" in note for note in swept(mesh(zeta=0.0), [0.5]).forces.notes)


def test_no_periodic_motion_and_no_response_are_found_there_and_the_reason_is_told():
    with pytest.raises(SolveError, match="the mode at 1592 Hz has no damping"):
        periodic(mesh(zeta=0.0))
    with pytest.raises(SolveError, match=r"the mode at 1591\.55 Hz has no damping"):
        frequency_response(mesh(zeta=0.0), [OMEGA / (2.0 * math.pi)], errors={"mesh": 1e-6})


@pytest.mark.parametrize("load", [1e300, -1e300, 1e14])
@pytest.mark.parametrize("verb", [lambda system: simulate(system, 0.01), periodic, swept])
def test_a_torque_beyond_all_gears_is_refused_before_it_runs(verb, load):
    """A smaller step, which was the advice, would not help."""
    with pytest.raises(SolveError, match=r"the loads press line mesh with .* look at the units of the loads"):
        verb(mesh(load=load))


def test_backlash_of_a_kilometre_is_only_wide():
    """Loaded teeth stay together: the same force as without; backlash of 1e300 m on the other flank is told."""
    wide, none = (simulate(mesh(load=1e4, backlash=play), 0.01, method="runge-kutta") for play in (1e3, 0.0))
    np.testing.assert_allclose(wide.force.maximum, none.force.maximum, rtol=1e-9)
    with pytest.raises(SolveError, match=r"line mesh is deflected by -1e\+300; look at the start"):
        simulate(mesh(load=-1.0, backlash=1e300), 0.01)


def test_loads_that_do_not_balance_are_told_by_every_verb():
    model = Model()
    first, second = model.rotation("a", inertia=1e-4, speed=1e3), model.rotation("b", inertia=1e-4, speed=-1e3)
    model.mesh("mesh", {first: 0.05, second: 0.05}, stiffness=1e8, damping=DampingRatio(0.05),
               variation=Periodic({first: 20}, (0.2,)))  # fmt: skip
    model.load(first, constant=10.0)
    model.load(second, constant=3.0)
    system = model.build()
    told = "the loads on it do not balance: they leave 7 N m"
    assert any(told in note for note in simulate(system, 0.001).notes)
    assert any(told in note for note in swept(system).forces.notes)
    with pytest.raises(SolveError, match=told):
        periodic(system)


@pytest.mark.parametrize("factors", [
    "fast", 1.0, None, [math.nan, 1.0], [], [-1.0], [0.0], [[1.0, 2.0]], np.array(1.0), ["1.0"], [True], [1j],
    [math.inf],
])  # fmt: skip
def test_a_speed_map_over_no_list_of_speeds_is_refused(factors):
    """Texts that read like numbers, and truth values, were taken."""
    with pytest.raises(DesignError, match=r"factors: .*give a sequence"):
        swept(mesh(), factors)


def test_speeds_need_no_order():
    """Each runs by itself, and the step is one for all."""
    up, down = (swept(mesh(), factors).forces.rms for factors in ([0.8, 1.1], [1.1, 0.8]))
    np.testing.assert_allclose(up, down[::-1], rtol=1e-12)


@pytest.mark.parametrize("value", [0.0, -0.01, 1.0, 1e-12, math.nan, "tight", None])
def test_a_tolerance_that_cannot_be_is_refused(value):
    with pytest.raises(DesignError, match="it must be a number between 1e-11 and 1"):
        Accuracy(value)


@pytest.mark.parametrize(("period", "step", "named"), [
    (0.0, None, "period"), (-1.0, None, "period"), (math.nan, None, "period"),
    (None, 0.0, "step"), (None, -1.0, "step"),
])  # fmt: skip
def test_a_period_or_a_step_that_cannot_be_is_refused(period, step, named):
    with pytest.raises(DesignError, match=f"{named}: .* it must be positive and finite"):
        periodic(mesh(), period=period, step=step)
