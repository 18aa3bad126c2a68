"""Radial seals where shafts leave: which, where, how heavy, and what is said where none will do."""

import math

import pytest

import gearwright as gw
from gearwright.checks import Status
from gearwright.render.drawings.shaft_sheet import shaft_content
from gearwright.reviews import open_checks
from gearwright.sizing.making import built_checks
from gearwright.sizing.shafts import holders_of, seal_checks, sealed_exits, unsealed_exits
from gearwright.sizing.shafts.ends import exits_of
from gearwright.spec import edited
from shipped_work import BY_HAND, ball_bearings_of_the_tail, sized, text_of

RELIEF, LEAST_WALL = 2e-3, 4e-3
"""Depth of a cover over inner ring and cage, and the thinnest aluminium casting [m]."""


def with_(name=BY_HAND, **changes):
    return gw.size(edited(gw.parse(text_of(name)), {key.replace("__", "."): value for key, value in changes.items()}))


def test_every_end_of_the_helicopters_gearbox_that_leaves_has_a_seal():
    sealed = {one.leaves.machine: one.seal.designation for one in sealed_exits(sized(BY_HAND))}
    assert sealed == {
        "arrius-2f": "DIN 3760 - A 30 x 42 x 7 - FKM", "main-rotor": "DIN 3760 - A 75 x 95 x 10 - FKM",
        "oil-pump": "DIN 3760 - A 10 x 22 x 7 - FKM", "tail-drive": "DIN 3760 - A 20 x 35 x 7 - FKM",
    }  # fmt: skip
    assert unsealed_exits(sized(BY_HAND)) == ()
    left = [(str(check.part), check.mode) for check in seal_checks(sized(BY_HAND)) if check.status is not Status.PASSES]
    assert left == [("main-rotor", "seal hardness")]  # no teeth of one piece with the mast are case-hardened


def test_the_mast_is_as_thick_as_its_bearing_under_the_seal_and_thinner_beyond():
    """71 mm carry the rotor, for which there is no seal: 75 mm as far as the bearing is wide."""
    mast = next(shaft for shaft in sized(BY_HAND).built_shafts if shaft.name == "mast")
    bearing = next(step for step in mast.steps if step.seat == "mast-upper")
    seat, beyond = (step for step in mast.steps if bearing.end - 1e-9 < step.start < 0.42)
    assert seat.diameter == pytest.approx(0.075) and beyond.diameter == pytest.approx(0.071)
    assert seat.end - seat.start == pytest.approx(bearing.end - bearing.start)
    bare = next(shaft for shaft in with_(shafting__seal="none").built_shafts if shaft.name == "mast")
    assert not [step for step in bare.steps if step.start > bearing.end - 1e-9 and step.diameter > 0.0711]


def test_a_seal_lies_behind_the_plate_of_its_cover_beyond_what_turns():
    """The tail shaft: a ring of 1.2 mm, 1 mm of air, 4 mm of plate; then 7 mm of seal in a bore 0.3 mm deeper."""
    sizing = sized(BY_HAND)
    bearing = next(bearing for bearing in sizing.bearings if bearing.name == "tail-rear")
    cover, seal = (
        next(holder for holder in holders_of(sizing) if holder.beside == "tail-rear" and holder.kind == kind)
        for kind in ("cover", "radial seal")
    )
    face = bearing.position + bearing.width / 2.0
    hollow, plate, boss = cover.rings
    assert (hollow.start, hollow.end) == pytest.approx((face, face + 1.2e-3 + 1e-3))
    assert plate.end - plate.start == pytest.approx(LEAST_WALL)
    assert (seal.start, seal.end) == pytest.approx((plate.end, plate.end + 7e-3)) and seal.lip == -1
    assert (boss.bore, boss.outer) == pytest.approx((0.035, 0.035 + 2.0 * LEAST_WALL))
    assert boss.end == pytest.approx(seal.end + 0.3e-3)
    assert plate.bore == pytest.approx(0.035 - 3e-3)  # the step that the seal is pressed against
    volume = sum(math.pi / 4.0 * (ring.outer**2 - ring.bore**2) * (ring.end - ring.start) for ring in cover.rings)
    assert cover.mass == pytest.approx(2700.0 * volume, rel=0.04)  # aluminium


def test_screws_of_a_cover_have_room_beside_its_boss():
    for cover in (holder for holder in holders_of(sized(BY_HAND)) if holder.stepped):
        boss = min(ring.outer for ring in cover.rings)
        screw = 1e-3 * float(cover.designation.split("M")[1].split(",")[0])
        assert cover.outer - 2.5 * screw - boss >= 1.5 * screw - 1e-9  # circle less boss: a head of 1.5 d between


def test_a_bearing_that_slides_keeps_its_air_beside_a_cover_that_only_seals():
    sizing = gw.size(gw.parse(ball_bearings_of_the_tail()))
    bearing = next(bearing for bearing in sizing.bearings if bearing.name == "tail-front")
    cover = next(holder for holder in holders_of(sizing) if holder.beside == "tail-front" and holder.kind == "cover")
    assert bearing.position - bearing.width / 2.0 - cover.end == pytest.approx(1e-3)
    assert cover.force == 0.0


def test_nitrile_is_taken_where_the_oil_is_cool_and_the_lip_slow():
    """SKF: 4.1 m/s on 20 mm, 8.6 m/s from 60 mm on, 100 °C, of which the lip takes 20 K."""
    marks = {one.machine: one.elastomer.mark for one in exits_of(with_(oil__temperature=75.0))}
    assert marks == {"arrius-2f": "FKM", "main-rotor": "NBR", "oil-pump": "FKM", "tail-drive": "FKM"}
    assert {one.elastomer.mark for one in exits_of(with_(oil__temperature=81.0))} == {"FKM"}


def test_a_lip_that_is_asked_for_and_does_not_suit_fails():
    failing = {(str(check.part), check.mode) for check in seal_checks(with_(shafting__seal="nbr")) if check.fails}
    assert failing == {
        ("arrius-2f", "seal speed"), ("oil-pump", "seal speed"), ("tail-drive", "seal speed"),
        ("arrius-2f", "seal temperature"), ("oil-pump", "seal temperature"), ("tail-drive", "seal temperature"),
        ("main-rotor", "seal temperature"),
    }  # fmt: skip


def test_sheets_of_shafts_say_what_is_asked_under_the_lips():
    """h11 on the stretch, its deviations, a case where the teeth have one, and no lead."""
    for name, fit, lower, hard in (("input", "Ø30 h11", "-130", "55 HRC"), ("mast", "Ø75 h11", "-190", "45 HRC")):
        content = shaft_content(sized(BY_HAND), name)
        fits = next(grid for grid in content.grids if grid.title.startswith("Fits"))
        assert (fit, "0", lower) in fits.rows
        (note,) = (note for note in content.notes if note.startswith("Under the seal"))
        assert "Ra 0.2 to 0.8" in note and "without lead" in note and hard in note
        hardened = [row for grid in content.grids if grid.title.startswith("Case-hardened") for row in grid.rows]
        assert any("under the seal" in row[1] for row in hardened) == (name == "input")  # the mast has no teeth


def test_no_seal_is_a_choice_and_leaves_the_estimate():
    sizing = with_(shafting__seal="none")
    assert sealed_exits(sizing) == () and len(unsealed_exits(sizing)) == 4
    weights = {item.part: item.each for item in gw.complete_mass(sizing).parts}
    assert weights["arrius-2f seal"] == pytest.approx(40.0 * 0.030**2)
    assert not [
        name for name in (item.part for item in gw.complete_mass(sized(BY_HAND)).parts) if name == "arrius-2f seal"
    ]


def test_what_no_lip_bears_is_said_with_what_is_usual_and_nothing_is_drawn():
    sizing = sized("in-line-h2")
    told = {str(check.part): check.why for check in open_checks(sizing, (), flown=False) if check.mode == "shaft seal"}
    assert "24.6 m/s on 23.5 mm" in told["gas-turbine"] and "carbon face seal" in told["gas-turbine"]
    assert set(told) == {"gas-turbine"}  # what a lip bears is sized with the bearings of its shaft
    propeller = next(one for one in unsealed_exits(sizing) if one.machine == "propeller")
    assert "a lip of FKM bears 27.2 m/s; shafts with [bearings] get seals" in propeller.lacking
    assert not [holder for holder in holders_of(sizing) if holder.lip] and not list(seal_checks(sizing))
    weights = {item.part: item.each for item in gw.complete_mass(sizing).parts}
    assert weights["gas-turbine seal"] == pytest.approx(40.0 * 0.02349**2, rel=1e-3)


def test_a_shaft_as_given_for_which_there_is_no_seal_says_the_next():
    sizing = with_("ec120b-as-reported", layout__mast__diameter_m=0.061)
    told = {str(check.part): check.why for check in open_checks(sizing, (), flown=False) if check.mode == "shaft seal"}
    assert set(told) == {"main-rotor"}
    assert "no seal for 61 mm, the next is for 65 mm: make the shaft that thick there" in told["main-rotor"]


def test_a_gearbox_in_the_housing_of_another_has_no_seals_of_its_own():
    assert exits_of(sized("geared-turbofan-star")) == ()


def test_what_sits_too_near_to_a_bearing_leaves_no_room_under_the_lip():
    sizing = with_(layout__input__places={**_places(), "arrius-2f": {"position": 0.036}})
    failing = {check.mode: check for check in seal_checks(sizing) if str(check.part) == "arrius-2f" and check.fails}
    assert set(failing) == {"seal seat"} and "further out" in failing["seal seat"].why
    assert failing["seal seat"].value == pytest.approx(0.0665 - 0.056)
    assert failing["seal seat"] in list(built_checks(sizing))


def _places():
    layout = gw.parse(text_of(BY_HAND)).layout["input"]
    return {name: place.model_dump() for name, place in layout.places.items()}
