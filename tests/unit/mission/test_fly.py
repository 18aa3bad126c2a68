"""Flying: balances, limits, spectra and damage."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from gearwright.catalogue import MAPS, compressed, hamilton_standard_charts
from gearwright.errors import DesignError
from gearwright.machines import performance
from gearwright.mission import (
    durability,
    flight_series,
    fly,
    gear_damage,
    mesh_spectrum,
    phase_summaries,
    shaft_spectrum,
    unrated_stages,
)
from gearwright.mission.flight import MESH_LOSS
from gearwright.render.answers.flights import Moment, fly_answer
from gearwright.render.answers.schema import described, plain
from gearwright.render.words.flights import flight_csv, flight_text, verdict_text
from gearwright.reviews import review_of
from gearwright.spec import parse_mission
from gearwright.units import si_unit
from shipped_work import flown as thesis, sized

BASE = """
schema = 1
name = "test"
[engine]
thermal_power_kw = 2600
[battery]
energy_kwh = 100
[phases.one]
altitude_ft = 5000
cas_kt = 170
duration_min = 2
power_kw = 900
propeller_speed_rpm = 1212
"""


def flown(text, sizing=None):
    """Return a flight of a mission text, of the hybrid if no sizing is given."""
    return fly(sizing or sized(), parse_mission(text))


def test_energy_closes_over_a_mission_with_every_mode():
    """Charge and speeds at the ends against powers summed over the way; 1e-9 is rounding of 533 intervals."""
    assert thesis().balance.residual < 1e-9
    assert thesis().balance.battery > 0.1 * thesis().balance.fuel


def test_energy_closes_while_the_propeller_spins_up():
    two = BASE + BASE[BASE.index("[phases.one]") :].replace("one", "two").replace("1212", "1100")
    flight = flown(two)
    assert flight.balance.stored < 0.0
    assert flight.balance.residual < 1e-9


def test_powers_balance_in_every_interval():
    """Machines = propeller + meshes + bearings and windage + spin-up + dragged motors; 1e-9 of the power."""
    h = thesis().history
    whole = sum(machine.power for machine in thesis().machines.values())
    out = h.propeller_power + h.mesh_loss + h.bearing_loss + h.windage_loss + h.spin_up
    dragged = np.array([phase in ("descent", "approach") for phase in thesis().phase])
    assert whole[~dragged] == pytest.approx(out[~dragged], rel=1e-9)
    assert whole[dragged] == pytest.approx((out + h.motor_loss)[dragged], rel=1e-9)


def test_a_loss_free_torque_follows_the_teeth():
    """The shaft torques of a lossless planetary train are in the ratio of its speeds; 2 % for the mesh losses."""
    flight = flown(BASE.replace("power_kw = 900", "power_kw = 1000"), sized("in-line"))
    propeller = flight.history.propeller_power / flight.history.propeller_speed
    turbine = flight.machines["gas-turbine"].power / flight.nodes["input"].speed
    ratio = flight.nodes["input"].speed / flight.history.propeller_speed
    assert propeller == pytest.approx(turbine * ratio, rel=0.02)


def test_the_propeller_holds_its_pitch_on_taxi():
    taxi = np.array([phase == "taxi-out" for phase in thesis().phase])
    assert np.degrees(thesis().history.pitch[taxi]) == pytest.approx(10.0, abs=1e-6)
    assert thesis().history.fuel_flow[taxi] == pytest.approx(0.0)


def test_regeneration_charges_the_battery():
    text = BASE.replace("power_kw = 900", 'power_kw = 700\nmode = "hybrid"\nelectric_share = -0.2')
    flight = flown(text)
    assert flight.history.state_of_charge[-1] > 0.95
    assert flight.balance.battery < 0.0
    assert flight.balance.residual < 1e-9


@pytest.fixture
def windmill(tmp_path):
    """A mission on a map of one's own, C_P = 0.01 (β - 20 J): at 15° and J = 1.2 the air drives the propeller."""
    rows = [f"{j},{b},{0.01 * (b - 20 * j):.6f},{0.01 * (b - 20 * j):.6f}" for j in (0, 1, 2) for b in (10, 25, 50)]
    head = "advance_ratio,blade_angle_deg,power_coefficient,thrust_coefficient"
    (tmp_path / "own.csv").write_text("\n".join([head, *rows]), encoding="utf-8")
    text = BASE.replace("power_kw = 900", 'pitch_deg = 15\nmode = "electric"')
    text = text.replace("energy_kwh = 100", "energy_kwh = 300\nstart_charge = 0.5")
    return text.replace('"test"', '"test"\npropeller_map = "own.csv"'), tmp_path


def test_a_propeller_that_the_air_drives_charges_through_the_teeth_at_a_loss(windmill):
    """Propeller → gearbox → motor: the teeth lose in this sense, too, as much as at the same power in the other."""
    text, folder = windmill
    flight = fly(sized(), parse_mission(text), folder=folder)
    history, row = flight.history, phase_summaries(flight)[0]
    assert history.propeller_power.max() < -500e3
    assert history.mesh_loss.min() > 0.0
    assert flight.balance.residual < 1e-9
    motor = flight.machines["electric"].power
    assert -motor == pytest.approx(-history.propeller_power - history.gearbox_heat, rel=1e-12)
    assert row.efficiency == pytest.approx(float(motor.sum() / history.propeller_power.sum()), rel=1e-12)
    driven = flown(text.replace("pitch_deg = 15", "power_kw = 690").replace('propeller_map = "own.csv"', ""))
    assert 1.0 - row.efficiency == pytest.approx(1.0 - phase_summaries(driven)[0].efficiency, rel=0.1)


def test_a_turbine_does_not_take_what_the_air_drives(windmill):
    text, folder = windmill
    with pytest.raises(DesignError, match="a turbine only gives"):
        fly(sized(), parse_mission(text.replace("electric", "conventional")), folder=folder)


def test_a_fast_propeller_loses_thrust_to_compressibility_as_its_charts_say():
    """The cruise of the thesis, Mach 0.52, by the method of the charts from its power: 0.963; 1e-4: the map's grid."""
    h, k = thesis().history, thesis().phase.index("cruise") + 5
    turns, diameter = h.propeller_speed[k] / (2 * np.pi), sized().design.propellers["propeller"].diameter
    power = h.propeller_power[k] / (h.air_density[k] * turns**3 * diameter**5)
    found = performance(hamilton_standard_charts(), MAPS["6-blades-af115"], h.advance_ratio[k],
                        power_coefficient=power, mach=h.mach[k])  # fmt: skip
    assert found.compressibility == pytest.approx(0.963, abs=1e-3)
    assert h.compressibility[k] == pytest.approx(found.compressibility, abs=1e-4)
    scale = h.air_density[k] * turns**2 * diameter**4
    assert h.thrust[k] == pytest.approx(found.thrust_coefficient * scale, rel=2e-3)


def test_a_mach_number_beyond_the_charts_is_refused():
    """The excess over the critical Mach number ends at 0.3; a map of one's own is taken as it is."""
    with pytest.raises(DesignError, match=r"Mach 0\.900, 0\.950 at the tips, .* outside the charts"):
        compressed("6-blades-af115", 2.0, 0.1, mach=0.9, tip_mach=0.95)
    assert compressed("mine.csv", 2.0, 0.1, mach=0.9, tip_mach=0.95) == 1.0


@pytest.mark.parametrize("turning", [1212, 1500])
def test_thrust_carries_the_weight_up_the_slope(turning):
    """T = D + m g sin γ + m dV/dt with C_D = C_D0 + k C_L², by hand amid the phase; 1e-3 for the fuel burnt.

    The faster propeller loses some thrust to compressibility, and pitch makes up for it.
    """
    aircraft = "[aircraft]\nmass_kg = 9000\nwing_area_m2 = 61\nzero_lift_drag = 0.028\ninduced_drag = 0.034\n"
    text = BASE.replace("power_kw = 900\n", "from_altitude_ft = 4000\n").replace("[engine]", aircraft + "[engine]")
    flight = flown(text.replace("1212", str(turning)), sized("in-line"))
    k, h = len(flight.phase) // 2, flight.history
    speed, slope = h.true_airspeed[k], 1000 * 0.3048 / 120 / h.true_airspeed[k]
    from gearwright.air import air_at

    dynamic = 0.5 * air_at(h.altitude[k]).density * speed**2 * 61
    lift = 9000 * 9.80665 * math.sqrt(1 - slope**2) / dynamic
    gain = (h.true_airspeed[k + 1] - h.true_airspeed[k - 1]) / (h.time[k + 1] - h.time[k - 1])  # at constant CAS
    thrust = dynamic * (0.028 + 0.034 * lift**2) + 9000 * (9.80665 * slope + gain)
    assert h.thrust[k] == pytest.approx(thrust, rel=1e-3)
    assert (h.compressibility[k] < 0.999) == (turning > 1400)


def test_an_aircraft_accelerates_from_one_airspeed_to_the_next():
    """Level, from 90 to 102 m/s in two minutes: 0.1 m/s² everywhere, and 0.1 m more thrust than steady flight has.

    The thrust of steady flight comes from the same polar by hand; 1e-3 for the fuel burnt.
    """
    from gearwright.air import air_at

    aircraft = "[aircraft]\nmass_kg = 9000\nwing_area_m2 = 61\nzero_lift_drag = 0.028\ninduced_drag = 0.034\n"
    text = BASE.replace("power_kw = 900\n", "").replace("cas_kt = 170", "from_tas_m_s = 90\ntas_m_s = 102")
    flight = flown(text.replace("[engine]", aircraft + "[engine]"), sized("in-line"))
    h = flight.history
    assert np.diff(h.true_airspeed) / np.diff(h.time) == pytest.approx(0.1, rel=1e-9)
    assert h.true_airspeed[0] - 0.1 * h.time[0] == pytest.approx(90.0, rel=1e-12)
    for speed, altitude, thrust in zip(h.true_airspeed, h.altitude, h.thrust, strict=True):
        dynamic = 0.5 * air_at(altitude).density * speed**2 * 61
        drag = dynamic * 0.028 + 0.034 * (9000 * 9.80665) ** 2 / dynamic
        assert thrust == pytest.approx(drag + 900.0, rel=1e-3)


def test_an_airspeed_at_the_start_is_given_once():
    with pytest.raises(DesignError, match="from_cas and from_tas given; give one of them"):
        parse_mission(BASE.replace("cas_kt = 170", "cas_kt = 170\nfrom_cas_kt = 100\nfrom_tas_kt = 110"))


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            "power_kw = 900",
            "power_kw = 1500",
            r"gas-turbine: needs 1500 kW at 1524 m, and gives 1046 kW \(by its rating\); ask for less power",
        ),
        (
            "thermal_power_kw = 2600",
            "thermal_power_kw = 800",
            r"needs 900 kW at 1524 m, and gives [\d.]+ kW \(by its core\)",
        ),
        ("power_kw = 900", 'power_kw = 2000\nmode = "electric"', "electric: needs 2000 kW"),
        ("duration_min = 2", 'duration_min = 20\nmode = "electric"', "empty"),
        ("energy_kwh = 100", "energy_kwh = 10\nstart_charge = 1", "overloaded"),
        ("power_kw = 900", "pitch_deg = 12", "blade angle 12°: outside the map"),
        ("cas_kt = 170", "cas_kt = 650", "Mach"),
        ("power_kw = 900", "power_kw = 0.1", "of 0.1 kW nothing reaches the propeller: bearings and oil"),
        ('name = "test"', 'name = "test"\npropeller_map = "nonsense"', "no shipped map"),
    ],
)
def test_what_cannot_be_flown_is_refused_with_phase_and_value(old, new, expected):
    text = BASE.replace(old, new)
    if expected == "overloaded":
        text = text.replace("power_kw = 900", 'power_kw = 900\nmode = "electric"')
    if expected == "empty":
        text = text.replace("power_kw = 900", "power_kw = 700").replace("duration_min = 10", "duration_min = 20")
        text = text.replace("energy_kwh = 100", "energy_kwh = 200\nhighest_c_rate = 20")
    with pytest.raises(DesignError, match=expected):
        flown(text)


def test_a_battery_names_its_limit_and_what_helps_in_the_mode():
    """1 C of 100 kWh at 2.5 % less than its mean voltage; only a hybrid phase has a share to lower."""
    electric = BASE.replace("power_kw = 900", 'power_kw = 900\nmode = "electric"')
    weak = electric.replace("energy_kwh = 100", "energy_kwh = 100\nhighest_c_rate = 1")
    expected = r"overloaded: .* A, of [\d.]+ A \(highest_c_rate 1\); ask for less power, or give more energy_kwh or"
    with pytest.raises(DesignError, match=expected):
        flown(weak)
    with pytest.raises(DesignError, match="; lower electric_share or power, or give"):
        flown(weak.replace('"electric"', '"hybrid"\nelectric_share = 0.5'))
    with pytest.raises(DesignError, match="its resistance of 50 Ω lets through; ask for less power, or lower"):
        flown(electric.replace("energy_kwh = 100", "energy_kwh = 100\nhighest_c_rate = 100\nresistance_ohm = 50"))


def test_a_full_battery_is_told_to_start_with_less(windmill):
    text, folder = windmill
    full = text.replace("start_charge = 0.5", "start_charge = 1")
    with pytest.raises(DesignError, match=r"full: .*\(maximum 1\); start with a lower start_charge, charge less"):
        fly(sized(), parse_mission(full), folder=folder)


def test_an_electric_phase_needs_a_motor():
    with pytest.raises(DesignError, match="the design has no motor"):
        flown(BASE.replace("power_kw = 900", 'power_kw = 900\nmode = "electric"'), sized("in-line"))


def test_a_spectrum_keeps_every_second_and_every_turn():
    """Classes sort the flight and lose nothing; 1e-12 is rounding."""
    for mesh in sized().train.meshes:
        bins = mesh_spectrum(thesis(), mesh.name)
        assert sum(each.time for each in bins) == pytest.approx(thesis().duration, rel=1e-12)
    bins = shaft_spectrum(thesis(), "output", classes=10)
    turns = (thesis().nodes["output"].speed * thesis().history.duration).sum() / (2 * np.pi)
    assert sum(each.turns for each in bins) == pytest.approx(turns, rel=1e-12)
    assert len(bins) <= 10


def test_damage_grows_with_the_time_under_load():
    """Miner's sum is linear in the cycles: twice the time, twice the damage; 1e-3 for the spin of the last class."""
    text = BASE.replace("power_kw = 900", 'power_kw = 2040\nmode = "hybrid"\nelectric_share = 0.49')
    text = text.replace("energy_kwh = 100", "energy_kwh = 900").replace("[phases", "[motor]\noverload = 1.05\n[phases")
    once = {(row.gear, row.mode): row.damage for row in gear_damage(flown(text))}
    twice = gear_damage(flown(text.replace("duration_min = 2", "duration_min = 4")))
    assert twice[0].damage > 0.0
    assert twice[0].damage == pytest.approx(2.0 * once[twice[0].gear, twice[0].mode], rel=1e-3)
    assert twice[0].flights == pytest.approx(1.0 / twice[0].damage)


def test_the_worst_gear_comes_first():
    """What is less than a billionth of the largest is none, and stays where it was."""
    rows = gear_damage(thesis())
    counting = [row.damage for row in rows if row.damage > 1e-9 * rows[0].damage]
    assert counting == sorted((row.damage for row in rows), reverse=True)[: len(counting)]
    assert len(rows) == 2 * len(sized().gears)


def test_a_flight_is_told_in_words_numbers_and_histories():
    parts = durability(thesis())
    told = flight_text(thesis(), parts, review_of(thesis().sizing, thesis(), parts))
    assert f"First to fail: {parts.parts[0].name}" in told
    assert all(row.name in told for row in phase_summaries(thesis()))
    table = flight_csv(thesis()).splitlines()
    assert len(table) == len(thesis().phase) + 1
    assert "bearing.second.planet" in table[0]
    assert plain(fly_answer(thesis(), parts, review_of(thesis().sizing, thesis(), parts)))["fuel_kg"] == thesis().fuel


def test_every_recorded_quantity_has_a_unit_and_every_loss_a_source():
    """CSV, JSON and figures take them from the marks of the fields."""
    recorded = {series.name: series for series in flight_series(thesis())}
    units = {name: si_unit(series.marks.dimension) for name, series in recorded.items()}
    assert units["propeller_speed"] == units["speed.output"] == "rad/s"
    assert units["air_temperature"] == units["oil_outlet"] == "K"
    assert units["power.electric"] == "W"
    assert all(series.marks.origin for name, series in recorded.items() if name.endswith("_loss"))
    assert all(len(series.values) == len(thesis().phase) for series in recorded.values())
    definitions = {}
    described(Moment, definitions)
    loss = definitions["History"]["properties"]["mesh_loss_kw"]
    assert (loss["unit"], loss["equation"], loss["source"]) == ("kW", "P μ H_V", MESH_LOSS.source)


def test_a_machine_has_a_torque_by_its_power_and_its_speed():
    motor = thesis().machines["electric"]
    assert motor.torque * thesis().speed("intermediate") == pytest.approx(motor.power, rel=1e-12)


def test_the_ground_stands_still_in_a_flight():
    assert not thesis().speed("ground").any()


def test_lives_beyond_any_sense_are_not_printed_in_full():
    """The worst part of a light flight lives longer than a million flights, and the sentence says just that."""
    parts = durability(flown(BASE.replace("power_kw = 900", "power_kw = 600")))
    assert parts.parts[0].flights > 1e6
    assert " after > 1e+06 flights or " in verdict_text(parts)


def test_a_verdict_without_all_bearings_is_of_what_is_rated():
    """Without [bearings] the planets' bearings are unknown; with it, one that falls short is rated all the same."""
    assert verdict_text(durability(flown(BASE))).startswith("First to fail of what is rated: ")
    parts = durability(thesis())
    assert parts.notes
    assert verdict_text(parts).startswith("First to fail: ")


def test_a_rotor_flies_by_its_schedules_and_its_face_gears_are_not_rated():
    """ISO 6336 covers cylindrical gears; those of the second stage are rated, and the first stage is named."""
    flight = thesis("face-gear-split-torque", "rotor-schedule")
    assert flight.history.thrust is None
    assert flight.balance.residual < 1e-9
    found = durability(flight)
    face = unrated_stages(flight.sizing.design)
    assert face
    assert {row.gear.partition(".")[0] for row in found.gears}.isdisjoint(face)
    assert any("face gears" in note for note in found.notes)


def test_a_gear_in_an_oil_bath_churns_and_costs_no_windage():
    """Half of the ring in the bath; energies still close, to the rounding of the sums."""
    wet = flown(BASE.replace("[engine]", '[oil.dip]\n"second.ring" = 0.3\n"second.planet" = 0.3\n[engine]'))
    dry = flown(BASE)
    assert wet.balance.churning_loss > 0.0
    assert wet.balance.windage_loss < dry.balance.windage_loss
    assert dry.balance.churning_loss == 0.0
    assert wet.balance.residual < 1e-9


def test_a_bath_for_a_gear_that_is_not_there_is_refused():
    with pytest.raises(DesignError, match=r"oil\.dip\.third\.ring: there is no gear"):
        flown(BASE.replace("[engine]", '[oil.dip]\n"third.ring" = 0.3\n[engine]'))


def twin():
    """Return two engines on sprag clutches."""
    return sized("twin-engine-sprag")


@cache
def unlimited():
    """Return two engines on sprag clutches without limits by time."""
    design = twin().design
    bare = {name: turbine.model_copy(update={"limits": {}}) for name, turbine in design.turbines.items()}
    return replace(twin(), design=design.model_copy(update={"turbines": bare}))


"""Its turbines have no limits for a time, so that ratings are all that they give."""
ONE_OUT = BASE.replace("power_kw = 900", 'power_kw = 900\ninoperative = ["turbine-2"]')


def test_one_engine_of_a_gearbox_stops_and_the_other_drives_alone():
    """The overrunning clutch lets go: the dead turbine stands still, gives nothing and burns nothing."""
    flight = flown(ONE_OUT, twin())
    both = flown(BASE, twin())
    assert np.abs(flight.machines["turbine-2"].power).max() == 0.0
    assert flight.machines["turbine-1"].power == pytest.approx(
        sum(machine.power for machine in both.machines.values()), rel=1e-3
    )
    assert flight.fuel < both.fuel
    assert flight.balance.residual < 1e-9


def test_a_contingency_rating_holds_only_while_an_engine_is_out():
    """1150 kW from one engine of 1046 kW: flown at a rating of 1.15 only; 1e-5 for the drag of one interval."""
    more = ONE_OUT.replace("power_kw = 900", "power_kw = 1150")
    with pytest.raises(DesignError, match="turbine-1: needs 1150 kW"):
        flown(more, unlimited())
    rated = more.replace("thermal_power_kw = 2600", "thermal_power_kw = 2600\ncontingency = 1.15")
    assert flown(rated, unlimited()).machines["turbine-1"].power.max() == pytest.approx(1150e3, rel=1e-5)
    with pytest.raises(DesignError, match="needs 1150 kW"):
        flown(
            BASE.replace("power_kw = 900", "power_kw = 2300").replace("2600", "2600\ncontingency = 1.05"), unlimited()
        )


def test_a_contingency_rating_does_not_change_what_a_power_burns():
    rated = ONE_OUT.replace("thermal_power_kw = 2600", "thermal_power_kw = 2600\ncontingency = 1.15")
    assert flown(rated, twin()).fuel == pytest.approx(flown(ONE_OUT, twin()).fuel, rel=1e-12)


@pytest.mark.parametrize(
    ("given", "expected"),
    [('["turbine-3"]', "there is no machine 'turbine-3'"), ('["turbine-1", "turbine-2"]', "mode needs one")],
)
def test_machines_that_cannot_be_out_are_refused(given, expected):
    with pytest.raises(DesignError, match=expected):
        flown(ONE_OUT.replace('["turbine-2"]', given), twin())
