"""Pulvirenti (2023), chapter 4, flown again: what it prints of cruise and taxi, and the page that says so."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from gearwright.mission import fly
from gearwright.mission.windows import fly_window
from gearwright.replays.pulvirenti.claims import sized
from gearwright.replays.pulvirenti.flight import (
    CLAIMS,
    CONSTANT,
    DESIGN,
    MISSION,
    PRINTED,
    UNITLESS,
    VARYING,
    JudgedClaim,
    Judgement,
    as_printed,
    in_phase,
    mean_off_ideal,
    mesh_means,
    mesh_swing,
    off_ideal,
    output_swing,
    reflown,
    spaced,
    steady_level as steady,
)
from gearwright.replays.pulvirenti.pages import (
    FIGURES,
    PANELS,
    STIFFNESS,
    TITLES,
    Side,
    chapter_figure,
    covered_figure_text as covered_text,
    number_text,
)
from gearwright.shipped import shipped_mission
from gearwright.spec import read_mission

PAGE = Path(__file__).parents[3] / "docs/theory/thesis-flight.md"
STIFFNESSES = (CONSTANT, VARYING)


@cache
def window(name, stiffness):
    """Return a window of the chapter, two seconds of it."""
    flight = fly(sized(DESIGN), read_mission(shipped_mission(MISSION)))
    rules = flight.mission.windows[name].model_copy(update={"stiffness": stiffness, "duration": 2.0})
    return fly_window(flight, name, rules)


def test_cruise_with_constant_stiffness_is_within_three_thousandths_of_the_ideal_torque():
    """§4.1, figure 4.5: less than 0.3 %."""
    assert off_ideal(window("cruise", CONSTANT)) < 0.003


@pytest.mark.parametrize("stiffness", STIFFNESSES)
def test_in_taxi_stage_one_carries_no_mean_force(stiffness):
    """§4.2.1, figures 4.17 and 4.21: zero, and of zero mean; the limit is 1e-5 of stage 2."""
    own = window("taxi", stiffness)
    assert np.max(np.abs(mesh_means(own, "first"))) < 1e-5 * np.mean(mesh_means(own, "second"))


def test_taxi_is_within_the_printed_difference_and_swing():
    """Figures 4.19 and 4.23: 0.8 % off the ideal torque, peak to peak 0.5 %, half to one and a half of it here."""
    assert off_ideal(window("taxi", CONSTANT)) < 0.008
    own = steady(window("taxi", VARYING))
    assert 0.0025 < np.ptp(own.output) / np.mean(own.ideal) < 0.0075


def test_torques_stand_to_each_other_as_printed():
    """Figure 4.4: T_EM about 2 T_GT, T_c1 about 6 T_GT and 3 T_EM, T_c2 above 20 T_GT."""
    own = steady(window("cruise", CONSTANT))
    turbine, motor, carrier, output = (float(np.mean(each)) for each in own[:4])
    assert motor / turbine == pytest.approx(2.0, abs=0.2)
    assert carrier / turbine == pytest.approx(6.0, abs=0.5)
    assert carrier / motor == pytest.approx(3.0, abs=0.3)
    assert output / turbine > 20.0


def test_varying_stiffness_keeps_the_mean_forces_and_makes_them_swing():
    """Figure 4.13."""
    one, other = (window("cruise", each) for each in STIFFNESSES)
    for stage in ("first", "second"):
        assert mesh_means(other, stage) == pytest.approx(mesh_means(one, stage), rel=1e-3)
        assert mesh_swing(one, stage) < 1e-6 * np.mean(mesh_means(one, stage))
        assert mesh_swing(other, stage) > 0.1 * np.mean(mesh_means(other, stage))


def test_planets_in_phase_swing_the_output_most():
    """Sequential phases cancel: Kahraman's rule. The thesis's (3.34) spaces the planets unevenly and lies between."""
    ways = ([], [lambda system, sizing: spaced(system, sizing, lambda planets: 2 * np.pi / (planets - 1))], [in_phase])
    for name in ("cruise", "taxi"):
        flown = [reflown(window(name, VARYING), sized(DESIGN), changes, duration=1.0) for changes in ways]
        placed, thesis, together = map(off_ideal, flown)
        assert placed < thesis < together


def test_the_printed_model_swings_the_output_torque_as_printed():
    """Figures 4.15 and 4.16: 0.8 % at most, a mean of 0.6 %, an amplitude of 1.13 %; half to one and a half of them."""
    own = as_printed(window("cruise", VARYING), sized(DESIGN))
    assert 0.004 < off_ideal(own) < 0.012
    assert 0.003 < mean_off_ideal(own) < 0.009
    assert 0.006 < 0.5 * output_swing(own) < 0.017


def test_every_figure_of_the_chapter_has_a_counterpart_and_a_claim():
    numbers = [f"4.{each}" for each in range(2, 24)]
    assert list(FIGURES) == numbers
    assert {claim.figure for claim in CLAIMS} == set(numbers)
    page = PAGE.read_text(encoding="utf-8")
    for claim in CLAIMS:
        assert f"| {claim.figure} | {claim.says} |" in page
        assert STIFFNESS[claim.figure] == claim.stiffness
    for name in PANELS:
        assert (PAGE.parent / f"thesis-flight-{name}.png").exists()


def test_figures_are_drawn_as_printed_beside_as_it_should_be():
    right = {("taxi", stiffness): window("taxi", stiffness) for stiffness in STIFFNESSES}
    printed = {key: reflown(flown, sized(DESIGN), [in_phase], duration=1.0) for key, flown in right.items()}
    sides = (Side("as printed", printed), Side("as it should be", right))
    figure = chapter_figure(sides, "taxi", tuple(TITLES), stiffness=VARYING)
    assert len(figure.axes) == 2 * len(TITLES)
    assert figure.axes[1].title == "Sun forces, stage 1, as it should be"


def test_a_claim_is_judged_by_the_printed_model_unless_it_hangs_on_what_is_not_printed():
    claim = next(claim for claim in CLAIMS if claim.figure == "4.5")
    assert JudgedClaim(claim, printed=0.1, right=0.4).judgement is Judgement.REPRODUCED
    assert JudgedClaim(claim, printed=0.4, right=0.1).judgement is Judgement.NOT_REPRODUCED
    share = next(claim for claim in CLAIMS if claim.figure == "4.3")
    assert JudgedClaim(share, printed=2.5, right=2.5).judgement is Judgement.NOT_TESTABLE
    assert covered_text(JudgedClaim(claim, 0.1, 0.4)) == "up to 0.3 %"
    assert number_text(1e-12, "%") == "0 %"
    assert number_text(2.0567, "") == "2.06"


def test_the_page_has_a_row_for_every_departure():
    page = PAGE.read_text(encoding="utf-8")
    for printed in (*PRINTED, *UNITLESS):
        assert printed.words in page
