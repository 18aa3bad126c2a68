"""The sheet of one gear: section with dimensions, hub, tooth data."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from gearwright.identity import Role
from gearwright.render.drawings.gears.edges import edge_notes
from gearwright.render.drawings.gears.gear_end import Circles, end_of_gear, needs_end
from gearwright.render.drawings.gears.hardened import hard_grid, hard_lines
from gearwright.render.drawings.sheet.compose import Content, Rows
from gearwright.render.drawings.sheet.dimensions import arrow
from gearwright.render.drawings.sheet.entities import (
    GAP,
    TEXT,
    Distance,
    Entity,
    Layer,
    Path,
    Words,
    trimmed,
    words_length,
)
from gearwright.render.drawings.sheet.frame import Title
from gearwright.render.drawings.sheet.symbols import texture, texture_length
from gearwright.render.drawings.sheet.tolerances import (
    HIGH,
    TRIANGLE,
    datum,
    frame_length,
    tolerance_frame,
)
from gearwright.render.drawings.views.bevel_view import bevel_plate, bevel_view
from gearwright.render.drawings.views.face_view import face_teeth, face_view, is_face_wheel
from gearwright.render.drawings.views.gear_dimensions import FACE_GRADE, LEAN, face_runout, thickness
from gearwright.render.drawings.views.gear_parts import Hub, Web, hub_of
from gearwright.render.drawings.views.gear_view import bore_edges, cylinder_section, ring_section, seat_section
from gearwright.render.drawings.views.shaft_parts import MM, bevel_profile
from gearwright.render.drawings.views.shaft_view import OVERSHOOT, Axis
from gearwright.render.drawings.views.tooth_data import tooth_grid
from gearwright.render.drawings.views.weights import made_of
from gearwright.shape.teeth import (
    cylindrical_gear,
    halves_of,
    is_internal,
    kind_of,
    making_of,
)
from gearwright.sizing import GearSizing, Sizing
from gearwright.sizing.casing import ring_seats
from gearwright.sizing.mass import bevel_dish, ring_outside
from gearwright.sizing.places import BOSS
from gearwright.sizing.rating import BACKUP

BORE_ROUGHNESS = 1.6
"""Ra of toleranced bores [µm]; assumed, as of bores in the housing."""
LEAST_ACROSS = 20.0
"""Diameter on paper below which that of a hub stands in the notes alone [mm]."""
CORNER = 2.0
"""Radius between web, rim and hub [mm]; assumed."""
ASIDE = 9.0
"""From a part to its nearest dimension line [mm]."""


def gear_content(sizing: Sizing, gear: GearSizing, shaft: str, label: str) -> Content:
    """Return what the sheet of a gear shows.

    Args:
        sizing: What was sized.
        gear: One of its gears.
        shaft: That carries it.
        label: Of the gear; with its shaft where its bodies differ.
    """
    hub, rules = hub_of(sizing, gear, shaft), sizing.design.rules(gear.stage)
    title = Title(
        sizing.design.name, f"Gear {label}", f"gear-{label}", "Component drawing",
        rules.material, f"{made_of(sizing).weights[gear.name]:.2f}",
    )  # fmt: skip
    bevel = kind_of(sizing, gear.stage) == "bevel"
    notes = [hub.note, *_notes(sizing, gear, hub), "General surfaces Ra 3.2 (assumed). Dimensions in mm."]

    def views(scale: float) -> Rows:
        axis = Axis(0j, 1 + 0j, scale)
        drawn = bevel_view if bevel else face_view if is_face_wheel(sizing, gear) else _cylindrical
        main = drawn(sizing, gear, hub, axis)
        main += hard_lines(sizing, gear, axis, list(main))
        return [[main, *([end_of_gear(hub, _circles(sizing, gear, hub), axis)] if needs_end(hub) else [])]]

    grids = (tooth_grid(sizing, gear, shaft), *hard_grid(sizing, gear))
    return Content(f"gear-{label}", title, views, grids, tuple(note for note in notes if note), kind="gear")


def _circles(sizing: Sizing, gear: GearSizing, hub: Hub) -> Circles:
    """Return what is seen of a gear along its axis."""
    if kind_of(sizing, gear.stage) == "bevel":
        profile = bevel_profile(sizing, gear)
        boss = (hub.boss.diameter / 2.0,) if hub.boss is not None else ()
        return Circles(
            (profile.large[0].imag, profile.small[0].imag, profile.roots[0].imag, *boss),
            profile.large[1].imag,
            names_spline=True,
        )
    if is_face_wheel(sizing, gear):
        inner, outer = face_teeth(sizing, gear).reach
        return Circles((outer, inner), MM * gear.pitch_diameter / 2.0)
    teeth, web = cylindrical_gear(sizing, gear), hub.web
    edges = (web.rim, web.hub) if web is not None else ()
    return Circles((MM * teeth.tip_radius, *edges), MM * teeth.pitch_radius)


def _notes(sizing: Sizing, gear: GearSizing, hub: Hub) -> Iterator[str]:
    ratio = sizing.design.rules(gear.stage).web_ratio
    if hub.web is not None:
        share = f"; both leave {ratio:g} of the solid disc" if gear.role is Role.WHEEL and ratio < 1.0 else ""
        wide, inside, outside = (trimmed(size, 2) for size in (hub.web.width, 2.0 * hub.web.rim, 2.0 * hub.web.hub))
        yield f"Web {wide} thick in the middle, rim inside Ø{inside}, hub Ø{outside}: as weighed{share}."
        if hub.web.holes:
            across, circle = (trimmed(2.0 * size, 2) for size in (hub.web.hole, hub.web.circle))
            yield f"{hub.web.holes} holes Ø{across} through the web on Ø{circle}, evenly spaced; the section cuts them."
        if hub.web.dish:
            aside, lean = trimmed(abs(hub.web.dish), 2), math.degrees(math.atan(ratio_of(hub.web)))
            end = "second" if hub.web.dish > 0.0 else "first"
            yield (
                f"Web dished: at the hub {aside} towards the shaft's {end} end, {trimmed(lean, 2)}°; its thickness is"
                " along the axis. The stiffness of its cone is not assessed."
            )
        yield f"Inner corners R{CORNER:g} (assumed; not weighed)."
    if hub.bore and kind_of(sizing, gear.stage) == "bevel":
        yield f"Run-out of the back IT{FACE_GRADE} at the root diameter against the bore A (assumed)."
    if hub.bore and kind_of(sizing, gear.stage) == "cylindrical" and not is_internal(sizing, gear):
        yield f"Axial run-out of the faces IT{FACE_GRADE} at the root diameter against the bore A (assumed)."
    if hub.tolerance:
        yield f"Bore Ra {BORE_ROUGHNESS:g} (assumed)."
    if hub.teeth is not None:
        yield "Datum A is the pitch cylinder of the hub's spline."
    yield from edge_notes(hub.bore, MM * gear.module)
    if gear.bodies > 1:
        yield f"{gear.bodies} equal bodies." if gear.role is Role.PLANET else ""
    if kind_of(sizing, gear.stage) == "bevel":
        plate, dish = bevel_plate(hub), bevel_dish(sizing, gear)
        if plate is not None:
            apex = bevel_profile(sizing, gear).apex
            wide, front, inside, behind = (
                trimmed(size, 2) for size in (plate.width, plate.front - apex, 2.0 * plate.rim, 2.0 * plate.behind)
            )
            yield (
                f"Web {wide} thick, its front {front} from the apex at the rim; rim inside Ø{inside} in front,"
                f" Ø{behind} behind: as weighed."
            )
        if dish:
            way = "away from" if dish > 0.0 else "towards"
            yield (
                f"Web dished by {trimmed(math.degrees(math.atan(abs(dish))), 2)}°: at its hub {way} the apex;"
                " its thickness is along the axis. The stiffness of its cone is not assessed."
            )
        yield "Assumed: teeth taper towards the apex (standard depth, ISO 23509)."
        if hub.bore:
            yield f"Assumed: rim {BACKUP:g} × tooth depth behind the root; the apex-to-back distance follows from it."
        if hub.boss is not None:
            yield (
                f"Assumed: hub as long as its seat, Ø {BOSS:g} × the bore with what is cut into it, at most the root Ø"
                " at the small end."
            )
        yield "Machine settings and the contact pattern's place follow from the maker's process: not sized."
    if is_face_wheel(sizing, gear):
        if hub.bore:
            yield f"Axial run-out of the back IT{FACE_GRADE} at the outer diameter against the bore A (assumed)."
        yield "Teeth: the envelope of a shaper with the teeth of the pinion, whole between the diameters drawn."
        yield f"Assumed: rim {BACKUP:g} × tooth depth behind the roots, web 0.6 of it, hub: as weighed."


def ratio_of(web: Web) -> float:
    """Return how far a web leans [-].

    Args:
        web: Dished.
    """
    return abs(web.dish) / (web.rim - web.hub)


def _span(gear: GearSizing) -> tuple[float, float]:
    return 0.0, MM * gear.face_width * halves_of(gear)


def _cylindrical(sizing: Sizing, gear: GearSizing, hub: Hub, axis: Axis) -> list[Entity]:
    teeth, span = cylindrical_gear(sizing, gear), _span(gear)
    internal = is_internal(sizing, gear)
    outer = MM * ring_outside(sizing, gear) if internal else MM * teeth.tip_radius
    beyond = OVERSHOOT / axis.scale
    entities: list[Entity] = [Path((axis.at(span[0] - beyond), axis.at(span[1] + beyond)), Layer.CENTRE)]
    if internal:
        entities += ring_section(axis, teeth, outer, span, lean=LEAN)
        for seat in (seat for seat in ring_seats(sizing) if seat.ring is gear):
            entities += seat_section(axis, seat, (span[0] + span[1]) / 2.0, lean=LEAN)
        tip = MM * teeth.tip_radius
        entities += [Path((axis.at(x, -tip), axis.at(x, tip)), Layer.OUTLINE) for x in span]
        entities.append(_across(axis, tip, span[0], -ASIDE))
    else:
        entities += [*cylinder_section(axis, teeth, hub, span, lean=LEAN), *bore_edges(axis, span, hub)]
        if hub.bore:
            suffix = f" {hub.tolerance}" if hub.tolerance else ""
            entities.append(_across(axis, hub.bore / 2.0, span[0], -ASIDE, suffix))
            entities += _against_bore(axis, hub, MM * teeth.root_radius, span)
    if span[1] > 1.5 * MM * gear.face_width:
        middle, root = span[1] / 2.0, MM * teeth.root_radius
        entities += [
            Path((axis.at(middle, side * outer), axis.at(middle, side * root)), Layer.OUTLINE) for side in (-1.0, 1.0)
        ]
    entities.append(_across(axis, outer, span[1], ASIDE + 16.0))
    if hub.web is not None and not internal and 2.0 * axis.scale * hub.web.hub > LEAST_ACROSS:
        entities += [_across(axis, hub.web.hub, span[1], ASIDE), _across(axis, hub.web.rim, span[1], ASIDE + 8.0)]
        half = hub.web.width / 2.0
        beyond_hub = hub.web.circle - hub.web.hole if hub.web.holes else hub.web.rim
        middle = (span[0] + span[1]) / 2.0 + hub.web.aside((hub.web.hub + beyond_hub) / 2.0)
        for named in thickness(axis, (middle - half, middle + half), (hub.web.hub, beyond_hub)):
            aside = -3.0 - words_length(named.text, TEXT) / 2.0
            entities.append(replace(named, text_at=complex(axis.at(span[0]).real + aside, named.line.imag + GAP)))
    entities.append(_width(axis, span, outer))
    left = hub.web is not None and not internal
    entities += _flank(
        sizing, gear, axis.at(span[0 if left else 1], (1.0 if left else -1.0) * MM * teeth.pitch_radius), left=left
    )
    if hub.teeth is not None:
        entities += _leader(axis.at(span[0], hub.bore / 2.0), hub.designation, "A")
    return entities


def _against_bore(axis: Axis, hub: Hub, root: float, span: tuple[float, float]) -> Iterator[Entity]:
    """Yield the bore as a datum, and what a face may run out against it: beside the datum, or on the other face.

    The datum of a spline is its pitch cylinder, and stands at its designation.
    """
    bore = hub.bore / 2.0
    if hub.teeth is None:
        yield from datum(axis.at(span[0], -bore) - ASIDE, -1j, "A")
    level = (axis.at(span[0], -bore) - 1j * (TRIANGLE + 2.0 + 2.0 * HIGH)).imag
    tolerance = face_runout(root)
    if tolerance is None:
        return
    if level > axis.at(span[0], -root).imag:
        face = complex(axis.at(span[0]).real, level)
        yield from (Path((face, face - ASIDE), Layer.SYMBOL), arrow(face, 1 + 0j, Layer.SYMBOL))
        yield from tolerance_frame(face - ASIDE - frame_length(tolerance), tolerance)
    else:
        face = axis.at(span[1], (bore + root) / 2.0)
        start = face + ASIDE + 24.0
        yield from (Path((face, start), Layer.SYMBOL), arrow(face, -1 + 0j, Layer.SYMBOL))
        yield from tolerance_frame(start, tolerance)


def _across(axis: Axis, radius: float, x: float, aside: float, suffix: str = "") -> Distance:
    """Return a diameter beside a face."""
    low, high = axis.at(x, -radius), axis.at(x, radius)
    return Distance(low, high, high + aside, math.pi / 2.0, axis.scale, "Ø", suffix)


def _width(axis: Axis, span: tuple[float, float], radius: float) -> Distance:
    line = axis.at(0.0, -radius) - 1j * ASIDE
    return Distance(axis.at(span[0], -radius), axis.at(span[1], -radius), line, 0.0, axis.scale)


def _flank(sizing: Sizing, gear: GearSizing, pitch_point: complex, *, left: bool) -> Iterator[Entity]:
    """Yield the texture of the flanks on the pitch line, where the rules of the stage give it."""
    roughness = making_of(sizing, gear.stage).roughness
    if roughness is not None:
        words = f"Rz {1e6 * roughness[0]:g}"
        far = -texture_length(words) - 4.0 if left else 4.0
        yield from texture(pitch_point + far, words)
        yield Path((pitch_point, pitch_point + far + (-2.0 if left else 2.0)), Layer.SYMBOL)


def _leader(target: complex, words: str, letter: str) -> Iterator[Entity]:
    """Yield a designation, and the datum that its pitch cylinder is."""
    knee = target + complex(-7.0, 7.0)
    written = Words(knee - 1.0 + 1.0j, words, TEXT, "right", layer=Layer.DIMENSION)
    end = knee - 2.0 - written.length
    yield Path((target, knee, end), Layer.DIMENSION)
    yield written
    yield from datum(end + HIGH, -1j, letter)
