"""What takes power in flight beside the propeller: accessories by their demand, others by their part."""

import pytest

from gearwright.mission import fly
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse, parse_mission
from shipped_work import flown

ROUNDING = 1e-11
"""Of sums over some 400 intervals [-]."""


@pytest.fixture(scope="module")
def sortie():
    return flown("ec120b", "ec120b-sortie")


def test_an_accessory_takes_its_own_power_in_every_phase(sortie):
    """The powers of the phases go from 60 to 315 kW; the pump's stays."""
    pump, turbine = sortie.machines["oil-pump"].power, sortie.machines["arrius-2f"].power
    assert turbine.max() > 4.0 * turbine.min()
    assert pump == pytest.approx(-sortie.sizing.design.accessories["oil-pump"].power, rel=ROUNDING)


def test_a_tail_rotor_takes_the_part_of_the_first_case(sortie):
    """45 of 376 kW, of what the engine gives without bearings' friction and windage: 1 % of it at the most."""
    ratio = -sortie.machines["tail-drive"].power / sortie.machines["arrius-2f"].power
    assert ratio == pytest.approx(45.0 / 376.0, rel=0.01)


def test_energy_closes_with_consumers(sortie):
    """Without what accessories and the tail rotor take, 2.7 % of the fuel's energy would be missing."""
    balance = sortie.balance
    assert balance.residual < ROUNDING
    taken = sum(-(sortie.machines[name].power * sortie.history.duration).sum() for name in ("oil-pump", "tail-drive"))
    assert balance.consumers == pytest.approx(taken, rel=ROUNDING)
    assert balance.consumers > 0.02 * balance.fuel


def test_power_balances_in_every_interval_with_consumers(sortie):
    history = sortie.history
    given = sum(machine.power for machine in sortie.machines.values())
    out = history.propeller_power + history.gearbox_heat + history.spin_up
    assert given == pytest.approx(out, rel=ROUNDING)


def test_a_propeller_keeps_its_asked_power_beside_an_accessory():
    """A map asks the propeller for its power; an accessory of 30 kW loads the turbine alone, and its fuel with it."""
    text = shipped_design("in-line").read_text(encoding="utf-8")
    design, loaded = parse(text), parse(text + '[accessories.pump]\nshaft = "input"\npower_kw = 30\n')
    mission = parse_mission(
        'schema = 1\nname = "test"\n[engine]\nthermal_power_kw = 2600\n[phases.one]\naltitude_ft = 5000\n'
        "cas_kt = 170\nduration_min = 2\npitch_deg = 30\npropeller_speed_rpm = 1212\n"
    )
    plain, flight = fly(size(design), mission), fly(size(loaded), mission)
    assert flight.history.propeller_power == pytest.approx(plain.history.propeller_power, rel=1e-9)
    history = flight.history
    assert history.turbine_power == pytest.approx(history.propeller_power + history.gearbox_heat + 30e3, rel=ROUNDING)
    assert flight.balance.residual < ROUNDING
