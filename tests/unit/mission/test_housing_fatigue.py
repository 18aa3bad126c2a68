"""What tires a housing: starts, changes of load and vibration at every section, over load cases and over a flight."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from designs import PAIR
from gearwright.catalogue import housing_materials
from gearwright.checks import Status
from gearwright.dynamics.vibration import forced_factors, row_swings, support_forces
from gearwright.mission.lives import housing_checks, housing_sections
from gearwright.mission.lives.housing import (
    FLAT,
    Loaded,
    Loading,
    counted,
    duty_of_cases,
    duty_of_flight,
    seat_loadings,
)
from gearwright.parts.housing_fatigue import StressCycles, fatigue_safety
from gearwright.reviews import review_of
from gearwright.shipped import shipped_designs
from gearwright.sizing import size
from gearwright.sizing.casing import carried_bosses, shell_of
from gearwright.sizing.mass import complete_mass, held_torques, torque_about, weighed_wall
from gearwright.spec import edited, parse
from shipped_work import flown, sized

near = pytest.approx
LIGHT = housing_materials()["aluminium"]


def sections(sizing, flight=None):
    """Return the sections of a housing."""
    return housing_sections(sizing, flight, complete_mass(sizing).total)


def section(name, part, kind, flight=None):
    """Return one section of a shipped design, the least safe of its name."""
    return next(one for one in sections(sized(name), flight) if (str(one.part), one.section) == (part, kind))


@pytest.mark.parametrize("name", shipped_designs())
def test_every_shipped_design_has_its_housing_judged_or_says_why_not(name):
    sizing = sized(name)
    checks = list(housing_checks(sizing, sections(sizing)))
    if sizing.design.housing.own:
        assert {"shell fatigue"} < {check.mode for check in checks} | {"mount fatigue"}
        assert all(check.value > 0.0 for check in checks if check.status is not Status.NOT_ASSESSED)
    else:
        assert [(check.status, check.mode) for check in checks] == [(Status.NOT_ASSESSED, "shell fatigue")]


def test_a_shell_bears_its_torque_by_hand():
    """T/(2 A t) of the torque between engine and propeller, times K_A, over 84/103 for shear; 1.5 in its corners."""
    sizing, found = sized("in-line-h2-star"), section("in-line-h2-star", "housing", "shell")
    torque = max(abs(torque) for _, torque in held_torques(sizing))
    shear = 1.25 * torque / (2.0 * shell_of(sizing).section * weighed_wall(sizing).thickness)
    assert sizing.design.service.application_factor == 1.25
    assert found.stress == near(shear / (84.0 / 103.0), rel=1e-9)
    assert found.notch == near(1.5)
    swing = found.swing_range / 2.0
    assert found.start_range == near(1.5 * found.stress + swing, rel=1e-9)


def test_a_wall_and_its_flat_bound_by_hand():
    """A shaft of spur gears: F/(2π a t) with D = 1.6 d and a = 0.62 D; F B/2 tilts it besides, B = D/5."""
    sizing, found = sized("mixed-h2"), section("mixed-h2", "input.first", "wall")
    shaft = next(shaft for shaft in sizing.shafts if shaft.name == "input")
    wall, outside = weighed_wall(sizing).thickness, 1.6 * shaft.diameter
    force = 1.25 * max(bearing.radial_force for bearing in shaft.bearings)
    boss, pad = 0.62 * outside, force / 1.25 / (2.0 * outside * LIGHT.shear_strength)
    thick = max(wall, pad)
    pulled = force / (2.0 * math.pi * boss * thick)
    assert found.stress == near(pulled, rel=1e-3)
    edge = math.sqrt(shell_of(sizing).section / math.pi)
    tilted = 3.0 * force * 0.1 * outside / (math.pi * boss * thick**2) * (edge**2 - boss**2) / (edge**2 + boss**2)
    assert section("mixed-h2", "input.first", FLAT).stress == near(pulled + tilted, rel=1e-3)


def test_lugs_and_torque_arms_by_hand():
    """Four lugs, 0.6 w high and 0.5 w deep, of a tenth of the shell; arms of iron at 64 MPa, times K_A."""
    sizing, found = sized("in-line-h2-star"), section("in-line-h2-star", "housing", "mount")
    shell, torque = shell_of(sizing), 1.25 * max(abs(torque) for _, torque in held_torques(sizing))
    volume = 0.1 * shell.area * weighed_wall(sizing).thickness
    width = (volume / (4.0 * 0.5 * (0.6 + math.pi / 8.0 - math.pi / 4.0 * 0.35**2))) ** (1.0 / 3.0)
    weight = 2.5 * 9.80665 * complete_mass(sizing).total
    force = (torque / (shell.girth / (2.0 * math.pi) + 0.6 * width) + weight) / 4.0
    assert found.stress == near(6.0 * force * 0.6 * width / (0.5 * width**3), rel=1e-9)
    assert found.swing_range == 0.0
    iron = housing_materials()["cast-iron"]
    assert section("wind-turbine-5mw", "housing", "arm").stress == near(1.25 * iron.bending_strength, rel=1e-9)


def test_starts_are_the_life_over_what_the_cases_last_together_or_over_the_stated_hours():
    """EC120B's cases with durations last an hour together; a design without durations has one start an hour."""
    durations = [case.duration for case in sized("ec120b").design.cases.values() if not case.static]
    assert sum(durations) == near(3600.0)
    assert section("ec120b", "housing", "shell").starts == near(sized("ec120b").design.service.life / 3600.0)
    stated = edited(sized("in-line-h2").design, {"housing.start_interval_h": 0.5})
    (shell,) = (one for one in sections(size(stated)) if one.section == "shell")
    assert shell.starts == near(2.0 * section("in-line-h2", "housing", "shell").starts)


def test_a_load_that_turns_round_counts_with_both_of_its_sides():
    """A car that coasts pushes its teeth the other way: from peak to peak is more than from rest to the peak."""
    found = section("e-axle", "layshaft.first", "wall")
    assert found.start_range > 1.1 * found.notch * found.stress
    assert found.changes > 0.0


def test_a_period_of_two_loads_is_counted_by_hand():
    """From rest to 40, to −20, to 30 MPa and to rest: −20 to 40 once, 0 to 31 once; ±1 MPa at 1 kHz for 10 s beside."""
    duty = duty_of_cases(sized("in-line-h2"))._replace(time=np.array([0.0, 0.0, 10.0]), uses=100.0)
    loading = Loading(np.array([40e6, -20e6, 30e6]), np.array([0.0, 0.0, 1e6]), np.array([1e3, 1e3, 1e3]))
    found = counted(Loaded(sized("in-line-h2").gears[0].part, "web", loading, 2.0), duty, LIGHT)
    assert (found.start_range, found.starts) == (near(120e6), 100.0)
    assert (found.change_range, found.changes) == (near(62e6), near(100.0))
    assert (found.swing_range, found.swings) == (near(4e6), near(1e6))
    cycles = [StressCycles(120e6, 100.0), StressCycles(62e6, 100.0), StressCycles(4e6, 1e6)]
    assert found.safety == near(fatigue_safety(LIGHT.curve, cycles, spectrum=0.3))
    assert found.start_share + found.swing_share < 1.0


@given(st.floats(1.0, 5.0), st.floats(1.0, 100.0))
@settings(max_examples=25)
def test_more_torque_or_more_life_never_makes_a_section_safer(more, longer):
    """All sections of a gearbox on two plain shafts, with the loads of a design times a factor, for a longer life."""
    sizing = sized("mixed-h2")
    material, duty = LIGHT, duty_of_cases(sizing)
    harder = duty._replace(torques=more * duty.torques)
    older = duty._replace(uses=longer * duty.uses)
    for name, loading in seat_loadings(sizing, duty).items():
        one = Loaded(sizing.gears[0].part, "wall", loading.radial.times(2e3), 1.5)
        heavy = one._replace(stress=seat_loadings(sizing, harder)[name].radial.times(2e3))
        safety = counted(one, duty, material).safety
        assert counted(heavy, harder, material).safety == near(safety / more, rel=1e-6)
        assert counted(one, older, material).safety <= safety * (1.0 + 1e-9)


def test_a_longer_life_and_a_higher_application_factor_lower_reserves_of_a_design():
    """Every section by load, at least in proportion; by life those that starts tire, and none is safer."""
    service = '[service]\nlife_h = 2000\napplication_factor = 1.25\n[gears]\nrating = "iso6336"\n[pairs.stage]'
    sizing = size(parse(PAIR.replace('level = "concept"\n', "").replace("[pairs.stage]", service)))
    before = safeties(sizing)
    older, harder = (
        safeties(dataclasses.replace(sizing, design=edited(sizing.design, {key: value})))
        for key, value in (("service.life_h", 40_000), ("service.application_factor", 2.0))
    )
    assert older.keys() == harder.keys() == before.keys()
    assert all(older[one] <= before[one] for one in before)
    assert older["housing", "mount"] < before["housing", "mount"]
    loaded = [one for one in before if one[1] != "mount"]  # weight does not grow with K_A
    assert all(harder[one] <= before[one] * 1.25 / 2.0 * (1.0 + 1e-9) for one in loaded)
    assert harder["housing", "mount"] < before["housing", "mount"]


def safeties(sizing):
    """Return part and section -> safety."""
    return {(str(one.part), one.section): one.safety for one in sections(sizing)}


def test_planets_that_mesh_in_turn_shake_the_housing_less_than_each_shakes_its_teeth():
    teeth, together = forced_factors(sized("in-line"), "rated"), row_swings(sized("in-line"), "rated")
    assert all(together[name] <= factor - 1.0 + 1e-12 for name, factor in teeth.items())
    assert any(together[name] < 0.5 * (factor - 1.0) for name, factor in teeth.items())
    pair = row_swings(sized("off-set"), "rated")
    assert all(pair[name] == near(factor - 1.0) for name, factor in forced_factors(sized("off-set"), "rated").items())


def test_shafts_that_the_design_lets_move_give_their_supports_forces():
    """Face gears on supports: half of what the support of the output swings by, times K_A, goes to each bearing."""
    sizing = sized("face-gear-split-torque")
    swing = support_forces(sizing, "rated")["output"].swing
    found = seat_loadings(sizing, duty_of_cases(sizing))
    factor = sizing.design.service.application_factor
    assert found["output.first"].radial.swing.max() == near(factor * swing / 2.0)
    assert swing > 0.0


def test_a_flight_is_a_cycle_of_use_and_its_machines_balance():
    """What machines give over the flight is what is lost and what spins up; starts are the life over its duration."""
    flight = flown()
    duty = duty_of_flight(flight)
    given = sum(duty.machines[name] * flight.speed(shaft) for name, shaft in flight.sizing.train.machines.items())
    spent = flight.history.gearbox_heat + flight.history.spin_up
    through = np.abs(flight.history.propeller_power).max()
    assert np.all(np.abs(given - spent) < 0.02 * through)
    shell = section("in-line-h2", "housing", "shell", flight)
    assert shell.starts == near(flight.sizing.design.service.life / flight.duration)
    assert shell.changes > shell.starts
    way, _ = held_torques(flight.sizing)[0]
    assert torque_about(flight.sizing, duty.machines, way).shape == (len(flight.phase),)


def test_a_review_of_a_flight_names_the_mission_at_the_housing():
    checks = [check for check in review_of(sized(), flown()).checks if check.mode.endswith("fatigue") and not check.why]
    assert {check.case for check in checks if str(check.part) == "housing"} == {flown().mission.name}


def test_a_flat_wall_may_prove_that_ribs_are_not_needed_and_never_that_they_do_not_do():
    sizing = sized("ec120b")
    flat = [one for one in sections(sizing) if one.section == FLAT]
    checks = list(housing_checks(sizing, sections(sizing)))
    told = [check for check in checks if check.mode == "flat wall fatigue"]
    thin = {str(one.part) for one in flat if one.safety < 1.35}
    assert (
        thin
        and {str(check.part) for check in told if check.value is not None} == {str(one.part) for one in flat} - thin
    )
    (left,) = (check for check in told if check.value is None)
    assert all(name in left.why for name in thin)
    assert not any(check.fails for check in checks)


def test_webs_have_the_stress_that_they_are_sized_by_times_k_a():
    """Webs of aluminium are as thick as 103/3.5 = 29.4 MPa asks under forces of one case without K_A."""
    sizing = sized("ec120b")
    found = [one for one in sections(sizing) if one.section == "web"]
    assert max(one.stress for one in found) == near(1.25 * LIGHT.bending_strength, rel=1e-6)
    bosses = [one for one in carried_bosses(sizing, weighed_wall(sizing).thickness) if one.found]
    judged = {str(one.part) for one in sections(sizing)}
    assert all(judged & set(one.bearings) for one in bosses)


def test_the_asked_safety_is_a_key_of_the_design_and_what_fails_can_be_waived():
    name = "housing shell fatigue"
    design = edited(sized("in-line-h2").design, {"housing.fatigue_safety": 2.0, f'waivers."{name}"': "cast thicker"})
    sizing = size(design)
    (shell,) = (check for check in review_of(sizing).checks if check.name == name)
    assert shell.limit == 2.0
    assert shell.status is Status.FAILS and not shell.fails
    assert math.isclose(shell.margin, shell.value / 2.0)
