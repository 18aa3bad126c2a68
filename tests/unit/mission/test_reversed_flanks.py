"""Teeth whose other flank is loaded less bend less both ways than an idler's; so do those that brake in a descent."""

import math

import numpy as np
import pytest

from gearwright.mission import fly, gear_damage
from gearwright.shipped import shipped_mission
from gearwright.sizing.rating import reverse_parts
from gearwright.sizing.rating.iso6336_inputs import mean_stress_factor
from gearwright.spec import read_mission
from rated_by_hand import Pair, cycles_of_root, planet_inside, root_by_hand
from shipped_work import sized


def test_the_mean_stress_factor_is_that_of_idlers_where_both_flanks_bear_alike():
    """ISO 6336-3, annex B: 1 without, 0.7 for R = -1; a sixth of the load on the other flank leaves 0.933."""
    assert mean_stress_factor(0.0) == 1.0
    assert mean_stress_factor(1.0) == 0.7
    assert mean_stress_factor(1.0 / 6.0) == pytest.approx(14.0 / 15.0, rel=1e-12)  # 1/(1 + 3/7/6)


def test_a_planet_is_loaded_on_both_flanks_alike_and_a_ring_as_its_flight_says():
    train = sized().train
    mesh = next(mesh for mesh in train.meshes if mesh.name == "second.planet-ring")
    loads = {row.name: (-100.0, 600.0) for row in train.meshes}
    assert reverse_parts(train, mesh, loads) == (1.0, pytest.approx(1.0 / 6.0))
    assert reverse_parts(train, mesh, {row.name: (100.0, 600.0) for row in train.meshes}) == (1.0, 1.0)  # not asked


def test_the_ring_of_a_flight_that_brakes_a_little_in_descent_does_not_fail_within_some_flights():
    """Rated as if every turn bent its teeth both ways it would have a damage 1078 times as large, of 0.094 a flight.

    By hand: 1988 kW at 126.9 rad/s are 15.66 kN m of carrier, of five planets with two meshes each at 157 mm: 9.97 kN.
    On 153 teeth of 2.99 mm at N = 0.90 with K_V = 1.95 they are 0.95 of what the roots of the ring endure; its rim
    of 3.95 − 1.25 modules has Y_B = 1.295, and a planet meets it five times in 153/48 of its turns.
    """
    flight = fly(sized(), read_mission(shipped_mission("hybrid-reserves")))
    k = list(flight.phase).index("take-off")
    carrier = flight.history.propeller_power[k] / flight.history.propeller_speed[k]
    assert flight.meshes["second.planet-ring"].force[k] == pytest.approx(carrier / (2 * 5 * 0.15704), rel=5e-3)
    torque = flight.meshes["second.planet-ring"].torque
    assert -torque.min() / torque.max() == pytest.approx(1531.7 / 9986.0, rel=1e-3)
    damage = {row.gear: row.damage for row in gear_damage(flight) if row.mode == "bending"}
    back = -torque.min() / torque.max()
    assert damage["second.ring"] == pytest.approx(damage_by_hand(flight, 1, back=back), rel=1e-3)
    assert damage["second.planet"] == pytest.approx(damage_by_hand(flight, 0, back=1.0), rel=1e-3)  # an idler
    assert damage_by_hand(flight, 1, back=1.0) / damage["second.ring"] == pytest.approx(1078.0, rel=2e-3)


def damage_by_hand(flight, gear, *, back):
    """Miner's sum of the roots of the second set's planet (0) or ring (1), interval by interval."""
    module = 1e3 * next(row.module for row in flight.sizing.gears if row.name == "second.planet")
    pair = Pair((48, -153), module, (1, 0), (planet_inside(48, module), 0.0))
    force = np.abs(flight.meshes["second.planet-ring"].torque) / (24.0 * module * 1e-3)
    rolling = np.abs(flight.speed("second.planet") - flight.speed("output"))
    passes, rim = ((1.0, math.inf), (5.0 * 48.0 / 153.0, 3.95 - 1.25))[gear]
    return sum(
        passes * w * t / (2.0 * math.pi)
        / cycles_of_root(root_by_hand(pair, gear, f, w * 30.0 / math.pi, bent_back=back, rim=rim))
        for f, w, t in zip(force, rolling, flight.history.duration, strict=True) if f > 1e-1
    )  # fmt: skip
