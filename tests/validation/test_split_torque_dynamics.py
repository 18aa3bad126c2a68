"""Face-gear split torque in motion: sharing ranges, agreement of the four solutions, the paper's claims.

The ranges come from an independent program for the same corrected equations (4 µs Runge-Kutta steps).
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from split_torque import ALL, STAGES, TURN, built, errors, shipped

from gearwright.dynamics import Outputs, simulate
from gearwright.dynamics.assembly import assemble, contacts_of
from gearwright.dynamics.equations import redundancy, steady_forces
from gearwright.dynamics.motion import line_numbers
from gearwright.dynamics.sharing import error_sources, influences, load_sharing, share_coefficients
from gearwright.sizing import size

RANGES = {
    2e9: {"first": (0.02, 1.66, 0.454, 1.374), "second": (0.45, 1.34, 0.563, 1.272)},
    1e7: {"first": (0.907, 1.085, 0.946, 1.038), "second": (0.852, 1.131, 0.959, 1.026)},
}
"""Support -> stage -> least and most share at an instant, and over a tooth cycle."""


def ends(values):
    return float(np.min(values)), float(np.max(values))


@pytest.mark.parametrize("support", RANGES)
@pytest.mark.parametrize("stage", STAGES)
def test_ranges_under_all_errors(support, stage):
    """Tooth-cycle means to 0.2 %, as their sampling decides the third digit; instants to half a printed unit."""
    found = load_sharing(built(support, ALL), STAGES[stage], method="dynamics", span=TURN)
    minimum, maximum, mean_least, mean_most = RANGES[support][stage]
    assert ends(found.instantaneous[:, 0]) == pytest.approx((minimum, maximum), abs=0.006)
    assert ends(found.tooth_cycle[:, 0]) == pytest.approx((mean_least, mean_most), abs=0.002)


@pytest.mark.parametrize(("support", "micrometres"), [(2e9, 11.1), (5e7, 116.0), (1e7, 148.0)])
def test_pinion_moves_further_the_softer_it_is_held(support, micrometres):
    """Largest displacement of shaft 1; printed digits."""
    trace = simulate(
        built(support, ALL), TURN[1], step=4e-6 if support < 1e9 else 2e-6, outputs=Outputs(windows=(TURN,))
    )
    window = trace.windows[0]
    found = np.max(np.hypot(window.motion("input.x"), window.motion("input.y")))
    assert 1e6 * found == pytest.approx(micrometres, rel=5e-3)


def test_pinion_moves_along_its_line_of_action():
    """Both pinion meshes lie on one line, x/y = tan 20°, and the two supports are equal."""
    trace = simulate(built(1e7, ALL), 0.02, outputs=Outputs(windows=((0.0, 0.02),)))
    x, y = (trace.windows[0].motion(f"input.{axis}") for axis in "xy")
    assert x == pytest.approx(y * np.tan(np.radians(20.0)), abs=1e-15)


@pytest.mark.parametrize(("support", "allowed"), [(1e7, 0.0033), (5e7, 0.0053), (2e9, 0.038)])
def test_closed_form_is_as_good_as_said(support, allowed):
    """Closed form against integration, tooth ripple of both stages taken out: 0.33 %, 0.53 %, 3.8 % in b."""
    assert slow_difference(support, "quasi-static") <= allowed


@pytest.mark.parametrize(("support", "allowed"), [(1e7, 0.0013), (5e7, 0.0056), (2e9, 0.038)])
def test_frequency_response_is_as_good_as_said(support, allowed):
    """The same for the frequency response at mean stiffness: 0.13 %, 0.56 %, 3.8 %."""
    assert slow_difference(support, "frequency response") <= allowed


def slow_difference(support, method):
    worst = 0.0
    for stage in STAGES.values():
        shares = [
            slow(load_sharing(built(support, ALL), stage, method=each, span=TURN)) for each in (method, "dynamics")
        ]
        time = np.linspace(TURN[0] + 0.002, TURN[1] - 0.002, 4000)
        low, fine = (np.interp(time, *each) for each in shares)
        worst = max(worst, float(np.max(np.abs(low - fine))))
    return worst


def slow(sharing):
    """Middles of windows of one mesh period of either stage, and the share of the first path there."""
    force, time = sharing.force, sharing.time
    for frequency in (4266.67, 929.03):
        width = round(1.0 / frequency / (time[1] - time[0]))
        total = np.cumsum(np.vstack([np.zeros(force.shape[1]), force]), axis=0)
        force = (total[width:] - total[:-width]) / width
        time = 0.5 * (time[width - 1 :] + time[: len(force)])
    return time, 2.0 * force[:, 0] / np.sum(force, axis=1)


@pytest.mark.parametrize(("support", "allowed"), [(1e7, 2e-3), (5e7, 2e-3), (2e9, 8e-3)])
def test_sidebands_agree_with_the_integration_while_teeth_touch(support, allowed):
    """Second-order sidebands at every instant; at 2e9 N/m a mesh comes within 2 % of parting."""
    for stage in STAGES.values():
        system = built(support, ALL)
        moving = load_sharing(system, stage, method="dynamics", span=(0.25, 0.27))
        force = steady_forces(system, sidebands=2).at(moving.time)
        steady = share_coefficients(force[:, line_numbers(system, stage)])
        assert np.max(np.abs(steady - moving.instantaneous)) <= allowed


def test_single_errors_in_motion():
    """Amplitude of b_5 at the shaft's frequency over whole turns of that shaft [%]; asked within 3 %."""
    wanted = {"Eb2": (1.023, 34.41), "Eg4": (0.987, 34.41), "Eg6": (0.803, 5.279), "Eg1": (0.663, 133.33)}
    for name, (percent, frequency) in wanted.items():
        turns = max(round(0.19 * frequency), 1)
        span = (0.25, 0.25 + turns / frequency)
        found = load_sharing(built(1e7, (name,)), STAGES["second"], method="dynamics", span=span)
        share = found.instantaneous[:-1, 0]
        wave = np.exp(-2j * np.pi * frequency * found.time[:-1])
        assert 200.0 * abs(np.mean((share - np.mean(share)) * wave)) == pytest.approx(percent, rel=0.03)


def test_bias_in_motion():
    """Zero-error means at 1e7 N/m: b_1 −0.460 %, b_5 −0.407 %; to 3 % of them."""
    for stage, percent in (("first", -0.460), ("second", -0.407)):
        found = load_sharing(built(1e7), STAGES[stage], method="dynamics", span=TURN)
        assert 100.0 * (np.mean(found.instantaneous[:, 0]) - 1.0) == pytest.approx(percent, rel=0.03)


def test_auto_says_which_solution_is_enough_and_why():
    """Closed form where the sidebands confirm it; integration where teeth part."""
    soft = load_sharing(built(5e7, ALL), STAGES["second"], span=TURN)
    assert (soft.method, soft.reason[:11]) == ("quasi-static", "closed form")
    stiff = load_sharing(built(2e9, ALL), STAGES["first"], span=TURN)
    assert stiff.method == "sidebands"
    assert "closed form is" in stiff.reason
    ripple = load_sharing(built(1e12, ALL), STAGES["first"], span=(0.25, 0.28))
    assert (ripple.method, "part" in ripple.reason) == ("dynamics", True)


def test_floating_improves_slow_sharing_elevenfold():
    """Claim of the paper, reproduced for what comes slowly: eccentricities spread b_5 11 times less at 1e7 N/m than on
    a rigid pinion, as the flexibility of the loop grows; within 5 %.
    """
    spread = [
        float(np.ptp(load_sharing(built(each, ALL), STAGES["second"], method="quasi-static", span=TURN).instantaneous))
        for each in (1e11, 1e7)
    ]
    assert spread[0] / spread[1] == pytest.approx(11.0, rel=0.05)


def test_floating_does_not_calm_the_instantaneous_sharing_of_the_first_stage_as_much():
    """Claim of the paper, not reproduced in general: tooth ripple stays, so that instants improve by far less."""
    slow_gain, ripple_gain = (
        [
            float(np.ptp(getattr(load_sharing(built(k, ALL), STAGES["second"], method="sidebands", span=TURN), what)))
            for k in (5e7, 1e7)
        ]
        for what in ("tooth_cycle", "instantaneous")
    )
    assert slow_gain[0] / slow_gain[1] > 3.5
    assert ripple_gain[0] / ripple_gain[1] < 2.0


def test_which_shaft_matters_most_depends_on_the_hand():
    """Claim of the paper, conditional: shaft 2's eccentricity is the largest only with shaft 4 on the side of −y; on
    the other side it is shaft 3's.
    """
    worst = []
    for angle in (math.pi, 0.0):
        layout = {**shipped().layout, "output": shipped().layout["output"].model_copy(update={"angle": angle})}
        sizing = size(shipped().model_copy(update={"layout": layout, "errors": errors(ALL)}))
        system = assemble(sizing)
        sources = error_sources(system, contacts_of(sizing, sizing.flows["rated"]), sizing.design.errors)
        found = influences(redundancy(system), sources, line_numbers(system, STAGES["second"]))
        worst.append(next(each.source for each in found if each.turns))
    assert worst == ["left eccentricity", "right eccentricity"]
