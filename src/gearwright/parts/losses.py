"""Power losses in gear meshes, bearings and seals, windage and churning losses, and cooling oil flow.

Temperatures follow from them in `mission`.
"""

from __future__ import annotations

import math
from enum import Enum
from typing import NamedTuple

import numpy as np

from gearwright.base import CELSIUS, RPM, Floats
from gearwright.elementwise import Values, across, functions
from gearwright.parts.bearings import BearingKind, taper_factors
from gearwright.parts.gears import UNSHIFTED, ToothShift, base_helix_angle, transverse_pressure_angle

# ----------------------------------------------------------------------------------------------------------------------
# Power lost in a gear mesh: the tooth-loss factor and the mean friction of the teeth.
# ----------------------------------------------------------------------------------------------------------------------


_LEAST_ROLLING = 1e-3
"""Sum of the rolling speeds below which the friction formula is held [m/s]; at rest it would grow without bound."""
HIGHEST_FRICTION = 0.2
"""Friction at which the formula is held: boundary lubrication of steel [-]; an assumption."""


class ToothContact(NamedTuple):
    """What friction and loss of a pair of cylindrical gears depend on."""

    loss_factor: float
    """H_V [-]."""
    curvature: float
    """Reduced radius of curvature at the pitch point ρ_redC [m]."""
    pressure_angle: float
    """Working transverse pressure angle α_wt [rad]."""
    base_helix: float
    """β_b [rad]."""
    pinion_diameter: float
    """Reference diameter of the smaller gear d_1 [m]."""
    radii: tuple[float, float] = (math.inf, math.inf)
    """Working pitch radii r_w1 and r_w2, the latter negative for an internal gear [m]."""
    path: tuple[float, float] = (0.0, 0.0)
    """Path of contact before and after the pitch point [m]."""
    base_pitch: float = math.inf
    """Transverse base pitch p_bt [m]."""
    helix: float = 0.0
    """β [rad]."""

    @property
    def closing(self) -> float:
        """How much faster than the pitch line the flanks part for every metre from the pitch point [1/m]."""
        return abs(1.0 / self.radii[0] + 1.0 / self.radii[1])


class Friction(Enum):
    """Whose mean coefficient of friction."""

    SCHLENK = "schlenk"
    """Schlenk 1994, as in ISO/TR 14179-2: R_a^¼."""
    NIEMANN_WINTER = "niemann-winter"
    """Niemann and Winter: roughness against the pinion's size, as DIN 3990-4 has it."""


def tooth_loss_factor(teeth: tuple[float, float], base_helix: float, *, approach: float, recess: float) -> float:
    """Return the tooth-loss factor H_V [-]: the mean of sliding over rolling, weighted with the load.

    Args:
        teeth: z_1 and z_2, the latter negative for an internal gear [-].
        base_helix: β_b [rad].
        approach: Part of the contact ratio before the pitch point ε_2 [-]; negative where the path starts behind it.
        recess: Part after it ε_1 [-]; negative where the path ends before it.

    Source: Ohlendorf (1958), π (1/z_1 + 1/z_2)/cos β_b · (1 - ε_α + ε_1² + ε_2²), which is the integral of the sliding
        for parts of 0 to 1 and ε_α of 1 to 2; the same integral, equal pairs sharing the load equally, elsewhere.

    Valid for: ε_α from 1 on; below, Ohlendorf's formula without a meaning of its own.

    >>> round(tooth_loss_factor((16, 24), 0.0, approach=0.707, recess=0.728), 3)
    0.195
    """
    holds = min(approach, recess) >= 0.0 and max(approach, recess) <= 1.0
    shape = _closed_sliding if holds or approach + recess < 1.0 else _sliding_over_path
    return math.pi * abs(1.0 / teeth[0] + 1.0 / teeth[1]) / math.cos(base_helix) * shape(approach, recess)


def ohlendorf_loss_factor(teeth: tuple[float, float], base_helix: float, *, approach: float, recess: float) -> float:
    """Return H_V by Ohlendorf's formula wherever the pitch point lies [-], as commercial reports print it.

    Args:
        teeth: z_1 and z_2, the latter negative for an internal gear [-].
        base_helix: β_b [rad].
        approach: ε_2 [-].
        recess: ε_1 [-].

    Source: `tooth_loss_factor`, which leaves the formula where a part is below 0 or above 1.
    """
    scale = math.pi * abs(1.0 / teeth[0] + 1.0 / teeth[1]) / math.cos(base_helix)
    return scale * _closed_sliding(approach, recess)


def _closed_sliding(approach: float, recess: float) -> float:
    """Ohlendorf's closed form of `_sliding_over_path`."""
    return 1.0 - (approach + recess) + approach**2 + recess**2


def _sliding_over_path(approach: float, recess: float) -> float:
    """Twice the integral of the distance to the pitch point over the path, each pair bearing its share of the load."""
    pairs = math.floor(approach + recess)
    more = approach + recess - pairs
    crowded = sum(_distance(place - approach, place - approach + more) for place in range(pairs + 1))
    return 2.0 * (_distance(-approach, recess) / pairs - crowded / (pairs * (pairs + 1)))


def _distance(start: float, end: float) -> float:
    """∫ |x| dx."""
    return 0.5 * (end * abs(end) - start * abs(start))


def tip_contact_ratio(teeth: float, tip_radius: float, base_radius: float, working_angle: float) -> float:
    """Return the part of the transverse contact ratio that the tip of one gear adds [-].

    Args:
        teeth: z, negative for an internal gear [-].
        tip_radius: r_a [m].
        base_radius: r_b [m].
        working_angle: α_wt [rad].

    Source: ISO 21771:2007: z/(2π) (tan α_a - tan α_wt).
    """
    reach = math.sqrt(max((tip_radius / base_radius) ** 2 - 1.0, 0.0))
    return teeth / (2.0 * math.pi) * (reach - math.tan(working_angle))


def tooth_contact(
    teeth: tuple[int, int],
    module: float,
    *,
    pressure_angle: float,
    helix_angle: float = 0.0,
    shifts: tuple[ToothShift, ToothShift] = (UNSHIFTED, UNSHIFTED),
    working_angle: float | None = None,
) -> ToothContact:
    """Return the contact of a pair without backlash on its working centre distance.

    Args:
        teeth: z_1 and z_2, the latter negative for an internal gear [-].
        module: m_n [m].
        pressure_angle: α_n [rad].
        helix_angle: β [rad].
        shifts: Of both gears.
        working_angle: α_wt [rad]; None: the reference centre distance.

    Source: ISO 21771:2007, addendum of one module; `tooth_loss_factor`.
    """
    reference = transverse_pressure_angle(pressure_angle, helix_angle)
    angle = reference if working_angle is None else working_angle
    radii = [0.5 * module * z / math.cos(helix_angle) for z in teeth]
    heights = [1.0 + shift.profile_shift + shift.tip_alteration for shift in shifts]
    tips = [radius + module * height for radius, height in zip(radii, heights, strict=True)]
    ratios = [
        tip_contact_ratio(z, abs(tip), abs(radius) * math.cos(reference), angle)
        for z, tip, radius in zip(teeth, tips, radii, strict=True)
    ]
    base = base_helix_angle(pressure_angle, helix_angle)
    stretch = 1.0 if working_angle is None else math.cos(reference) / math.cos(angle)
    curvature = stretch * radii[0] * radii[1] / (radii[0] + radii[1]) * math.sin(angle) / math.cos(base)
    pitch = math.pi * module * math.cos(reference) / math.cos(helix_angle)
    return ToothContact(
        loss_factor=tooth_loss_factor(teeth, base, approach=ratios[1], recess=ratios[0]),
        curvature=curvature,
        pressure_angle=angle,
        base_helix=base,
        pinion_diameter=2.0 * min(abs(radius) for radius in radii),
        radii=(stretch * radii[0], stretch * radii[1]),
        path=(ratios[1] * pitch, ratios[0] * pitch),
        base_pitch=pitch,
        helix=helix_angle,
    )


def mesh_friction(
    contact: ToothContact,
    line_load: Values,
    velocity: Values,
    *,
    viscosity: Values,
    roughness: float,
    law: Friction = Friction.SCHLENK,
) -> Values:
    """Return the mean coefficient of friction of a mesh μ_mz [-].

    Args:
        contact: Of the pair.
        line_load: F_bt/b [N/m], with the application factor and that of load sharing where they are known.
        velocity: Pitch-line velocity v [m/s].
        viscosity: Dynamic viscosity of the oil at its temperature η [Pa s].
        roughness: Mean arithmetic roughness of both flanks R_a [m].
        law: Whose.

    Source: Schlenk (1994): 0.048 (F_bt/b/(v_ΣC ρ_redC))^0.2 η^-0.05 R_a^0.25 with N/mm, m/s, mm, mPa s, µm, and
        v_ΣC = 2 v sin α_wt; a mineral oil without factor X_L. Niemann and Winter (2003): 0.045, and 3.8 (R_a/d_1)^0.25
        in place of R_a^0.25, with d_1 in mm. Both held at 0.2.
    """
    of = functions(line_load, velocity, viscosity)
    rolling = of.max(2.0 * abs(velocity) * of.sin(contact.pressure_angle), _LEAST_ROLLING)
    loading = abs(line_load) * 1e-3 / (rolling * contact.curvature * 1e3)
    oil, surface = of.pow(viscosity * 1e3, -0.05), of.pow(roughness * 1e6, 0.25)
    if law is Friction.SCHLENK:
        return of.min(0.048 * of.pow(loading, 0.2) * oil * surface, HIGHEST_FRICTION)
    size = 3.8 * of.pow(contact.pinion_diameter * 1e3, -0.25)
    return of.min(0.045 * of.pow(loading, 0.2) * oil * size * surface, HIGHEST_FRICTION)


def mesh_efficiency(contact: ToothContact, friction: float) -> float:
    """Return the efficiency of a mesh: power out of its teeth over power into them, relative to the carrier [-].

    Args:
        contact: Of the pair.
        friction: μ_mz [-].

    Source: P_VZP = P μ_mz H_V; ISO/TR 14179-2:2001.
    """
    return 1.0 - friction * contact.loss_factor


# ----------------------------------------------------------------------------------------------------------------------
# What part of its power a mesh loses, by the method that is asked for.
# ----------------------------------------------------------------------------------------------------------------------


SLOWEST, FASTEST = 2.0, 25.0
"""Pitch-line velocities between which ISO/TR 14179-1 gives a friction [m/s]."""
LEAST_INTENSITY, MOST_INTENSITY = 1.4e6, 14e6
"""Load intensities K between which ISO/TR 14179-1 gives a friction [Pa]."""
_LEAST_FRICTION, _MOST_FRICTION = 0.0, 0.2
_FILM_TRACTION = 9.0e7
"""Rolling traction over film thickness and face width [N/m²] (Anderson and Loewenthal, after Crook)."""
_POINTS = 200
"""Points of the path of contact at which the loss is taken [-]."""
_LEAST_VELOCITY = 1e-3
"""Velocity below which a mesh loses as at this one [m/s]."""


class MeshLaw(Enum):
    """Whose loss of a mesh."""

    SCHLENK = "schlenk"
    """Schlenk's friction and Ohlendorf's loss factor: ISO/TR 14179-2:2001."""
    NIEMANN_WINTER = "niemann-winter"
    """Niemann and Winter's friction and Ohlendorf's loss factor."""
    ISO_TR_14179_1 = "iso-tr-14179-1"
    """ISO/TR 14179-1:2001, after AGMA: friction by oil, load intensity and velocity, and a mechanical advantage."""
    ANDERSON_LOEWENTHAL = "anderson-loewenthal"
    """NASA TP-1622: sliding by Benedict and Kelley and rolling traction, along the path of contact."""


class LossDuty(NamedTuple):
    """What a mesh bears."""

    line_load: Values
    """F_bt/b [N/m]."""
    face_width: float
    """b [m]."""
    velocity: Values
    """Pitch-line velocity v [m/s]."""


class OilState(NamedTuple):
    """The oil between the teeth, and the teeth themselves."""

    viscosity: Values
    """Dynamic viscosity at its temperature η [Pa s]."""
    density: float
    """[kg/m³]"""
    roughness: float
    """Mean arithmetic roughness of both flanks R_a [m]."""
    lubricant_factor: float = 1.0
    """X_L of Schlenk, and of Niemann and Winter [-]: 1 for mineral oils."""


def mesh_loss_part(contact: ToothContact, duty: LossDuty, oil: OilState, *, law: MeshLaw = MeshLaw.SCHLENK) -> Values:
    """Return the part of its power that a mesh loses [-].

    Args:
        contact: Of the pair.
        duty: Load and velocity.
        oil: Between the teeth.
        law: Whose.

    Source: Schlenk, or Niemann and Winter: μ_mz H_V (`mesh_friction`, `tooth_loss_factor`); `iso_tr_14179_1_part`,
        `anderson_loewenthal_part`.
    """
    if law is MeshLaw.ISO_TR_14179_1:
        return iso_tr_14179_1_part(contact, duty, oil)
    if law is MeshLaw.ANDERSON_LOEWENTHAL:
        return anderson_loewenthal_part(contact, duty, oil)
    friction = mesh_friction(
        contact, duty.line_load, duty.velocity,
        viscosity=oil.viscosity, roughness=oil.roughness, law=Friction(law.value),
    )  # fmt: skip
    return friction * oil.lubricant_factor * contact.loss_factor


def load_intensity(contact: ToothContact, line_load: Values) -> Values:
    """Return the load intensity K of a mesh [Pa].

    Args:
        contact: Of the pair.
        line_load: F_bt/b [N/m].

    Source: ISO/TR 14179-1:2001: 1000 T_1 (z_1 + z_2)/(2 b r_w1² z_2) in N m and mm: F_t/(2 b)
        (1/r_w1 + 1/r_w2).
    """
    return 0.5 * abs(line_load) * functions(line_load).cos(contact.pressure_angle) * contact.closing


def iso_tr_14179_1_part(contact: ToothContact, duty: LossDuty, oil: OilState) -> Values:
    """Return the part of its power that a mesh loses by ISO/TR 14179-1 [-].

    Args:
        contact: Of the pair.
        duty: Load and velocity.
        oil: Between the teeth.

    Source: ISO/TR 14179-1:2001: f_m cos² β/M, f_m = ν^-0.223 K^-0.40/(3.239 V^0.70) in mm²/s, N/mm² and m/s,
        M = 2 cos α_w (H_s + H_t)/(H_s² + H_t²), H the path before and after the pitch point times 1/r_w1 + 1/r_w2.

    Valid for: V of 2 to 25 m/s and K of 1.4 to 14 N/mm²; outside it is taken at the nearest end.
    """
    of = functions(duty.line_load, duty.velocity, oil.viscosity)
    velocity = of.min(of.max(abs(duty.velocity), SLOWEST), FASTEST)
    intensity = of.min(of.max(load_intensity(contact, duty.line_load), LEAST_INTENSITY), MOST_INTENSITY)
    viscosity = oil.viscosity / oil.density * 1e6
    friction = viscosity**-0.223 * (intensity * 1e-6) ** -0.40 / (3.239 * velocity**0.70)
    slides = [abs(length) * contact.closing for length in contact.path]
    advantage = 2.0 * of.cos(contact.pressure_angle) * sum(slides) / sum(slide**2 for slide in slides)
    return friction * of.cos(contact.helix) ** 2 / advantage


def anderson_loewenthal_part(contact: ToothContact, duty: LossDuty, oil: OilState) -> Values:
    """Return the part of its power that a mesh loses by sliding and by rolling [-].

    Args:
        contact: Of the pair.
        duty: Load and velocity.
        oil: Between the teeth.

    Source: Anderson and Loewenthal, NASA TP-1622 (1980): sliding with f = 0.0127 lg(29.66 w/(μ V_S V_T²)) of Benedict
        and Kelley (N/m, mPa s, m/s), rolling traction 9e7 h b with h = 2.051e-7 (V_T μ)^0.67 F^-0.067 ρ^0.464 (mPa s,
        N, m); here at points of the path, pairs in contact sharing the load equally, in place of their means.

    Valid for: spur gears; helical ones as their transverse section. f is held between 0 and 0.2.
    """
    of = functions(duty.line_load, duty.velocity, oil.viscosity)
    velocity, width = of.max(abs(duty.velocity), _LEAST_VELOCITY), duty.face_width
    carried = abs(duty.line_load) * width
    total = of.where(carried == 0.0, 1.0, carried)
    place, pairs = _pairs_in_contact(contact)
    slides, rolls, curvature = _kinematics(contact, place, across(velocity))
    load, oil_mpas = across(total) / pairs, across(oil.viscosity) * 1e3
    with np.errstate(divide="ignore"):
        inner = 29.66 * load / width / (oil_mpas * slides * rolls**2)
    friction = np.clip(0.0127 * np.log10(inner), _LEAST_FRICTION, _MOST_FRICTION)
    film = 2.051e-7 * (rolls * oil_mpas) ** 0.67 * load**-0.067 * curvature**0.464
    power = friction * load * slides + _FILM_TRACTION * film * width * rolls
    in_contact = sum(abs(length) for length in contact.path) / contact.base_pitch
    mean = np.mean(power, axis=-1) if power.ndim > 1 else np.mean(power)
    part = mean * in_contact / (total * math.cos(contact.pressure_angle) * velocity)
    return of.where(carried == 0.0, 0.0, part)


def _pairs_in_contact(contact: ToothContact) -> tuple[Floats, Floats]:
    """Return places on the path from the pitch point [m] and how many pairs of teeth touch when one is there."""
    approach, recess = contact.path
    place = (np.arange(_POINTS) + 0.5) / _POINTS * (approach + recess) - approach
    reach = math.ceil((approach + recess) / contact.base_pitch)
    shifted = place[:, None] + contact.base_pitch * np.arange(-reach, reach + 1)[None, :]
    return place, np.sum((shifted >= -approach) & (shifted <= recess), axis=1).astype(float)


def _kinematics(contact: ToothContact, place: Floats, velocity: Values) -> tuple[Floats, Floats, Floats]:
    """Return sliding and summed rolling velocity [m/s] and reduced radius of curvature [m] at places of the path."""
    first, second = contact.radii
    lean = math.sin(contact.pressure_angle)
    curvatures = first * lean + place, second * lean - place
    slides = velocity * np.abs(place) * contact.closing
    rolls = np.abs(velocity * (curvatures[0] / first + curvatures[1] / second))
    return slides, rolls, np.abs(curvatures[0] * curvatures[1] / (curvatures[0] + curvatures[1]))


# ----------------------------------------------------------------------------------------------------------------------
# Friction of rolling bearings.
# ----------------------------------------------------------------------------------------------------------------------


CYLINDRICAL_ROLLER_FRICTION = 0.0011
"""μ of a cylindrical roller bearing with cage [-]; SKF rolling bearings catalogue, constant-coefficient estimate."""

LEAST_PRODUCT = 2000.0
"""ν n as which a smaller one counts in Palmgren's idle torque [mm²/(s min)]."""


def bearing_torque_constant(load: Values, bore: float, friction: float = CYLINDRICAL_ROLLER_FRICTION) -> Values:
    """Return the friction torque of a bearing by a constant coefficient [N m].

    Args:
        load: Equivalent load P [N].
        bore: d [m].
        friction: μ [-].

    Source: SKF rolling bearings catalogue: M = 0.5 μ P d.

    Valid for: load about a tenth of the dynamic rating, good lubrication, medium speed.

    >>> round(bearing_torque_constant(1000.0, 0.1), 3)
    0.055
    """
    return 0.5 * friction * load * bore


def bearing_torque_palmgren(
    load: Values, mean_diameter: float, speed: Values, *, viscosity: Values, oil_factor: float, load_factor: float
) -> Values:
    """Return the friction torque of a bearing as a part by the oil and a part by the load [N m].

    Args:
        load: Deciding load P_1 [N].
        mean_diameter: d_m [m].
        speed: Of the inner against the outer ring [rad/s].
        viscosity: Kinematic viscosity at the oil's temperature ν [m²/s].
        oil_factor: f_0 of the bearing's type and lubrication [-].
        load_factor: f_1 of the bearing's type and load [-].

    Source: Palmgren (1957), as in ISO/TR 14179-2:2001: M_0 = 1e-7 f_0 (ν n)^(2/3) d_m³, with ν n at least 2000, and
        M_1 = f_1 P_1 d_m, in mm, N mm, mm²/s and 1/min.

    >>> round(bearing_torque_palmgren(5000.0, 0.065, 157.08, viscosity=40e-6, oil_factor=2.0, load_factor=3e-4), 3)
    0.182
    """
    of = functions(load, speed, viscosity)
    product = of.where(speed == 0.0, 0.0, of.max(viscosity * 1e6 * abs(speed) / RPM, LEAST_PRODUCT))
    diameter = mean_diameter * 1e3
    idle = 1e-7 * oil_factor * of.pow(product, 2.0 / 3.0) * diameter**3
    return 1e-3 * (idle + load_factor * load * diameter)


# ----------------------------------------------------------------------------------------------------------------------
# Friction torque of rolling bearings by SKF's model: rolling and sliding, by the film that the oil makes.
# ----------------------------------------------------------------------------------------------------------------------


OIL_JET = 3e-8
"""K_rs of a low oil bath or an oil jet [-]."""
BOUNDARY_FRICTION, STARTING_FRICTION = 0.12, 0.15
"""μ_bl in motion and at rest [-]."""
FULL_FILM_FRICTION = {BearingKind.CYLINDRICAL: 0.02, BearingKind.TAPER: 0.002}
"""μ_EHL by kind; of ball bearings in mineral oil 0.05 [-]."""
_BALL_FRICTION = 0.05
_GEOMETRY = {
    BearingKind.DEEP_GROOVE: 3.1, BearingKind.FOUR_POINT: 3.1, BearingKind.CYLINDRICAL: 5.1, BearingKind.TAPER: 6.0,
}  # fmt: skip
"""K_Z [-]."""


class SeriesFriction(NamedTuple):
    """What a series of bearings loses, as its makers fit it."""

    oil_factor: float
    """f_0 and f_0r [-]."""
    load_factor: float
    """f_1 and f_1r [-]."""
    rolling: tuple[float, float, float]
    """R_1, R_2, R_3 in mm, N and 1/min."""
    sliding: tuple[float, float, float]
    """S_1, S_2, S_3 in mm, N and 1/min."""


class RunningBearing(NamedTuple):
    """A bearing under load."""

    kind: BearingKind
    bore: float
    """d [m]."""
    outer_diameter: float
    """D [m]."""
    static_rating: float
    """C_0 [N]."""
    contact_angle: float
    """α, of taper bearings [rad]."""
    radial: Values
    """F_r [N]."""
    axial: Values
    """F_a [N]."""


def bearing_torque_skf(
    bearing: RunningBearing,
    friction: SeriesFriction,
    speed: Values,
    *,
    viscosity: Values,
    replenishment: float = OIL_JET,
) -> Values:
    """Return the friction torque of a bearing without seals by its rolling and its sliding [N m].

    Args:
        bearing: Under load.
        friction: Of its series.
        speed: Of the inner against the outer ring [rad/s].
        viscosity: Kinematic viscosity at the oil's temperature ν [m²/s].
        replenishment: K_rs [-]; 6e-8 for grease and oil-air.

    Source: SKF, The SKF model for calculating the frictional moment: φ_ish φ_rs G_rr (ν n)^0.6 + G_sl μ_sl, in mm, N,
        1/min and mm²/s, with constants by series.

    Valid for: mineral oil, normal clearance; without the drag of an oil bath and without seals.
    """
    turns, oil = abs(speed) / RPM, viscosity * 1e6
    mean = 1e3 * (bearing.bore + bearing.outer_diameter) / 2.0
    of = functions(bearing.radial, bearing.axial, speed, viscosity)
    rolling = _rolling_variable(bearing, friction, mean, turns) * of.pow(oil * turns, 0.6)
    heated = 1.0 / (1.0 + 1.84e-9 * of.pow(turns * mean, 1.28) * of.pow(oil, 0.64))
    sides = 1e3 * (bearing.outer_diameter - bearing.bore), 1e3 * (bearing.outer_diameter + bearing.bore)
    starved = of.exp(-replenishment * oil * turns * sides[1] * math.sqrt(_GEOMETRY[bearing.kind] / (2.0 * sides[0])))
    slides = _sliding_variable(bearing, friction, mean, turns) * _sliding_friction(bearing.kind, oil * turns, mean)
    return 1e-3 * (heated * starved * rolling + slides)


def _sliding_friction(kind: BearingKind, product: Values, mean: float) -> Values:
    """Return μ_sl between boundary lubrication and a full film [-]."""
    of = functions(product)
    boundary = of.exp(-2.6e-8 * of.pow(product, 1.4) * mean)
    dry = of.where(product == 0.0, STARTING_FRICTION, BOUNDARY_FRICTION)
    return boundary * dry + (1.0 - boundary) * FULL_FILM_FRICTION.get(kind, _BALL_FRICTION)


def _rolling_variable(bearing: RunningBearing, friction: SeriesFriction, mean: float, turns: Values) -> Values:
    """Return G_rr."""
    first, second, third = friction.rolling
    radial, axial = abs(bearing.radial), abs(bearing.axial)
    of = functions(radial, axial, turns)
    if bearing.kind is BearingKind.CYLINDRICAL:
        return first * of.pow(mean, 2.41) * of.pow(radial, 0.31)
    if bearing.kind is BearingKind.TAPER:
        return first * of.pow(mean, 2.38) * of.pow(radial + second * _slope(bearing) * axial, 0.31)
    if bearing.kind is BearingKind.FOUR_POINT:
        return first * of.pow(mean, 1.97) * of.pow(radial + third * mean**4 * turns**2 + second * axial, 0.54)
    pushed = second / _loaded_sine(bearing) * axial
    return first * of.pow(mean, 1.96) * of.pow(radial + pushed, 0.54)


def _sliding_variable(bearing: RunningBearing, friction: SeriesFriction, mean: float, turns: Values) -> Values:
    """Return G_sl."""
    first, second, third = friction.sliding
    radial, axial = abs(bearing.radial), abs(bearing.axial)
    of = functions(radial, axial, turns)
    if bearing.kind is BearingKind.CYLINDRICAL:
        return first * of.pow(mean, 0.9) * axial + second * mean * radial
    if bearing.kind is BearingKind.TAPER:
        return first * of.pow(mean, 0.82) * (radial + second * _slope(bearing) * axial)
    if bearing.kind is BearingKind.FOUR_POINT:
        flung = radial + third * mean**4 * turns**2
        return first * of.pow(mean, 0.26) * (of.pow(flung, 4.0 / 3.0) + second * of.pow(axial, 4.0 / 3.0))
    pushed = second * of.pow(mean, 1.5) / _loaded_sine(bearing) * axial**4
    under_thrust = first * of.pow(mean, -0.145) * of.pow(radial**5 + pushed, 1.0 / 3.0)
    return of.where(axial == 0.0, first * of.pow(mean, -0.26) * of.pow(radial, 5.0 / 3.0), under_thrust)


def _slope(bearing: RunningBearing) -> float:
    """Return Y of a taper bearing [-]."""
    return taper_factors(bearing.contact_angle).axial


def _loaded_sine(bearing: RunningBearing) -> Values:
    """Return sin α_F, α_F the contact angle of a deep groove bearing under thrust; 1 without thrust."""
    of = functions(bearing.axial)
    angle = of.radians(24.6 * of.pow(abs(bearing.axial) / bearing.static_rating, 0.24))
    return of.where(bearing.axial == 0.0, 1.0, of.sin(angle))


# ----------------------------------------------------------------------------------------------------------------------
# Friction of radial shaft seals.
# ----------------------------------------------------------------------------------------------------------------------


VITON, NITRILE = 3.737e-3, 2.429e-3
"""Torque over shaft diameter by material of the lip [N m/mm] (ISO/TR 14179-1:2001)."""
LEAST_OIL_FACTOR = 0.5 * 76.9
"""Factor at which Linke's line is held [W min/mm² 1e-7]: half of that of ISO/TR 14179-2; an assumption."""


def seal_power_14179_1(diameter: float, speed: Values, *, torque_per_mm: float = VITON) -> Values:
    """Return what a shaft seal loses by ISO/TR 14179-1 [W].

    Args:
        diameter: Of the shaft [m].
        speed: [rad/s].
        torque_per_mm: Of the lip's material [N m/mm].

    Source: ISO/TR 14179-1:2001: T = 3.737e-3 D for Viton, 2.429e-3 D for nitrile, in N m and mm.

    >>> round(seal_power_14179_1(0.04, 157.08), 1)
    23.5
    """
    return torque_per_mm * 1e3 * diameter * abs(speed)


def seal_power_14179_2(diameter: float, speed: Values) -> Values:
    """Return what a shaft seal loses by ISO/TR 14179-2 [W].

    Args:
        diameter: Of the shaft d [m].
        speed: [rad/s].

    Source: ISO/TR 14179-2:2001: 7.69e-6 d² n with mm and 1/min.

    >>> round(seal_power_14179_2(0.04, 157.08), 2)
    18.46
    """
    return 7.69e-6 * (1e3 * diameter) ** 2 * abs(speed) / RPM


def seal_power_oil(diameter: float, speed: Values, *, temperature: Values, viscosity_40: float) -> Values:
    """Return what a shaft seal loses by its oil [W].

    Args:
        diameter: Of the shaft d [m].
        speed: [rad/s].
        temperature: Of the oil sump θ [K].
        viscosity_40: Kinematic viscosity at 40 °C [m²/s].

    Source: Linke (1996), as makers of seals (Simrit) have it: (145 - 1.6 θ + 350 lg lg(ν_40 + 0.8)) d² n 1e-7, θ in °C,
        mm²/s, mm and 1/min.

    Valid for: factors from half of that of ISO/TR 14179-2 on; the line falls through zero where oil is hot or thin, and
        is held there, which is an assumption: no seal runs without friction.

    >>> round(seal_power_oil(0.04, 157.08, temperature=423.15, viscosity_40=26e-6), 2)  # half of 18.46 W
    9.23
    """
    of = functions(speed, temperature)
    factor = of.max(seal_oil_factor(temperature, viscosity_40), LEAST_OIL_FACTOR)
    return 1e-7 * factor * (1e3 * diameter) ** 2 * abs(speed) / RPM


def seal_oil_factor(temperature: Values, viscosity_40: float) -> Values:
    """Return the factor of Linke's line, wherever it leads [W min/mm² 1e-7].

    Args:
        temperature: Of the oil sump θ [K].
        viscosity_40: Kinematic viscosity at 40 °C [m²/s].

    Source: `seal_power_oil`.
    """
    return 145.0 - 1.6 * (temperature - CELSIUS) + 350.0 * math.log10(math.log10(viscosity_40 * 1e6 + 0.8))


# ----------------------------------------------------------------------------------------------------------------------
# What oil and oil mist cost, and the oil that carries the heat away.
# ----------------------------------------------------------------------------------------------------------------------


OIL_DENSITY = 950.0
"""Of a turbine oil [kg/m³]."""
TURBINE_OIL = (26e-6, 5e-6)
"""Kinematic viscosity of a 5 cSt turbine oil at 40 °C and 100 °C [m²/s], typical of a MIL-PRF-23699 oil."""
_ARRANGEMENT = 0.2
"""A_g of ISO/TR 14179-1 [-]."""
LEAST_HELIX = math.radians(10.0)
"""Helix angle as which a smaller one counts in churning [rad]."""
LEAST_MODULE = 1.0
"""Module below which the roughness of the teeth is held [mm]."""


def windage_power(radius: Values, face_width: Values, speed: Values, *, viscosity: Values) -> Values:
    """Return the windage of one gear in the oil mist of a dry-sump gearbox [W].

    Args:
        radius: Pitch radius R [m].
        face_width: F [m].
        speed: [rad/s].
        viscosity: Dynamic viscosity of the oil μ_0 [Pa s].

    Source: Anderson and Loewenthal, NASA TP-1622 (1980): 2.82e-7 (1 + 2.3 F/R) n^2.8 R^4.6 (0.028 μ_0 + 0.019)^0.2 kW
        with n in 1/min and μ_0 in mPa s.
    """
    of, turns = functions(radius, speed, viscosity), abs(speed) * 30.0 / math.pi
    mist = of.pow(0.028 * viscosity * 1e3 + 0.019, 0.2)
    return 1e3 * 2.82e-7 * (1.0 + 2.3 * face_width / radius) * of.pow(turns, 2.8) * of.pow(radius, 4.6) * mist


def windage_power_dawson(
    diameter: float, face_width: float, speed: Values, *, module: float, enclosure: float = 1.0
) -> Values:
    """Return the windage of one gear in air [W].

    Args:
        diameter: Root diameter D [m].
        face_width: F [m].
        speed: [rad/s].
        module: M [m].
        enclosure: λ, 1 in the open, about 0.6 to 0.7 in a housing [-].

    Source: Dawson (1984): n^2.9 (0.16 D^3.9 + D^2.9 F^0.75 M^1.15) Φ λ 1e-20 kW with n in 1/min, lengths in mm, Φ = 1
        for air without oil.

    Valid for: large spur gears in air; oil mist is denser.
    """
    turns, wide, broad, teeth = abs(speed) * 30.0 / math.pi, 1e3 * diameter, 1e3 * face_width, 1e3 * module
    surfaces = 0.16 * wide**3.9 + wide**2.9 * broad**0.75 * teeth**1.15
    return 1e3 * 1e-20 * enclosure * turns**2.9 * surfaces


def churning_power(
    diameter: float, face_width: float, speed: Values, *, viscosity: Values, dip: float, module: float,
    helix_angle: float = 0.0,
) -> Values:  # fmt: skip
    """Return the churning of one gear, its teeth and both its sides, in an oil bath [W].

    Args:
        diameter: D [m].
        face_width: b [m].
        speed: [rad/s].
        viscosity: Kinematic viscosity at the oil's temperature ν [m²/s].
        dip: f_g: 0 out of the oil, 1 fully in it [-].
        module: Transverse module m_t [m].
        helix_angle: β, taken as 10° at least [rad].

    Source: ISO/TR 14179-1:2001: f_g ν n³ D^4.7 (7.37 b R_f/√tan β + 1.474 D)/(A_g 1e26) kW with the teeth's roughness
        R_f = 7.93 - 4.648/m_t and A_g = 0.2, in mm²/s, 1/min and mm.
    """
    of, turns, wide = functions(speed, viscosity), abs(speed) * 30.0 / math.pi, diameter * 1e3
    teeth = (7.93 - 4.648 / max(module * 1e3, LEAST_MODULE)) / of.sqrt(of.tan(max(helix_angle, LEAST_HELIX)))
    surfaces = 7.37 * face_width * 1e3 * teeth + 1.474 * wide
    return 1e3 * dip * viscosity * 1e6 * turns**3 * of.pow(wide, 4.7) * surfaces / (_ARRANGEMENT * 1e26)


def oil_flow(heat: float, rise: float, *, density: float = OIL_DENSITY, heat_capacity: float = 2000.0) -> float:
    """Return the oil flow that carries heat away [m³/s].

    Args:
        heat: [W].
        rise: Of the oil's temperature through the gearbox [K].
        density: [kg/m³]; a turbine oil at 100 °C.
        heat_capacity: [J/(kg K)]; the same.

    Source: heat balance, Q = P/(ρ c ΔT).
    """
    return heat / (density * heat_capacity * rise)


def cooler_conductance(heat: Values, oil_temperature: Values, air_temperature: Values) -> Values:
    """Return the conductance U A that an oil cooler needs [W/K].

    Args:
        heat: [W].
        oil_temperature: Mean of the oil in the cooler [K].
        air_temperature: Mean of the cooling air [K].

    Source: heat balance with mean temperatures.
    """
    return heat / (oil_temperature - air_temperature)


def oil_viscosity(temperature: Values, grade: tuple[float, float] = TURBINE_OIL) -> Values:
    """Return the kinematic viscosity of an oil [m²/s].

    Args:
        temperature: Of the oil [K].
        grade: Its kinematic viscosity at 40 °C and at 100 °C [m²/s]; a 5 cSt turbine oil.

    Source: Walther's equation (ASTM D341) through 5.0 mm²/s at 100 °C and 26 mm²/s at 40 °C, typical of a
        MIL-PRF-23699 oil.

    >>> round(oil_viscosity(373.15) * 1e6, 2)
    5.0
    """
    warm, hot = (_walther(viscosity * 1e6) for viscosity in grade)
    slope = (warm - hot) / math.log10(373.15 / 313.15)
    at = warm - slope * functions(temperature).log10(temperature / 313.15)
    return (10.0 ** (10.0**at) - 0.7) * 1e-6


def _walther(viscosity: float) -> float:
    """lg lg (ν + 0.7) with ν in mm²/s."""
    return math.log10(math.log10(viscosity + 0.7))
