"""Standard parts and fits: keys, lock nuts, retaining rings, shaft seals, undercuts, centre holes.

Rolling bearings and materials are beside this folder; what parts bear is computed in `parts/joints`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from types import MappingProxyType
from typing import Literal, NamedTuple

from gearwright.base import DesignError, Force, Length, Mass, Problem, Velocity, near
from gearwright.catalogue.tables import data_rows
from gearwright.parts.bearings import BearingKind
from gearwright.parts.shafts import KeySection

# ----------------------------------------------------------------------------------------------------------------------
# Limits and fits of ISO 286 for seats on shafts, and the tolerance classes that bearing seats usually take.
# ----------------------------------------------------------------------------------------------------------------------


SMALLEST, LARGEST = 0.006, 3.150
"""Sizes that the table covers: above the first, up to the second [m]."""
LARGEST_M6 = 0.100
"""Bore of roller bearings up to which m6 is usual, n6 above [m]."""
SEAT_SOURCE = "rotating load on the inner ring, normal load: DIN 5425-1"
"""Where the tolerance classes of bearing seats come from."""


@cache
def _fit_ranges() -> tuple[dict[str, float], ...]:
    """Return the table of ISO 286-1: ranges in mm, grades and lower deviations in µm."""
    return tuple({name: float(value) for name, value in row.items()} for row in data_rows("limits_and_fits.csv"))


def _range(diameter: float) -> dict[str, float]:
    for row in _fit_ranges():
        if row["over_mm"] < 1e3 * diameter <= row["to_mm"] + 1e-9:
            return row
    message = f"{1e3 * diameter:.4g} mm given; the table holds above 6 up to 3150 mm"
    raise DesignError([Problem("diameter", message)])


def standard_tolerance(diameter: float, grade: int) -> Length:
    """Return the width of a standard tolerance grade [m] (ISO 286-1:2010, table 1).

    Args:
        diameter: Nominal size [m].
        grade: Of IT5 to IT11 [-].

    Raises:
        DesignError: If the table has no such size or grade.

    >>> round(1e6 * standard_tolerance(0.060, 6))
    19
    """
    return 1e-6 * _entry(_range(diameter), f"IT{grade}_um")


def shaft_limits(diameter: float, tolerance_class: str) -> tuple[Length, Length]:
    """Return lower and upper limit deviation of a shaft [m] (ISO 286-1:2010, tables 1 and 5).

    Args:
        diameter: Nominal size [m].
        tolerance_class: Such as ``k6``; letters h, k, m, n and p, with grades 5 to 7 for k.

    Raises:
        DesignError: If the table has no such size or class.

    Source: p up to 180 mm: Narayana, Kannaiah, Venkata Reddy, Machine Drawing, table 15.2; above 500 mm: DME, Mold
        Bases & Plates 2020, table 5; between them from memory, IT7 and 4 to 5 µm more as beside it.

    >>> tuple(round(1e6 * limit) for limit in shaft_limits(0.060, "m6"))
    (11, 30)
    """
    letter, row = tolerance_class[:1], _range(diameter)
    width = 1e-6 * _entry(row, f"IT{tolerance_class[1:]}_um")
    if letter == "h":
        return -width, 0.0
    low = 1e-6 * _entry(row, f"{letter}_um")
    return low, low + width


def _entry(row: dict[str, float], name: str) -> float:
    if name not in row:
        known = [column.removesuffix("_um") for column in row if column.endswith("_um")]
        raise DesignError([Problem("tolerance", f"the table has no {name.removesuffix('_um')}; {near(name, known)}")])
    return row[name]


def seat_tolerance(kind: BearingKind, bore: float) -> str:
    """Return the usual tolerance class of a shaft under an inner ring that turns with its load.

    Args:
        kind: Of the bearing.
        bore: d [m].

    Returns:
        k6 for balls; m6 for rollers, n6 above 100 mm (`SEAT_SOURCE`).
    """
    if kind.is_ball:
        return "k6"
    return "m6" if bore <= LARGEST_M6 + 1e-9 else "n6"


# ----------------------------------------------------------------------------------------------------------------------
# Fits of gears: tooth thicknesses by DIN 3967, centre distances by DIN 3964, as designs and drawings name them.
# ----------------------------------------------------------------------------------------------------------------------


SERIES = ("a", "ab", "b", "bc", "c", "cd", "d", "e", "f", "g", "h")
"""Series of upper allowances, the thinnest teeth first (DIN 3967:1978, table 1)."""
TOLERANCES = tuple(range(21, 31))
"""Series of tolerances of tooth thickness, the finest first (DIN 3967:1978, table 2)."""
THICKNESS_FITS: Mapping[str, tuple[str, int]] = MappingProxyType(
    {f"{series}{tolerance}": (series, tolerance) for series in SERIES for tolerance in TOLERANCES}
)
"""Fit as it is written, such as ``cd25`` -> its two series."""
CENTRE_FITS: Mapping[str, int] = MappingProxyType({f"js{grade}": grade for grade in range(5, 12)})
"""Fit of a centre distance as it is written -> grade of ISO 286 (DIN 3964:1980)."""


@cache
def _tooth_thickness_ranges() -> tuple[dict[str, float], ...]:
    """Return DIN 3967's tables: ranges of reference diameters in mm, allowances and tolerances in µm."""
    return tuple({name: float(value) for name, value in row.items()} for row in data_rows("tooth_thickness.csv"))


def thickness_allowances(diameter: float, fit: str) -> tuple[Length, Length]:
    """Return lower and upper allowance of the normal tooth thickness, E_sni and E_sns [m].

    Args:
        diameter: Reference diameter d [m].
        fit: Such as ``cd25``.

    Raises:
        DesignError: If the tables do not reach so far.

    Source: DIN 3967:1978, tables 1 and 2; E_sni = E_sns − T_sn.

    >>> low, high = thickness_allowances(0.100, "cd27")
    >>> round(1e6 * low), round(1e6 * high)
    (-170, -70)
    """
    series, tolerance = THICKNESS_FITS[fit]
    for row in _tooth_thickness_ranges():
        if 1e3 * diameter <= row["to_mm"] + 1e-9:
            upper = 1e-6 * row[f"{series}_um"]
            return upper - 1e-6 * row[f"T{tolerance}_um"], upper
    message = f"{diameter:.4g} m given; tooth thickness allowances (DIN 3967) hold up to 10 m"
    raise DesignError([Problem("diameter", message)])


def centre_allowance(distance: float, fit: str) -> Length:
    """Return by how much a centre distance may be larger or smaller, A_a [m].

    Args:
        distance: a_w [m].
        fit: Such as ``js7``.

    Source: DIN 3964:1980: half the standard tolerance of ISO 286-1 to either side.

    >>> round(1e6 * centre_allowance(0.052, "js7"))
    15
    """
    return 0.5 * standard_tolerance(distance, CENTRE_FITS[fit])


# ----------------------------------------------------------------------------------------------------------------------
# Parallel keys of DIN 6885-1, form A and B, high.
# ----------------------------------------------------------------------------------------------------------------------


LENGTHS = tuple(
    length / 1e3
    for length in (
        6, 8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 32, 36, 40, 45, 50, 56, 63, 70, 80, 90, 100, 110, 125, 140, 160, 180,
        200, 220, 250, 280, 320, 360, 400,
    )
)  # fmt: skip
"""Lengths of keys [m] (DIN 6885-1:1968)."""


@dataclass(frozen=True)
class StandardKey:
    """A key section with the shafts and lengths for which it is made."""

    over: Length
    """Shaft diameters above this [m]."""
    to: Length
    """Shaft diameters up to this [m]."""
    section: KeySection
    """b, h, t_1, t_2 [m]."""
    shortest: Length
    """Shortest length [m]."""
    longest: Length
    """Longest length [m]."""


@cache
def standard_keys() -> tuple[StandardKey, ...]:
    """Return the sections of DIN 6885-1 by shaft diameter."""
    return tuple(_key({name: float(value) / 1e3 for name, value in row.items()}) for row in data_rows("keys.csv"))


def _key(row: dict[str, float]) -> StandardKey:
    section = KeySection(row["width_mm"], row["height_mm"], row["shaft_depth_mm"], row["hub_depth_mm"])
    return StandardKey(row["over_mm"], row["to_mm"], section, row["shortest_mm"], row["longest_mm"])


def key_for_shaft(diameter: float) -> StandardKey:
    """Return the key of a shaft.

    Args:
        diameter: d [m].

    Raises:
        DesignError: If the standard has none for this diameter.
    """
    for key in standard_keys():
        if key.over < diameter - 1e-9 and diameter <= key.to + 1e-9:
            return key
    keys = standard_keys()
    message = (
        f"{1e3 * diameter:g} mm given; DIN 6885-1 has keys above {1e3 * keys[0].over:g} to {1e3 * keys[-1].to:g} mm"
    )
    raise DesignError([Problem("diameter", message)])


def keyway_tolerance(section: KeySection) -> Length:
    """Return how much deeper than t_1 a keyway in a shaft may be [m].

    Args:
        section: Of the key.

    Source: DIN 6885-1 as Berger Tools prints it (standard parts catalogue, pp. 2079 and 2080) for shafts up to 50 mm:
        0.1 mm of keys up to 6 mm wide, 0.2 mm of wider ones; 0.3 mm from 36 mm on is from memory.

    >>> round(1e3 * keyway_tolerance(key_for_shaft(0.020).section), 1)
    0.1
    """
    width = 1e3 * section.width
    return 0.1e-3 if width < 6.5 else 0.2e-3 if width < 35.0 else 0.3e-3


# ----------------------------------------------------------------------------------------------------------------------
# Where threads of shafts end: undercuts and run-outs of DIN 76, and the chamfer at their start.
# ----------------------------------------------------------------------------------------------------------------------


THREAD_TOLERANCE = "6g"
"""Tolerance class of threads for lock nuts (ISO 965-1), as makers ask for beside nuts of 5H."""
RUN_OUT = 2.5
"""x_1, turns that are not cut to their full depth, over the pitch at most [-]: DIN 76-1, usual."""
THREAD_RUN_IN = math.radians(30.0)
"""Angle of an undercut to the thread and to the seat beside it [rad]."""
CORE = 1.2269
"""d − d_3 over the pitch: depth of an external thread on the diameter [-] (ISO 68-1, root rounded with P/6.93)."""
NUT_CORE = 1.0825
"""d − D_1 over the pitch: what a nut can be slid over [-] (ISO 724)."""


@dataclass(frozen=True)
class ThreadUndercut:
    """An undercut of form A beside an external thread."""

    pitch: Length
    """P [m]."""
    below: Length
    """d − d_g, on the diameter [m]."""
    width: Length
    """g_2, with both of its flanks [m]."""
    radius: Length
    """r [m]."""

    @property
    def designation(self) -> str:
        """As drawings name it."""
        return "DIN 76 - A"


@cache
def thread_undercuts() -> tuple[ThreadUndercut, ...]:
    """Return the undercuts of external threads of ISO, by pitch.

    Source: HEIDENHAIN, CNC PILOT 4290, user's manual, 11.1.1 (undercut DIN 76, external thread); of the same maker's
        MANUALplus 4110, operation manual, 10.2, d − I.
    """
    rows = data_rows("thread_undercuts.csv")
    return tuple(ThreadUndercut(*(float(value) / 1e3 for value in row.values())) for row in rows)


def thread_undercut(pitch: float) -> ThreadUndercut:
    """Return the undercut of a thread.

    Args:
        pitch: P [m].

    Raises:
        DesignError: If the table has none of this pitch.

    >>> found = thread_undercut(1.5e-3)
    >>> round(1e3 * found.below, 3), round(1e3 * found.width, 3), round(1e3 * found.radius, 3)
    (2.3, 5.2, 0.8)
    """
    found = next((each for each in thread_undercuts() if math.isclose(each.pitch, pitch, rel_tol=1e-6)), None)
    if found is None:
        pitches = ", ".join(f"{1e3 * each.pitch:g}" for each in thread_undercuts())
        message = f"DIN 76 has no undercut for {1e3 * pitch:g} mm; it has some for {pitches} mm: take one of them"
        raise DesignError([Problem("pitch", message)])
    return found


def thread_run_out(pitch: float) -> Length:
    """Return how far turns may fade out beyond a thread, x_1 [m].

    Args:
        pitch: P [m].

    Source: DIN 76-1, usual: 2.5 P, as Fabory prints it for studs (x_1 of 2.5, 3.8 and 5 mm for P of 1, 1.5 and 2 mm).

    >>> round(1e3 * thread_run_out(1.5e-3), 2)
    3.75
    """
    return RUN_OUT * pitch


def thread_chamfer(pitch: float) -> Length:
    """Return the chamfer of 45° at the start of a thread, down to its core and up to 0.1 mm [m].

    Args:
        pitch: P [m].

    Source: (d − d_3)/2 (ISO 68-1); that a thread starts with a chamfer to its core is usual.

    >>> round(1e3 * thread_chamfer(1.5e-3), 3)
    1.0
    """
    return math.ceil(1e4 * CORE * pitch / 2.0 - 1e-9) / 1e4


# ----------------------------------------------------------------------------------------------------------------------
# Lock nuts for shafts, series KM of DIN 981, with their lock washers MB of DIN 5406, and what their threads bear.
# ----------------------------------------------------------------------------------------------------------------------


YIELD = 200e6
"""Yield strength of a nut at least [Pa]: that for which DIN 471 tells what grooves bear; makers tell none."""
EVEN = 0.5
"""Mean over largest load of the turns of a nut's thread [-], an assumption: the first turn takes the most."""


_SIZES = {10: 0, 12: 1, 15: 2, 17: 3}
"""Threads [mm] whose number is not their fifth."""


@dataclass(frozen=True)
class LockNut:
    """A nut with the washer that locks it in a slot of the shaft."""

    thread: Length
    """d [m]."""
    pitch: Length
    """P [m]."""
    face: Length
    """Outer diameter of the face that presses, d_1 [m]."""
    outer: Length
    """[m]"""
    width: Length
    """B [m]."""
    mass: Mass
    """Of the nut [kg]."""
    washer_outer: Length
    """Over its tabs before they are bent [m]."""
    washer: Length
    """Thickness of the washer [m]."""
    washer_mass: Mass
    """[kg]"""

    @property
    def designation(self) -> str:
        """Such as ``KM 6 with MB 6``."""
        bore = round(1e3 * self.thread)
        size = _SIZES.get(bore, bore // 5)
        return f"KM {size} with MB {size}"

    @property
    def cut(self) -> str:
        """Its thread, such as ``M30 x 1.5``."""
        return f"M{1e3 * self.thread:g} x {1e3 * self.pitch:g}"

    @property
    def core(self) -> Length:
        """Core diameter of the shaft's thread, d − 1.2269 P (ISO 68-1) [m]."""
        return self.thread - CORE * self.pitch

    @property
    def bore(self) -> Length:
        """What it can be slid over, D_1 = d − 1.0825 P (ISO 724) [m]."""
        return self.thread - NUT_CORE * self.pitch

    @property
    def room(self) -> Length:
        """What washer, nut and one turn of thread beyond it take along the shaft [m]."""
        return self.washer + self.width + self.pitch

    @property
    def capacity(self) -> Force:
        """What its thread bears before it is sheared off at the yield strength of the nut [N].

        F = ½ · 0.6 R_e · 7/8 π d (B − P): threads of the nut sheared at their major diameter, where 7/8 of a turn is
        metal (ISO 68-1), a turn of it run out, half of the rest borne evenly.
        """
        return EVEN * 0.6 * YIELD * 0.875 * math.pi * self.thread * (self.width - self.pitch)


@cache
def lock_nuts() -> tuple[LockNut, ...]:
    """Return the nuts KM 0 to KM 40, for threads of 10 to 200 mm, in order.

    Source: NKE, general catalogue, pp. 1004 and 1014; IBB prints the same diameters and widths up to 100 mm, NSK
        (Rolling Bearings, nuts AN and washers AW) beyond, the face of KM 29 aside (172 for 171 mm).
    """
    return tuple(_nut({name: float(cell) for name, cell in row.items()}) for row in data_rows("lock_nuts.csv"))


def _nut(row: dict[str, float]) -> LockNut:
    lengths = ("thread", "pitch", "face", "outer", "width", "washer_outer", "washer")
    return LockNut(
        **{name: row[f"{name}_mm"] / 1e3 for name in lengths},
        mass=row["mass_kg"],
        washer_mass=row["washer_mass_g"] / 1e3,
    )


def lock_nut(thread: float) -> LockNut | None:
    """Return the nut of a thread; None where the series has none of this diameter.

    Args:
        thread: d [m].

    >>> nut = lock_nut(0.030)
    >>> nut.designation, nut.cut, round(nut.capacity)
    ('KM 6 with MB 6', 'M30 x 1.5', 27214)
    """
    return next((nut for nut in lock_nuts() if abs(nut.thread - thread) < 1e-6), None)


# ----------------------------------------------------------------------------------------------------------------------
# Retaining rings for shafts of DIN 471, normal type: grooves, and what their grooves bear.
# ----------------------------------------------------------------------------------------------------------------------


GROOVE_STRESS = 200e6 / 1.2
"""Pressure that the collar of a groove bears at a yield strength of 200 N/mm² [Pa]: F_N/A_N of DIN 471, to 2 %."""
COLLAR = 3.0
"""Shaft beyond a groove over the depth of the groove, at least: n/t of DIN 471 [-]."""


@dataclass(frozen=True)
class RetainingRing:
    """A ring with the groove that it sits in."""

    shaft: Length
    """d_1 [m]."""
    groove: Length
    """d_2 [m]."""
    groove_width: Length
    """m [m]."""
    thickness: Length
    """s [m]."""

    @property
    def designation(self) -> str:
        """Such as ``DIN 471 - 30 x 1.5``."""
        return f"DIN 471 - {1e3 * self.shaft:g} x {1e3 * self.thickness:g}"

    @property
    def room(self) -> Length:
        """What groove and collar take along the shaft, m + n [m]."""
        return self.groove_width + COLLAR * (self.shaft - self.groove) / 2.0

    @property
    def capacity(self) -> Force:
        """F_N, what the groove bears at a yield strength of 200 N/mm²; stronger shafts bear more, rings too [N]."""
        return GROOVE_STRESS * math.pi / 4.0 * (self.shaft**2 - self.groove**2)


@cache
def retaining_rings() -> tuple[RetainingRing, ...]:
    """Return the rings of DIN 471 for 8 to 300 mm, beyond 100 mm those of 5 or 10 mm apart.

    Source: DIN 471:2011, d_1, d_2, m, s, as two public tables have them alike up to 100 mm; beyond, d_1, d_2 and s are
        of one (the fasteners of FreeCAD), which has the others as they are, and m is 0.15 mm more than s, as from
        50 mm on.
    """
    return tuple(
        RetainingRing(*(float(value) / 1e3 for value in row.values())) for row in data_rows("retaining_rings.csv")
    )


def retaining_ring(shaft: float) -> RetainingRing | None:
    """Return the ring of a shaft; None where the standard has none of this diameter.

    Args:
        shaft: d_1 [m].

    >>> ring = retaining_ring(0.019)
    >>> ring.designation, round(ring.capacity)
    ('DIN 471 - 19 x 1.2', 4843)
    """
    return next((ring for ring in retaining_rings() if abs(ring.shaft - shaft) < 1e-6), None)


# ----------------------------------------------------------------------------------------------------------------------
# Radial shaft seals of ISO 6194-1 (DIN 3760): sizes, and what makers let their lips bear.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Undercuts of form F at the shoulders of shafts whose seat and face are ground: DIN 509.
# ----------------------------------------------------------------------------------------------------------------------


NEAR = 1e-9
"""Diameters that differ by less are the same [m]."""


@dataclass(frozen=True)
class Undercut:
    """An undercut of form F: it goes below the seat, and behind the face."""

    over: Length
    """Seats above this diameter have it [m]."""
    to: Length
    """And up to this [m]."""
    radius: Length
    """r [m]."""
    depth: Length
    """t_1, below the seat [m]."""
    width: Length
    """f, along the seat [m]."""
    face_depth: Length
    """t_2, behind the face [m]."""

    @property
    def designation(self) -> str:
        """Such as ``DIN 509 - F 1.2 x 0.2``."""
        return f"DIN 509 - F {1e3 * self.radius:g} x {1e3 * self.depth:g}"


@cache
def undercuts() -> tuple[Undercut, ...]:
    """Return the undercuts for seats of 1.6 mm up, of the preferred radii.

    Source: DIN 509:1998, form F, r of series 1, for parts with increased fatigue strength, up to 18 mm those of usual
        stress, as an extract for teaching has them (Scribd 415623829). Up to 18 mm depth and width are also those of
        HEIDENHAIN, CNC PILOT 4290, user's manual, 11.1.3, whose radii above are the smaller ones for usual stress.
    """
    return tuple(Undercut(*(float(value) / 1e3 for value in row.values())) for row in data_rows("undercuts.csv"))


def undercut(seat: float) -> Undercut:
    """Return the undercut of a seat.

    Args:
        seat: Diameter d_1 [m].

    Raises:
        DesignError: If the standard has none of this diameter.

    >>> undercut(0.045).designation, undercut(0.060).designation
    ('DIN 509 - F 1.2 x 0.2', 'DIN 509 - F 1.6 x 0.3')
    """
    found = next((each for each in undercuts() if each.over < seat - NEAR <= each.to), None)
    if found is None:
        message = f"DIN 509 has no undercut for seats of {1e3 * seat:g} mm; above 1.6 and up to 1000 mm are, or fillets"
        raise DesignError([Problem("shafting.shoulders", message)])
    return found


# ----------------------------------------------------------------------------------------------------------------------
# Centre holes with a thread in the ends of shafts, DIN 332-2, and what a screw in them holds by its preload.
# ----------------------------------------------------------------------------------------------------------------------


PROOF_STRESS = ((16e-3, 580e6), (math.inf, 600e6))
"""Largest diameter [m] and proof stress S_p [Pa] of screws of class 8.8 (ISO 898-1)."""
PRELOAD = 0.7
"""Preload over what the proof stress bears [-]: usual for tightening by torque, an assumption."""


@dataclass(frozen=True)
class CentreHole:
    """A centre hole of form D with the thread of a screw."""

    over: Length
    """Ends of shafts above this diameter have it [m]."""
    to: Length
    """And up to this [m]."""
    thread: Length
    """d [m]."""
    pitch: Length
    """P [m]."""

    @property
    def designation(self) -> str:
        """Such as ``DIN 332 - D M12``."""
        return f"DIN 332 - D {self.screw}"

    @property
    def screw(self) -> str:
        """Such as ``M12``."""
        return f"M{1e3 * self.thread:g}"

    @property
    def preload(self) -> Force:
        """What a screw of class 8.8 clamps with, above which an end plate would part from the shaft [N].

        A_s = π/4 (d − 0.9382 P)², ISO 898-1.
        """
        area = math.pi / 4.0 * (self.thread - 0.9382 * self.pitch) ** 2
        return PRELOAD * area * next(stress for largest, stress in PROOF_STRESS if self.thread <= largest)


@cache
def centre_holes() -> tuple[CentreHole, ...]:
    """Return the centre holes for ends of 7 to 130 mm.

    Source: DIN 332-2:1983, form D. From 16 to 50 mm as Siemens prints them for ends of shafts (Flender gear units,
        catalogue MD 31.1, 2016, p. 7/2); thinner and thicker ends go on as those of electric motors usually do, for
        which no source was found.
    """
    return tuple(CentreHole(*(float(value) / 1e3 for value in row.values())) for row in data_rows("centre_holes.csv"))


def centre_hole(end: float) -> CentreHole | None:
    """Return the centre hole of a shaft's end; None of one thinner or thicker than the standard has.

    Args:
        end: Diameter [m].

    >>> centre_hole(0.038).designation, round(centre_hole(0.038).preload)  # 84.3 mm² of M12
    ('DIN 332 - D M12', 34212)
    """
    return next((hole for hole in centre_holes() if hole.over < end <= hole.to), None)
