"""Periodic motions with backlash are those of the exact piecewise linear solution."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np
import pytest
from piecewise_linear import CASES, Case, exponent, orbit

from gearwright.dynamics import Accuracy, DampingRatio, Model, Orbit, Outputs, Periodic, System, periodic, simulate


def gear(case: Case) -> System:
    """Return the mesh as a system: its error e cos(Ωt) shakes with a = e Ω²."""
    model = Model()
    model.rotation("clock", inertia=1.0, speed=case.rate)
    model.rotation("rotor", inertia=1.0, speed=0.0)
    errors = [Periodic({"clock": 1}, (case.shake / case.rate**2,))]
    damping = DampingRatio(case.damping)
    model.mesh("mesh", {"rotor": 1.0}, stiffness=1.0, damping=damping, backlash=case.backlash, errors=errors)
    model.load("rotor", constant=case.load)
    return model.build()


def apart(case: Case, found: Orbit) -> tuple[float, int]:
    """Return the largest error of the deflection over its largest value, and how often contact begins or ends."""
    deflection = found.samples.deflection("mesh")[:-1]
    start = deflection[0], found.samples.velocity[0, 1]  # the error's own rate is nothing at time 0
    exact, crossings = orbit(case, start, found.samples.time[:-1])
    return float(np.max(np.abs(deflection - exact)) / np.max(np.abs(exact))), crossings


@pytest.mark.parametrize("case", CASES)
def test_orbits_with_backlash_are_the_exact_ones_to_1e_5(case):
    """Where 1e-5 is asked for; halving stopped early, and one motion was not found, when six halvings were all."""
    found = periodic(gear(case), step=Accuracy(1e-5))
    away, crossings = apart(case, found)
    assert crossings >= 2
    assert away < 1e-5
    assert away < found.error <= 1e-5
    assert not found.notes


@pytest.mark.parametrize("case", CASES)
def test_by_default_an_orbit_is_as_near_as_it_says(case):
    found = periodic(gear(case))
    assert apart(case, found)[0] < found.error <= 0.01


@pytest.mark.parametrize(("shake", "rate", "chaotic"), [
    (0.05, 1.0, False), (0.2, 1.0, False), (0.3, 0.6, False), (0.3, 0.8, True), (0.3, 1.0, True),
])  # fmt: skip
def test_chaos_is_told_with_its_exponent_and_what_holds(shake, rate, chaotic):
    """The pair of Kahraman and Singh (1990, J. Sound Vib. 142, 49): ζ = 0.05, F = 0.1, half the backlash 1.

    Three motions that repeat themselves, then two that no period closes. The exponent is that of the exact solution
    from the end of the run on, within a fifth of the damping: about what 200 periods leave of either mean.
    """
    case = Case(0.05, 0.1, shake * rate**2, rate, 2.0)
    length = 400.0 * case.period
    late = Outputs(start=0.25 * length, windows=((0.99 * length, length),))
    run, longer = (simulate(gear(case), many * length, outputs=late) for many in (1.0, 4.0))
    end = run.windows[0]
    wanted = exponent(case, (end.deflection("mesh")[-1], end.velocity[-1, 1]), 200)
    assert (wanted > 0.0) is chaotic
    assert run.exponent == pytest.approx(wanted, abs=0.01)
    assert any("chaotic" in note and "root mean squares and distributions" in note for note in run.notes) is chaotic
    assert run.force.rms[0, 0] == pytest.approx(longer.force.rms[0, 0], rel=max(run.rms_error, 1e-3))


@pytest.mark.parametrize("number", [78, 378, 988])
def test_a_motion_that_parts_on_the_way_says_so_though_its_end_draws_neighbours_in(number):
    """Random one-sided bounces: two runs agreed within 0.4 % by chance where the exact peak was 59 % away.

    The exponent after the end is negative in all three; how far the runs are from each other on the way tells it.
    """
    benchmark = runpy.run_path(str(Path(__file__).parents[3] / "benchmarks" / "impacts.py"))
    run = benchmark["compared"](8675309, number)
    assert run.marked
    assert run.peak_share <= 1.0
    assert run.rms_share <= 1.0


def test_teeth_that_never_part_have_no_exponent():
    case = Case(0.05, 1.0, 0.1, 0.5, 2.0)
    assert simulate(gear(case), 20.0 * case.period).exponent is None
