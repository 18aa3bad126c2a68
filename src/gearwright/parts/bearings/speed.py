"""What a rolling bearing must bear so as not to skid, and how fast it may turn."""

from __future__ import annotations

import math
from types import MappingProxyType
from typing import Literal, NamedTuple

from gearwright.parts.bearings.rolling_bearing import BearingKind
from gearwright.units import RPM

REFERENCE_VISCOSITY = 12e-6
"""Of the oil of the reference conditions at 70 °C, radial bearings [m²/s] (ISO 15312)."""
REFERENCE_LOAD = 0.05
"""Radial load of the reference conditions over C_0 [-] (ISO 15312)."""
_HEAT_FLOW, _WIDEST = 0.016e6, 0.05
"""Reference heat flow density [W/m²] up to a surface [m²] (ISO 15312), from which on it falls."""
_FALL = -0.34
_ROUNDS = 80


Lubrication = Literal["grease", "jet", "under-race"]
"""How oil comes to a bearing: packed with grease, by jets from the side, or through its inner ring."""


class SpeedLimit(NamedTuple):
    """What n d_m a kind of bearing bears [mm/min]."""

    usual: float
    """Without more ado."""
    careful: float
    """With a cage guided on lands, accurate parts, clean and cool oil."""


SPEED_LIMITS = MappingProxyType(
    {
        ("grease", "ball"): SpeedLimit(0.5e6, 0.7e6),
        ("grease", "roller"): SpeedLimit(0.3e6, 0.5e6),
        ("grease", "taper"): SpeedLimit(0.3e6, 0.5e6),
        ("jet", "ball"): SpeedLimit(1.2e6, 1.8e6),
        ("jet", "roller"): SpeedLimit(1.0e6, 1.5e6),
        ("jet", "taper"): SpeedLimit(0.5e6, 0.8e6),
        ("under-race", "ball"): SpeedLimit(2.0e6, 3.0e6),
        ("under-race", "roller"): SpeedLimit(2.0e6, 3.0e6),
        ("under-race", "taper"): SpeedLimit(1.0e6, 2.4e6),
    }
)
"""Lubrication and what rolls -> limits; of taper rollers under the races with oil to their rib, too."""


def speed_limit(kind: BearingKind, lubrication: Lubrication) -> SpeedLimit:
    """Return the n d_m that a bearing bears [mm/min].

    Args:
        kind: Of bearing [-].
        lubrication: How oil comes to it [-].

    Source: usual speeds of makers' catalogues, oil or grease of the trade; oil under the races after tests of NASA
        with ball and roller (to 3e6) and taper bearings with fed ribs (to 2.4e6). Estimates: the maker says better.
    """
    rolls = "ball" if kind.is_ball else "taper" if kind is BearingKind.TAPER else "roller"
    return SPEED_LIMITS[lubrication, rolls]


def least_load(rating: float, kind: BearingKind) -> float:
    """Return the load below which rolling elements may skid [N].

    Args:
        rating: C [N].
        kind: Of bearing [-].

    Source: general rule of makers' catalogues (SKF, Rolling bearings, requisite minimum load): 0.01 C for ball, 0.02 C
        for roller bearings.

    >>> least_load(60e3, BearingKind.CYLINDRICAL)
    1200.0
    """
    return (0.01 if kind.is_ball else 0.02) * rating


def speed_factor(speed: float, bore: float, outer_diameter: float) -> float:
    """Return the speed factor n d_m [mm/min].

    Args:
        speed: [rad/s].
        bore: d [m].
        outer_diameter: D [m].

    Source: n (d + D)/2 in 1/min and mm, as makers' catalogues have it.
    """
    return abs(speed) / RPM * 1e3 * (bore + outer_diameter) / 2.0


def reference_heat(bore: float, outer_diameter: float, width: float) -> float:
    """Return the heat that a radial bearing gives off under reference conditions [W].

    Args:
        bore: d [m].
        outer_diameter: D [m].
        width: B [m].

    Source: ISO 15312:2003: q_r A_r, A_r = π B (D + d), q_r = 0.016 W/mm² up to 50 000 mm², then falling by
        (A_r/50 000)^-0.34.
    """
    surface = math.pi * width * (outer_diameter + bore)
    return _HEAT_FLOW * surface * math.pow(max(surface / _WIDEST, 1.0), _FALL)


def thermal_reference_speed(
    bore: float, outer_diameter: float, width: float, *, static_rating: float, oil_factor: float, load_factor: float
) -> float:
    """Return the speed at which a radial bearing warms to 70 °C under reference conditions [rad/s].

    Args:
        bore: d [m].
        outer_diameter: D [m].
        width: B [m].
        static_rating: C_0 [N].
        oil_factor: f_0r of its series [-].
        load_factor: f_1r of its series [-].

    Source: ISO 15312:2003: π n/(30·10³) (1e-7 f_0r (ν_r n)^(2/3) d_m³ + f_1r P_1r d_m) = q_r A_r, with 12 mm²/s, 5 %
        of C_0 and 20 °C around.

    Valid for: oil bath or circulating oil at 70 °C; oil that carries heat away allows more.
    """
    heat, diameter = reference_heat(bore, outer_diameter, width), 1e3 * (bore + outer_diameter) / 2.0
    loaded = 1e-3 * load_factor * REFERENCE_LOAD * static_rating * diameter
    idle = 1e-10 * oil_factor * (REFERENCE_VISCOSITY * 1e6 / RPM) ** (2.0 / 3.0) * diameter**3
    speed = (heat / idle) ** 0.6  # without load, hence from above
    for _ in range(_ROUNDS):  # Newton on a convex function
        excess = speed * (idle * speed ** (2.0 / 3.0) + loaded) - heat
        step = excess / (5.0 / 3.0 * idle * speed ** (2.0 / 3.0) + loaded)
        speed -= step
        if step < 1e-13 * speed:
            break
    return float(speed)
