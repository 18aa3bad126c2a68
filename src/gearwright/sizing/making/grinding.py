"""Whether teeth of one piece with a shaft can be ground: how large a wheel runs out beside what is thicker there.

A wheel of diameter D that cuts down to the root circle stands a = √(h (D − h)) wide of its lowest point where it is h
higher. What stands a beside the teeth and reaches h above their roots therefore lets pass D = (a² + h²)/h.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from gearwright.checks import Check
from gearwright.sizing import BuiltShaft, GearSizing, Sizing, cylindrical_gear

LEAST_WHEEL = 0.03
"""Smallest wheel that grinds profiles between shoulders, an estimate: plated ones of a few centimetres [m]."""
_CLAUSE = "D = (a² + h²)/h"
_HELP = "more room between them along the shaft, or a gear that is joined instead of being of one piece, would help"


class Beside(NamedTuple):
    """What stands beside teeth and is thicker than their root circle."""

    name: str
    apart: float
    """From the face of the teeth [m]."""
    height: float
    """Above their roots [m]."""


def largest_wheel(apart: float, height: float) -> float:
    """Return the largest wheel that runs out of teeth beside what is thicker than their roots [m].

    Args:
        apart: From the face of the teeth [m].
        height: Of what stands there above the roots [m].

    Source: a chord of a circle, a² = h (D − h).

    >>> round(1e3 * largest_wheel(0.0145, 0.007), 3)
    37.036
    """
    return (apart**2 + height**2) / height if height > 0.0 else math.inf


def grinding_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the largest wheel that grinds every cylindrical gear of one piece with its shaft.

    Args:
        sizing: As sized.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    for shaft in sizing.built_shafts:
        own = [gears[joint.part] for joint in sizing.joints
               if joint.shaft == shaft.name and joint.kind == "integral" and joint.part in gears]  # fmt: skip
        for gear in own:
            if sizing.design.pairs[gear.stage].kind == "cylindrical":
                yield from _ground(sizing, shaft, gear, own)


def _ground(sizing: Sizing, shaft: BuiltShaft, gear: GearSizing, own: list[GearSizing]) -> Iterator[Check]:
    wheels = [(largest_wheel(thing.apart, thing.height), thing.name) for thing in _beside(sizing, shaft, gear, own)]
    if wheels:
        wheel, name = min(wheels)
        yield Check(
            gear.body(shaft.name), "wheel that grinds it", _CLAUSE, wheel, LEAST_WHEEL, "length", exponent=None,
            place=f"beside {name}", why="" if wheel >= LEAST_WHEEL else _HELP,
        )  # fmt: skip


def _beside(sizing: Sizing, shaft: BuiltShaft, gear: GearSizing, own: list[GearSizing]) -> Iterator[Beside]:
    """Yield the steps and gears of one piece with the shaft that are thicker than the roots of a gear."""
    places, root = sizing.arrangement.plans[shaft.name].places, cylindrical_gear(sizing.design, gear).root_radius
    start, end = (places[gear.name] + side * _half(gear) for side in (-1.0, 1.0))
    thick = [(step.start, step.end, step.diameter / 2.0, step.seat or "its shaft") for step in shaft.steps]
    thick += [(places[other.name] - _half(other), places[other.name] + _half(other), _tip(other), other.name)
              for other in own]  # fmt: skip
    for low, high, radius, name in thick:
        if name != gear.name and radius > root:
            yield Beside(name, max(low - end, start - high, 0.0), radius - root)


def _half(gear: GearSizing) -> float:
    return gear.face_width * gear.bodies / len(gear.shafts) / 2.0


def _tip(gear: GearSizing) -> float:
    return gear.pitch_diameter / 2.0 + gear.module * (1.0 + gear.profile_shift + gear.tip_alteration)
