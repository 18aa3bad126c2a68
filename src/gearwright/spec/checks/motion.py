"""What can be wrong with supports and errors: names that point nowhere."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem, near
from gearwright.spec.design import Design


def motion_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with a design's supports and errors.

    Args:
        design: As typed.
    """
    for shaft in design.supports:
        if shaft not in design.shafts:
            yield Problem(f"supports.{shaft}", f"there is no shaft {shaft!r}; {near(shaft, design.shafts)}")
    yield from _errors(design)


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
    yield from (f"{name}.{gear}" for name, epicyclic in design.epicyclics.items() for gear in epicyclic.centrals)


def _planets(design: Design) -> Iterator[str]:
    for name, stage in design.planetaries.items():
        yield from (f"{name}.planet-{k + 1}" for k in range(stage.planets))
    for name, epicyclic in design.epicyclics.items():
        bodies = dict.fromkeys(map(epicyclic.body, epicyclic.planets))
        yield from (f"{name}.{body}-{k + 1}" for body in bodies for k in range(epicyclic.sets))
