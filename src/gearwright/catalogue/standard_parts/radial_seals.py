"""Radial shaft seals of ISO 6194-1 (DIN 3760): sizes, and what makers let their lips bear."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Literal, NamedTuple

from gearwright.catalogue.tables import data_rows
from gearwright.units import Length, Velocity

ElastomerName = Literal["nbr", "fkm"]
"""Of a lip: nitrile rubber or fluoro rubber (ISO 1629)."""
DEEPER = 0.3e-3
"""Depth of the bore in the housing beyond the width of a seal with a metal insert, at least [m]: SKF."""
HARDNESS = 45.0
"""Of the surface on which a lip runs, at least [HRC]: Freudenberg, data sheet of the Simmerring WA."""
FAST_HARDNESS, FAST = 55.0, 4.0
"""The same from a speed [HRC, m/s], and where dirt comes near: a maker's sheet on installation (Locas)."""
ROUGHNESS = (0.2e-6, 0.8e-6)
"""Ra of that surface, least and largest [m]: the same sheet, with Rz 1 to 4 µm, and ground without lead."""
SHAFT, BORE = "h11", "H8"
"""Tolerances of shaft and bore in the housing: Freudenberg, data sheet of the Simmerring WA."""


class Elastomer(NamedTuple):
    """What a lip is made of."""

    name: ElastomerName
    mark: str
    """Of ISO 1629."""
    coldest: float
    """[°C]"""
    hottest: float
    """[°C]"""
    density: float
    """Mean of a whole seal of type A with its insert and its spring [kg/m³], in its envelope d_1, d_2, b."""


ELASTOMERS = (
    Elastomer("nbr", "NBR", -40.0, 100.0, 1600.0),
    Elastomer("fkm", "FKM", -25.0, 200.0, 1820.0),
)
"""What lips are made of, the one that lasts less heat and speed first.

Source: SKF, pages of products HMS5 RG and HMS5 V (read October 2026); densities are the means of 19 of their seals of
10 to 60 mm, whose masses differ from that by up to 20 %.
"""


@dataclass(frozen=True)
class RadialSeal:
    """The size of a seal."""

    shaft: Length
    """d_1 [m]."""
    bore: Length
    """d_2, of the bore in which it sits [m]."""
    width: Length
    """b [m]."""
    listed_by: str
    """Who lists it: ``ISO 6194-1``, ``SKF`` or both."""

    @property
    def depth(self) -> Length:
        """Least depth of the bore in which it sits [m]."""
        return self.width + DEEPER

    def designation(self, elastomer: Elastomer) -> str:
        """Return such as ``DIN 3760 - A 30 x 42 x 7 - FKM``.

        Args:
            elastomer: Of its lip.
        """
        size = " x ".join(f"{1e3 * value:g}" for value in (self.shaft, self.bore, self.width))
        return f"DIN 3760 - A {size} - {elastomer.mark}"

    def mass(self, elastomer: Elastomer) -> float:
        """Return about what it weighs [kg].

        Args:
            elastomer: Of its lip.
        """
        return elastomer.density * math.pi / 4.0 * (self.bore**2 - self.shaft**2) * self.width


@cache
def radial_seals() -> tuple[RadialSeal, ...]:
    """Return the seals for shafts of 6 to 400 mm, by shaft, then by bore.

    Source: sizes of ISO 6194-1 as GB/T 13871.1-2007, which takes them over, has them in a public table (164580.com);
        those between them that SKF lists as of ISO 6194 and DIN 3760 (pages of products, read October 2026). 25 of the
        94 sizes of the table were found on SKF's pages, too, and none otherwise.
    """
    rows = data_rows("radial_seals.csv")
    sizes = (
        (float(row["shaft_mm"]) / 1e3, float(row["bore_mm"]) / 1e3, float(row["width_mm"]) / 1e3, row["listed_by"])
        for row in rows
    )
    return tuple(RadialSeal(*size) for size in sizes)


def seals_for(shaft: float) -> tuple[RadialSeal, ...]:
    """Return the seals of a shaft's diameter, the one with the smallest bore first; none where there is no size.

    Args:
        shaft: d_1 [m].

    >>> [seal.designation(ELASTOMERS[1]) for seal in seals_for(0.030)][:2]
    ['DIN 3760 - A 30 x 42 x 7 - FKM', 'DIN 3760 - A 30 x 47 x 7 - FKM']
    """
    return tuple(seal for seal in radial_seals() if abs(seal.shaft - shaft) < 1e-6)


def next_seal_shaft(diameter: float) -> float | None:
    """Return the thinnest shaft for which there is a seal and that is not thinner; None beyond the largest [m].

    Args:
        diameter: [m].

    >>> next_seal_shaft(0.071), next_seal_shaft(0.075), next_seal_shaft(0.5)
    (0.075, 0.075, None)
    """
    return next((seal.shaft for seal in radial_seals() if seal.shaft > diameter - 1e-6), None)


def lip_speed(diameter: float, elastomer: Elastomer) -> Velocity:
    """Return the circumferential speed that a lip bears [m/s].

    Args:
        diameter: Of the shaft d_1 [m].
        elastomer: Of the lip.

    Source: SKF, pages of products HMS5 (read October 2026), 10 to 60 mm.

    Valid for: shafts of 10 to 60 mm; below, the rotational speed of 10 mm holds, beyond, the speed of 60 mm, which is
        on the safe side, as lips bear more on thicker shafts. Lips in oil, without pressure.

    >>> lip_speed(0.030, ELASTOMERS[0]), lip_speed(0.030, ELASTOMERS[1])
    (5.8, 19.5)
    """
    points = list(zip(*_speeds()[elastomer.name], strict=True))
    for (low, slower), (high, faster) in pairwise(points):
        if diameter <= high:
            return min(1.0, diameter / low) * (slower + max(diameter - low, 0.0) / (high - low) * (faster - slower))
    return points[-1][1]


@cache
def _speeds() -> dict[str, tuple[list[float], list[float]]]:
    rows = data_rows("seal_speeds.csv")
    diameters = [float(row["shaft_mm"]) / 1e3 for row in rows]
    return {one.name: (diameters, [float(row[f"{one.name}_m_s"]) for row in rows]) for one in ELASTOMERS}
