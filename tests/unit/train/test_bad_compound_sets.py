"""Compound sets that cannot be: planets that touch, pins that no triangle joins, locked and free sets, interference."""

from designs import changed, problems
from gearwright.sizing import size
from gearwright.spec import parse

RAVIGNEAUX = """\
schema = 1
name = "Ravigneaux"
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
