"""What many tests look at, made once for each process when a test first asks: shipped designs sized, and one flown."""

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
def flown():
    """Return the flight of the thesis's mission by its hybrid."""
    return fly(sized(), read_mission(shipped_mission("thesis")))


@cache
def lives():
    """Return what that flight does to gears and bearings."""
    return durability(flown())


@cache
def flown_review():
    """Return the review of that flight."""
    return review_of(sized(), flown(), lives())


@cache
def ground_review():
    """Return the review of the same design without a mission."""
    return review_of(sized())
