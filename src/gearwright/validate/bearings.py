"""Published rolling bearings: rating factors of ISO 281 and ISO 76, lives of a catalogue and of a program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

from gearwright.parts.bearings import (
    BearingGeometry,
    BearingKind,
    RingLoad,
    ball_dynamic_factor,
    ball_static_factor,
    basic_life,
    basic_reference_life,
    life_time,
    load_distribution,
    roller_dynamic_factor,
)
from gearwright.units import RPM
from gearwright.validate.case import Case

BALL_FACTORS = (
    29.1, 35.8, 40.3, 43.8, 46.7, 49.1, 51.1, 52.8, 54.3, 55.5, 56.6, 57.5, 58.2, 58.8, 59.3, 59.6, 59.8, 59.9, 60.0,
    59.9, 59.8, 59.6, 59.3, 59.0, 58.6, 58.2, 57.7, 57.1, 56.6, 56.0, 55.3, 54.6, 53.9, 53.2, 52.4, 51.7, 50.9, 50.0,
    49.2, 48.4,
)  # fmt: skip
"""f_c of ISO 281:2007, table 2, single row radial contact, at D_w cos α/D_pw = 0.01, 0.02 ... 0.40."""
ROLLER_FACTORS: Mapping[float, float] = {
    0.01: 52.1, 0.02: 60.8, 0.03: 66.5, 0.04: 70.7, 0.05: 74.1, 0.06: 76.9, 0.07: 79.2, 0.08: 81.2, 0.09: 82.8,
    0.10: 84.2, 0.12: 86.4, 0.14: 87.7, 0.16: 88.5, 0.18: 88.8, 0.20: 88.7, 0.22: 88.2, 0.24: 87.5, 0.26: 86.4,
    0.28: 85.2, 0.30: 83.8,
}  # fmt: skip
"""D_w cos α/D_pw -> f_c of ISO 281:2007, table 7."""
STATIC_FACTORS = (
    14.9, 15.1, 15.3, 15.5, 15.7, 15.9, 16.1, 16.3, 16.5, 16.4, 16.1, 15.9, 15.6, 15.4, 15.2, 14.9, 14.7, 14.4, 14.2,
    14.0, 13.7, 13.5, 13.2, 13.0, 12.8, 12.5, 12.3, 12.1, 11.8, 11.6,
)  # fmt: skip
"""f_0 of ISO 76:2006, table 1, radial contact, at D_w cos α/D_pw = 0.01, 0.02 ... 0.30."""
REFERENCE = BearingGeometry(BearingKind.DEEP_GROOVE, 7, 11.5e-3, 43.5e-3)
"""Z = 7, D_w = 11.5, D_pw = 43.5 mm."""
REFERENCE_RATING = 23.4e3
"""C [N]."""
REFERENCE_LIVES: Mapping[str, tuple[float, RingLoad, float]] = {
    "radial, no clearance": (0.0, RingLoad(x=1000.0), 13163.019),
    "axial, no clearance": (0.0, RingLoad(axial=1000.0), 2222.7318),
    "radial": (10e-6, RingLoad(x=1000.0), 10795.7948),
    "axial": (10e-6, RingLoad(axial=1000.0), 3115.8781),
    "both": (10e-6, RingLoad(x=1000.0, axial=1000.0), 1630.5367),
    "couple, no clearance": (0.0, RingLoad(moment_y=1.0), 785144.7521),
    "all": (10e-6, RingLoad(x=1000.0, axial=1000.0, moment_y=1.0), 1627.7479),
}
"""Load -> radial clearance [m], load, basic reference life [10⁶ turns]."""


def inside(kind: BearingKind, ratio: float) -> BearingGeometry:
    """Return rolling elements of a given D_w/D_pw.

    Args:
        kind: Of bearing.
        ratio: D_w/D_pw [-].
    """
    return BearingGeometry(kind, 8, 0.1 * ratio, 0.1, roller_length=0.01)


def _balls() -> Sequence[float]:
    steps = range(1, len(BALL_FACTORS) + 1)
    return [ball_dynamic_factor(inside(BearingKind.DEEP_GROOVE, step / 100)) for step in steps]


def _rollers() -> Sequence[float]:
    return [roller_dynamic_factor(inside(BearingKind.CYLINDRICAL, ratio)) for ratio in ROLLER_FACTORS]


def _static() -> Sequence[float]:
    steps = range(1, len(STATIC_FACTORS) + 1)
    return [ball_static_factor(inside(BearingKind.DEEP_GROOVE, step / 100)) for step in steps]


def _reference_life(clearance: float, load: RingLoad) -> Sequence[float]:
    distribution = load_distribution(REFERENCE, load, clearance=clearance)
    return [basic_reference_life(REFERENCE, REFERENCE_RATING, distribution.force)]


def _catalogue_life() -> Sequence[float]:
    return [basic_life(55.3e3, 10e3, BearingKind.DEEP_GROOVE)]


def _catalogue_hours() -> Sequence[float]:
    return [life_time(_catalogue_life()[0], 3000.0 * RPM) / 3600.0]


CASES = (
    Case("dynamic factor f_c of balls", "ISO 281:2007, table 2", "", BALL_FACTORS, _balls, 0.05,
         "printed to 0.1", is_relative=False),
    Case("dynamic factor f_c of rollers", "ISO 281:2007, table 7", "", tuple(ROLLER_FACTORS.values()), _rollers, 0.05,
         "printed to 0.1", is_relative=False),
    Case("static factor f_0 of balls", "ISO 76:2006, table 1", "", STATIC_FACTORS, _static, 0.054,
         "printed to 0.1; one value is 0.003 beyond half a digit", is_relative=False),
    *(
        Case(f"reference life, {name}", "MASTA, in minzhun/ISO16281; ISO/TS 16281", "10⁶", (life,),
             partial(_reference_life, clearance, load), 2e-3, "another arm of the tilt, 1.05 % shorter")
        for name, (clearance, load, life) in REFERENCE_LIVES.items()
    ),
    Case("basic life of a 6309, C = 55.3 kN, P = 10 kN", "SKF, Rolling bearings", "10⁶", (169.0,), _catalogue_life, 0.5,
         "three digits", is_relative=False),
    Case("the same at 3000 rpm", "SKF, Rolling bearings", "h", (940.0,), _catalogue_hours, 1.0, "three digits",
         is_relative=False),
)  # fmt: skip
"""Published bearings."""
