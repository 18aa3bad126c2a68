"""What a sizing gives although nobody makes it so: teeth too small to cut, planets that their bearings use up."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.sizing.bearings import planet_bodies
from gearwright.sizing.result import Sizing
from gearwright.sizing.tooth_shape import cylindrical_gear
from gearwright.units import text

LEAST_MODULE = 0.2e-3
"""Below it teeth are those of watches, moulded or punched rather than cut [m]; an estimate: standards of gears in fine
mechanics begin about here."""


def remarks(sizing: Sizing) -> tuple[str, ...]:
    """Return what to know of a sizing that no check says, as sentences with the path to change.

    Args:
        sizing: As sized.
    """
    return (*_small_teeth(sizing), *_bored_away(sizing))


def _small_teeth(sizing: Sizing) -> Iterator[str]:
    """Yield a sentence where modules are smaller than gears are cut."""
    small = {gear.stage: gear.module for gear in sizing.gears if gear.module < LEAST_MODULE}
    if small:
        modules = ", ".join(f"{stage} {text(module, 'length')}" for stage, module in small.items())
        paths = ", ".join(f"{sizing.design.table(stage)}.module_mm" for stage in small)
        least = text(LEAST_MODULE, "length")
        yield (
            f"Modules below {least}, which nobody cuts: {modules}. What the loads ask is less than what can be made;"
            f" give {paths}, such as 0.3."
        )


def _bored_away(sizing: Sizing) -> Iterator[str]:
    """Yield a sentence for every planet whose bearing is larger outside than its root circle."""
    for body in planet_bodies(sizing.design, sizing.gears):
        for step in body.steps:
            if step.runs_on is None:
                continue
            root = 2.0 * cylindrical_gear(sizing.design, step).root_radius
            outside = step.runs_on.outer_diameter
            if outside >= root:
                path = f"planetaries.{step.stage}.planet_bearing"
                yield (
                    f"{path}: {step.runs_on.designation} is {text(outside, 'length', 4)} outside and the root circle of"
                    f" {step.name} {text(root, 'length', 4)}: nothing is left of the planet, and neither its mass nor"
                    f" its life says anything. Give a smaller one, or a larger module or more teeth to {step.stage}."
                )
