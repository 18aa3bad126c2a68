"""Where gears, machines and rolling bearings of a document sit on its shafts, as tables of a design."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from gearwright.catalogue import bearings
from gearwright.exchange.rexs.files import Component
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.reading.bodies import Bodies
from gearwright.exchange.rexs.reading.gearing import Gearing
from gearwright.exchange.rexs.words import ABSORBS, BEARING_TYPES
from gearwright.spec import GROUND

Table = dict[str, Any]
_SIDES = ("u_coordinate_on_shaft_inner_side", "u_coordinate_on_shaft_outer_side")
CATALOGUED = "rolling_bearing_with_catalog_geometry"
RADIAL = 2
"""Bearings that carry a shaft across its axis [-]."""


@dataclass
class Mounting:
    """What sits where on the shafts that are known by one component along +u."""

    places: dict[str, dict[str, float]] = field(default_factory=dict)
    """Shaft -> what sits on it -> middle of its width from the shaft's first end [m]."""
    shafts: list[tuple[str, dict[str, Table], frozenset[int]]] = field(default_factory=list)
    """Shafts that the housing alone carries, the seats of their bearings by name, and the ids of these."""


def read_mounting(asking: Asking, bodies: Bodies, gearing: Gearing, shafts: Mapping[str, Component]) -> Mounting:
    """Return places and bearings of shafts.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gearing: Its gears, stages and machines.
        shafts: Shaft of the design -> the component that it is, which stands along +u.
    """
    mounting = Mounting()
    named = {**gearing.labels, **gearing.machines}
    for name, shaft in shafts.items():
        found: dict[str, list[float]] = defaultdict(list)
        for number in asking.document.related("assembly", "assembly", shaft.number, "part"):
            place = _place(asking, shaft, asking.document.components[number])
            if number in named and place is not None:
                found[named[number]].append(place)
        mounting.places[name] = {label: sum(places) / len(places) for label, places in found.items()}
        seats = dict(_seats(asking, bodies, shaft, name))
        radial = sum(seat.get("radial", True) for seat in seats.values())
        if radial > RADIAL:
            asking.notes.append(f"the {radial} radial bearings of {name} are not read: statics knows two")
        if radial == RADIAL:
            called = {bodies.new_name(asking.document.components[number]): seat for number, seat in seats.items()}
            mounting.shafts.append((name, called, frozenset(seats)))
    return mounting


def with_places(table: Mapping[str, Any], mounting: Mounting) -> Table:
    """Return the tables of a design with the places of what sits on its shafts, where all are between the ends.

    Args:
        table: Of the design, with its layout.
        mounting: As read.
    """
    layout = {name: dict(entry) for name, entry in table.get("layout", {}).items()}
    for name, places in mounting.places.items():
        if places and all(0.0 <= place <= layout[name]["length_m"] for place in places.values()):
            layout[name]["places"] = {label: {"position_m": place} for label, place in places.items()}
    return {**table, "layout": layout} if layout else dict(table)


def _place(asking: Asking, shaft: Component, part: Component) -> float | None:
    """Return where the middle of a part is on its shaft: by where both stand, else by what the part says [m]."""
    own, its = asking.vector(part, "support_vector"), asking.vector(shaft, "support_vector")
    asking.vector(part, "u_axis_vector")
    said = asking.number(part, "u_coordinate_on_shaft")
    return own[0] - its[0] if own and its and part.kind != "external_load" else said


def _seats(asking: Asking, bodies: Bodies, shaft: Component, name: str) -> Iterator[tuple[int, Table]]:
    """Yield every bearing of a shaft; none where another shaft carries it."""
    document, seats = asking.document, dict[int, Table]()
    for component in document.of_kind(CATALOGUED, "concept_bearing"):
        ends = {
            role: document.related("side", "assembly", component.number, role) for role in ("inner_part", "outer_part")
        }
        parts = [part for both in ends.values() for part in both]
        if shaft.number not in parts:
            continue
        others = [part for part in parts if part != shaft.number]
        if len(parts) != len(ends) or bodies.name_of(others[0]) != GROUND:
            return
        side = "inner_side" if shaft.number in ends["inner_part"] else "outer_side"
        position = asking.number(component, f"u_coordinate_on_shaft_{side}")
        if position is None:
            return
        seats[component.number] = {"shaft": name, "position_m": position} | _kind(asking, component)
    yield from seats.items()


def _kind(asking: Asking, component: Component) -> Table:
    """Return kind, direction and size of a bearing, as far as a design has words for them."""
    kinds = {said: kind for kind, said in BEARING_TYPES.items()}
    locates = {said: kind for kind, said in ABSORBS.items()}.get(
        asking.text(component, "axial_force_absorption"), "none"
    )
    stated = asking.text(component, "bearing_type")
    kind = kinds.get(stated, "cylindrical" if locates == "none" else "deep-groove")
    if stated not in kinds:
        words = "a bearing of another kind" if stated else "a bearing of no kind"
        asking.notes.append(f"line {component.line}: {component.path} is {words}; {kind} stands for it")
    table: Table = {"kind": kind, "locates": locates}
    if asking.text(component, "radial_force_absorption") == "false":
        table["radial"] = False
    designation = catalogued(asking.text(component, "catalogue_designation"))
    bore = asking.number(component, "inner_diameter")
    for name in ("outer_diameter", "width", "fatigue_limit_load"):
        asking.attribute(component, name)  # which follow from the bearing
    for name in ("support_vector", "u_axis_vector", "manufacturer", *_SIDES):
        asking.attribute(component, name)  # said by the shaft and the coordinate on it
    if designation:
        table["designation"] = designation
    elif bore:
        table["bore_m"] = bore
    for name, key in (
        ("radial_dynamic_load_rating", "dynamic_rating_n"),
        ("radial_static_load_rating", "static_rating_n"),
    ):
        value = asking.number(component, name)
        if value and designation:
            table[key] = value
    return table


def catalogued(designation: str) -> str:
    """Return the name of the catalogue for what a maker calls a bearing; empty where the catalogue has none.

    Args:
        designation: With seals, cages and the like behind it.

    >>> catalogued("6210-2Z"), catalogued("NU 2212 E"), catalogued("K 50x58x25")
    ('6210', 'NU 2212', '')
    """
    plain = designation.replace(" ", "").upper()
    names = {name.replace(" ", ""): name for name in bearings()}
    starts = (plain[:length] for length in range(len(plain), 2, -1) if not plain[length : length + 1].isdigit())
    return next((names[start] for start in starts if start in names), "")
