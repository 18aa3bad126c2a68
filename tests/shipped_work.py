"""What many tests look at, made once for each process when a test first asks: shipped designs sized and flown."""

from functools import cache

from gearwright.mission import durability, fly
from gearwright.reviews import review_of
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import read, read_mission


@cache
def sized(name="in-line-h2"):
    """Return the sizing of a shipped design."""
    return size(read(shipped_design(name)))


@cache
def flown(design="in-line-h2", mission="thesis"):
    """Return the flight of a shipped mission by a shipped design."""
    return fly(sized(design), read_mission(shipped_mission(mission)))


@cache
def lives():
    """Return what the thesis's mission does to gears and bearings of its hybrid."""
    return durability(flown())


@cache
def flown_review():
    """Return the review of that flight."""
    return review_of(sized(), flown(), lives())


@cache
def ground_review():
    """Return the review of the same design without a mission."""
    return review_of(sized())
