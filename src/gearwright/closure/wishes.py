"""What is asked of a closed gearbox beside what its design says: a life, how sizes are rounded, which way to go."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

from gearwright.closure.freedoms import FREEDOMS
from gearwright.closure.requirements import REQUIREMENTS
from gearwright.errors import Problem, near, refuse

HOUR = 3600.0
"""[s]"""


@dataclass(frozen=True)
class Wishes:
    """What a closure is asked for; what is left out is as the design says."""

    life: float | None = None
    """Life of gears and bearings alike [s]; None: service.life and service.bearing_life of the design."""
    rounded: bool = True
    """Modules of ISO 54 and face widths in whole millimetres, as the rules of the design ask; False: continuous."""
    separate: bool = True
    """Look for teeth and modules that keep critical speeds away from operating ones; False: crossings are listed."""
    lighten: bool = True
    """Look for other teeth, and for what else is free, with which everything is lighter; False: teeth as sized."""
    free: tuple[str, ...] = ()
    """Names of `FREEDOMS`: what is changed, too, while all becomes lighter, also where the design gives it."""
    left_out: frozenset[str] = field(default_factory=frozenset)
    """Requirements that the closure does not look at: to see which of them bind."""

    def __post_init__(self) -> None:
        refuse(self._problems())

    def _problems(self) -> Iterator[Problem]:
        """Yield what cannot be asked for."""
        if self.life is not None and not 0.0 < self.life < math.inf:
            yield Problem("life", f"{self.life / HOUR:g} h is asked; it must be above 0 and finite")
        for name in self.free:
            if name not in FREEDOMS:
                yield Problem("free", f"{name!r} is no freedom; {near(name, FREEDOMS)}")
        for name in sorted(self.left_out - REQUIREMENTS.keys()):
            yield Problem("left_out", f"{name!r} is no requirement; {near(name, REQUIREMENTS)}")
