"""At which limit of its formula a loss stands: the words where it is held, none where the formula holds."""

import math

import pytest

from designs import PAIR
from gearwright.particulars import particulars
from gearwright.parts.losses import LossDuty, MeshLaw, OilState, load_intensity, seal_oil_factor, tooth_contact
from gearwright.render.tables.sizing import loss_tables
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size
from gearwright.sizing.losses import Loss, Oil, bearing_limits, loss_balance, mesh_limits, seal_limits
from gearwright.spec import edited, parse, read

SPUR = tooth_contact((30, 90), 3e-3, pressure_angle=math.radians(20.0))
HELICAL = tooth_contact((30, 90), 3e-3, pressure_angle=math.radians(20.0), helix_angle=math.radians(15.0))
OIL = OilState(8e-3, 950.0, 0.4e-6)
FIRST = MeshLaw.ISO_TR_14179_1


def duty(velocity: float, intensity: float = 5e6) -> LossDuty:
    """Return a duty of the asked load intensity K, which is proportional to the line load [m/s, Pa]."""
    return LossDuty(intensity / load_intensity(SPUR, 1.0), 0.04, velocity)


@pytest.mark.parametrize(
    ("velocity", "words"), [(1.99, "counts as 2 "), (25.1, "counts as 25 "), (2.01, ""), (24.9, "")]
)
def test_velocities_beyond_part_one_are_told(velocity, words):
    told = mesh_limits(SPUR, duty(velocity), OIL, FIRST, "cylindrical")
    assert (words in told) if words else told == ""


@pytest.mark.parametrize(("intensity", "words"), [(1.39e6, "as 1.4 "), (14.1e6, "as 14 "), (1.41e6, ""), (13.9e6, "")])
def test_load_intensities_beyond_part_one_are_told(intensity, words):
    told = mesh_limits(SPUR, duty(10.0, intensity), OIL, FIRST, "cylindrical")
    assert (words in told) if words else told == ""


def test_a_mesh_that_stands_or_idles_is_at_no_limit():
    assert mesh_limits(SPUR, duty(0.0), OIL, FIRST, "cylindrical") == ""
    assert mesh_limits(SPUR, LossDuty(0.0, 0.04, 10.0), OIL, FIRST, "cylindrical") == ""


def test_a_law_of_spur_gears_says_so_of_helical_ones():
    law = MeshLaw.ANDERSON_LOEWENTHAL
    assert "15°" in mesh_limits(HELICAL, duty(10.0), OIL, law, "cylindrical")
    assert mesh_limits(SPUR, duty(10.0), OIL, law, "cylindrical") == ""


def test_boundary_friction_is_told_where_it_is_held():
    assert mesh_limits(SPUR, duty(10.0), OIL, MeshLaw.SCHLENK, "cylindrical") == ""
    assert "held at 0.2" in mesh_limits(SPUR, duty(1e-3, 500e6), OIL, MeshLaw.SCHLENK, "cylindrical")


@pytest.mark.parametrize("kind", ["bevel", "face"])
def test_crossed_gears_lose_as_cylindrical_ones_and_say_so(kind):
    assert kind in mesh_limits(SPUR, duty(10.0), OIL, MeshLaw.SCHLENK, kind)


def test_seals_in_hot_oil_are_told():
    """Linke's line of an oil of 26 mm²/s: 145 − 1.6 θ + 350 lg lg 26.8; half of 76.9 is reached at 100.4 °C."""
    assert seal_oil_factor(373.15, 26e-6) == pytest.approx(
        145.0 - 160.0 + 350.0 * math.log10(math.log10(26.8)), rel=1e-12
    )
    cool, hot = (Oil(273.15 + degrees, 0.4e-6, seals="simrit") for degrees in (100.0, 101.0))
    assert seal_limits(cool) == ""
    assert "held at half" in seal_limits(hot)
    assert seal_limits(hot._replace(seals="iso-tr-14179-1")) == ""


def test_bearings_at_a_limit_are_told():
    """5 mm²/s and 10 rad/s (95.5 1/min) are 477, below 2000; without a size the constant stands in."""
    oil = Oil(373.15, 0.4e-6, bearings="palmgren")
    assert "477" in bearing_limits("palmgren", 10.0, oil)
    assert bearing_limits("palmgren", 100.0, oil) == ""
    assert bearing_limits("palmgren", 0.0, oil) == ""
    assert "palmgren" in bearing_limits("constant", 100.0, oil)


WAIVED = {"waivers": {"bevel scuffing": "an oil as hot as it is here"}}
"""So that hot oil asks for no larger gears."""


def rows(design: str, **changes: object) -> dict[str, Loss]:
    changed = {key.replace("__", "."): to for key, to in changes.items()}
    sizing = size(edited(read(shipped_design(design)), changed | WAIVED))
    return {loss.part: loss for loss in loss_balance(sizing).losses}


def test_the_balance_has_the_limits_of_every_origin():
    """ec120b: the mast turns too slowly for Palmgren; an oil of 150 °C is beyond the line of seals."""
    found = rows("ec120b", losses__bearings="palmgren", losses__seals="simrit", oil__temperature=150.0)
    assert "cylindrical pair" in found["bevel"].limit
    assert "counts as 2000" in found["mast-upper"].limit
    assert "held at half" in found["seal at main-rotor"].limit
    assert found["helical"].limit == found["input-rear"].limit == found["helical.wheel"].limit == ""


def test_straight_gears_in_a_bath_are_told():
    spur = size(parse(f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n[losses.dip]\n"stage.wheel" = 0.2\n'))
    wheel = next(loss for loss in loss_balance(spur).losses if loss.part == "stage.wheel")
    assert (wheel.origin, "counts as 10°" in wheel.limit) == ("churning", True)


def test_the_table_names_each_limit_once_and_counts_many_parts():
    sizing: Sizing = size(
        edited(read(shipped_design("ec120b")), {"losses.seals": "simrit", "oil.temperature": 150.0} | WAIVED)
    )
    note = loss_tables(particulars(sizing))["losses"].note
    assert note.count("held at half") == 1
    assert "and 3 more: factor" in note
    assert "limit" in [column.name for column in loss_tables(particulars(sizing))["loss_parts"].columns]


def test_a_table_without_limits_has_no_column_for_them():
    sizing = size(parse(f"{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n"))
    assert "limit" not in [column.name for column in loss_tables(particulars(sizing))["loss_parts"].columns]
