"""A made propeller in words: its blades, its map, and what it does at a point of flight."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.catalogue import MadePropeller, PropellerLoads
from gearwright.machines.propellers import BladeShape, Feathered, activity_factor, integrated_lift
from gearwright.render.tables.propeller import propeller_table
from gearwright.render.words.text import table_text
from gearwright.units import number_text, text

_SOURCES = {"elements": "by blade elements", "charts": "by the Hamilton Standard charts"}


def blades_line(shape: BladeShape) -> str:
    """Return number, activity factor and design lift of blades.

    Args:
        shape: The blades.
    """
    return f"{shape.number} blades, activity factor {activity_factor(shape):.3g}, C_Li {integrated_lift(shape):.3g}"


def made_text(made: MadePropeller) -> RenderableType:
    """Return a made map for the terminal.

    Args:
        made: The map.
    """
    _, chart = made.maps[0]
    machs = f" at {len(made.maps)} tip Mach numbers" if len(made.maps) > 1 else ""
    lines = [] if made.blades is None else [Text(blades_line(made.blades))]
    angles = f"{len(chart.blade_angle)} blade angles{machs}"
    size = f"{len(chart.advance_ratio)} advance ratios by {angles}, {_SOURCES[made.by]}"
    feather = made.feather
    stands = [] if feather is None else [Text(), Text(_stands(feather))]
    return Group(*lines, Text(size), Text(), table_text(propeller_table(made)), *stands)


def _stands(feather: Feathered) -> str:
    return (
        f"In feather at {text(feather.angle, 'angle')} it stands still, and drags q D² times {feather.drag_area:.4f}:\n"
        f"  for the phases of a mission, extra_drag = {feather.drag_area:.4f} D²/S"
    )


def loads_text(found: PropellerLoads, by: str) -> RenderableType:
    """Return what a propeller does at a point of flight, with the two keys of a design that its incidence gives.

    Args:
        found: At that point.
        by: ``elements`` or ``charts``, which say nothing of incidence.
    """
    point = (
        f"At advance ratio {found.advance_ratio:.4g}, tip Mach {found.tip_mach:.3f}, {_SOURCES[by]},"
        f" blade angle {text(found.blade_angle, 'angle')}:",
        f"  power {text(found.power, 'power')}, torque {text(found.torque, 'torque')},"
        f" thrust {text(found.thrust, 'force')}, efficiency {number_text(found.efficiency, 'ratio')}",
    )
    if by == "charts":
        return Group(*map(Text, point))
    lines = (
        *point,
        f"  by incidence {text(found.in_plane_force, 'force')} across the shaft and"
        f" {text(found.hub_moment, 'torque')} at the hub,",
        f"  which bend the shaft once a turn; each blade by ±{text(found.blade_bending, 'torque')}",
        f"  in a design: in_plane_force_n = {found.in_plane_force:.0f}, hub_moment_nm = {found.hub_moment:.0f},"
        f" thrust_n = {found.thrust:.0f}",
    )
    return Group(*map(Text, lines))
