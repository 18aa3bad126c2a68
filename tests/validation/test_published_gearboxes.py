"""Whole gearboxes with published masses: sums of parts come out near them, and the fit finds what made masses."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from gearwright.catalogue import published_gearboxes
from gearwright.errors import DesignError
from gearwright.sizing.mass import CALIBRATED
from gearwright.validate.gearboxes import fitted, held, score

FEW = ("Bosch Rexroth 850 kW", "Bosch Rexroth 2000 kW b", "Eickhoff 3300 kW")


@cache
def row(name):
    (found,) = held([published_gearboxes()[name]])
    return found


def test_every_gearbox_has_a_requirement_a_mass_and_a_source():
    boxes = published_gearboxes().values()
    assert len(boxes) >= 8
    assert all(min(box.power, box.torque, box.ratio, box.mass) > 0.0 and box.source for box in boxes)


@pytest.mark.parametrize("name", FEW)
def test_a_catalogue_s_wind_gearbox_is_within_the_scatter(name):
    """Twice the shipped scatter about the published mass: nineteen of twenty gearboxes."""
    found = row(name)
    assert CALIBRATED.scatter**-2 < found.mass().total / found.gearbox.mass < CALIBRATED.scatter**2


def test_the_model_of_5_mw_is_as_heavy_as_published_and_its_groups_are():
    """Bodies of the vendor's model: 49.8 t, planets with bearings 9.1 t, housing with rings 25.8 t.

    The model counts low-speed flange, hubs and bearings to carriers, suns and wheels; these differ by more. Walls by
    torque are thicker than castings, and the shell goes around sets in a row: housing and rings are half as
    heavy again (docs/theory/gearbox-mass.md).
    """
    found = row("SIMPACK 5 MW")
    mass = found.mass()
    parts = {(item.part, item.group): item.total for item in mass.parts}
    planets = sum(parts[f"{stage}.planet", group] for stage in ("first", "middle") for group in ("gears", "bearings"))
    housing = mass.of("housing") + sum(parts[f"{stage}.ring", "gears"] for stage in ("first", "middle"))
    assert mass.total == pytest.approx(49800.8, rel=0.25)
    assert planets == pytest.approx(4 * 1780.2 + 3 * 658.455, rel=0.10)
    assert housing == pytest.approx(25801.6, rel=0.55)


def test_the_fan_drive_is_three_and_a_half_times_a_journalist_s_round_pounds_where_its_films_last():
    """A known miss: 253 % above "about 200 lb", 183 % above the 250 lb told elsewhere; 73 % wider than "about 18 in".

    No check of it fails: films of 12 µm at its power ask for planets that large.
    """
    found = row("Fan drive of 30 000 shp")
    assert found.mass().total / found.gearbox.mass == pytest.approx(3.53, rel=0.02)
    assert not [check for check in found.sizing.checks if check.fails]
    ring = next(gear for gear in found.sizing.gears if gear.rim)
    assert 2.0 * ring.rim + ring.pitch_diameter == pytest.approx(1.73 * 18 * 0.0254, rel=0.02)


def test_the_teeth_of_the_propeller_gear_are_those_of_all_its_published_ratios():
    """7.917 in between centres and eleven ratios: 95 teeth together, six to the inch, as the page rounds them."""
    printed = (2.958, 2.800, 2.654, 2.519, 2.393, 2.276, 2.167, 2.065, 1.969, 1.879, 1.794)
    assert [round((95 - pinion) / pinion, 3) for pinion in range(24, 35)] == list(printed)
    assert pytest.approx(7.917, abs=5e-4) == 95 / 6 / 2
    found = row("EPI Mark-10")
    assert {gear.teeth for gear in found.sizing.gears} == {29, 66}
    assert found.gearbox.torque * 29 / 66 == pytest.approx(800 * 1.3558179483, rel=1e-4)


def test_the_propeller_gear_which_no_fit_has_seen_is_within_the_scatter():
    found = row("EPI Mark-10")
    assert found.gearbox.mass == pytest.approx(57 * 0.45359237, rel=1e-3)
    assert 1.0 / CALIBRATED.scatter < found.mass().total / found.gearbox.mass < CALIBRATED.scatter


def test_the_fit_finds_the_constant_that_made_the_masses():
    made = CALIBRATED._replace(stress_share=0.2)
    rows = [
        replace(found, gearbox=replace(found.gearbox, mass=found.mass(made).total))
        for found in map(row, (*FEW, "Fan drive of 30 000 shp"))
    ]
    assert fitted(rows).stress_share == pytest.approx(made.stress_share, rel=0.03)  # lines between sums 22 % apart


def test_a_score_of_masses_by_hand():
    rows = [row(name) for name in FEW]
    masses = [found.gearbox.mass for found in rows]
    twice = score(rows, [2.0 * mass for mass in masses])
    assert (twice.bias, twice.scatter) == pytest.approx((2.0, 1.0))
    assert twice.exponents[0] == pytest.approx(twice.exponents[1])
    slope = np.polyfit(np.log([found.gearbox.torque for found in rows]), np.log(masses), 1)[0]
    assert twice.exponents[0] == pytest.approx(slope)


def test_a_requirement_that_no_teeth_meet_is_refused_with_a_reason():
    box = replace(published_gearboxes()[FEW[0]], ratio=1e5)
    with pytest.raises(DesignError):
        held([box])
