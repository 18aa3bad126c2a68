"""The page of a flight: whole, alone, and the same each time."""

import math
import re
from functools import cache

import numpy as np
import pytest

from gearwright.mission import Balance, durability, fly, size_for_life
from gearwright.render.figures.flights import apart, energies
from gearwright.render.pages.flight import flight_page
from gearwright.reviews import review_of
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.spec import parse_mission, read, read_mission
from html_checks import PACKED
from rated_by_hand import DENSITY, Pair, cycles_of_flank, flank_by_hand, planet_inside
from shipped_work import flown, flown_review, lives


@cache
def page():
    """Return the page of the flight."""
    return flight_page(flown(), lives(), flown_review())


def test_the_page_asks_nothing_of_any_other_place():
    assert not re.search(r"(?:src|href)=[\"'](?!#)|url\((?!#)|@import", page())
    assert not re.search(r"<script[^>]", PACKED.sub("", page()))


def test_the_page_answers_what_a_reader_asks_first():
    for words in ("375 kg", "498 kWh", "105 °C", "First to fail: bearing of first.planet, rolling fatigue, after 140",
                  "First gear to fail: first.sun, pitting, after 2852 flights"):  # fmt: skip
        assert words in page()


def test_the_lives_on_the_page_are_those_by_hand():
    """The sun of 54 teeth meets three planets of 66 a turn, 167 N m each, at N = 1.54: 0.855 of the endurance limit.

    The planet's bearing bears its own mass at 4465 rpm of the carrier, 28.1 kN, beside 7.4 kN of both meshes.
    """
    flight = flown()
    module, time = (
        1e3 * next(gear.module for gear in flight.sizing.gears if gear.name == "first.sun"),
        flight.history.duration,
    )
    torque = np.abs(flight.meshes["first.sun-planet"].torque)
    carrier = flight.speed("intermediate")
    rolling = np.abs(flight.speed("input") - carrier)
    pair = Pair((54, 66), module, (3, 1), (0.0, planet_inside(66, module)), paths=3)
    force = torque / (27.0 * module * 1e-3)
    damage = sum(
        3.0 * w * t / (2.0 * math.pi) / cycles_of_flank(flank_by_hand(pair, f, w * 30.0 / math.pi))
        for f, w, t in zip(force, rolling, time, strict=True) if f > 1e-3
    )  # fmt: skip
    assert 1.0 / damage == pytest.approx(2852.0, abs=0.5)
    disc = math.pi / 4.0 * (66.0 * module) ** 2 * pair.width * DENSITY
    borne = np.hypot(2.0 * force, disc * 60.0 * module * 1e-3 * carrier**2)
    turning = rolling * 54.0 / 66.0 / (2.0 * math.pi)
    row = next(row for row in lives().bearings.rows if row.seat == "first.planet")
    tired = float(np.sum(turning * time * (borne / row.bearing.dynamic_rating) ** (10.0 / 3.0))) / 1e6
    assert 1.0 / tired == pytest.approx(140.0, abs=0.5)


def test_the_page_is_the_same_each_time():
    assert flight_page(flown(), lives(), flown_review()) == page()


def test_every_id_is_there_once():
    ids = re.findall(r'\bid="([^"]+)"', page())
    assert len(ids) == len(set(ids))


@pytest.mark.parametrize(
    ("design", "mission"), [("in-line", "regional-250nm"), ("face-gear-split-torque", "rotor-schedule")]
)
def test_flights_without_motor_or_without_propeller_map_have_a_page(design, mission):
    flight = flown(design, mission)
    page = flight_page(flight, durability(flight), review_of(flight.sizing, flight))
    assert "exhaust of the turbines" in page
    assert "state of charge" not in page


def test_a_life_shows_what_it_costs():
    life = size_for_life(read(shipped_design("in-line-h2")), read_mission(shipped_mission("thesis")), 2000.0)
    assert "What a life costs" in flight_page(
        life.flight, durability(life.flight), review_of(life.sizing, life.flight), life=life
    )


def test_what_flows_into_the_sankey_flows_out():
    """Sum of sources against sum of sinks, a battery and a propeller that give or take; 1e-12 is rounding."""
    for battery, stored in ((0.3, 0.01), (-0.2, -0.01), (-0.8, 0.0)):
        rest = dict.fromkeys(("mesh_loss", "bearing_loss", "windage_loss", "churning_loss"), 0.01)
        work = 1.0 + battery - 0.7 - 0.04 - 0.02 - 0.01 - 0.03 - stored
        balance = Balance(
            1.0, battery, work, 0.03, 0.7, 0.65, 0.05, motor_loss=0.02, battery_loss=0.01, stored=stored, **rest
        )
        assert balance.residual == pytest.approx(0.0, abs=1e-12)
        flows = energies(balance)
        out = sum(sink.energy for sinks in (flows.hot, flows.used, flows.lost) for sink in sinks)
        assert balance.came_in == pytest.approx(out, rel=1e-12)
        assert flows.turbine + flows.electric + flows.slowed + flows.air == pytest.approx(
            flows.generated + sum(sink.energy for sink in flows.used), rel=1e-12
        )


def test_a_flight_that_only_charges_has_a_page(tmp_path):
    """Nothing but the air gives energy: no fuel, a battery that takes, on a map of one's own below C_P = 0."""
    rows = [f"{j},{b},{0.01 * (b - 20 * j)},{0.01 * (b - 20 * j)}" for j in (0, 2) for b in (10, 50)]
    head = "advance_ratio,blade_angle_deg,power_coefficient,thrust_coefficient"
    (tmp_path / "own.csv").write_text("\n".join([head, *rows]), encoding="utf-8")
    words = 'altitude_ft = 5000\ncas_kt = 170\nduration_min = 1\nmode = "electric"\npitch_deg = 15'
    mission = parse_mission(
        'schema = 1\nname = "descent"\npropeller_map = "own.csv"\n[battery]\nenergy_kwh = 300\nstart_charge = 0.5\n'
        f"[phases.down]\n{words}\npropeller_speed_rpm = 1212"
    )
    flight = fly(flown().sizing, mission, folder=tmp_path)
    page = flight_page(flight, durability(flight), review_of(flight.sizing, flight))
    assert "from the air" in page
    assert "charge of the battery" in page


def test_labels_keep_apart_and_stay_where_they_may():
    assert apart([0.0, 5.0, 10.0], 2.0) == [0.0, 5.0, 10.0]
    assert apart([0.0, 0.0, 0.0], 2.0) == [-2.0, 0.0, 2.0]
