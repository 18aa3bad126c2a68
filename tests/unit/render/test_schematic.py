from itertools import combinations

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from gearwright.render.schematic import power_flow_figure, schematic_figure, source_colours, trace_power
from gearwright.render.skeleton import lay_out
from gearwright.render.style import Board
from gearwright.render.vector.figure import Axes, Box, TextMark
from gearwright.render.vector.layout import text_width, words_box
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import parse, read
from gearwright.train import build_train

NAMES = ["in-line-h2", "off-set", "mixed", "twin", "star"]
DIFFERENTIAL = """
name = "Differential"
level = "concept"
shafts = ["input", "electric", "output"]
turbines.gas-turbine = { shaft = "input", power_kw = 1046, speed_rpm = 20000 }
motors.motor = { shaft = "electric", power_kw = 300, speed_rpm = 1500 }
propellers.propeller = { shaft = "output", speed_rpm = 5000, diameter_m = 3.9 }
planetaries.only = { sun = "input", ring = "electric", carrier = "output", sun_teeth = 30, planet_teeth = 30 }
"""


def layout_of(sizing):
    return lay_out(sizing.train, sizing.gears, {machine.name: machine.kind for machine in sizing.machines})


def overlapping(figure):
    axes, frame = figure.axes[0], (0.0, 0.0, figure.width, figure.height)
    boxes = [(words.text, shrunk(words_box(words, axes, frame))) for words in axes.of(TextMark)]
    return [(a, b) for (a, one), (b, other) in combinations(boxes, 2) if meet(one, other)]


def shrunk(box):
    """Lines of one label stand one below the other without room between."""
    return (box[0] + 0.15, box[1] + 0.15, box[2] - 0.15, box[3] - 0.15)


def meet(one, other):
    return min(one[2], other[2]) > max(one[0], other[0]) and min(one[3], other[3]) > max(one[1], other[1])


@pytest.mark.parametrize("name", shipped_designs())
def test_no_two_labels_overlap_in_any_shipped_design(name) -> None:
    sizing = size(read(shipped_design(name)))
    figures = [schematic_figure(sizing), *(power_flow_figure(sizing, case) for case in sizing.flows)]
    assert [overlapping(figure) for figure in figures] == [[] for _ in figures]


def test_labels_avoid_what_is_drawn_and_each_other() -> None:
    """Both want the middle of a gear: the first goes above it, the second beside the first."""
    board = Board(Axes())
    board.axes.rectangle((-5.0, -5.0), 10.0, 10.0)
    board.take_parts()
    places = [(0.0, 0.0), (0.0, 10.0), (30.0, 10.0)]
    first, second = board.place("input", places), board.place("output", places)
    assert (first[0] + first[2], first[1] + first[3]) == pytest.approx((0.0, 20.0))
    assert (second[0] + second[2], second[1] + second[3]) == pytest.approx((60.0, 20.0))


def test_a_label_is_as_wide_as_matplotlib_draws_it() -> None:
    figure = Figure(dpi=254)
    text = figure.text(0.1, 0.5, "16035 N m", fontsize=7.0, weight="bold", family="DejaVu Sans")
    drawn = text.get_window_extent(FigureCanvasAgg(figure).get_renderer()).width / 10.0
    assert text_width("16035 N m", 7.0) == pytest.approx(drawn, rel=0.03)  # hinting rounds to pixels


def test_a_motor_that_feeds_a_stage_from_its_own_shaft_stands_before_it() -> None:
    """Its axis lies on the height of the output's: behind the stage the two would run into each other."""
    layout = layout_of(size(read(shipped_design("off-set-h1"))))
    motor, output = layout.spans["motor"], layout.spans["output"]
    assert layout.heights["motor"] == pytest.approx(layout.heights["output"], abs=1e-9)
    assert motor[1] < output[0]


@pytest.mark.parametrize("name", NAMES)
def test_a_train_without_any_sizing_is_drawn_with_all_its_names(designs, name) -> None:
    train = designs[name].train
    written = {words.text for words in schematic_figure(train).axes[0].of(TextMark)}
    assert set(train.machines) | set(train.machines.values()) <= written


def test_gears_are_drawn_to_one_scale(in_line_h2) -> None:
    layout = layout_of(in_line_h2)
    drawn = schematic_figure(in_line_h2).axes[0].of(Box)
    for gear in in_line_h2.gears:
        if gear.role == "sun":
            wanted = (gear.face_width * layout.scale, gear.pitch_diameter * layout.scale)
            assert any((p.width, p.height) == pytest.approx(wanted) for p in drawn), gear.name


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
    written = " ".join(words.text for words in schematic_figure(designs["off-set"]).axes[0].of(TextMark))
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


def test_more_machines_than_colours_each_have_a_band() -> None:
    """Eight motors on one wheel and seven colours: the first seven differ, and the eighth has one of them again."""
    motors = "".join(
        f'motors.t{k} = {{ shaft = "s{k}", power_kw = 100, speed_rpm = 6000 }}\n'
        f'pairs.p{k} = {{ pinion = "s{k}", wheel = "o" }}\n'
        for k in range(8)
    )
    shafts = ", ".join(f'"s{k}"' for k in range(8))
    sizing = size(
        parse(f'name = "m"\nshafts = ["o", {shafts}]\nloads.l = {{ shaft = "o", speed_rpm = 1000 }}\n{motors}')
    )
    (flow,) = sizing.flows.values()
    found = source_colours(sizing.train, flow, {machine.name: machine.kind for machine in sizing.machines})
    assert list(found) == [f"t{k}" for k in range(8)]
    assert len(set(list(found.values())[:7])) == 7
    assert power_flow_figure(sizing, next(iter(sizing.flows))).axes[0].marks
