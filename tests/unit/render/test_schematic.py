from itertools import combinations

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.patches import Rectangle

from gearwright.render.schematic import power_flow_figure, schematic_figure
from gearwright.render.schematic_layout import lay_out
from gearwright.render.schematic_power import trace_power
from gearwright.spec import parse
from gearwright.train.graph import build_train

NAMES = ["in-line-h2", "off-set", "mixed", "twin", "star"]
DIFFERENTIAL = """
name = "Differential"
shafts = ["input", "electric", "output"]
turbines.gas-turbine = { shaft = "input", power_kw = 1046, speed_rpm = 20000 }
motors.motor = { shaft = "electric", power_kw = 300, speed_rpm = 1500 }
propellers.propeller = { shaft = "output", speed_rpm = 5000, diameter_m = 3.9 }
planetaries.only = { sun = "input", ring = "electric", carrier = "output", sun_teeth = 30, planet_teeth = 30 }
"""


def layout_of(sizing):
    return lay_out(sizing.train, sizing.gears, {machine.name: machine.kind for machine in sizing.machines})


def overlapping(figure):
    renderer = FigureCanvasAgg(figure).get_renderer()
    boxes = [(text.get_text(), text.get_window_extent(renderer)) for text in figure.axes[0].texts]
    return [(a, b) for (a, one), (b, other) in combinations(boxes, 2) if one.padded(-0.5).overlaps(other.padded(-0.5))]


@pytest.mark.parametrize("name", NAMES)
def test_no_two_labels_overlap_in_any_schematic_or_power_flow(designs, name) -> None:
    sizing = designs[name]
    figures = [schematic_figure(sizing), *(power_flow_figure(sizing, case) for case in sizing.flows)]
    assert [overlapping(figure) for figure in figures] == [[] for _ in figures]


@pytest.mark.parametrize("name", NAMES)
def test_a_train_without_any_sizing_is_drawn_with_all_its_names(designs, name) -> None:
    train = designs[name].train
    written = {text.get_text() for text in schematic_figure(train).axes[0].texts}
    assert set(train.machines) | set(train.machines.values()) <= written


def test_gears_are_drawn_to_one_scale(in_line_h2) -> None:
    layout = layout_of(in_line_h2)
    drawn = [patch for patch in schematic_figure(in_line_h2).axes[0].patches if isinstance(patch, Rectangle)]
    for gear in in_line_h2.gears:
        if gear.role == "sun":
            wanted = (gear.face_width * layout.scale, gear.pitch_diameter * layout.scale)
            assert any((p.get_width(), p.get_height()) == pytest.approx(wanted) for p in drawn), gear.name


def test_axes_of_a_pair_are_its_centre_distance_apart(designs) -> None:
    sizing = designs["mixed"]
    layout = layout_of(sizing)
    distance = sum(gear.pitch_diameter for gear in sizing.gears if gear.stage == "first") / 2.0
    assert layout.exact
    assert abs(layout.heights["input"] - layout.heights["lay"]) == pytest.approx(distance * layout.scale)
    assert layout.heights["lay"] == layout.heights["output"]


def test_parallel_layshafts_mirror_each_other_and_the_drawing_says_that_it_is_not_to_one_scale(designs) -> None:
    layout = layout_of(designs["off-set"])
    assert layout.heights["left"] == pytest.approx(-layout.heights["right"])
    assert layout.heights["input"] == pytest.approx(layout.heights["output"])
    assert not layout.exact
    written = " ".join(text.get_text() for text in schematic_figure(designs["off-set"]).axes[0].texts)
    assert "not to one scale" in written


def test_machines_stand_in_the_order_of_the_power(in_line_h2) -> None:
    places = layout_of(in_line_h2).places
    order = sorted(places, key=lambda name: places[name].x)
    assert order == ["gas-turbine", "first", "electric", "second", "propeller"]


def test_shafts_that_lie_one_in_the_other_get_different_levels() -> None:
    train = build_train(parse(DIFFERENTIAL))
    layout = lay_out(train, (), {"gas-turbine": "turbine", "motor": "motor", "propeller": "propeller"})
    assert layout.levels == {"input": 0, "output": 0, "electric": 1}


def test_power_mixes_in_the_shares_of_its_sources(in_line_h2) -> None:
    """Rated: 1046 kW of the turbine meet 1005 kW of the motor; the output shaft carries both."""
    flow = in_line_h2.flows["rated"]
    stretches, _ = trace_power(in_line_h2.train, flow, layout_of(in_line_h2))
    output = next(each for each in stretches if each.shaft == "output")
    assert output.power == pytest.approx(2051e3)
    assert output.torque == pytest.approx(16035.0, abs=0.5)  # the printed digits
    assert output.sources == pytest.approx({"gas-turbine": 1046 / 2051, "electric": 1005 / 2051})


def test_a_generator_takes_power_off_the_shaft_that_it_sits_on(designs) -> None:
    sizing = designs["mixed"]
    stretches, _ = trace_power(sizing.train, sizing.flows["charge"], layout_of(sizing))
    lay = sorted((each for each in stretches if each.shaft == "lay"), key=lambda each: each.start)
    assert [each.power for each in lay] == pytest.approx([1046e3, 846e3])
    assert all(each.sources == pytest.approx({"gas-turbine": 1.0}) for each in lay)


def test_an_engine_behind_an_open_clutch_carries_nothing(designs) -> None:
    sizing = designs["twin"]
    stretches, _ = trace_power(sizing.train, sizing.flows["engine-two-out"], layout_of(sizing))
    idle = [each for each in stretches if each.shaft in ("two", "second-in")]
    assert len(idle) == 2
    assert all(abs(each.power) < 1e-6 for each in idle)
