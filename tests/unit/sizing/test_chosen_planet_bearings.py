"""Bearings that sizing chooses for planets: room, life, film, mass, and what a smaller size would fail."""

import math

import pytest

from designs import ONE_SET, problem
from gearwright.catalogue import bearing, bearings
from gearwright.checks import Status
from gearwright.errors import DesignError
from gearwright.parts.bearings import BearingKind, ceramic_share, dynamic_rating, rolling_weights
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.bearing_seats import bearing_seats
from gearwright.sizing.losses import loss_balance
from gearwright.spec import edited, parse

near = pytest.approx
SET = (
    ONE_SET.format(speed=1200)
    + """\
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3
sun_teeth = 30
planet_teeth = 45
module_mm = 3
face_width_mm = 40
"""
)
BARE = parse(SET)
PATH = "planetaries.set.planet_bearing"
MADE = ("needle", "integral", "ceramic", "plain")
ANYTHING = {f"{PATH}.least_film_um": 0.5, f"{PATH}.largest_pressure_mpa": 50}


def sized(kind, **changes):
    """Return a set whose planets turn on a kind, with more keys of the bearing or of the design."""
    own = {key if "." in key else f"{PATH}.{key}": value for key, value in changes.items()}
    return size(edited(BARE, {f"{PATH}.kind": kind, **own}))


def planet(sizing):
    return next(gear for gear in sizing.gears if gear.name == "set.planet")


def judged(sizing):
    return {
        check.mode: check for check in sizing.checks if str(check.part) == "set.planet" and check.part.kind == "bearing"
    }


@pytest.mark.parametrize("kind", ["cylindrical", *MADE])
def test_what_is_chosen_has_room_serves_and_carries_its_pin(kind):
    sizing = sized(kind, **(ANYTHING if kind == "plain" else {}))
    assert {check.mode: check.status for check in judged(sizing).values() if check.status is Status.FAILS} == {}
    (carrier,) = sizing.carriers
    assert carrier.pin_diameter == planet(sizing).runs_on.pin_diameter
    assert carrier.pin_margin >= 1.0 - 1e-9


@pytest.mark.parametrize("kind", ["needle", "integral", "ceramic"])
def test_a_thinner_pin_would_live_too_short(kind):
    """A life that room allows governs: 2 % less on the pin, and the life fails."""
    sizing = sized(kind, life_h=6000)
    pin, life = planet(sizing).runs_on.pin_diameter, judged(sizing)["life"]
    assert life.ratio >= 1.0
    assert judged(sized(kind, life_h=6000, diameter_mm=980.0 * pin))["life"].fails


def test_a_film_under_a_thinner_pin_would_be_pressed_too_hard():
    keys = {"least_film_um": 0.5, "largest_pressure_mpa": 3}
    sizing = sized("plain", **keys)
    assert judged(sizing)["film pressure"].ratio == near(1.0, abs=0.01)
    pin = planet(sizing).runs_on.pin_diameter
    assert judged(sized("plain", **keys, diameter_mm=980.0 * pin))["film pressure"].fails


@pytest.mark.parametrize(("module", "film"), [(3.5, 10), (6, 8)])
def test_an_open_face_is_as_wide_as_the_film_of_the_planets_asks_to_the_millimetre(module, film):
    open_face = {"planetaries.set.face_width_mm": None, "planetaries.set.module_mm": module}
    design = edited(
        BARE, {**open_face, "gears.rating": "iso6336", f"{PATH}.kind": "plain", f"{PATH}.least_film_um": film}
    )
    taken = size(design)
    assert all(check.status is not Status.FAILS for check in taken.checks)
    width = round(1e3 * taken.gears[0].face_width)
    narrower = size(edited(design, {"planetaries.set.face_width_mm": width - 1}))
    failing = {check.name for check in narrower.checks if check.status is Status.FAILS}
    assert failing == {"set.planet film thickness"}


def test_the_first_bearing_of_the_catalogue_that_serves_is_the_smallest():
    """Every smaller outside that has room is named by hand, and none of them lives or holds its pin."""
    sizing = sized("cylindrical")
    taken = planet(sizing).runs_on.bearing
    smaller = [
        size.designation
        for size in bearings().values()
        if size.kind is BearingKind.CYLINDRICAL and size.outer_diameter < taken.outer_diameter and size.width <= 0.04
    ]
    assert smaller
    for name in smaller[-6:]:
        named = size(edited(BARE, {f"{PATH}.designation": name}))
        fails = [check for check in named.checks if check.fails and check.mode in ("life", "static safety")]
        assert fails or named.carriers[0].pin_diameter > bearing(name).bore


def test_a_planet_is_a_ring_with_what_turns_of_its_bearing():
    """π/4 (d² − D²) b ρ and m (d² + D²)/8; rollers, cage and outer ring swing with it. By hand."""
    gear = planet(sized("cylindrical"))
    made, density = gear.runs_on.bearing, 7850.0
    mass = math.pi / 4.0 * (gear.pitch_diameter**2 - made.outer_diameter**2) * 0.04 * density
    assert gear.mass == near(mass, rel=0.01)
    assert gear.inertia == near(gear.mass * (gear.pitch_diameter**2 + made.outer_diameter**2) / 8.0, rel=1e-9)
    inside = made.geometry
    rollers = inside.elements * math.pi / 4.0 * inside.diameter**2 * inside.roller_length * density
    raceway = inside.pitch_diameter + inside.diameter
    ring = math.pi / 4.0 * (made.outer_diameter**2 - raceway**2) * made.width * density
    assert gear.runs_on.turning_mass > rollers + ring
    assert gear.turning_mass == gear.mass + gear.runs_on.turning_mass


def test_what_turns_of_a_bearing_swings_its_planet():
    """m r ω²: of ring, rollers, cage and outer ring; with a mass of the user's, the bearing's parts still count."""
    for changes in ({}, {"planetaries.set.planet_mass_kg": 0.5}):
        sizing = sized("cylindrical", **changes)
        (seat,) = bearing_seats(sizing)
        gear, (carrier,) = planet(sizing), sizing.carriers
        assert seat.swung == near((gear.mass + gear.runs_on.turning_mass) * carrier.radius, rel=1e-12)
        speed = sizing.reference.speeds["slow"]
        assert carrier.centrifugal_force == near(seat.swung * speed**2, rel=1e-12)
    assert gear.mass == 0.5


@pytest.mark.parametrize("name", ["NU 206", "NU 210", "NU 2212", "NU 309", "NU 2310"])
def test_parts_of_a_bearing_weigh_what_the_catalogue_says(name):
    """Cylinders and a cage against steel over room as makers weigh it: within 12 %."""
    made = bearing(name)
    weights = rolling_weights(made.geometry, made.bore, made.outer_diameter, made.width)
    assert weights.total == near(made.mass, rel=0.12)


def test_rollers_fill_the_circle_and_are_rated_by_iso_281():
    made = planet(sized("integral", diameter_mm=40, roller_diameter_mm=10)).runs_on.bearing
    assert made.geometry.elements == math.floor(0.85 * math.pi / math.asin(10.0 / 50.0))
    assert (made.bore, made.outer_diameter) == near((0.040, 0.060))
    assert made.dynamic_rating == near(dynamic_rating(made.geometry), rel=1e-12)
    ceramic = planet(sized("ceramic", diameter_mm=40, roller_diameter_mm=10)).runs_on
    assert ceramic.bearing.dynamic_rating == near(ceramic_share() * made.dynamic_rating, rel=1e-12)
    assert ceramic.turning_mass < planet(sized("integral", diameter_mm=40, roller_diameter_mm=10)).runs_on.turning_mass


def test_a_thicker_pin_is_bored_to_the_same_strength():
    """1 − κ⁴ = (d_needed/d)³ until the wall is a tenth of the diameter."""
    (carrier,) = sized("plain", diameter_mm=90, **ANYTHING).carriers
    assert carrier.pin_bore == near(0.8 * 0.090)
    assert carrier.pin_margin > 1.0
    (slim,) = sized("plain", diameter_mm=8, **ANYTHING).carriers
    assert slim.pin_diameter > 0.008 and slim.pin_bore is None


def test_rims_that_are_stated_thinner_leave_more_room():
    """s_R = 1.0 h_t = 2.25 m below the roots, which lie 1.25 m inside the pitch circle: 135 − 2 · 3.5 · 3 mm."""
    sizing = sized("needle", **{"gears.rim_ratio": 1.0, "gears.rating": "iso6336"})
    (seat,) = bearing_seats(sizing)
    assert seat.room == near(0.135 - 2.0 * 3.5 * 0.003, rel=1e-9)


def test_a_film_loses_what_its_friction_does_and_a_flight_counts_it():
    sizing = sized("plain", **ANYTHING)
    loss = next(loss for loss in loss_balance(sizing).losses if loss.part == "set.planet")
    assert (loss.method, loss.count) == ("film", 3)
    journal, load = planet(sizing).runs_on.journal, sizing.carriers[0].pin_force
    spin = sizing.reference.speeds["set.planet"] - sizing.reference.speeds["slow"]
    friction = loss.power / 3.0 / (load * abs(spin) * journal.diameter / 2.0)
    assert 5e-4 < friction < 2e-2


def test_a_life_that_no_size_gives_is_told_with_what_would_help():
    check = judged(sized("needle", life_h=1e7))["life"]
    assert check.fails and "plain bearing" in check.why and "carrier" in check.why


def test_a_planet_without_room_is_refused_with_what_has():
    with pytest.raises(DesignError, match=r"planetaries\.set\.planet_bearing: no cylindrical .* thinner rims"):
        size(edited(BARE, {f"{PATH}.kind": "cylindrical", "planetaries.set.face_width_mm": 5}))


@pytest.mark.parametrize(
    ("keys", "path", "words"),
    [
        ('kind = "plain"\ndesignation = "NU 206"', "designation", "keep one of the two"),
        ('designation = "NU 206"\ndiameter_mm = 30', "diameter", "no effect on a bearing of the catalogue"),
        ('kind = "needle"\nclearance = 0.001', "clearance", "no effect on the kind needle"),
        ('kind = "plain"\nroller_diameter_mm = 4', "roller_diameter", "no effect on the kind plain"),
        ('kind = "plain"\nside_by_side = 2', "side_by_side", "stands alone"),
        ('kind = "integral"\nspacing_mm = 20', "spacing", "without a designation"),
        ('kind = "integral"\ndynamic_rating_kn = 20\nstatic_rating_kn = 20', "", "belong to a designation"),
    ],
)
def test_keys_without_effect_are_told(keys, path, words):
    found = problem(f"{SET}[planetaries.set.planet_bearing]\n{keys}\n")
    assert found.path == f"{PATH}.{path}".rstrip(".") and words in found.message


def test_compound_sets_ask_for_a_name():
    text = shipped_design("wolfrom-reducer").read_text(encoding="utf-8")
    found = problem(text.replace('meshes = ["sun", "held"]', 'meshes = ["sun", "held"]\nbearing = { kind = "plain" }'))
    assert found.path == "epicyclics.wolfrom.planets.wide.bearing.designation" and "compound sets" in found.message


def test_what_has_no_room_is_told_with_the_planets_that_have_it():
    """Half a millimetre of module leaves a bore of less than 30 mm, the outside of NU 200; a pin of 43 mm none has."""
    text = (
        ONE_SET.format(speed=1900) + 'sun = "fast"\nring = "ground"\ncarrier = "slow"\nplanets = 3\n'
        '[planetaries.set.planet_bearing]\nkind = "cylindrical"\n[overrides]\n'
    )
    small = problem(text + "set.module_mm = 0.7\nset.face_width_mm = 6\n", sized=True)
    assert small.path == "planetaries.set.planet_bearing"
    assert (
        "NU 200, 30 mm outside, has it with planets of" in small.message and "and a face of 9 mm; or" in small.message
    )
    narrow = problem(text + "set.module_mm = 3\nset.face_width_mm = 6\n", sized=True)
    assert "has it with a face of 9 mm; or" in narrow.message
    pin = problem(text + "set.pin_diameter_mm = 43\n", sized=True)
    assert pin.message.endswith("sits on a pin of 43 mm; the nearest are for 40 and 45 mm")
