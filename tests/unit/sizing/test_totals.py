"""What a sizing amounts to, added up by hand."""

import math

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing import named_results, size
from gearwright.spec import read


@pytest.fixture(scope="module")
def sizing():
    return size(read(shipped_design("in-line-h2")))


def test_masses_are_the_sums_of_their_parts(sizing):
    results = {name: result.value for name, result in named_results(sizing).items()}
    gears = sum(results[f"gears.{gear.name}.mass"] * gear.bodies for gear in sizing.gears)
    shafts = sum(results[f"shafts.{shaft.name}.mass"] for shaft in sizing.shafts)
    carriers = sum(results[f"carriers.{carrier.stage}.mass"] for carrier in sizing.carriers)
    motors = sum(machine.mass or 0.0 for machine in sizing.machines)
    assert min(gears, shafts, carriers, motors) > 0.0
    assert results["gear_mass"] == pytest.approx(gears)
    assert results["shaft_mass"] == pytest.approx(shafts)
    assert results["carrier_mass"] == pytest.approx(carriers)
    assert results["motor_mass"] == pytest.approx(motors)
    assert results["mass"] == pytest.approx(gears + shafts + carriers)
    assert results["total_mass"] == pytest.approx(gears + shafts + carriers + motors)


def test_power_densities_are_what_the_machines_give_over_the_masses(sizing):
    results = {name: result.value for name, result in named_results(sizing).items()}
    given = sum(power for power in sizing.flows["rated"].machine_powers.values() if power > 0.0)
    assert given == pytest.approx(1046e3 + 1005e3)
    assert results["power_density"] == pytest.approx(given / results["mass"])
    assert results["total_power_density"] == pytest.approx(given / results["total_mass"])


def test_speeds_torques_and_powers_of_machines_belong_together(sizing):
    results = named_results(sizing)
    for case in sizing.flows:
        for machine, shaft in sizing.train.machines.items():
            torque, power = (results[f"cases.{case}.{machine}.{what}"] for what in ("torque", "power"))
            speed = results[f"cases.{case}.{shaft}.speed"]
            assert (torque.dimension, power.dimension, speed.dimension) == ("torque", "power", "speed")
            assert math.isclose(torque.value * speed.value, power.value, rel_tol=1e-12, abs_tol=1e-6)


def test_the_mass_breakdown_is_the_whole_and_heaviest_first(sizing):
    from gearwright.sizing import mass_parts

    parts = mass_parts(sizing)
    assert sum(part.total for part in parts) == pytest.approx(sizing.parts_mass)
    assert sum(part.share for part in parts) == pytest.approx(1.0)
    assert all(part.total == pytest.approx(part.count * part.each) for part in parts)
    assert [part.total for part in parts] == sorted((part.total for part in parts), reverse=True)
    assert {part.group for part in parts} == {"gears", "shafts", "carriers"}


def test_a_preliminary_breakdown_has_the_bearings_of_planets_and_adds_up():
    from gearwright.sizing import mass_parts

    sizing = size(read(shipped_design("hybrid-turboprop")))
    parts = mass_parts(sizing)
    turning = [part for part in parts if part.group == "planet bearings"]
    assert sum(part.total for part in turning) == pytest.approx(sizing.planet_bearing_mass)
    assert sizing.planet_bearing_mass > 0.0
    assert sum(part.total for part in parts) == pytest.approx(sizing.mass)
    assert sum(part.share for part in parts) == pytest.approx(1.0)
