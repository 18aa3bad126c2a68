"""The shipped missions that an aircraft flies: their books, their distances, and what charges."""

import math

import numpy as np
import pytest

from gearwright.mission import fly, phase_forces
from gearwright.render.words.flights import forces_text
from gearwright.shipped import shipped_mission
from gearwright.spec import read_mission
from gearwright.units import NAUTICAL_MILE
from shipped_work import flown, sized

DESIGN_OF = {"regional-aircraft": "in-line", "hybrid-reserves": "in-line-h2"}


def flight_of(mission):
    return flown(DESIGN_OF[mission], mission)


@pytest.mark.parametrize("name", DESIGN_OF)
def test_thrust_is_drag_and_path_in_every_phase_that_an_aircraft_flies(name):
    flight = flight_of(name)
    for row in phase_forces(flight):
        kind = flight.mission.phases[row.name].kind
        if kind not in (None, "taxi", "take-off", "landing"):  # on the ground a step's mean differs from its middle
            assert abs(row.left_over) < 0.002 * row.drag, row.name
        elif kind is not None:
            assert abs(row.left_over) < 0.06 * row.drag, row.name


@pytest.mark.parametrize("name", DESIGN_OF)
def test_the_books_of_paths_by_power_close(name):
    books = {phase: path.energy for phase, path in flight_of(name).paths.items() if path.energy is not None}
    assert {"take-off", "climb", "landing"} <= set(books)
    assert max(energy.residual for energy in books.values()) < 1e-6


@pytest.mark.parametrize("name", DESIGN_OF)
def test_energies_of_the_gearbox_close(name):
    assert flight_of(name).balance.residual < 1e-9


def test_the_regional_flight_is_250_miles_from_take_off_to_landing():
    rows = phase_forces(flight_of("regional-aircraft"))
    way = sum(row.distance for row in rows if row.name not in ("taxi-out", "taxi-in"))
    assert way / NAUTICAL_MILE == pytest.approx(250.0, abs=3.0)


def test_motors_that_brake_the_propellers_charge_the_battery():
    flight = flight_of("hybrid-reserves")
    within = np.array(flight.phase) == "descent"
    assert flight.history.thrust[within].max() < 0.0
    assert (np.diff(flight.history.state_of_charge[within]) > 0.0).all()


def test_reserves_are_no_part_of_the_block_fuel():
    flight = flight_of("hybrid-reserves")
    reserve = np.array([flight.mission.phases[name].reserve for name in flight.phase])
    burnt = 2.0 * flight.history.fuel_flow * flight.history.duration
    line = next(line for line in forces_text(flight) if line.startswith("Block fuel"))
    assert f"{burnt[~reserve].sum():.0f} kg, reserves of {burnt[reserve].sum():.0f} kg" in line


def test_smaller_steps_change_the_fuel_by_little():
    mission = read_mission(shipped_mission("regional-aircraft")).model_copy(update={"step": 5.0})
    fine = fly(flight_of("regional-aircraft").sizing, mission)
    assert fine.fuel == pytest.approx(flight_of("regional-aircraft").fuel, rel=1e-3)


def test_blades_held_in_reverse_brake_in_the_history_as_on_the_path():
    """The power of the path had been given to the other angle that takes it: 29 kN forwards."""
    mission = read_mission(shipped_mission("regional-aircraft"))
    reverse = mission.phases["landing"].model_copy(update={"power": None, "pitch": math.radians(-8.0)})
    flight = fly(
        sized("in-line"),
        mission.model_copy(update={"phases": {**mission.phases, "landing": reverse}}),
    )
    row = {row.name: row for row in phase_forces(flight)}["landing"]
    assert row.thrust < 0.0
    assert row.left_over == pytest.approx(0.0, abs=0.05 * row.drag)  # the mean of four intervals beside their path
