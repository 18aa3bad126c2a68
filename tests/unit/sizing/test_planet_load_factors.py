"""K_γ by number of planets: as a single number where planets are given, weighed where their number is chosen."""

import pytest

from designs import ONE_SET, PAIR, changed, problem
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import edited, parse, read
from gearwright.study import for_requirement

SET = ONE_SET.format(speed=1400) + 'sun = "fast"\nring = "ground"\ncarrier = "slow"\n{}\n[gears]\n{}\n'
TABLE = "planet_load_factors = {{ 3 = 1.1, 4 = {}, 5 = {} }}"


def sized(planets, rules):
    return size(parse(SET.format(planets, rules)))


@pytest.mark.parametrize(("count", "factor"), [(3, 1.1), (4, 1.25), (5, 1.35)])
def test_the_factor_of_the_number_of_planets_is_that_of_a_single_one(count, factor):
    by_table = sized(f"planets = {count}", TABLE.format(1.25, 1.35))
    alone = sized(f"planets = {count}", f"mesh_load_factor = {factor}")
    assert by_table.meshes[0].load_factor == factor
    assert (by_table.mass, by_table.teeth) == (alone.mass, alone.teeth)
    assert by_table.search.gear_mass == pytest.approx(alone.search.gear_mass, rel=1e-12)


@pytest.mark.parametrize("factors", [(1.1, 1.1), (1.25, 1.35), (1.5, 2.0), (2.0, 1.2)])
def test_the_number_of_planets_is_the_lightest_with_the_factor_of_each(factors):
    """Brute force: each number given, with its own factor."""
    chosen = sized("", TABLE.format(*factors))
    masses = {n: sized(f"planets = {n}", TABLE.format(*factors)).gear_mass for n in (3, 4, 5)}
    assert chosen.design.planetaries["set"].planets == min(masses, key=masses.get)
    assert chosen.gear_mass == pytest.approx(min(masses.values()), rel=1e-12)


def test_uneven_sharing_of_more_planets_makes_fewer_lighter():
    even, uneven = (sized("", TABLE.format(*factors)) for factors in ((1.1, 1.1), (2.0, 2.5)))
    assert even.design.planetaries["set"].planets > uneven.design.planetaries["set"].planets == 3


def test_architectures_that_are_compared_choose_planets_by_their_table():
    """Of a requirement the planets are free, whatever the design gave: their factors are those of its rules."""
    design = read(shipped_design("in-line"))
    asked = {"power": 1e6, "engine_speed": 2000.0, "propeller_speed": 125.0}
    table = {"gears.planet_load_factors": {"3": 1.1, "4": 2.5, "5": 2.9}}
    even, uneven = (size(for_requirement(edited(design, changes), **asked)) for changes in ({}, table))
    assert max(stage.planets for stage in even.design.planetaries.values()) > 3
    assert {stage.planets for stage in uneven.design.planetaries.values()} == {3}


def test_compound_sets_have_the_factor_of_their_sets_and_pairs_their_own():
    design = read(shipped_design("geared-turbofan-star"))
    table = {"gears.planet_load_factors": {"5": 1.4}}
    assert {mesh.load_factor for mesh in size(edited(design, table)).meshes} == {1.4}
    text = f"{PAIR}[gears]\nmesh_load_factor = 1.2\nplanet_load_factors = {{ 3 = 1.7 }}\n"
    assert {mesh.load_factor for mesh in size(parse(text)).meshes} == {1.2}


@pytest.mark.parametrize(
    ("planets", "rules", "path", "words"),
    [
        ("planets = 4", "planet_load_factors = { three = 1.1, 4 = 1.2 }", "gears.planet_load_factors.three", "1 to 12"),
        ("planets = 4", "planet_load_factors = { 4 = 0.9 }", "gears.planet_load_factors.4", "from 1 to 3"),
        ("planets = 4", "planet_load_factors = { 3 = 1.1 }", "planetaries.set", "its 4 planets are"),
        ("", "planet_load_factors = { 7 = 1.1 }", "planetaries.set", "none of 2 to 5 planets"),
    ],
)
def test_a_table_without_what_is_asked_of_it_is_refused(planets, rules, path, words):
    found = problem(SET.format(planets, rules))
    assert found.path == path and words in found.message


def test_a_pair_with_a_table_of_its_own_is_told_that_nothing_reads_it():
    text = changed(PAIR, 'wheel = "slow"\n', 'wheel = "slow"\ngears = { planet_load_factors = { 3 = 1.2 } }\n')
    assert "only planetary sets" in problem(text).message
