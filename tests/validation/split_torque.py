"""The face-gear split torque as the paper's numbers need it: the shipped design with other supports and single errors.

The paper counts errors the other way round, e = +J ε, and measures the pinion's phases from its line of action: half a
turn, and for the pinion 20° more, lie between its angles and those of a design file.
"""

from __future__ import annotations

import functools
import math

from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.model import System
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size
from gearwright.spec import Design, read
from gearwright.spec.design import PartErrors

SIZE = 25e-6
GEARS = {
    "1": "first.pinion",
    "2": "first.wheel.left",
    "3": "first.wheel.right",
    "4": "second.pinion.left",
    "5": "second.pinion.right",
    "6": "second.wheel",
}
SHAFTS = {"1": "input", "2": "left", "3": "right", "4": "output"}
ALL = (
    *(f"Eg{k}" for k in range(1, 7)),
    *(f"{kind}{k}" for kind in ("Eb", "Ab") for k in range(1, 5)),
    "Bb2",
    "Bb3",
)
"""Ten eccentricities, four radial and two axial assembly errors; equal tooth thicknesses cancel."""
TURN = (0.25, 0.25 + 0.18943)
"""One turn of the output after the transient [s]."""
STAGES = {"first": ("first.left", "first.right"), "second": ("second.left", "second.right")}


def errors(names: tuple[str, ...]) -> dict[str, PartErrors]:
    """Errors of 25 µm with the paper's phases β = 0 and γ = 90°."""
    fields: dict[str, dict[str, float]] = {}
    for name in names:
        part = (GEARS if name[:2] == "Eg" else SHAFTS)[name[2]]
        own = fields.setdefault(part, {})
        at_pinion = math.radians(20.0) if name[2] == "1" else 0.0
        if name[0] == "E":
            own |= {"eccentricity": SIZE, "phase": math.pi - at_pinion}
        elif name[0] == "A":
            own |= {"radial": SIZE, "radial_angle": -0.5 * math.pi - at_pinion}
        else:
            own |= {"axial": -SIZE}
    return {part: PartErrors(**own) for part, own in fields.items()}


@functools.cache
def shipped() -> Design:
    return read(shipped_design("face-gear-split-torque"))


@functools.cache
def sized(support: float, names: tuple[str, ...] = ()) -> Sizing:
    """The shipped design with a support stiffness of the pinion's shaft [N/m] and some errors."""
    design = shipped()
    supports = {**design.supports, "input": design.supports["input"].model_copy(update={"radial": support})}
    return size(design.model_copy(update={"supports": supports, "errors": errors(names)}))


@functools.cache
def built(support: float, names: tuple[str, ...] = ()) -> System:
    return assemble(sized(support, names))
