"""Figures show what a user wrote as it is written, and do not read it as mathematics."""

from html import escape

import matplotlib.pyplot as plt
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

from designs import PAIR, changed
from gearwright.render.schematic.schematic import power_flow_figure
from gearwright.render.style import plotted, theme
from gearwright.sizing import size
from gearwright.spec import parse

EVIL = r"$\frac$ and $x_$"


def test_a_design_with_dollars_in_its_name_is_drawn() -> None:
    design = parse(changed(PAIR, '"one pair"', f"'{EVIL}'"))
    drawn = power_flow_figure(size(design), "rated")
    assert "<svg" in theme.to_svg(drawn)
    assert theme.to_png(drawn)
    assert EVIL in drawn.texts()
    assert escape(EVIL) in theme.to_svg(drawn)


def _labelled() -> Figure:
    figure = plotted.sheet(100.0, 60.0)
    left, right = figure.subplots(1, 2)
    left.loglog([1.0, 1e4], [1e-3, 1.0], label=EVIL)
    left.legend(title=EVIL)
    left.set_title(EVIL)
    right.barh([0, 1], [1.0, 2.0])
    right.set_yticks([0, 1], [EVIL, "plain"])
    right.set_xlabel(EVIL)
    figure.suptitle(EVIL)
    return figure


def test_no_title_label_legend_or_tick_of_a_figure_is_read_as_mathematics() -> None:
    drawn = plotted.styled(_labelled)()
    assert "<svg" in theme.to_svg(drawn)
    assert all(not each.get_parse_math() for each in drawn.findobj(Text) if each.get_text() == EVIL)


def test_logarithmic_axes_keep_their_powers() -> None:
    drawn = plotted.styled(_labelled)()
    theme.to_svg(drawn)
    ticks = [each for each in drawn.axes[0].get_xticklabels() if "mathdefault" in each.get_text()]
    assert ticks
    assert all(each.get_parse_math() for each in ticks)


def test_the_figures_of_others_are_left_alone() -> None:
    assert plt.rcParams["text.parse_math"]
    with pytest.raises(ValueError, match="frac"):
        figure = Figure()
        figure.suptitle(EVIL)
        figure.draw_without_rendering()
