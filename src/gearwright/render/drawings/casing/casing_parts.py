"""The housing in a list of parts, and what a drawing says of it."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.render.drawings.casing.casing_section import CasingSection
from gearwright.render.drawings.sheet.entities import millimetres, trimmed
from gearwright.render.drawings.views.arrangement_parts import Item
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.weights import made_of
from gearwright.sizing import Sizing
from gearwright.sizing.casing import LENGTH
from gearwright.sizing.mass import carried_in_walls, weighed_flanges, weighed_wall

SHOWN = tuple(
    f"housing {part}".strip() for part in ("", "shell", "flanges", "bosses", "webs", "lands of rings", "ribs", "mounts")
)
"""What is drawn of what a housing is weighed as; the first one where a design gives the whole."""
SCREWS = "housing bolts"
"""What of it is not one piece with it."""


def casing_items(sizing: Sizing, section: CasingSection, scale: float) -> Iterator[Item]:
    """Yield the housing and the screws of its flanges as the list of parts has them.

    Args:
        sizing: What was sized.
        section: What is drawn of the housing.
        scale: mm of paper per mm [-].
    """
    masses = made_of(sizing).casing
    mass = sum(each for name, each in masses.items() if name != SCREWS)
    yield Item("Housing", sizing.design.housing.material, 1, mass, scale * section.anchor)
    if SCREWS in masses:
        flanges = weighed_flanges(sizing)
        count, size = flanges.number * flanges.screws, f"M{trimmed(MM * flanges.thread, 1)}"
        remark = f"{size} x {trimmed(MM * LENGTH * flanges.thread, 1)}, 10.9, nut, washers"
        yield Item("Screw of flange", remark, count, masses[SCREWS] / count, scale * section.screw)


def casing_notes(sizing: Sizing, section: CasingSection | None) -> Iterator[str]:
    """Yield what has to be said of the housing.

    Args:
        sizing: What was sized.
        section: What is drawn of it.
    """
    if not sizing.design.housing.own:
        yield "No housing: what stands around the gears is no part of the gearbox."
    elif section is None:
        yield "The housing is not drawn: the section has axes beside each other that are not in one plane in space."
    else:
        wall = weighed_wall(sizing)
        yield (
            f"Housing: a wall of {millimetres(MM * section.wall)} mm, the shell of the complete mass (thin, "
            f"{millimetres(MM * wall.thickness)} mm as {wall.why} asks), with flanges, bosses, ribs and mounts."
        )
        bare = [name for one in carried_in_walls(sizing) if not one.found for name in one.bearings]
        if sizing.bearings:
            yield "Webs (not hatched) and collars carry bosses; webs beside this plane: sheet housing."
        if bare:
            yield f"No web or collar finds a way from the housing to the bosses of {', '.join(bare)}."
        hidden = {name: mass for name, mass in made_of(sizing).casing.items() if name not in (*SHOWN, SCREWS)}
        if hidden:
            listed = ", ".join(f"{name} {mass:.3g} kg" for name, mass in hidden.items())
            yield f"Weighed, not drawn: {listed}."
        for part, (drawn, weighed) in section.short.items():
            yield f"{part.capitalize()}: {drawn:.3g} kg of {weighed:.3g} kg are drawn: walls leave no room for more."
        if section.steps:
            yield "The section of the housing steps from one plane of axes to the other at the chain line."
        elif not section.flat:
            yield "B-B is unfolded: cut in the plane of each two axes that stand beside each other, as view A has them."
        if section.crossed:
            names = ", ".join(section.crossed)
            yield f"Where other legs of the section also cut bodies on {names}, these are left out of them."
