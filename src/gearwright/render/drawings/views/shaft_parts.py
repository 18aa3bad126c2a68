"""A shaft as its drawing shows it: turned pieces, teeth that are one piece with it, keyways and splines; in mm."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from gearwright.catalogue import THREAD_TOLERANCE, key_for_shaft, seat_tolerance
from gearwright.catalogue.standard_parts.radial_seals import SHAFT as UNDER_SEAL
from gearwright.parts.bevel import BevelProfile
from gearwright.parts.bevel import bevel_profile as bevel_teeth
from gearwright.parts.joints import KeySection, Spline, spline
from gearwright.shape.teeth import bevel_pair, cylindrical_gear, gear_of, halves_of, kind_of, meshes_of
from gearwright.sizing import BuiltShaft, GearSizing, JointSizing, ShaftStep, Sizing
from gearwright.sizing.places import runs
from gearwright.sizing.shafts import Cut, Thread, grooves, sealed_exits, threads, undercuts_of

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
class Slot:
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
    slots: tuple[Slot, ...] = ()
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


def _slot(joint: JointSizing) -> Slot:
    section = key_for_shaft(joint.diameter).section
    half = MM * joint.length / 2.0
    middle = MM * joint.position
    return Slot(middle - half, middle + half, MM * joint.diameter, section, joint.designation, joint.form)


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
