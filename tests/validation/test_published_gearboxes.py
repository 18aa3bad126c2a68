"""Whole gearboxes with published masses: sums of parts come out near them, and the fit finds what made masses."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from gearwright.catalogue import mass_classes, published_gearboxes
from gearwright.errors import DesignError
from gearwright.sizing.mass import cage_of, weighed_wall
from gearwright.sizing.places import runs
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


def test_the_model_of_5_mw_by_its_published_groups():
    """Bodies of the vendor's model: planets 9.1 t, housing with rings 25.8 t, carriers 10.2 t, sum 49.8 t, all ± 15 %.

    Nothing is fitted. Carriers (7743 and 2450 kg) are those that keep planets straight to half of f_Hβ.
    """
    found = row("SIMPACK 5 MW")
    mass = found.mass
    parts = {(item.part, item.group): item.total for item in mass.parts}
    planets = sum(parts[f"{stage}.planet", group] for stage in ("first", "middle") for group in ("gears", "bearings"))
    rings = sum(parts[f"{stage}.ring", "gears"] for stage in ("first", "middle"))
    assert mass.total == pytest.approx(49800.8, rel=0.15)
    assert mass.of("carriers") == pytest.approx(7743.3 + 2450.0, rel=0.15)
    assert parts["first.carrier", "carriers"] == pytest.approx(7743.3, rel=0.15)
    assert parts["middle.carrier", "carriers"] == pytest.approx(2450.0, rel=0.15)
    assert planets == pytest.approx(4 * 1780.2 + 3 * 658.455, rel=0.15)
    assert mass.of("housing") + mass.of("reaction") + rings == pytest.approx(25801.6, rel=0.15)
    assert mass.of("housing") + mass.of("reaction") == pytest.approx(18000.0, rel=0.15)


def test_carriers_of_the_model_of_5_mw_have_their_metal_as_far_out_as_the_published_ones():
    """Radii of gyration from published masses and inertias: √(3665/7743) = 0.688 m and √(656.5/2450) = 0.518 m."""
    sizing = row("SIMPACK 5 MW").sizing
    reaches, _ = runs(sizing)
    for carrier, published in zip(sizing.carriers, (0.688, 0.518), strict=True):
        cage = cage_of(sizing, carrier, reaches)
        assert cage.bridge is not None
        length = cage.span[1] - cage.span[0]
        plates = [(plate.volume, plate.body.radius**2 / 2.0) for plate in cage.plates]
        pins = math.pi / 4.0 * (cage.pin_diameter**2 - cage.pin_bore**2) * length * cage.pins
        block = cage.bridges * cage.bridge.width * cage.bridge.depth * length
        own = cage.bridge.radius**2 + (cage.bridge.width**2 + cage.bridge.depth**2) / 12.0
        bodies = [*plates, (pins, carrier.radius**2), (block, own)]
        gyration = math.sqrt(sum(v * k for v, k in bodies) / sum(v for v, _ in bodies))
        assert gyration == pytest.approx(published, rel=0.20)


def test_the_fan_drive_is_a_tenth_above_the_larger_of_two_published_masses():
    """Within 1.25 of the 250 lb told elsewhere, two fifths above a journalist's "about 200 lb", and at most 140 kg.

    A known miss: 38 % wider than "about 18 in". No check of it fails; its films are as thick as is published of such
    bearings, and its ring is by gears that scuff.
    """
    found = row("Fan drive of 30 000 shp")
    pound = 0.45359237
    assert found.mass.total <= 140.0
    assert found.mass.total / (250.0 * pound) == pytest.approx(1.106, rel=0.02)
    assert found.mass.total / (200.0 * pound) == pytest.approx(1.383, rel=0.02)
    assert not [check for check in found.sizing.checks if check.fails]
    ring = next(gear for gear in found.sizing.gears if gear.rim)
    assert 2.0 * ring.rim + ring.pitch_diameter == pytest.approx(1.376 * 18 * 0.0254, rel=0.02)


def test_films_of_the_fan_drive_are_as_published_claims_have_them():
    """Eccentricity 1 − 2 h/c between 0.825 and 0.970 at 90 °C, and a clearance between 120 and 600 µm."""
    sizing = row("Fan drive of 30 000 shp").sizing
    film = next(check for check in sizing.checks if check.mode == "film thickness")
    runs_on = next(gear.runs_on for gear in sizing.gears if gear.runs_on is not None)
    clearance = runs_on.outer_diameter - runs_on.pin_diameter
    assert 120e-6 < clearance < 600e-6
    assert 0.69 + 0.0015 * 90.0 < 1.0 - 2.0 * film.value / clearance < 0.94 + 0.00033 * 90.0


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
