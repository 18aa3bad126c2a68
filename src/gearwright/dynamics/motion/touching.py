"""Starts at which no tooth touches: named before anything is computed from them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import errors_at, line_forces, redundancy
from gearwright.dynamics.model import System, along_lines
from gearwright.dynamics.motion.record import line_numbers
from gearwright.errors import DesignError, Problem

NOTHING = 1e-9
"""Force of parallel lines over the largest that their stiffness and errors could give, that counts as none [-]."""
FELT = 1e-6
"""Length that the errors of a system without errors are taken as [m]."""


def slack_lines(system: System, position: Floats) -> tuple[str, ...]:
    """Return the lines with backlash if all of them stand between their flanks at time 0; else nothing.

    Args:
        system: Bodies, lines, loads.
        position: q at the start [rad or m], shape (coordinates,).
    """
    arrays = system.arrays
    play = arrays.backlash > 0.0
    deflection = along_lines(arrays, position) - errors_at(system, np.zeros(1))[0]
    open_ = (deflection < 0.0) & (deflection > -arrays.backlash)
    if not np.any(play) or not np.all(open_[play]):
        return ()
    return tuple(name for name, has in zip(system.labels.lines, play, strict=True) if has)


def check_shared_load(system: System, lines: Sequence[str]) -> None:
    """Refuse to share a load that is not there.

    Args:
        system: With its loads and errors.
        lines: Names of the parallel meshes.

    Raises:
        DesignError: If the lines together carry nothing when everything is slow: no share is defined.
    """
    shared, errors = line_numbers(system, lines), errors_at(system, np.zeros(1))[0]
    train = redundancy(system)
    force = line_forces(train, errors)[shared]
    stiffness = float(np.max(system.arrays.stiffness[shared]))
    scale = stiffness * max(FELT, float(np.max(np.abs(errors[shared]))))
    if abs(float(np.sum(force))) <= NOTHING * scale:
        message = f"{', '.join(lines)} carry nothing at the start, so there is nothing to share; give the case a load"
        raise DesignError([Problem("loads", message)])
