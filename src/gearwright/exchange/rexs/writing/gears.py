"""Gears with their flanks as components of REXS."""

from __future__ import annotations

import math

import numpy as np

from gearwright.exchange.rexs.words import GEAR
from gearwright.exchange.rexs.writing.shafts import holder
from gearwright.exchange.rexs.writing.sheet import Value
from gearwright.exchange.rexs.writing.task import Task, placed
from gearwright.parts.bevel import Hand
from gearwright.shape import Stand, bevel_pair, cylindrical_gear, halves_of, hand_of, is_internal, kind_of
from gearwright.spec import GROUND


def write_gears(task: Task) -> None:
    """Write every gear of a file; wheels of face gears, which REXS does not know, are left out.

    Args:
        task: Whose shafts and planets are written.
    """
    for stand in task.stands:
        kind = kind_of(task.sizing, stand.gear.stage)
        if kind == "bevel":
            task.gears[stand.name] = (_bevel(task, stand),)
        elif kind == "cylindrical" or stand.gear.role == "pinion":
            task.gears[stand.name] = _cylindrical(task, stand)


def _shaft(task: Task, stand: Stand) -> int:
    if stand.carrier:
        return task.planets[stand.node, stand.place]
    if stand.node == GROUND:
        key = f"{stand.name} shaft"
        if key not in task.shafts:
            task.shafts[key] = holder(task, key)
        return task.shafts[key]
    return task.shafts[stand.node]


def _on_shaft(place: float) -> float | None:
    """Return a place along a shaft; None before its first end, for which REXS has the support vector alone."""
    return place if place >= 0.0 else None


def _place(task: Task, stand: Stand) -> float:
    """Return the middle of a gear from the first end of its shaft [m]."""
    if stand.carrier:
        first = next(one for one in task.stands if (one.node, one.place) == (stand.node, stand.place))
        origin = first.axes.origin - first.gear.face_width / 2.0 * first.axes.along
    elif stand.node == GROUND:
        return 0.0
    else:
        origin = np.asarray(task.sizing.arrangement.frames[stand.node].origin)
    return float((stand.axes.origin - origin) @ stand.axes.along)


def _cylindrical(task: Task, stand: Stand) -> tuple[int, ...]:
    sizing, gear, sheet = task.sizing, stand.gear, task.sheet
    halves = halves_of(gear) if stand.gear.stage in sizing.design.pairs else 1
    teeth, hand = cylindrical_gear(sizing, gear), _hand(task, stand)
    kind, middle, shaft = (
        "ring_gear" if is_internal(sizing, gear) else "cylindrical_gear",
        _place(task, stand),
        _shaft(task, stand),
    )
    numbers = []
    for half in range(halves):
        beside = (half - (halves - 1) / 2.0) * gear.face_width
        where = placed(
            stand.axes.origin + beside * stand.axes.along, stand.axes.along, stand.axes.turned[:, 1], task.unit
        )
        attributes: dict[str, Value] = {
            "u_coordinate_on_shaft": _on_shaft(middle + beside), "number_of_teeth": abs(gear.teeth),
            "normal_module": gear.module, "face_width": gear.face_width,
            "helix_angle_reference_diameter": (1 - 2 * half) * hand * gear.helix_angle,
            "reference_circle_diameter": gear.pitch_diameter, "tip_diameter": 2.0 * abs(teeth.tip_radius),
            "root_diameter": 2.0 * abs(teeth.root_radius), "base_circle_diameter": 2.0 * abs(teeth.base_radius),
            "mass_of_component": gear.mass, GEAR: gear.name,
        }  # fmt: skip
        name = stand.name if halves == 1 else f"{stand.name} half {half + 1}"
        number = sheet.add(kind, name, attributes | where)
        sheet.relate("assembly", {"assembly": shaft, "part": number})
        _flanks(task, number, name, {
            "addendum_modification_coefficient": gear.profile_shift,
            "normal_pressure_angle": sizing.design.rules(gear.stage).pressure_angle,
        })  # fmt: skip
        task.material(sizing.design.rules(gear.stage).material, number)
        numbers.append(number)
    return tuple(numbers)


def _flanks(task: Task, gear: int, name: str, attributes: dict[str, Value]) -> None:
    left, right = (
        task.sheet.add("cylindrical_gear_flank", f"{name} {side} flank", attributes) for side in ("left", "right")
    )
    task.sheet.relate("flank", {"gear": gear, "left": left, "right": right})


def _hand(task: Task, stand: Stand) -> int:
    """Return +1 for teeth of a right-hand helix and straight ones, −1 for left-hand ones."""
    if stand.gear.helix_angle == 0.0:
        return 1
    if stand.gear.stage in task.sizing.design.pairs:
        return -1 if hand_of(task.sizing, stand.gear, stand.node) is Hand.LEFT else 1
    return 1 if stand.gear.role == "sun" else -1


def _bevel(task: Task, stand: Stand) -> int:
    sizing, gear = task.sizing, stand.gear
    pair, side = bevel_pair(sizing, gear.stage), 0 if gear.role == "pinion" else 1
    hand = -1.0 if hand_of(sizing, gear, stand.node) is Hand.LEFT else 1.0
    number = task.sheet.add("bevel_gear", stand.name, {
        "u_coordinate_on_shaft": _on_shaft(_place(task, stand)), "number_of_teeth": gear.teeth,
        "face_width": gear.face_width,
        "mean_normal_module": gear.module, "mean_spiral_angle": hand * pair.spiral_angle,
        "outer_pitch_diameter": pair.outer_diameters[side], "pitch_angle": pair.pitch_angles[side],
        "mean_cone_distance": pair.mean_cone_distance,
        "mean_pitch_diameter": 2.0 * pair.mean_cone_distance * math.sin(pair.pitch_angles[side]),
        "profile_shift_coefficient": gear.profile_shift, "mass_of_component": gear.mass, GEAR: gear.name,
    })  # fmt: skip
    task.sheet.relate("assembly", {"assembly": _shaft(task, stand), "part": number})
    task.material(sizing.design.rules(gear.stage).material, number)
    return number
