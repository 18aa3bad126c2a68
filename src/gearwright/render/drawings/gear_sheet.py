"""The sheet of one gear: section with dimensions, hub, end view, tooth data, and where teeth and shafts are hard."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from gearwright.base import INCH, Floats, Role
from gearwright.catalogue import LARGEST, SMALLEST, standard_tolerance
from gearwright.parts.bevel_geometry import face_and_root, mean_thickness
from gearwright.parts.gears import (
    CylindricalGear,
    ball_measurement,
    feed_grade,
    least_backlash,
    runout_tolerance,
    span_allowance,
    span_allowances,
    span_measurement,
    spanned_teeth,
    thinned,
)
from gearwright.parts.iso6336 import Treatment, flank_tolerances
from gearwright.parts.iso10300 import EFFECTIVE_WIDTH
from gearwright.render.drawings.entities import (
    GAP,
    HIGH,
    SMALL,
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
from gearwright.render.drawings.paper import Content, Rows, SheetTable, Title, clear_of, segments, texts
from gearwright.render.drawings.shaft_view import (
    CHAMFERS,
    MM,
    OVERSHOOT,
    SheetAxis,
    bevel_profile,
    made_of,
)
from gearwright.shape.stands import (
    cylindrical_gear,
    gear_of,
    halves_of,
    hand_of,
    is_internal,
    kind_of,
    making_of,
    meshes_of,
    sized_mesh,
)
from gearwright.sizing import GearSizing, Sizing, backlash_of, fit_of, gear_relief, stated_pitch, thickness_of
from gearwright.sizing.casing import ring_seats
from gearwright.sizing.mass import bevel_dish, ring_outside
from gearwright.sizing.mass.bodies import bevel_cones as bevel_pair
from gearwright.sizing.places import BOSS
from gearwright.sizing.rating import BACKUP
from gearwright.spec import Pair

# ----------------------------------------------------------------------------------------------------------------------
# The table of tooth data beside a gear: what is cut, what is measured, what it meshes with.
# ----------------------------------------------------------------------------------------------------------------------


CASE = (0.15, 0.2)
"""Depth of the case over the module, at least and at most [-]: within 0.1 to 0.2 of ISO 6336-5."""
BALL = 1.75
"""Diameter of measuring balls over the module, rounded to 0.25 mm [-]."""
LEADS = {"none": "as cut", "crowning": "crowned", "corrected": "corrected for the shafts' deflection"}
"""Modification of the lead -> as the table says it."""
Row = tuple[str, str, str]


def tooth_grid(sizing: Sizing, gear: GearSizing, shaft: str) -> SheetTable:
    """Return the table of tooth data of a gear.

    Args:
        sizing: What was sized.
        gear: One of its gears.
        shaft: That carries it.
    """
    bevel = kind_of(sizing, gear.stage) == "bevel"
    rows = (_bevel_rows if bevel else _face_rows if is_face_wheel(sizing, gear) else _cylindrical_rows)(sizing, gear)
    named = {"hand": _hand(sizing, gear, shaft)}
    filled = tuple((name, symbol, named.get(value, value)) for name, symbol, value in rows)
    return SheetTable(f"Tooth data: {gear.name}", (*filled, *_quality(sizing, gear), *_mates(sizing, gear)))


def _hand(sizing: Sizing, gear: GearSizing, shaft: str) -> str:
    hand = hand_of(sizing, gear, shaft)
    if hand is None:
        return "straight"
    stage = sizing.design.stages[gear.stage]
    double = isinstance(stage, Pair) and stage.halves == 2
    return "double-helical" if double else hand.value


def _cylindrical_rows(sizing: Sizing, gear: GearSizing) -> Iterator[Row]:
    teeth = cylindrical_gear(sizing, gear)
    internal = teeth.side < 0
    yield "Kind", "", "internal" if internal else "external"
    yield "Number of teeth", "z", f"{teeth.teeth}".replace("-", "−")
    yield "Normal module", "m_{n}", _mm(teeth.module)
    yield from _pitches(teeth.module, teeth.helix_angle)
    yield "Normal pressure angle", "α_{n}", _degrees(teeth.rack.pressure_angle)
    yield "Basic rack", "", "ISO 53 A"
    yield "Helix angle", "β", _degrees(teeth.helix_angle)
    yield "Hand of helix", "", "hand"
    yield "Profile shift coefficient", "x", f"{teeth.profile_shift + 0.0:g}"
    if teeth.tip_alteration:
        yield "Tip alteration coefficient", "k", f"{teeth.tip_alteration:.4g}"
    yield "Reference diameter", "d", _mm(2.0 * teeth.pitch_radius)
    yield "Base diameter", "d_{b}", _mm(2.0 * teeth.base_radius)
    yield "Tip diameter", "d_{a}", _mm(2.0 * teeth.tip_radius)
    yield "Root diameter", "d_{f}", _mm(2.0 * teeth.root_radius)
    yield "Face width", "b", _mm(teeth.face_width)
    if kind_of(sizing, gear.stage) == "cylindrical":
        yield from _measurement(sizing, gear, teeth)


def _face_rows(sizing: Sizing, gear: GearSizing) -> Iterator[Row]:
    teeth = face_teeth(sizing, gear)
    inner, outer = teeth.reach
    yield "Kind", "", "face gear"
    yield "Number of teeth", "z", f"{gear.teeth}"
    yield "Module of the shaper", "m", _mm(teeth.pinion.module)
    yield "Teeth of the shaper", "z_{s}", f"{teeth.pinion.teeth}"
    yield "Pressure angle of the shaper", "α", _degrees(teeth.pinion.rack.pressure_angle)
    yield "Shaft angle", "Σ", "90°"
    yield "Reference diameter", "d", _mm(gear.pitch_diameter)
    yield "Outer diameter of whole teeth", "d_{e}", trimmed(2.0 * outer, 3)
    yield "Inner diameter of whole teeth", "d_{i}", trimmed(2.0 * inner, 3)
    yield "Width of whole teeth", "b", trimmed(outer - inner, 3)
    yield "Addendum", "h_{a}", trimmed(teeth.tip, 3)
    yield "Dedendum", "h_{f}", trimmed(teeth.root, 3)


def _pitches(module: float, helix_angle: float) -> Iterator[Row]:
    """Yield the diametral pitches of a design in inches: the transverse one, and the normal one where it is another."""
    pitch = stated_pitch(module)
    if pitch is None:
        return
    if helix_angle:
        yield "Normal diametral pitch", "P_{nd}", f"{trimmed(INCH * pitch, 4)} /in"
    yield "Transverse diametral pitch", "P_{d}", f"{trimmed(INCH * pitch * math.cos(helix_angle), 4)} /in"


def _measurement(sizing: Sizing, gear: GearSizing, teeth: CylindricalGear) -> Iterator[Row]:
    thickness = thickness_of(sizing.design, gear)
    if thickness is not None:
        yield "Tooth thickness", "DIN 3967", fit_of(sizing.design, gear) or ""
        yield "Allowances of the tooth thickness", "E_{sns} / E_{sni}", _limits(thickness)
    # The anvils reach over the whole span on a helical gear only if it is wide enough; into a ring they do not.
    count = 0 if is_internal(sizing, gear) else spanned_teeth(teeth)
    span = span_measurement(teeth, count) if count else math.inf
    if count and span * math.sin(teeth.base_helix_angle) <= teeth.face_width:
        yield from _span(sizing, gear, teeth, count)
    else:
        yield from _balls(teeth, thickness)


def _balls(teeth: CylindricalGear, thickness: tuple[float, float] | None) -> Iterator[Row]:
    """Yield the distance over balls, or between them, and its limits where the thickness has some."""
    ball = max(round(4e3 * BALL * teeth.module), 1) / 4e3
    distance = ball_measurement(teeth, ball)
    name = "Distance between balls" if teeth.side < 0 else "Distance over balls"
    yield "Ball diameter (assumed)", "D_{M}", _mm(ball)
    yield name, "M_{dK}", f"{_mm(distance)} without backlash"
    if thickness is not None:
        low, high = sorted(ball_measurement(thinned(teeth, allowed), ball) - distance for allowed in thickness)
        yield f"Allowances of the {name.lower()}", "", _limits((low, high))


def _span(sizing: Sizing, gear: GearSizing, teeth: CylindricalGear, count: int) -> Iterator[Row]:
    allowances = _allowances(sizing, gear, teeth)
    yield "Span over teeth", "k", f"{count}"
    yield "Span without backlash", "W_{k}", _mm(span_measurement(teeth, count))
    if allowances is None:
        yield "Allowances of the span", "E_{bn}", "none: no class, or d out of ISO 286-1"
    else:
        yield "Allowances of the span", "E_{bns} / E_{bni}", _limits(allowances)


def _limits(allowances: tuple[float, float]) -> str:
    """Return lower and upper allowance as a drawing has them, the upper first [mm]."""
    low, high = (f"{1e3 * allowance:+.3f}".replace("-", "−").replace("+0.000", "0") for allowance in allowances)
    return f"{high} / {low}"


def _allowances(sizing: Sizing, gear: GearSizing, teeth: CylindricalGear) -> tuple[float, float] | None:
    """Return allowances of the span by the design's fit, or else by a tolerance class that they are known for."""
    if (thickness := thickness_of(sizing.design, gear)) is not None:
        low, high = (span_allowance(allowed, pressure_angle=teeth.rack.pressure_angle) for allowed in thickness)
        return low, high
    stage = sizing.design.stages[gear.stage]
    grade = making_of(sizing, gear.stage).iso_class
    if grade is None or not 4 <= grade <= 9:
        return None
    if not SMALLEST < 2.0 * teeth.pitch_radius <= LARGEST:
        return None
    distance = _centre_distance(sizing, gear)
    backlash = stage.backlash or least_backlash(distance, teeth.module)
    quality, factor = feed_grade(grade)
    feed = factor * standard_tolerance(2.0 * teeth.pitch_radius, quality)
    runout = runout_tolerance(2.0 * teeth.pitch_radius, teeth.module, grade)
    return span_allowances(backlash, runout, feed, pressure_angle=teeth.rack.pressure_angle)


def _centre_distance(sizing: Sizing, gear: GearSizing) -> float:
    mesh, _ = meshes_of(sizing, gear.name)[0]
    return sized_mesh(sizing, mesh).centre_distance


def _bevel_rows(sizing: Sizing, gear: GearSizing) -> Iterator[Row]:
    pair, side = bevel_pair(sizing, gear.stage), meshes_of(sizing, gear.name)[0][1]
    face, root = face_and_root(pair, side)
    scale = pair.outer_cone_distance / pair.mean_cone_distance
    pitch = pair.pitch_angles[side]
    tip = pair.outer_diameters[side] + 2.0 * scale * pair.addenda[side] * math.cos(pitch)
    yield "Number of teeth", "z", f"{gear.teeth}"
    yield "Outer transverse module", "m_{et}", _mm(pair.outer_module)
    yield from _pitches(pair.outer_module, 0.0)
    yield "Mean normal module", "m_{mn}", _mm(pair.mean_module)
    yield "Normal pressure angle", "α_{n}", _degrees(pair.pressure_angle)
    yield "Mean spiral angle", "β_{m}", _degrees(pair.spiral_angle)
    yield "Hand of spiral", "", "hand"
    yield "Shaft angle", "Σ", _degrees(pair.shaft_angle)
    yield "Pitch cone angle", "δ", _degrees(pitch)
    yield "Face cone angle", "δ_{a}", _degrees(face)
    yield "Root cone angle", "δ_{f}", _degrees(root)
    yield "Outer cone distance", "R_{e}", _mm(pair.outer_cone_distance)
    yield "Mean cone distance", "R_{m}", _mm(pair.mean_cone_distance)
    yield "Outer pitch diameter", "d_{e}", _mm(pair.outer_diameters[side])
    yield "Mean pitch diameter", "d_{m}", _mm(pair.mean_diameters[side])
    yield "Outer tip diameter", "d_{ae}", _mm(tip)
    yield "Mean addendum", "h_{am}", _mm(pair.addenda[side])
    yield "Mean dedendum", "h_{fm}", _mm(pair.dedenda[side])
    yield "Face width", "b", _mm(pair.face_width)
    yield "Mean normal tooth thickness", "s_{mn}", _mm(mean_thickness(pair, side))
    crown = pair.outer_cone_distance * math.cos(pitch) - scale * pair.addenda[side] * math.sin(pitch)
    yield "Apex to crown", "t_{xo}", _mm(crown)
    stage = sizing.design.stages[gear.stage]
    backlash = stage.backlash or least_backlash(pair.mean_cone_distance, pair.mean_module)
    yield "Least backlash, mean cone" + ("" if stage.backlash else " (assumed)"), "j_{t}", _mm(backlash)
    cutter = sizing.design.rules(gear.stage).cutter_radius
    if pair.spiral_angle:
        yield "Cutter radius", "r_{c0}", _mm(cutter) if cutter else "not chosen; rated as large"
    if making_of(sizing, gear.stage).iso_steel is not None:
        yield "Contact pattern at full load, as rated", "b_{e}", f"{_mm(EFFECTIVE_WIDTH * pair.face_width)} long"
    yield "Contact pattern, light load (assumed)", "", "free of all edges, marked in place"


def _quality(sizing: Sizing, gear: GearSizing) -> Iterator[Row]:
    making = making_of(sizing, gear.stage)
    yield "Flank tolerance class", "", making.accuracy
    if kind_of(sizing, gear.stage) == "cylindrical" and making.iso_class is not None:
        yield from _deviations(sizing, gear, making.iso_class)
    if making.roughness is not None:
        flank, root = (f"{1e6 * roughness:g}" for roughness in making.roughness)
        yield "Roughness of flank / root", "R_{z}", f"{flank} / {root} µm"
    table, steel = making.steel
    if steel:
        yield f"Steel ({table})", "", steel
    if "case-hardened" in steel:
        low, high = (_mm(share * gear.module) for share in CASE)
        yield "Case depth at 550 HV, ground (assumed)", "CHD", f"{low} to {high}; bore and splines soft"


def _deviations(sizing: Sizing, gear: GearSizing, grade: int) -> Iterator[Row]:
    """Yield what teeth may deviate by their class, and how their flanks are modified."""
    d, b = gear.pitch_diameter, gear.face_width
    may = flank_tolerances(d, gear.module, b, grade=grade)
    yield "Single pitch", "f_{pT}", _microns(may.single_pitch)
    yield "Profile slope / form", "f_{HαT} / f_{fαT}", f"{_microns(may.profile_slope)} / {_microns(may.profile_form)}"
    yield "Helix slope", "f_{HβT}", _microns(may.helix_slope)
    yield "Run-out of the teeth", "F_{rT}", _microns(runout_tolerance(d, gear.module, grade))
    rules = sizing.design.rules(gear.stage).iso6336
    relief = gear_relief(sizing, gear.name)
    yield "Tip relief", "C_{a}", f"{1e6 * relief:.3g} µm" if relief else "none"
    yield "Lead", "", LEADS[rules.helix_modification]


def _microns(value: float | Floats) -> str:
    """Return a deviation, to 1 µm from 10 µm on, to 0.1 µm below [µm]."""
    return f"{1e6 * float(value):.0f} µm" if float(value) >= 1e-5 else f"{trimmed(1e6 * float(value), 1)} µm"


def _mates(sizing: Sizing, gear: GearSizing) -> Iterator[Row]:
    mates = {mesh.gears[1 - side]: mesh for mesh, side in meshes_of(sizing, gear.name)}
    for name, mesh in mates.items():
        mate = gear_of(sizing, name)
        yield "Mating gear", "", f"{name}, z = {mate.teeth}"
        if kind_of(sizing, gear.stage) == "cylindrical":
            row = sized_mesh(sizing, mesh)
            fit = sizing.design.rules(gear.stage).centre_allowance
            yield "Centre distance", "a", f"{_mm(row.centre_distance)} {fit or ''}".rstrip()
            play = backlash_of(sizing.design, {part.name: part for part in sizing.gears}, row)
            if play is not None:
                least, most = (_mm(end) for end in play.circumferential)
                yield "Backlash on the working circles", "j_{wt}", f"{least} to {most}"
            if gear.profile_shift + mate.profile_shift:
                yield "Working pressure angle", "α_{wt}", _degrees(row.working_pressure_angle)


def _mm(value: float) -> str:
    return trimmed(1e3 * value, 3)


def _degrees(value: float) -> str:
    return trimmed(math.degrees(value), 4) + "°"


# ----------------------------------------------------------------------------------------------------------------------
# Where a gear is hardened: a line beside its teeth (ISO 15787), and the table of what is asked.
# ----------------------------------------------------------------------------------------------------------------------


HARDEST = 800.0
"""Hardness of case-hardened flanks up to which ISO 6336-5 rates them [HV]."""
OUTSIDE = 2.0
"""Between the outline and the line of a hardened surface [mm of paper]."""
RING = 2.3
"""Radius of the circle around a number [mm of paper]."""
CASE_HARDENED, NITRIDED = ("case-hardened", "nitrided")


def case_words(hardness: float, depth: tuple[float, float]) -> str:
    """Return hardness and depth of a case as drawings write them.

    Args:
        hardness: At least [HV].
        depth: At least and at most [mm].

    >>> case_words(700.0, (0.3, 0.4))
    '700 +100 HV, CHD 0.3 +0.1'
    """
    more, (low, high) = HARDEST - hardness, depth
    hard = f"{hardness:.0f} {more:+.0f} HV" if more > 0.0 else f"{hardness:.0f} HV"
    return f"{hard}, CHD {trimmed(low, 2)} +{trimmed(high - low, 2)}"


def hard_line(ends: tuple[complex, complex], away: complex, number: int) -> Iterator[Entity]:
    """Yield the line beside a surface that is hardened, and its number in a circle (ISO 15787).

    Args:
        ends: Of the surface's outline [mm of paper].
        away: Unit vector out of the part [-].
        number: In the table of hardened surfaces.
    """
    yield Path((ends[0] + OUTSIDE * away, ends[1] + OUTSIDE * away), Layer.HARDENED)
    middle = (ends[0] + ends[1]) / 2.0 + (OUTSIDE + RING + 0.7) * away
    yield Arc(middle, RING, Layer.SYMBOL)
    yield Words(middle - 1j * SMALL / 2.0, f"{number}", SMALL, "middle", layer=Layer.SYMBOL)


class Hard(NamedTuple):
    """What is asked of the teeth of a gear."""

    treatment: str
    """``case-hardened`` or ``nitrided``."""
    hardness: float
    """At least [HV]."""


def hard_teeth(sizing: Sizing, gear: GearSizing) -> Hard | None:
    """Return what is asked of the teeth of a gear: as its rating has them, else its material; None of soft ones.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    steel = making_of(sizing, gear.stage).iso_steel
    if steel is not None:
        known = {Treatment.CASE_HARDENED: CASE_HARDENED, Treatment.NITRIDED: NITRIDED}
        return Hard(known[steel.treatment], steel.hardness) if steel.treatment in known else None
    material = sizing.design.gear_material(gear.stage)
    if material.steel not in (CASE_HARDENED, NITRIDED) or not material.hardness:
        return None
    return Hard(material.steel, material.hardness)


def hard_grid(sizing: Sizing, gear: GearSizing) -> Iterator[SheetTable]:
    """Yield the table of hardened surfaces; none where none is.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    hard = hard_teeth(sizing, gear)
    if hard is None:
        return
    if hard.treatment == NITRIDED:
        rows = [
            ("1", "teeth", f"at least {hard.hardness:.0f} HV, NHD not sized"),
            ("", "all else", "may be nitrided, too (assumed)"),
        ]
        yield SheetTable("Nitrided (ISO 15787)", tuple(rows))
        return
    low, high = (MM * share * gear.module for share in CASE)
    rows = [("1", "teeth", case_words(hard.hardness, (low, high)))]
    rows.append(("", "all else", "soft: kept from carburizing (assumed)"))
    yield SheetTable("Case-hardened and tempered (ISO 15787)", tuple(rows))


def hard_lines(sizing: Sizing, gear: GearSizing, axis: SheetAxis, view: Sequence[Entity]) -> Iterator[Entity]:
    """Yield the line beside the teeth of a gear in section, above its axis, or below it where letters are in its way.

    Args:
        sizing: What was sized.
        gear: One of its gears.
        axis: Of the section.
        view: What is drawn of the gear.
    """
    if hard_teeth(sizing, gear) is None:
        return
    lines, ends = list(segments(view)), _ends(sizing, gear)
    for side in (1.0, -1.0):
        first, last = (axis.on(complex(end.real, side * end.imag)) for end in ends)
        away = side * 1j * (last - first) / abs(last - first)
        found = list(hard_line((first, last), away, 1))
        if clear_of(texts(found), lines) and clear_of(texts(view), list(segments(found))):
            yield from found
            return


def _ends(sizing: Sizing, gear: GearSizing) -> tuple[complex, complex]:
    """Return both ends of the tips of a gear's teeth, metal to the right of the way from one to the other [mm]."""
    if kind_of(sizing, gear.stage) == "bevel":
        profile = bevel_profile(sizing, gear)
        return profile.small[0], profile.large[0]
    if is_face_wheel(sizing, gear):
        teeth = face_teeth(sizing, gear)
        return complex(-teeth.tip, teeth.reach[0]), complex(-teeth.tip, teeth.reach[1])
    tip, wide = MM * cylindrical_gear(sizing, gear).tip_radius, MM * gear.face_width * halves_of(gear)
    return (complex(wide, tip), 1j * tip) if is_internal(sizing, gear) else (1j * tip, complex(wide, tip))


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


def end_of_gear(hub: Hub, circles: Circles, axis: SheetAxis) -> list[Entity]:
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


def _halved(axis: SheetAxis, reach: float) -> Iterator[Path]:
    """Yield the strokes at both ends of a line of symmetry (ISO 128-3)."""
    for side in (1.0, -1.0):
        for k in (0.0, 1.0):
            foot = axis.origin + 1j * side * (reach + APART * k)
            yield Path((foot - MARK / 2.0, foot + MARK / 2.0), Layer.THIN)


def _keyway(hub: Hub, axis: SheetAxis, tip: float) -> Iterator[Entity]:
    """Yield width and depth of a keyway, and what key it is for, outside of the gear."""
    assert hub.key is not None
    radius, half, top = hub.bore / 2.0, MM * hub.key.width / 2.0, hub.reach / 2.0
    above = axis.at(0.0, tip) + 1j * ASIDE_OF_END
    yield Distance(axis.at(-half, top), axis.at(half, top), above, 0.0, axis.scale, suffix=" P9")
    side = axis.at(tip) + ASIDE_OF_END
    yield Distance(axis.at(0.0, -radius), axis.at(half, top), side, math.pi / 2.0, axis.scale)
    yield Words(axis.at(0.0, -tip) - 1j * (ASIDE_OF_END + TEXT), hub.designation, TEXT, "middle")


def _spline(hub: Hub, axis: SheetAxis, tip: float) -> Iterator[Entity]:
    """Yield the leader from a splined bore to below the gear, with the spline's designation."""
    target = axis.on(cmath.rect(hub.bore / 2.0, -math.pi / 4.0))
    level = axis.origin.imag - axis.scale * tip - KNEE
    knee = complex(target.real + (target.imag - level) / 2.0, level)
    words = Words(knee + 2.0 + 1.0j, hub.designation, TEXT, "left", layer=Layer.DIMENSION)
    yield Path((target, knee, knee + 4.0 + words.length), Layer.DIMENSION)
    yield words


def _holes(web: Web, axis: SheetAxis, tip: float, half: tuple[float, float]) -> Iterator[Entity]:
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


def _told(web: Web, axis: SheetAxis, tip: float, places: Sequence[complex]) -> Iterator[Entity]:
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
        axis = SheetAxis(0j, 1 + 0j, scale)
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


def _cylindrical(sizing: Sizing, gear: GearSizing, hub: Hub, axis: SheetAxis) -> list[Entity]:
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


def _against_bore(axis: SheetAxis, hub: Hub, root: float, span: tuple[float, float]) -> Iterator[Entity]:
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


def _across(axis: SheetAxis, radius: float, x: float, aside: float, suffix: str = "") -> Distance:
    """Return a diameter beside a face."""
    low, high = axis.at(x, -radius), axis.at(x, radius)
    return Distance(low, high, high + aside, math.pi / 2.0, axis.scale, "Ø", suffix)


def _width(axis: SheetAxis, span: tuple[float, float], radius: float) -> Distance:
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
