"""Figures and chapters of dynamics say what they must and are the same each time."""

import re

import numpy as np
import pytest

from gearwright.dynamics import Model, Outputs, campbell, modes, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.model import Bearing, Rotor, Segment, add_bearing, add_rotor
from gearwright.dynamics.vibration import answer, critical_speeds, first_meshes, peaks, run_up
from gearwright.errors import DesignError
from gearwright.particulars import particulars, reported
from gearwright.render.figures.dynamics import campbell_figure, diagram_figure, response_figure, waterfall_figure
from gearwright.render.figures.motion import (
    drawn_modes_figure,
    moving_centres,
    orbit_figure,
    phase_figure,
    transmission_error_figure,
)
from gearwright.render.pages.motion import dynamics_sections
from gearwright.render.style import to_svg
from gearwright.render.tables.dynamics import critical_table, excited_by, loudest_table, machine_table, peak_table
from gearwright.render.vector.figure import Figure, Shape, TextMark
from gearwright.render.vector.layout import key_rows
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import parse


def sized(name="in-line-h2", more=""):
    return size(parse(shipped_design(name).read_text(encoding="utf-8") + more))


SIZING = sized()
SYSTEM = assemble(SIZING)
REPORTED = reported(particulars(SIZING), SYSTEM)
FOUND = critical_speeds(SIZING)[0]
MOVING = sized(more='\n[dynamics]\nfidelity = "translational"\n')


def words(figure):
    """All texts of a figure."""
    if isinstance(figure, Figure):
        return figure.texts()
    return [text.get_text() for text in figure.findobj(lambda each: hasattr(each, "get_text")) if text.get_text()]


def test_the_campbell_figure_names_orders_and_the_nearest_critical_speeds():
    found = words(campbell_figure(SIZING, FOUND))
    assert {"second", "second × 2", "operating"} <= set(found)
    first = FOUND.critical[0]
    assert any(each.startswith(f"{first.order}, mode {first.mode}") for each in found)


def test_the_campbell_figure_is_the_same_each_time():
    assert to_svg(campbell_figure(SIZING, FOUND)) == to_svg(campbell_figure(SIZING, FOUND))


@pytest.mark.parametrize("design", shipped_designs())
def test_every_shipped_design_has_its_campbell_diagram_and_drawn_modes(design):
    sizing = sized(design)
    for found in critical_speeds(sizing):
        assert "Campbell diagram" in "".join(words(campbell_figure(sizing, found)))
    system = assemble(sizing)
    assert "2:" in "".join(words(drawn_modes_figure(particulars(sizing), system, modes(system), numbers=[2])))


def test_the_critical_table_says_which_speeds_are_in_resonance_and_which_not_excited():
    table = critical_table(FOUND, maximum=1000)
    verdicts = [row[-1].value for row in table.rows]
    assert set(verdicts) == {"in resonance", "clear", "not excited"}
    assert verdicts == sorted(verdicts, key=lambda each: each == "not excited")
    assert "more are left out" in critical_table(FOUND, maximum=3).note


def test_the_response_figure_shows_each_mesh_and_the_table_its_highest_peak_first():
    lines = first_meshes(SIZING, SYSTEM)
    found = answer(SIZING, SYSTEM, "first.sun-planet", error=1e-6, top=1e4)
    assert set(lines) <= set(words(response_figure(found, lines, title="answer")))
    forces = [row[-1].value for row in peak_table(found, lines, excited="an error").rows]
    assert forces == sorted(forces, reverse=True) and len(forces) > 3


def test_the_table_of_a_response_names_mesh_amplitude_and_case_and_lists_no_rounding():
    """An error in the second set leaves the first one still: its forces of 1e-14 N had a thousand maxima."""
    lines = first_meshes(SIZING, SYSTEM)
    found = answer(SIZING, SYSTEM, "second.sun-planet", error=2e-6, top=1e4)
    listed = peaks(found, lines)
    assert 0 < len(listed) < 30
    assert all(peak.force > 1e-9 * listed[0].force for peak in listed)
    table = peak_table(found, lines, excited=excited_by("second.sun-planet", 2e-6, "rated"))
    assert table.title == "Peaks: transmission error of 2 µm in second.sun-planet, case rated"


def test_the_swing_of_a_run_up_is_defined_and_is_the_root_mean_square_about_the_mean():
    """√(1/T ∫ (F − F_m)² dt): by Parseval √(½ Σ a²) of the amplitudes of its orders, where no other is there."""
    line = "second.sun-planet-1"
    found = run_up(SIZING, SYSTEM, [0.9, 1.0], lines=[line], settle=0.05, window=0.05)
    amplitude = found.order_amplitude[:, 0, :]
    np.testing.assert_allclose(found.swing[:, 0], np.sqrt(0.5 * np.sum(amplitude**2, axis=1)), rtol=0.02)
    assert "√(1/T ∫ (F − F_m)² dt)" in loudest_table(found, 1.0, case="rated").note


def test_the_waterfall_marks_the_operating_speed_and_its_orders():
    line = "second.sun-planet-1"
    found = run_up(SIZING, SYSTEM, [0.8, 1.0, 1.2], lines=[line], settle=0.005, window=0.01)
    speed = SIZING.flows["rated"].speeds["input"]
    texts = words(waterfall_figure(found, line, speed=speed, shaft="input"))
    assert {"operating", "second × 2", "second mesh"} <= set(texts)
    assert loudest_table(found, speed, case="rated").rows[0][0].value == line


def test_drawn_modes_move_only_the_set_that_takes_part():
    """A mode that lives in the second set alone: every disc of the first is drawn twice in one place."""
    system = assemble(MOVING)
    found = modes(system)
    own = [name.startswith("second.") for name in system.labels.coordinates]
    place = int(np.argmax(np.sum(found.shapes[own] ** 2 * system.arrays.mass[own, None], axis=0) > 0.999))
    figure = drawn_modes_figure(particulars(MOVING), system, found, numbers=[place + 1])
    first, second = figure.axes[1:]
    still, moved = ([np.mean(disc.points[:12], axis=0) for disc in axes.of(Shape)] for axes in (first, second))
    assert np.allclose(still[::2], still[1::2])
    assert not np.allclose(moved[::2], moved[1::2])


def test_paths_of_one_motion():
    system = assemble(MOVING)
    window = simulate(system, 0.01, outputs=Outputs(windows=((0.005, 0.01),))).windows[0]
    centres = moving_centres(window)
    assert ("second.sun.x", "second.sun.y") in centres
    assert ("second.planet-1.radial", "second.planet-1.tangential") in centres
    assert "second.sun" in words(orbit_figure(window, centres[:6]))
    assert "second.sun-planet-1" in words(phase_figure(window, ["second.sun-planet-1"]))
    figure = transmission_error_figure(window, ["second.sun-planet-1"], mesh_frequency=3100.0)
    assert "transmission error [µm]" in words(figure)


def test_orbits_are_refused_where_nothing_moves_across():
    window = simulate(SYSTEM, 0.002, outputs=Outputs(windows=((0.001, 0.002),))).windows[0]
    with pytest.raises(DesignError, match="fidelity"):
        orbit_figure(window)


def test_chapters_of_the_report_hold_every_figure_with_ids_of_its_own():
    trace = simulate(SYSTEM, 0.004, outputs=Outputs(windows=((0.002, 0.004),)))
    sections = dynamics_sections(REPORTED, SYSTEM, case="rated", modes=modes(SYSTEM), trace=trace, campbell=(FOUND,))
    titles = ["Critical speeds", "Mode shapes", "Transmission error and paths", "Assumptions of the dynamic model"]
    assert [section.title for section in sections] == titles
    ids = [
        name for section in sections for figure in section.figures for name in re.findall(r'\bid="([^"]+)"', figure.svg)
    ]
    assert len(ids) == len(set(ids)) > 10


def test_chapters_without_run_and_modes_are_the_assumptions_alone():
    sections = dynamics_sections(REPORTED, SYSTEM, case="rated")
    assert [section.title for section in sections] == ["Assumptions of the dynamic model"]


def test_the_diagram_of_a_rotor_tells_forward_from_backward_whirl():
    """Bending splits by the gyroscopic effect; torsion and axial motion do not turn."""
    model = Model()
    shaft = add_rotor(model, "shaft", Rotor([Segment(0.1, 0.05)] * 3), speed=2000.0)
    for station in (0, 3):
        add_bearing(model, f"bearing {station}", shaft.at(station), Bearing((1e8, 1e8)))
    axes = diagram_figure(campbell(model.build(), [0.5, 1.0])).axes[0]
    words = [mark.label for mark in key_rows(axes)]
    assert [word.split(",")[0] for word in words][:3] == ["natural frequency", "forward whirl", "backward whirl"]


def test_what_lies_below_300_hz_has_a_panel_with_every_order_by_name():
    figure = campbell_figure(SIZING, FOUND)
    titles = [axes.title for axes in figure.axes]
    low = next(axes for axes, title in zip(figure.axes, titles, strict=True) if "300 Hz" in title)
    assert low.get_ylim() == (0.0, 300.0)
    words = {mark.text for mark in low.of(TextMark)}
    assert {"propeller blade pass", "gas-turbine 1P", "second planet pass"} <= words


def test_the_table_of_machines_says_why_each_order_is_there():
    rows = {row.order: row for row in FOUND.assumed}
    assert rows["propeller blade pass"].why == "6 blades"
    assert "1 % of the mean torque" in machine_table(FOUND).note
