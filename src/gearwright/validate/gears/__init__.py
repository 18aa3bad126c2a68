"""Published ratings of gears: stiffness, flanks, roots, scuffing and losses of teeth."""

from gearwright.validate.gears import (
    bevels,
    losses,
    measured,
    mesh_stiffness,
    rating,
    reports,
    scuffing,
    wind_dynamics,
    wind_reports,
)

CASES = (
    *mesh_stiffness.CASES,
    *rating.CASES,
    *reports.CASES,
    *losses.CASES,
    *measured.CASES,
    *scuffing.CASES,
    *bevels.CASES,
    *wind_reports.CASES,
    *wind_dynamics.CASES,
)
"""In the order of the table."""

__all__ = ["CASES"]
