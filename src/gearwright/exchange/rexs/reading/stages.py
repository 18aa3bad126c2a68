"""Stages of a document, one by one: which belong to planetary sets, and which are pairs."""

from __future__ import annotations

import math

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.exchange.rexs.files import Component
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.reading.bodies import Bodies
from gearwright.exchange.rexs.reading.gearing import Gear, Gearing, Table, stage_table
from gearwright.exchange.rexs.reading.sets import read_set
from gearwright.parts.gears.working_centre import shifts_at

SPACE = 3
"""Dimensions of space [-]."""
PARALLEL = 1e-3
"""Sine of the angle between axes that count as parallel [-]."""
SHARED = ("module_m", "outer_module_m", "centre_distance_m")
"""What a pair has from the one whose gear it shares."""


def read_stages(asking: Asking, bodies: Bodies, gears: dict[int, Gear]) -> Gearing:
    """Return pairs and planetary sets.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gears: Gears by id.
    """
    gearing, document = Gearing(), asking.document
    ends = _ends(asking, gears)
    taken: set[int] = set()
    for whole in document.of_kind("planetary_stage"):
        own = [number for number in document.related("assembly", "assembly", whole.number, "part") if number in ends]
        taken |= set(own)
        asking.used.add(whole.number)
        read_set(asking, bodies, gearing, whole, {number: ends[number] for number in own})
    for number, pair in ends.items():
        if number in taken:
            continue
        other = next((k for k in ends if k > number and k not in taken and _are_halves(pair, ends[k], bodies)), None)
        taken |= {number, other or number}
        _pair(asking, bodies, gearing, (document.components[number], pair), () if other is None else ends[other])
    return gearing


def _are_halves(one: tuple[Gear, Gear], other: tuple[Gear, Gear], bodies: Bodies) -> bool:
    """Tell whether two stages are halves of a double-helical pair: equal gears of opposite hand on the same shafts."""
    return one[0].helix != 0.0 and all(
        bodies.of(first.shaft) == bodies.of(second.shaft) and first.teeth == second.teeth
        and first.module == second.module and first.width == second.width and first.helix == -second.helix
        for first, second in zip(one, other, strict=True)
    )  # fmt: skip


def _ends(asking: Asking, gears: dict[int, Gear]) -> dict[int, tuple[Gear, Gear]]:
    """Return stage -> its two gears."""
    ends: dict[int, tuple[Gear, Gear]] = {}
    for relation in asking.document.relations:
        roles = relation.roles
        if relation.kind != "stage" or roles.get("stage") not in asking.document.components:
            continue
        pair = [gears.get(roles.get(role, -1)) for role in ("gear_1", "gear_2")]
        if pair[0] is None or pair[1] is None:
            continue  # a worm stage, or a spline: its component is listed as not read
        ends[roles["stage"]] = (pair[0], pair[1])
        asking.used.add(roles["stage"])
    for stage in asking.document.of_kind("cylindrical_stage", "bevel_stage"):
        if stage.number not in ends:
            asking.refuse(stage, "has no two gears; give it a stage relation with gear_1 and gear_2")
    return ends


def _pair(
    asking: Asking, bodies: Bodies, gearing: Gearing, read: tuple[Component, tuple[Gear, Gear]],
    other_half: tuple[Gear, ...],
) -> None:  # fmt: skip
    """Add a pair; gears that stand in a former one are its."""
    stage, ends = read
    pinion, wheel = sorted(ends, key=lambda gear: (gear.component.kind == "ring_gear", gear.teeth))
    name = bodies.new_name(stage)
    table = stage_table(asking, stage, (pinion, wheel))
    if other_half:
        table["halves"] = 2
    follows = dict[int, float]()
    if {pinion.number, wheel.number} & gearing.owners.keys():  # module and distance follow from the gear that it shares
        follows = _closing(gearing, pinion, wheel, table.get("centre_distance_m"))
        table = {key: value for key, value in table.items() if key not in SHARED}
    for role, gear in (("pinion", pinion), ("wheel", wheel)):
        shaft = gearing.add_shaft(bodies.name(gear.shaft))
        table[role] = gearing.owners.get(gear.number, shaft)
        table[f"{role}_teeth"] = gear.teeth
        shift = gear.shift if gear.shift is not None else follows.get(gear.number)
        if shift is not None and gear.number not in gearing.owners and gear.component.kind != "bevel_gear":
            table[f"{role}_shift"] = shift
        same = [half.number for half in other_half if half.shaft == gear.shaft]
        for number in (gear.number, *same):
            gearing.owners.setdefault(number, f"{name}.{role}")
            gearing.labels.setdefault(number, gearing.owners[number])
        if role == "wheel":
            gearing.wheels.add(gear.number)
    table |= _kind(asking, stage, pinion, wheel)
    if pinion.shift is not None and pinion.component.kind == "bevel_gear":
        table["pinion_shift"] = pinion.shift
    gearing.pairs[name] = table
    gearing.stages[name] = (stage.number,)


def _closing(gearing: Gearing, pinion: Gear, wheel: Gear, centre: float | None) -> dict[int, float]:
    """Return the shift of a gear that a file does not state, where it closes with the shared one at their distance."""
    known = [gear for gear in (pinion, wheel) if gear.number in gearing.owners]
    free = [gear for gear in (pinion, wheel) if gear.number not in gearing.owners and gear.shift is None]
    if centre is None or len(known) != 1 or not free or known[0].shift is None or "bevel" in pinion.component.kind:
        return {}
    teeth = pinion.teeth + (-wheel.teeth if wheel.component.kind == "ring_gear" else wheel.teeth)
    try:
        sums = shifts_at(teeth, centre / pinion.module, pressure_angle=pinion.pressure_angle, helix_angle=pinion.helix)
    except DesignError:  # the design is refused in its own words
        return {}
    return {free[0].number: sums - known[0].shift}


def _kind(asking: Asking, stage: Component, pinion: Gear, wheel: Gear) -> Table:
    """Return what tells internal and bevel pairs."""
    if pinion.component.kind != "bevel_gear":
        if _cross(asking, pinion, wheel):
            asking.refuse(stage, "has gears on axes that cross; cylindrical gears on parallel axes are read")
        return {"internal": True} if wheel.component.kind == "ring_gear" else {}
    if asking.number(stage, "hypoid_offset"):
        asking.refuse(stage, "is hypoid: its hypoid_offset is not 0; only axes that meet are read")
    return {"kind": "bevel", "axis_angle_rad": asking.number(stage, "shaft_angle") or math.pi / 2.0}


def _cross(asking: Asking, pinion: Gear, wheel: Gear) -> bool:
    """Tell whether axes that a file states are not parallel."""
    ways = [asking.vector(gear.component, "u_axis_vector") for gear in (pinion, wheel)]
    if not all(way is not None and len(way) == SPACE and any(way) for way in ways):
        return False
    one, other = (np.asarray(way) / np.linalg.norm(np.asarray(way)) for way in ways)
    return bool(np.linalg.norm(np.cross(one, other)) > PARALLEL)


def refuse_nothing(asking: Asking, gearing: Gearing) -> None:
    """Refuse a document without a stage that can be read.

    Args:
        asking: The document.
        gearing: What was read of it.
    """
    if gearing.pairs or gearing.planetaries or gearing.compounds or asking.problems:
        return
    kinds = sorted({component.kind for component in asking.document.components.values()})
    said = (
        f"there is no cylindrical, bevel or planetary stage among {', '.join(kinds) or 'them'}; export the gears, too"
    )
    asking.problems.append(Problem("components", said))
