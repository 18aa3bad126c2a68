"""Teeth of a bevel gear by Tredgold's virtual gear, the body behind them, and what both fill.

A gear stands with its axis along z, away from its mate: the mean point of its face at z = 0, tips towards −z.
"""

from __future__ import annotations

import math

from gearwright.arrays import Floats
from gearwright.parts.bevel.geometry import BevelPair
from gearwright.parts.gears import (
    BasicRack,
    SeatHub,
    TransverseTooth,
    dishes_behind,
    outline_area,
    revolved_volume,
    transverse_form,
    way_behind,
)

RIM = 1.2
"""Metal behind the roots over the depth of the teeth [-] (AGMA 2001-D04, backup ratio without loss of strength)."""
WEB = 0.3
"""Web over face width [-], an assumption where no web is sized."""
_THINNEST, _WHOLE, _HALVINGS = 0.15, 2.0, 24
"""Webs over face widths between which one is looked for, and how often their distance is halved [-]."""


def virtual_tooth(pair: BevelPair, side: int) -> TransverseTooth:
    """Return the tooth of the virtual cylindrical gear at the mean cone.

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.

    Source: Tredgold's virtual gear z/cos δ of the back cone.
    """
    tooth, shift = pair.tooth, pair.tooth.profile_shift * (1.0 if side == 0 else -1.0)
    rack = BasicRack(pair.pressure_angle, tooth.addendum, tooth.dedendum, tooth.edge_radii[side])
    teeth = pair.teeth[side] / math.cos(pair.pitch_angles[side])
    return TransverseTooth(teeth, pair.mean_module, pair.spiral_angle, shift, rack=rack)


def bevel_form(pair: BevelPair, side: int, *, fillet: int, flank: int) -> tuple[Floats, Floats]:
    """Return one side of a tooth of the virtual cylindrical gear at the mean cone.

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        fillet: Points on the fillet [-].
        flank: Points on the flank [-].

    Returns:
        Radii [m] and half angles [rad] from root to tip.

    Source: as `virtual_tooth` and `gearwright.parts.gears.transverse_form`.
    """
    return transverse_form(virtual_tooth(pair, side), fillet=fillet, flank=flank)


def bevel_way(
    pair: BevelPair, side: int, bore: float, web: float = WEB, seat: SeatHub | None = None, *, dish: float = 0.0
) -> list[tuple[float, float]]:
    """Return the way behind the teeth from the large end to the small one, z and radius [m].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate between rim and hub over the face width [-].
        seat: The hub where its seat is sized.
        dish: By how much the plate leans away from the apex towards the hub [-].

    Source: cones about the apex, ISO 23509:2016; rim 1.2 times the depth of the teeth behind the roots (AGMA 2001-D04).
    """
    toe, heel = _rim(pair, side)
    return way_behind(toe, heel, bore, web=web * pair.face_width, seat=seat, dish=dish)


def bevel_dishes(
    pair: BevelPair, side: int, bore: float, web: float, seat: SeatHub | None
) -> tuple[float, float] | None:
    """Return the least and the largest dish with which the plate meets rim and hub with all of its thickness [-].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate between rim and hub over the face width [-].
        seat: The hub where its seat is sized.

    Returns:
        None where rim and hub meet, so that there is no plate.

    Source: as `bevel_way`.
    """
    toe, heel = _rim(pair, side)
    return dishes_behind(toe, heel, bore, web=web * pair.face_width, seat=seat)


def _rim(pair: BevelPair, side: int) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return where the rim ends under the inner and the outer end of the teeth, z and radius [m]."""
    tooth, mean = virtual_tooth(pair, side), pair.mean_cone_distance
    back = tooth.root_radius - RIM * (tooth.tip_radius - tooth.root_radius) - tooth.pitch_radius
    inner, outer = (_under(pair, side, far, back * far / mean) for far in _ends(pair))
    return inner, outer


def bevel_volume(
    pair: BevelPair, side: int, bore: float, web: float = WEB, seat: SeatHub | None = None, *, dish: float = 0.0
) -> float:
    """Return what a bevel gear fills: its teeth, and the body under their roots [m³].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate between rim and hub over the face width [-].
        seat: The hub where its seat is sized.
        dish: By how much the plate leans away from the apex towards the hub [-].

    Source: teeth that taper to the apex are a pyramid's frustum, V = z A (R_e³ − R_i³)/(3 R_m²), as every point of a
        back cone is R from the apex along its normal; frusta of cones behind them.
    """
    tooth, mean, (inner, outer) = virtual_tooth(pair, side), pair.mean_cone_distance, _ends(pair)
    crown = pair.teeth[side] * outline_area(tooth) * (outer**3 - inner**3) / (3.0 * mean**2)
    root = (tooth.root_radius - tooth.pitch_radius) / mean
    roots = [_under(pair, side, far, root * far) for far in (inner, outer)]
    return crown + revolved_volume([*bevel_way(pair, side, bore, web, seat, dish=dish), *roots])


def lightened_web(pair: BevelPair, side: int, bore: float, share: float, seat: SeatHub | None = None) -> float:
    """Return the web, over the face width, with which a gear fills a share of what it fills without a web [-].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        bore: Radius of what the gear sits on [m].
        share: Of the volume with a plate as thick as the rim is long [-]; the nearest that a web gives.
        seat: The hub where its seat is sized.

    Source: `bevel_volume` by bisection, of a straight web, which a dished one weighs as much as but for its ends.
    """
    low, high = _THINNEST, _WHOLE
    target = share * bevel_volume(pair, side, bore, high, seat)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if bevel_volume(pair, side, bore, middle, seat) > target else (middle, high)
    return 0.5 * (low + high)


def _ends(pair: BevelPair) -> tuple[float, float]:
    """Return the cone distances of both ends of the face [m]."""
    return pair.mean_cone_distance - pair.face_width / 2.0, pair.mean_cone_distance + pair.face_width / 2.0


def _under(pair: BevelPair, side: int, far: float, height: float) -> tuple[float, float]:
    """Return z and radius of a point on a back cone, so high above the pitch cone."""
    cone = pair.pitch_angles[side]
    along = (far - pair.mean_cone_distance) * math.cos(cone) - height * math.sin(cone)
    return along, far * math.sin(cone) + height * math.cos(cone)
