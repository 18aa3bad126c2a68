"""The sheet of one gear: section with dimensions, hub, end view, edges, tooth data."""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from gearwright.base import Role
from gearwright.render.drawings.entities import (
    GAP,
    HIGH,
    TEXT,
    TRIANGLE,
    Arc,
    Distance,
    Entity,
    Layer,
    Path,
    Words,
    arrow,
    datum,
    frame_length,
    millimetres,
    texture,
    texture_length,
    tolerance_frame,
    trimmed,
    words_length,
)
from gearwright.render.drawings.gear_view import (
    FACE_GRADE,
    LEAN,
    Hub,
    Web,
    bevel_plate,
    bevel_view,
    bore_edges,
    cylinder_section,
    face_runout,
    face_teeth,
    face_view,
    hub_of,
    hub_view,
    is_face_wheel,
    ring_section,
    seat_section,
    thickness,
)
from gearwright.render.drawings.paper import Content, Rows, Title
from gearwright.render.drawings.shaft_view import CHAMFERS, MM, OVERSHOOT, Axis, bevel_profile, made_of
from gearwright.render.drawings.tooth_data import hard_grid, hard_lines, tooth_grid
from gearwright.shape.stands import cylindrical_gear, halves_of, is_internal, kind_of, making_of
from gearwright.sizing import GearSizing, Sizing
from gearwright.sizing.casing import ring_seats
from gearwright.sizing.mass import bevel_dish, ring_outside
from gearwright.sizing.places import BOSS
from gearwright.sizing.rating import BACKUP

# ----------------------------------------------------------------------------------------------------------------------
# Edges of gears: chamfers of bores, and how the edges of teeth are broken.
# ----------------------------------------------------------------------------------------------------------------------


BROKEN = 0.1
"""Of the edges of teeth over the module [-]; assumed."""
LEAST = 0.2
"""Of the same, at least [mm]; assumed."""


def edge_notes(bore: float, module: float) -> Iterator[str]:
    """Yield how the edges of a gear are broken.

    Args:
        bore: Its diameter; 0: none [mm].
        module: Normal, or mean normal module [mm].
    """
    broken = max(round(BROKEN * module, 1), LEAST)
    bored = ""
    if bore:
        chamfer = next(chamfer for up_to, chamfer in CHAMFERS if bore <= up_to)
        bored = f" chamfers of the bore {trimmed(chamfer, 1)} × 45°,"
    yield f"Edges of teeth, at tips and ends, {trimmed(broken, 1)} × 45°,{bored} as assumed; not weighed."


# ----------------------------------------------------------------------------------------------------------------------
# A gear seen along its axis from its first face, where its bore or its web is no body of revolution (ISO 2203).
# ----------------------------------------------------------------------------------------------------------------------


ASIDE_OF_END = 9.0
"""From a part to its nearest dimension line [mm]."""
MARK, APART, BEYOND = 4.0, 1.5, 1.0
"""Of the two strokes that mean that the other half is alike: length, distance and place beyond the outline [mm]."""
KNEE = 7.0
"""Of a leader beyond the gear [mm]."""


class Circles(NamedTuple):
    """What is seen of a gear's body, as radii [mm]."""

    outlines: tuple[float, ...]
    """Tips, edges of the rim and of the hub."""
    pitch: float
    """Of the pitch circle."""
    names_spline: bool = False
    """Whether the designation of a spline stands here, as the section has no room for it."""


def needs_end(hub: Hub) -> bool:
    """Tell whether a gear is no body of revolution.

    Args:
        hub: Its bore and web.
    """
    return hub.key is not None or hub.teeth is not None or (hub.web is not None and hub.web.holes > 0)


def end_of_gear(hub: Hub, circles: Circles, axis: Axis) -> list[Entity]:
    """Return a gear seen along its axis: whole with a keyway, else its right half.

    Args:
        hub: Its bore and web.
        circles: What is seen of its body.
        axis: Its origin is the middle.
    """
    whole, tip = hub.key is not None, max(circles.outlines)
    half = (0.0, 2.0 * math.pi) if whole else (-math.pi / 2.0, math.pi / 2.0)
    seen = [(radius, Layer.OUTLINE) for radius in sorted(set(circles.outlines))]
    seen.append((circles.pitch, Layer.PITCH))
    if hub.key is None and hub.bore:
        seen.append((hub.bore / 2.0, Layer.OUTLINE))
    if hub.teeth is not None:
        seen.append((MM * hub.teeth.reference_diameter / 2.0, Layer.THIN))
    entities: list[Entity] = [Arc(axis.at(0.0), axis.scale * radius, layer, *half) for radius, layer in seen]
    reach = axis.scale * tip + OVERSHOOT
    entities.append(Path((axis.origin - 1j * reach, axis.origin + 1j * reach), Layer.CENTRE))
    entities.append(Path((axis.origin - (reach if whole else OVERSHOOT), axis.origin + reach), Layer.CENTRE))
    if hub.key is not None:
        entities += [*hub_view(axis, hub)[:1], *_keyway(hub, axis, tip)]
    else:
        entities += _halved(axis, axis.scale * tip + OVERSHOOT + BEYOND)
    if hub.teeth is not None and circles.names_spline:
        entities += _spline(hub, axis, tip)
    if hub.web is not None and hub.web.holes:
        entities += _holes(hub.web, axis, tip, half)
    return entities


def _halved(axis: Axis, reach: float) -> Iterator[Path]:
    """Yield the strokes at both ends of a line of symmetry (ISO 128-3)."""
    for side in (1.0, -1.0):
        for k in (0.0, 1.0):
            foot = axis.origin + 1j * side * (reach + APART * k)
            yield Path((foot - MARK / 2.0, foot + MARK / 2.0), Layer.THIN)


def _keyway(hub: Hub, axis: Axis, tip: float) -> Iterator[Entity]:
    """Yield width and depth of a keyway, and what key it is for, outside of the gear."""
    assert hub.key is not None
    radius, half, top = hub.bore / 2.0, MM * hub.key.width / 2.0, hub.reach / 2.0
    above = axis.at(0.0, tip) + 1j * ASIDE_OF_END
    yield Distance(axis.at(-half, top), axis.at(half, top), above, 0.0, axis.scale, suffix=" P9")
    side = axis.at(tip) + ASIDE_OF_END
    yield Distance(axis.at(0.0, -radius), axis.at(half, top), side, math.pi / 2.0, axis.scale)
    yield Words(axis.at(0.0, -tip) - 1j * (ASIDE_OF_END + TEXT), hub.designation, TEXT, "middle")


def _spline(hub: Hub, axis: Axis, tip: float) -> Iterator[Entity]:
    """Yield the leader from a splined bore to below the gear, with the spline's designation."""
    target = axis.on(cmath.rect(hub.bore / 2.0, -math.pi / 4.0))
    level = axis.origin.imag - axis.scale * tip - KNEE
    knee = complex(target.real + (target.imag - level) / 2.0, level)
    words = Words(knee + 2.0 + 1.0j, hub.designation, TEXT, "left", layer=Layer.DIMENSION)
    yield Path((target, knee, knee + 4.0 + words.length), Layer.DIMENSION)
    yield words


def _holes(web: Web, axis: Axis, tip: float, half: tuple[float, float]) -> Iterator[Entity]:
    """Yield holes on their circle, the first on top, and what is said of them."""
    whole = half[0] == 0.0
    radius = axis.scale * web.hole
    yield Arc(axis.at(0.0), axis.scale * web.circle, Layer.CENTRE, *half)
    places = [cmath.rect(web.circle, math.pi / 2.0 - 2.0 * math.pi * k / web.holes) for k in range(web.holes)]
    for place in places:
        if whole or place.real > web.hole:
            yield Arc(axis.on(place), radius, Layer.OUTLINE)
        elif place.real > -web.hole:
            turn = math.acos(max(min(-place.real / web.hole, 1.0), -1.0))
            yield Arc(axis.on(place), radius, Layer.OUTLINE, -turn, turn)
    yield from _told(web, axis, tip, places)


def _told(web: Web, axis: Axis, tip: float, places: Sequence[complex]) -> Iterator[Entity]:
    """Yield the leader from a hole on the right, to beyond the gear."""
    place = max(
        places, key=lambda at: (round(at.imag, 6), round(at.real, 6)) if at.real > web.hole else (-math.inf, 0.0)
    )
    target = axis.on(place) + cmath.rect(axis.scale * web.hole, math.pi / 4.0)
    level = axis.origin.imag + axis.scale * tip + KNEE
    knee = complex(target.real + (level - target.imag), level)
    across, circle = (millimetres(2.0 * size) for size in (web.hole, web.circle))
    words = Words(knee + 2.0 + 1.0j, f"{web.holes} × Ø{across} on Ø{circle}", TEXT, "left", layer=Layer.DIMENSION)
    yield Path((target, knee, knee + 4.0 + words.length), Layer.DIMENSION)
    yield words


# ----------------------------------------------------------------------------------------------------------------------
# The sheet of one gear: section with dimensions, hub, tooth data.
# ----------------------------------------------------------------------------------------------------------------------


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


def _cylindrical(sizing: Sizing, gear: GearSizing, hub: Hub, axis: Axis) -> list[Entity]:
    teeth, span = cylindrical_gear(sizing, gear), (0.0, MM * gear.face_width * halves_of(gear))
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
