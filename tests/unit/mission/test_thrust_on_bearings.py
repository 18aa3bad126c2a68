"""Thrust of propellers and rotors goes to bearings that hold their shaft in the housing, never into planets."""

import pytest

from gearwright.catalogue import bearings
from gearwright.mission import durability, fly
from gearwright.mission.lives import seat_duties
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.bearing_seats import bearing_seats
from gearwright.spec import parse, parse_mission

THRUST, DIAMETER = 20e3, "diameter_m = 3.93"
IN_LINE = shipped_design("in-line").read_text(encoding="utf-8")
SET = IN_LINE + '\n[planetaries.second.planet_bearing]\ndesignation = "NU 2212"\n'
SHAFT = """
[layout.output]
length_mm = 400
places.propeller.position_mm = 390
places."second.carrier".position_mm = 20
[bearings.rear]
shaft = "output"
position_mm = 100
[bearings.nose]
shaft = "output"
position_mm = 300
kind = "deep-groove"
"""
MISSION = """
schema = 1
name = "steady"
propeller_map = "none"
[engine]
thermal_power_kw = 5000
[phases.one]
altitude_ft = 0
tas_kt = 100
duration_min = 60
power_kw = 1500
propeller_speed_rpm = 1212
"""
CHOSEN = "[bearings]\nlife_h = 3000\n"


def flown(text, thrust="thrust_kn = 20\n", more="", asks=""):
    """Return the flight of the set with a propeller that pulls."""
    design = text.replace(DIAMETER, f"{DIAMETER}\n{thrust}{more}")
    return fly(size(parse(design)), parse_mission(MISSION + asks))


def test_a_propeller_s_thrust_goes_past_the_bearings_in_planets():
    """The usual bearings of the shaft that the planets' carrier is part of bear it; the planets' rollers could not."""
    flight = flown(SET, more="hub_moment_nm = 2000\n", asks=CHOSEN)
    along = {seat.name: duty.axial for seat, duty in seat_duties(flight)}
    assert along["second.planet"].max() == 0.0
    assert sum(along[name] for name in ("output.first", "output.second")) == pytest.approx(THRUST, rel=1e-9)
    notes = durability(flight).notes
    assert any("output: up to 20000 N of thrust, and the design describes no bearing of it" in note for note in notes)


def test_a_thrust_that_no_bearing_is_there_for_is_told_and_rated_nowhere():
    """A shaft that nothing bends has no bearings of its own: what is missing is said, and planets keep their lives."""
    found = durability(flown(SET))
    (loose,) = found.bearings.loose
    assert "where it goes is not assessed" in loose
    assert '[bearings.NAME] with shaft = "output", one of them with locates = "both"' in loose
    assert [row.seat for row in found.bearings.rows] == ["second.planet"]


def test_a_chosen_bearing_has_the_bore_of_its_shaft_whatever_it_then_lives():
    """The next bore of the catalogue from the shaft's diameter on: no larger one, and no shaft that is not there."""
    flight = flown(SET, more="hub_moment_nm = 2000\n", asks=CHOSEN)
    seats = {seat.name: seat for seat in bearing_seats(flight.sizing)}
    found = durability(flight)
    chosen = [row for row in found.bearings.rows if row.asked is not None and row.holds_shaft]
    assert {"output.first", "output.second"} == {row.seat for row in chosen}
    for row in chosen:
        bores = [size.bore for size in bearings().values() if size.kind is row.bearing.kind]
        assert row.bearing.bore == min(bore for bore in bores if bore >= seats[row.seat].bore)
    short = {row.seat for row in chosen if row.falls_short}
    assert short == {note.split(":")[0] for note in found.notes if "its bore is the shaft's" in note}


def test_a_design_whose_bearings_locate_has_nothing_to_be_told():
    built = SET.replace('level = "concept"', 'level = "built"')
    flight = flown(built + SHAFT + 'locates = "both"\n')
    along = {seat.name: duty.axial for seat, duty in seat_duties(flight)}
    assert along["nose"] == pytest.approx(THRUST, rel=1e-9)
    assert along["rear"].max() == along["second.planet"].max() == 0.0
    assert not durability(flight).bearings.loose
