"""The two schematics: the skeleton of any train, and the power flow of a load case on it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearwright.errors import by_name
from gearwright.identity import Kind, Role
from gearwright.render.schematic.bands import Pen, band_scale, draw_bands, half_width, source_colours, spots
from gearwright.render.schematic.drawing import draw_train, gear_sides
from gearwright.render.schematic.layout import Layout, lay_out
from gearwright.render.schematic.power import NOTHING, Feed, Stretch, trace_power
from gearwright.render.style import theme
from gearwright.render.style.labels import Board
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure, Slot
from gearwright.render.vector.palette import tinted
from gearwright.render.vector.words import text_width
from gearwright.sizing import Sizing
from gearwright.train import PowerFlow, Train
from gearwright.units import shown, text, written

BORDER = 4.0
"""Around the drawing [mm]."""
_NOT_TRUE = "Parallel paths meet again: each mesh is in its true ratio, the axes are not to one scale."
_HANGING = (12.0, 16.0, 20.0, 26.0, 32.0, 40.0)
"""Distances from an axis at which a machine's name is tried [mm]."""


@theme.drawn
def schematic_figure(source: Train | Sizing) -> Figure:
    """Return the skeleton of a train: to scale where it is sized, in common proportions otherwise.

    Args:
        source: A train, or a sizing of one.
    """
    board, train, layout, kinds = _start(source)
    draw_train(board.axes, train, layout, kinds=kinds)
    board.take_parts()
    _name_machines(board, train, layout, {name: name for name in train.machines})
    _name_shafts(board, layout)
    if isinstance(source, Sizing):
        _number_teeth(board, train, layout, source)
    _caption_stages(board, layout, source if isinstance(source, Sizing) else None)
    scale = f"Radii and face widths 1 : {1e3 / layout.scale:.1f}" if isinstance(source, Sizing) else "Not to scale"
    title = source.design.name if isinstance(source, Sizing) else "Train"
    return _finish(board, [title, scale if layout.exact else _NOT_TRUE], {})


@theme.drawn
def power_flow_figure(sizing: Sizing, case: str) -> Figure:
    """Return the power flow of a case on the skeleton: bands as wide as the power, kW, N m and rpm on every branch.

    Args:
        sizing: As sized.
        case: Load case.
    """
    flow = by_name(case, sizing.flows, "case")
    board, train, layout, kinds = _start(sizing)
    traced = trace_power(train, flow, layout)
    pen = Pen(board.axes, band_scale(traced), source_colours(train, flow, kinds))
    opened = [joint.name for joint in train.joints if joint.name not in flow.joints]
    draw_train(board.axes, train, layout, kinds=kinds, open_clutches=opened)
    draw_bands(pen, train, flow, layout=layout, traced=traced)
    board.take_parts()
    _name_machines(board, train, layout, _machine_texts(traced.feeds, layout))
    _label_stretches(board, pen, layout, traced.stretches)
    _number_teeth(board, train, layout, sizing)
    _caption_stages(board, layout, sizing)
    legend = {f"{name} {text(flow.machine_powers[name], 'power')}": colour for name, colour in pen.colours.items()}
    heading = [sizing.design.name, f"Power flow, case {case}", *_losses(flow), *([] if layout.exact else [_NOT_TRUE])]
    return _finish(board, heading, legend)


def _start(source: Train | Sizing) -> tuple[Board, Train, Layout, Mapping[str, str]]:
    sized = source if isinstance(source, Sizing) else None
    train = sized.train if sized else source
    assert isinstance(train, Train)
    kinds = {machine.name: machine.kind for machine in sized.machines} if sized else {}
    layout = lay_out(train, sized.gears if sized else (), kinds)
    axes = Axes()
    axes.set_axis_off()
    return Board(axes), train, layout, kinds


def _losses(flow: PowerFlow) -> list[str]:
    return [f"Lost in the meshes: {text(flow.loss, 'power')}"] if flow.loss else []


def _machine_texts(feeds: Sequence[Feed], layout: Layout) -> dict[str, str]:
    """Return machine -> name; with its power and torque where its shaft goes through, as no stretch shows them."""
    texts = {}
    for feed in feeds:
        if feed.branch.part.kind is Kind.MACHINE:
            start, end = layout.spans[feed.branch.shaft]
            alone = start < feed.x < end or start == end
            values = [text(abs(feed.branch.power), "power"), _torque(feed.branch.torque)]
            name = feed.branch.part.name
            texts[name] = "\n".join([name, *(values if alone else [])])
    return texts


def _name_machines(board: Board, train: Train, layout: Layout, texts: Mapping[str, str]) -> None:
    for name, words in texts.items():
        x, y = layout.places[name].x, layout.heights[train.machines[name]]
        depth = 1.5 * len(words.split("\n"))
        places = [(x, y + side * (away + depth)) for away in _HANGING for side in (-1.0, 1.0)]
        board.place(words, places, size=7.0, bold=True)


def _name_shafts(board: Board, layout: Layout) -> None:
    for shaft, (start, end) in layout.spans.items():
        gaps = [gap for gap in layout.gaps() if start < gap < end] or [(start + end) / 2.0]
        y = layout.heights[shaft]
        places = [(gap, y + side * away) for gap in gaps for away in (2.5, 4.5, 7.0, 10.0) for side in (1.0, -1.0)]
        board.place(shaft, places, colour=theme.MUTED)


def _label_stretches(board: Board, pen: Pen, layout: Layout, stretches: Sequence[Stretch]) -> None:
    """Write kW and N m at every stretch, and the shaft's name and speed at its first."""
    fastest = max((abs(stretch.speed) for stretch in stretches), default=0.0)
    largest = max((abs(stretch.power) for stretch in stretches), default=0.0)
    strongest = max((abs(stretch.torque) for stretch in stretches), default=0.0)
    for place, stretch in enumerate(stretches):
        first = all(other.shaft != stretch.shaft for other in stretches[:place])
        lines = [stretch.shaft, text(_clean(stretch.speed, fastest), "speed").replace("-", "−")] if first else []
        lines += [text(_clean(abs(stretch.power), largest), "power"), _torque(_clean(stretch.torque, strongest))]
        clear = half_width(stretch, pen, layout, stretches) + 1.0 + len(lines) * 1.5
        y = layout.heights[stretch.shaft]
        away = [(spot, y + side * (clear + more)) for spot in spots(stretch, layout)
                for more in (0.0, 3.0, 6.0, 10.0, 15.0) for side in (1.0, -1.0)]  # fmt: skip
        board.place("\n".join(lines), away, bold=first)


def _torque(value: float) -> str:
    """Return a torque as people read it: in kN m from 100 000 N m on."""
    size = abs(value)
    return f"{size / 1e3:.4g} kN m" if size >= 1e5 else text(size, "torque")


def _clean(value: float, largest: float) -> float:
    """Return zero for what is only rounding beside the largest value."""
    return value if abs(value) > NOTHING * largest else 0.0


def _number_teeth(board: Board, train: Train, layout: Layout, sizing: Sizing) -> None:
    """Write the tooth number beside every gear, on the side that is free."""
    for gear, x, y in gear_sides(train, layout):
        half = layout.places[train.gear(gear).stage].half
        words = f"$z$ {sizing.teeth[gear]}"
        reach = text_width(words, 6.0, math=True) / 2.0 + 1.0
        width = layout.outlines[gear].width * layout.scale / 2.0
        away = [(x + side * (width * k + reach), y + up) for k in (1.0, 2.1) for up in (0.0, 2.0, -2.0, 4.0, -4.0)
                for side in (-1.0, 1.0) if width * k < half]  # fmt: skip
        board.place(words, away, size=6.0, colour=theme.MUTED)


def _caption_stages(board: Board, layout: Layout, sizing: Sizing | None) -> None:
    """Write tooth numbers, module and width below the drawing, stages of one column one below the other."""
    floor = board.extent()[1] - 2.0
    below: dict[float, float] = {}
    stages = dict.fromkeys(gear.stage for gear in sizing.gears) if sizing else {}
    for stage in stages:
        assert sizing is not None
        words = "\n".join([stage, *_stage_lines(sizing, stage)])
        x, height = layout.places[stage].x, len(words.split("\n")) * 6.5 * 1.3 * theme.INCH / 72.0
        low = below.get(x, floor)
        board.place(words, [(x, low - height / 2.0)], bold=True)
        below[x] = low - height - 2.0


def _stage_lines(sizing: Sizing, stage: str) -> list[str]:
    gears = [gear for gear in sizing.gears if gear.stage == stage]
    if not gears:
        return []
    teeth = {gear.role: gear.teeth for gear in gears}
    lines = [f"{gear.bodies} planets" for gear in gears if gear.role is Role.PLANET and not gear.own]
    if stage in sizing.design.epicyclics:
        lines.append(f"{sizing.design.epicyclics[stage].sets} sets of planets")
    elif Role.RING in teeth:
        lines.append(f"$1 + z_r/z_s$ = {1.0 + teeth[Role.RING] / teeth[Role.SUN]:.4g}")
    else:
        pinion, wheel = next(mesh.gears for mesh in sizing.train.meshes if mesh.stage == stage)
        lines.append(f"$z_2/z_1$ = {sizing.teeth[wheel] / sizing.teeth[pinion]:.4g}")
    lines.append(f"$m_n$ {written(shown(gears[0].module, 'length'), 3)} mm")
    lines.append(f"$b$ {written(shown(gears[0].face_width, 'length'), 3)} mm")
    return lines


def _finish(board: Board, heading: Sequence[str], legend: Mapping[str, str]) -> Figure:
    """Write heading and legend above the drawing and cut the paper to what is on it."""
    axes = board.axes
    left, low, right, high = board.extent()
    x, y = left, high + 6.0
    for name, colour in legend.items():
        axes.rectangle((x, y - 1.2), 5.0, 2.6, fc=tinted(colour), lw=0.0)
        axes.text(x + 6.5, y, name, va="center_baseline", fontsize=7.0)
        x += text_width(name, 7.0) + 14.0
    y += 5.0 if legend else 0.0
    for k, words in enumerate(reversed(heading)):
        is_title = k == len(heading) - 1
        axes.text(left, y, words, va="center_baseline", fontsize=9.0 if is_title else 7.0,
                  weight="bold" if is_title else "normal")  # fmt: skip
        y += 5.0
    right = max(right, x - 8.0, left + max(text_width(words, 9.0) for words in heading))
    axes.set(xlim=(left - BORDER, right + BORDER), ylim=(low - BORDER, y + BORDER - 3.0))
    figure = Figure(right - left + 2.0 * BORDER, y - 3.0 - low + 2.0 * BORDER, bare=True, title=": ".join(heading[:2]))
    figure.slots = [Slot(axes, 0, 0)]
    return figure
