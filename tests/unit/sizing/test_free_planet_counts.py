"""How many planets a set has where its design leaves that out, how large suns become, and how a ratio is shared."""

import math

import pytest

from designs import ONE_SET, problem
from gearwright.errors import DesignError
from gearwright.parts.planetary import most_planet_teeth, neighbours_clear
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import edited, read
from gearwright.study import for_engine, for_requirement
from gearwright.units import RPM

SET = (
    ONE_SET
    + """\
sun = "fast"
ring = "ground"
carrier = "slow"
"""
)


def fitted(name, ratio, **changes):
    design = for_requirement(
        read(shipped_design(name)), power=2e6, engine_speed=1000 * ratio * RPM, propeller_speed=1000 * RPM
    )
    return edited(design, {path.replace("__", "."): value for path, value in changes.items()})


@pytest.mark.parametrize(("ratio", "planets"), [(4.06, 5), (5.1, 4), (6.3, 4), (9.0, 3), (14.0, 3), (20.0, 2)])
def test_the_lightest_number_of_planets_is_chosen(ratio, planets):
    """Of 2 to 5 that pass each other: up to 4.7 five do with 59 teeth on the sun, to 6.6 four, to 14.4 three."""
    free = fitted("single-planetary", ratio)
    masses = {}
    for count in range(2, 6):
        try:
            sizing = size(edited(free, {"planetaries.first.planets": count, "teeth.sun_maximum": 59}))
        except DesignError:
            continue
        masses[count] = sizing.gear_mass
    chosen = size(free)
    assert chosen.design.planetaries["first"].planets == planets == min(masses, key=masses.get)
    assert chosen.gear_mass == pytest.approx(masses[planets], rel=1e-12)


def test_a_number_of_planets_that_is_given_stays_and_so_does_the_design():
    design = read(shipped_design("in-line"))
    assert size(design).design is design
    three = size(fitted("in-line", 16.5, planetaries__second__planets=3)).design.planetaries
    assert (three["second"].planets, three["first"].planets) == (3, 5)


def test_given_teeth_with_planets_left_out_get_as_many_as_assemble():
    """18 + 72 = 90 is a multiple of 2, 3 and 5; (18 + 27) sin 36° = 26.5 is not above 29, with 3 it is 39."""
    design = edited(
        fitted("single-planetary", 5.0), {"planetaries.first.sun_teeth": 18, "planetaries.first.planet_teeth": 27}
    )
    assert size(design).design.planetaries["first"].planets == 3


def test_no_more_planets_are_looked_at_than_the_rules_allow():
    assert size(fitted("single-planetary", 3.0, teeth__planets_maximum=8)).design.planetaries["first"].planets == 8
    assert size(fitted("single-planetary", 3.0)).design.planetaries["first"].planets == 5


def test_suns_are_larger_where_no_smaller_ones_do_unless_the_design_limits_them():
    """1 + z_r/z_s = 2 + 2 z_p/z_s: with planets of 12 teeth or more, 2.2 needs suns of about 120."""
    sizing = size(fitted("single-planetary", 2.2))
    assert 59 < sizing.teeth["first.sun"] <= 120
    found = problem(SET.format(speed=6000 / 2.2) + "[teeth]\nsun_maximum = 59\n", sized=True)
    assert "is below 2.407, the least with suns of up to 59 teeth and planets of 12 or more" in found.message


def test_a_set_below_its_least_ratio_is_refused_with_it():
    found = problem(SET.format(speed=3000), sized=True)
    assert found.path == "planetaries.set"
    assert "1 + z_r/z_s = 2 is below 2.06" in found.message
    assert "all stages to the propeller together give no ratio below 2.06, and 2 is asked" in found.message


def test_given_planets_are_refused_with_the_ratio_at_which_they_touch():
    found = problem(SET.format(speed=1000) + "planets = 5\nsun_teeth = 30\n", sized=True)
    assert "sun_teeth = 30" in found.message


def test_the_limit_of_planets_is_where_neighbours_touch():
    for sun, planets in ((18, 3), (59, 4), (40, 5)):
        most = most_planet_teeth(sun, planets)
        assert neighbours_clear(sun, math.ceil(most) - 1, planets)
        assert not neighbours_clear(sun, math.floor(most) + 1, planets)


def test_the_other_stage_takes_what_a_planetary_set_cannot():
    """At 3:1 equal parts would be 1.73, and a set begins at 2.41: the pair before it takes 1.25."""
    sizing = size(fitted("mixed", 3.0))
    pair = sizing.teeth["first.wheel"] / sizing.teeth["first.pinion"]
    planetary = 1.0 + sizing.teeth["second.ring"] / sizing.teeth["second.sun"]
    assert 2.407 / 1.025 <= planetary <= 2.407 * 1.05
    assert pair * planetary == pytest.approx(3.0, rel=0.05)


def test_given_planets_hand_on_what_they_have_no_room_for():
    """At 26:1 five planets have no room for 5.1, but the three before them for what is left."""
    sizing = size(fitted("in-line", 26.0, planetaries__first__planets=3, planetaries__second__planets=5))
    second = 1.0 + sizing.teeth["second.ring"] / sizing.teeth["second.sun"]
    assert second < 4.8 < 1.0 + sizing.teeth["first.ring"] / sizing.teeth["first.sun"]


def test_a_motor_between_two_stages_turns_so_that_both_have_teeth():
    """At 3:1 the scaled speed would leave 1.58 for the planetary set."""
    design = fitted("mixed-h2", 3.0)
    assert design.motors["electric"].speed / RPM == pytest.approx(1000 * (2 + 24 / 59), rel=1e-9)
    assert size(design).mass > 0.0


def test_pairs_on_common_axes_are_weighed_with_their_common_centre_distance():
    """Fifteen teeth on both pinions is one of the choices, so that what is chosen is no heavier."""
    free = fitted("off-set-h1", 26.0)
    given = {f"pairs.{name}.pinion_teeth": 15 for name in free.pairs}
    assert size(free).gear_mass <= size(edited(free, given)).gear_mass * (1.0 + 1e-9)


def test_what_a_design_is_remains_when_its_numbers_become_free():
    design = read(shipped_design("off-set-h1"))
    assert for_requirement(design) is design
    free = for_requirement(design, power=2.5e6)
    assert all(pair.pinion_teeth is None for pair in free.pairs.values())
    kept = for_engine(design, power=2.5e6)
    assert [pair.pinion_teeth for pair in kept.pairs.values()] == [15, 15, 15]
    assert free.teeth == kept.teeth
    assert free.machines == kept.machines
