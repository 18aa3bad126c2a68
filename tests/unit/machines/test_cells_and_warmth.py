"""Cells and networks of heat against closed forms: an RC pulse, one body that cools, a steady chain by hand."""

import math

import numpy as np
import pytest

from gearwright.machines import Battery, battery_step, stored_energy
from gearwright.machines.electric import (
    Cells,
    CellState,
    Network,
    cell_step,
    held_energy,
    open_voltage,
    resistance_factor,
    steady,
    straight,
    warmed,
)

PACK = Battery(3.6e5, 800.0, 600.0, 0.05, 8.0, 0.05)
FLAT = Battery(3.6e5, 700.0, 700.0, 0.05, 8.0, 0.05)


def stepped(battery, cells, state, power, duration=10.0, temperature=298.15):
    return cell_step(battery, cells, state, power=power, duration=duration, temperature=temperature)


@pytest.mark.parametrize("power", [-5e4, 0.0, 8e4])
def test_cells_without_a_pair_are_a_plain_battery(power):
    plain = battery_step(PACK, 0.6, power, 10.0)
    cells = straight(PACK)
    step = stepped(PACK, cells, CellState(0.6), power).step
    assert step.state_of_charge == pytest.approx(plain.state_of_charge, abs=1e-14)
    assert step.loss == pytest.approx(plain.loss, rel=1e-9, abs=1e-6)
    assert held_energy(PACK, cells, CellState(0.6)) == pytest.approx(stored_energy(PACK, 0.6), rel=1e-14)


def test_a_pulse_polarises_as_an_rc_pair_does():
    """Steps of nearly constant current against v = R_1 I (1 - e^(-t/τ)), and its decay behind the pulse."""
    cells, state = straight(FLAT, slow_resistance=0.02, time=20.0), CellState(0.9)
    for _ in range(30):
        done = stepped(FLAT, cells, state, 5e4, 1.0)
        state = done.state
    assert state.polarisation == pytest.approx(0.02 * done.step.current * (1.0 - math.exp(-30.0 / 20.0)), rel=2e-3)
    top = state.polarisation
    state = stepped(FLAT, cells, state, 0.0, 20.0).state
    assert state.polarisation == pytest.approx(top * math.exp(-1.0), rel=1e-12)


@pytest.mark.parametrize("power", [-6e4, 4e4, 1.2e5])
def test_what_cells_lose_is_power_and_heat(power):
    """Over a curve with knees: store lost = power + heat, 1e-12 of the store."""
    cells = Cells((0.0, 0.1, 0.8, 1.0), (500.0, 620.0, 700.0, 820.0), 0.03, 15.0, 2500.0)
    state, given, heat = CellState(0.55), 0.0, 0.0
    start = held_energy(PACK, cells, state)
    for _ in range(40):
        done = stepped(PACK, cells, state, power, 7.0, 283.15)
        state, given, heat = done.state, given + 7.0 * power, heat + 7.0 * done.step.loss
    assert heat > 0.0
    assert start - held_energy(PACK, cells, state) == pytest.approx(given + heat, abs=1e-11 * start)


def test_cold_cells_resist_more():
    cells = straight(PACK, activation=3000.0)
    assert resistance_factor(cells, 298.15) == 1.0
    assert resistance_factor(cells, 273.15) == pytest.approx(math.exp(3000.0 * (1 / 273.15 - 1 / 298.15)))
    assert (
        stepped(PACK, cells, CellState(0.5), 8e4, temperature=263.15).step.loss
        > 2.0 * battery_step(PACK, 0.5, 8e4, 10.0).loss
    )


def test_a_curve_is_read_between_its_points():
    cells = Cells((0.0, 0.5, 1.0), (600.0, 700.0, 720.0), 0.0, 1.0, 0.0)
    assert [open_voltage(cells, s) for s in (0.0, 0.25, 0.5, 0.75, 1.0)] == [600.0, 650.0, 700.0, 710.0, 720.0]


@pytest.mark.parametrize(
    ("state", "power", "stop"), [(0.0501, 1e5, "empty"), (0.5, 9e6, "overloaded"), (0.99999, -1e5, "full")]
)
def test_what_stops_cells_is_named(state, power, stop):
    assert stepped(PACK, straight(PACK), CellState(state), power).step.fault == stop


def chain():
    """Winding - case - coolant: 400 J/K, 3000 J/K; 5 W/K between, 20 W/K out."""
    return Network(np.array([400.0, 3000.0]), np.array([[0.0, 5.0], [5.0, 0.0]]), np.array([[0.0], [20.0]]))


def test_a_steady_chain_is_that_of_a_hand_calculation():
    """250 W in the winding, 150 W in the case: case 300 + 400/20, winding 50 K above it."""
    assert steady(chain(), np.array([250.0, 150.0]), np.array([300.0])) == pytest.approx([370.0, 320.0])
    long = warmed(
        chain(), np.array([300.0, 300.0]), np.array([250.0, 150.0]), surroundings=np.array([300.0]), duration=1e6
    )
    assert long.temperature == pytest.approx([370.0, 320.0], rel=1e-12)


def test_one_body_follows_its_exponential_in_steps_of_any_length():
    body = Network(np.array([1000.0]), np.zeros((1, 1)), np.array([[10.0]]))
    for count in (1, 7):
        temperature = np.array([290.0])
        for _ in range(count):
            temperature = warmed(
                body, temperature, np.array([500.0]), surroundings=np.array([290.0]), duration=150.0 / count
            ).temperature
        assert temperature[0] == pytest.approx(290.0 + 50.0 * (1.0 - math.exp(-1.5)), rel=1e-13)


@pytest.mark.parametrize("duration", [1e-6, 1.0, 600.0, 1e7])
def test_a_network_stores_and_rejects_what_heats_it(duration):
    network, start, heat = chain(), np.array([330.0, 305.0]), np.array([120.0, 40.0])
    after = warmed(network, start, heat, surroundings=np.array([295.0]), duration=duration)
    stored = float(network.capacity @ (after.temperature - start))
    assert stored + float(after.rejected.sum()) * duration == pytest.approx(160.0 * duration, rel=1e-9, abs=1e-8)


def test_an_isolated_body_warms_up_by_its_heat_alone():
    body = Network(np.array([50.0]), np.zeros((1, 1)), np.zeros((1, 1)))
    after = warmed(body, np.array([300.0]), np.array([10.0]), surroundings=np.array([250.0]), duration=20.0)
    assert after.temperature[0] == pytest.approx(304.0, rel=1e-14) and after.mean[0] == pytest.approx(302.0, rel=1e-14)
