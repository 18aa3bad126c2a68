"""Every mass method beside the others for one requirement, with the band of the real weights and the mass to take."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gearwright.catalogue import Engine, nearest
from gearwright.errors import Problem, refuse
from gearwright.showing import Shown
from gearwright.units import Mass
from gearwright.weights.method import Estimate, estimate
from gearwright.weights.methods import methods
from gearwright.weights.refit import Band, bands
from gearwright.weights.requirement import Requirement

PARTS = "sum of the parts of the sized design"
"""Origin of a bottom-up mass."""


@dataclass(frozen=True)
class StatedMass:
    """A gearbox mass with its origin, to be carried into every result that uses it."""

    mass: Mass
    """[kg]."""
    origin: str
    """Where it comes from: a method, the design's own sizing, or the user's words."""
    overridden: bool = False
    """Whether the user gave it in place of a computed value."""

    def __post_init__(self) -> None:
        problems = []
        if not (math.isfinite(self.mass) and self.mass > 0.0):
            problems.append(Problem("mass_kg", f"{self.mass!r} was given; a finite mass above zero is needed"))
        if not self.origin.strip():
            problems.append(Problem("origin", "a stated mass needs its origin, such as 'weighed, maintenance manual'"))
        refuse(problems)


@dataclass(frozen=True, repr=False)
class Comparison(Shown):
    """What is known about the mass of a gearbox before it is designed, and after if there is a design."""

    requirement: Requirement
    estimates: tuple[Estimate, ...]
    """One per method, in the order of `methods`."""
    bands: tuple[Band, ...]
    """Prediction bands of the refit, the narrow one first; empty outside the range of its weights."""
    engines: tuple[Engine, ...]
    """Engines of the catalogue that are most alike, the nearest first."""
    bottom_up: StatedMass | None
    """Mass of the design's own parts, where there is a design."""
    stated: StatedMass | None
    """The user's own mass."""

    @property
    def taken(self) -> StatedMass | None:
        """The mass for every later result: the user's own, else the refit's median; a sum of parts stands beside it."""
        return self.stated or self._from_refit()

    @property
    def spread(self) -> tuple[float, float]:
        """Least and greatest mass among the methods that apply [kg]."""
        masses = [answer.mass for answer in self.estimates if answer.mass is not None]
        return min(masses), max(masses)

    def _from_refit(self) -> StatedMass | None:
        best = next(answer for answer in self.estimates if answer.method.key == "refit")
        if best.mass is None:
            return None
        return StatedMass(best.mass, f"{best.method.name}: {best.method.formula} ({best.method.source})")


def compare(
    requirement: Requirement,
    *,
    bottom_up: Mass | StatedMass | None = None,
    stated: StatedMass | None = None,
    count: int = 5,
) -> Comparison:
    """Return every method side by side for a requirement.

    Args:
        requirement: Power and speeds.
        bottom_up: Sum of the parts of a sized design, with its origin or alone [kg].
        stated: The user's own mass with its origin.
        count: How many engines to show [-].

    >>> from gearwright.units import RPM
    >>> result = compare(Requirement(2051e3, 20204 * RPM, 1212 * RPM))
    >>> round(result.taken.mass, 1)
    136.5
    """
    estimates = tuple(estimate(method, requirement) for method in methods())
    has_refit = any(answer.method.key == "refit" and answer.mass is not None for answer in estimates)
    return Comparison(
        requirement=requirement,
        estimates=estimates,
        bands=bands(requirement) if has_refit else (),
        engines=nearest(requirement.power, requirement.engine_speed, requirement.propeller_speed, count=count),
        bottom_up=bottom_up if bottom_up is None or isinstance(bottom_up, StatedMass) else StatedMass(bottom_up, PARTS),
        stated=stated,
    )
