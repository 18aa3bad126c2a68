"""Every requirement that the closure meets binds somewhere: left out there, the design fails its review by it."""

import pytest
from test_planet_bearings_chosen import SET

import mounted_designs
from designs import PAIR
from gearwright.checks import Status
from gearwright.closure import REQUIREMENTS, Outcome, Wishes, close, requirement_of
from gearwright.reviews import review
from gearwright.shipped import shipped_design
from gearwright.spec import design_text, edited, parse, read

HOUR = 3600.0
JAMMED = PAIR.replace(
    "[pairs.stage]",
    """\
[cases.rated.turbine]
rating = 1

[cases.jam]
static = true

[cases.jam.turbine]
power_kw = 110

[pairs.stage]""",
)
"""A turbine that pushes once harder than rated."""
OUT_OF_PLACE = """
[errors."set.planet-2"]
pin_tangential_um = 20
"""
"""A pin that stands ahead of its place, in a set none of whose members floats."""
FAST = {"turbines.turbine.speed_rpm": 15000, "propellers.propeller.speed_rpm": 5000}
SLOW = {"turbines.turbine.speed_rpm": 3000, "propellers.propeller.speed_rpm": 1000}
LONG = {
    "turbines.turbine.speed_rpm": 8000,
    "propellers.propeller.speed_rpm": 1800,
    "service.life_h": 20000,
    "service.bearing_life_h": 20000,
}
FEW = {"planetaries.set.sun_teeth": 35, "planetaries.set.planet_teeth": 43, "planetaries.set.ring_teeth": 121}
"""Planets of few teeth, in which a bearing that lives has no room but with costlier rollers."""
MANY = {"pairs.stage.pinion_teeth": 40, "pairs.stage.wheel_teeth": 119}
"""Small teeth, whose roots a jam breaks."""
SIXFOLD = {"planetaries.set.sun_teeth": 38, "planetaries.set.planet_teeth": 76, "planetaries.set.ring_teeth": 190}
"""Of a set that is clear of critical speeds."""
ISO = "gears.iso6336."
FINE = {f"{ISO}tolerance_class": 1, f"{ISO}pitting_safety": 1.0, "service.application_factor": 1.0}
CASES = {
    "flank": (PAIR, {}),
    "root": (PAIR, {f"{ISO}bending_safety": 5.0, f"{ISO}pitting_safety": 1.0}),
    "static strength": (JAMMED, {f"{ISO}static_bending_safety": 5.0, f"{ISO}pitting_safety": 1.0, **MANY}),
    "scuffing": (PAIR, {f"{ISO}scuffing_safety": 2.5, f"{ISO}tip_relief_um": 0.0, **FAST}),
    "teeth": (PAIR, {f"{ISO}widest_modules": 8}),
    "sharing": (f"{SET}{OUT_OF_PLACE}", {}),
    "peaks": (PAIR, FINE),
    "shafts": (PAIR, {}),
    "critical speeds": (PAIR, SLOW),
    "bearings": (SET, {**LONG, **FEW}),
}
"""Requirement -> a design in which it binds."""
BEARING = "planetaries.set.planet_bearing."
QUICK = LONG | {"turbines.turbine.speed_rpm": 12000, "propellers.propeller.speed_rpm": 2000}
ROTOR = PAIR.replace("[propellers.propeller]", "[rotors.main]").replace(
    "diameter_m = 2", "diameter_m = 2.6\nblades = 4"
)
WALL = """
[keep_out.wall]
reason = "a wall"
start = { x_mm = -500, y_mm = -500, z_mm = -500 }
end = { x_mm = 500, y_mm = -30, z_mm = 500 }
"""
SPLINED = mounted_designs.PAIR.replace(
    '[joints."helical.pinion"]\nkind = "integral"', '[joints."helical.pinion"]\nkind = "spline"'
)
KEYED = mounted_designs.PAIR.replace(
    '[joints."helical.wheel"]\nkind = "spline"', '[joints."helical.wheel"]\nkind = "key"\nform = "B"\nlength_mm = 14'
)
STUBBY = {"pairs.helical.pinion_shift": 0.2, "pairs.helical.pinion_teeth": 15, "pairs.helical.wheel_teeth": 59,
          f"{ISO}pitting_safety": 1.0, "gears.material": "18CrNiMo7-6"}  # fmt: skip
GIVEN = {
    "carriers": (SET, QUICK | {f"{BEARING}kind": "integral", f"{BEARING}life_h": 1, "service.static_safety": 0.5,
                               "planetaries.set.pin_diameter_mm": 20, "carriers.safety": 20, **SIXFOLD}),
    "machines": (ROTOR, {}),
    "room": (PAIR + WALL, {}),
    "housing": (PAIR, {"housing.fatigue_safety": 5.0, "housing.wall_mm": 1.5}),
    "joints": (KEYED, {}),
    "rims": (SPLINED, STUBBY),
    "making": (SPLINED, STUBBY),
}  # fmt: skip
"""Requirement that sizes do not move -> a design that gives what breaks it."""
CASES["room of planets"] = (SET, QUICK | {f"{BEARING}kind": "needle", f"{BEARING}width_mm": 30})
BESIDE = {"critical speeds", "shafts", "making", "rims"}
ELSEWHERE = {"life in flight", "others"}
"""Those that `test_closed_in_flight.py` has designs for, and the name of what no requirement covers."""


def closed(name, *left_out):
    """Return the design of a requirement, closed without some of them, and what fails in its review."""
    text, changes = CASES[name]
    design = edited(parse(text), {"gears.rating": "iso6336", **changes})
    wishes = Wishes(separate=name == "critical speeds", lighten=False, left_out=frozenset(left_out))
    found = close(design, wishes=wishes)
    return found, {requirement_of(check) for check in review(parse(design_text(found.design))).failing}


def test_every_requirement_has_a_design_in_which_it_binds():
    assert CASES.keys() | GIVEN.keys() | ELSEWHERE == REQUIREMENTS.keys()
    assert not CASES.keys() & GIVEN.keys()


@pytest.mark.parametrize("name", CASES)
def test_a_requirement_that_is_left_out_fails_in_the_review(name):
    _, failing = closed(name)
    _, without = closed(name, name)
    assert name not in failing
    assert name in without


@pytest.mark.parametrize("name", GIVEN)
def test_a_closure_that_does_not_look_calls_closed_what_the_review_fails(name):
    """What designs with bearings lack beside it is left out both times."""
    text, changes = GIVEN[name]
    design = edited(parse(text), {"gears.rating": "iso6336", **changes})
    beside = frozenset(BESIDE - {name} if design.bearings else ())
    told, blind = (close(design, wishes=Wishes(separate=False, lighten=False, left_out=left))
                   for left in (beside, beside | {name}))  # fmt: skip
    assert {row.requirement for row in told.unmet} == {name}
    assert blind.outcome is Outcome.CLOSED
    assert name in {requirement_of(check) for check in review(parse(design_text(blind.design))).failing}


@pytest.mark.parametrize("name", ["ec120b", "ec120b-as-reported", "in-line-h2-star", "off-set-h1-free"])
def test_every_check_that_a_review_assesses_belongs_to_a_requirement_by_name(name):
    judged = review(read(shipped_design(name))).checks
    unnamed = [check for check in judged if requirement_of(check) == "others"]
    assert [check.name for check in unnamed if check.status is not Status.NOT_ASSESSED] == []
