"""A mass method as data (formula, source, what it includes, where it holds) and what it says of a requirement."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from gearwright.units import Mass, text
from gearwright.weights.requirement import Requirement

_ROUNDING = 1e-9
"""A limit itself is inside, however its value was computed [-]."""
Covered = Literal["included", "left out", "not stated"]


@dataclass(frozen=True)
class Coverage:
    """What the mass of a method contains besides its gears."""

    lubrication: Covered
    """Lubrication system."""
    rotor_shaft: Covered
    """Shaft of the rotor or propeller."""
    accessories: Covered
    """Accessory drives."""
    housing: Covered = "included"
    """Case, shafts and bearings."""


@dataclass(frozen=True)
class Range:
    """Where a method holds in one quantity."""

    quantity: Literal["power", "ratio", "beta"]
    """A property of `Requirement`."""
    low: float
    """Least value, SI."""
    high: float
    """Greatest value, SI."""
    reason: str
    """Source of the range, or the geometry that sets it."""
    shows_beyond: bool = False
    """Whether the bare formula outside may be shown to the reader: it still means a gearbox there."""

    def complaint(self, requirement: Requirement) -> str:
        """Return why a requirement lies outside, or an empty string.

        Args:
            requirement: Power and speeds.
        """
        value = getattr(requirement, self.quantity)
        if self.low * (1.0 - _ROUNDING) <= value <= self.high * (1.0 + _ROUNDING):
            return ""
        dimension = "power" if self.quantity == "power" else "number"
        shown, low, high = (text(number, dimension) for number in (value, self.low, self.high))
        return f"{self.quantity} {shown} is outside {low} to {high} ({self.reason})"


@dataclass(frozen=True)
class Method:
    """A published way from power and speeds to a mass."""

    key: str
    """Short name for files and links."""
    name: str
    formula: str
    """The formula in the symbols and units of its source."""
    source: str
    """Author, year, report."""
    basis: str
    """What it was drawn from, and the error that its authors state."""
    includes: Coverage
    mass: Callable[[Requirement], float]
    """Bare formula: mass [kg] of a requirement."""
    ranges: tuple[Range, ...] = ()
    """Where it holds; empty where its source states no numbers."""
    assumes: str = ""
    """Inputs that a requirement does not give, and the values taken."""


@dataclass(frozen=True)
class Estimate:
    """What a method says of a requirement: a mass, or why it gives none."""

    method: Method
    mass: Mass | None
    """[kg]; none outside the range of the method."""
    reason: str = ""
    """Why there is no mass."""
    beyond: Mass | None = None
    """Bare formula outside its range [kg]: for the reader only, used nowhere."""


def estimate(method: Method, requirement: Requirement) -> Estimate:
    """Return the mass by a method, or the reason why it does not apply.

    Args:
        method: Of `methods`.
        requirement: Power and speeds.
    """
    broken = [range_ for range_ in method.ranges if range_.complaint(requirement)]
    if not broken:
        return Estimate(method, method.mass(requirement))
    reason = "; ".join(range_.complaint(requirement) for range_ in broken)
    beyond = method.mass(requirement) if all(range_.shows_beyond for range_ in broken) else None
    return Estimate(method, None, reason, beyond)
