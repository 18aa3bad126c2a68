"""Bearings in flight: loads from the meshes, lives over the spectrum, and bearings that are chosen or named."""

import dataclasses
import math

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.mission import bearing_lives, fly
from gearwright.mission.lives import seat_duties
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.airscrew_loads import usual_loads
from gearwright.sizing.bearing_seats import bearing_seats, seat_forces
from gearwright.spec import parse, parse_mission, read
from shipped_work import flown, lives, sized

STEADY = """
schema = 1
name = "steady"
propeller_map = "none"
[engine]
thermal_power_kw = 5000
[bearings]
life_h = 3000
[phases.one]
altitude_ft = 0
tas_kt = 100
duration_min = 60
power_kw = 1500
propeller_speed_rpm = 1212
"""
OFF_SET = shipped_design("off-set").read_text(encoding="utf-8").replace('level = "concept"', "", 1)
SEATS = """
[service]
bearing_life_h = 1000
[layout.output]
length_mm = 200
[layout.output.places."second.wheel"]
position_mm = 100
[bearings.nose]
shaft = "output"
position_mm = 30
kind = "four-point"
locates = "both"
[bearings.tail]
shaft = "output"
position_mm = 175
"""
PLANETS = (
    shipped_design("in-line").read_text(encoding="utf-8") + "\n[planetaries.second.planet_bearing]\ndesignation = {}\n"
)


def second_planet(flight):
    """Return the row of the second stage's planets."""
    return next(row for row in bearing_lives(flight).rows if row.seat == "second.planet")


@pytest.mark.parametrize("name", ["off-set", "mixed", "in-line-h2", "face-gear-split-torque", "star"])
def test_seats_bear_in_the_sized_case_what_the_sizing_says(name):
    """Unit loads superposed against the reactions of the case that governs: equal but for rounding, 1e-9."""
    sizing = size(read(shipped_design(name)))
    sized = {f"{shaft.name}.{end}": (shaft.case, load.radial_force) for shaft in sizing.shafts
             for end, load in zip(("first", "second"), shaft.bearings, strict=False)}  # fmt: skip
    sized |= {f"{each.stage}.planet": (each.case, each.pin_force) for each in sizing.carriers}
    for seat in bearing_seats(sizing):
        case, expected = sized[seat.name]
        flow = sizing.flows[case]
        torques = np.array([flow.meshes[mesh.name].torques[0] / mesh.count for mesh in sizing.train.meshes])
        radial, _ = seat_forces(seat, torques, np.array(flow.speeds[seat.carrier]))
        assert float(radial) == pytest.approx(expected, rel=1e-9, abs=1e-6)


def test_a_steady_flight_has_the_life_of_the_closed_form():
    """ISO 281: L = (C/P)^(10/3) 10⁶ turns at one load and one speed; 1e-9, as nothing changes over the flight."""
    flight = fly(size(read(shipped_design("off-set"))), parse_mission(STEADY))
    row = next(each for each in bearing_lives(flight).rows if each.seat == "left.second")
    hours = (row.bearing.dynamic_rating / row.mean_load) ** (10 / 3) * 1e6 * 2 * math.pi / row.mean_speed / 3600
    assert row.life == pytest.approx(hours, rel=1e-9)
    assert row.falls_short == (row.life < 3000.0)


def test_damage_of_two_phases_is_the_sum_of_both():
    """Miner 1945: linear in time; 1e-6 for the losses, which follow the interval before."""
    sizing = size(parse(PLANETS.format('"NU 2309"')))
    less, phase = STEADY.replace("1500", "1000"), STEADY.index("[phases.one]")
    both = STEADY + less[phase:].replace("phases.one", "phases.two")
    one, other, sum_ = (second_planet(fly(sizing, parse_mission(text))).damage for text in (STEADY, less, both))
    assert sum_ == pytest.approx(one + other, rel=1e-6)


def test_a_thrust_goes_to_the_bearing_with_the_smaller_radial_force():
    flight = fly(size(read(shipped_design("off-set"))), parse_mission(STEADY))
    duties = {seat.name: duty for seat, duty in seat_duties(flight)}
    assert duties["left.first"].axial.min() > 0.0
    assert duties["left.second"].axial.max() == 0.0
    assert duties["left.first"].radial.max() < duties["left.second"].radial.min()


@pytest.mark.parametrize("turning", [0.0, 1.0])
def test_a_bearing_that_bears_load_only_while_it_stands_is_chosen_by_its_static_safety(turning):
    """Nothing tires it, whether it never turns or turns without load."""
    flight = fly(
        size(read(shipped_design("off-set"))), parse_mission(STEADY.replace("= 3000", "= 3000\nstatic_safety = 3"))
    )
    turns = turning * (np.arange(len(flight.phase)) % 2)
    nodes = {name: dataclasses.replace(node, speed=node.speed * turns) for name, node in flight.nodes.items()}
    meshes = {
        name: dataclasses.replace(mesh, torque=mesh.torque * (turns == 0.0)) for name, mesh in flight.meshes.items()
    }
    found = bearing_lives(dataclasses.replace(flight, nodes=nodes, meshes=meshes))
    assert {"left.first", "left.second"} <= {row.seat for row in found.rows}
    for row in found.rows:
        assert row.damage == 0.0
        assert row.static_safety >= 3.0


def test_a_named_bearing_keeps_its_makers_rating():
    ratings = '"NU 2309"\ndynamic_rating_kn = 200\nstatic_rating_kn = 230'
    mission = parse_mission(STEADY.replace("[bearings]\nlife_h = 3000\n", ""))
    found = bearing_lives(fly(size(parse(PLANETS.format(ratings))), mission))
    assert [row.seat for row in found.rows] == ["second.planet"]
    assert found.rows[0].bearing.dynamic_rating == 200e3
    assert found.notes == ("first.planet: no bearing is named, and the mission has no [bearings] to choose one",)


def test_two_bearings_side_by_side_live_longer_by_the_rule_of_iso_281():
    """7.1.2: C grows by 2^(7/9), so that the life grows by 2^(70/27) = 6.03; two swing more, the life falls with the
    power 10/3 of the load; 1e-9."""
    sizings = (size(parse(PLANETS.format(each))) for each in ('"NU 2309"', '"NU 2309"\nside_by_side = 2'))
    one, two = (second_planet(fly(sizing, parse_mission(STEADY))) for sizing in sizings)
    heavier = two.mean_load / one.mean_load
    assert 1.0 < heavier < 1.2
    assert two.life / one.life == pytest.approx(2 ** (70 / 27) / heavier ** (10 / 3), rel=1e-9)
    assert two.count == 2 * one.count


def test_bearings_of_the_design_live_in_steady_flight_as_their_sizing_says():
    """The powers of the rated case, which is all of the service: P of the sizing; 2 % for the meshes' losses."""
    sizing = size(parse(OFF_SET + SEATS))
    flight = fly(sizing, parse_mission(STEADY.replace("1500", "2051")))
    rows = {row.seat: row for row in bearing_lives(flight).rows}
    assert {"nose", "tail"} <= rows.keys()
    assert "output.first" not in rows
    for bearing in sizing.bearings:
        row = rows[bearing.name]
        assert row.bearing == bearing.bearing
        assert row.mean_load == pytest.approx(bearing.equivalent_load, rel=0.02)


def test_the_thrust_of_the_map_loads_the_bearing_that_locates_the_propeller():
    """The helix pushes the output shaft one way and the thrust pulls the other: their difference, by hand; 1e-9.

    The flight without a map has the thrust of the design, which is stated as none.
    """
    none = "thrust_n = 0\nin_plane_force_n = 0\nhub_moment_nm = 0\n"
    sizing = size(parse(OFF_SET.replace("blades = 6\n", f"blades = 6\n{none}", 1) + SEATS))
    mapped = STEADY.replace('propeller_map = "none"\n', "").replace("tas_kt = 100", "tas_kt = 200")
    with_map, without = (
        {seat.name: duty for seat, duty in seat_duties(flight)}
        for flight in (fly(sizing, parse_mission(mapped)), fly(sizing, parse_mission(STEADY.replace("= 100", "= 200"))))
    )
    thrust = fly(sizing, parse_mission(mapped)).history.thrust
    apart = np.abs(with_map["nose"].axial - without["nose"].axial)
    total = with_map["nose"].axial + without["nose"].axial
    assert np.minimum(np.abs(apart - thrust), np.abs(total - thrust)) == pytest.approx(0.0, abs=1e-6 * thrust.max())


def test_a_flight_without_a_map_has_the_assumed_thrust_of_usual_flight():
    """Within 1e-4, as other shafts and bearings lose a little more or less, and meshes bear that."""
    sizing = size(parse(OFF_SET + SEATS))
    usual = usual_loads(sizing.design, sizing.flows, "propeller", in_bearings=True)
    assumed, plain = (
        {seat.name: (seat, duty) for seat, duty in seat_duties(fly(one, parse_mission(STEADY)))}
        for one in (sizing, size(parse(OFF_SET.replace("blades = 6\n", "blades = 6\nthrust_n = 0\n", 1) + SEATS)))
    )
    apart = np.abs(assumed["nose"][1].axial - plain["nose"][1].axial)
    total = assumed["nose"][1].axial + plain["nose"][1].axial
    off = np.minimum(np.abs(apart - usual.thrust), np.abs(total - usual.thrust))
    assert off == pytest.approx(0.0, abs=1e-4 * usual.thrust)
    assert assumed["nose"][0].across > 0.0


def test_the_bearing_of_the_fast_planets_governs_the_thesiss_gearbox():
    """A planet on a carrier at 4500 rpm presses its pin with 28 kN of centrifugal force, four times its teeth's."""
    parts = lives().parts
    assert parts[0].name == "bearing of first.planet"
    assert next(part for part in parts if not part.is_bearing).name == "first.sun"
    assert next(each for each in sized().carriers if each.stage == "first").centrifugal_force > 25e3


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ('"NU 99"', r"planetaries\.second\.planet_bearing\.designation: 'NU 99'"),
        ('"NU 2309"\ndynamic_rating_kn = 9', "one rating without the other"),
    ],
)
def test_a_bearing_that_is_not_is_refused_as_the_design_is_read(given, expected):
    with pytest.raises(DesignError, match=expected):
        parse(PLANETS.format(given))


@pytest.mark.parametrize("given", ['"NU 202"', '"NU 2222"'])
def test_a_bearing_that_does_not_sit_between_pin_and_rim_is_refused(given):
    sizing = size(parse(PLANETS.format(given)))
    with pytest.raises(DesignError, match=r"planetaries\.second\.planet_bearing: NU .* has a bore of"):
        bearing_lives(fly(sizing, parse_mission(STEADY)))


def test_the_helicopters_mast_lives_on_tapers_that_take_the_rotors_thrust():
    """The upper taper takes 16.8 kN of thrust and what the bevel adds; every bearing of the design has its life."""
    flight = flown("ec120b", "ec120b-sortie")
    assert {row.seat for row in bearing_lives(flight).rows} == set(flight.sizing.design.bearings)
    upper = next(duty for seat, duty in seat_duties(flight) if seat.name == "mast-upper")
    assert upper.axial.min() > 16.8e3


def test_a_bearing_falls_short_of_a_static_safety_as_of_a_life():
    """What no size reaches is told, whichever it is; a life alone was looked at once."""
    asked = STEADY.replace("life_h = 3000", "life_h = 1.5\nstatic_safety = 19")
    lives = bearing_lives(fly(size(read(shipped_design("in-line"))), parse_mission(asked)))
    short = [row for row in lives.rows if row.static_safety < 19.0]
    assert short and all(row.falls_short and row.life > 1.5 for row in short)
    assert any("comes nearest" in note.replace("\n", " ") for note in lives.notes)


@pytest.mark.parametrize("name", ["off-set", "mixed", "in-line", "star"])
def test_a_chosen_bearing_lives_as_long_as_is_asked_or_is_said_not_to(name):
    """Under the flight's spectrum, not under the mean of its loads: no part of the life may be missing."""
    lives = bearing_lives(flown(name, "regional-250nm"))
    assert all(row.life >= row.asked or row.falls_short for row in lives.rows)
    assert sum("comes nearest" in note for note in lives.notes) == sum(row.falls_short for row in lives.rows)
