"""Bearings of a design with the oil of its file: lives, checks, refusals; nothing moves where nothing is said."""

import functools

import pytest

from gearwright.catalogue import BearingOil, BearingSpectrum, bearing, check_bearing, modified_life
from gearwright.errors import DesignError
from gearwright.parts.bearings import Cleanliness, life_modification, reference_viscosity
from gearwright.sizing import size
from gearwright.spec import edited, read
from gearwright.units import RPM

HOUR = 3600.0
near = pytest.approx
THICK = {"oil__viscosity_40": 68.0, "oil__viscosity_100": 8.5, "gears__iso6336__oil_viscosity": 68.0}
"""One oil for bearings and teeth, of which the design states its own."""


STAGES = ("helical", "bevel", "tail-take-off")
"""Of the EC120B: their scuffing is waived where the oil is thin, so that gears stay as they are."""


@functools.cache
def sized(**changes):
    given = {key.replace("__", "."): value for key, value in changes.items() if not key.startswith("waivers")}
    waived = {key.partition("__")[2]: why for key, why in changes.items() if key.startswith("waivers")}
    return size(edited(read("ec120b"), given | {"waivers": waived}))


def steady(radial, rpm, share=1.0):
    return BearingSpectrum((radial,), (0.0,), (rpm * RPM,), (share,), 5000 * HOUR)


def test_the_modified_life_of_one_load_is_a_iso_times_the_basic_one():
    """6309, 10 kN, 3000/min, 20 mm²/s, normal: κ = 20/9.649, e_C = 0.55, as the maker's example up to its own a_SKF."""
    fitted, oil = bearing("6309"), BearingOil(20e-6, Cleanliness.NORMAL)
    kappa = 20e-6 / reference_viscosity(3000 * RPM, fitted.geometry.pitch_diameter)
    factor = life_modification(0.55 * fitted.fatigue_limit / 10e3, kappa, fitted.kind)
    duty = steady(10e3, 3000.0)
    found = modified_life(fitted, duty, oil)
    assert (found.factor, found.viscosity_ratio, found.contamination) == (near(factor), near(kappa), 0.55)
    assert found.life == near(factor * check_bearing(fitted, duty).life)
    strict = modified_life(fitted, duty, BearingOil(20e-6, Cleanliness.NORMAL, 0.99))
    assert strict.life == near(0.25 * found.life)


def test_levels_of_a_spectrum_tire_one_after_the_other():
    """Miner by hand: Σ share/L of both levels by themselves; what stands or bears nothing does not tire."""
    fitted, oil = bearing("NU 212"), BearingOil(7e-6, Cleanliness.HIGH)
    levels = [(10e3, 1500.0, 0.25), (4e3, 3000.0, 0.75)]
    lives = [modified_life(fitted, steady(load, rpm), oil).life for load, rpm, _ in levels]
    both = BearingSpectrum(
        (10e3, 4e3, 50e3, 0.0), (0.0,) * 4, (1500 * RPM, 3000 * RPM, 0.0, 900 * RPM), (0.25, 0.75, 0.0, 0.0), HOUR
    )
    assert modified_life(fitted, both, oil).life == near(1.0 / (0.25 / lives[0] + 0.75 / lives[1]))
    assert modified_life(fitted, steady(0.0, 1500.0), oil) is None


def test_both_lives_are_shown_and_the_basic_one_is_asked_unless_the_design_says_otherwise():
    for row in sized().bearings:
        assert row.judged_life == row.life
        assert row.modified_life == near(row.life_factor * row.life)
    life = next(check for check in sized().checks if check.part.name == "mast-lower" and check.mode == "life")
    assert (life.symbol, life.value) == ("L_10h", near(sized().bearings[6].life))


def test_a_design_that_asks_for_the_modified_life_takes_bearings_that_reach_it():
    asked = sized(bearing_rules__life="modified", **THICK)
    lives = [check for check in asked.checks if check.mode == "life" and check.symbol == "L_nmh"]
    assert len(lives) == len(asked.bearings)
    for row in asked.bearings:
        assert row.judged_life == row.modified_life >= row.wanted_life
    assert asked.system_life < min(row.modified_life for row in asked.bearings)


def test_thicker_and_cleaner_oil_never_shortens_a_life():
    plain, thick = sized(), sized(**THICK)
    clean = sized(oil__cleanliness="high")
    for one, two, three in zip(plain.bearings, thick.bearings, clean.bearings, strict=True):
        assert one.designation == two.designation == three.designation
        assert two.viscosity_ratio > one.viscosity_ratio and two.modified_life > one.modified_life
        assert three.contamination > one.contamination and three.modified_life > one.modified_life


def test_an_oil_filter_is_asked_by_its_name():
    filtered = sized(oil__cleanliness="beta-6-200")
    assert all(0.0 < row.contamination < 1.0 for row in filtered.bearings)


def test_too_thin_an_oil_is_refused_where_its_life_is_asked_and_not_shown_elsewhere():
    thin = THICK | dict.fromkeys(("oil__viscosity_40", "gears__iso6336__oil_viscosity"), 5.0)
    thin |= {"oil__viscosity_100": 1.2, "oil__temperature": 180.0}
    thin |= {f"waivers__{stage} scuffing": "an oil as thin as it is here" for stage in STAGES}
    assert any(row.modified_life is None for row in sized(**thin).bearings)
    with pytest.raises(DesignError, match=r"below 0\.1, where ISO 281 gives no life; take a thicker oil, in \[oil\]"):
        sized(bearing_rules__life="modified", **thin)


def test_speeds_are_limited_by_kind_and_lubrication_without_being_asked():
    """Makers' n d_m with oil jets and care: 1.8e6 of balls, 1.5e6 of rollers, 0.8e6 of tapers; with grease less."""
    careful = {"deep-groove ball": 1.8e6, "four-point contact ball": 1.8e6, "cylindrical roller": 1.5e6}
    for row in sized().bearings:
        check = next(c for c in sized().checks if c.part.name == row.name and c.mode == "speed factor")
        assert check.limit == careful.get(row.bearing.kind, 0.8e6)
        assert check.value == near(row.speed_factor)
    greased = sized(bearing_rules__lubrication="grease")
    fast = next(c for c in greased.checks if c.part.name == "input-front" and c.mode == "speed factor")
    assert fast.limit < 0.8e6


def test_a_bearing_that_is_too_fast_names_what_would_help_and_one_that_needs_care_says_so():
    """The sun's planets of a star set at 1.22e6: above 1.0e6, which is usual, below 1.5e6; with grease too fast."""
    jets = next(c for c in size(read("in-line-star")).checks if c.name == "first.planet speed factor")
    assert jets.status == "passes" and "above 1e+06, which is usual with oil jets" in jets.why
    greased = size(edited(read("in-line-star"), {"bearing_rules.lubrication": "grease"}))
    slow = next(c for c in greased.checks if c.name == "first.planet speed factor")
    assert slow.fails and slow.limit == 0.5e6
    assert (
        'a smaller bore or a lighter series, or two rows that share the load, or bearing_rules.lubrication = "jet"'
        in (slow.why)
    )


def test_least_load_and_reference_speed_are_checked_where_they_are_asked():
    modes = {"least load", "thermal reference speed", "speed factor"}
    assert modes & {check.mode for check in sized().checks} == {"speed factor"}
    asked = sized(bearing_rules__limits=True, bearing_rules__speed_factor=250e3)
    found = [check for check in asked.checks if check.mode in modes]
    assert {check.mode for check in found} == modes and len(found) == 3 * len(asked.bearings)
    fast = {check.part.name: check for check in found if check.mode == "speed factor"}
    assert fast["input-rear"].fails and not fast["mast-lower"].fails
    light = next(check for check in found if check.mode == "least load" and check.part.name == "input-rear")
    row = next(row for row in asked.bearings if row.name == "input-rear")
    assert "may skid" in light.why if light.fails else not light.why
    assert (light.value, light.limit) == (row.lightest_load, near(0.02 * row.dynamic_rating))
