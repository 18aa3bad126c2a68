"""Sections of gears along their axis by ISO 2203, cylindrical, bevel and face gears, with dimensions."""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from gearwright.base import Role
from gearwright.catalogue import LARGEST, SMALLEST, key_for_shaft, standard_tolerance
from gearwright.parts.bevel_geometry import BevelProfile, bevel_way, face_and_root
from gearwright.parts.gears import CylindricalGear, TransverseTooth, face_reach, face_way
from gearwright.parts.shafts import KeySection, Spline
from gearwright.render.drawings.entities import (
    Corner,
    Distance,
    Entity,
    GeometricTolerance,
    Hatch,
    Layer,
    Path,
    arrow,
    corner_leader,
    corner_words,
    datum,
    tolerance_frame,
    words_corners,
)
from gearwright.render.drawings.paper import Segment, crossings, segments
from gearwright.render.drawings.shaft_view import (
    MM,
    OVERSHOOT,
    SheetAxis,
    away_of,
    bevel_profile,
    keyed_rim,
    made_of,
    spline_of,
    toothed_piece,
)
from gearwright.shape.stands import cylindrical_gear, halves_of, is_internal, kind_of, meshes_of, stands_of
from gearwright.sizing import GearSizing, JointSizing, Sizing
from gearwright.sizing.casing import RingSeat, ring_seats
from gearwright.sizing.mass import bevel_cones as bevel_pair, bevel_dish, bevel_hub, bevel_web, pinion_of, tooth_of
from gearwright.sizing.places import BOSS, Bell
from gearwright.sizing.rating import BACKUP
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# A gear's body as its drawing shows it: bore, joint and rim; in mm.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_WALL = 1.0
"""Wall between a bore and the roots of the teeth below which no bore is drawn, in modules [-]."""


@dataclass(frozen=True)
class Boss:
    """The hub of a bevel gear where it sits on its shaft, along the axis away from the apex, from the mean point."""

    start: float
    """[mm]"""
    end: float
    """[mm]"""
    diameter: float
    """[mm]"""


class Web(NamedTuple):
    """What is turned out of a cylindrical gear on both sides, between its rim and its hub [mm]."""

    rim: float
    """Radius inside the rim."""
    hub: float
    """Radius outside of the hub."""
    width: float
    """Of what is left between them."""
    holes: int = 0
    """Through it, evenly spaced [-]."""
    circle: float = 0.0
    """Radius of the circle of their middles."""
    hole: float = 0.0
    """Radius of one."""
    dish: float = 0.0
    """How far it stands at the hub from where it stands at the rim, towards the shaft's second end."""

    def aside(self, radius: float) -> float:
        """Return how far it stands from the middle at a radius [mm].

        Args:
            radius: Between hub and rim [mm].
        """
        return self.dish * (self.rim - radius) / (self.rim - self.hub)


@dataclass(frozen=True)
class Hub:
    """The bore of a gear and what is cut into it."""

    bore: float
    """[mm]; zero where there is none."""
    tolerance: str = ""
    """Tolerance class of the bore."""
    key: KeySection | None = None
    teeth: Spline | None = None
    designation: str = ""
    note: str = ""
    """Where the bore comes from, or why there is none."""
    boss: Boss | None = None
    """Of a bevel gear whose seat is sized."""
    web: Web | None = None
    """Of a cylindrical gear that is not solid between rim and hub."""
    way: tuple[complex, ...] = ()
    """Behind the teeth of a bored bevel gear, as it is weighed: along the axis away from the apex, and radius [mm]."""

    @property
    def reach(self) -> float:
        """Largest diameter that is cut out on the side of the keyway [mm]."""
        if self.key is not None:
            return self.bore + 2.0 * MM * self.key.hub_depth
        return MM * self.teeth.reference_diameter if self.teeth is not None else self.bore


def hub_of(sizing: Sizing, gear: GearSizing, shaft: str) -> Hub:
    """Return the bore of a gear: its joint's, or the diameter of what carries it where no joint is sized.

    Args:
        sizing: What was sized.
        gear: One of its gears.
        shaft: That carries it.
    """
    hub = _bored(sizing, gear, shaft)
    return replace(hub, web=_web(sizing, gear), way=_way(sizing, gear, hub))


def _way(sizing: Sizing, gear: GearSizing, hub: Hub) -> tuple[complex, ...]:
    """Return the way behind the teeth of a bored bevel gear, with the bore that is drawn."""
    if not hub.bore or kind_of(sizing, gear.stage) != "bevel":
        return ()
    pair, side = bevel_pair(sizing, gear.stage), meshes_of(sizing, gear.name)[0][1]
    bore = made_of(sizing).blanks[gear.name].bore_radius
    web, seat = bevel_web(sizing, gear, bore), bevel_hub(sizing, gear, bore)
    points = bevel_way(pair, side, bore, web, seat, dish=bevel_dish(sizing, gear))
    inner = min(radius for _, radius in points)
    return tuple(complex(MM * z, hub.bore / 2.0 if radius == inner else MM * radius) for z, radius in points)


def _web(sizing: Sizing, gear: GearSizing) -> Web | None:
    """Return what is turned out of a cylindrical gear, as it is weighed; None of a solid one."""
    blank = made_of(sizing).blanks.get(gear.name)
    if blank is None or blank.is_solid or kind_of(sizing, gear.stage) != "cylindrical":
        return None
    web = Web(
        MM * blank.rim_radius, MM * blank.hub_radius, MM * halves_of(gear) * blank.web_width, dish=MM * blank.dish
    )
    if not blank.hole_radius:
        return web
    return web._replace(holes=blank.holes, circle=MM * blank.hole_circle, hole=MM * blank.hole_radius)


def _bored(sizing: Sizing, gear: GearSizing, shaft: str) -> Hub:
    """Return the bore of a gear."""
    joint = next((joint for joint in sizing.joints if joint.part == gear.name and joint.shaft == shaft), None)
    if joint is not None:
        hub = _joined(joint)
        return replace(hub, boss=_boss(sizing, gear, joint, hub)) if kind_of(sizing, gear.stage) == "bevel" else hub
    if is_internal(sizing, gear):
        return Hub(0.0, note=_held(sizing, gear, shaft))
    carrier = next((carrier for carrier in sizing.carriers if carrier.stage == gear.stage), None)
    if gear.role is Role.PLANET and carrier is not None:
        bore = 2.0 * MM * made_of(sizing).blanks[gear.name].bore_radius
        what = (
            "its bearings" if gear.runs_on else f"what its load asks for on a pin of Ø{MM * carrier.pin_diameter:.4g}"
        )
        return _fitting(sizing, gear, bore, f"Bore: outside of {what}, as weighed.")
    sized = next((body for body in sizing.shafts if body.name == shaft), None)
    diameter = MM * sized.diameter if sized is not None else 0.0
    return _fitting(sizing, gear, diameter, "Bore: diameter of the shaft; their joint is not sized.")


def _held(sizing: Sizing, ring: GearSizing, shaft: str) -> str:
    """Return what holds a ring."""
    if shaft != GROUND:
        return f"The arrangement has its bell to shaft {shaft}; their joint is not sized, and not drawn."
    seat = next((seat for seat in ring_seats(sizing) if seat.ring is ring), None)
    if seat is None:
        return "What holds the ring is not sized, and not drawn."
    length, tip = (f"{MM * size:.4g}" for size in (seat.spline[1] - seat.spline[0], seat.teeth.shaft_tip))
    return (
        f"Outside, about the middle: splines W {seat.name} (as DIN 5480-1, which has no such diameter), {length} long, "
        f"Ø{tip} over tips, drawn to half of their height."
    )


def _joined(joint: JointSizing) -> Hub:
    diameter = MM * joint.diameter
    if joint.kind == "integral":
        return Hub(0.0, note=f"One piece with shaft {joint.shaft}; see its sheet.")
    if joint.kind == "key":
        return Hub(diameter, "H7", key=key_for_shaft(joint.diameter).section, designation=joint.designation,
                   note="Bore H7, keyway P9 (assumed).")  # fmt: skip
    if joint.kind == "spline":
        teeth = spline_of(joint)
        designation = joint.designation.replace(" W ", " N ")
        note = f"Hub {designation}; the bore shown is its tip circle."
        return Hub(MM * teeth.hub_tip, teeth=teeth, designation=designation, note=note)
    return Hub(diameter, "H7", note="Bore H7 (assumed); press fit by its joint's calculation.")


def _boss(sizing: Sizing, gear: GearSizing, joint: JointSizing, hub: Hub) -> Boss | None:
    """Return the hub over the gear's seat on its shaft, within the root at the small end; None of one piece with it."""
    built = next(shaft for shaft in sizing.built_shafts if shaft.name == joint.shaft)
    seats = [step for step in built.steps if step.seat == gear.name]
    if not hub.bore or not seats:
        return None
    away = away_of(sizing, gear)
    ends = sorted(away * MM * (edge - joint.position) for edge in (seats[0].start, seats[-1].end))
    root = 2.0 * bevel_profile(sizing, gear).roots[0].imag
    return Boss(ends[0], ends[1], max(min(BOSS * hub.reach, root), hub.bore))


def _fitting(sizing: Sizing, gear: GearSizing, diameter: float, note: str) -> Hub:
    """Return a plain bore, or none where it would leave no wall under the teeth."""
    if kind_of(sizing, gear.stage) == "bevel":
        root = toothed_piece(sizing, gear, 0.0).diameters
        inner = min(root) - 2.0 * MM * 2.25 * gear.module
    else:
        inner = 2.0 * MM * cylindrical_gear(sizing, gear).root_radius
    if diameter > inner - 2.0 * LEAST_WALL * MM * gear.module:
        return Hub(0.0, note=f"A shaft of Ø{diameter:.4g} leaves no wall under the teeth: one piece with its shaft.")
    return Hub(diameter, note=note)


# ----------------------------------------------------------------------------------------------------------------------
# Sections of gears along their axis by ISO 2203, and of hubs across it.
# ----------------------------------------------------------------------------------------------------------------------


def cylinder_section(
    axis: SheetAxis, teeth: CylindricalGear, hub: Hub, span: tuple[float, float], *, lean: float
) -> list[Entity]:
    """Return an external gear in section, both halves.

    Args:
        axis: Where its axis lies.
        teeth: Its teeth.
        hub: Its bore.
        span: From face to face along the axis [mm].
        lean: Angle of the hatching [rad].
    """
    root, tip = MM * teeth.root_radius, MM * teeth.tip_radius
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        inner = (hub.reach if side > 0.0 else _bottom(hub)) / 2.0
        whole = _box(span, inner, root, side) if hub.web is None else _webbed(span, hub.web, inner, root, side)
        bodies = [whole] if hub.web is None or not hub.web.holes else _bored_web(whole, hub.web, side)
        outline = _box(span, hub.bore / 2.0, tip, side)
        # Without a bore the two halves are one: no edge lies on the axis.
        entities += [hatched(axis, body, lean) for body in bodies]
        entities.append(line(axis, outline[1:] + outline[:1], closed=hub.bore > 0.0))
        entities.append(line(axis, _along(span, side * root)))
        if hub.web is not None:
            entities += [line(axis, recess) for recess in _recesses(span, hub.web, side)]
            entities += _hole(axis, hub.web, (span[0] + span[1]) / 2.0, side)
        if inner > hub.bore / 2.0:
            entities.append(line(axis, _along(span, side * inner)))
        entities.append(_pitch(axis, span, side * MM * teeth.pitch_radius))
    return entities


def _recesses(span: tuple[float, float], web: Web, side: float) -> list[list[complex]]:
    """Return the edges of what is turned out on both faces, from the hub over the web to the rim."""
    middle, half = (span[0] + span[1]) / 2.0, web.width / 2.0
    ways = ((span[0], middle - half), (span[1], middle + half))
    return [
        [complex(face, side * web.hub), complex(deep + web.dish, side * web.hub),
         complex(deep, side * web.rim), complex(face, side * web.rim)]
        for face, deep in ways
    ]  # fmt: skip


def _webbed(span: tuple[float, float], web: Web, inner: float, root: float, side: float) -> list[complex]:
    """Return the section of a body with rim, web and hub."""
    first, second = _recesses(span, web, side)
    return [complex(span[0], side * inner), *first, *_along(span, side * root), *second[::-1],
            complex(span[1], side * inner)]  # fmt: skip


def _bored_web(body: list[complex], web: Web, side: float) -> list[list[complex]]:
    """Return the two parts of a section through a hole of its web: around the hub, and around the rim."""
    ends = [[complex(x, side * (web.circle + way * web.hole)) for x in (body[2].real, body[9].real)] for way in (-1, 1)]
    inner = [*body[:3], *ends[0], *body[9:]]
    outer = [ends[1][0], *body[3:9], ends[1][1]]
    return [inner, outer]


def _hole(axis: SheetAxis, web: Web, middle: float, side: float) -> Iterator[Path]:
    """Yield the edges of a hole in a web, and its centre line."""
    half, more = web.width / 2.0, OVERSHOOT / axis.scale
    for radius in (web.circle - web.hole, web.circle + web.hole) if web.holes else ():
        yield line(axis, _along((middle - half, middle + half), side * radius))
    if web.holes:
        yield line(axis, _along((middle - half - more, middle + half + more), side * web.circle), Layer.CENTRE)


def ring_section(
    axis: SheetAxis, teeth: CylindricalGear, outer: float, span: tuple[float, float], *, lean: float
) -> list[Entity]:
    """Return an internal gear in section, both halves.

    Args:
        axis: Where its axis lies.
        teeth: Its teeth, with a negative number.
        outer: Outer radius of the ring [mm].
        span: From face to face along the axis [mm].
        lean: Angle of the hatching [rad].
    """
    root, tip = MM * teeth.root_radius, MM * teeth.tip_radius
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        entities += [
            hatched(axis, _box(span, root, outer, side), lean),
            line(axis, _box(span, tip, outer, side), closed=True),
            line(axis, _along(span, side * root)),
            _pitch(axis, span, side * MM * teeth.pitch_radius),
        ]
    return entities


def seat_section(axis: SheetAxis, seat: RingSeat, middle: float, *, lean: float) -> list[Entity]:
    """Return the splines of a ring that stands in the housing in section, to half of their height, both halves.

    Args:
        axis: Of the ring.
        seat: Of the ring.
        middle: Of the ring along the axis [mm].
        lean: Angle of the hatching [rad].
    """
    span = (middle + MM * seat.spline[0], middle + MM * seat.spline[1])
    return list(_rings(axis, span, (MM * seat.teeth.shaft_root / 2.0, MM * seat.middle), lean))


def keeper_section(axis: SheetAxis, seat: RingSeat, middle: float, *, lean: float) -> list[Entity]:
    """Return the ring that keeps a ring in the housing in section, both halves.

    Args:
        axis: Of the ring.
        seat: Of the ring.
        middle: Of the ring along the axis [mm].
        lean: Angle of the hatching [rad].
    """
    span = (middle + MM * seat.keeper[0], middle + MM * seat.keeper[1])
    return list(_rings(axis, span, (MM * seat.clear, MM * seat.outside), lean))


def _rings(axis: SheetAxis, span: tuple[float, float], radii: tuple[float, float], lean: float) -> Iterator[Entity]:
    for side in (1.0, -1.0):
        corners = _box(span, radii[0], radii[1], side)
        yield from (hatched(axis, corners, lean), line(axis, corners, closed=True))


def bell_section(axis: SheetAxis, bell: Bell, *, lean: float) -> list[Entity]:
    """Return what joins a turning ring to its shaft in section, both halves.

    Args:
        axis: Of the shaft.
        bell: As sized.
        lean: Angle of the hatching [rad].
    """
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        corners = [complex(MM * place, side * MM * radius) for place, radius in bell.section]
        entities += [hatched(axis, corners, lean), line(axis, corners, closed=True)]
    return entities


def bell_anchor(bell: Bell) -> complex:
    """Return a point in the disc of a bell, along its shaft and beside it [mm].

    Args:
        bell: As sized.
    """
    (face, hub), (_, inside) = bell.section[:2]
    return MM * complex(face + 0.4 * (bell.section[-2][0] - face), 0.4 * hub + 0.6 * inside)


def bevel_corners(profile: BevelProfile, hub: Hub) -> list[complex]:
    """Return the body of a bevel gear below the roots of its teeth, as it is weighed, upper half.

    Args:
        profile: Corners of its teeth.
        hub: Its bore, and the way behind the teeth; of one piece with its shaft, without one.

    Returns:
        Root at the small end, root at the large end, heel of the back cone, back to the bore, front from the bore:
        along the axis away from the apex, from the mean point, and radius [mm].
    """
    small, large = profile.roots
    if hub.way:
        return [small, large, *hub.way]
    heel = large + BACKUP * (large - profile.large[0])
    return [small, large, heel, complex(heel.real, 0.0), complex(small.real, 0.0)]


def bevel_section(axis: SheetAxis, profile: BevelProfile, hub: Hub, *, away: float, lean: float) -> list[Entity]:
    """Return a bevel gear in section, both halves, with its pitch cone from the apex on.

    Args:
        axis: Where its axis lies; x = 0 is the mean point.
        profile: Corners of its teeth.
        hub: Its bore.
        away: +1 where the apex lies towards the first end, −1 where it lies towards the second [-].
        lean: Angle of the hatching [rad].
    """
    entities: list[Entity] = []
    body = bevel_corners(profile, hub)
    for side in (1.0, -1.0):
        below = [complex(away * corner.real, side * corner.imag) for corner in body]
        tooth = [complex(away * corner.real, side * corner.imag)
                 for corner in (profile.roots[0], profile.small[0], profile.large[0], profile.roots[1])]  # fmt: skip
        entities += [hatched(axis, below, lean), line(axis, tooth)]
        entities.append(line(axis, below if hub.bore else [below[4], *below[:4]], closed=hub.bore > 0.0))
        more = profile.large[1] + (profile.large[1] - profile.small[1]) * 0.12
        ends = [complex(away * profile.apex, 0.0), complex(away * more.real, side * more.imag)]
        entities.append(line(axis, ends, Layer.PITCH))
    return entities


def hub_view(axis: SheetAxis, hub: Hub) -> list[Entity]:
    """Return the bore of a hub seen along its axis, keyway on top.

    Args:
        axis: Its origin is the middle.
        hub: With a keyway.
    """
    assert hub.key is not None
    radius, half = hub.bore / 2.0, MM * hub.key.width / 2.0
    top = hub.reach / 2.0
    outline = (*keyed_rim(axis, radius, half), axis.at(-half, top), axis.at(half, top))
    reach = radius + OVERSHOOT / axis.scale
    return [
        Path(outline, Layer.OUTLINE, closed=True),
        Path((axis.at(-reach), axis.at(reach)), Layer.CENTRE),
        Path((axis.at(0.0, -reach), axis.at(0.0, top + OVERSHOOT / axis.scale)), Layer.CENTRE),
    ]


def _bottom(hub: Hub) -> float:
    """Return the diameter that is cut out on the side without keyway [mm]."""
    return hub.bore if hub.key is not None else hub.reach


def bore_edges(axis: SheetAxis, span: tuple[float, float], hub: Hub) -> Iterator[Entity]:
    """Yield the edges of a bore that are seen behind the section.

    Args:
        axis: Where its axis lies.
        span: From face to face along the axis [mm].
        hub: The bore.
    """
    radius = hub.bore / 2.0
    for x in span if hub.bore else ():
        yield line(axis, [complex(x, -radius), complex(x, radius)])
    if hub.key is not None:
        flank = math.sqrt(radius**2 - (MM * hub.key.width / 2.0) ** 2)
        yield line(axis, _along(span, flank))


def _box(span: tuple[float, float], inner: float, outer: float, side: float) -> list[complex]:
    return [*_along(span, side * inner), *_along(span, side * outer)[::-1]]


def _along(span: tuple[float, float], radius: float) -> list[complex]:
    return [complex(x, radius) for x in span]


def hatched(axis: SheetAxis, corners: Sequence[complex], lean: float) -> Hatch:
    """Return a face that is cut.

    Args:
        axis: Of the part.
        corners: Along the axis and beside it [mm].
        lean: Angle of the hatching against the axis [rad].
    """
    turned = (lean + cmath.phase(axis.along)) % math.pi
    return Hatch(tuple(axis.on(corner) for corner in corners), turned)


def line(axis: SheetAxis, corners: Sequence[complex], layer: Layer = Layer.OUTLINE, *, closed: bool = False) -> Path:
    """Return a line over corners.

    Args:
        axis: Of the part.
        corners: Along the axis and beside it [mm].
        layer: Of the line.
        closed: Whether it ends where it begins.
    """
    return Path(tuple(axis.on(corner) for corner in corners), layer, closed=closed)


def _pitch(axis: SheetAxis, span: tuple[float, float], radius: float) -> Path:
    more = 2.0 / axis.scale
    return line(axis, _along((span[0] - more, span[1] + more), radius), Layer.PITCH)


# ----------------------------------------------------------------------------------------------------------------------
# Dimensions that cylindrical and bevel gears have in common: thickness of a web, run-out of a face.
# ----------------------------------------------------------------------------------------------------------------------


LEAN = math.pi / 4.0
"""Of the hatching [rad]."""
FACE_GRADE = 5
"""Of the run-out of a gear's faces; assumed."""
LEAST_BETWEEN = 8.0
"""Room on paper below which the thickness of a web stands in the notes alone [mm]."""


def thickness(axis: SheetAxis, web: tuple[float, float], radii: tuple[float, float]) -> Iterator[Distance]:
    """Yield the thickness of a web where the sheet has room between rim and hub.

    Args:
        axis: On paper.
        web: Where it begins and ends along the axis [mm].
        radii: Of hub and rim [mm].
    """
    if axis.scale * (radii[1] - radii[0]) > LEAST_BETWEEN:
        low, high = (axis.at(x, sum(radii) / 2.0) for x in web)
        yield Distance(low, high, low, 0.0, axis.scale)


def face_runout(root: float) -> GeometricTolerance | None:
    """Return what the face of a gear may run out against its bore; None beyond the sizes of ISO 286-1.

    Args:
        root: Root radius, where it is measured [mm].
    """
    if not SMALLEST < 2.0 * root / MM <= LARGEST:
        return None
    return GeometricTolerance("run-out", MM * standard_tolerance(2.0 * root / MM, FACE_GRADE), "A")


def runout_beside(face: complex, start: float, root: float) -> Iterator[Entity]:
    """Yield what a face that looks to the right may run out against the bore; nothing beyond the sizes of ISO 286-1.

    Args:
        face: Where the arrow meets it [mm of paper].
        start: Where the frame begins, on paper from left to right [mm].
        root: Radius at which it is measured [mm].
    """
    tolerance = face_runout(root)
    if tolerance is not None:
        left = complex(start, face.imag)
        yield from (Path((face, left), Layer.SYMBOL), arrow(face, -1 + 0j, Layer.SYMBOL))
        yield from tolerance_frame(left, tolerance)


# ----------------------------------------------------------------------------------------------------------------------
# The section of a bevel gear with its dimensions about the apex.
# ----------------------------------------------------------------------------------------------------------------------


BESIDE = 0.85
"""Share of the way from the apex to the hub that angles take, so that their texts stay clear of it [-]."""
SHARES = (1.0, 0.93, 0.86, 0.8, 0.74, 0.68, 0.62, 0.56, 0.5, 0.44, 0.38)
"""Of the radius of an angle's arc that are tried where lines run through its text [-]."""


def bevel_view(sizing: Sizing, gear: GearSizing, hub: Hub, axis: SheetAxis) -> list[Entity]:
    """Return a bevel gear in section with its dimensions.

    Args:
        sizing: What was sized.
        gear: A bevel gear of it.
        hub: Of the gear.
        axis: On paper.
    """
    profile = bevel_profile(sizing, gear)
    beyond = OVERSHOOT / axis.scale
    corners = bevel_corners(profile, hub)
    heel, bored = corners[2], _bore_ends(corners, hub)
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
        root = profile.roots[1].imag
        face = axis.at(heel.real, -0.9 * root)
        entities += runout_beside(face, max(right, face.real) + 24.0, root)
    if hub.boss is not None:
        outer = complex(max(hub.boss.end, heel.real), hub.boss.diameter / 2.0)
        entities += [_at(axis, outer, right + 8.0), _hub_length(axis, hub.boss, hub.bore / 2.0)]
        web = bevel_plate(hub)
        if web is not None:
            low, high = web.hub, web.rim
            front = web.front + web.lean * (high - 0.5 * (low + high))
            entities += thickness(axis, (front, front + web.width), (low, high))
    return entities


class Plate(NamedTuple):
    """The web of a bevel gear, from the mean point along the axis away from the apex [mm]."""

    front: float
    """Where its face towards the apex meets the rim."""
    width: float
    """Along the axis."""
    lean: float
    """Towards its hub [-]."""
    hub: float
    """Radius of the hub."""
    rim: float
    """Radius inside the rim, on the face towards the apex."""
    behind: float
    """The same behind."""


def bevel_plate(hub: Hub) -> Plate | None:
    """Return the web of a bored bevel gear; None where rim and hub meet.

    Args:
        hub: Of the gear.
    """
    if len(hub.way) < len(("heel", "back", "hub", "bore", "bore", "hub", "front", "toe")):
        return None
    toe, front = hub.way[-1], hub.way[-2]
    at = 2 if hub.way[1].imag != hub.way[2].imag else 1
    back = hub.way[at]
    lean = (front.real - toe.real) / (toe.imag - front.imag)
    return Plate(toe.real, back.real - front.real, lean, front.imag, toe.imag, hub.way[at - 1].imag)


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


def _bore_ends(corners: Sequence[complex], hub: Hub) -> tuple[float, float]:
    """Return where the bore begins and ends [mm]."""
    ends = [corner.real for corner in corners if corner.imag <= hub.bore / 2.0]
    return min(ends), max(ends)


def _hub_length(axis: SheetAxis, boss: Boss, bore: float) -> Distance:
    """Return the length of the hub, within its bore."""
    line = axis.at(0.0, -bore) + 2.0j
    return Distance(axis.at(boss.start, -bore), axis.at(boss.end, -bore), line, 0.0, axis.scale)


def _at(axis: SheetAxis, point: complex, x: float, suffix: str = "") -> Distance:
    return Distance(axis.on(point.conjugate()), axis.on(point), complex(x, 0.0), math.pi / 2.0, axis.scale, "Ø", suffix)


def _bevel_lengths(
    axis: SheetAxis, profile: BevelProfile, angles: Sequence[Corner], *, hub: Hub, back: float
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
    sizing: Sizing, gear: GearSizing, axis: SheetAxis, *, profile: BevelProfile, boss: Boss | None
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


# ----------------------------------------------------------------------------------------------------------------------
# The section of a face gear's wheel, as it is weighed, with its dimensions from the plane of its pitch circle.
# ----------------------------------------------------------------------------------------------------------------------


ASIDE, STEP = 9.0, 8.0
"""From a part to its first dimension line, and from each to the next [mm]."""


class FaceTeeth(NamedTuple):
    """Between which radii, and how far before and behind the plane of its pitch circle, a face gear has its teeth."""

    pinion: TransverseTooth
    """That its shaper is."""
    reach: tuple[float, float]
    """[mm]"""
    tip: float
    """Before the plane, towards the pinion [mm]."""
    root: float
    """Behind it [mm]."""


def is_face_wheel(sizing: Sizing, gear: GearSizing) -> bool:
    """Tell whether a gear is the wheel of a face-gear pair.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    return kind_of(sizing, gear.stage) == "face" and gear.role is Role.WHEEL


def face_teeth(sizing: Sizing, gear: GearSizing) -> FaceTeeth:
    """Return the teeth of the wheel of a face-gear pair.

    Args:
        sizing: What was sized.
        gear: The wheel.
    """
    mate = pinion_of(sizing, gear)
    tooth = tooth_of(sizing, mate)
    inner, outer = face_reach(tooth, gear.teeth, mate.face_width)
    tip, root = (MM * height * tooth.module for height in (tooth.rack.addendum, tooth.rack.dedendum))
    return FaceTeeth(tooth, (MM * inner, MM * outer), tip, root)


def toward_pinion(sizing: Sizing, gear: GearSizing, shaft: str) -> float:
    """Return +1 where the teeth of a wheel look towards its shaft's second end, −1 where towards the first.

    Args:
        sizing: What was sized.
        gear: The wheel of a face-gear pair.
        shaft: That carries it.
    """
    stands = {stand.node: stand for stand in stands_of(sizing) if stand.gear.stage == gear.stage}
    own = stands[shaft]
    mate = next(stand for stand in stands.values() if stand.gear.role is Role.PINION)
    return math.copysign(1.0, float((mate.axes.origin - own.axes.origin) @ own.axes.along))


def face_section(
    sizing: Sizing, gear: GearSizing, hub: Hub, axis: SheetAxis, *, toward: float, lean: float
) -> list[Entity]:
    """Return the wheel of a face-gear pair in section, both halves; x = 0 is the plane of its pitch circle.

    Args:
        sizing: What was sized.
        gear: The wheel.
        hub: Its bore.
        axis: Where its axis lies.
        toward: +1 where its teeth look along the axis, −1 where against it [-].
        lean: Angle of the hatching [rad].
    """
    teeth, way = face_teeth(sizing, gear), _face_way(sizing, gear, hub)
    inner, outer = teeth.reach
    tooth = [complex(teeth.root, inner), complex(-teeth.tip, inner), complex(-teeth.tip, outer),
             complex(teeth.root, outer)]  # fmt: skip
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        below = [_placed(corner, toward, side) for corner in (tooth[0], tooth[3], *way)]
        entities += [hatched(axis, below, lean), line(axis, [_placed(corner, toward, side) for corner in tooth])]
        entities.append(line(axis, below, closed=True))
        more = 2.0 / axis.scale
        ends = [_placed(complex(0.0, radius), toward, side) for radius in (inner - more, outer + more)]
        entities.append(line(axis, ends, Layer.PITCH))
    return entities


def _placed(corner: complex, toward: float, side: float) -> complex:
    return complex(-toward * corner.real, side * corner.imag)


def _face_way(sizing: Sizing, gear: GearSizing, hub: Hub) -> list[complex]:
    """Return the way behind the teeth from their outside to their inside, with the bore that is drawn [mm]."""
    teeth, bore = face_teeth(sizing, gear), made_of(sizing).blanks[gear.name].bore_radius
    points = face_way(teeth.pinion, gear.teeth, width=pinion_of(sizing, gear).face_width, bore=bore)
    inner = min(radius for _, radius in points)
    return [complex(MM * z, hub.bore / 2.0 if radius == inner else MM * radius) for z, radius in points]


def face_view(sizing: Sizing, gear: GearSizing, hub: Hub, axis: SheetAxis) -> list[Entity]:
    """Return the wheel of a face-gear pair in section with its dimensions.

    Args:
        sizing: What was sized.
        gear: The wheel.
        hub: Its bore.
        axis: On paper.
    """
    teeth, way = face_teeth(sizing, gear), _face_way(sizing, gear, hub)
    inner, outer = teeth.reach
    bored = [corner.real for corner in way if corner.imag <= hub.bore / 2.0]
    ends = (min(-teeth.tip, *(corner.real for corner in way)), max(corner.real for corner in way))
    beyond = OVERSHOOT / axis.scale
    entities: list[Entity] = [Path((axis.at(ends[0] - beyond), axis.at(ends[1] + beyond)), Layer.CENTRE)]
    entities += face_section(sizing, gear, hub, axis, toward=-1.0, lean=LEAN)
    entities += bore_edges(axis, (min(bored), max(bored)), hub)
    right, left = axis.at(ends[1]).real + ASIDE, axis.at(ends[0]).real - ASIDE
    back, front = way[0], way[-1]
    radii = sorted({corner.imag for corner in way if hub.bore / 2.0 < corner.imag < inner})
    across = [(max(bored), hub.bore / 2.0)] if hub.bore else []
    across += [(max(corner.real for corner in way if corner.imag == radius), radius) for radius in radii[:1]]
    across.append((back.real, outer))
    for row, (x, radius) in enumerate(across):
        suffix = f" {hub.tolerance}" if hub.tolerance and row == 0 else ""
        entities.append(_across(axis, x, radius, right + STEP * row, suffix))
    entities.append(_across(axis, -teeth.tip, inner, left, ""))
    if hub.bore:
        entities += datum(complex(right, axis.at(0.0, -hub.bore / 2.0).imag), -1j, "A")
        face = axis.at(back.real, -0.9 * outer)
        entities += runout_beside(face, max(right + STEP * len(across), face.real + ASIDE), outer)
    flat = [corner.real for corner in way if radii and corner.imag == radii[0]]
    if radii and min(flat) < front.real:
        entities += thickness(axis, (front.real, back.real), (radii[0], inner))
    entities += _lengths(axis, teeth, (back.real, *((min(bored), max(bored)) if hub.bore else ())))
    return entities


def _across(axis: SheetAxis, x: float, radius: float, at: float, suffix: str) -> Distance:
    low, high = axis.at(x, -radius), axis.at(x, radius)
    return Distance(low, high, complex(at, 0.0), math.pi / 2.0, axis.scale, "Ø", suffix)


def _lengths(axis: SheetAxis, teeth: FaceTeeth, backs: tuple[float, ...]) -> Iterator[Entity]:
    """Yield how far tips and backs lie from the plane of the pitch circle, which the assembly distance is to."""
    inner, outer = teeth.reach
    plane, level = axis.at(0.0, -outer), axis.at(0.0, -outer).imag - ASIDE
    yield Distance(axis.at(-teeth.tip, -outer), axis.at(backs[0], -outer), complex(0.0, level), 0.0, axis.scale)
    for row, back in enumerate(sorted(set(backs)), 1):
        foot = axis.at(back, -outer if back == backs[0] else -inner)
        yield Distance(plane, foot, complex(0.0, level - STEP * row), 0.0, axis.scale)
