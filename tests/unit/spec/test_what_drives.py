"""One sign for the amounts of a case: into the train is positive, and what takes power usually says when it drives."""

from __future__ import annotations

import pytest

from designs import PAIR, problem, problems
from gearwright.sizing import size
from gearwright.spec import parse
from gearwright.spec.design import MACHINES

PUMP = '[loads.pump]\nshaft = "fast"\npower_kw = 50\n'
CASE = "[cases.one.turbine]\nrating = 1\n"
TABLES = {
    "turbines": 'speed_rpm = 6000\npower_kw = 100\nshaft = "fast"\n',
    "motors": 'speed_rpm = 6000\npower_kw = 100\nshaft = "fast"\n',
    "generators": 'speed_rpm = 6000\npower_kw = 100\nshaft = "fast"\n',
    "propellers": 'speed_rpm = 2000\ndiameter_m = 2\nshaft = "slow"\n',
    "rotors": 'speed_rpm = 2000\ndiameter_m = 2\nshaft = "slow"\n',
    "accessories": 'power_kw = 2\nshaft = "fast"\n',
    "loads": 'power_kw = 2\nshaft = "fast"\n',
}


def flow(text):
    """Return the powers of the one case."""
    return size(parse(text)).flows["one"].machine_powers


def test_a_load_takes_by_its_table_and_by_its_case_the_same():
    by_table, by_case = flow(PAIR + PUMP + CASE), flow(PAIR + PUMP + CASE + "[cases.one.pump]\npower_kw = -50\n")
    assert by_table == pytest.approx(by_case)
    assert by_table["pump"] == pytest.approx(-50e3)
    assert by_table["propeller"] == pytest.approx(-50e3)


def test_a_load_that_a_case_lets_give_power_says_so():
    found = problem(PAIR + PUMP + CASE + "[cases.one.pump]\npower_kw = 50\n")
    assert found.path == "cases.one.pump.power_kw"
    assert found.message == (
        "50 kW: this machine (load) takes power, and what a case takes is negative; write -50 kW, or drives = true"
        " beside it if it gives power"
    )
    driven = flow(PAIR + PUMP + CASE + "[cases.one.pump]\npower_kw = 50\ndrives = true\n")
    assert (driven["pump"], driven["propeller"]) == (pytest.approx(50e3), pytest.approx(-150e3))


@pytest.mark.parametrize("kind", MACHINES)
@pytest.mark.parametrize("amount", ["power_kw = 1", "torque_nm = 10"])
def test_more_than_nothing_is_given_by_what_drives_or_is_said_to(kind, amount):
    """Turbines and motors always drive, generators and accessories never; the others where a case says so."""
    machine, name = MACHINES[kind], MACHINES[kind].__name__.lower()
    head = f"{PAIR}[{kind}.other]\n{TABLES[kind]}{CASE}[cases.one.other]\n"
    text, taken = f"{head}{amount}\n", f"{head}{amount.replace('= ', '= -')}\n"
    if machine.drives:
        parse(text)
        assert problem(f"{text}drives = true\n").message == f"a {name} always drives; leave it out"
        return
    assert problem(text).path == f"cases.one.other.{amount.split()[0]}"
    if machine.gives:
        assert parse(f"{text}drives = true\n").cases["one"].machines["other"].drives
        assert problem(f"{taken}drives = true\n").message.startswith(
            "what it gives is not said; give a power or torque"
        )
    else:
        assert f"a {name} never drives; leave it out" in [found.message for found in problems(f"{text}drives = true\n")]
