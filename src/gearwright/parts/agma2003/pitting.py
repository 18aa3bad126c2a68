"""The pitting resistance geometry factor I of bevel gears by annex C of ANSI/AGMA 2003."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated

from gearwright.parts.agma2003.section import SOURCE, MeanSection
from gearwright.units import Origin, Quantity

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
