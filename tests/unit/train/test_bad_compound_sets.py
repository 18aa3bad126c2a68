"""Compound sets that cannot be: planets that touch, pins that no triangle joins, locked and free sets, interference."""

from designs import changed, problems
from gearwright.sizing import size
from gearwright.spec import parse

RAVIGNEAUX = """\
schema = 1
name = "Ravigneaux"
level = "concept"
shafts = ["in", "out", "idle"]
turbines.engine = { shaft = "in", power_kw = 50, speed_rpm = 3000 }
propellers.load = { shaft = "out", speed_rpm = 1285.71, diameter_m = 2 }
layout.idle.diameter_mm = 20
[epicyclics.set]
carrier = "ground"
suns.small = { shaft = "in", teeth = 36 }
suns.large = { shaft = "idle", teeth = 42 }
rings.ring = { shaft = "out", teeth = 84 }
planets.short = { teeth = 21, meshes = ["small", "long"] }
planets.long = { teeth = 21, meshes = ["large", "ring"] }
"""
SIMPLE = """\
schema = 1
name = "one set"
level = "concept"
shafts = ["in", "out"]
turbines.engine = { shaft = "in", power_kw = 50, speed_rpm = 3000 }
propellers.load = { shaft = "out", speed_rpm = 810.81, diameter_m = 2 }
[epicyclics.set]
carrier = "out"
suns.sun = { shaft = "in", teeth = 20 }
rings.ring = { shaft = "ground", teeth = 54 }
planets.planet = { teeth = 17, meshes = ["sun", "ring"] }
"""


def rewritten(text, *passages):
    """Return a text with passages replaced, each old one followed by its new one."""
    for old, new in zip(passages[::2], passages[1::2], strict=True):
        text = changed(text, old, new)
    return text


def messages(text):
    """Return what is refused of a file, read and sized."""
    return [problem.message for problem in problems(text, sized=True)]


TWO_SETS = ("[epicyclics.set]", "[epicyclics.set]\nsets = 2")


def test_the_sets_as_they_are_can_be_sized():
    assert size(parse(RAVIGNEAUX)).reference.residual < 1e-12
    assert size(parse(rewritten(SIMPLE, *TWO_SETS))).reference.residual < 1e-12


def test_planets_of_a_pair_that_touch_are_refused_by_how_much():
    """Six pairs of 21 and 21 teeth stand in each other's way."""
    text = rewritten(RAVIGNEAUX, 'carrier = "ground"', 'carrier = "ground"\nsets = 6')
    assert any("short stands into long by 12 modules at the tips" in message for message in messages(text))


def test_planets_of_a_pair_whose_pins_no_triangle_joins_are_refused():
    """A sun and a short planet of 12 reach 12 modules, the long one's pin is at 31.5, and 16.5 join them: 3 too few."""
    text = rewritten(RAVIGNEAUX, "teeth = 36", "teeth = 12", "short = { teeth = 21", "short = { teeth = 12")
    assert any("they are 19.5 to 43.5 apart, and the teeth ask 16.5" in message for message in messages(text))


def test_neighbours_whose_tips_overlap_are_refused():
    """Planets of 40 on a sun of 20 have pins at 30 modules: six of them are 30 apart, and 42 across their tips."""
    text = rewritten(SIMPLE, "teeth = 54", "teeth = 100", "teeth = 17", "teeth = 40", "810.81", "500",
                     "[epicyclics.set]", "[epicyclics.set]\nsets = 6")  # fmt: skip
    assert any("planet stands into those of the next set by 12 modules" in message for message in messages(text))


def test_a_locked_set_names_the_machine_that_cannot_turn():
    text = rewritten(SIMPLE, 'suns.sun = { shaft = "in"', 'suns.sun = { shaft = "ground"', *TWO_SETS)
    text = rewritten(text, 'engine = { shaft = "in"', 'engine = { shaft = "out"', '["in", "out"]', '["out"]')
    text = rewritten(text, "speed_rpm = 3000", "speed_rpm = 810.81")
    assert any("the train locks it" in message for message in messages(text)), messages(text)


def test_a_free_set_is_refused_with_what_to_ground():
    text = rewritten(SIMPLE, 'rings.ring = { shaft = "ground"', 'rings.ring = { shaft = "idle"', *TWO_SETS)
    text = rewritten(text, '["in", "out"]', '["in", "out", "idle"]')
    assert any("All three members of set turn: ground one" in message for message in messages(text))


BESIDE = """\
schema = 1
name = "beside"
level = "concept"
shafts = ["in", "out"]
motors.motor = {{ shaft = "in", power_kw = 50, speed_rpm = 3000 }}
loads.load = {{ shaft = "out", speed_rpm = 1333.33 }}
[epicyclics.set]
carrier = "out"
sets = 2
suns.sun = {{ shaft = "in", teeth = 24{0} }}
rings.ring = {{ shaft = "ground", teeth = 78{1} }}
planets.inner = {{ teeth = 34, meshes = ["sun", "outer"]{0} }}
planets.outer = {{ teeth = 20, meshes = ["ring"]{2} }}
"""
"""The pin of ``inner`` is at (24 + 34)/2 = 29 modules, its tips reach 29 + 18 = 47, those of the ring stand at 38."""


def test_a_planet_that_stands_into_a_ring_that_it_does_not_mesh_is_refused_by_how_much():
    found = [problem for problem in problems(BESIDE.format("", "", "")) if "stands into ring" in problem.message]
    assert found[0].path == "epicyclics.set.planets.inner"
    assert "inner stands into ring by 9 modules at the tips; give inner fewer teeth" in found[0].message


def test_places_along_the_axis_say_what_lies_in_one_plane():
    """Faces of 10 mm overlap where their middles are less than 10 apart; without widths, places apart say nothing."""

    def apart(inner, ring, width=", face_width_mm = 10"):
        return BESIDE.format(f", place_mm = {inner}", f", place_mm = {ring}{width}", f", place_mm = {ring}")

    without_widths = [apart(20, ring, width="") for ring in (20, 30)]
    for text in (apart(20, 20), apart(20, 29.9), *without_widths):
        assert any("inner stands into ring" in problem.message for problem in problems(text))
    parse(apart(20, 30))


def test_modules_and_widths_of_gears_that_mesh_may_not_contradict_each_other():
    for key, what in (("module_mm", "module"), ("face_width_mm", "face width")):
        text = rewritten(SIMPLE, *TWO_SETS, "teeth = 20", f"teeth = 20, {key} = 2", "teeth = 54",
                         f"teeth = 54, {key} = 3", "teeth = 17", f"teeth = 17, {key} = 5")  # fmt: skip
        (found,) = problems(text)
        assert found.path == f"epicyclics.set.planets.planet.{key}"
        values = f"suns.sun.{key} = 2, rings.ring.{key} = 3, planets.planet.{key} = 5"
        assert f"have one {what}: {values}; give one value" in found.message
        parse(text.replace(f"{key} = 2", f"{key} = 5").replace(f"{key} = 3", f"{key} = 5"))


def test_tips_that_run_into_the_root_of_a_mate_are_refused_in_compound_sets():
    """Basic rack: tips stand 1 + k out, roots 1.25 deep, c = 0.25 − k modules: none is left at k = 0.25."""
    text = rewritten(SIMPLE, *TWO_SETS, "teeth = 20", "teeth = 20, module_mm = 3, tip_alteration = 0.3")
    (found,) = problems(text)
    assert found.path == "epicyclics.set.suns.sun.tip_alteration"
    assert "0.05 modules (0.15 mm) into the root of planet" in found.message
    assert "give tip_alteration = 0.249 or below" in found.message
    assert problems(text.replace("0.3 }", "0.25 }"))
    parse(text.replace("0.3 }", "0.249 }"))


def test_two_suns_in_one_place_are_refused_with_the_distance_that_they_need():
    """Faces of 10 mm on one axis need middles 10 mm apart."""

    def placed(large):
        return rewritten(RAVIGNEAUX, "teeth = 36", "teeth = 36, place_mm = 20, face_width_mm = 10",
                         "teeth = 42", f"teeth = 42, place_mm = {large}", 'teeth = 21, meshes = ["small"',
                         'teeth = 21, place_mm = 20, meshes = ["small"', 'teeth = 21, meshes = ["large"',
                         f'teeth = 21, place_mm = {large}, meshes = ["large"')  # fmt: skip

    (found,) = [problem for problem in problems(placed(26)) if problem.path.endswith("suns.large.place_mm")]
    assert "6 mm from that of small, on one axis" in found.message
    assert "at least 10 mm apart" in found.message
    parse(placed(30))
