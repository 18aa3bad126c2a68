"""Bores and bearings that do not go with their shafts and gears are refused where they are written."""

import pytest

from designs import PAIR, problem
from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.spec import parse

SIZES = "pinion_teeth = 21\nwheel_teeth = 63\nmodule_mm = 3\nface_width_mm = 40\n"
STAGE = 'pinion = "fast"\n'
"""Root circle of the pinion: 63 − 7.5 = 55.5 mm (ISO 21771), without profile shift; 48.75 mm leave half of 2.25 m."""
SEATS = """
[layout.fast]
length_mm = 200
{layout}
places.turbine.position_mm = 10
places."stage.pinion".position_mm = 100
[bearings.front]
shaft = "fast"
position_mm = 50
kind = "deep-groove"
locates = "both"
{front}
[bearings.rear]
shaft = "fast"
position_mm = 150
"""
BUILT = PAIR.replace('level = "concept"', 'level = "built"')


def refused(text):
    """Return the only problem of a design that is read and cannot be sized."""
    with pytest.raises(DesignError) as error:
        size(parse(text))
    (only,) = error.value.problems
    return only


def pair(layout):
    return PAIR.replace(STAGE, STAGE + SIZES) + f"[layout.fast]\n{layout}\n"


@pytest.mark.parametrize("layout", ["bore_mm = 60\ndiameter_mm = 70", "bore_mm = 300"])
def test_a_bore_beyond_the_roots_of_its_pinion_is_refused_with_both(layout):
    found = refused(pair(layout))
    assert found.path == "layout.fast.bore_mm"
    assert "stage.pinion (z 21, m_n 3 mm) has a root circle of 55.5 mm; allowed: up to 48.75 mm" in found.message
    assert "give a smaller bore, or the gear more teeth or a larger module" in found.message


def test_a_bore_that_leaves_a_rim_under_the_teeth_is_taken():
    assert size(parse(pair("diameter_mm = 50\nbore_mm = 40"))).shafts[0].bore == pytest.approx(0.04, rel=1e-9)


@pytest.mark.parametrize(
    ("front", "path", "said"),
    [
        ('designation = "6230"', "bearings.front.designation", "6230 with a bore of 150 mm on a shaft that"),
        ("bore_mm = 150", "bearings.front.bore_mm", "a seat of 150 mm on a shaft that"),
    ],
)
def test_a_bearing_that_is_larger_than_its_shaft_is_refused_with_both(front, path, said):
    found = problem(BUILT + SEATS.format(layout="diameter_mm = 30", front=front))
    assert found.path == path
    assert f"{said} layout.fast.diameter_mm makes 30 mm at its thickest; allowed: up to 30 mm" in found.message


def test_a_bore_that_leaves_the_seat_of_a_bearing_no_wall_is_refused_with_both():
    found = problem(BUILT + SEATS.format(layout="bore_mm = 35", front="bore_mm = 30"))
    assert found.path == "layout.fast.bore_mm"
    assert "35 mm through a seat of 30 mm at bearings.front; allowed: up to 27 mm" in found.message


def test_a_planets_bearing_that_does_not_go_over_its_pin_is_refused_with_both():
    text = """
schema = 1
name = "one set"
shafts = ["fast", "slow"]
[turbines.turbine]
shaft = "fast"
power_kw = 100
speed_rpm = 6000
[propellers.propeller]
shaft = "slow"
speed_rpm = 1500
diameter_m = 2
[planetaries.set]
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3
pin_diameter_mm = 60
planet_bearing.designation = "NU 2309"
"""
    found = problem(text)
    assert found.path == "planetaries.set.planet_bearing.designation"
    assert (
        "NU 2309 has a bore of 45 mm, and planetaries.set.pin_diameter_mm is 60; allowed: a pin of up to 45"
        in found.message
    )
