import pytest
from drawn_designs import MIXED, sized

from gearwright.particulars import particulars
from gearwright.render.tables.dynamics import energy_table, mode_table, motion_tables
from gearwright.render.tables.sizing import flow_tables, tables_of
from gearwright.sizing import asked_speeds, bearing_forces, mass_parts
from gearwright.spec import GROUND
from gearwright.spec.design import NO_ORIGIN
from gearwright.train import branches


def test_the_parts_on_every_shaft_are_in_balance_in_every_case(designs) -> None:
    """Σ T = 0 on every shaft: no part of the power flow is left out or counted twice."""
    for sizing in designs.values():
        for flow in sizing.flows.values():
            found = branches(sizing.train, flow)
            largest = max(abs(each.torque) for each in found)
            for shaft in sizing.design.shafts:
                total = sum(each.torque for each in found if each.shaft == shaft)
                assert abs(total) < 1e-9 * largest, (sizing.design.name, flow.case, shaft)  # rounding of the statics


def test_the_ground_takes_the_reaction_of_the_rings(in_line_h2) -> None:
    found = branches(in_line_h2.train, in_line_h2.flows["rated"])
    held = {str(each.part) for each in found if each.shaft == GROUND}
    assert held == {"first.ring", "second.ring"}
    assert sum(each.power for each in found if each.shaft == GROUND) == 0.0


def test_margins_come_worst_first_with_every_check(in_line_h2) -> None:
    found = in_line_h2.checks
    assert not any(check.ratio is None for check in found)
    strength = 2 * len(in_line_h2.meshes) + len(in_line_h2.shafts) + 4 * len(in_line_h2.carriers)
    # Undercut, contact ratio, three interferences, neighbours and pins of every planetary set.
    assert len(found) == strength + 7 * len(in_line_h2.carriers)
    moved = [check.margin for check in found if check.exponent is not None]
    assert moved == sorted(moved, key=lambda value: round(value, 9))
    assert [check.exponent is None for check in found] == sorted(check.exponent is None for check in found)
    assert found[0].margin == pytest.approx(in_line_h2.worst_margin, abs=1e-9)
    assert not any(each.fails for each in found)


def test_a_stress_above_its_allowable_does_not_hold() -> None:
    worst = sized(MIXED + '[overrides]\n"lay.diameter_mm" = 20\n').checks[0]
    assert (worst.name, worst.fails) == ("lay Tresca", True)
    assert worst.value > worst.limit


def test_the_mass_breakdown_adds_up(designs) -> None:
    for sizing in designs.values():
        parts = mass_parts(sizing)
        assert sum(part.total for part in parts) == pytest.approx(sizing.parts_mass, rel=1e-12)  # summation order
        assert sum(part.share for part in parts) == pytest.approx(1.0, rel=1e-12)


def test_only_speeds_that_really_deviate_are_listed(in_line_h2) -> None:
    """The motor's speed is kept to rounding; the propeller's yields by 0.78 %."""
    assert {(each.case, each.machine) for each in asked_speeds(in_line_h2)} == {
        ("rated", "propeller"), ("cruise", "propeller"),
    }  # fmt: skip


def test_there_is_one_flow_table_a_case(in_line_h2) -> None:
    assert [each.title for each in flow_tables(particulars(in_line_h2).branches)] == ["Case rated", "Case cruise"]


def test_the_mode_table_lists_each_frequency_once_with_what_is_strained(modal) -> None:
    rows = mode_table(modal).rows
    assert len(rows) == 3
    assert [cell.text for cell in rows[0]][2:4] == ["rigid", "none"]
    assert rows[2][3].text == "first.mesh"  # the stiffest line holds the highest mode
    assert "2 higher ones" in mode_table(modal, maximum=1).note


def test_the_statistics_of_a_run_are_in_balance_with_its_loads(run) -> None:
    """500 N m over 0.05 m base radius is 10 kN, 5000 N m over 0.5 m as well; the run starts in equilibrium."""
    forces, torques = motion_tables(run)
    mean = forces.rows[0][1].value
    assert mean == pytest.approx(10e3, rel=0.01)  # the train as a whole speeds up a little: loads balance only nearly
    assert torques.rows[0][1].value == pytest.approx(mean * 0.05, rel=0.01)
    assert abs(energy_table(run).rows[0][-1].value) < 1e-6


def test_overrides_are_listed_as_written_with_their_origin() -> None:
    text = (
        MIXED
        + '[overrides]\n"lay.diameter_mm" = 80\n"gearbox.mass_kg" = 60\n[origins]\n"gearbox.mass_kg" = "weighed"\n'
    )
    rows = tables_of(particulars(sized(text)))["overrides"].rows
    assert [[cell.text for cell in row] for row in rows] == [
        ["lay.diameter_mm", "80.00", NO_ORIGIN], ["gearbox.mass_kg", "60.00", "weighed"],
    ]  # fmt: skip


def test_bearings_hold_the_shafts_that_gears_push_aside(designs) -> None:
    """The off-set input pinion is pushed equally from both sides; its layshafts are not."""
    loads = {}
    for each in bearing_forces(designs["off-set"]):
        loads.setdefault(each.shaft, []).append(each.radial_force)
    assert all(len(both) == 2 for both in loads.values())
    assert max(loads["input"]) < 1e-6 * max(loads["left"])
    assert bearing_forces(designs["star"]) == ()
