"""Where threads of shafts end: undercuts and run-outs of DIN 76, and the chamfer at their start."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

from gearwright.catalogue.tables import data_rows
from gearwright.errors import DesignError, Problem
from gearwright.units import Length

THREAD_TOLERANCE = "6g"
"""Tolerance class of threads for lock nuts (ISO 965-1), as makers ask for beside nuts of 5H."""
RUN_OUT = 2.5
"""x_1, turns that are not cut to their full depth, over the pitch at most [-]: DIN 76-1, usual."""
THREAD_RUN_IN = math.radians(30.0)
"""Angle of an undercut to the thread and to the seat beside it [rad]."""
CORE = 1.2269
"""d − d_3 over the pitch: depth of an external thread on the diameter [-] (ISO 68-1, root rounded with P/6.93)."""
NUT_CORE = 1.0825
"""d − D_1 over the pitch: what a nut can be slid over [-] (ISO 724)."""


@dataclass(frozen=True)
class ThreadUndercut:
    """An undercut of form A beside an external thread."""

    pitch: Length
    """P [m]."""
    below: Length
    """d − d_g, on the diameter [m]."""
    width: Length
    """g_2, with both of its flanks [m]."""
    radius: Length
    """r [m]."""

    @property
    def designation(self) -> str:
        """As drawings name it."""
        return "DIN 76 - A"


@cache
def thread_undercuts() -> tuple[ThreadUndercut, ...]:
    """Return the undercuts of external threads of ISO, by pitch.

    Source: HEIDENHAIN, CNC PILOT 4290, user's manual, 11.1.1 (undercut DIN 76, external thread); of the same maker's
        MANUALplus 4110, operation manual, 10.2, d − I.
    """
    rows = data_rows("thread_undercuts.csv")
    return tuple(ThreadUndercut(*(float(value) / 1e3 for value in row.values())) for row in rows)


def thread_undercut(pitch: float) -> ThreadUndercut:
    """Return the undercut of a thread.

    Args:
        pitch: P [m].

    Raises:
        DesignError: If the table has none of this pitch.

    >>> found = thread_undercut(1.5e-3)
    >>> round(1e3 * found.below, 3), round(1e3 * found.width, 3), round(1e3 * found.radius, 3)
    (2.3, 5.2, 0.8)
    """
    found = next((each for each in thread_undercuts() if math.isclose(each.pitch, pitch, rel_tol=1e-6)), None)
    if found is None:
        pitches = ", ".join(f"{1e3 * each.pitch:g}" for each in thread_undercuts())
        message = f"DIN 76 has no undercut for {1e3 * pitch:g} mm; it has some for {pitches} mm: take one of them"
        raise DesignError([Problem("pitch", message)])
    return found


def thread_run_out(pitch: float) -> Length:
    """Return how far turns may fade out beyond a thread, x_1 [m].

    Args:
        pitch: P [m].

    Source: DIN 76-1, usual: 2.5 P, as Fabory prints it for studs (x_1 of 2.5, 3.8 and 5 mm for P of 1, 1.5 and 2 mm).

    >>> round(1e3 * thread_run_out(1.5e-3), 2)
    3.75
    """
    return RUN_OUT * pitch


def thread_chamfer(pitch: float) -> Length:
    """Return the chamfer of 45° at the start of a thread, down to its core and up to 0.1 mm [m].

    Args:
        pitch: P [m].

    Source: (d − d_3)/2 (ISO 68-1); that a thread starts with a chamfer to its core is usual.

    >>> round(1e3 * thread_chamfer(1.5e-3), 3)
    1.0
    """
    return math.ceil(1e4 * CORE * pitch / 2.0 - 1e-9) / 1e4
