"""Published statistics of gearbox mass."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.units import RPM
from gearwright.validate.case import Case
from gearwright.weights import mass_afdd00, refit, scores, willis

INCH_POUND = 0.112984829
"""[N m]"""
PSI = 6894.757293
"""[Pa]"""


def _afdd00() -> Sequence[float]:
    return [mass_afdd00(1e3, RPM, RPM)]


def _willis() -> Sequence[float]:
    return [willis.mass_willis(INCH_POUND, 1.0, k_factor=PSI)]


def _refit() -> Sequence[float]:
    line = refit()
    return [line.slope, line.intercept]


def _line() -> Sequence[float]:
    score = next(score for score in scores() if score.method.key == "tm215680")
    return [value for value in (score.bias, score.scatter) if value is not None]


CASES = (
    Case("AFDD00 at 1 kW and 1 rpm", "Pulvirenti 2023, eq. 1.1", "kg", (54.6311,), _afdd00, 4e-6, "six digits printed"),
    Case("Willis in kilograms", "Pulvirenti 2023, eq. 1.6", "kg psi/(lb in)", (0.2268,), _willis, 5e-5,
         "four digits printed", is_relative=False),
    Case("refit of real gearboxes: slope and intercept", "AeroSandbox, studies/GearboxMassFits", "",
         (1.0445171124733774, 2.0083615496306910), _refit, 1e-12, "the same points, all digits"),
    Case("line of the report on its own weights: bias and scatter", "NASA/TM-2009-215680", "", (0.952, 1.251), _line,
         1e-3, "three digits are given", is_relative=False),
)  # fmt: skip
"""Published statistics."""
