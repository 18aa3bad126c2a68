"""The table of tooth data beside a gear, and where gears and shafts are hardened (ISO 15787)."""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gearwright.base import INCH, Floats
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
from gearwright.render.drawings.entities import SMALL, Arc, Entity, Layer, Path, Words, trimmed
from gearwright.render.drawings.gear_view import face_teeth, is_face_wheel
from gearwright.render.drawings.paper import Grid, clear_of, segments, texts
from gearwright.render.drawings.shaft_view import MM, Axis, Piece, ShaftBody, bevel_profile
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
from gearwright.sizing.mass.bodies import bevel_cones as bevel_pair
from gearwright.sizing.shafts import case_hardened
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


def tooth_grid(sizing: Sizing, gear: GearSizing, shaft: str) -> Grid:
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
    return Grid(f"Tooth data: {gear.name}", (*filled, *_quality(sizing, gear), *_mates(sizing, gear)))


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
# Where a shaft is case-hardened: lines beside its outline with numbers (ISO 15787), and the table of what is asked.
# ----------------------------------------------------------------------------------------------------------------------


HARDEST = 800.0
"""Hardness of case-hardened flanks up to which ISO 6336-5 rates them [HV]."""
OUTSIDE = 2.0
"""Between the outline and the line of a hardened surface [mm of paper]."""
RING = 2.3
"""Radius of the circle around a number [mm of paper]."""
UNDER_LIP = (0.3, 0.6)
"""Depth of the case under the lip of a seal, at least (makers' sheets) and at most (assumed) [mm]."""
_MM = 1e3


class Zone(NamedTuple):
    """A surface of a shaft that is hardened."""

    piece: Piece
    what: str
    """Such as ``teeth of helical.pinion``."""
    hardness: float
    """At least [HV]."""
    depth: tuple[float, float]
    """At least and at most [mm]."""

    @property
    def words(self) -> str:
        """Hardness and depth of the case as drawings write them."""
        return case_words(self.hardness, self.depth)


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


def zones(sizing: Sizing, body: ShaftBody) -> tuple[Zone, ...]:
    """Return the teeth of one piece with a shaft that are case-hardened, and with them what runs under lips of seals.

    Args:
        sizing: What was sized.
        body: The shaft.
    """
    found, steels = [], case_hardened(sizing, body.name)
    for piece in body.pieces:
        if piece.toothed and piece.seat in steels:
            gear = gear_of(sizing, piece.seat)
            low, high = (_MM * share * gear.module for share in CASE)
            found.append(Zone(piece, f"teeth of {gear.name}", steels[gear.name].hardness, (low, high)))
    if found:
        hardness = min(zone.hardness for zone in found)
        found += [Zone(piece, f"under the seal towards {piece.sealed}", hardness, UNDER_LIP)
                  for piece in body.pieces if piece.sealed]  # fmt: skip
    return tuple(found)


def zone_lines(axis: Axis, hard: tuple[Zone, ...]) -> Iterator[Entity]:
    """Yield the lines below the outline along which a shaft is hardened, with their numbers.

    Args:
        axis: Of the shaft.
        hard: From `zones`.
    """
    for number, zone in enumerate(hard, start=1):
        piece = zone.piece
        ends = [
            axis.at(x, -diameter / 2.0) for x, diameter in zip((piece.start, piece.end), piece.diameters, strict=True)
        ]
        along = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
        yield from hard_line((ends[0], ends[1]), -1j * along, number)


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


def zone_grid(hard: tuple[Zone, ...]) -> Iterator[Grid]:
    """Yield the table of hardened surfaces; none where none is.

    Args:
        hard: From `zones`.
    """
    if hard:
        rows = [(f"{number}", zone.what, zone.words) for number, zone in enumerate(hard, start=1)]
        rows.append(("", "all else", "soft: kept from carburizing (assumed)"))
        yield Grid("Case-hardened and tempered (ISO 15787)", tuple(rows))


# ----------------------------------------------------------------------------------------------------------------------
# Where a gear is hardened: a line beside its teeth (ISO 15787), and the table of what is asked.
# ----------------------------------------------------------------------------------------------------------------------


CASE_HARDENED, NITRIDED = ("case-hardened", "nitrided")


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


def hard_grid(sizing: Sizing, gear: GearSizing) -> Iterator[Grid]:
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
        yield Grid("Nitrided (ISO 15787)", tuple(rows))
        return
    low, high = (MM * share * gear.module for share in CASE)
    rows = [("1", "teeth", case_words(hard.hardness, (low, high)))]
    rows.append(("", "all else", "soft: kept from carburizing (assumed)"))
    yield Grid("Case-hardened and tempered (ISO 15787)", tuple(rows))


def hard_lines(sizing: Sizing, gear: GearSizing, axis: Axis, view: Sequence[Entity]) -> Iterator[Entity]:
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
