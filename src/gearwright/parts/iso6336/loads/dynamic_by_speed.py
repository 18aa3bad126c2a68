"""Dynamic factor K_V of ISO 6336-1 by method C: below resonance, by v z_1 and the tolerance class alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.parts.iso6336.geometry import MeshGeometry, Value, as_value
from gearwright.units import Origin, Quantity

_SOURCE = "ISO 6336-1:2006, clause 6, method C"
_CLASSES = tuple(float(grade) for grade in range(3, 13))
_SPUR = (2.1, 3.9, 7.5, 14.9, 26.8, 39.1, 52.8, 76.6, 102.6, 146.3)
_HELICAL = (1.9, 3.5, 6.7, 13.3, 23.9, 34.8, 47.0, 68.2, 91.4, 130.3)
_LEAST_LOAD = 100.0  # N/mm
FASTEST = 3.0
"""v z_1/100 √(u²/(1 + u²)) up to which method C is meant [m/s]: beyond, resonance asks for method B."""


@dataclass(frozen=True)
class DynamicFactorBySpeed:
    """K_V by method C with what it is made of."""

    characteristic: Annotated[Value, Quantity("velocity"), Origin("v z_1/100 √(u²/(1 + u²))", _SOURCE)]
    """Speed that stands for the distance from resonance [m/s]."""
    slope: Annotated[Value, Quantity("ratio"), Origin("K_3 = 2.071 − 0.357 v z_1/100 √(u²/(1 + u²)), 1 to 2", _SOURCE)]
    """K_3 [-]."""
    factor: Annotated[
        Value,
        Quantity("ratio"),
        Origin("K_V = 1 + (K_1/(K_A F_t/b) + K_2) v z_1/100 K_3 √(u²/(1 + u²))", _SOURCE),
    ]
    """Dynamic factor K_V [-]."""


def dynamic_factor_by_speed(
    mesh: MeshGeometry, grade: Value, *, specific_load: Value, speed: Value
) -> DynamicFactorBySpeed:
    """Return K_V of a mesh by method C.

    Args:
        mesh: The pair.
        grade: Flank tolerance class, 3 to 12; finer ones count as 3 [-].
        specific_load: F_t K_A K_γ / b, at least 100 N/mm [N/m].
        speed: Pitch-line velocity v [m/s].

    Source: ISO 6336-1:2006, clause 6, method C: K_1 by class, K_2 = 0.0193 (spur) or 0.0087 (ε_β ≥ 1), straight between
        them in ε_β; K_3 is 2 up to 0.2 m/s and falls to 1 at 3 m/s, where DIN 3990-1:1987 has none.
    Valid for: steel, v z_1/100 √(u²/(1 + u²)) < 3 m/s.

    >>> spur = MeshGeometry((20, 60), 2e-3, 0.02, 0.08, (0.022, 0.062))
    >>> k = dynamic_factor_by_speed(spur, 6, specific_load=2e5, speed=5.0)
    >>> round(float(k.factor), 4)  # x = 0.9487 m/s, K_3 = 1.7323: 1 + (14.9/200 + 0.0193) 1.6434
    1.1542
    """
    lever = np.abs(mesh.ratio) / np.sqrt(1.0 + mesh.ratio**2)
    place = speed * mesh.teeth[0] / 100.0 * lever
    slope = np.clip(2.071 - 0.357 * place, 1.0, 2.0)
    load = np.maximum(specific_load / 1e3, _LEAST_LOAD)
    rises = (
        np.interp(grade, _CLASSES, constants) / load + size for constants, size in ((_SPUR, 0.0193), (_HELICAL, 0.0087))
    )
    spur, helical = (1.0 + rise * place * slope for rise in rises)
    overlap = np.minimum(mesh.overlap_ratio, 1.0)
    return DynamicFactorBySpeed(as_value(place), as_value(slope), as_value(spur - overlap * (spur - helical)))
