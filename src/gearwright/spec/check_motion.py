"""What can be wrong with face and bevel gears, supports and errors: axis angles, names that point nowhere."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import Problem, near
from gearwright.spec.design import Design, Pair

SQUARE = 0.5 * math.pi
"""Axis angle of face and bevel gears that is understood [rad]."""
ROUNDING = 1e-6
"""How near to it a written angle must be [rad]."""


def motion_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with a design's crossing axes, supports and errors.

    Args:
        design: As typed.
    """
    for name, pair in design.pairs.items():
        yield from _crossing(name, pair, design)
    for shaft in design.supports:
        if shaft not in design.shafts:
            yield Problem(f"supports.{shaft}", f"there is no shaft {shaft!r}; {near(shaft, design.shafts)}")
    yield from _errors(design)


def _crossing(name: str, pair: Pair, design: Design) -> Iterator[Problem]:
    path = f"pairs.{name}"
    if pair.kind == "cylindrical":
        if pair.axis_angle is not None:
            message = 'only face and bevel gears have one; write kind = "face" or "bevel", or leave it out'
            yield Problem(f"{path}.axis_angle", message)
        return
    if pair.axis_angle is None:
        yield Problem(f"{path}.axis_angle_deg", f"a {pair.kind}-gear pair needs the angle between its axes; write 90")
    elif abs(pair.axis_angle - SQUARE) > ROUNDING:
        given = math.degrees(pair.axis_angle)
        yield Problem(f"{path}.axis_angle", f"{given:.6g} deg is not understood; only square axes are, 90")
    if pair.internal or pair.halves > 1:
        yield Problem(path, f"a {pair.kind}-gear pair is neither internal nor double-helical; leave that out")
    if pair.kind == "bevel" and design.rules(name).rating != "iso6336":
        yield Problem(f"{path}.gears.rating", 'bevel gears are rated by ISO 10300; write rating = "iso6336"')
    if design.rules(name).helix_angle:
        message = (
            "face gears are spur here; write 0" if pair.kind == "face" else "bevel gears have a spiral_angle; write 0"
        )
        yield Problem(f"{path}.gears.helix_angle_deg", message)


def _errors(design: Design) -> Iterator[Problem]:
    gears, planets = set(_gears(design)), set(_planets(design))
    for name, part in design.errors.items():
        path, known = f"errors.{name}", gears | planets | set(design.shafts)
        if name not in known:
            quoted = "" if "." not in near(name, known) else "; a name with a point stands in quotes"
            yield Problem(path, f"there is no such gear, shaft or planet; {near(name, known)}{quoted}")
        elif name not in planets and (part.pin_radial or part.pin_tangential):
            yield Problem(path, f"only planets have pins; {near(name, planets)}")
        elif name in design.shafts and (part.tooth_thickness or part.clocking):
            yield Problem(path, f"tooth_thickness and clocking belong to a gear; {near(name, gears)}")


def _gears(design: Design) -> Iterator[str]:
    """Yield the name of every gear body but planets."""
    for name, pair in design.pairs.items():
        for side in ("pinion", "wheel"):
            shafts = [pair.pinion, pair.wheel][side == "wheel"]
            names = [shafts] if isinstance(shafts, str) else shafts
            if len(names) > 1:
                yield from (f"{name}.{side}.{shaft}" for shaft in names)
            elif "." not in "".join(names):
                yield f"{name}.{side}"
    for name in design.planetaries:
        yield from (f"{name}.sun", f"{name}.ring")


def _planets(design: Design) -> Iterator[str]:
    for name, stage in design.planetaries.items():
        yield from (f"{name}.planet-{k + 1}" for k in range(stage.planets))
