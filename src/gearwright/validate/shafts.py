"""Published shafts: the countershaft of Shigley's Mechanical Engineering Design, a keyed shaft by DIN 743."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.parts.shafts import (
    Overload,
    PointLoads,
    SectionLoad,
    ShaftSection,
    ShaftSteel,
    SteelGroup,
    blank_factor,
    diagram,
    din743_safety,
    keyway_factor,
    supported,
)
from gearwright.units import INCH, POUND_FORCE
from gearwright.validate.case import Case

POUND_INCH = POUND_FORCE * INCH
BEARINGS = (0.75 * INCH, 10.75 * INCH)
LENGTH = 11.5 * INCH
_SOURCE = "Budynas & Nisbett, Shigley's Mechanical Engineering Design, example 7-2"


def countershaft() -> PointLoads:
    """Return the loads of gears 3 and 4: W_23 = (197, 540) lbf, W_54 = (885, 2431) lbf, torque 3240 lbf in."""
    force = np.array([[-197.0, -885.0], [540.0, -2431.0]]) * POUND_FORCE
    torque = np.array([3240.0, -3240.0]) * POUND_INCH
    return PointLoads(np.array([2.75, 8.50]) * INCH, force, np.zeros((2, 2)), torque)


def reactions() -> Sequence[float]:
    """Return both bearings' forces along y, then along z [lbf]."""
    forces = supported(countershaft(), BEARINGS, length=LENGTH).force[:, 2:] / POUND_FORCE
    return [float(value) for value in forces.ravel()]


def moments() -> Sequence[float]:
    """Return the resulting bending moment at gear 3, at the shoulder and at gear 4 [lbf in]."""
    drawn = diagram(supported(countershaft(), BEARINGS, length=LENGTH))
    places = np.array([2.75, 7.50, 8.50]) * INCH
    y, z = (np.interp(places, drawn.position, plane) / POUND_INCH for plane in drawn.bending)
    return [float(value) for value in np.hypot(y, z)]


_KEYED = ShaftSteel(750e6, 520e6, 375e6, 225e6, SteelGroup.TEMPERED)
"""C50 with σ_bW = 0.5 σ_B and τ_tW = 0.3 σ_B."""


def keyed_shaft() -> Sequence[float]:
    """Return β_σ, S_D and S_F of a hard shaft of 60 mm with one key, load growing at constant σ_m/σ_a."""
    notch = keyway_factor(0.060, blank_factor(0.080, _KEYED.group, yielding=False) * _KEYED.ultimate)
    safety = din743_safety(
        SectionLoad(bending_amplitude=1402.294, torque_mean=1336.902),
        ShaftSection(0.060, 0.080, notch, 25e-6, hard_surface=True),
        _KEYED,
        greatest=SectionLoad(bending_amplitude=2524.1292, torque_mean=2406.4236),
        overload=Overload.CONSTANT_RATIO,
    )
    return [notch.bending, safety.fatigue, safety.yielding]


CASES = (
    Case(
        "bearing reactions of a countershaft",
        _SOURCE,
        "lbf",
        (356.7, 725.3, 115.0, 1776.0),
        reactions,
        0.1,
        "printed to 0.1 lbf",
        is_relative=False,
    ),
    Case(
        "bending moments of a countershaft",
        _SOURCE,
        "lbf in",
        (749.0, 3651.0, 4316.0),
        moments,
        1.0,
        "printed to 1 lbf in",
        is_relative=False,
    ),
    Case(
        "β_σ, S_D and S_F of a hard shaft with a key, DIN 743, case 2",
        "Exam MEL1 2024W, problem 2 (repository hanslhansl/din743, tests/test_1.py)",
        "",
        (2.5203, 1.472, 2.568),
        keyed_shaft,
        6e-4,
        "printed to three decimals",
        is_relative=False,
    ),
)
"""Published shafts."""
