"""Published ratings of gears: stiffness, flanks, roots, scuffing and losses of teeth."""

from gearwright.validate.gears import bevels, ratings, wind

CASES = (
    *ratings.STIFFNESS_CASES,
    *ratings.RATING_CASES,
    *ratings.PROGRAM_CASES,
    *ratings.LOSS_CASES,
    *ratings.MEASURED_CASES,
    *ratings.SCUFFING_CASES,
    *bevels.CASES,
    *wind.REPORT_CASES,
    *wind.DYNAMICS_CASES,
)
"""In the order of the table."""

__all__ = ["CASES"]
