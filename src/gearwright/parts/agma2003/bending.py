"""The bending strength geometry factor J of bevel gears by annex C of ANSI/AGMA 2003."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.parts.agma2003.section import SOURCE, MeanSection, root_between
from gearwright.parts.bevel import mean_thickness
from gearwright.parts.gears import involute
from gearwright.units import Origin, Quantity

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
class BendingGeometry:
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


def bending_geometry(section: MeanSection, gear: int) -> BendingGeometry:
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
    return BendingGeometry(
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
