"""A helicopter's rotors in words: tables over its speed, and the speeds that stand out."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.catalogue import RotorTrim
from gearwright.render.tables.rotor import rotor_tables
from gearwright.render.words.text import table_text
from gearwright.units import text


def rotor_text(found: RotorTrim) -> RenderableType:
    """Return what the rotors take, for the terminal.

    Args:
        found: Over the speed.
    """
    merit = "" if found.figure_of_merit is None else f"Figure of merit in hover {found.figure_of_merit:.3f}. "
    words = (
        f"{merit}Least power {text(found.least_power, 'power')} at {text(found.least_power_speed, 'velocity')};"
        f" farthest at {text(found.best_range_speed, 'velocity')}."
    )
    parts: list[RenderableType] = []
    for table in rotor_tables(found):
        parts += [table_text(table), Text()]
    return Group(*parts, Text(words))
