"""Spur gears of nitrided steel rated by hand, with formulas of ISO 6336 and nothing of the product: N, mm, µm, rpm.

Class 5, no helix modification, R_z 4 µm, no relief but that of running in, K_A = K_γ = 1, no profile shift, b = 10 m.
"""

from math import acos, cos, hypot, inf, log, pi, radians, sin, sqrt, tan
from typing import NamedTuple

ANGLE = radians(20.0)
MODULUS, DENSITY = 210e3, 7.85e-6
"""E [N/mm²] and ρ [kg/mm³] of the nitriding steel; formulas of ISO 6336 take 206 000 for steel."""
FLANK, ROOT = 1250.0, 420.0
"""σ_Hlim and σ_Flim of nitriding steel, MQ [N/mm²] (ISO 6336-5, table 1)."""


class Pair(NamedTuple):
    """Two gears; of a ring z is negative."""

    teeth: tuple[int, int]
    module: float
    mates: tuple[float, float]
    """Equal meshes that move each gear together; 0 of one that is held."""
    inside: tuple[float, float]
    """Bore or inside of the rim of each."""
    paths: int = 1
    """Meshes that twist the first gear."""

    @property
    def width(self) -> float:
        return 10.0 * self.module

    @property
    def diameters(self) -> tuple[float, float]:
        return self.teeth[0] * self.module, abs(self.teeth[1]) * self.module

    @property
    def tips(self) -> tuple[float, float]:
        """tan α_a of both."""
        first, second = self.teeth
        return tuple(sqrt(((z + 2.0) / (z * cos(ANGLE))) ** 2 - 1.0) for z in (first, second))

    @property
    def contact_ratio(self) -> float:
        return sum(z / (2.0 * pi) * (tip - tan(ANGLE)) for z, tip in zip(self.teeth, self.tips, strict=True))


class Loads(NamedTuple):
    """K_V, K_Hβ, K_Fβ, K_Hα, K_Fα, and N."""

    dynamic: float
    face: float
    face_root: float
    transverse: float
    transverse_root: float
    speed: float


def planet_inside(teeth: int, module: float) -> float:
    """0.66 d of the raceway, unless a rim of 1.2 tooth heights is thicker."""
    return min(0.66 * teeth, teeth - 2.0 * (1.25 + 1.2 * 2.25)) * module


def loads_by_hand(pair: Pair, force: float, speed: float) -> Loads:
    """ISO 6336-1, clauses 6 to 9; speed of the first gear against the carrier [rpm]."""
    m, b, (d1, _), total = pair.module, pair.width, pair.diameters, pair.contact_ratio
    line, internal = force / b, pair.teeth[1] < 0
    small, large = sorted(map(abs, pair.teeth))
    flexibility = 0.04723 + 0.15551 / small + (0.0 if internal else 0.25791 / large)
    single = 0.8 * (1.0 + 0.5 * (1.2 - 1.25)) * MODULUS / 206e3 / flexibility * min(1.0, line / 100.0) ** 0.25
    mean = single * (0.75 * total + 0.25)
    lightness = 0.0
    for d, sign, mates, inside in zip(pair.diameters, (1, -1 if internal else 1), pair.mates, pair.inside, strict=True):
        middle = d - sign * 0.25 * m
        mass = pi / 8.0 * DENSITY * middle**4 / (d * cos(ANGLE)) ** 2 * (1.0 - (inside / middle) ** 4)
        lightness += mates / mass
    ratio = speed * pi * pair.teeth[0] / 30e3 / sqrt(mean * lightness)
    pitch = max(0.001 * d + 0.4 * m + 5.0 for d in pair.diameters) * cos(ANGLE)
    form = 0.55 * m + 5.0
    pitch, form = pitch - min(0.075 * pitch, 3.0), form - min(0.075 * form, 3.0)
    relief = (FLANK / 97.0 - 18.45) ** 2 / 18.0 + 1.5
    terms = single * pitch / line, single * form / line, abs(1.0 - single * relief / line)

    def summed(*factors: float) -> float:
        return sum(factor * term for factor, term in zip(factors, terms, strict=False))

    assert 1.5 < total < 2.0
    near, far = 1.0 + summed(0.32, 0.34, 0.90), summed(0.47, 0.47) + 0.125 * sin(pi * (total - 2.0)) + 0.875
    begins = 0.5 + 0.35 * sqrt(min(line, 100.0) / 100.0)
    if ratio <= begins:
        dynamic = 1.0 + ratio * summed(0.32, 0.34, 0.23)
    else:
        dynamic = far + (near - far) * min(max((1.5 - ratio) / 0.35, 0.0), 1.0)
    shaken = line * dynamic
    bent = 0.023 * 206e3 / MODULUS * shaken * (abs(2.0 * pair.paths - 1.0 - 0.3) + 0.3) * (b / d1) ** 2
    askew = 1.33 * bent + hypot(*(0.05 * sqrt(d) + 0.35 * sqrt(b) + 4.0 for d in pair.diameters))
    uneven = (askew - min(0.15 * askew, 6.0)) * 0.85 * mean / (2.0 * shaken)
    face = 1.0 + uneven if uneven <= 1.0 else 2.0 * sqrt(uneven)
    slender = b / (2.25 * m)
    across = 0.5 * total * (0.9 + 0.4 * mean * pitch / (shaken * face))
    return Loads(
        dynamic, face, face ** (slender**2 / (1.0 + slender + slender**2)),
        min(max(across, 1.0), 3.0 / (4.0 - total)), min(max(across, 1.0), total / (0.25 * total + 0.75)), ratio,
    )  # fmt: skip


def flank_by_hand(pair: Pair, force: float, speed: float) -> float:
    """σ_H over σ_Hlim Z_L Z_v Z_R of the first gear of an external pair, ISO 6336-2; ν_40 100 mm²/s."""
    loads, total, (d1, d2) = loads_by_hand(pair, force, speed), pair.contact_ratio, pair.diameters
    steps = [2.0 * pi / z for z in pair.teeth]
    inner = tan(ANGLE) / sqrt((pair.tips[0] - steps[0]) * (pair.tips[1] - (total - 1.0) * steps[1]))
    nominal = sqrt(2.0 / (cos(ANGLE) * sin(ANGLE)) * MODULUS / (2.0 * pi * 0.91) * (4.0 - total) / 3.0)
    nominal *= sqrt(force / (d1 * pair.width) * (1.0 + d1 / d2))
    stress = max(inner, 1.0) * nominal * sqrt(loads.dynamic * loads.face * loads.transverse)
    oil = 0.91 + 4.0 * 0.09 / (1.2 + 134.0 / 100.0) ** 2
    fast = 0.93 + 2.0 * 0.07 / sqrt(0.8 + 32.0 / (pi * d1 * speed / 60e3))
    curved = 0.5 * sin(ANGLE) * d1 * d2 / (d1 + d2)
    rough = (3.0 / (4.0 * (10.0 / curved) ** (1.0 / 3.0))) ** 0.08
    return stress / (FLANK * oil * fast * rough)


def root_by_hand(pair: Pair, gear: int, force: float, speed: float, *, bent_back: float, rim: float = inf) -> float:
    """σ_F over σ_FE Y_δrelT Y_RrelT Y_M of a gear, ISO 6336-3:2019; the rim below the roots over the module."""
    z, loads, side = pair.teeth[gear], loads_by_hand(pair, force, speed), 1.0 if pair.teeth[gear] > 0 else -1.0
    opening, other, along = (pi / 3.0, sqrt(3.0), 1.0) if side > 0.0 else (pi / 6.0, 1.0, sqrt(3.0))
    corner = pi / 4.0 - 1.25 * tan(ANGLE) - (1.0 - sin(ANGLE)) * 0.38 / cos(ANGLE)
    drop, turned = 0.38 - 1.25, 2.0 / z * (pi / 2.0 - corner) - opening
    theta = pi / 6.0
    for _ in range(100):
        theta = 2.0 * drop / z * tan(theta) - turned
    offset = drop / cos(theta) - 0.38
    chord = z * sin(opening - theta) + other * offset
    fillet = 0.38 + 2.0 * drop**2 / (cos(theta) * (z * cos(theta) ** 2 - 2.0 * drop))
    base = abs(z) * cos(ANGLE)
    reach = sqrt((abs(z) + side * 2.0) ** 2 - base**2) / 2.0 - side * pi * cos(ANGLE) * (pair.contact_ratio - 1.0)
    at = 2.0 * sqrt(reach**2 + base**2 / 4.0)
    half = pi / 2.0 / z + tan(ANGLE) - ANGLE - tan(acos(base / at)) + acos(base / at)
    slant = acos(base / at) - half
    lever = 0.5 * ((cos(half) - sin(half) * tan(slant)) * side * at - z * cos(opening - theta) - along * offset)
    form, slim, notch = 6.0 * lever * cos(slant) / (chord**2 * cos(ANGLE)), chord / lever, chord / (2.0 * fillet)
    correction = (1.2 + 0.13 * slim) * notch ** (1.0 / (1.21 + 2.3 / slim))
    thin = max(1.0, 1.15 * log(8.324 / rim)) if rim < inf else 1.0
    stress = force / (pair.width * pair.module) * form * correction * thin
    stress *= loads.dynamic * loads.face_root * loads.transverse_root
    sensitive = (1.0 + sqrt(0.1005 * 0.2 * (1.0 + 2.0 * notch))) / (1.0 + sqrt(0.1005 * 1.2))
    rough = 4.299 - 3.259 * (10.0 + 1.0) ** 0.0058
    return stress / (2.0 * ROOT * sensitive * rough * 0.7 / (0.7 + 0.3 * bent_back))


def cycles_of_flank(ratio: float) -> float:
    """Nitrided: 1.3 at 1e5, 1 at 2e6, 0.85 at 1e10 cycles (ISO 6336-2, table 2)."""
    return 2e6 * ratio ** -(log(20.0) / log(1.3) if ratio > 1.0 else log(5e3) / -log(0.85))


def cycles_of_root(ratio: float) -> float:
    """Nitrided: 1.6 at 1e3, 1 at 3e6, 0.85 at 1e10 cycles (ISO 6336-3, table 1)."""
    return 3e6 * ratio ** -(log(3e3) / log(1.6) if ratio > 1.0 else log(1e10 / 3e6) / -log(0.85))
