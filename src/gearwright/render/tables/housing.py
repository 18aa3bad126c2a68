"""What tires a housing, what was assumed of it, and the maintenance of a gearbox, as tables of a review."""

from gearwright.render.grid import Table, table
from gearwright.reviews import Review

_TIRES = (
    "σ: nominal, of the largest steady load. Ranges have the notch in them: start and stop with what vibrates then,"
    " changes from load to load, and vibration at mesh frequency. Shares: of Miner's sum where it fails. Flat walls say"
    " what walls bear at least, without ribs."
)
_UPKEEP = (
    "What has to come off first follows from where stages, shafts and machines stand; intervals are asked of none."
)
_TASKS = ("part", "task", "interval", "decides", "removed_first", "source")
_SECTIONS = (
    "part", "section", "stress", "notch", "start_range", "starts", "change_range", "swing_range", "swings",
    "start_share", "swing_share", "safety",
)  # fmt: skip


def housing_tables(review: Review) -> tuple[Table, ...]:
    """Return what tires the housing, what is assumed of it, and what is to be maintained, each as a table.

    Args:
        review: Of a design.
    """
    return (
        table("What tires the housing", review.housing, _SECTIONS, note=_TIRES),
        table("Assumed of the housing", review.housing_assumed, ("what", "value", "source")),
        table("Maintenance", review.upkeep, _TASKS, note=_UPKEEP),
    )
