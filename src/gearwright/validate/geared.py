"""Published geared drive lines: a ship's steam turbines through two reductions, a wind turbine's gearbox."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gearwright.dynamics import Model, modes
from gearwright.dynamics.model import Line
from gearwright.validate.case import Case

POUND_INCH = 0.11298
"""Of the publication's inertias [lb in s²] and stiffnesses [lb in/rad] -> [kg m²], [N m/rad]."""
MARINE_INERTIAS = {
    "propeller": 2.454e6,
    "bull gear": 0.826e6,
    "low pressure gear": 1.283e4,
    "low pressure turbine": 1.509e4,
    "high pressure gear": 2.723e4,
    "high pressure turbine": 2.612e2,
}
"""[lb in s²], each at its own speed."""
MARINE_SHAFTS = (
    ("propeller", 1.0, "bull gear", 826e6),
    ("bull gear", 9.4094, "low pressure gear", 203.94e6),
    ("bull gear", 9.4094, "high pressure gear", 24.17e6),
    ("low pressure gear", 40.0424 / 9.4094, "low pressure turbine", 30.51e6),
    ("high pressure gear", 78.2365 / 9.4094, "high pressure turbine", 14.26e6),
)
"""From a gear by a pinion of so many times its speed, without inertia, to what turns with it [lb in/rad]."""


def geared_shaft(model: Model, first: str, ratio: float, second: str, stiffness: float) -> None:
    """Add a shaft that a gear turns through rigid teeth.

    Args:
        model: To which.
        first: The gear.
        ratio: Speed of the shaft over the gear's [-].
        second: What turns with the shaft.
        stiffness: [N m/rad].
    """
    model.add(Line(f"{first}-{second}", {first: ratio, second: -1.0}, stiffness, kind="shaft"))


def marine_turbines() -> Sequence[float]:
    """Return the first natural frequencies of a propeller that two turbines drive by two reductions each [1/min]."""
    model = Model()
    for name, inertia in MARINE_INERTIAS.items():
        model.rotation(name, inertia=inertia * POUND_INCH)
    for first, ratio, second, stiffness in MARINE_SHAFTS:
        geared_shaft(model, first, ratio, second, stiffness * POUND_INCH)
    return [60.0 * float(value) for value in modes(model.build()).frequency[1:4]]


SHAFT, GENERATOR, RATIO = 2317025352.0, 1500.5, 50.0
"""Shaft of a wind turbine of 10 MW [N m/rad], its generator's inertia [kg m²] and its gearbox's ratio [-]."""


def wind_turbine() -> Sequence[float]:
    """Return the free drive line's frequency [Hz]; the rotor's inertia is by that with the generator held."""
    model = Model()
    model.rotation("rotor", inertia=SHAFT / (2.0 * math.pi * 0.612) ** 2)
    model.rotation("generator", inertia=GENERATOR)
    geared_shaft(model, "generator", 1.0 / RATIO, "rotor", SHAFT)
    return [float(modes(model.build()).frequency[1])]


CASES = (
    Case("marine steam turbines with two reductions each, rigid teeth",
         "Gunter & Chen 2001, Introduction to dynamics of rotor-bearing systems, example 8.1 (read in openTorsion)",
         "1/min", (177.7, 220.2, 1282.6), marine_turbines, 0.06, "printed to 0.1", is_relative=False),
    Case("wind turbine of 10 MW, free drive line",
         "Bak et al. 2013, DTU 10 MW reference wind turbine, tables 6.2 and 6.3 (read in Rebouças' Drivetrain)",
         "Hz", (4.003,), wind_turbine, 2e-3, "the 0.612 Hz that give the rotor's inertia are printed to 0.08 %"),
)  # fmt: skip
"""Published geared drive lines."""
