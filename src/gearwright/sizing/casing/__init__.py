"""What a housing is around a sized gearbox: the bodies that it holds, its shell, its flanges.

What it weighs is for `sizing.mass`, its solids for `shape`.
"""

from gearwright.sizing.casing.around import ball_around
from gearwright.sizing.casing.flanges import (
    HEAD,
    HOLE,
    LENGTH,
    NUT,
    THICKNESS,
    WASHER,
    Flanges,
    flanges_of,
    screw_volume,
)
from gearwright.sizing.casing.housed import BOSS, boss_bodies, bosses_of, cover_at, cover_bodies, housed, shell_of
from gearwright.sizing.casing.ring_seats import Land, LandPiece, RingSeat, lands_of, ring_frame, ring_seats
from gearwright.sizing.casing.rooms import rooms_around
from gearwright.sizing.casing.shell import Shell, Stretch, outline_of, section_across, shell_around, stretches_around
from gearwright.sizing.casing.webs import Carried, Collar, Web, carried_bosses
from gearwright.sizing.sealing import Leaving, leaving_of

__all__ = [
    "BOSS",
    "HEAD",
    "HOLE",
    "LENGTH",
    "NUT",
    "THICKNESS",
    "WASHER",
    "Carried",
    "Collar",
    "Flanges",
    "Land",
    "LandPiece",
    "Leaving",
    "RingSeat",
    "Shell",
    "Stretch",
    "Web",
    "ball_around",
    "boss_bodies",
    "bosses_of",
    "carried_bosses",
    "cover_at",
    "cover_bodies",
    "flanges_of",
    "housed",
    "lands_of",
    "leaving_of",
    "outline_of",
    "ring_frame",
    "ring_seats",
    "rooms_around",
    "screw_volume",
    "section_across",
    "shell_around",
    "shell_of",
    "stretches_around",
]
