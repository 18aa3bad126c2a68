"""Speed map: line forces of steady running at many speeds, all side by side."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.model import System, check_finite
from gearwright.dynamics.motion import Accuracy, Ensemble, simulate_many
from gearwright.dynamics.vibration.sequences import positive_numbers
from gearwright.showing import Shown
from gearwright.verbs import verb


@dataclass(frozen=True, eq=False, repr=False)
class SpeedMap(Shown):
    """Line forces against speed."""

    factor: Floats
    """Speed over reference speed [-], shape (speeds,)."""
    forces: Ensemble
    """Statistics at each speed."""

    def swing(self, line: str) -> Floats:
        """Return the root mean square of a line's force about its mean [N or N m], shape (speeds,).

        Args:
            line: Its name.
        """
        values = self.forces.of(line)
        return np.sqrt(np.maximum(values["rms"] ** 2 - values["mean"] ** 2, 0.0))


@verb
@one_blas_thread()
def speed_map(
    system: System,
    factors: Sequence[float] | Floats,
    *,
    settle: float,
    duration: float,
    accuracy: Accuracy | None = None,
    progress: Callable[[float], None] | None = None,
) -> SpeedMap:
    """Return the forces at steady running, each speed from its own static equilibrium.

    Args:
        system: Its loads are kept as they are at every speed.
        factors: Speeds over the reference speeds [-], positive; any sequence of numbers.
        settle: Time left out, for the transient to decay [s].
        duration: Whole time at each speed [s].
        accuracy: Of the forces; left out, peaks to 1 %, root mean squares to 0.1 %; the errors are in `forces`.
        progress: Called with the fraction done.

    Raises:
        DesignError: For speeds that are not positive.
    """
    speeds = positive_numbers(factors, "factors")
    check_finite(system)
    systems = [at_speed(system, factor) for factor in speeds]
    forces = simulate_many(systems, duration, step=accuracy, settle=settle, progress=progress)
    return SpeedMap(speeds, forces)


def at_speed(system: System, factor: float) -> System:
    """Return a system that runs steadily at another speed.

    Args:
        system: Any.
        factor: Speed over reference speed [-].
    """
    zero = np.zeros(1)
    profile = system.arrays.profile._replace(time=zero, factor=np.array([float(factor)]), travel=zero)
    return replace(system, arrays=system.arrays._replace(profile=profile))
