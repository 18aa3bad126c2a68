"""Critical speeds: margins, what is excited, and what a run says of the estimate."""

import math
from functools import cache

import numpy as np
import pytest

from gearwright.checks import Status
from gearwright.dynamics import Model, campbell
from gearwright.dynamics.assembly import assemble, assumptions
from gearwright.dynamics.model import Tone
from gearwright.dynamics.vibration import (
    RESONANCE,
    SEPARATION,
    answer,
    critical_speeds,
    first_meshes,
    order_name,
    resonance_checks,
    run_up,
    turning_shaft,
)
from gearwright.errors import DesignError
from gearwright.render.tables.dynamics import (
    ByMachine,
    Critical,
    critical_rows,
    critical_table,
    machine_rows,
    machine_table,
)
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import parse


@cache
def sized(name="in-line-h2", more=""):
    return size(parse(shipped_design(name).read_text(encoding="utf-8") + more))


SIZING = sized()
FOUND = critical_speeds(SIZING)[0]


def test_cases_of_equal_speeds_share_a_diagram_and_the_worst_comes_first():
    assert FOUND.cases == "rated, cruise"
    excited = [each for each in FOUND.critical if each.excited]
    assert list(FOUND.critical[: len(excited)]) == excited
    assert [each.over_limit for each in excited] == sorted(each.over_limit for each in excited)


@pytest.mark.parametrize("design", shipped_designs())
def test_the_review_and_the_table_of_critical_speeds_agree_number_by_number(design):
    """n_op/n − 1 of the nearest excited critical speed of every order, its limit, and the word that follows of both."""
    cases = critical_speeds(sized(design))
    judged = {(check.case, check.mode): check for check in resonance_checks(sized(design), cases)}
    judged = {key: check for key, check in judged.items() if not check.place.startswith("no natural frequency")}
    told = dict[tuple[str, str], list[ByMachine | Critical]]()
    for case in cases:
        operating = abs(case_speed(design, case.first))
        for row in (*critical_rows(case.critical), *machine_rows(case)):
            assert row.separation_margin == pytest.approx(operating / row.speed - 1.0, rel=1e-9, abs=1e-12)
            if row.verdict in ("in resonance", "clear"):
                assert row.limit is not None
                assert (row.verdict == "in resonance") == (abs(row.separation_margin) < row.limit)
                told.setdefault((case.cases, f"resonance of {row.order.replace('×', 'x')}"), []).append(row)
    assert judged.keys() == told.keys()
    for key, check in judged.items():
        nearest = min(told[key], key=lambda row: abs(row.separation_margin))
        assert (check.value, check.limit) == (abs(nearest.separation_margin), nearest.limit)
        assert check.place == f"mode {nearest.mode}"
        assert (check.status is Status.FAILS) == any(row.verdict == "in resonance" for row in told[key])


def case_speed(design, case):
    sizing = sized(design)
    return sizing.flows[case].speeds[turning_shaft(sizing, case)]


@pytest.mark.parametrize("design", shipped_designs())
def test_api_617_asks_for_nothing_where_the_same_teeth_meet(design):
    """API 617 is made for what comes once or several times in a turn of a shaft; hunting teeth meet less often."""
    cases = critical_speeds(sized(design))
    hunting = [row for case in cases for row in case.assumed if "hunting tooth" in row.order]
    assert all(row.criterion is None and not row.in_resonance for row in hunting)
    assert not any("hunting tooth" in check.mode for check in resonance_checks(sized(design), cases))


def test_a_turning_shaft_is_held_against_api_617_and_a_mesh_against_iso_6336():
    """ISO 6336-1, clause 6, tells of the mesh frequency; an error that turns with its gear shakes once in a turn."""
    sizing = sized(more='\n[errors."first.sun"]\neccentricity_um = 10\n')
    (case,) = critical_speeds(sizing)
    clauses = {("turning" in row.order): row.criterion for row in case.critical if row.criterion}
    assert clauses == {True: SEPARATION, False: RESONANCE}


def test_the_table_leaves_out_no_row_in_resonance():
    (case,) = critical_speeds(sized("face-gear-split-torque"))
    for table, rows in ((critical_table, case.critical), (machine_table, case.assumed)):
        within = sum(row.excited and row.in_resonance for row in rows)
        verdicts = [row[-1].text for row in table(case, maximum=1).rows]
        assert verdicts.count("in resonance") == within > 1


def test_a_campbell_diagram_without_speeds_is_that_of_the_critical_speeds():
    diagram = campbell(FOUND.system)
    assert (diagram.factor[0], diagram.factor[-1]) == (0.1, 1.5)
    np.testing.assert_array_equal(diagram.frequency, FOUND.campbell.frequency)
    assert diagram.crossings == FOUND.campbell.crossings


def test_at_a_critical_speed_the_order_has_the_natural_frequency():
    """f = l z_s (n_s − n_c)/60 at the critical speed: kinematics with the teeth of the sizing."""
    one = next(each for each in FOUND.critical if each.order == "second mesh × 2")
    speeds = SIZING.flows["rated"].speeds
    teeth, relative = SIZING.teeth["second.sun"], speeds["intermediate"] - speeds["output"]
    assert one.frequency == pytest.approx(
        2.0 * teeth * relative / (2.0 * math.pi) / (1.0 + one.separation_margin), rel=1e-9
    )
    assert one.speed == pytest.approx(speeds["input"] / (1.0 + one.separation_margin), rel=1e-9)


def test_three_planets_in_phase_do_not_excite_their_planet_modes():
    """Parker 2000: z_s l mod N = 0 excites rotational modes alone; the first sun has a multiple of three teeth."""
    assert SIZING.teeth["first.sun"] % 3 == 0
    system = FOUND.system
    shapes = {each.mode for each in FOUND.critical if each.order.startswith("first mesh") and each.excited}
    values = FOUND.campbell.frequency[0]
    apart = np.abs(values[:, None] / values - 1.0)
    # One rigid mode stands before the elastic ones, and numbers count from 1.
    planet = {f"{place + 2}" for place in np.flatnonzero(np.sum(apart < 1e-6, axis=1) > 1)}
    assert len(planet) >= 4
    assert shapes.isdisjoint(planet)
    assert len(system.labels.coordinates) == len(values) + 1


@pytest.mark.parametrize(
    ("order", "tolerance"), [("first mesh", 0.1), ("second mesh × 2", 0.15), ("second mesh × 3", 0.45)]
)
def test_the_estimated_force_at_a_resonance_is_what_a_run_finds(order, tolerance):
    """First order in the stiffness variation (±10 to 25 %): 5 to 10 %, and short by 45 % where lower orders add up."""
    one = max((each for each in FOUND.critical if each.order == order), key=lambda each: each.dynamic_force)
    cruise = assemble(SIZING, "rated")
    lines = [name for name in cruise.labels.lines if "planet" in name]
    found = run_up(SIZING, cruise, [1.0 / (1.0 + one.separation_margin)], lines=lines, settle=0.05, window=0.02)
    place = [str(each) for each in found.orders].index(order)
    ratio = np.max(found.order_amplitude[0, :, place] / np.abs(found.mean[0]))
    assert ratio == pytest.approx(one.dynamic_force, rel=tolerance)


def test_every_case_and_order_has_a_name_that_a_designer_knows():
    orders = FOUND.campbell.orders
    names = {str(order_name(SIZING, order.tone)) for order in orders if order.excitation is None}
    names |= {str(order) for order in orders if order.excitation is not None}
    assert {"first mesh", "first mesh × 5", "second mesh", "gas-turbine 1P", "propeller blade pass"} <= names
    assert str(order_name(sized("off-set"), Tone((("first.pinion", 30),)))) == "first mesh × 2"


def test_an_unknown_case_is_refused_with_those_there_are():
    with pytest.raises(DesignError, match=r"there is no case 'climb'; allowed: cruise, rated"):
        critical_speeds(SIZING, cases=["climb"])


def test_a_slow_error_meets_the_inertia_of_a_train_without_loops_and_the_stiffness_of_a_closed_one():
    """Three planets in phase are no loop for an error that they share: F grows with f². Two layshafts are one."""
    free = np.abs(answer(SIZING, FOUND.system, "first.sun-planet", error=1e-6, top=1.0).force("first.sun-planet-1"))
    assert free[0] / free[-1] == pytest.approx(1e-6, rel=0.05)
    sizing = sized("off-set")
    held = np.abs(answer(sizing, assemble(sizing), "first.left", error=1e-6, top=1.0).force("first.left"))
    assert held[0] / held[-1] == pytest.approx(1.0, rel=1e-2)


def test_first_meshes_are_lines_of_the_system():
    assert first_meshes(SIZING, FOUND.system) == [
        "first.sun-planet-1",
        "first.planet-ring-1",
        "second.sun-planet-1",
        "second.planet-ring-1",
    ]


def test_an_answer_to_an_unknown_mesh_names_the_nearest():
    with pytest.raises(DesignError, match=r"did you mean first\.sun-planet\?"):
        answer(SIZING, FOUND.system, "firs.sun-planet", error=1e-6, top=1e4)


def test_assumptions_tell_given_from_default_and_computed():
    more = '\n[dynamics]\nmesh_damping = 0.05\nfidelity = "translational"\n[planetaries.first.bearings]\nsun_n_um = 0\n'
    sizing = sized(more=more)
    found = {each.path: each for each in assumptions(sizing, assemble(sizing))}
    assert (found["dynamics.mesh_damping"].value, found["dynamics.mesh_damping"].origin) == ("0.05", "given")
    assert found["dynamics.shaft_damping"].origin == "default"
    assert found["planetaries.first.bearings.sun_n_um"].value == "none: floats"
    assert found["planetaries.second.bearings.pin_n_um"].origin == "computed"
    assert found["propellers.propeller.inertia_kg_m2"].origin == "computed"


def test_run_up_refuses_speeds_and_lines_that_cannot_be():
    with pytest.raises(DesignError, match="positive"):
        run_up(SIZING, FOUND.system, [0.0, 1.0], lines=["first.sun-planet-1"])
    with pytest.raises(DesignError, match=r"did you mean first\.sun-planet-1\?"):
        run_up(SIZING, FOUND.system, [1.0], lines=["first.sun-planet-11"])


def test_a_model_without_tones_has_shaft_orders_alone():
    """Written by hand: two discs that turn; only their turning can excite."""
    model = Model()
    model.rotation("one", inertia=1.0, speed=100.0)
    model.rotation("other", inertia=1.0)
    model.shaft("shaft", "one", "other", stiffness=1e4)
    diagram = campbell(model.build(), [0.5, 3.0])
    assert [str(order.tone) for order in diagram.orders] == ["1 one"]
    assert diagram.crossings[0].factor == pytest.approx(math.sqrt(2e4) / 100.0)
