"""Propeller performance by blade-element momentum theory, feathering, and loads at incidence.

Charts and maps themselves are read beside this room; what a file says of a blade is read by the catalogue.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.machines.propeller_charts import Blades, PropellerMap

# ----------------------------------------------------------------------------------------------------------------------
# Lift and drag of a propeller's section at every angle of attack, with camber, thickness and Mach number.
# ----------------------------------------------------------------------------------------------------------------------


LIFT_SLOPE = 0.8147 * 2.0 * math.pi
"""Of a section on a turning blade, part of a thin aerofoil's [1/rad]; fitted to the charts, see the theory page."""
CAMBER_EFFECT = 0.7988
"""Part of its design lift that a section has at no incidence [-]; fitted."""
MOST_LIFT, LEAST_LIFT, CAMBER_STALL = 1.3669, -0.6792, 0.3
"""Lift coefficients of a symmetric section at its stalls, and what a unit of design lift adds to both [-]; fitted."""
STALL_WIDTHS = (0.0070, 0.0369)
"""Angle over which attached flow parts, at the upper and the lower stall [rad]; fitted."""
PLATE_DRAG = 1.25
"""Drag coefficient of a blade across the stream [-]: Viterna's 1.11 + 0.018 A for an aspect ratio A of 8."""
FRICTION = 0.0033
"""Coefficient of skin friction [-]; fitted."""
POLAR = (0.1939, 0.3691)
"""Drag per square of the lift beyond the bucket of least drag, above it and below [-]; fitted."""
LEAST_DRAG = 0.8725
"""Part of its design lift in the middle of that bucket [-]; fitted."""
BUCKET = 0.1480
"""Half the width of the bucket of least drag, as a lift coefficient [-]; fitted."""
PARTED_DRAG = 0.0052
"""Drag that parted flow adds to that of the plate [-]; fitted."""
HIGHEST_MACH = 0.80
"""Where the Prandtl-Glauert factor is held [-]."""
KORN = 0.87
"""Technology factor of Korn's drag divergence, for sections of NACA's 6 series [-]."""
SHEAR_RISE = 20.0
"""Lock's factor of the drag rise [-]."""
_FARTHEST = 60.0
"""Stall widths beyond which flow has parted wholly [-]."""


class SectionLoads(NamedTuple):
    """What the air does to a section."""

    lift: Floats
    """c_l [-]."""
    drag: Floats
    """c_d [-]."""


def section_loads(angle: Floats, design_lift: Floats, thickness: Floats, mach: Floats) -> SectionLoads:
    """Return lift and drag of propeller sections from −180° to 180°.

    Args:
        angle: Of attack, from the chord [rad].
        design_lift: Lift coefficient that the camber is made for [-].
        thickness: Over chord [-].
        mach: Of the section's stream [-].

    Source: attached: a straight lift curve with Prandtl-Glauert, friction and form after Hoerner (1965), 2 c_f
        (1 + 2 t/c + 60 (t/c)⁴), drag rise 20 (M − M_crit)⁴ after Lock with Korn's divergence; parted: Viterna and
        Corrigan (1982), NASA CP-2230. The constants called fitted are fitted to the charts of NASA CR-114399.

    Valid for: blades of several metres.
    """
    squeeze = 1.0 / np.sqrt(1.0 - np.minimum(mach, HIGHEST_MACH) ** 2)
    free = LIFT_SLOPE * np.sin(angle) + CAMBER_EFFECT * design_lift
    upper, lower = (stall + CAMBER_STALL * design_lift for stall in (MOST_LIFT, LEAST_LIFT))
    above, below = (
        (lift / squeeze - CAMBER_EFFECT * design_lift) / LIFT_SLOPE for lift in (upper, lower)
    )  # angles of the stalls
    beyond = np.exp(np.minimum((angle - above) / STALL_WIDTHS[0], _FARTHEST))
    short = np.exp(np.minimum((below - angle) / STALL_WIDTHS[1], _FARTHEST))
    attached = 1.0 / (1.0 + beyond + short)
    parted = beyond * _parted_lift(angle, above, upper) - short * _parted_lift(-angle, -below, -lower)
    offset = free - LEAST_DRAG * design_lift
    distance = np.maximum(np.abs(offset) - BUCKET, 0.0)
    profile = 2.0 * FRICTION * (1.0 + 2.0 * thickness + 60.0 * thickness**4)
    profile = profile + np.where(offset > 0.0, *POLAR) * distance**2 + _drag_rise(squeeze * free, thickness, mach)
    plate = PARTED_DRAG + PLATE_DRAG * np.sin(angle) ** 2
    return SectionLoads(
        lift=attached * (squeeze * free + parted),
        drag=attached * profile + attached * (beyond + short) * plate,
    )


def _parted_lift(angle: Floats, stall: Floats, lift: Floats) -> Floats:
    """Return Viterna's lift beyond a stall; the term that joins it to the stall ends at 90°."""
    share = (lift - PLATE_DRAG * np.sin(stall) * np.cos(stall)) * np.sin(stall) / np.cos(stall) ** 2
    along, across = np.maximum(np.cos(angle), 0.0), np.maximum(np.sin(angle), 0.5 * np.sin(stall))
    return np.asarray(0.5 * PLATE_DRAG * np.sin(2.0 * angle) + share * along**2 / across)


def _drag_rise(lift: Floats, thickness: Floats, mach: Floats) -> Floats:
    """Return 20 (M − M_crit)⁴ with M_crit = κ − t/c − |c_l|/10 − (0.1/80)^(1/3)."""
    critical = KORN - thickness - np.abs(lift) / 10.0 - (0.1 / 80.0) ** (1.0 / 3.0)
    return np.asarray(SHEAR_RISE * np.maximum(mach - critical, 0.0) ** 4)


# ----------------------------------------------------------------------------------------------------------------------
# The shape of a propeller's blades, as given or made for an activity factor and a design lift.
# ----------------------------------------------------------------------------------------------------------------------


Polar = Callable[[Floats, Floats, Floats, Floats], SectionLoads]

REFERENCE = 0.75
"""Radius ratio at which a blade angle is told [-]."""
HUB = 0.18
"""Radius ratio at which a generic blade begins [-]; an assumption."""
ELEMENTS = 24
"""Elements of a generic blade."""
TWIST_RATIO = 2.3650
"""Advance ratio whose helix a generic blade's twist follows [-]; fitted to the charts, see theory page."""
UNTWIST = 0.0982
"""Angle by which the tip is coarser than that helix says, per radius [rad]; fitted."""

WIDEST = 0.7336
"""Radius ratio at which a generic blade is widest [-]; fitted."""


class BladeShape(NamedTuple):
    """The blades of a propeller, element by element from the hub out."""

    number: int
    """Number of blades [-]."""
    radius: Floats
    """Middle of the elements over the tip radius [-]."""
    width: Floats
    """Of the elements over the tip radius [-]."""
    chord: Floats
    """Over the tip radius [-]."""
    twist: Floats
    """Blade angle less that at three quarters of the radius [rad]."""
    design_lift: Floats
    """Design lift coefficient of the sections [-]."""
    thickness: Floats
    """Over chord [-]."""
    hub: float = HUB
    """Radius ratio at which the blades begin [-]."""
    polar: Polar = section_loads
    """Lift and drag of the sections over angle [rad], design lift, thickness and Mach number."""
    losses: bool = True
    """Whether tip and hub lose lift (Prandtl)."""


def generic_blade(blades: Blades) -> BladeShape:
    """Return blades that nobody measured, with an activity factor and a design lift.

    Args:
        blades: Number, activity factor, design lift.

    Source: stated here: from 0.18 R, a chord that is widest at 0.73 R and rounds to the tip, scaled to the activity
        factor; twist of a helix of advance ratio 2.4, less 0.10 rad a radius; design lift constant along the blade;
        thickness ratio from 0.24 at the hub to 0.05 at the tip.
    """
    edges = np.linspace(HUB, 1.0, ELEMENTS + 1)
    radius, width = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    outline = np.sqrt(1.0 - np.clip((radius - WIDEST) / (1.02 - WIDEST), -0.8, 1.0) ** 2)
    shape = BladeShape(
        number=blades.number,
        radius=radius,
        width=width,
        chord=outline,
        twist=np.arctan(TWIST_RATIO / (math.pi * radius))
        - math.atan(TWIST_RATIO / (math.pi * REFERENCE))
        + UNTWIST * (radius - REFERENCE),
        design_lift=np.full(ELEMENTS, blades.design_lift / (1.0 - HUB**4)),
        thickness=0.05 + 0.19 * ((1.0 - radius) / (1.0 - HUB)) ** 2,
    )
    return shape._replace(chord=outline * blades.activity_factor / activity_factor(shape))


def activity_factor(shape: BladeShape) -> float:
    """Return the activity factor of one blade, 100 000/16 ∫ (c/D) x³ dx [-].

    Args:
        shape: The blades.

    Source: definition, as in NASA CR-114399.
    """
    return float(1e5 / 16.0 * np.sum(0.5 * shape.chord * shape.radius**3 * shape.width))


def integrated_lift(shape: BladeShape) -> float:
    """Return the integrated design lift coefficient of a blade, 4 ∫ c_l,i x³ dx [-].

    Args:
        shape: The blades.

    Source: definition, as in NASA CR-114399.
    """
    return float(4.0 * np.sum(shape.design_lift * shape.radius**3 * shape.width))


# ----------------------------------------------------------------------------------------------------------------------
# Blade-element momentum: the stream through every element, found by one bracketed residual, in every state.
# ----------------------------------------------------------------------------------------------------------------------


BISECTIONS = 38
"""Halvings of the bracket of 90°: the inflow angle to 6e-12 rad."""
SMALLEST = 1e-7
"""Inflow angle nearest to the disc's plane [rad]."""
TURBULENT = 2.0 / 3.0
"""Load beyond which the stream of a windmill is turbulent, where its induction is 0.4 [-]."""
AT_REST = 2.0
"""Thrust over dynamic pressure and area at which Buhl's stream comes to rest in the disc [-]."""


class Loads(NamedTuple):
    """A propeller at operating points; arrays of their shape."""

    thrust: Floats
    """C_T = T/(ρ n² D⁴) [-]."""
    power: Floats
    """C_P = P/(ρ n³ D⁵) [-]."""
    element_thrust: Floats
    """dC_T/dx of every element, last axis [-]."""
    element_power: Floats
    """dC_P/dx of every element, last axis [-]."""
    inflow_angle: Floats
    """φ of every element, last axis [rad]."""
    axial: Floats
    """Speed added by the disc to the stream at every element, over the tip speed, last axis [-]."""
    swirl: Floats
    """Speed of the swirl in the disc at every element, over the tip speed, last axis [-]."""


class _Stream(NamedTuple):
    """What the elements meet; arrays broadcast to points by elements."""

    shape: BladeShape
    pitch: Floats
    """Angle of every element [rad]."""
    turning: Floats
    """Tangential speed over that of the tip [-]."""
    ratio: Floats
    """λ: axial over tangential speed [-]."""
    mach: Floats
    """Of the tip's rotation [-]."""


class _Balance(NamedTuple):
    residual: Floats
    axial_load: Floats
    """s c_n/sin² φ [-]."""
    swirl_load: Floats
    """s c_t/|sin φ| cos φ [-]."""
    through: Floats
    """Speed through the disc over the free stream's, where that is not zero [-]."""
    normal: Floats
    """c_n [-]."""
    tangential: Floats
    """c_t [-]."""
    factor: Floats
    """Prandtl's F [-]."""


def loads(
    shape: BladeShape, advance_ratio: Floats | float, pitch: Floats | float, tip_mach: Floats | float = 0.0
) -> Loads:
    """Return thrust and power of a propeller at any blade angle: driving, windmilling, braking, reversed.

    Args:
        shape: The blades.
        advance_ratio: J = V/(n D), not negative; 0 is standstill [-].
        pitch: Blade angle at three quarters of the radius [rad].
        tip_mach: Of the tip's rotation; 0 leaves compressibility out [-].

    Source: Ning, Wind Energy 17 (2014) 1327: one residual in the inflow angle, bracketed, so that it always converges;
        tip and hub losses after Prandtl; windmills beyond an induction of 0.4 after Buhl, NREL/TP-500-36834 (2005);
        where the blades throw back more than Buhl's stream at rest bears, momentum with the stream reversed.

    Valid for: axial flow; no swirl upstream, no interference of nacelle and wing.
    """
    ratio, angle, mach = (np.asarray(value, dtype=float)[..., None] for value in (advance_ratio, pitch, tip_mach))
    ratio, angle, mach, _ = np.broadcast_arrays(ratio, angle, mach, shape.radius)
    return loads_in(shape, ratio / math.pi, np.broadcast_to(shape.radius, ratio.shape), pitch=angle, tip_mach=mach)


def loads_in(
    shape: BladeShape, axial: Floats, turning: Floats, *, pitch: Floats | float, tip_mach: Floats | float = 0.0
) -> Loads:
    """Return thrust and power of blades whose elements meet the air at given speeds.

    Args:
        shape: The blades.
        axial: Speed along the axis over that of the tip; points by elements [-].
        turning: Speed along the turn over that of the tip, positive; points by elements [-].
        pitch: Blade angle at three quarters of the radius [rad].
        tip_mach: Of the tip's rotation [-].

    Source: `loads`; every element with the stream that its own load makes.
    """
    axial, turning, angle, mach, _ = np.broadcast_arrays(axial, turning, pitch, tip_mach, shape.radius)
    stream = _Stream(shape, angle + shape.twist, turning, axial / turning, mach)
    return _loads(stream, _inflow(stream))


def _inflow(stream: _Stream) -> Floats:
    """Return the inflow angle of every element by bisection in the state's bracket [rad]."""
    edge = _balance(stream, np.full_like(stream.ratio, SMALLEST))
    thrown_back = AT_REST * edge.factor * -edge.normal * _solidity(stream, edge.factor) > stream.ratio**2
    low = np.where(thrown_back, -math.pi / 2.0, SMALLEST)
    high = np.where(thrown_back, -SMALLEST, math.pi / 2.0)
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        above = _balance(stream, middle).residual > 0.0
        high, low = np.where(above, middle, high), np.where(above, low, middle)
    return 0.5 * (low + high)


def _solidity(stream: _Stream, factor: Floats) -> Floats:
    """s = σ'/(4 F): what a unit of force asks of the stream."""
    shape = stream.shape
    return shape.number * shape.chord / (2.0 * math.pi * shape.radius) / (4.0 * factor)


def _balance(stream: _Stream, inflow: Floats) -> _Balance:
    """Return how far momentum and forces are from each other at an inflow angle."""
    shape, sine, cosine = stream.shape, np.sin(inflow), np.cos(inflow)
    speed = stream.mach * stream.turning * np.hypot(1.0, stream.ratio)
    force = shape.polar(stream.pitch - inflow, shape.design_lift, shape.thickness, speed)
    normal, tangential = force.lift * cosine - force.drag * sine, force.lift * sine + force.drag * cosine
    factor = _loss(shape, np.abs(sine))
    part = _solidity(stream, factor)
    load = part * normal / sine**2
    swirl = part * tangential / (np.abs(sine) * cosine + 1e-300)
    through = _through(load, factor, sine)
    residual = sine * np.abs(sine) * through - stream.ratio * (np.abs(sine) * cosine + part * tangential)
    return _Balance(residual, load, swirl, through, normal, tangential, factor)


def _through(load: Floats, factor: Floats, sine: Floats) -> Floats:
    """Return the free stream's speed over that through the disc; it changes sign where the stream is reversed."""
    calm = np.where(sine > 0.0, 1.0 - load, 1.0 + load)
    turbulent = (sine > 0.0) & (load < -TURBULENT)
    k = 2.0 * factor * np.where(turbulent, -load, 1.0)
    first, second, third = k - (10.0 / 9.0 - factor), k - factor * (4.0 / 3.0 - factor), k - (25.0 / 9.0 - 2.0 * factor)
    third = np.where(np.abs(third) < 1e-9, 1e-9, third)
    slowed = (first - np.sqrt(np.maximum(second, 0.0))) / third
    return np.where(turbulent, 1.0 / np.maximum(1.0 - slowed, 1e-12), calm)


def _loss(shape: BladeShape, sine: Floats) -> Floats:
    """Return Prandtl's factor of tip and hub."""
    if not shape.losses:
        return np.ones(np.broadcast_shapes(sine.shape, shape.radius.shape))
    half, radius = shape.number / 2.0, shape.radius
    tip = np.exp(-half * (1.0 - radius) / (radius * np.maximum(sine, 1e-9)))
    hub = np.exp(-half * (radius - shape.hub) / (shape.hub * np.maximum(sine, 1e-9)))
    return np.maximum((2.0 / math.pi) ** 2 * np.arccos(tip) * np.arccos(hub), 1e-4)


def _loads(stream: _Stream, inflow: Floats) -> Loads:
    """Return the forces at the inflow angles that were found."""
    shape, balance = stream.shape, _balance(stream, inflow)
    sine, cosine, radius = np.sin(inflow), np.cos(inflow), shape.radius
    # Speeds over that of the tip; the stream's square from whichever of its parts is well known.
    turning = stream.turning / (1.0 + balance.swirl_load)
    total = turning / np.maximum(cosine, 1e-12)
    axial = stream.ratio * stream.turning / np.where(np.abs(balance.through) < 1e-12, np.inf, balance.through)
    total = np.where(np.abs(sine) > cosine, np.abs(axial / sine), total)
    scale = shape.number * shape.chord * total**2 * math.pi**2 / 8.0
    thrust, power = scale * balance.normal, scale * balance.tangential * math.pi * radius
    return Loads(
        thrust=np.sum(thrust * shape.width, axis=-1),
        power=np.sum(power * shape.width, axis=-1),
        element_thrust=thrust,
        element_power=power,
        inflow_angle=inflow,
        axial=total * sine - stream.ratio * stream.turning,
        swirl=stream.turning - total * cosine,
    )


# ----------------------------------------------------------------------------------------------------------------------
# A propeller map in every state of the stream: what is charted stays, blade elements carry it on beyond.
# ----------------------------------------------------------------------------------------------------------------------


FADE = math.radians(8.0)
"""Blade angle in which the seam's offset fades by e [rad]; an assumption."""


def element_map(shape: BladeShape, ratios: Floats, angles: Floats, tip_mach: float = 0.0) -> PropellerMap:
    """Return the map of a propeller by its blade elements, full of points.

    Args:
        shape: The blades.
        ratios: J, rising, not negative [-].
        angles: Blade angles at three quarters of the radius, rising [rad].
        tip_mach: Of the tip's rotation; 0 leaves compressibility out [-].

    Source: `loads`.

    Valid for: axial flow.
    """
    found = loads(shape, ratios[:, None], angles[None, :], tip_mach)
    first, last = (np.full(len(ratios), k, dtype=np.int64) for k in (0, len(angles) - 1))
    return PropellerMap(ratios, angles, found.power, found.thrust, first, last)


def continued(chart: PropellerMap, shape: BladeShape, ratios: Floats, angles: Floats) -> PropellerMap:
    """Return a chart's map carried on by blade elements to other advance ratios and blade angles.

    Args:
        chart: The map that stays as it is.
        shape: Blades of the same propeller.
        ratios: J to be in the map beside the chart's; within the chart's range they are left out [-].
        angles: Blade angles to be in the map beside the chart's [rad].

    Source: beyond the chart's first and last blade angle the elements' coefficients, moved by what the two differ by at
        that seam, which fades by e in 8°; beyond its last advance ratio the elements alone. The map is continuous.
    """
    beyond = ratios[ratios > chart.advance_ratio[-1]]
    ratio = np.concatenate([chart.advance_ratio, beyond])
    angle = np.unique(np.round(np.concatenate([chart.blade_angle, angles]), 9))
    full = element_map(shape, ratio, angle)
    place = np.searchsorted(angle, np.round(chart.blade_angle, 9))
    for row in range(len(chart.advance_ratio)):
        given = slice(int(chart.first[row]), int(chart.last[row]) + 1)
        columns = place[given]
        for table, charted in ((full.power, chart.power), (full.thrust, chart.thrust)):
            table[row] += _offset(angle, angle[columns], charted[row, given] - table[row, columns])
    return full


def _offset(angle: Floats, given: Floats, offset: Floats) -> Floats:
    """Return what moves a row of the elements onto the chart, fading beyond its ends."""
    distance = np.maximum(np.maximum(given[0] - angle, angle - given[-1]), 0.0)
    return np.asarray(np.interp(angle, given, offset) * np.exp(-distance / FADE))


# ----------------------------------------------------------------------------------------------------------------------
# A propeller that stands: the blade angle at which the air does not turn it, and what it then drags.
# ----------------------------------------------------------------------------------------------------------------------


STANDING = 1e4
"""Advance ratio of a propeller that stands as good as still [-]."""
_ANGLES = np.radians(np.linspace(50.0, 90.0, 161))


class Feathered(NamedTuple):
    """A propeller in feather."""

    angle: float
    """Blade angle at three quarters of the radius at which it stands [rad]."""
    drag_area: float
    """Drag over the dynamic pressure and D² [-]."""


def feathered(shape: BladeShape) -> Feathered | None:
    """Return how blades feather; None where no angle from 50 to 90° stops them.

    Args:
        shape: The blades.

    Source: `loads` at an advance ratio of 10⁴: no torque; D/(q D²) = -2 C_T/J².
    """
    found = loads(shape, STANDING, _ANGLES)
    torque, area = found.power / STANDING**2, -2.0 * found.thrust / STANDING**2
    turned = np.flatnonzero((torque[:-1] < 0.0) & (torque[1:] >= 0.0))
    if not len(turned):
        return None
    k = int(turned[-1])
    part = float(-torque[k] / (torque[k + 1] - torque[k]))
    angle, drag = (float(row[k] + part * (row[k + 1] - row[k])) for row in (_ANGLES, area))
    return Feathered(angle, drag) if math.isfinite(drag) else None


# ----------------------------------------------------------------------------------------------------------------------
# A propeller whose axis stands at an angle to the stream: loads that bend blades and shaft once a turn.
# ----------------------------------------------------------------------------------------------------------------------


AZIMUTHS = 24
"""Places of a blade around the turn; loads are sines of few orders."""
LARGEST_INCIDENCE = math.radians(30.0)
"""Angle beyond which the stream along the disc is no small part of the blades' speed [rad]."""


class Inclined(NamedTuple):
    """A propeller at incidence; coefficients by ρ n² D⁴, moments by ρ n² D⁵, power by ρ n³ D⁵."""

    thrust: float
    """C_T along the axis [-]."""
    power: float
    """C_P [-]."""
    normal: float
    """C_N: force across the axis, towards the side to which the nose points [-]."""
    yaw: float
    """C_n: moment across the axis by the thrust, which lies towards the blades that go down (nose up) [-]."""
    blade_thrust: Floats
    """C_T of one blade around the turn, from where it stands up [-]."""
    blade_bending: Floats
    """Moment of one blade's thrust about the axis' centre, around the turn [-]."""

    @property
    def once_a_turn(self) -> float:
        """Amplitude of a blade's bending once a turn [-]."""
        turn = np.exp(-2j * math.pi * np.arange(AZIMUTHS) / AZIMUTHS)
        return float(abs(2.0 * np.mean(self.blade_bending * turn)))


def inclined(
    shape: BladeShape, advance_ratio: float, pitch: float, *, incidence: float, tip_mach: float = 0.0
) -> Inclined:
    """Return the loads of a propeller whose axis stands at an angle to the stream.

    Args:
        shape: The blades.
        advance_ratio: J = V/(n D) of the whole stream [-].
        pitch: Blade angle at three quarters of the radius [rad].
        incidence: Angle between axis and stream; positive where the nose points up [rad].
        tip_mach: Of the tip's rotation; 0 leaves compressibility out [-].

    Source: blade elements around the turn: the part V sin α along the disc adds V sin α sin ψ to an element's speed;
        steady sections, and momentum at every place as if the whole ring were loaded so.

    Valid for: incidences to 30° and V sin α well below the speed of the elements; no wing, no nacelle.

    Raises:
        ValueError: Beyond 30°, or where elements of the hub would run backwards.
    """
    if abs(incidence) > LARGEST_INCIDENCE:
        raise ValueError(f"{math.degrees(incidence):.4g}° of incidence: give at most 30°")
    along = advance_ratio / math.pi * math.sin(incidence)
    if abs(along) >= shape.radius[0]:
        raise ValueError("the stream along the disc is faster than the blades' roots turn; less incidence or speed")
    turn = 2.0 * math.pi * np.arange(AZIMUTHS)[:, None] / AZIMUTHS
    turning = shape.radius + along * np.sin(turn)
    axial = np.full_like(turning, advance_ratio / math.pi * math.cos(incidence))
    found = loads_in(shape, axial, turning, pitch=pitch, tip_mach=tip_mach)
    # C_P per element is 2π (r/D) times the force along the turn: D/2 is the unit of the radius.
    across = found.element_power / (math.pi * shape.radius)
    side = np.sin(turn)[:, 0]
    bending = np.sum(found.element_thrust * shape.radius * shape.width, axis=-1) / 2.0
    return Inclined(
        thrust=float(np.mean(found.thrust)),
        power=float(np.mean(found.power)),
        normal=float(np.mean(np.sum(across * shape.width, axis=-1) * side)),
        yaw=float(np.mean(bending * side)),
        blade_thrust=found.thrust / shape.number,
        blade_bending=bending / shape.number,
    )
