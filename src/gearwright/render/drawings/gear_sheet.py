"""The sheet of one gear: section with dimensions, hub, tooth data."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from gearwright.catalogue import LARGEST, SMALLEST, standard_tolerance
from gearwright.identity import Role
from gearwright.parts.bevel import BevelProfile, face_and_root
from gearwright.render.drawings.sheet.compose import Content, Rows
from gearwright.render.drawings.sheet.crossing import Segment, crossings, segments
from gearwright.render.drawings.sheet.dimensions import arrow, corner_leader, corner_words, words_corners
from gearwright.render.drawings.sheet.entities import (
    GAP,
    TEXT,
    Corner,
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
    Tolerance,
    datum,
    frame_length,
    tolerance_frame,
)
from gearwright.render.drawings.views.gear_parts import Boss, Hub, hub_of
from gearwright.render.drawings.views.gear_view import (
    bevel_corners,
    bevel_section,
    bore_edges,
    cylinder_section,
    hub_view,
    ring_section,
)
from gearwright.render.drawings.views.shaft_parts import MM, bevel_profile
from gearwright.render.drawings.views.shaft_view import OVERSHOOT, Axis
from gearwright.render.drawings.views.tooth_data import tooth_grid
from gearwright.render.drawings.views.weights import made_of
from gearwright.shape.teeth import (
    bevel_pair,
    cylindrical_gear,
    halves_of,
    is_internal,
    kind_of,
    making_of,
    meshes_of,
)
from gearwright.sizing import GearSizing, Sizing
from gearwright.sizing.places import BACKUP, BOSS

LEAN = math.pi / 4.0
"""Of the hatching [rad]."""
BESIDE = 0.85
"""Share of the way from the apex to the hub that angles take, so that their texts stay clear of it [-]."""
SHARES = (1.0, 0.93, 0.86, 0.8, 0.74, 0.68, 0.62, 0.56, 0.5, 0.44, 0.38)
"""Of the radius of an angle's arc that are tried where lines run through its text [-]."""
FACE_GRADE = 5
"""Of the run-out of a gear's faces; assumed."""
LEAST_ACROSS = 20.0
"""Diameter on paper below which that of a hub stands in the notes alone [mm]."""
LEAST_BETWEEN = 8.0
"""Room on paper below which the thickness of a web stands in the notes alone [mm]."""
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
        main = _bevel(sizing, gear, hub, axis) if bevel else _cylindrical(sizing, gear, hub, axis)
        return [[main, *([_hub(hub, axis)] if hub.key is not None else [])]]

    grid = tooth_grid(sizing, gear, shaft)
    return Content(f"gear-{label}", title, views, (grid,), tuple(note for note in notes if note), kind="gear")


def _notes(sizing: Sizing, gear: GearSizing, hub: Hub) -> Iterator[str]:
    ratio = sizing.design.rules(gear.stage).web_ratio
    if hub.web is not None:
        share = f"; both leave {ratio:g} of the solid disc" if gear.role is Role.WHEEL and ratio < 1.0 else ""
        wide, inside, outside = (trimmed(size, 2) for size in (hub.web.width, 2.0 * hub.web.rim, 2.0 * hub.web.hub))
        yield f"Web {wide} thick in the middle, rim inside Ø{inside}, hub Ø{outside}: as weighed{share}."
        if hub.web.holes:
            across, circle = (trimmed(2.0 * size, 2) for size in (hub.web.hole, hub.web.circle))
            yield f"{hub.web.holes} holes Ø{across} through the web on Ø{circle}, evenly spaced; the section cuts them."
        yield f"Inner corners R{CORNER:g} (assumed; not weighed)."
    if hub.bore and kind_of(sizing, gear.stage) == "bevel":
        yield f"Run-out of the back IT{FACE_GRADE} at the root diameter against the bore A (assumed)."
    if hub.bore and kind_of(sizing, gear.stage) == "cylindrical" and not is_internal(sizing, gear):
        yield f"Axial run-out of the faces IT{FACE_GRADE} at the root diameter against the bore A (assumed)."
    if gear.bodies > 1:
        yield f"{gear.bodies} equal bodies." if gear.role is Role.PLANET else ""
    if kind_of(sizing, gear.stage) == "bevel":
        yield "Assumed: teeth taper towards the apex (standard depth, ISO 23509)."
        if hub.bore:
            yield f"Assumed: rim {BACKUP:g} × tooth depth behind the root; the apex-to-back distance follows from it."
        if hub.boss is not None:
            yield (
                f"Assumed: hub as long as its seat, Ø {BOSS:g} × the bore with what is cut into it, at most the root Ø"
                " at the small end."
            )
    if kind_of(sizing, gear.stage) == "face":
        yield "Face-gear pair: the wheel's tooth form is not sized; drawn by its pitch circle alone."


def _span(gear: GearSizing) -> tuple[float, float]:
    return 0.0, MM * gear.face_width * halves_of(gear)


def _cylindrical(sizing: Sizing, gear: GearSizing, hub: Hub, axis: Axis) -> list[Entity]:
    teeth, span = cylindrical_gear(sizing, gear), _span(gear)
    internal = is_internal(sizing, gear)
    outer = MM * (teeth.pitch_radius + gear.rim) if internal else MM * teeth.tip_radius
    beyond = OVERSHOOT / axis.scale
    entities: list[Entity] = [Path((axis.at(span[0] - beyond), axis.at(span[1] + beyond)), Layer.CENTRE)]
    if internal:
        entities += ring_section(axis, teeth, outer, span, lean=LEAN)
        entities.append(_across(axis, MM * teeth.tip_radius, span[0], -ASIDE))
    else:
        entities += [*cylinder_section(axis, teeth, hub, span, lean=LEAN), *bore_edges(axis, span, hub)]
        if hub.bore:
            suffix = f" {hub.tolerance}" if hub.tolerance else ""
            entities.append(_across(axis, hub.bore / 2.0, span[0], -ASIDE, suffix))
            entities += _against_bore(axis, hub.bore / 2.0, MM * teeth.root_radius, span)
    if span[1] > 1.5 * MM * gear.face_width:
        middle, root = span[1] / 2.0, MM * teeth.root_radius
        entities += [
            Path((axis.at(middle, side * outer), axis.at(middle, side * root)), Layer.OUTLINE) for side in (-1.0, 1.0)
        ]
    entities.append(_across(axis, outer, span[1], ASIDE + 16.0))
    if hub.web is not None and not internal and 2.0 * axis.scale * hub.web.hub > LEAST_ACROSS:
        entities += [_across(axis, hub.web.hub, span[1], ASIDE), _across(axis, hub.web.rim, span[1], ASIDE + 8.0)]
        middle, half = (span[0] + span[1]) / 2.0, hub.web.width / 2.0
        beyond_hub = hub.web.circle - hub.web.hole if hub.web.holes else hub.web.rim
        for named in _thickness(axis, (middle - half, middle + half), (hub.web.hub, beyond_hub)):
            aside = -3.0 - words_length(named.text, TEXT) / 2.0
            entities.append(replace(named, text_at=complex(axis.at(span[0]).real + aside, named.line.imag + GAP)))
    entities.append(_width(axis, span, outer))
    left = hub.web is not None and not internal
    entities += _flank(
        sizing, gear, axis.at(span[0 if left else 1], (1.0 if left else -1.0) * MM * teeth.pitch_radius), left=left
    )
    if hub.teeth is not None:
        entities += _leader(axis.at(span[0], hub.bore / 2.0), hub.designation)
    return entities


def _thickness(axis: Axis, web: tuple[float, float], radii: tuple[float, float]) -> Iterator[Distance]:
    """Yield the thickness of a web where the sheet has room between rim and hub."""
    if axis.scale * (radii[1] - radii[0]) > LEAST_BETWEEN:
        low, high = (axis.at(x, sum(radii) / 2.0) for x in web)
        yield Distance(low, high, low, 0.0, axis.scale)


def _against_bore(axis: Axis, bore: float, root: float, span: tuple[float, float]) -> Iterator[Entity]:
    """Yield the bore as a datum, and what a face may run out against it: beside the datum, or on the other face."""
    foot = axis.at(span[0], -bore) - ASIDE
    yield from datum(foot, -1j, "A")
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


def face_runout(root: float) -> Tolerance | None:
    """Return what the face of a gear may run out against its bore; None beyond the sizes of ISO 286-1.

    Args:
        root: Root radius, where it is measured [mm].
    """
    if not SMALLEST < 2.0 * root / MM <= LARGEST:
        return None
    return Tolerance("run-out", MM * standard_tolerance(2.0 * root / MM, FACE_GRADE), "A")


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


def _leader(target: complex, words: str) -> Iterator[Entity]:
    knee = target + complex(-7.0, 7.0)
    written = Words(knee - 1.0 + 1.0j, words, TEXT, "right", layer=Layer.DIMENSION)
    yield Path((target, knee, knee - 2.0 - written.length), Layer.DIMENSION)
    yield written


def _hub(hub: Hub, axis: Axis) -> list[Entity]:
    assert hub.key is not None
    entities = hub_view(axis, hub)
    radius, half, top = hub.bore / 2.0, MM * hub.key.width / 2.0, hub.reach / 2.0
    entities.append(
        Distance(axis.at(-half, top), axis.at(half, top), axis.at(0.0, top) + 1j * ASIDE, 0.0, axis.scale, suffix=" P9")
    )
    side = axis.at(radius) + ASIDE
    reach = Distance(axis.at(0.0, -radius), axis.at(half, top), side, math.pi / 2.0, axis.scale)
    words = Words(axis.at(0.0, -radius) - 1j * ASIDE, hub.designation, TEXT, "middle")
    return [*entities, reach, words]


def _bevel(sizing: Sizing, gear: GearSizing, hub: Hub, axis: Axis) -> list[Entity]:
    profile = bevel_profile(sizing, gear)
    beyond = OVERSHOOT / axis.scale
    corners = bevel_corners(profile, hub)
    heel, bored = corners[2], _bored(corners, hub)
    entities: list[Entity] = [
        Path((axis.at(profile.apex - beyond), axis.at(max(heel.real, profile.large[0].real) + beyond)), Layer.CENTRE)
    ]
    entities += bevel_section(axis, profile, hub, away=1.0, lean=LEAN)
    entities += bore_edges(axis, bored, hub)
    entities += [
        Path((axis.at(profile.apex), axis.on(corner)), Layer.DIMENSION)
        for corner in (profile.small[0], profile.roots[0])
    ]
    arcs = _bevel_angles(sizing, gear, axis, profile=profile, boss=hub.boss)
    angles = _uncrossed(arcs, list(segments(entities)))
    entities += _bevel_lengths(axis, profile, angles, hub=hub, back=heel.real)
    lines = list(segments(entities))
    entities += [angle for angle in angles if not crossings(corner_words(angle), lines)]
    tip = profile.large[0]
    right = axis.at(max(heel.real, tip.real, bored[1])).real + 9.0
    entities.append(_at(axis, tip, right + (8.0 if hub.boss is None else 16.0)))
    if hub.bore:
        suffix = f" {hub.tolerance}" if hub.tolerance else ""
        entities.append(_at(axis, complex(bored[1], hub.bore / 2.0), right, suffix))
        entities += datum(complex(right, axis.at(0.0, -hub.bore / 2.0).imag), -1j, "A")
        entities += _back_runout(axis, profile, heel.real, right)
    if hub.boss is not None:
        outer = complex(max(hub.boss.end, heel.real), hub.boss.diameter / 2.0)
        entities += [_at(axis, outer, right + 8.0), _hub_length(axis, hub.boss, hub.bore / 2.0)]
        front, back = hub.way[-1], hub.way[1]
        radii = (hub.boss.diameter / 2.0, min(front.imag, back.imag))
        if front.real < back.real:
            entities += _thickness(axis, (front.real, back.real), radii)
    return entities


def _back_runout(axis: Axis, profile: BevelProfile, back: float, right: float) -> Iterator[Entity]:
    """Yield what the back of a bevel gear may run out against its bore, beyond the diameters beside it."""
    tolerance = face_runout(profile.roots[1].imag)
    if tolerance is not None:
        face = axis.at(back, -0.9 * profile.roots[1].imag)
        start = complex(max(right, face.real) + 24.0, face.imag)
        yield from (Path((face, start), Layer.SYMBOL), arrow(face, -1 + 0j, Layer.SYMBOL))
        yield from tolerance_frame(start, tolerance)


def _uncrossed(arcs: Sequence[Corner], lines: Sequence[Segment]) -> list[Corner]:
    """Return the first angle at the largest radius at which no line runs through its text, and the clear others.

    Where no radius is clear, the table of tooth data has it alone.
    """
    first, *others = arcs
    tried = [replace(first, radius=share * first.radius) for share in SHARES]
    wide = next((arc for arc in tried if not crossings(corner_words(arc), lines)), None)
    if wide is None:
        return []
    return [
        wide,
        *(arc for arc in others if not crossings(corner_words(arc), lines) and arc.radius < 0.8 * wide.radius),
    ]


def _bored(corners: Sequence[complex], hub: Hub) -> tuple[float, float]:
    """Return where the bore begins and ends [mm]."""
    ends = [corner.real for corner in corners if corner.imag <= hub.bore / 2.0]
    return min(ends), max(ends)


def _hub_length(axis: Axis, boss: Boss, bore: float) -> Distance:
    """Return the length of the hub, within its bore."""
    line = axis.at(0.0, -bore) + 2.0j
    return Distance(axis.at(boss.start, -bore), axis.at(boss.end, -bore), line, 0.0, axis.scale)


def _at(axis: Axis, point: complex, x: float, suffix: str = "") -> Distance:
    return Distance(axis.on(point.conjugate()), axis.on(point), complex(x, 0.0), math.pi / 2.0, axis.scale, "Ø", suffix)


def _bevel_lengths(
    axis: Axis, profile: BevelProfile, angles: Sequence[Corner], *, hub: Hub, back: float
) -> Iterator[Entity]:
    """Yield face width and, beyond the texts of angles, cone distance; hub, crown and back of a body from the apex."""
    apex = axis.at(profile.apex)
    near, far = axis.on(profile.small[1]), axis.on(profile.large[1])
    turn = cmath.phase(far - apex)
    above = cmath.rect(1.0, turn + math.pi / 2.0)
    clear = ((axis.on(profile.large[0]) - far) * above.conjugate()).real
    yield Distance(near, far, far + above * (clear + 9.0), turn, axis.scale)
    texts = [point for angle in angles for point in words_corners(corner_words(angle))]
    over = max((((point - far) * above.conjugate()).real for point in texts), default=0.0)
    yield Distance(apex, far, far + above * max(clear + 17.0, over + 1.0), turn, axis.scale)
    crown = axis.on(profile.large[0].conjugate())
    points = [] if hub.boss is None else [axis.at(hub.boss.start, -hub.boss.diameter / 2.0)]
    points += [crown, *([axis.at(back, -profile.roots[0].imag)] if hub.bore else [])]
    for row, point in enumerate(sorted(points, key=lambda point: point.real)):
        yield Distance(apex, point, complex(0.0, crown.imag - 9.0 - 8.0 * row), 0.0, axis.scale)


def _bevel_angles(
    sizing: Sizing, gear: GearSizing, axis: Axis, *, profile: BevelProfile, boss: Boss | None
) -> list[Corner]:
    """Return pitch, face and root cone angle about the apex."""
    pair, side = bevel_pair(sizing, gear.stage), meshes_of(sizing, gear.name)[0][1]
    apex = axis.at(profile.apex)
    face, root = face_and_root(pair, side)
    free = profile.roots[0].real - profile.apex
    if boss is not None and boss.start > profile.apex:
        free = min(free, BESIDE * (boss.start - profile.apex))
    clear = min(axis.scale * free, abs(axis.on(profile.small[0]) - apex))
    arcs = [Corner(apex, 0.0, angle, share * clear)
            for share, angle in ((0.94, pair.pitch_angles[side]), (0.7, face), (0.46, root))]  # fmt: skip
    # Where the apex is too near for all three, the table has the others.
    return [arc for k, arc in enumerate(arcs) if k == 0 or not corner_leader(arc)]
