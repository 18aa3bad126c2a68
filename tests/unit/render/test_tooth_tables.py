"""What the tables beside gears say of their pitch: the module, and the diametral one of designs in inches."""

import math

import pytest

from designs import ONE_SET, PAIR
from gearwright.particulars import particulars
from gearwright.render.drawings.gear_sheet import tooth_grid
from gearwright.render.tables.sizing import tables_of
from gearwright.sizing import size
from gearwright.spec import parse


def rows_of(keys, rules=""):
    text = f"{PAIR}pinion_teeth = 20\nwheel_teeth = 60\nface_width_mm = 30\n{keys}\n[gears]\n{rules}\n"
    sizing = size(parse(text))
    pinion = sizing.gears[0]
    return {name: value for name, _, value in tooth_grid(sizing, pinion, pinion.shafts[0]).rows}


def test_a_spur_gear_of_a_diametral_pitch_has_it_beside_its_module():
    rows = rows_of("normal_diametral_pitch = 8")
    assert (rows["Normal module"], rows["Transverse diametral pitch"]) == ("3.175", "8 /in")
    assert "Normal diametral pitch" not in rows


def test_a_helical_gear_has_the_normal_and_the_transverse_one():
    """P_d = P_nd cos β = 8 cos 12° = 7.8252: ISO 21771, m_t = m_n/cos β."""
    rows = rows_of("normal_diametral_pitch = 8", "helix_angle_deg = 12")
    assert rows["Normal diametral pitch"] == "8 /in"
    assert float(rows["Transverse diametral pitch"].removesuffix(" /in")) == pytest.approx(
        8.0 * math.cos(math.radians(12.0)), abs=5e-5
    )


def test_a_bevel_gear_has_that_of_its_outer_module():
    keys = 'kind = "bevel"\naxis_angle_deg = 90\nouter_diametral_pitch = 6.5'
    rows = rows_of(keys, 'rating = "iso6336"\nmaterial = "carburised-9310"')
    assert rows["Transverse diametral pitch"] == "6.5 /in"


@pytest.mark.parametrize("module", [0.5, 1, 1.25, 2, 2.25, 2.5, 3.5, 5.5, 8, 2.9871])
def test_a_metric_design_has_none(module):
    assert "Transverse diametral pitch" not in rows_of(f"module_mm = {module}")


@pytest.mark.parametrize(("keys", "told"), [("unequal_places = true\n", True), ("", False)])
def test_pins_that_stand_unequally_are_told_with_their_angles(keys, told):
    """27/36/99 with four planets: 126 places, 32 and 31 of them apart; 28/36/100 with four stand evenly."""
    sun, ring = (27, 99) if told else (28, 100)
    teeth = f'sun = "fast"\nring = "ground"\ncarrier = "slow"\nplanets = 4\nsun_teeth = {sun}\nring_teeth = {ring}\n'
    sizing = size(parse(ONE_SET.format(speed=6000.0 * sun / (sun + ring)) + teeth + keys))
    note = tables_of(particulars(sizing))["carriers"].note
    assert note == ("Pins of set stand at 0°, 91.42857°, 180°, 271.4286°." if told else "")
