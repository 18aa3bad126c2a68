"""The outline of a shaft with what is cut into it, undercuts, marks across its axis, weights of parts."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

from gearwright.catalogue import (
    THREAD_RUN_IN,
    THREAD_TOLERANCE,
    ThreadUndercut,
    Undercut,
    key_for_shaft,
    seat_tolerance,
    thread_chamfer,
)
from gearwright.catalogue.standard_parts import SHAFT as UNDER_SEAL
from gearwright.memo import of_latest
from gearwright.parts.bevel_geometry import BevelProfile, bevel_profile as bevel_teeth
from gearwright.parts.gears import Blank
from gearwright.parts.shafts import KeySection, Spline, spline
from gearwright.render.drawings.entities import (
    GAP,
    SMALL,
    TEXT,
    Arc,
    Distance,
    Entity,
    GeometricTolerance,
    Hatch,
    Layer,
    Path,
    Words,
    arrow,
    extent,
    millimetres,
    texture,
    texture_length,
    tolerance_frame,
    words_length,
)
from gearwright.shape.stands import cylindrical_gear, gear_of, halves_of, kind_of, meshes_of
from gearwright.sizing import BuiltShaft, GearSizing, JointSizing, ShaftStep, Sizing
from gearwright.sizing.mass import TRAIN, bevel_cones as bevel_pair, complete_mass, gear_blanks
from gearwright.sizing.places import runs
from gearwright.sizing.shafts import Cut, Thread, grooves, sealed_exits, threads, undercuts_of

# ----------------------------------------------------------------------------------------------------------------------
# A shaft as its drawing shows it: turned pieces, teeth that are one piece with it, keyways and splines; in mm.
# ----------------------------------------------------------------------------------------------------------------------


MM = 1e3
"""Millimetres in a metre."""
CHAMFERS = ((50.0, 1.0), (math.inf, 2.0))
"""Diameters up to this [mm] have ends with this chamfer [mm]; assumed."""


@dataclass(frozen=True)
class Piece:
    """A cylinder or cone of a shaft."""

    start: float
    """From the shaft's first end [mm]."""
    end: float
    """[mm]"""
    diameters: tuple[float, float]
    """At start and end [mm]."""
    seat: str = ""
    """What sits on it."""
    tolerance: str = ""
    """Tolerance class of the diameter, such as k6."""
    pitch: tuple[float, float] | None = None
    """Pitch diameters at start and end, where teeth are cut in it [mm]."""
    thread: Thread | None = None
    """That is cut on it, or whose undercut it is, as `relieved` says."""
    relieved: bool = False
    is_groove: bool = False
    """Of a retaining ring."""
    sealed: str = ""
    """Machine before whose seal it runs."""

    @property
    def fit(self) -> str:
        """Tolerance class of its diameter: of a bearing's seat, or under a radial seal."""
        return self.tolerance or (UNDER_SEAL if self.sealed else "")

    @property
    def diameter(self) -> float:
        """The larger one [mm]."""
        return max(self.diameters)

    @property
    def toothed(self) -> bool:
        """True where teeth are cut in it."""
        return self.pitch is not None

    @property
    def conical(self) -> bool:
        """True where its ends differ."""
        return self.diameters[0] != self.diameters[1]


@dataclass(frozen=True)
class Keyway:
    """A keyway for a key of DIN 6885, with ends as the key has them."""

    start: float
    """[mm]"""
    end: float
    """[mm]"""
    diameter: float
    """Of the shaft [mm]."""
    section: KeySection
    designation: str
    form: str
    """A with round ends, B with square ones."""


@dataclass(frozen=True)
class Toothing:
    """Splines on a shaft."""

    start: float
    """[mm]"""
    end: float
    """[mm]"""
    teeth: Spline
    designation: str


@dataclass(frozen=True)
class ShaftBody:
    """Everything that is turned and cut on a shaft."""

    name: str
    pieces: tuple[Piece, ...]
    """Without gaps, from the first end on."""
    bore: float
    """[mm]"""
    slots: tuple[Keyway, ...] = ()
    splines: tuple[Toothing, ...] = ()
    gears: tuple[str, ...] = ()
    """Gears that are one piece with it."""
    fillets: tuple[tuple[float, float], ...] = ()
    """Shoulder along the axis, and radius of its fillet [mm]."""
    undercuts: tuple[Cut, ...] = ()
    threads: tuple[Thread, ...] = ()

    @property
    def length(self) -> float:
        """[mm]"""
        return self.pieces[-1].end - self.pieces[0].start


def shaft_body(sizing: Sizing, name: str) -> ShaftBody:
    """Return a shaft as it is built, or the cylinder of the first sizing where no bearings were asked for.

    That cylinder is as long as its solid, and as what is weighed.

    Args:
        sizing: What was sized.
        name: Of the shaft.
    """
    plain = next(shaft for shaft in sizing.shafts if shaft.name == name)
    built = next((shaft for shaft in sizing.built_shafts if shaft.name == name), None)
    if built is None:
        steps = [step for run in runs(sizing)[0] if run.shaft == name for step in run.steps]
        start, end = (
            min((step[0] for step in steps), default=0.0),
            max((step[1] for step in steps), default=plain.length),
        )
        piece = Piece(MM * start, MM * end, (MM * plain.diameter,) * 2)
        return ShaftBody(name, (piece,), MM * plain.bore)
    joints = [joint for joint in sizing.joints if joint.shaft == name]
    integral = [
        joint for joint in joints if joint.kind == "integral" and any(g.name == joint.part for g in sizing.gears)
    ]
    pieces = _merged([_turned(sizing, step, name) for step in built.steps])
    for joint in integral:
        pieces = _overlaid(pieces, toothed_piece(sizing, gear_of(sizing, joint.part), joint.position))
    for groove in grooves(sizing):
        if groove.shaft == name and not (groove.is_thread or groove.around):
            edges, across = (MM * groove.start, MM * groove.end), (MM * groove.diameter,) * 2
            pieces = _overlaid(pieces, Piece(*edges, across, is_groove=True))
    own = tuple(thread for thread in threads(sizing) if thread.shaft == name)
    for thread in own:
        for piece in _threaded(thread):
            pieces = _overlaid(pieces, piece)
    cuts = tuple(undercuts_of(sizing, built))
    feet = {(cut.place, cut.bottom) for cut in cuts}
    return ShaftBody(
        name,
        tuple(pieces),
        MM * built.bore,
        slots=tuple(_slot(joint) for joint in joints if joint.kind == "key"),
        splines=tuple(_toothing(joint, built) for joint in joints if joint.kind == "spline"),
        gears=tuple(joint.part for joint in integral),
        fillets=tuple((MM * section.position, MM * section.fillet) for section in built.sections
                      if section.fillet and (section.position, section.diameter) not in feet),
        undercuts=cuts,
        threads=own,
    )  # fmt: skip


def _threaded(thread: Thread) -> Iterator[Piece]:
    """Yield a thread, and what is beneath washer and ring: its undercut, or turns that run out in no seat."""
    whole = (MM * thread.nut.thread,) * 2
    bottom = (MM * thread.bottom,) * 2 if thread.undercut else whole
    low, high = (MM * place for place in thread.fading)
    yield Piece(low, high, bottom, thread=thread, relieved=True)
    low, high = (MM * place for place in thread.turns)
    yield Piece(low, high, whole, thread=thread)


def thread_name(thread: Thread) -> str:
    """Return a thread with its tolerance class, such as ``M30 x 1.5 - 6g``.

    Args:
        thread: On a shaft.
    """
    return f"{thread.nut.cut} - {THREAD_TOLERANCE}"


def _turned(sizing: Sizing, step: ShaftStep, shaft: str) -> Piece:
    bearing = next((seated.bearing for seated in sizing.bearings if seated.name == step.seat), None)
    tolerance = seat_tolerance(bearing.kind, bearing.bore) if bearing else ""
    piece = Piece(MM * step.start, MM * step.end, (MM * step.diameter,) * 2, step.seat, tolerance)
    for leaves, seal in sealed_exits(sizing):
        if leaves.shaft == shaft and step.start < (seal.start + seal.end) / 2.0 < step.end:
            return replace(piece, sealed=leaves.machine)
    return piece


def _merged(pieces: list[Piece]) -> list[Piece]:
    """Return pieces with those together that no shoulder and no tolerance parts."""
    merged = pieces[:1]
    for piece in pieces[1:]:
        last = merged[-1]
        if last.diameters == piece.diameters and last.fit == piece.fit == "":
            merged[-1] = Piece(last.start, piece.end, last.diameters, last.seat or piece.seat)
        else:
            merged.append(piece)
    return merged


def toothed_piece(sizing: Sizing, gear: GearSizing, position: float) -> Piece:
    """Return the body of a gear's teeth: tip cylinder or face cone over its face width.

    Args:
        sizing: What was sized.
        gear: External or bevel.
        position: Middle of the face along the shaft [m].
    """
    if kind_of(sizing, gear.stage) == "bevel":
        return _cone(sizing, gear, MM * position)
    middle, half = MM * position, MM * gear.face_width * halves_of(gear) / 2.0
    teeth = cylindrical_gear(sizing, gear)
    pitch = 2.0 * MM * teeth.pitch_radius
    return Piece(middle - half, middle + half, (2.0 * MM * teeth.tip_radius,) * 2, gear.name, pitch=(pitch, pitch))


def _cone(sizing: Sizing, gear: GearSizing, middle: float) -> Piece:
    """Return the tip cone of a bevel gear, from the tip of its small end to that of its large end."""
    profile = bevel_profile(sizing, gear)
    sign = away_of(sizing, gear)
    small, large = sorted((profile.small, profile.large), key=lambda end: sign * end[0].real)
    return Piece(
        middle + sign * small[0].real,
        middle + sign * large[0].real,
        (2.0 * small[0].imag, 2.0 * large[0].imag),
        gear.name,
        pitch=(2.0 * small[1].imag, 2.0 * large[1].imag),
    )


def bevel_profile(sizing: Sizing, gear: GearSizing) -> BevelProfile:
    """Return the corners of a bevel gear's teeth [mm].

    Args:
        sizing: What was sized.
        gear: A bevel gear.
    """
    pair, side = bevel_pair(sizing, gear.stage), meshes_of(sizing, gear.name)[0][1]
    return bevel_teeth(pair, side).scaled(MM)


def away_of(sizing: Sizing, gear: GearSizing) -> float:
    """Return +1 where the apex of a bevel gear lies towards its shaft's first end, −1 where it lies towards the second.

    Args:
        sizing: What was sized.
        gear: A bevel gear.
    """
    pair, side = sizing.design.pairs[gear.stage], meshes_of(sizing, gear.name)[0][1]
    return -1.0 if (pair.pinion_apex if side == 0 else pair.wheel_apex) == "second" else 1.0


def _overlaid(pieces: list[Piece], toothed: Piece) -> list[Piece]:
    """Return pieces with teeth, or a groove, in place of what they cover."""
    left = [replace(piece, end=min(piece.end, toothed.start)) for piece in pieces if piece.start < toothed.start - 1e-6]
    right = [replace(piece, start=max(piece.start, toothed.end)) for piece in pieces if piece.end > toothed.end + 1e-6]
    return [*left, toothed, *right]


def _slot(joint: JointSizing) -> Keyway:
    section = key_for_shaft(joint.diameter).section
    half = MM * joint.length / 2.0
    middle = MM * joint.position
    return Keyway(middle - half, middle + half, MM * joint.diameter, section, joint.designation, joint.form)


def _toothing(joint: JointSizing, built: BuiltShaft) -> Toothing:
    """Return splines as long as they bear, and on to the end of their seat from which the hub is slid on."""
    seat = next((step for step in built.steps if step.seat == joint.part), None)
    low, high = joint.position - joint.length / 2.0, joint.position + joint.length / 2.0
    if seat is not None:
        before = max((step.diameter for step in built.steps if step.end <= seat.start), default=0.0)
        behind = max((step.diameter for step in built.steps if step.start >= seat.end), default=0.0)
        low, high = (seat.start, high) if before <= behind else (low, seat.end)
    return Toothing(MM * low, MM * high, spline_of(joint), joint.designation)


def spline_of(joint: JointSizing) -> Spline:
    """Return the splines of a joint.

    Args:
        joint: A splined one, such as ``DIN 5480 - W 25 x 1.25 x 18``.
    """
    return spline(joint.diameter, joint.module)


# ----------------------------------------------------------------------------------------------------------------------
# Undercuts of seats (DIN 509, form F) and of threads (DIN 76, form A): their profile and their enlarged detail.
# ----------------------------------------------------------------------------------------------------------------------


RUN_IN, RUN_OUT = math.radians(15.0), math.radians(8.0)
"""Angles to the seat and to the face [rad] (DIN 509:1998, form F)."""
ENLARGED, THREAD_ENLARGED = 10.0, 5.0
"""Scales of the details of undercuts of seats and of threads [-]."""
AROUND = 1.5
"""Of seat and face beside the undercut in the detail, and metal below it [mm]."""
_TURNS = 8


def undercut_profile(standard: Undercut) -> list[tuple[float, float]]:
    """Return the corners of an undercut from seat to face: from the face along the seat, and above the seat [mm].

    Args:
        standard: The undercut.
    """
    depth, behind, radius = (
        MM * standard.depth,
        MM * standard.face_depth,
        MM * standard.radius,
    )
    width = MM * standard.width
    quarter = [math.pi / 2.0 * k / _TURNS for k in range(_TURNS + 1)]
    rounded = [(radius * (1.0 - math.sin(turn)) - behind, radius * (1.0 - math.cos(turn)) - depth) for turn in quarter]
    return [
        (width, 0.0), (width - depth / math.tan(RUN_IN), -depth),
        *rounded, (0.0, radius - depth + behind / math.tan(RUN_OUT)),
    ]  # fmt: skip


def undercut_detail(standard: Undercut) -> list[Entity]:
    """Return the enlarged section of an undercut with its sizes; the seat on the left, the face on the right.

    Args:
        standard: The undercut.
    """
    corners = [complex(-along, above) for along, above in undercut_profile(standard)]
    seat, foot, top, behind = corners[0], corners[1], corners[-1], corners[-2]
    edge = (seat - AROUND, *corners, top + 1j * AROUND)
    low = complex(behind.real + AROUND, foot.imag - AROUND)
    around = (*edge, complex(low.real, edge[-1].imag), low, complex(edge[0].real, low.imag))
    entities: list[Entity] = [
        Hatch(tuple(ENLARGED * point for point in around)),
        Path(tuple(ENLARGED * point for point in edge), Layer.OUTLINE),
    ]
    above = ENLARGED * (top + 1j * AROUND)
    rounding = ENLARGED * corners[2 + _TURNS // 2]
    knee = complex(rounding.real - 6.0, ENLARGED * top.imag * 0.5 + 2.0)
    radius = f"R{millimetres(MM * standard.radius)}"
    shoulder = knee - complex(Words(0j, radius).length + 2.0, 0.0)
    entities += [
        Distance(ENLARGED * seat, above, above + 8j, 0.0, ENLARGED),
        Distance(above, ENLARGED * behind, above + 18j, 0.0, ENLARGED),
        Distance(ENLARGED * seat, ENLARGED * foot, ENLARGED * edge[0] - 5.0, math.pi / 2.0, ENLARGED),
        Path((shoulder, knee, rounding), Layer.DIMENSION),
        arrow(rounding, (rounding - knee) / abs(rounding - knee)),
        Words(shoulder + complex(1.0, GAP), radius, TEXT, layer=Layer.DIMENSION),
    ]
    left, _, right, high = extent(entities)
    entities.append(Words(complex((left + right) / 2.0, high + 3.0 + SMALL), standard.designation, TEXT, "middle"))
    entities.append(Words(complex((left + right) / 2.0, high + 1.5), f"{ENLARGED:g}:1", SMALL, "middle"))
    return entities


def relief_profile(standard: ThreadUndercut) -> list[tuple[float, float]]:
    """Return the corners of a thread's undercut: along the shaft from one of its edges, and above its edges [mm].

    Args:
        standard: The undercut; on both sides its flanks lean by 30°, which meet its bottom in its radius.
    """
    depth, width, radius = (
        MM * standard.below / 2.0,
        MM * standard.width,
        MM * standard.radius,
    )
    foot = depth / math.tan(THREAD_RUN_IN) + radius * math.tan(THREAD_RUN_IN / 2.0)
    turns = [THREAD_RUN_IN * k / _TURNS for k in range(_TURNS, -1, -1)]
    half = [(0.0, 0.0), *((foot - radius * math.sin(turn), radius * (1.0 - math.cos(turn)) - depth) for turn in turns)]
    return [*half, *((width - along, above) for along, above in reversed(half))]


def relief_detail(standard: ThreadUndercut) -> list[Entity]:
    """Return the enlarged section of a thread's undercut with its sizes; the seat on the left, the thread on the right.

    Args:
        standard: The undercut.
    """
    corners = [complex(along, above) for along, above in relief_profile(standard)]
    left, right, bottom = corners[0], corners[-1], complex(corners[0].real, -MM * standard.below / 2.0)
    edge = (left - 2.0 * AROUND, *corners, right + 2.0 * AROUND)
    low = bottom.imag - AROUND
    around = (*edge, complex(edge[-1].real, low), complex(edge[0].real, low))
    scale = THREAD_ENLARGED
    entities: list[Entity] = [
        Hatch(tuple(scale * point for point in around)),
        Path(tuple(scale * point for point in edge), Layer.OUTLINE),
    ]
    rounding = scale * corners[1 + _TURNS // 2]
    knee = complex(rounding.real + 4.0, 7.0)
    radius = f"R{millimetres(MM * standard.radius)}"
    flat = scale * corners[1 + _TURNS]
    entities += [
        Distance(scale * left, scale * right, scale * right + 16j, 0.0, scale),
        Distance(flat, scale * left, scale * edge[0] - 5.0, math.pi / 2.0, scale),
        Path((knee + Words(0j, radius).length + 2.0, knee, rounding), Layer.DIMENSION),
        arrow(rounding, (rounding - knee) / abs(rounding - knee)),
        Words(knee + complex(1.0, GAP), radius, TEXT, layer=Layer.DIMENSION),
    ]
    first, _, last, high = extent(entities)
    entities.append(Words(complex((first + last) / 2.0, high + 3.0 + SMALL), standard.designation, TEXT, "middle"))
    entities.append(Words(complex((first + last) / 2.0, high + 1.5), f"{scale:g}:1", SMALL, "middle"))
    return entities


# ----------------------------------------------------------------------------------------------------------------------
# The outline of a shaft, seen from the side, with what is cut into it.
# ----------------------------------------------------------------------------------------------------------------------


OVERSHOOT = 3.0
"""How far a centre line goes beyond what it belongs to [mm]."""
NEAR = 1e-6
"""Places that are nearer to each other are one [mm]."""
_TURN = tuple(2.0 * math.pi * k / 96 for k in range(97))


class SheetAxis(NamedTuple):
    """Where the axis of a part lies on the sheet."""

    origin: complex
    """Of its first end [mm of paper]."""
    along: complex
    """Direction to its second end, of length 1 [-]."""
    scale: float
    """mm of paper per mm [-]."""

    def at(self, x: float, radius: float = 0.0) -> complex:
        """Return a point of the part on the sheet [mm of paper].

        Args:
            x: Along the axis [mm].
            radius: To the left of the axis [mm].
        """
        return self.on(complex(x, radius))

    def on(self, point: complex) -> complex:
        """Return a point of the part on the sheet [mm of paper].

        Args:
            point: Along the axis, and to the left of it [mm].
        """
        return self.origin + self.scale * self.along * point


def shaft_outline(axis: SheetAxis, body: ShaftBody) -> list[Entity]:
    """Return a shaft seen from the side, with its centre line.

    Args:
        axis: Where it lies.
        body: What it is.
    """
    start, end = body.pieces[0].start, body.pieces[-1].end
    beyond = OVERSHOOT / axis.scale
    entities: list[Entity] = [Path((axis.at(start - beyond), axis.at(end + beyond)), Layer.CENTRE)]
    upper = _profile(body)
    corners = [*upper, *((x, -r) for x, r in reversed(upper))]
    entities.append(Path(tuple(axis.at(x, r) for x, r in corners), Layer.OUTLINE, closed=True))
    entities += _edges(axis, body)
    for piece in body.pieces:
        entities += _pitch_lines(axis, piece)
    if body.bore:
        entities += [
            Path((axis.at(start, side * body.bore / 2.0), axis.at(end, side * body.bore / 2.0)), Layer.HIDDEN)
            for side in (-1.0, 1.0)
        ]
    for slot in body.slots:
        entities += _slot_from_above(axis, slot)
    for toothing in body.splines:
        entities += _spline(axis, toothing)
    return entities


def end_chamfer(piece: Piece) -> float:
    """Return the chamfer of a shaft's end [mm]; none on teeth, of a thread down to its core.

    Args:
        piece: First or last of the shaft.
    """
    if piece.toothed:
        return 0.0
    if piece.thread is not None:
        return MM * thread_chamfer(piece.thread.nut.pitch)
    return next(chamfer for up_to, chamfer in CHAMFERS if piece.diameter <= up_to)


def _profile(body: ShaftBody) -> list[tuple[float, float]]:
    """Return the upper outline from the first end to the second: along the axis, radius [mm]."""
    first, last = body.pieces[0], body.pieces[-1]
    points: list[tuple[float, float]] = []
    fillets = {round(x, 6): radius for x, radius in body.fillets}
    for before, piece in zip((None, *body.pieces), body.pieces, strict=False):
        start = [(piece.start, piece.diameters[0] / 2.0)]
        if before is not None and not (before.conical or piece.conical):
            cut = next((cut for cut in body.undercuts if abs(MM * cut.place - piece.start) < NEAR), None)
            foot = _fillet(before, piece, fillets.get(round(piece.start, 6), 0.0)) if cut is None else _undercut(cut)
            if foot and before.diameters[1] < piece.diameters[0]:
                points[-1:] = foot
            elif foot:
                start = foot
        if piece.relieved and piece.thread is not None and piece.thread.undercut is not None:
            top = MM * piece.thread.nut.thread / 2.0
            points += [(piece.start + x, top + above) for x, above in relief_profile(piece.thread.undercut)]
            continue
        end = [(piece.end, piece.diameters[1] / 2.0)]
        chamfer = end_chamfer(piece) if piece.thread is not None and not piece.relieved else 0.0
        if chamfer and piece.thread is not None and piece.thread.way < 0 and piece is not first:
            start = [(piece.start, start[0][1] - chamfer), (piece.start + chamfer, start[0][1])]
        elif chamfer and piece.thread is not None and piece.thread.way > 0 and piece is not last:
            end = [(piece.end - chamfer, end[0][1]), (piece.end, end[0][1] - chamfer)]
        points += [*start, *end]
    first_chamfer, last_chamfer = end_chamfer(first), end_chamfer(last)
    if first_chamfer:
        points[:1] = [(first.start, points[0][1] - first_chamfer), (first.start + first_chamfer, points[0][1])]
    if last_chamfer:
        points[-1:] = [(last.end - last_chamfer, points[-1][1]), (last.end, points[-1][1] - last_chamfer)]
    return points


def _undercut(cut: Cut) -> list[tuple[float, float]]:
    """Return the points of an undercut, from left to right."""
    way, radius = math.copysign(1.0, cut.edge - cut.place), MM * (cut.bottom / 2.0 + cut.standard.depth)
    points = [(MM * cut.place + way * along, radius + above) for along, above in undercut_profile(cut.standard)]
    return points if way < 0.0 else points[::-1]


def _fillet(left: Piece, right: Piece, radius: float) -> list[tuple[float, float]]:
    """Return the points of a fillet between two pieces, from left to right; none without one."""
    thin, thick = sorted((left.diameters[1] / 2.0, right.diameters[0] / 2.0))
    if not radius or thick <= thin:
        return []
    turn = math.acos(max(0.0, 1.0 - (thick - thin) / radius))
    reach = radius * math.sin(turn)
    arc = [
        (reach - radius * math.sin(turn * k / 8.0), thin + radius * (1.0 - math.cos(turn * k / 8.0))) for k in range(9)
    ]
    if left.diameters[1] < right.diameters[0]:
        return [(right.start - x, r) for x, r in arc]
    return [(right.start + x, r) for x, r in arc[::-1]]


def _edges(axis: SheetAxis, body: ShaftBody) -> Iterator[Entity]:
    """Yield the round edges that are seen as lines across: of shoulders and chamfers."""
    for left, right in pairwise(body.pieces):
        radius = max(left.diameters[1], right.diameters[0]) / 2.0
        # Where only a seat ends, its limit is a thin line (ISO 129-1).
        layer = Layer.THIN if left.diameters[1] == right.diameters[0] else Layer.OUTLINE
        yield Path((axis.at(left.end, radius), axis.at(left.end, -radius)), layer)
    chamfered = [(body.pieces[0], body.pieces[0].start, 1.0), (body.pieces[-1], body.pieces[-1].end, -1.0)]
    for piece in body.pieces[1:-1]:
        if piece.thread is not None and not piece.relieved:
            outwards = piece.thread.way > 0
            chamfered.append((piece, piece.end if outwards else piece.start, -1.0 if outwards else 1.0))
    for piece, x, sense in chamfered:
        chamfer, radius = end_chamfer(piece), piece.diameters[0 if sense > 0.0 else 1] / 2.0
        if chamfer:
            at = x + sense * chamfer
            yield Path((axis.at(at, radius), axis.at(at, -radius)), Layer.OUTLINE)


def _pitch_lines(axis: SheetAxis, piece: Piece) -> Iterator[Entity]:
    if piece.pitch is not None:
        start, end = (pitch / 2.0 for pitch in piece.pitch)
        slope = (end - start) / (piece.end - piece.start)
        more = 2.0 / axis.scale
        for side in (-1.0, 1.0):
            yield Path(
                (
                    axis.at(piece.start - more, side * (start - slope * more)),
                    axis.at(piece.end + more, side * (end + slope * more)),
                ),
                Layer.PITCH,
            )


def _slot_from_above(axis: SheetAxis, slot: Keyway) -> Iterator[Entity]:
    """Yield a keyway seen from above."""
    half = MM * slot.section.width / 2.0
    if slot.form == "B":
        corners = ((slot.start, -half), (slot.end, -half), (slot.end, half), (slot.start, half))
        yield Path(tuple(axis.at(*corner) for corner in corners), Layer.OUTLINE, closed=True)
        return
    for side in (-1.0, 1.0):
        ends = (axis.at(slot.start + half, side * half), axis.at(slot.end - half, side * half))
        yield Path(ends, Layer.OUTLINE)
    turn = math.atan2(axis.along.imag, axis.along.real)
    for x, facing in ((slot.start + half, math.pi), (slot.end - half, 0.0)):
        middle = turn + facing
        yield Arc(axis.at(x), half * axis.scale, Layer.OUTLINE, middle - math.pi / 2.0, middle + math.pi / 2.0)


def _spline(axis: SheetAxis, toothing: Toothing) -> Iterator[Entity]:
    """Yield root lines of splines, thin, and the pitch line (ISO 6413)."""
    for layer, diameter in ((Layer.THIN, toothing.teeth.shaft_root), (Layer.PITCH, toothing.teeth.pitch_diameter)):
        for side in (-1.0, 1.0):
            radius = side * MM * diameter / 2.0
            yield Path((axis.at(toothing.start, radius), axis.at(toothing.end, radius)), layer)
    for x in (toothing.start, toothing.end):
        radius = MM * toothing.teeth.shaft_tip / 2.0
        yield Path((axis.at(x, radius), axis.at(x, -radius)), Layer.OUTLINE)


def keyed_rim(axis: SheetAxis, radius: float, half: float) -> list[complex]:
    """Return the rim of a shaft or bore about the origin of an axis, open where a keyway on top cuts it [mm of paper].

    Args:
        axis: Its origin is the middle.
        radius: Of the rim [mm].
        half: Half the width of the keyway [mm].
    """
    start = math.asin(half / radius)
    around = [start + (2.0 * math.pi - 2.0 * start) * k / 96 for k in range(97)]
    return [axis.at(radius * math.sin(angle), radius * math.cos(angle)) for angle in around]


def key_section(axis: SheetAxis, slot: Keyway, bore: float = 0.0) -> list[Entity]:
    """Return the section of a shaft through a keyway, looking along its axis; the keyway is on top.

    Args:
        axis: Its origin is the middle.
        slot: The keyway.
        bore: Of the shaft [mm].
    """
    radius, half = slot.diameter / 2.0, MM * slot.section.width / 2.0
    floor = radius - MM * slot.section.shaft_depth
    rim = keyed_rim(axis, radius, half)
    outline = (*rim, axis.at(-half, floor), axis.at(half, floor))
    reach = radius + OVERSHOOT / axis.scale
    inner = [axis.at(bore / 2.0 * math.sin(-angle), bore / 2.0 * math.cos(angle)) for angle in _TURN] if bore else []
    entities: list[Entity] = [
        Hatch((*rim, *((rim[-1], *inner, rim[-1]) if inner else ()), *outline[97:])),
        Path(outline, Layer.OUTLINE, closed=True),
        Path((axis.at(-reach), axis.at(reach)), Layer.CENTRE),
        Path((axis.at(0.0, -reach), axis.at(0.0, reach)), Layer.CENTRE),
    ]
    if bore:
        entities.append(Arc(axis.at(0.0), bore / 2.0 * axis.scale, Layer.OUTLINE))
    return entities


# ----------------------------------------------------------------------------------------------------------------------
# What is written across an axis, above a part: diameters, designations, textures and frames of tolerances.
# ----------------------------------------------------------------------------------------------------------------------


ACROSS = 10.5
"""Between what is written across an axis: a texture mark on one side reaches beside half a frame on the other [mm]."""

AT_FACE = 2.5
"""Between the foot of a leader and the face that it points at [mm of paper]."""


class Callout(NamedTuple):
    """Something written across a shaft: a diameter, or a designation with a leader."""

    x: float
    """Along the axis [mm]."""
    radius: float
    """Of the outline there [mm]."""
    suffix: str
    """After the diameter."""
    words: str = ""
    """Instead of a diameter."""
    texture: str = ""
    tolerance: GeometricTolerance | None = None
    """Of the surface there, instead of words."""
    face: float = 0.0
    """−1 or +1 where a face is meant that lies to the right or to the left of the leader's foot."""


def marked(axis: SheetAxis, mark: Callout, place: float, top: float) -> Iterator[Entity]:
    """Yield a diameter whose line goes on above the shaft, to its slot, with the text along it.

    Args:
        axis: Of the part.
        mark: What is written.
        place: Along the axis, above which it stands [mm of paper].
        top: Radius of the part where it is thickest [mm of paper].
    """
    low, high = axis.at(mark.x, -mark.radius), axis.at(mark.x, mark.radius)
    start = complex(place, axis.origin.imag + top + 8.0)
    knee = complex(high.real, axis.origin.imag + top + 2.0)
    if mark.tolerance is not None:
        tip, way = (high - mark.face * AT_FACE, complex(-mark.face)) if mark.face else (high, -1j)
        yield Path(((tip, high, knee, start) if mark.face else (high, knee, start)), Layer.SYMBOL)
        yield arrow(tip, way, Layer.SYMBOL)
        yield from tolerance_frame(start, mark.tolerance, math.pi / 2.0)
        return
    words = mark.words or f"Ø{millimetres(2.0 * mark.radius)}{mark.suffix}"
    length = words_length(words, TEXT)
    middle = start + 1j * (1.0 + length / 2.0) - GAP
    tail = start + 1j * (2.0 + length)
    if mark.words:
        yield Words(middle, words, TEXT, "middle", math.pi / 2.0, Layer.DIMENSION)
    else:
        yield Distance(low, high, high, math.pi / 2.0, axis.scale, "Ø", mark.suffix, middle)
    end = tail + (1j * texture_length(mark.texture) if mark.texture else 0.0)
    yield Path((high, knee, start, end), Layer.DIMENSION)
    if mark.texture:
        yield from texture(tail + 2.5j, mark.texture, math.pi / 2.0)


# ----------------------------------------------------------------------------------------------------------------------
# What drawn parts weigh and how their bodies are: as the complete mass has them, whose bodies the solids have, too.
# ----------------------------------------------------------------------------------------------------------------------


class Made(NamedTuple):
    """Parts as they are made."""

    weights: Mapping[str, float]
    """Gear, shaft or carrier -> mass of one [kg]."""
    casing: Mapping[str, float]
    """Housing shell, housing ribs and what else a housing is weighed as -> mass [kg]."""
    total: float
    """Of the whole gearbox [kg]."""
    blanks: Mapping[str, Blank]
    """External gear -> its body."""


@of_latest(1)
def made_of(sizing: Sizing) -> Made:
    """Return the parts of a sizing as they are made.

    Args:
        sizing: What was sized.
    """
    whole = complete_mass(sizing)
    weights = {str(item.part): item.each for item in whole.parts if item.group in TRAIN}
    casing = {item.part: item.total for item in whole.parts if item.group == "housing"}
    return Made(weights, casing, whole.total, gear_blanks(sizing))


def mass_with_gears(sizing: Sizing, gears: tuple[str, ...], shaft: str) -> float:
    """Return the mass of a shaft with the gears that are one piece with it [kg].

    Args:
        sizing: What was sized.
        gears: One piece with it.
        shaft: Its name.
    """
    weights, whole = made_of(sizing).weights, [gear_of(sizing, name) for name in gears]
    return weights.get(shaft, 0.0) + sum(weights[gear.name] * gear.bodies / len(gear.shafts) for gear in whole)
