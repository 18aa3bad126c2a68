"""What a closure may change beside modules, widths and bearings, where it is asked to look for something lighter."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

FREEDOMS: Mapping[str, str] = MappingProxyType({
    "teeth": "tooth numbers of pairs and sets",
    "shifts": "profile shift of pinions and suns",
    "planets": "number of planets, their load factor as the design states it",
    "helix": "helix angle of pairs",
    "material": "steel of the gears, and its grade",
    "rims": "rims of wheels, planets and rings",
    "webs": "webs of pairs",
})  # fmt: skip
"""Name -> what may then be changed, also where the design gives it."""
