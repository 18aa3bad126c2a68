"""Published ratings of gears: stiffness, flanks, roots, scuffing and losses of teeth."""

from gearwright.validate.gears import bevels, losses
from gearwright.validate.gears import losses as measured
from gearwright.validate.gears import losses as scuffing
from gearwright.validate.gears import ratings as mesh_stiffness
from gearwright.validate.gears import ratings as rating
from gearwright.validate.gears import ratings as reports
from gearwright.validate.gears import wind as wind_dynamics
from gearwright.validate.gears import wind as wind_reports

CASES = (
    *mesh_stiffness.STIFFNESS_CASES,
    *rating.RATING_CASES,
    *reports.PROGRAM_CASES,
    *losses.LOSS_CASES,
    *measured.MEASURED_CASES,
    *scuffing.SCUFFING_CASES,
    *bevels.CASES,
    *wind_reports.REPORT_CASES,
    *wind_dynamics.DYNAMICS_CASES,
)
"""In the order of the table."""

__all__ = ["CASES"]
