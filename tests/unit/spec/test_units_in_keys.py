"""Every quantity carries its unit in the key, and is SI inside."""

import math

import pytest

from designs import PAIR, changed, problem
from gearwright.spec import Record, build, keys_of, parse
from gearwright.units import RPM, SUFFIXES, Angle, Inertia, Length, Mass, Power, Speed, shown, text, unit


class Everything(Record):
    """One field of every dimension that a file may hold."""

    angle: Angle | None = None
    inertia: Inertia | None = None
    length: Length | None = None
    mass: Mass | None = None
    power: Power | None = None
    speed: Speed | None = None


ROUNDING = 1e-15
"""One multiplication by a factor that is itself a rounded product."""


@pytest.mark.parametrize(
    ("key", "si"),
    [
        ("angle_deg", math.pi / 180), ("angle_rad", 1.0), ("inertia_kg_m2", 1.0),
        ("length_m", 1.0), ("length_mm", 1e-3), ("length_um", 1e-6), ("length_in", 0.0254), ("length_ft", 0.3048),
        ("mass_kg", 1.0), ("mass_g", 1e-3), ("mass_lb", 0.45359237),
        ("power_w", 1.0), ("power_kw", 1e3), ("power_mw", 1e6), ("power_hp", 745.6998715822702),
        ("speed_rad_s", 1.0), ("speed_rpm", 2 * math.pi / 60),
    ],
)  # fmt: skip
def test_a_key_gives_its_unit_in_si(key, si):
    """Yard and pound: international agreement of 1959; horsepower 550 ft lbf/s."""
    record, written = build(Everything, {key: 3})
    assert written.problems == []
    assert getattr(record, key.partition("_")[0]) == pytest.approx(3 * si, rel=ROUNDING)


def test_every_suffix_of_every_dimension_is_a_key():
    for name, info in Everything.model_fields.items():
        keys = {key for key, meant in keys_of(Everything).items() if meant.field == name}
        dimension = next(iter(info.annotation.__args__[0].__metadata__)).dimension
        assert keys == {f"{name}_{suffix}" for suffix in SUFFIXES[dimension]}


def test_the_same_design_in_other_units_is_the_same_design():
    """6000 rpm and 100 kW as hp and rad/s; equal up to the rounding of the written digits."""
    other = changed(PAIR, "power_kw = 100", "power_hp = 134.10220895950279")
    other = changed(other, "speed_rpm = 6000", "speed_rad_s = 628.3185307179587")
    one, two = parse(PAIR).turbines["turbine"], parse(other).turbines["turbine"]
    assert two.power == pytest.approx(one.power, rel=1e-14)
    assert two.speed == pytest.approx(one.speed, rel=1e-14)


def test_both_units_of_one_quantity_are_refused():
    found = problem(changed(PAIR, "power_kw = 100", "power_kw = 100\npower_w = 1e5"))
    assert found.path == "turbines.turbine.power_w"
    assert "given twice" in found.message
    assert "turbines.turbine.power_kw" in found.message
    assert found.line == 8


def test_a_missing_unit_names_all_units():
    found = problem(changed(PAIR, "power_kw", "power"))
    assert (found.path, found.line) == ("turbines.turbine.power", 7)
    assert found.message == "the unit is missing; write one of power_hp, power_kw, power_mw, power_w"


def test_a_wrong_suffix_names_the_nearest_key():
    found = problem(changed(PAIR, "power_kw", "power_kg"))
    assert (found.path, found.line) == ("turbines.turbine.power_kg", 7)
    assert "did you mean power_kw?" in found.message


def test_capitals_are_recognised():
    assert "did you mean power_kw?" in problem(changed(PAIR, "power_kw", "power_kW")).message


def test_a_bound_is_told_in_the_units_of_the_user():
    found = problem(PAIR + "[gears]\npressure_angle_deg = 45\n")
    assert found.path == "gears.pressure_angle_deg"
    assert found.message == "45 ° is not allowed; give a value from 14 to 30 °"


@pytest.mark.parametrize(
    ("value", "dimension", "read"),
    [(628.3185307179587, "speed", "6000 rpm"), (0.0254, "length", "25.4 mm"), (0.0, "force", "0 N"),
     (12345.678, "force", "12346 N"), (-2.5, "ratio", "-2.5")],
)  # fmt: skip
def test_a_value_is_shown_as_an_engineer_reads_it(value, dimension, read):
    assert text(value, dimension) == read


def test_shown_inverts_the_unit():
    assert shown(4500 * RPM, "speed") == pytest.approx(4500, rel=ROUNDING)
    assert unit("stress") == "MPa"
