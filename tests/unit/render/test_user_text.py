"""Figures show what a user wrote as it is written, and do not read it as mathematics."""

from html import escape

from designs import PAIR, changed
from gearwright.render import style as theme
from gearwright.render.schematic import power_flow_figure
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
