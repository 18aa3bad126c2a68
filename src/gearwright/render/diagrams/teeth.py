"""What pairs of gears and their teeth are measured by."""

from __future__ import annotations

import cmath
import math

from gearwright.parts.gears import CylindricalGear
from gearwright.render.diagrams.strokes import (
    DEGREE,
    across,
    along,
    axis,
    box,
    cross,
    leader,
    line,
    note,
    swept,
    toothed,
    up,
)
from gearwright.render.drawings.sheet.entities import Arc, Entity, Hatch, Layer, Path


def pair() -> list[Entity]:
    """A cylindrical pair along its axes, with its bores, and from the side, with the helix on the pitch cylinder."""
    pinion, wheel = (CylindricalGear(teeth, 2.5, 1.0) for teeth in (17, 29))
    distance = pinion.pitch_radius + wheel.pitch_radius
    entities: list[Entity] = []
    for gear, middle, turn in ((pinion, 0j, 0.0), (wheel, complex(distance), math.pi + math.pi / 29.0)):
        entities += [*toothed(gear, middle, turn), Arc(middle, 7.0, Layer.OUTLINE), *cross(middle, gear.tip_radius)]
    entities.append(across(0j, complex(distance), -48.0, "centre_distance_mm"))
    entities += leader(cmath.rect(7.0, 145.0 * DEGREE), complex(-28.0, 24.0), "pinion_bore_mm")
    entities += leader(distance + cmath.rect(7.0, 45.0 * DEGREE), complex(distance + 44.0, 48.0), "wheel_bore_mm")
    entities += [note(complex(0.0, 32.0), "pinion"), note(complex(distance, 46.0), "wheel")]
    start, end, radius = 112.0, 148.0, wheel.tip_radius
    middle = (start + end) / 2.0
    entities += [*box(complex(start, -radius), complex(end, radius)), axis(complex(start), complex(end))]
    slope = 18.0 * math.tan(20.0 * DEGREE)
    for k in range(-3, 4):
        entities.append(line(complex(start, 8.0 * k - slope), complex(end, 8.0 * k + slope), layer=Layer.THIN))
    entities += swept(complex(middle), (0.0, 20.0 * DEGREE), 28.0, complex(end + 18.0, 16.0), "helix_angle_deg")
    entities.append(across(complex(start, -radius), complex(end, -radius), -48.0, "face_width_mm"))
    return entities


def _rack(pitch: float, count: int, heights: tuple[float, float], slope: float) -> list[complex]:
    """Return the profile of a rack whose first tooth has its middle at x = 0; at y = 0 a tooth is half a pitch."""
    return [
        complex(tooth * pitch + sign * (pitch / 4.0 - slope * y), y)
        for tooth in range(count)
        for sign in (-1.0, 1.0)
        for y in (heights if sign < 0.0 else heights[::-1])
    ]


def teeth() -> list[Entity]:
    """Teeth in a normal section: pitch, pressure angle, relief, roughness and thickness."""
    module, slope = 12.0, math.tan(20.0 * DEGREE)
    pitch, low, high = math.pi * module, -1.25 * module, module
    left, right = complex(-0.5 * pitch, low), complex(2.5 * pitch, low)
    body = (left, *_rack(pitch, 3, (low, high), slope), right)
    entities: list[Entity] = [
        Hatch((*body, right - 8.0j, left - 8.0j)), Path(body, Layer.OUTLINE),
        Path((left - 1j * low, right - 1j * low), Layer.PITCH),
    ]  # fmt: skip
    flank = complex(-pitch / 4.0)
    entities.append(across(flank, flank + pitch, 30.0, "π · module_mm"))
    foot = complex(pitch / 4.0)
    entities += swept(foot, (90.0 * DEGREE, 110.0 * DEGREE), 17.0, complex(-26.0, 20.0), "pressure_angle_deg")
    relieved = complex(pitch + pitch / 4.0 - slope * high, high)
    entities += [line(relieved + complex(slope * 8.0, -8.0), relieved - 2.6, layer=Layer.THIN)]
    entities += leader(relieved - 1.0, relieved + complex(9.0, 9.0), "tip_relief_mm ± tip_relief_tolerance_mm")
    thick = complex(2.0 * pitch + pitch / 4.0)
    entities += [line(*(thick + complex(2.6 - slope * y, y) for y in (low, high)), layer=Layer.HIDDEN)]
    normal = cmath.rect(2.44, 20.0 * DEGREE)
    entities += leader(thick + normal, thick + complex(16.0, 8.0), "tooth_thickness_mm")
    rough = complex(2.0 * pitch - pitch / 4.0 + slope * 5.0, -5.0)
    entities += leader(rough, complex(2.0 * pitch + 20.0, -32.0), "flank_roughness_mm, roughness_mm")
    root = complex(pitch / 2.0 - 2.0, low)
    entities += leader(root, complex(pitch / 2.0 - 12.0, -32.0), "root_roughness_mm")
    return entities


def mesh() -> list[Entity]:
    """A tooth in the gap of its mate: the play along the line of action, at the flanks that do not touch."""
    module, slope, play = 14.0, math.tan(20.0 * DEGREE), 4.0
    pitch, low, high = math.pi * module, -1.25 * module, module
    below = (complex(-1.05 * pitch, low), *_rack(pitch, 2, (low, high), slope), complex(1.6 * pitch, low))
    below = tuple(point - pitch / 2.0 for point in below)
    half = pitch / 4.0 - play / 2.0 / math.cos(20.0 * DEGREE)
    shift = complex(-play / 2.0 / math.cos(20.0 * DEGREE))
    above = tuple(
        shift + complex(sign * (half + slope * y), y)
        for sign, y in ((-1.0, 15.0), (-1.0, -high), (1.0, -high), (1.0, 15.0))
    )
    normal = cmath.rect(play, -20.0 * DEGREE)
    gap = above[2] + (above[3] - above[2]) * 0.55
    entities: list[Entity] = [
        Hatch((*below, below[-1] - 7.0j, below[0] - 7.0j)), Path(below, Layer.OUTLINE),
        Hatch((*above, above[-1] + 5.0j, above[0] + 5.0j), angle=-math.pi / 4.0), Path(above, Layer.OUTLINE),
        Path((complex(-52.0), complex(52.0)), Layer.PITCH),
        along(gap, gap + normal, 0.0, ""),
        *leader(gap + 0.5 * normal, complex(44.0, 14.0), "backlash_mm"),
    ]  # fmt: skip
    return [*entities, note(complex(0.0, 24.0), "tooth of the driven gear"), note(complex(0.0, -33.0), "driving gear")]


def bevel() -> list[Entity]:
    """A bevel pair through its axes, and the crown wheel of its teeth from above."""
    angle, inner, outer = math.atan(20.0 / 31.0), 46.0, 72.0
    entities = [*_cone(angle, 0.0, (inner, outer)), *_cone(math.pi / 2.0 - angle, -math.pi / 2.0, (inner, outer))]
    entities += [axis(0j, complex(84.0)), axis(0j, complex(0.0, -66.0))]
    entities += swept(0j, (-math.pi / 2.0, 0.0), 26.0, complex(-8.0, -13.0), "axis_angle_deg")
    near, far = (cmath.rect(reach, angle) for reach in (inner, outer))
    entities += [along(near, far, 13.0, "face_width_mm")]
    heel = cmath.rect(outer, angle)
    entities += up(heel.conjugate(), heel, 94.0, "z_{1} · outer_module_mm")
    return [*entities, *_crown(complex(190.0, -86.0))]


def _cone(angle: float, turn: float, cones: tuple[float, float]) -> list[Entity]:
    """Return a bevel gear in section: its teeth, its body and its pitch cone."""
    ahead = cmath.rect(1.0, turn)
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        ray = cmath.rect(1.0, side * angle)
        out = ray * 1j * side
        tips, roots = ([cone * ray + out * height * cone / cones[1] for cone in cones] for height in (4.5, -5.6))
        body = [*roots, complex(roots[1].real + 3.0, side * 8.0), complex(roots[0].real, side * 8.0)]
        teeth = [tips[0], tips[1], roots[1], roots[0]]
        entities += [
            Hatch(tuple(ahead * point for point in body), side * math.pi / 4.0),
            line(*(ahead * point for point in body), closed=True),
            line(*(ahead * point for point in teeth), closed=True),
            line(0j, ahead * (cones[1] + 6.0) * ray, layer=Layer.PITCH),
        ]
    return entities


def _crown(centre: complex) -> list[Entity]:
    """Return a part of the crown wheel: spiral teeth, cut by a circle of blades."""
    inner, outer, radius, spiral = 58.0, 88.0, 62.0, 35.0 * DEGREE
    mean = (inner + outer) / 2.0
    span = (72.0 * DEGREE, 122.0 * DEGREE)
    entities: list[Entity] = [Arc(centre, reach, Layer.OUTLINE, *span) for reach in (inner, outer)]
    entities += [line(*(centre + cmath.rect(reach, end) for reach in (inner, outer))) for end in span]
    tangent = cmath.rect(1.0, math.pi / 2.0 - spiral)
    cutter = 1j * mean - radius * 1j * tangent
    arc = [cutter + cmath.rect(radius, cmath.phase(1j * tangent) + k * DEGREE) for k in range(-40, 41)]
    inside = [point for point in arc if inner <= abs(point) <= outer]
    for tooth in range(-2, 4):
        entities.append(
            Path(tuple(centre + cmath.rect(1.0, 7.0 * tooth * DEGREE) * point for point in inside), Layer.THIN)
        )
    middle = centre + 1j * mean
    entities += [line(middle - 25.0j, middle + 33.0j, layer=Layer.CENTRE)]
    rays = (math.pi / 2.0 - spiral, math.pi / 2.0)
    entities += swept(middle, rays, 28.0, middle + complex(24.0, 36.0), "spiral_angle_deg")
    entities += [*cross(centre + cutter, 3.0), along(middle, centre + cutter, 0.0, "cutter_radius_mm")]
    return entities
