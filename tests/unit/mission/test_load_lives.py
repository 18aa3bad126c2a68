"""Spectra beside S-N curves: the same damage as that of the gears, and curves that give each class its part."""

import numpy as np
import pytest

from gearwright.mission import gear_damage
from gearwright.mission.lives import load_lives
from gearwright.render.figures.flights import LONGEST, SHOWN, load_life_figure
from shipped_work import flown


def test_the_parts_of_the_classes_sum_up_to_the_damage_of_each_gear():
    rows = {(str(row.part), row.mode): row.total for row in load_lives(flown())}
    gears = {(gear.gear, gear.mode): gear.damage for gear in gear_damage(flown())}
    assert rows.keys() == gears.keys()
    for name, damage in gears.items():
        assert rows[name] == pytest.approx(damage, rel=1e-12)


def test_the_curve_bears_at_a_class_the_load_changes_that_its_part_says():
    """N = n/D at the load of the class; between the steps of the curve ln N runs nearly straight over ln F."""
    for row in load_lives(flown())[:4]:
        worst = int(np.argmax(row.damage))
        some = row.borne > 0.0  # no load that breaks the tooth at once
        read = np.exp(np.interp(np.log(row.force[worst]), np.log(row.ladder[some]), np.log(row.borne[some])))
        assert row.changes[worst] / row.damage[worst] == pytest.approx(read, rel=0.1)


def test_a_tooth_of_the_sun_changes_load_with_every_planet_in_each_turn():
    rows = {(str(row.part), row.mode): row for row in load_lives(flown())}
    sizing = flown().sizing
    teeth, planets = sizing.teeth, sizing.design.planetaries["first"].planets
    sun, planet = rows["first.sun", "pitting"], rows["first.planet", "pitting"]
    ratio = planets * teeth["first.planet"] / teeth["first.sun"]
    assert sun.changes.sum() / planet.changes.sum() == pytest.approx(ratio)


def test_higher_loads_are_borne_less_often():
    """Where the curve is drawn; at the least loads ISO 6336-1 changes its rule for K_Hα, at F_t/b = 100 N/mm."""
    for row in load_lives(flown()):
        assert np.all(np.diff(row.borne[row.borne < LONGEST]) <= 0.0)


def test_a_figure_has_a_panel_for_each_of_the_most_damaged_and_tells_its_sum():
    rows = load_lives(flown())
    figure = load_life_figure(rows, 100.0)
    titles = [axes.title for axes in figure.axes if axes.title]
    assert len(titles) == SHOWN
    assert titles[0].endswith(f"D = {100.0 * rows[0].total:.2g}")
