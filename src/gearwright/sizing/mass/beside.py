"""The sum of parts beside the statistics of real gearboxes, and what to make of a difference."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.errors import DesignError
from gearwright.ranking import largest
from gearwright.sizing.mass.record import CompleteMass
from gearwright.sizing.result import Sizing
from gearwright.units import Mass, text
from gearwright.weights import Requirement, bands, estimate, methods

_LEVEL = 0.68
"""Probability of both bands that are compared [-]."""


@dataclass(frozen=True)
class Statistics:
    """What the refit of real gearboxes says of a design's power and speeds, or why it says nothing."""

    mass: Mass | None
    """Median of its kind [kg]; None outside the range of the weights."""
    low: Mass | None
    """Lower limit of the 68 % band [kg]."""
    high: Mass | None
    """Upper limit of the 68 % band [kg]."""
    sentence: str
    """How the sum of parts stands to it."""


def requirement_of(sizing: Sizing) -> Requirement | None:
    """Return power, fastest driving and slowest driven speed of a design; None where it does not reduce speed.

    Args:
        sizing: As sized.
    """
    flow, machines = sizing.reference, sizing.design.machines
    powers = {name: power for name, power in flow.machine_powers.items() if power}
    driving = [abs(flow.speeds[machines[name].shaft]) for name, power in powers.items() if power > 0.0]
    driven = {name: -power for name, power in powers.items() if power < 0.0}
    if not driving or not driven:
        return None
    most = largest(driven, lambda name: driven[name])
    try:
        return Requirement(sizing.rated_power, max(driving), abs(flow.speeds[machines[most].shaft]))
    except DesignError:
        return None


def band_of(need: Requirement) -> tuple[float, float, float] | None:
    """Return median and 68 % limits of the refit [kg]; None outside the range of its weights.

    Args:
        need: Power and speeds.
    """
    refit = estimate(next(method for method in methods() if method.key == "refit"), need)
    if refit.mass is None:
        return None
    (band,) = bands(need, (_LEVEL,))
    return refit.mass, band.low, band.high


def statistics_beside(sizing: Sizing, mass: CompleteMass) -> Statistics:
    """Return the refit's band for a design, and a sentence on the sum of its parts.

    Args:
        sizing: As sized.
        mass: Its complete mass.
    """
    need, cramped = requirement_of(sizing), _cramped(mass)
    if need is None:
        said = "No statistics: they are of gearboxes that reduce an engine's speed."
        return Statistics(None, None, None, said + cramped)
    found = band_of(need)
    if found is None:
        return Statistics(None, None, None, "No statistics: its β is outside that of the 61 weights." + cramped)
    median, low, high = found
    return Statistics(median, low, high, _sentence(mass, median, (low, high)) + cramped)


def _cramped(mass: CompleteMass) -> str:
    """Say whose bearings are lighter than their load asks."""
    if not mass.crowded:
        return ""
    return (
        f" The bearings of {' and '.join(mass.crowded)} are weighed as large as there is room, and their load asks for"
        " larger ones: gearwright close finds what lives."
    )


def _sentence(mass: CompleteMass, median: float, band: tuple[float, float]) -> str:
    """Say whether two bands of 68 % meet."""
    low, high = mass.band
    said = f"61 real gearboxes: {_kg(median)}, 68 % from {_kg(band[0])} to {_kg(band[1])}"
    if low <= band[1] and high >= band[0]:
        return f"{said}; the bands meet."
    way = "lighter" if high < band[0] else "heavier"
    return (
        f"{said}: the sum of parts is {way}, and the bands do not meet. Where requirements are not met yet"
        " (gearwright review), or life and loads that are asked differ from those of aircraft, the sum is not that of a"
        " gearbox that flies."
    )


def _kg(mass: float) -> str:
    return text(mass, "mass", 3)
