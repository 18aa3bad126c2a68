"""What many tests look at, made once for each process when a test first asks: shipped designs sized and flown."""

from dataclasses import replace
from functools import cache

from gearwright.mission import durability, fly
from gearwright.reviews import review_of
from gearwright.shape import scene
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import parse, read, read_mission

BY_HAND = "ec120b with teeth of 36/173 and 67/88"
"""EC120B with the teeth with which it was worked out by hand: other teeth keep the shipped one out of resonance."""


def text_of(name):
    """Return the text of a shipped design, or of that of `BY_HAND`."""
    if name != BY_HAND:
        return shipped_design(name).read_text(encoding="utf-8")
    text = shipped_design("ec120b").read_text(encoding="utf-8")
    for now, then in (
        ("pinion_teeth = 40 ", "pinion_teeth = 36 "),
        ("wheel_teeth = 193", "wheel_teeth = 173"),
        ("helix_angle_deg = 9", "helix_angle_deg = 12"),
    ):
        assert text.count(now) == 1
        text = text.replace(now, then)
    return text


@cache
def sized(name="in-line-h2"):
    """Return the sizing of a shipped design, or of that of `BY_HAND`."""
    return size(parse(text_of(name)) if name == BY_HAND else read(shipped_design(name)))


def coarse(sizing):
    """Return the coarse solids of a sizing, which its drawings show."""
    return scene(sizing, detail="coarse")


def ball_bearings_of_the_tail(front="", rear='locates = "both"\n'):
    """Return the text of EC120B with its tail on two ball bearings near its gear, each with more keys.

    Covers of the tail and of the input stand in each other then; shafts and bearings are what tests look at.
    """
    text = text_of(BY_HAND)
    for long, short in (
        ("length_mm = 190", "length_mm = 160"),
        ("rotor-brake.position_mm = 150", "rotor-brake.position_mm = 120"),
        ("tail-drive.position_mm = 175", "tail-drive.position_mm = 145"),
    ):
        assert text.count(long) == 1
        text = text.replace(long, short)
    head, tail = text.split("[bearings.tail-front]")
    joints = tail[tail.index("\n[joints]") :]
    kind = 'shaft = "tail"\nkind = "deep-groove"\n'
    seats = f"{kind}position_mm = 30\n{front}\n[bearings.tail-rear]\n{kind}position_mm = 95\n{rear}"
    return f"{head}[bearings.tail-front]\n{seats}{joints}"


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


def with_turned_down_tail(sizing):
    """Return the EC120B gearbox with the first end of its tail shaft as thin as its torque needs, from the bearing on.

    Args:
        sizing: With ball bearings there.
    """
    (tail,) = (shaft for shaft in sizing.built_shafts if shaft.name == "tail")
    thin = replace(tail, steps=(replace(tail.steps[1], diameter=0.010), *tail.steps[2:]))
    return replace(sizing, built_shafts=tuple(thin if shaft is tail else shaft for shaft in sizing.built_shafts))
