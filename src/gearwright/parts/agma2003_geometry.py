"""Geometry factors I and J of bevel gears by annex C of ANSI/AGMA 2003."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, NamedTuple

from gearwright.base import DesignError, Origin, Problem, Quantity, refuse
from gearwright.parts.bevel_geometry import BevelPair, mean_thickness
from gearwright.parts.gears import involute

# ----------------------------------------------------------------------------------------------------------------------
# The mean normal section of a bevel pair as annex C of ANSI/AGMA 2003 sees it: radii, path of contact, load sharing.
#
# The geometry factors I and J are both taken from it.
# ----------------------------------------------------------------------------------------------------------------------


SOURCE = "ANSI/AGMA 2003-D19"


@dataclass(frozen=True)
class MeanSection:
    """A bevel pair cut square to its teeth in the middle of the face, with the paths on which they touch."""

    bevel: BevelPair
    """The pair."""
    is_static: bool = False
    """Loaded without running, as in a differential; then no inertia factor is taken."""

    def __post_init__(self) -> None:
        ratio = self.profile_ratio
        refuse(
            [Problem("contact_ratio", f"{ratio:.3f} given; {SOURCE}, eq. C.24 asks straight teeth for more than 1")]
            if self.bevel.spiral_angle == 0.0 and ratio <= 1.0
            else []
        )

    @cached_property
    def mean_scale(self) -> float:
        """m_mt/m_et = R_m/R_e [-]."""
        return self.bevel.mean_cone_distance / self.bevel.outer_cone_distance

    @cached_property
    def transverse_radii(self) -> tuple[float, float]:
        """r_mpt = d_m/(2 cos δ) [m] (eqs C.13, C.14)."""
        pair = self.bevel
        first, second = (
            0.5 * d / math.cos(cone) for d, cone in zip(pair.mean_diameters, pair.pitch_angles, strict=True)
        )
        return first, second

    @cached_property
    def normal_radii(self) -> tuple[float, float]:
        """r_mpn = r_mpt/cos² β_m [m] (eqs C.15, C.16)."""
        square = math.cos(self.bevel.spiral_angle) ** 2
        return self.transverse_radii[0] / square, self.transverse_radii[1] / square

    @cached_property
    def base_radii(self) -> tuple[float, float]:
        """r_mbn = r_mpn cos α_n [m] (eqs C.17, C.18)."""
        cosine = math.cos(self.bevel.pressure_angle)
        return self.normal_radii[0] * cosine, self.normal_radii[1] * cosine

    @cached_property
    def tip_tangents(self) -> tuple[float, float]:
        """√(r_mne² − r_mbn²), from the base circle to the tip along the path of contact [m] (eqs C.19 to C.22)."""
        first, second = (
            math.sqrt((pitch + addendum) ** 2 - base**2)
            for pitch, addendum, base in zip(self.normal_radii, self.bevel.addenda, self.base_radii, strict=True)
        )
        return first, second

    @cached_property
    def addendum_actions(self) -> tuple[float, float]:
        """g_a1 and g_a2, from the pitch point to the tips [m] (eqs C.21, C.22)."""
        sine = math.sin(self.bevel.pressure_angle)
        return self.tip_tangents[0] - self.normal_radii[0] * sine, self.tip_tangents[1] - self.normal_radii[1] * sine

    @cached_property
    def action(self) -> float:
        """Length of action in the normal section g_an [m] (eq. C.23)."""
        return sum(self.addendum_actions)

    @cached_property
    def base_pitch(self) -> float:
        """Mean normal base pitch p_mbn [m] (eq. C.10)."""
        return math.pi * self.bevel.mean_module * math.cos(self.bevel.pressure_angle)

    @cached_property
    def base_cosine(self) -> float:
        """cos β_mb of the mean base spiral angle [-] (eq. C.28)."""
        alpha = self.bevel.pressure_angle
        return math.cos(alpha) * math.hypot(math.cos(self.bevel.spiral_angle), math.tan(alpha))

    @cached_property
    def base_sine(self) -> float:
        """sin β_mb [-]."""
        return math.sqrt(max(1.0 - self.base_cosine**2, 0.0))

    @cached_property
    def profile_ratio(self) -> float:
        """Transverse contact ratio ε_α = g_an/p_2 [-] (eqs C.12, C.24)."""
        alpha = self.bevel.pressure_angle
        pitch = math.pi * self.bevel.mean_module / math.cos(alpha)
        return self.action * (math.cos(self.bevel.spiral_angle) ** 2 + math.tan(alpha) ** 2) / pitch

    @cached_property
    def face_ratio(self) -> float:
        """Face contact ratio ε_β [-]; 0 of straight teeth (eqs C.25, C.26)."""
        part, slope = self.bevel.face_width / self.bevel.outer_cone_distance, math.tan(self.bevel.spiral_angle)
        lean = part * (2.0 - part) / (2.0 * (1.0 - part)) * slope
        return (lean - lean**3 / 3.0) * self.bevel.outer_cone_distance / (math.pi * self.bevel.outer_module)

    @cached_property
    def modified_ratio(self) -> float:
        """Modified contact ratio ε_o = √(ε_α² + ε_β²) [-] (eq. C.27)."""
        return math.hypot(self.profile_ratio, self.face_ratio)

    @cached_property
    def inertia(self) -> float:
        """Inertia factor Z_i = 2/ε_o, at least 1 [-] (eqs C.40, C.105)."""
        return 1.0 if self.is_static else max(2.0 / self.modified_ratio, 1.0)

    @cached_property
    def ellipse(self) -> float:
        """g_η², the square of the length of action within the ellipse of contact [m²] (eq. C.29)."""
        return (self.action * self.base_cosine**2) ** 2 + (self.bevel.face_width * self.base_sine) ** 2

    @cached_property
    def location(self) -> float:
        """Location constant k′, by which the load leaves the middle of the face [-] (eq. C.7)."""
        first, second = self.bevel.teeth
        return (second - first) / (3.2 * second + 4.0 * first)

    def chord(self, place: float) -> float:
        """Return the length of action within the ellipse at a place on it, g_ηI or g_ηJ [m].

        Args:
            place: Distance from the middle, y_I or y_J [m].

        Source: ANSI/AGMA 2003-D19, eqs C.34 and C.50.
        """
        return math.sqrt(max(self.ellipse - 4.0 * place**2, 0.0))

    def sharing(self, place: float) -> float:
        """Return the part of the load that the rated pair of teeth bears, ε_NI or ε_NJ [-].

        Args:
            place: Where it touches, y_I or y_J [m].

        Source: ANSI/AGMA 2003-D19, eqs C.41, C.42, C.103 and C.104: all pairs within the ellipse, each by the cube of
            its length of action.
        """
        own = self.chord(place) ** 3
        return own / (own + self._beyond(place, self.base_pitch) + self._beyond(place, -self.base_pitch))

    def _beyond(self, place: float, step: float) -> float:
        """Cubes of the lengths of action of all pairs on one side of a place, a base pitch apart [m³]."""
        total = 0.0
        while (chord := self.chord(place := place + step)) > 0.0:
            total += chord**3
        return total


def root_between(function: Callable[[float], float], low: float, high: float) -> float:
    """Return where a function that rises through 0 does so.

    Args:
        function: Of a length, below 0 at the lower end and above 0 at the upper [-].
        low: Lower end [m].
        high: Upper end [m].

    Source: bisection to the last digits.
    """
    while (middle := 0.5 * (low + high)) not in (low, high):
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
    return high


# ----------------------------------------------------------------------------------------------------------------------
# The pitting resistance geometry factor I of bevel gears by annex C of ANSI/AGMA 2003.
# ----------------------------------------------------------------------------------------------------------------------


_STEPS_DOWN = 40.0
"""Steps over the length of action in which the least I is looked for [-]."""
_GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


@dataclass(frozen=True)
class PittingGeometry:
    """Where the flanks are worst off, and the factor I that stands for them."""

    place: Annotated[float, Quantity("length"), Origin("y_I", f"{SOURCE}, eqs C.32, C.33")]
    """Distance of the critical point from the middle of the zone [m]."""
    curvature: Annotated[float, Quantity("length"), Origin("ρ_yo = ρ_1 ρ_2/(ρ_1 + ρ_2)", f"{SOURCE}, eqs C.35 to C.38")]
    """Relative radius of the profiles there [m]."""
    contact_line: Annotated[float, Quantity("length"), Origin("g_c = b g_an g_ηI cos β_mb/g_η²", f"{SOURCE}, eq. C.39")]
    """Length of the line of contact there [m]."""
    sharing: Annotated[float, Quantity("ratio"), Origin("ε_NI", f"{SOURCE}, eq. C.42")]
    """Part of the load that this line bears [-]."""
    inertia: Annotated[float, Quantity("ratio"), Origin("Z_i = max(2/ε_o, 1)", f"{SOURCE}, eq. C.40")]
    """Inertia factor of few teeth in contact [-]."""
    factor: Annotated[
        float,
        Quantity("ratio"),
        Origin("I = g_c ρ_yo cos β_m cos α_n/(b d_e1 Z_i ε_NI) m_mt/m_et", f"{SOURCE}, eq. C.1"),
    ]
    """Geometry factor I [-]."""


def pitting_geometry(section: MeanSection) -> PittingGeometry:
    """Return the geometry factor I and what makes it.

    Args:
        section: Mean section of the pair.

    Source: ANSI/AGMA 2003-D19, C.1.3: of straight teeth at the lowest point of single contact, of spiral teeth where
        I is least, sought from the middle of the zone.
    Valid for: bevel gears without offset; straight teeth with ε_α above 1.
    """
    if section.bevel.spiral_angle == 0.0:
        return _at(section, 0.5 * section.action - section.base_pitch)
    return _at(section, _lowest(lambda place: _at(section, place).factor, math.sqrt(section.ellipse)))


def _at(section: MeanSection, place: float) -> PittingGeometry:
    pair, chord, square = section.bevel, section.chord(place), section.ellipse
    along = section.action**2 * place * section.base_cosine**2
    across = pair.face_width * section.action * chord * section.location * section.base_sine
    distance = 0.5 * section.action + (along + across) / square - section.addendum_actions[1]
    sine = math.sin(pair.pressure_angle) / section.base_cosine**2
    first = section.transverse_radii[0] * sine + distance
    second = section.transverse_radii[1] * sine - distance
    curvature = first * second / (first + second)
    line = pair.face_width * section.action * chord * section.base_cosine / square
    share = section.sharing(place)
    angles = math.cos(pair.spiral_angle) * math.cos(pair.pressure_angle) * section.mean_scale
    area = pair.face_width * pair.outer_diameters[0] * section.inertia * share
    return PittingGeometry(place, curvature, line, share, section.inertia, line * curvature * angles / area)


def _lowest(function: Callable[[float], float], reach: float) -> float:
    """Return where a function has the minimum that lies next to 0."""
    step = reach / _STEPS_DOWN
    if function(-step) > function(step):
        step = -step
    place, value = 0.0, function(0.0)
    while (lower := function(place - step)) < value and abs(place - 2.0 * step) < 0.5 * reach:
        place, value = place - step, lower
    low, high = sorted((place - step, place + step))
    while high - low > 1e-9 * reach:
        inner, outer = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
        low, high = (low, outer) if function(inner) < function(outer) else (inner, high)
    return 0.5 * (low + high)


# ----------------------------------------------------------------------------------------------------------------------
# The bending strength geometry factor J of bevel gears by annex C of ANSI/AGMA 2003.
# ----------------------------------------------------------------------------------------------------------------------


_STEP, _STEPS = 0.1, 2000
"""Steps of the roll in depths of the tool's tip circle, until the fillet meets the parabola [-]."""


class LoadPoint(NamedTuple):
    """Where the load is put on the tooth."""

    along_path: float
    """Distance along the path of contact y_3 [m]."""
    along_face: float
    """Distance from the middle of the face, towards the heel positive, g_o″ [m]."""
    chord: float
    """Length of action there g_ηJ [m]."""
    sharing: float
    """Part of the load ε_NJ [-]."""


class Fillet(NamedTuple):
    """The weakest section of a tooth."""

    half_chord: float
    """s_N [m]."""
    height: float
    """Of the load above it h_N [m]."""


@dataclass(frozen=True)
class BevelBendingGeometry:
    """The tooth as a beam, and the factor J that stands for it."""

    load_angle: Annotated[float, Quantity("angle"), Origin("α_h", f"{SOURCE}, eqs C.58 to C.63")]
    """Pressure angle where the load meets the centre line of the tooth [rad]."""
    height: Annotated[float, Quantity("length"), Origin("h_N", f"{SOURCE}, eqs C.70 to C.95")]
    """Of the load above the weakest section [m]."""
    half_chord: Annotated[float, Quantity("length"), Origin("s_N; s_N cot υ/h_N = 2", f"{SOURCE}, eqs C.70 to C.95")]
    """Half the thickness of the weakest section, where the largest parabola touches the fillet [m]."""
    fillet_radius: Annotated[
        float, Quantity("length"), Origin("r_mf = (h_fm − ρ)²/(r_mpn + h_fm − ρ) + ρ", f"{SOURCE}, eqs C.68, C.69")
    ]
    """Least radius of the fillet [m]."""
    form: Annotated[
        float, Quantity("ratio"), Origin("Y = 2/(3 m_et (h_N/s_N² − tan α_h/(3 s_N)))", f"{SOURCE}, eqs C.82, C.95")
    ]
    """Tooth form factor Y, without the fillet's stress concentration [-]."""
    stress_correction: Annotated[
        float, Quantity("ratio"), Origin("Y_f = H + (2 s_N/r_mf)^L (2 s_N/h_N)^M", f"{SOURCE}, eqs C.96 to C.100")
    ]
    """Stress concentration and correction factor Y_f [-]."""
    sharing: Annotated[float, Quantity("ratio"), Origin("ε_NJ", f"{SOURCE}, eq. C.104")]
    """Part of the load on the tooth [-]."""
    inertia: Annotated[float, Quantity("ratio"), Origin("Y_i = max(2/ε_o, 1)", f"{SOURCE}, eq. C.105")]
    """Inertia factor of few teeth in contact [-]."""
    load_radius: Annotated[float, Quantity("ratio"), Origin("r_myo/r_mpt", f"{SOURCE}, eqs C.64 to C.67")]
    """Radius of the load over the mean one [-]."""
    effective_face: Annotated[float, Quantity("ratio"), Origin("b′/b", f"{SOURCE}, eqs C.106 to C.116")]
    """Part of the face over which the root bears [-]."""
    factor: Annotated[
        float,
        Quantity("ratio"),
        Origin("J = Y/(Y_f ε_NJ Y_i) r_myo/r_mpt b′/b m_mt/m_et", f"{SOURCE}, eqs C.43, C.44"),
    ]
    """Geometry factor J [-]."""


def bending_geometry(section: MeanSection, gear: int) -> BevelBendingGeometry:
    """Return the geometry factor J of one gear and what makes it.

    The pinion's concave flank drives, which is the usual hand; a spiral wheel is then loaded on its convex one.

    Args:
        section: Mean section of the pair.
        gear: 0 for the pinion, 1 for the wheel.

    Source: ANSI/AGMA 2003-D19, C.2; the weakest section is where the envelope of the cutter's tip circle, rolled on the
        pitch circle, touches the largest parabola from the load.
    Valid for: generated bevel gears without offset.
    """
    pair, load = section.bevel, load_point(section, concave=gear == 0)
    angle = _load_angle(section, gear, load)
    rise = section.base_radii[gear] / math.cos(angle) - section.normal_radii[gear]
    fillet = weakest_section(section, gear, rise)
    tool, dedendum = pair.tooth.edge_radii[gear] * pair.mean_module, pair.dedenda[gear]
    deep = dedendum - tool
    radius = deep**2 / (section.normal_radii[gear] + deep) + tool
    bending = fillet.height / fillet.half_chord**2 - math.tan(angle) / (3.0 * fillet.half_chord)
    form = 2.0 / (3.0 * pair.outer_module * bending)
    notch = stress_correction(fillet, radius, pair.pressure_angle)
    cone = pair.mean_cone_distance
    arm = (cone + load.along_face) / cone + rise / section.transverse_radii[gear]
    face = effective_face(section, load, fillet.height)
    factor = form / (notch * load.sharing * section.inertia) * arm * face * section.mean_scale
    return BevelBendingGeometry(
        angle, fillet.height, fillet.half_chord, radius, form, notch, load.sharing, section.inertia, arm, face, factor
    )


def load_point(section: MeanSection, *, concave: bool) -> LoadPoint:
    """Return where the load is put on a tooth.

    Args:
        section: Mean section of the pair.
        concave: The loaded flank of a spiral tooth is the concave one.

    Source: ANSI/AGMA 2003-D19, eqs C.47 to C.56 and C.103, C.104; straight teeth at the highest point of
        single contact.
    """
    pair, square, side = section.bevel, section.ellipse, 1.0 if concave else -1.0
    place = section.base_pitch - 0.5 * math.sqrt(square) if section.modified_ratio <= 2.0 else 0.0
    chord = section.chord(place)
    along = section.action**2 * place / square
    across = pair.face_width * section.action * chord * section.location / square
    cosine, sine = section.base_cosine**2, side * section.base_sine
    alone = pair.spiral_angle == 0.0 and section.modified_ratio <= 2.0
    share = 1.0 if alone else section.sharing(place)
    if pair.spiral_angle == 0.0:
        return LoadPoint(0.5 * section.action + along, across, chord, share)
    path = 0.5 * section.action + along * cosine + across * sine
    return LoadPoint(path, across * cosine - along * sine, chord, share)


def _load_angle(section: MeanSection, gear: int, load: LoadPoint) -> float:
    """α_h, where the load meets the centre line of the tooth (eqs C.58 to C.63)."""
    alpha = section.bevel.pressure_angle
    reach = load.along_path + sum(section.normal_radii) * math.sin(alpha) - section.tip_tangents[1 - gear]
    loaded = math.atan(reach / section.base_radii[gear])
    half = 0.5 * mean_thickness(section.bevel, gear) / section.normal_radii[gear]
    return loaded - (half - float(involute(loaded)) + float(involute(alpha)))


def weakest_section(section: MeanSection, gear: int, rise: float) -> Fillet:
    """Return the section of a tooth where the largest parabola from the load touches its fillet.

    Args:
        section: Mean section of the pair.
        gear: 0 for the pinion, 1 for the wheel.
        rise: Of the load above the pitch circle, on the centre line [m].

    Source: ANSI/AGMA 2003-D19, eqs C.70 to C.95: the centre of the cutter's tip circle at the roll angle ζ = g_fo/r
        lies g_zb = g_yb sin ζ + g_x cos ζ inwards and g_za = g_yb cos ζ − g_x sin ζ below the rolling point, υ between.

    Raises:
        DesignError: Teeth so pointed or undercut that there is none.
    """
    pair, radius = section.bevel, section.normal_radii[gear]
    alpha, tool = pair.pressure_angle, pair.tooth.edge_radii[gear] * pair.mean_module
    deep = pair.dedenda[gear] - tool
    offset = 0.5 * mean_thickness(pair, gear) + pair.dedenda[gear] * math.tan(alpha)
    offset += tool * (1.0 / math.cos(alpha) - math.tan(alpha))

    def centre(roll: float) -> tuple[float, float, float]:
        turn, ahead = roll / radius, roll - offset
        below = deep * math.cos(turn) - ahead * math.sin(turn)
        inwards = deep * math.sin(turn) + ahead * math.cos(turn)
        return turn, below, inwards

    def fillet(roll: float) -> Fillet:
        turn, below, inwards = centre(roll)
        slope = math.hypot(below, inwards)
        half = radius * math.sin(turn) - inwards - tool * inwards / slope
        return Fillet(half, rise + radius * (1.0 - math.cos(turn)) + below + tool * below / slope)

    def excess(roll: float) -> float:
        _, below, inwards = centre(roll)
        found = fillet(roll)
        return found.half_chord - 2.0 * found.height * below / inwards

    step = _STEP * deep
    first = next((offset + n * step for n in range(_STEPS) if excess(offset + n * step) > 0.0), None)
    if first is None:
        message = f"no parabola from the load touches the fillet of the {('pinion', 'wheel')[gear]}; give other teeth"
        raise DesignError([Problem("tooth", message)])
    return fillet(root_between(excess, first - step, first))


def stress_correction(fillet: Fillet, radius: float, pressure_angle: float) -> float:
    """Return the stress concentration and correction factor Y_f [-].

    Args:
        fillet: The weakest section.
        radius: Least radius of the fillet r_mf [m].
        pressure_angle: α_n [rad].

    Source: ANSI/AGMA 2003-D19, eqs C.96 to C.100, after Dolan and Broghamer 1942; at 20° 0.18, 0.15 and 0.45.
    """
    degrees = math.degrees(pressure_angle)
    constant, by_radius = 0.3254545 - 0.0072727 * degrees, 0.3318182 - 0.0090909 * degrees
    by_height = 0.2681818 + 0.0090909 * degrees
    chord = 2.0 * fillet.half_chord
    return float(constant + (chord / radius) ** by_radius * (chord / fillet.height) ** by_height)


def effective_face(section: MeanSection, load: LoadPoint, height: float) -> float:
    """Return the part of the face over which the root bears the load b′/b [-].

    Args:
        section: Mean section of the pair.
        load: Where the load is put.
        height: Of the load above the weakest section h_N [m].

    Source: ANSI/AGMA 2003-D19, eqs C.106 to C.116; neither end of the line is spread beyond the tooth.
    """
    width, lean = section.bevel.face_width, math.cos(section.bevel.spiral_angle)
    line = width * section.action * load.chord * section.base_cosine**2 / section.ellipse
    free = max((width - line) / lean, 0.0)
    near = max(0.5 * free - abs(load.along_face) / lean, 0.0)
    spread = math.atan(near / height) + math.atan((free - near) / height)
    return (height * lean * spread + line) / width
