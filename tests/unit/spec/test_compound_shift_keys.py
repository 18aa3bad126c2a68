"""Profile shifts of compound sets as a design file gives them: what follows from what, and what is refused."""

import pytest

from designs import changed, problem, problems
from gearwright.spec import parse
from gearwright.spec.design import compound_shifts

SET = """\
schema = 1
name = "stepped"
level = "concept"
shafts = ["fast", "slow", "cage"]
motors.motor = { shaft = "fast", power_kw = 1, speed_rpm = 3000, balances = false }
loads.drum = { shaft = "slow", speed_rpm = 18.5185 }
[epicyclics.set]
carrier = "cage"
sets = 3
suns.sun = { shaft = "fast", teeth = 12, module_mm = 1 }
rings.held = { shaft = "ground", teeth = 84 }
rings.turned = { shaft = "slow", teeth = 81 }
planets.wide = { teeth = 36, meshes = ["sun", "held"] }
planets.narrow = { teeth = 33, meshes = ["turned"], in_one_piece_with = "wide" }
[gears]
pressure_angle_deg = 25
"""
"""All three meshes want the pin at 24 mm."""


RINGS = """\
schema = 1
name = "rings"
level = "concept"
shafts = ["fast", "slow"]
motors.motor = {{ shaft = "fast", power_kw = 1, speed_rpm = 3000, balances = false }}
loads.drum = {{ shaft = "slow", speed_rpm = 30 }}
[gears]
pressure_angle_deg = {}
[epicyclics.set]
carrier = "fast"
sets = 1
planets.wide = {{ teeth = {}, meshes = ["held"] }}
rings.held = {{ shaft = "ground", teeth = {} }}
planets.narrow = {{ teeth = {}, meshes = ["turned"], in_one_piece_with = "wide" }}
rings.turned = {{ shaft = "slow", teeth = {} }}
"""
"""A stepped planet on a crank between two rings."""


def with_keys(*keys, rules=""):
    """Return the set with further keys of its gears, each as gear and text."""
    text = SET
    for gear, key in keys:
        line = next(line for line in text.splitlines() if f".{gear} = " in line)
        text = changed(text, line, line.replace(" }", f", {key} }}"))
    return text + rules


def shifts_of(text):
    return compound_shifts(parse(text), "set")


def test_nothing_said_of_shift_is_no_shift():
    shifts = shifts_of(SET)
    assert all(gear == (0.0, 0.0) for gear in shifts.gears.values())
    assert all(mesh.centre is None for mesh in shifts.meshes.values())


def test_a_rules_shift_is_that_of_suns_and_rings_and_planets_have_its_opposite():
    """As in simple sets: suns and rings +0.2, planets −0.2, and no pin moves; of a step without a sun, too."""
    shifts = shifts_of(with_keys(rules="profile_shift = 0.2\n"))
    assert {name: gear.profile_shift for name, gear in shifts.gears.items()} == {
        "sun": 0.2, "held": 0.2, "turned": 0.2, "wide": -0.2, "narrow": -0.2,
    }  # fmt: skip
    assert all(mesh.centre is None for mesh in shifts.meshes.values())


def test_one_shift_leaves_its_opposite_to_the_mates_of_its_step_alone():
    shifts = shifts_of(with_keys(("wide", "shift = -0.3"), rules="profile_shift = 0.1\n"))
    assert {name: round(gear.profile_shift, 12) for name, gear in shifts.gears.items()} == {
        "sun": 0.3, "held": 0.3, "turned": 0.1, "wide": -0.3, "narrow": -0.1,
    }  # fmt: skip


def test_two_shifts_of_one_step_put_the_pin_where_the_other_step_follows():
    """x_s + x_p = 0.5 moves the pin outwards; all four meshes then stand at that distance."""
    shifts = shifts_of(with_keys(("sun", "shift = 0.3"), ("wide", "shift = 0.2"), ("narrow", "module_mm = 1")))
    centres = {mesh: own.centre for mesh, own in shifts.meshes.items()}
    assert centres["sun-wide"] > 24.4
    assert len({round(centre, 9) for centre in centres.values()}) == 1
    assert shifts.gears["sun"].tip_alteration == pytest.approx(centres["sun-wide"] - 24.0 - 0.5)
    assert shifts.gears["narrow"].profile_shift != 0.0


def test_a_centre_distance_is_that_of_all_steps_on_its_pin():
    shifts = shifts_of(with_keys(("narrow", "centre_distance_mm = 24.2")))
    assert [mesh.centre for mesh in shifts.meshes.values()] == pytest.approx([24.2, 24.2, 24.2])


def test_one_planet_in_two_rings_of_other_teeth_closes_by_shifts():
    """Wolfrom's rings on one planet: 24, 24 and 22.5 modules by 12/36/84 and 81 teeth; the pin stands at 23.5."""
    one = changed(SET, 'meshes = ["sun", "held"]', 'meshes = ["sun", "held", "turned"]')
    lines = [line for line in one.splitlines(keepends=True) if "narrow" not in line]
    one = changed("".join(lines), "teeth = 12", "teeth = 18").replace("teeth = 84", "teeth = 90")
    one = changed(one, "teeth = 81", "teeth = 87").replace("18.5185", "16.6667")
    shifts = compound_shifts(parse(one.replace("16.6667", "17.2414")), "set")
    assert [mesh.centre for mesh in shifts.meshes.values()] == pytest.approx([26.5, 26.5, 26.5])


@pytest.mark.parametrize(
    ("text", "path", "words"),
    [
        (with_keys(("sun", "shift = 1.2")), "suns.sun.shift", ("points 12 teeth", "give at most")),
        (with_keys(("sun", "shift = -0.4")), "suns.sun.shift", ("undercuts 12 teeth", "at least")),
        (with_keys(("sun", "shift = 0.3"), ("wide", "shift = -0.3"), ("held", "shift = 0.5")),
         "rings.held.shift", ("rings.held.shift = 0.5 and planets.wide.shift = -0.3 close at",
                              "give rings.held.shift = 0.3000, or leave one of them out")),
        (with_keys(("narrow", "centre_distance_mm = 30")), "planets.narrow.centre_distance_mm",
         ("it asks x_1 + x_2", "reach 21.95 to 26.51 modules")),
        (with_keys(("narrow", "centre_distance_mm = 20")), "planets.narrow.centre_distance_mm",
         ("base circles roll on each",)),
        (with_keys(("narrow", "centre_distance_mm = 24.1"), ("wide", "centre_distance_mm = 24.2")),
         "planets.narrow.centre_distance_mm", ("on the same pin",)),
        (changed(with_keys(("narrow", "centre_distance_mm = 24.1")), ", module_mm = 1", ""),
         "planets.narrow.centre_distance_mm", ("only with a module",)),
        (changed(SET, "teeth = 33", "teeth = 42, module_mm = 1"), "planets.wide",
         ("want the pin at different distances", "held-wide 24, turned-narrow 19.5", "on their mean")),
        (RINGS.format(20, 18, "69, tip_alteration = 0", 18, 69), "rings.held.teeth",
         ("dig 0.072 modules past the involute", "tip_alteration = -0.073", "teeth")),
        (RINGS.format(20, 40, 44, 20, 60), "rings.held.teeth", ("trochoidal interference", "or ", "teeth")),
    ],
)  # fmt: skip
def test_shifts_that_make_no_gears_are_refused_with_what_would(text, path, words):
    found = problem(text)
    assert found.path == f"epicyclics.set.{path}"
    assert all(word in found.message for word in words), found.message


FOUR = """\
schema = 1
name = "four planets"
level = "concept"
shafts = ["fast", "slow"]
motors.motor = {{ shaft = "fast", power_kw = 1, speed_rpm = 600, balances = false }}
loads.drum = {{ shaft = "slow", speed_rpm = 100 }}
[epicyclics.set]
carrier = "slow"
sets = 4
suns.sun = {{ shaft = "fast", teeth = 32 }}
rings.ring = {{ shaft = "ground", teeth = 160 }}
planets.planet = {{ teeth = 64, meshes = ["sun", "ring"]{} }}
"""


def test_teeth_whose_tips_lie_below_their_base_circle_are_refused_as_undercut():
    """6 teeth of x = −1.5 have r_a = 2.5 m below r_b = 2.82 m: no involute, which once was no answer either."""
    found = problems(RINGS.format(20, "6, shift = -1.5", 43, 20, 60))
    assert any("-1.5 undercuts 6 teeth" in each.message for each in found)


def test_planets_that_only_touch_with_their_shifted_tips_are_refused():
    """Four planets of 64 about a sun of 32: 96 sin 45° = 67.88 above 66; tips of 2 (32 + 1 + 0.8 + 0.2) = 68 touch."""
    parse(FOUR.format(""))
    parse(FOUR.format(", shift = 0.8"))
    found = problem(FOUR.format(", shift = 0.8, tip_alteration = 0.2"))
    assert found.path == "epicyclics.set.planets.planet"
    assert "stands into those of the next set by 0.12 modules" in found.message


def test_a_shift_closes_a_set_that_whole_teeth_put_together_all_the_same():
    """Whether equal sets go in is asked of teeth alone: (32 + 159)/4 is not whole, whatever the shifts."""
    text = FOUR.format("").replace("teeth = 160", "teeth = 159").replace("speed_rpm = 100", "speed_rpm = 100.52")
    assert "cannot be assembled" in problem(text).message


def test_what_is_told_of_contradicting_shifts_moves_no_pin():
    """Sun and planet have 0.3 + 0.1; the ring's shift is then −0.4 − 0.1, whatever planets the sun has put."""
    keys = ("sun", "shift = 0.3"), ("wide", "shift = 0.1")
    found = problem(with_keys(*keys, ("held", "shift = 0.5")))
    assert found.path == "epicyclics.set.rings.held.shift"
    assert "give rings.held.shift = -0.5000" in found.message
    parse(with_keys(*keys, ("held", "shift = -0.5")))


def test_fewer_sets_are_advised_only_where_there_are_some_and_one_is_one():
    """20 + 83 = 103 is prime, so that one planet alone has room for its teeth; one of a chain stands into the sun."""
    sets = """
suns.sun = { shaft = "fast", teeth = 20, module_mm = 1 }
rings.held = { shaft = "ground", teeth = 83 }
"""
    head = SET[: SET.index("\nsuns.sun")].replace('"slow", "cage"', '"cage"').replace('"slow"', '"cage"')
    alone = head + sets + 'planets.wide = { teeth = 31, meshes = ["sun", "held"] }\n'
    assert any("give 1 set;" in f"{found.message};" for found in problems(alone))
    chain = 'planets.a = { teeth = 30, meshes = ["sun", "b"] }\nplanets.b = { teeth = 30, meshes = ["held", "a"] }\n'
    chain = changed(head, "sets = 3", "sets = 1") + changed(sets, "83", "80") + chain
    told = [found.message for found in problems(chain) if "stands into" in found.message]
    assert told
    assert not any("fewer sets" in message for message in told)
