"""Whole gearboxes with published masses: sums of parts come out near them, and the fit finds what made masses."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from gearwright.catalogue import mass_classes, published_gearboxes
from gearwright.errors import DesignError
from gearwright.sizing.mass import weighed_wall
from gearwright.validate.gearboxes import fitted_factor, held, left_out, score

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
def test_a_catalogue_s_wind_gearbox_is_within_the_scatter_about_the_factor_of_its_class(name):
    """Twice the shipped scatter about the published mass: nineteen of twenty gearboxes."""
    found, own = row(name), mass_classes()["wind"]
    assert own.scatter**-2 < own.factor * found.mass.total / found.gearbox.mass < own.scatter**2


@pytest.mark.parametrize("name", FEW)
def test_walls_of_wind_gearboxes_are_as_castings_have_them(name):
    """Castings of 2 MW gearboxes have 16 to 32 mm; walls by a fitted torque had 97 to 144."""
    assert 15e-3 < weighed_wall(row(name).sizing).thickness < 40e-3
    assert weighed_wall(row(name).sizing).why == "casting"


def test_catalogues_scatter_by_less_than_a_fifth_about_one_factor():
    """All 27, each left out of the fit: the shipped factor within 5 %, one standard deviation of × 1.20 at most."""
    boxes = [box for box in published_gearboxes().values() if box.status == "catalogue"]
    rows = [row(box.name) for box in boxes]
    own = mass_classes()["wind"]
    assert own.gearboxes == len(rows) == 27
    assert fitted_factor(rows) == pytest.approx(own.factor, rel=0.05)
    errors = np.log([mass / found.gearbox.mass for mass, found in zip(left_out(rows), rows, strict=True)])
    assert math.exp(float(np.sqrt(np.mean(errors**2)))) < 1.20


def test_the_study_is_one_curve_and_no_four_gearboxes():
    """NREL/TP-500-40566, three stages: 70.94 T^0.759 kg, T in kN m, within 3.3 % of all four."""
    study = [box for box in published_gearboxes().values() if box.status == "study"]
    ratios = [box.mass / (70.94 * (box.torque / 1e3) ** 0.759) for box in study]
    assert len(ratios) == 4 and all(abs(ratio - 1.0) < 0.033 for ratio in ratios)


def test_the_model_of_5_mw_by_its_published_groups_of_which_carriers_are_half():
    """Bodies of the vendor's model: planets with bearings 9.1 t, housing with rings 25.8 t, of which nothing is fitted.

    A known miss: carriers of 10.2 t, with low-speed flange, hubs and bearings, where strength alone asks for 5.2 t; how
    far free plates lag, which tilts planets, decides there and is not computed. The sum and all else are within 15 %.
    """
    found = row("SIMPACK 5 MW")
    mass, carriers = found.mass, 10200.0
    parts = {(item.part, item.group): item.total for item in mass.parts}
    planets = sum(parts[f"{stage}.planet", group] for stage in ("first", "middle") for group in ("gears", "bearings"))
    rings = sum(parts[f"{stage}.ring", "gears"] for stage in ("first", "middle"))
    assert mass.total - mass.of("carriers") == pytest.approx(49800.8 - carriers, rel=0.15)
    assert mass.total == pytest.approx(49800.8, rel=0.15)
    assert mass.of("carriers") == pytest.approx(0.506 * carriers, rel=0.05)
    assert planets == pytest.approx(4 * 1780.2 + 3 * 658.455, rel=0.10)
    assert mass.of("housing") + mass.of("reaction") + rings == pytest.approx(25801.6, rel=0.15)


def test_the_fan_drive_is_nearly_four_times_a_journalist_s_round_pounds_where_its_films_last():
    """A known miss: 271 % above "about 200 lb", 197 % above the 250 lb told elsewhere; 78 % wider than "about 18 in".

    No check of it fails: films of 12 µm at its power ask for planets that large.
    """
    found = row("Fan drive of 30 000 shp")
    assert found.mass.total / found.gearbox.mass == pytest.approx(3.71, rel=0.02)
    assert not [check for check in found.sizing.checks if check.fails]
    ring = next(gear for gear in found.sizing.gears if gear.rim)
    assert 2.0 * ring.rim + ring.pitch_diameter == pytest.approx(1.78 * 18 * 0.0254, rel=0.02)


def test_the_teeth_of_the_propeller_gear_are_those_of_all_its_published_ratios():
    """7.917 in between centres and eleven ratios: 95 teeth together, six to the inch, as the page rounds them."""
    printed = (2.958, 2.800, 2.654, 2.519, 2.393, 2.276, 2.167, 2.065, 1.969, 1.879, 1.794)
    assert [round((95 - pinion) / pinion, 3) for pinion in range(24, 35)] == list(printed)
    assert pytest.approx(7.917, abs=5e-4) == 95 / 6 / 2
    found = row("EPI Mark-10")
    assert {gear.teeth for gear in found.sizing.gears} == {29, 66}
    assert found.gearbox.torque * 29 / 66 == pytest.approx(800 * 1.3558179483, rel=1e-4)


def test_the_propeller_gear_which_no_fit_has_seen_is_a_quarter_light_without_the_propeller_s_shaft_and_bearings():
    """A first sizing has no span and no bearings: 0.75; with a shaft that stands in bearings 1.2."""
    found = row("EPI Mark-10")
    assert found.gearbox.mass == pytest.approx(57 * 0.45359237, rel=1e-3)
    assert found.mass.total / found.gearbox.mass == pytest.approx(0.75, rel=0.03)


def test_the_fit_finds_the_factor_that_made_the_masses_and_each_left_out_does_not_see_its_own():
    rows = [replace(found, gearbox=replace(found.gearbox, mass=1.7 * found.mass.total)) for found in map(row, FEW)]
    assert fitted_factor(rows) == pytest.approx(1.7)
    assert left_out(rows) == pytest.approx([found.gearbox.mass for found in rows])
    odd = [replace(rows[0], gearbox=replace(rows[0].gearbox, mass=9.0 * rows[0].gearbox.mass)), *rows[1:]]
    assert left_out(odd)[0] == pytest.approx(rows[0].gearbox.mass)


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
