"""Strategies: what each rule makes of an interval, and the optimal share against brute force and a closed form."""

import itertools

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.machines import Battery, battery_step, current_of, stored_energy
from gearwright.mission import fly
from gearwright.mission.strategies import Demand, ShareCost, electric_share, optimal_plan
from gearwright.spec import StrategyRules, parse_mission, read_mission
from shipped_work import flown, sized

PACK = Battery(1e6, 800.0, 600.0, 0.05, 5.0, 0.1)


def part(flight, name, field):
    return getattr(flight.history, field)[np.array(flight.phase) == name]


def share(rule, power, charge=0.5, planned=0.0, available=1e6, **keys):
    return electric_share(StrategyRules(rule=rule, **keys), Demand(power, available, charge, 10.0), PACK, planned)


def test_each_rule_divides_power_as_it_says():
    assert share("share", 1e6, electric_share=0.3) == 0.3
    assert share("boost", 1.25e6, turbine_power=5e5) == pytest.approx(0.6)
    assert share("boost", 1.25e6) == pytest.approx(0.2)
    assert share("boost", 4e5, turbine_power=5e5) == 0.0
    assert (share("turbine-alone", 1e6), share("electric-taxi", 1e6)) == (0.0, 1.0)
    assert (share("regenerate", -1e5), share("regenerate", 1e5)) == (1.0, 0.0)
    assert share("charge", 8e5, charge_power=1e5) == pytest.approx(-0.125)
    assert share("charge", 9.5e5, charge_power=1e5) == pytest.approx(-5e4 / 9.5e5)
    assert share("optimal", 1e6, planned=0.4) == 0.4


def test_charging_ends_where_the_battery_is_full_enough():
    assert share("charge", 8e5, charge=0.96, charge_power=1e5) == 0.0
    room = stored_energy(PACK, 0.6) - stored_energy(PACK, 0.5999)
    assert share("charge", 8e5, charge=0.5999, charge_power=1e5, until_charge=0.6) == pytest.approx(-room / 10.0 / 8e5)


def test_the_shipped_mission_flies_by_its_rules():
    flight = flown(mission="strategies")
    assert flight.balance.residual < 1e-9
    assert part(flight, "taxi-out", "fuel_flow").max() == 0.0
    assert part(flight, "climb", "turbine_power") == pytest.approx(1e6, rel=1e-9)
    assert part(flight, "descent", "battery_power") == pytest.approx(0.0, abs=1e-6)
    charge = part(flight, "cruise", "state_of_charge")
    assert np.all(np.diff(charge) >= -1e-15)  # rounding of the charge that motors hold at the end
    assert charge[-1] == pytest.approx(0.6, abs=1e-3) and charge[-1] <= 0.6


def stages(powers, shares, duration=60.0):
    """Intervals in which a turbine burns 1e-7 kg/J, idles with 1e-3 kg/s and stops where its part is 0."""

    def stage(power):
        fuel = np.array([duration * (1e-3 + 1e-7 * power * (1.0 - u)) if u < 1.0 else 0.0 for u in shares])
        electric = power * np.array(shares)

        def after(charges):
            current, square = current_of(PACK, charges[:, None], electric[None, :], duration)
            return np.where(square < 0.0, np.nan, charges[:, None] - current * duration / PACK.charge)

        return ShareCost(fuel, after)

    return [stage(power) for power in powers]


def test_the_plan_is_the_best_of_all_combinations():
    powers, shares = (3e5, 9e5, 6e5, 4e5), (0.0, 0.25, 0.5, 0.75, 1.0)
    rows = stages(powers, shares)
    best = (np.inf, None)
    for combination in itertools.product(range(5), repeat=4):
        charge, fuel = 0.5, 0.0
        for power, place, stage in zip(powers, combination, rows, strict=True):
            charge = battery_step(PACK, charge, power * shares[place], 60.0).state_of_charge
            fuel += stage.fuel[place]
        if charge >= 0.42 and fuel < best[0]:
            best = (fuel, combination)
    plan = optimal_plan(rows, np.linspace(0.1, 1.0, 2001), start=0.5, end=0.42)
    assert plan.shares == best[1]
    assert plan.fuel == pytest.approx(best[0], rel=1e-12)
    assert plan.charge[-1] >= 0.42


def test_equal_intervals_share_alike_where_only_resistance_loses():
    """R I² is convex and fuel is linear in power: by Jensen's inequality no plan beats equal currents.

    Closed form at a constant voltage V: I = Q Δs/T, electric power V I - R I². 2e-3: 201 shares and 2001 states.
    """
    flat = Battery(1e6, 700.0, 700.0, 0.2, 5.0, 0.0)
    power, duration, count, drop = 5e5, 60.0, 6, 0.12
    shares = np.linspace(0.0, 0.99, 201)

    def after(charges):
        current, _ = current_of(flat, charges[:, None], (power * shares)[None, :], duration)
        return charges[:, None] - current * duration / flat.charge

    row = ShareCost(duration * 1e-7 * power * (1.0 - shares), after)
    plan = optimal_plan([row] * count, np.linspace(0.0, 1.0, 2001), start=0.5, end=0.5 - drop)
    current = flat.charge * drop / (count * duration)
    electric = 700.0 * current - 0.2 * current**2
    exact = count * duration * 1e-7 * (power - electric)
    assert plan.fuel == pytest.approx(exact, rel=2e-3)
    assert plan.fuel >= exact * (1.0 - 1e-6)
    assert plan.charge[-1] >= 0.5 - drop - 1e-9


def test_an_optimal_flight_burns_less_than_its_rules_at_the_same_charge():
    rules = flown(mission="strategies")
    end = float(part(rules, "approach", "state_of_charge")[-1])
    mission = read_mission("strategies")
    best = StrategyRules(rule="optimal", end_charge=end)
    taxi = "green-taxi"
    phases = {
        name: phase if phase.strategy == taxi else phase.model_copy(update={"strategy": "best"})
        for name, phase in mission.phases.items()
    }
    named = {taxi: mission.strategies[taxi], "best": best}
    flight = fly(sized(), mission.model_copy(update={"phases": phases, "strategies": named}))
    assert flight.fuel < 0.995 * rules.fuel
    assert part(flight, "approach", "state_of_charge")[-1] >= end
    assert flight.balance.residual < 1e-9


BASE = """
schema = 1
name = "test"
{tables}
[phases.one]
altitude_ft = 5000
cas_kt = 170
duration_min = 2
power_kw = 900
propeller_speed_rpm = 1212
{phase}
"""


@pytest.mark.parametrize(
    ("tables", "phase", "message"),
    [
        ("[battery]\nenergy_kwh = 100", 'strategy = "peek"', "there is no strategy 'peek'"),
        ('[strategies.peak]\nrule = "boost"', 'strategy = "peak"', "without a .battery."),
        ('[battery]\nenergy_kwh = 9\n[strategies.peak]\nrule = "share"', "", "strategies.peak: rule 'share' without"),
        ('[strategies.peak]\nrule = "boost"\nend_charge = 0.3', "", "strategies.peak.end_charge: .*optimal"),
        ('[battery]\nenergy_kwh = 9\n[strategies.a]\nrule = "boost"', 'strategy = "a"\nmode = "electric"', "keep one"),
    ],
)
def test_strategies_that_do_not_fit_are_told(tables, phase, message):
    with pytest.raises(DesignError, match=message):
        parse_mission(BASE.format(tables=tables, phase=phase))


def test_a_design_without_motors_flies_only_on_its_turbine():
    text = BASE.format(tables='[battery]\nenergy_kwh = 100\n[strategies.a]\nrule = "boost"', phase='strategy = "a"')
    with pytest.raises(DesignError, match="needs a motor, and the design has none"):
        fly(sized("in-line"), parse_mission(text))
    alone = text.replace("boost", "turbine-alone")
    assert fly(sized("in-line"), parse_mission(alone)).history.electric_share.max() == 0.0
