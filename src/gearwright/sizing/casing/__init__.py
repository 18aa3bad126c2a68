"""What a housing is around a sized gearbox: the bodies that it holds, its shell, its flanges.

What it weighs is for `sizing.mass`, its solids for `shape`.
"""

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
from gearwright.sizing.casing.housed import BOSS, bosses_of, cover_at, housed
from gearwright.sizing.casing.shell import Shell, Stretch, outline_of, shell_around, stretches_around
from gearwright.sizing.sealing import Leaving, leaving_of

__all__ = [
    "BOSS",
    "HEAD",
    "HOLE",
    "LENGTH",
    "NUT",
    "THICKNESS",
    "WASHER",
    "Flanges",
    "Leaving",
    "Shell",
    "Stretch",
    "bosses_of",
    "cover_at",
    "flanges_of",
    "housed",
    "leaving_of",
    "outline_of",
    "screw_volume",
    "shell_around",
    "stretches_around",
]
