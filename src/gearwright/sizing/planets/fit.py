"""Planets with what they turn on: bored for it, and as heavy as ring and bearing together."""

from __future__ import annotations

from gearwright.sizing.bearings import as_made
from gearwright.sizing.planets.choice import chosen
from gearwright.sizing.planets.rollers import on_rollers
from gearwright.sizing.planets.task import bored, crown_of, tasks
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing


def fit_planets(context: Context, gears: tuple[GearSizing, ...]) -> tuple[GearSizing, ...]:
    """Return all gears, the planets with the bearings that the design asks for; without any, as they are.

    Args:
        context: What sizing reads.
        gears: As sized, planets as solid discs.

    Raises:
        DesignError: No bearing has room in a planet.
    """
    fitted = {
        task.planet.name: bored(context, task.planet, chosen(task), crown=task.crown) for task in tasks(context, gears)
    }
    for gear in gears:
        stage = context.design.epicyclics.get(gear.stage)
        asked = stage.planets[gear.own].bearing if stage is not None and gear.own in stage.planets else None
        if asked is not None and asked.designation is not None:
            made = on_rollers(asked.kind, as_made(asked, asked.designation), asked.side_by_side)
            fitted[gear.name] = bored(context, gear, made, crown=crown_of(context, gear))
    return tuple(fitted.get(gear.name, gear) for gear in gears)
