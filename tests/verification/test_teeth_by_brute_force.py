"""The search for teeth finds what sizing every admissible combination of teeth finds."""

import math
from contextlib import suppress
from itertools import product

import pytest

from designs import ONE_SET, PAIR
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.mass import complete_mass
from gearwright.spec import edited, parse, read

RATIO = 3.0
"""Of the pair: 6000 to 2000 rpm."""


def pair(*, gears="", teeth="", **given):
    """Return the sized pair with rules, and teeth where they are given."""
    lines = "".join(f"{key} = {value}\n" for key, value in given.items())
    return size(parse(f"{PAIR}{lines}[gears]\n{gears}\n[teeth]\n{teeth}\n"))


def lightest_pair(pinions, tolerance, *, hunting=False, gears=""):
    """Return the least mass of the gears over all pairs of teeth, and the teeth."""
    masses = {}
    for pinion in pinions:
        exact = RATIO * pinion
        for wheel in (math.ceil(exact) - 1, math.ceil(exact)):
            fits = abs(wheel / pinion / RATIO - 1.0) <= tolerance
            if fits and not (hunting and math.gcd(pinion, wheel) > 1):
                masses[pinion, wheel] = pair(gears=gears, pinion_teeth=pinion, wheel_teeth=wheel).gear_mass
    return min(masses.values()), min(masses, key=masses.get)


@pytest.mark.parametrize(
    ("gears", "teeth", "pinions", "tolerance"),
    [
        ("", "", range(18, 41), 0.025),
        ("", "pinion_maximum = 23", range(18, 24), 0.025),
        ("", "pinion_minimum = 21", range(21, 41), 0.025),
        ("", "hunting = true", range(18, 41), 0.025),
        ("", "hunting = true\nstage_tolerance = 0.012", range(18, 41), 0.012),
        ("helix_angle_deg = 20", "", range(15, 41), 0.025),
        ("profile_shift = 0.2", "", range(14, 41), 0.025),
        ("pressure_angle_deg = 25", "", range(12, 41), 0.025),
    ],
)
def test_the_lightest_pair_is_chosen(gears, teeth, pinions, tolerance):
    chosen = pair(gears=gears, teeth=teeth)
    least, numbers = lightest_pair(pinions, tolerance, hunting="hunting" in teeth, gears=gears)
    assert chosen.gear_mass == pytest.approx(least, rel=1e-9)
    assert (chosen.teeth["stage.pinion"], chosen.teeth["stage.wheel"]) == numbers


def test_the_lightest_internal_pair_is_chosen_with_its_wheel_as_a_ring():
    """As a disc the wheel would pull the choice to few teeth; the ring weighs with its circumference."""
    chosen = pair(gears="helix_angle_deg = 15", teeth="pinion_maximum = 30", internal="true")
    masses = {}
    for pinion in range(15, 31):
        for wheel in range(3 * pinion - 1, 3 * pinion + 2):
            if abs(wheel / pinion / RATIO - 1.0) <= 0.025:
                sized = pair(gears="helix_angle_deg = 15", internal="true", pinion_teeth=pinion, wheel_teeth=wheel)
                masses[pinion, wheel] = sized.gear_mass
    assert chosen.gear_mass == pytest.approx(min(masses.values()), rel=1e-9)
    assert (chosen.teeth["stage.pinion"], chosen.teeth["stage.wheel"]) == min(masses, key=masses.get)


def test_no_pinion_is_undercut():
    """z_min = 2 cos β (1 − x)/sin² α_t: 17.1 teeth at 20°, 14.3 with β = 20°, 13.7 with x = 0.2, 11.2 at 25°."""
    angle = math.radians(20.0)
    transverse = math.atan(math.tan(angle) / math.cos(angle))
    assert math.ceil(2.0 / math.sin(angle) ** 2) == 18
    assert math.ceil(2.0 * math.cos(angle) / math.sin(transverse) ** 2) == 15
    for gears, fewest in (("", 18), ("helix_angle_deg = 20", 15), ("profile_shift = 0.2", 14)):
        with pytest.raises(DesignError):
            pair(gears=gears, teeth=f"pinion_maximum = {fewest - 1}")
        assert pair(gears=gears, teeth=f"pinion_maximum = {fewest}").teeth["stage.pinion"] == fewest


SET = (
    ONE_SET
    + """\
sun = "{sun}"
ring = "{ring}"
carrier = "{carrier}"
planets = {planets}
{given}
"""
)
MEMBERS = {
    "planetary": ("fast", "ground", "slow"),
    "star": ("fast", "slow", "ground"),
    "solar": ("ground", "fast", "slow"),
}
RATIOS = {"planetary": lambda rho: 1.0 + rho, "star": lambda rho: rho, "solar": lambda rho: 1.0 + 1.0 / rho}


def planetary_set(kind, speed, planets, given=""):
    """Return a sized planetary set of one kind."""
    sun, ring, carrier = MEMBERS[kind]
    return size(parse(SET.format(sun=sun, ring=ring, carrier=carrier, speed=speed, planets=planets, given=given)))


def stands(sun, planet, planets):
    """Tell whether equal planets can be put in, and pass each other with 2 m_n between tips of m_n."""
    whole = (2 * sun + 2 * planet) % planets == 0
    return whole and (sun + planet) * math.sin(math.pi / planets) > planet + 2.0


@pytest.mark.parametrize(
    ("kind", "speed", "planets"),
    [("planetary", 1400, 3), ("planetary", 1550, 4), ("star", 1900, 5), ("star", 2300, 3), ("solar", 4300, 5)],
)
def test_the_lightest_set_is_chosen(kind, speed, planets):
    chosen = planetary_set(kind, speed, planets)
    asked = 6000 / speed
    masses = {}
    for sun in range(18, 60):
        for planet in range(12, 5 * 59):
            ratio = RATIOS[kind]((sun + 2 * planet) / sun)
            exact = next(
                rho for rho in (asked - 1.0, asked, 1.0 / (asked - 1.0)) if abs(RATIOS[kind](rho) - asked) < 1e-9
            )
            nearest = abs(planet - (exact - 1.0) / 2.0 * sun) <= 1.0
            if nearest and stands(sun, planet, planets) and abs(ratio / asked - 1.0) <= 0.025:
                sized = planetary_set(kind, speed, planets, f"sun_teeth = {sun}\nplanet_teeth = {planet}")
                masses[sun, planet] = sized.gear_mass
    assert (chosen.teeth["set.sun"], chosen.teeth["set.planet"]) == min(masses, key=masses.get)
    assert chosen.gear_mass == pytest.approx(min(masses.values()), rel=1e-9)
    assert chosen.teeth["set.ring"] == chosen.teeth["set.sun"] + 2 * chosen.teeth["set.planet"]


SHIFTED = [
    ("module_mm = 3\ncentre_distance_mm = 101", "", 0),
    ("module_mm = 3\ncentre_distance_mm = 100.6\nsun_shift = 0.4", "", 0),
    ("module_mm = 3\ncentre_distance_mm = 101\nplanet_shift = -0.2", "", 1),
    ("sun_shift = 0.4\nplanet_shift = 0.5", "", 0),
    ("", 'balanced_shifts = "sliding"', 0),
    ("", 'balanced_shifts = "strength"', 1),
    ("planets = 4", 'balanced_shifts = "sliding"', 2),
    ("planet_shift = 0.1\nring_shift = -0.4", "", 2),
]
"""Keys of a set, rules of gears, teeth by which the ring may differ."""
SHIFTED_SET = SET.format(
    sun="fast", ring="ground", carrier="slow", speed=1550, planets="{planets}",
    given="{keys}\n{teeth}\n[gears]\n{gears}\n[teeth]\n{rules}",
)  # fmt: skip


def shifted(keys="", gears="", teeth="", rules=""):
    """Return a sized set whose teeth may have shifts."""
    text = SHIFTED_SET.replace("planets = {planets}", "" if "planets" in keys else "planets = 3")
    return size(parse(text.format(keys=keys, gears=gears, teeth=teeth, rules=rules)))


@pytest.mark.parametrize(("keys", "gears", "deviation"), SHIFTED)
def test_open_teeth_with_shifts_are_the_lightest_that_close(keys, gears, deviation):
    """Each combination next to the exact ratio is sized in full with its teeth given, or refused: the search holds all
    that are sized, no other, and takes the lightest complete gearbox that passes its checks."""
    chosen = shifted(keys, gears, rules=f"sized = 1000\nring_deviation = {deviation}\nsun_maximum = 38")
    asked, masses, failing = 6000 / 1550 - 1.0, {}, 0
    for sun, more, planet in product(range(18, 39), range(-deviation, deviation + 1), range(12, 120)):
        ring = sun + 2 * planet + more
        near = abs(planet - (asked * sun - sun - more) / 2.0) <= 1.0
        if near and abs((1.0 + ring / sun) / (1.0 + asked) - 1.0) <= 0.025:
            teeth = f"sun_teeth = {sun}\nplanet_teeth = {planet}\nring_teeth = {ring}"
            with suppress(DesignError):
                alone = shifted(keys, gears, teeth)
                if any(check.fails for check in alone.checks):
                    failing += 1
                else:
                    masses[sun, planet, ring] = complete_mass(alone).total
    assert tuple(chosen.teeth.values()) == min(masses, key=masses.get)
    assert complete_mass(chosen).total == pytest.approx(min(masses.values()), rel=1e-9)
    assert chosen.search.combinations == len(masses) + failing
    assert chosen.search.failing == failing


def test_a_ring_deviates_only_where_shifts_close_it():
    """Without shift z_r is z_s + 2 z_p, whatever is allowed; a rule of balance makes use of it, and saves."""
    plain, allowed = (shifted(rules=rules) for rules in ("", "ring_deviation = 2"))
    assert plain.teeth == allowed.teeth
    rules = "sized = 50\nsun_maximum = 44\nring_deviation = {}"
    none, two = (shifted(gears='balanced_shifts = "sliding"', rules=rules.format(most)) for most in (0, 2))
    assert complete_mass(two).total < complete_mass(none).total
    sun, planet, ring = two.teeth.values()
    assert 0 < abs(ring - sun - 2 * planet) <= 2


@pytest.mark.parametrize(
    ("keys", "path", "words"),
    [
        ("module_mm = 3\ncentre_distance_mm = 2000", "set.centre_distance", "centre distance of 666.7 modules"),
        ("sun_shift = 0.2\nring_shift = 0.1", "set", "with the shifts that are given"),
    ],
)
def test_shifts_that_no_teeth_close_are_refused_with_them(keys, path, words):
    """2000 mm are 667 modules, and suns have up to 400 teeth; shifts of sun and ring are equal without a distance."""
    with pytest.raises(DesignError) as caught:
        shifted(keys, rules="sun_maximum = 90")
    (found,) = caught.value.problems
    assert found.path == f"planetaries.{path}" and words in found.message


def test_two_given_members_of_a_set_give_the_third():
    for given in (
        "sun_teeth = 24\nplanet_teeth = 33",
        "sun_teeth = 24\nring_teeth = 90",
        "planet_teeth = 33\nring_teeth = 90",
    ):
        teeth = planetary_set("star", 1600, 3, given).teeth
        assert (teeth["set.sun"], teeth["set.planet"], teeth["set.ring"]) == (24, 33, 90)


def test_one_given_gear_of_a_pair_or_a_set_is_kept():
    assert pair(pinion_teeth=23).teeth["stage.pinion"] == 23
    assert pair(wheel_teeth=77).teeth["stage.wheel"] == 77
    assert planetary_set("planetary", 1400, 3, "ring_teeth = 101").teeth["set.ring"] == 101
    assert planetary_set("planetary", 1400, 3, "planet_teeth = 40").teeth["set.planet"] == 40
    assert planetary_set("planetary", 1400, 3, "sun_teeth = 31").teeth["set.sun"] == 31


def test_a_free_split_is_lighter_than_an_equal_one():
    design = read(shipped_design("in-line"))
    equal, optimal = (size(edited(design, {"teeth.split": split})).gear_mass for split in ("equal", "optimal"))
    assert optimal < 0.999 * equal
