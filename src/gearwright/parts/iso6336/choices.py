"""Which method of ISO 6336 gives a factor where the standard offers several."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class RatingMethod(Enum):
    """Methods of ISO 6336 by which a factor is had; A, by measurement, is none that a formula gives."""

    B = "B"
    """The usual one."""
    C = "C"
    """The simpler one: fewer inputs, more on the safe side."""


@dataclass(frozen=True)
class Choices:
    """Method of the factors that have a choice."""

    dynamic: RatingMethod = RatingMethod.B
    """Of K_V: by resonance and deviations, or by the speed v z_1 alone."""
    root: RatingMethod = RatingMethod.B
    """Of Y_F and Y_S: load at the outer point of single contact, or at the tip with Y_ε."""
    least_dynamic: float = 1.0
    """K_V below which none counts [-]: by an analysis of the whole train, as method A has it."""


USUAL_CHOICES = Choices()
"""Method B throughout."""
