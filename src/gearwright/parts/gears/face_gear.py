"""The wheel of a face gear: teeth as racks in cylinders about its axis, and the body behind them.

It stands with its axis along z, away from its pinion: the pitch plane at z = 0, tips towards −z. In every cylinder
about its axis its teeth are those of the rack that the unrolled pinion meshes with there; the curvature of the wheel's
motion within the width of a tooth is left out.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.base import DesignError, Problem
from gearwright.parts.gears.tooth_form import TransverseTooth

RIM = 1.2
"""Metal behind the roots over the depth of the teeth [-] (AGMA 2001-D04, backup ratio without loss of strength)."""
HUB = 1.25
"""Hub over bore [-], an assumption."""
NEXT = 0.98
"""Hub over the radius inside the rim, at most [-]."""
_STRIPS = 65
"""Cylinders in which teeth are weighed [-]."""


def face_reach(pinion: TransverseTooth, teeth: int, width: float) -> tuple[float, float]:
    """Return the radii between which teeth of a face gear are whole [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle [m].

    Source: Litvin and Fuentes 2004, chapter 18: inside R_b = r_b z_2/z_1 the shaper undercuts, outside teeth are
        pointed where their tops meet.
    """
    ratio, pitch = teeth / pinion.teeth, pinion.pitch_radius * teeth / pinion.teeth
    inner = max(pitch - width / 2.0, 1.002 * pinion.base_radius * ratio)
    return inner, min(pitch + width / 2.0, pointed_radius(pinion, teeth))


def face_way(pinion: TransverseTooth, teeth: int, *, width: float, bore: float) -> list[tuple[float, float]]:
    """Return the way behind the teeth of a face gear from its outside to its inside, z and radius [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle [m].
        bore: Radius of what it sits on [m].

    Source: rim 1.2 times the depth of the teeth behind the roots (AGMA 2001-D04).
    """
    inner, outer = face_reach(pinion, teeth, width)
    root = pinion.rack.dedendum * pinion.module
    rim = RIM * (root + pinion.rack.addendum * pinion.module)
    return way_behind((root + 0.4 * rim, inner), (root + rim, outer), bore, web=0.6 * rim)


def face_crown(pinion: TransverseTooth, teeth: int, width: float) -> float:
    """Return the volume of the teeth of a face gear, from their roots to their tips [m³].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle [m].

    Source: trapezia in cylinders about the axis, summed over their radii.
    """
    radii = np.linspace(*face_reach(pinion, teeth, width), _STRIPS)
    depth = (pinion.rack.addendum + pinion.rack.dedendum) * pinion.module
    areas = np.array([depth * sum(face_thickness(pinion, teeth, float(radius))) for radius in radii])
    return teeth * float(np.sum(0.5 * (areas[1:] + areas[:-1]) * np.diff(radii)))


def pointed_radius(pinion: TransverseTooth, teeth: int) -> float:
    """Return where the teeth of a face gear become pointed, a tenth of a module of top left [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].

    Source: as `face_reach`.
    """
    pitch = pinion.pitch_radius * teeth / pinion.teeth
    radii = np.linspace(pinion.base_radius * teeth / pinion.teeth * 1.001, 1.5 * pitch, 400)
    top = np.array([face_thickness(pinion, teeth, float(radius))[0] for radius in radii])
    return float(radii[np.nonzero(top > 0.05 * pinion.module)[0].max()])


def face_thickness(pinion: TransverseTooth, teeth: int, radius: float) -> tuple[float, float]:
    """Return half the thickness of a face gear's tooth at its top and at its root [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        radius: Of the cylinder in which it is cut [m].

    Source: Litvin and Fuentes 2004, chapter 18, in sections: cos α(R) = R_b/R.
    """
    roll = radius * pinion.teeth / teeth
    angle = math.acos(min(1.0, pinion.base_radius / roll))
    half = (math.pi / pinion.teeth - float(pinion.half_angles(np.asarray(roll)))) * roll
    rack, middle = pinion.rack, pinion.pitch_radius
    top, root = middle - rack.addendum * pinion.module, middle + rack.dedendum * pinion.module
    most = 0.98 * math.pi * roll / pinion.teeth
    return half + (top - roll) * math.tan(angle), min(half + (root - roll) * math.tan(angle), most)


class SeatHub(NamedTuple):
    """A hub over its seat, from the middle of the face away from the mate [m]."""

    low: float
    """Where it begins."""
    high: float
    """Where it ends."""
    radius: float
    """Outside; at most what the rim leaves."""


def _under_rim(
    toe: tuple[float, float], heel: tuple[float, float], upper: float, dish: float
) -> tuple[float, tuple[float, float]]:
    """Return which share of a rim a plate takes, and where its back meets it, z and radius [m]."""
    long = heel[0] - toe[0]
    if long == 0.0:
        return 1.0, (upper, heel[1])
    # On the rim z = upper − dish (r − r_toe), with r − r_toe in proportion to z − z_toe.
    share = min((upper - toe[0]) / long / (1.0 + dish * (heel[1] - toe[1]) / long), 1.0)
    return share, (toe[0] + share * long, toe[1] + share * (heel[1] - toe[1]))


def dishes_behind(
    toe: tuple[float, float],
    heel: tuple[float, float],
    bore: float,
    *,
    web: float,
    seat: SeatHub | None = None,
) -> tuple[float, float] | None:
    """Return the least and the largest dish with which a plate meets rim and hub with all of its thickness [-].

    Args:
        toe: Where the rim ends under the inner end of the teeth, z and radius [m].
        heel: The same under the outer end [m].
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate [m].
        seat: The hub where its seat is sized; None: about the plate, in proportion to the bore.

    Returns:
        None where rim and hub meet, so that there is no plate.

    Source: geometry: along the hub the plate moves by dish times its height; its back leaves the rim at the heel
        where it leans back by what the rim is longer along z over what the rim rises.
    """
    bore, hub = _hub(toe, bore, seat)
    if hub is None or hub >= toe[1]:
        return None
    upper = min(toe[0] + web, heel[0])
    low, high = _along(toe[0], upper, bore, hub, seat)
    height, rise = toe[1] - hub, heel[1] - toe[1]
    least = (low - toe[0]) / height
    return max(least, (upper - heel[0]) / rise) if rise > 0.0 else least, (high - upper) / height


def _hub(toe: tuple[float, float], bore: float, seat: SeatHub | None) -> tuple[float, float | None]:
    """Return the radii of bore and hub [m]; no hub where it meets the rim, or the gear has no bore."""
    bore = min(bore, 0.85 * toe[1])
    hub = HUB * bore if seat is None else max(min(seat.radius, NEXT * toe[1]), bore)
    return bore, None if (seat is None and hub > 0.8 * toe[1]) or bore <= 0.0 else hub


def _along(low: float, high: float, bore: float, hub: float, seat: SeatHub | None) -> tuple[float, float]:
    """Return the ends of a hub about a plate from low to high, or of the seat that is sized [m]."""
    if seat is not None:
        return seat.low, seat.high
    middle, half = (low + high) / 2.0, max(1.6 * (high - low), 1.2 * (hub - bore)) / 2.0
    return middle - half, middle + half


def way_behind(
    toe: tuple[float, float],
    heel: tuple[float, float],
    bore: float,
    *,
    web: float,
    seat: SeatHub | None = None,
    dish: float = 0.0,
) -> list[tuple[float, float]]:
    """Return the way behind teeth on a cone or a face from heel to toe: a rim, a plate, a hub about the bore.

    Args:
        toe: Where the rim ends under the inner end of the teeth, z and radius [m].
        heel: The same under the outer end [m].
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate [m].
        seat: The hub where its seat is sized; None: about the plate, in proportion to the bore.
        dish: By how much the plate leans along z towards the hub [-]; its thickness along z is kept.

    Returns:
        One that goes straight to the bore where rim and hub meet, or the gear has no bore.

    Raises:
        DesignError: A plate that leans so far that it does not meet rim and hub with all of its thickness; with how
            far it may.

    Source: geometry.
    """
    limits = dishes_behind(toe, heel, bore, web=web, seat=seat) if dish else None
    if limits is not None and not limits[0] <= dish <= limits[1]:
        raise DesignError([Problem("dish", f"{dish:g} given; must be from {limits[0]:.4g} to {limits[1]:.4g}")])
    bore, hub = _hub(toe, bore, seat)
    if hub is None:
        return [heel, (heel[0], bore), (toe[0], bore), toe]
    upper = min(toe[0] + web, heel[0])
    share, under = _under_rim(toe, heel, upper, dish)
    low, high = _along(toe[0], upper, bore, hub, seat)
    way = [heel] + ([under] if share < 1.0 else [])
    lean = dish * (toe[1] - hub)
    back, front = upper + lean, toe[0] + lean
    return [*way, (back, hub), (high, hub), (high, bore), (low, bore), (low, hub), (front, hub), toe]
