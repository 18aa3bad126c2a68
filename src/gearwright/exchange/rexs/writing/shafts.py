"""Shafts, planets' shafts and pins, carriers and bearings as components of REXS."""

from __future__ import annotations

import numpy as np

from gearwright.exchange.rexs.words import ABSORBS, BEARING_TYPES
from gearwright.exchange.rexs.writing.sheet import Value
from gearwright.exchange.rexs.writing.task import Task, placed
from gearwright.shape import Stand
from gearwright.sizing import CarrierSizing, ShaftSizing
from gearwright.spec import GROUND


def write_shafts(task: Task) -> None:
    """Write every shaft with its sections and bearings.

    Args:
        task: Whose gear unit and housing are written.
    """
    for shaft in task.sizing.shafts:
        frame = task.sizing.arrangement.frames[shaft.name]
        attributes: dict[str, Value] = {"mass_of_component": shaft.mass}
        where = placed(np.asarray(frame.origin), frame.along, frame.up, task.unit)
        number = _shaft(task, shaft.name, attributes | where)
        task.shafts[shaft.name] = number
        for start, end, diameter, bore in _sections(task, shaft):
            section(task, number, (start, end), diameter, bore)
        task.material(task.sizing.design.shaft_material.name, number)
        if not any(bearing.shaft == shaft.name for bearing in task.sizing.bearings):
            for place, load in enumerate(shaft.bearings, start=1):
                _simple_bearing(task, f"{shaft.name} bearing {place}", load.position, number)
    _bearings(task)


def _sections(task: Task, shaft: ShaftSizing) -> list[tuple[float, float, float, float]]:
    built = next((built for built in task.sizing.built_shafts if built.name == shaft.name), None)
    if built is None:
        return [(0.0, shaft.length, shaft.diameter, shaft.bore)]
    return [(step.start, step.end, step.diameter, built.bore) for step in built.steps]


def _shaft(task: Task, name: str, attributes: dict[str, Value]) -> int:
    number = task.sheet.add("shaft", name, attributes)
    task.sheet.relate("assembly", {"assembly": task.unit, "part": number})
    return number


def section(task: Task, shaft: int, ends: tuple[float, float], diameter: float, bore: float) -> None:
    """Write a cylinder of a shaft.

    Args:
        task: The file in the making.
        shaft: Number of the shaft.
        ends: From the shaft's first end [m].
        diameter: Outer diameter [m].
        bore: Inner diameter [m].
    """
    number = task.sheet.add("shaft_section", "section", {
        "u_coordinate_on_shaft": ends[0], "length": ends[1] - ends[0], "outer_diameter_begin": diameter,
        "outer_diameter_end": diameter, "inner_diameter_begin": bore, "inner_diameter_end": bore,
    })  # fmt: skip
    task.sheet.relate("assembly", {"assembly": shaft, "part": number})


def _bearings(task: Task) -> None:
    for bearing in task.sizing.bearings:
        seat = task.sizing.design.bearings[bearing.name]
        number = task.sheet.add("rolling_bearing_with_catalog_geometry", bearing.name, {
            "catalogue_designation": bearing.designation, "bearing_type": BEARING_TYPES[seat.kind],
            "axial_force_absorption": ABSORBS[seat.locates], "radial_force_absorption": seat.radial,
            "inner_diameter": bearing.inner_diameter, "outer_diameter": bearing.outer_diameter, "width": bearing.width,
            "radial_dynamic_load_rating": bearing.dynamic_rating, "radial_static_load_rating": bearing.static_rating,
            "nominal_rating_life_time_iso_281_2007": bearing.life,
            "modified_rating_life_time_iso_281_2007": bearing.modified_life,
            "u_coordinate_on_shaft_inner_side": bearing.position,
        })  # fmt: skip
        task.sheet.relate(
            "side", {"assembly": number, "inner_part": task.shafts[bearing.shaft], "outer_part": task.casing}
        )


def _simple_bearing(task: Task, name: str, position: float, inner: int, outer: int | None = None) -> None:
    number = task.sheet.add("concept_bearing", name, {
        "u_coordinate_on_shaft_inner_side": position, "axial_force_absorption": "no_direction",
        "radial_force_absorption": True,
    })  # fmt: skip
    task.sheet.relate("side", {"assembly": number, "inner_part": inner, "outer_part": outer or task.casing})


def holder(task: Task, name: str) -> int:
    """Write a shaft that the housing holds, for what stands on the ground, and return its number.

    Args:
        task: The file in the making.
        name: Of the shaft.
    """
    number = _shaft(task, name, {})
    couple(task, f"{name} in housing", number, task.casing)
    return number


def couple(task: Task, name: str, inner: int, outer: int) -> None:
    """Join two components.

    Args:
        task: The file in the making.
        name: Of what joins them.
        inner: A shaft.
        outer: A shaft, a side plate or the housing.
    """
    task.sheet.relate(
        "side", {"assembly": task.sheet.add("coupling", name, {}), "inner_part": inner, "outer_part": outer}
    )


def write_planets(task: Task, stage: str, number: int) -> None:
    """Write the carrier of a set and the shaft and pin of every planet.

    Args:
        task: Whose shafts are written.
        stage: Name of the set.
        number: Of its planetary stage.
    """
    sheet = task.sheet
    carrier = next(carrier for carrier in task.sizing.carriers if carrier.stage == stage)
    body = sheet.add("planet_carrier", str(carrier.part), {"mass_of_component": carrier.mass})
    sheet.relate("assembly", {"assembly": number, "part": body})
    held = task.shafts[carrier.shaft] if carrier.shaft != GROUND else holder(task, f"{carrier.part} shaft")
    sheet.relate("planet_carrier_shaft", {"planetary_stage": number, "shaft": held})
    sheet.relate("assembly", {"assembly": body, "part": held})
    plate = _plate(task, carrier, body, held)
    for stand in task.stands:
        key = (stand.node, stand.place)
        if stand.gear.stage == stage and stand.carrier and key not in task.planets:
            task.planets[key] = _planet(task, stand, carrier, (number, body, plate))


def _plate(task: Task, carrier: CarrierSizing, body: int, shaft: int) -> int:
    widest = max(stand.gear.pitch_diameter for stand in task.stands if stand.gear.stage == carrier.stage
                 and stand.carrier)  # fmt: skip
    plate = task.sheet.add("side_plate", f"{carrier.part} plate", {
        "length": carrier.plate_thickness, "outer_diameter": 2.0 * carrier.radius + widest,
    })  # fmt: skip
    task.sheet.relate("assembly", {"assembly": body, "part": plate})
    couple(task, f"{carrier.part} plate on shaft", shaft, plate)
    return plate


def _planet(task: Task, stand: Stand, carrier: CarrierSizing, holds: tuple[int, int, int]) -> int:
    """Write shaft and pin of a planet; return the number of the shaft."""
    stage, body, plate = holds
    width, axes = stand.gear.face_width, stand.axes
    where = placed(axes.origin - width / 2.0 * axes.along, axes.along, axes.turned[:, 1], task.unit)
    shaft, pin = _shaft(task, f"{stand.name} shaft", where), _pin(task, stand, carrier, body, where)
    task.sheet.relate("planet_shaft", {"planetary_stage": stage, "shaft": shaft})
    task.sheet.relate("planet_pin", {"planetary_stage": stage, "shaft": pin})
    couple(task, f"{stand.name} pin in plate", pin, plate)
    _simple_bearing(task, f"{stand.name} bearing", width / 2.0, pin, shaft)
    return shaft


def _pin(task: Task, stand: Stand, carrier: CarrierSizing, body: int, where: dict[str, Value]) -> int:
    pin = task.sheet.add("shaft", f"{stand.name} pin", where)
    task.sheet.relate("assembly", {"assembly": body, "part": pin})
    section(task, pin, (0.0, stand.gear.face_width), carrier.pin_diameter, carrier.pin_bore or 0.0)
    return pin
