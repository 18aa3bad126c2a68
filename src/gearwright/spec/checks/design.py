"""What the types cannot see: names that must exist, names that must differ, teeth that must fit together."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import Problem, near
from gearwright.identity import SIDES
from gearwright.spec.checks.bands import band_problems
from gearwright.spec.checks.cases import case_problems
from gearwright.spec.checks.contradictions import contradiction_problems
from gearwright.spec.checks.effect import effect_problems
from gearwright.spec.checks.epicyclics import epicyclic_problems
from gearwright.spec.checks.gears import gear_problems
from gearwright.spec.checks.materials import material_problems
from gearwright.spec.checks.motion import motion_problems
from gearwright.spec.checks.mounting import mounting_problems
from gearwright.spec.checks.names import alike_problems, name_problems
from gearwright.spec.checks.oils import oil_problems
from gearwright.spec.checks.planets import load_factor_problems, planetary_problems
from gearwright.spec.checks.sharing import sharing_problems
from gearwright.spec.design import (
    CONCEPT,
    GROUND,
    MACHINES,
    PRELIMINARY,
    RATINGS,
    Damper,
    Design,
    gear_named,
    given_values,
)
from gearwright.units import text

WIDEST = 60
"""Largest face width in modules that a design may ask for."""


def reference_problems(design: Design) -> list[Problem]:
    """Return every name in a design that points nowhere or clashes, and every impossible set of given teeth.

    Args:
        design: As typed; its references are not resolved yet.
    """
    problems = _problems(design)
    if not problems or design.level != PRELIMINARY or "level" in design.model_fields_set:
        return problems
    at_concept = {problem.path for problem in _problems(design.stating(level=CONCEPT))}
    why = f'no level is stated, so it is {PRELIMINARY!r}: level = "{CONCEPT}" asks for nothing of it'
    return [
        problem if problem.path in at_concept else Problem(problem.path, f"{problem.message}; {why}")
        for problem in problems
    ]


def _problems(design: Design) -> list[Problem]:
    """Return what is wrong with a design at its level; parts of one name alone, as all else asks for parts by name."""
    if alike := list(alike_problems(design)):
        return [*name_problems(design), *alike]
    checks = (
        name_problems, _shafts, _machines, _speeds, _pairs, planetary_problems, load_factor_problems, sharing_problems,
        epicyclic_problems, _links, _teeth, _layout, case_problems, _keep, _widths, _given, _waivers, _level,
    )  # fmt: skip
    problems = [problem for check in checks for problem in check(design)]
    more = (
        material_problems, gear_problems, effect_problems, motion_problems, mounting_problems, oil_problems,
        contradiction_problems, band_problems,
    )  # fmt: skip
    return [*problems, *(problem for check in more for problem in check(design))]


def _shafts(design: Design) -> Iterator[Problem]:
    used = _used_shafts(design)
    for name in design.shafts:
        if name not in used:
            yield Problem("shafts", f"{name!r} carries nothing; remove it, or put a machine or a gear on it")


def _used_shafts(design: Design) -> set[str]:
    used = {machine.shaft for machine in design.machines.values()}
    for pair in design.pairs.values():
        used |= {name for side in SIDES for name in pair.named(side)}
    for stage in design.sets.values():
        used |= set(stage.members)
    for link in design.links.values():
        used |= {link.driving, link.driven}
    return used


def _shaft(path: str, name: str, design: Design) -> Iterator[Problem]:
    if name not in design.shafts:
        yield Problem(path, f"there is no shaft {name!r}; {near(name, design.shafts)}")


def _machines(design: Design) -> Iterator[Problem]:
    for table in MACHINES:
        for name, machine in getattr(design, table).items():
            path = f"{table}.{name}.shaft"
            if machine.shaft == GROUND:
                yield Problem(path, f"{GROUND!r} stands still, and no machine turns there; name a shaft that turns")
            else:
                yield from _shaft(path, machine.shaft, design)
            poles = getattr(machine, "poles", None)
            if poles is not None and poles % 2:
                yield Problem(f"{table}.{name}.poles", f"{poles} is odd; poles come in pairs: give an even number")
    if not design.machines:
        yield Problem("", "no machine drives or loads this train; add a table such as [turbines.gas-turbine]")


def _speeds(design: Design) -> Iterator[Problem]:
    """Find machines on one shaft that ask for different speeds, or senses, and trains of which no speed is asked."""
    if design.machines and all(machine.asked_speed is None for machine in design.machines.values()):
        yield Problem("", "no machine has a speed; give one to a machine, such as speed_rpm of a turbine or motor")
    first: dict[str, str] = {}
    for name, machine in design.machines.items():
        if machine.asked_speed is None:
            continue
        partner = first.setdefault(machine.shaft, name)
        asked, speed = signed_speed(name, design), signed_speed(partner, design)
        if abs(asked / speed - 1.0) > design.teeth.speed_tolerance:
            yield Problem(
                f"{table_of(name, design)}.{name}.speed",
                f"{text(asked, 'speed')} on shaft {machine.shaft!r}, where {partner} turns at {text(speed, 'speed')};"
                " give one speed to both, or put a gear stage between them",
            )


def signed_speed(machine: str, design: Design) -> float:
    """Return the speed that a machine asks for, negative where it turns against the first [rad/s]; 0 if it asks none.

    Args:
        machine: Its name.
        design: The design.
    """
    asked = design.machines[machine].asked_speed or 0.0
    return -asked if machine in design.motors and design.motors[machine].reverse else asked


def table_of(machine: str, design: Design) -> str:
    """Return the table of the file that describes a machine.

    Args:
        machine: Its name.
        design: The design.
    """
    return next(table for table in MACHINES if machine in getattr(design, table))


def _pairs(design: Design) -> Iterator[Problem]:
    for name, pair in design.pairs.items():
        path = f"pairs.{name}"
        if pair.pinion == [] or pair.wheel == []:
            yield Problem(path, "a gear sits on at least one shaft; name one in pinion and in wheel")
            continue
        sides = {side: pair.named(side) for side in SIDES}
        if all(isinstance(getattr(pair, side), list) for side in SIDES):
            yield Problem(
                path, "pinion and wheel are both lists; one gear meshes with several, so only one side may be a list"
            )
        for side, names in sides.items():
            for shaft in names:
                yield from _gear_reference(f"{path}.{side}", shaft, name, design)
            if len(set(names)) < len(names) or (len(names) > 1 and any("." in shaft for shaft in names)):
                yield Problem(f"{path}.{side}", f"{names}: a list names different shafts, and no shared gear")
        if set.intersection(*map(set, sides.values())):
            yield Problem(path, f"{pair.pinion!r} carries both gears; pinion and wheel turn on two shafts")
        if pair.coaxial_with is not None and (pair.coaxial_with == name or pair.coaxial_with not in design.pairs):
            others = [other for other in design.pairs if other != name]
            yield Problem(f"{path}.coaxial_with", f"there is no other pair {pair.coaxial_with!r}; {near(name, others)}")
        meshes = max(len(names) for names in sides.values())
        if pair.share is not None and not _is_share(pair.share, meshes):
            yield Problem(
                f"{path}.share",
                f"{pair.share} does not share the load of {meshes} meshes; give as many positive numbers, sum 1",
            )


def _is_share(share: list[float], meshes: int) -> bool:
    return len(share) == meshes and min(share) > 0.0 and abs(sum(share) - 1.0) <= 1e-9


def _gear_reference(path: str, name: str, pair_name: str, design: Design) -> Iterator[Problem]:
    if "." not in name:
        yield from _shaft(path, name, design)
        return
    stage, gear = gear_named(name) or ("", SIDES[0])
    others = [f"{pair}.{side}" for pair in design.pairs if pair != pair_name for side in SIDES]
    if stage == pair_name or stage not in design.pairs:
        yield Problem(path, f"there is no gear {name!r} in another pair; {near(name, others)}")
    elif any("." in shaft for shaft in design.pairs[stage].named(gear)):
        yield Problem(path, f"{name!r} is itself a shared gear; name the pair that owns it")


def _links(design: Design) -> Iterator[Problem]:
    for name, link in design.links.items():
        table, kind = ("dampers", "damper") if isinstance(link, Damper) else ("clutches", "clutch")
        for side in ("driving", "driven"):
            if isinstance(link, Damper) or getattr(link, side) != GROUND:  # a clutch to the ground is a brake
                yield from _shaft(f"{table}.{name}.{side}", getattr(link, side), design)
        if link.driving == link.driven:
            message = f"{link.driven!r} drives already; a {kind} joins two different shafts"
            yield Problem(f"{table}.{name}.driven", message)


def _teeth(design: Design) -> Iterator[Problem]:
    rules = design.teeth
    largest = rules.largest_sun()
    if rules.sun_minimum > largest:
        yield Problem("teeth.sun_minimum", f"{rules.sun_minimum} is above teeth.sun_maximum, {largest}")
    if rules.pinion_minimum is not None and rules.pinion_minimum > rules.pinion_maximum:
        yield Problem(
            "teeth.pinion_minimum", f"{rules.pinion_minimum} is above teeth.pinion_maximum, {rules.pinion_maximum}"
        )


def _layout(design: Design) -> Iterator[Problem]:
    given = given_values(design).values
    for name, layout in design.layout.items():
        yield from _shaft(f"layout.{name}", name, design)
        if layout.bore is not None and layout.bore_ratio is not None:
            yield Problem(f"layout.{name}", "bore and bore_ratio are both given; keep one")
        diameter = given.get(f"{name}.diameter")
        if layout.bore is not None and diameter is not None and layout.bore >= diameter.value:
            yield Problem(
                f"layout.{name}.bore",
                f"the bore {layout.bore * 1e3:g} mm leaves no wall in a shaft of {diameter.value * 1e3:g} mm",
            )


def _keep(design: Design) -> Iterator[Problem]:
    for machine in design.speeds.keep or []:
        if machine not in design.machines:
            yield Problem("speeds.keep", f"there is no machine {machine!r}; {near(machine, design.machines)}")


def _given(design: Design) -> Iterator[Problem]:
    yield from given_values(design).problems


def _waivers(design: Design) -> Iterator[Problem]:
    for name, reason in design.waivers.items():
        if not reason.strip():
            yield Problem(f"waivers.{name}", "has no reason; write why the design accepts that this check fails")


def _level(design: Design) -> Iterator[Problem]:
    """Find a level that the bearings contradict, and stages that a preliminary design cannot rate."""
    if design.level in ("concept", "preliminary") and design.bearings:
        message = (
            f'{design.level!r}, but [bearings] stand, which build the shafts; write level = "built", or leave them out'
        )
        yield Problem("level", message)
    if design.level == "preliminary":
        yield from _preliminary(design)
    if design.level == "built" and not design.bearings:
        yield Problem("level", "'built' needs [bearings]; give each shaft two, or write level = \"concept\"")


def _preliminary(design: Design) -> Iterator[Problem]:
    """Find stages whose method knows no fatigue."""
    for name in design.stages:
        if not RATINGS[design.rating(name)].fatigue:
            message = (
                f'{design.rating(name)!r} knows no fatigue, which level = "preliminary" asks for; write rating ='
                ' "iso6336", or size the design with --level preliminary'
            )
            yield Problem(f"{design.table(name)}.gears.rating", message)


def _widths(design: Design) -> Iterator[Problem]:
    """Find helix angles so small that no face width gives the overlap."""
    rules = {"gears": design.gears} if design.pairs else {}
    rules |= {
        f"pairs.{name}.gears": design.rules(name) for name, pair in design.pairs.items() if pair.gears is not None
    }
    for path, rule in rules.items():
        smallest = math.asin(rule.overlap_ratio * math.pi / WIDEST)
        if rule.face_width_ratio is None and 0.0 < rule.helix_angle < smallest:
            yield Problem(
                f"{path}.helix_angle",
                f"{text(rule.helix_angle, 'angle')} needs gears wider than {WIDEST} modules for the overlap ratio"
                f" {rule.overlap_ratio:g}; use 0, {text(smallest, 'angle')} or more, or give face_width_ratio",
            )
