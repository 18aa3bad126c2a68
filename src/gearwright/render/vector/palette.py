"""Colours of everything that is drawn, for light and for dark paper, and the classes by which a page may change them.

The palette is Okabe and Ito's, which also those see who do not tell red from green.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from types import MappingProxyType

INK, MUTED, HAIR, PAPER = "#1d2530", "#66707c", "#d9dde2", "#ffffff"
BLUE, ORANGE, GREEN, PURPLE = "#0072b2", "#d55e00", "#009e73", "#a3548c"
SKY, AMBER = "#56b4e9", "#e69f00"
STEEL = "#e4e8ed"
"""Fill of gears and boxes."""
DARK_STEEL, PALE_STEEL, DEEP_STEEL = "#cdd5de", "#f3f5f7", "#b4bfca"
"""Shades of gears that lie beside each other."""
CYCLE = (BLUE, ORANGE, GREEN, PURPLE, SKY, AMBER)
"""Colours of curves, in order."""
TINT = 0.42
"""Share of the colour in the bands of power [-]."""

NAMES: Mapping[str, str] = MappingProxyType({
    INK: "ink", MUTED: "muted", HAIR: "hair", PAPER: "paper", BLUE: "blue", ORANGE: "orange", GREEN: "green",
    PURPLE: "purple", SKY: "sky", AMBER: "amber", STEEL: "steel", DARK_STEEL: "steel-2", PALE_STEEL: "steel-3",
    DEEP_STEEL: "steel-4",
})  # fmt: skip
"""Colour -> what a page calls it: the CSS variable is ``--gw-NAME``."""
DARK: Mapping[str, str] = MappingProxyType({
    "ink": "#e6e9ed", "muted": "#a0a9b4", "hair": "#39424d", "paper": "#171b21", "blue": "#4ba3dc",
    "orange": "#ee8344", "green": "#35c29b", "purple": "#cd86b8", "sky": "#7cc7f2", "amber": "#f0b73c",
    "steel": "#2d3642", "steel-2": "#3f4b5a", "steel-3": "#252d37", "steel-4": "#566476",
})  # fmt: skip
"""Name -> colour on dark paper."""


@functools.cache
def tinted(colour: str, strength: float = TINT) -> str:
    """Return a colour mixed with white.

    Args:
        colour: As ``#rrggbb``.
        strength: Share of the colour [-].
    """
    parts = [255.0 - strength * (255.0 - int(colour[k : k + 2], 16)) for k in (1, 3, 5)]
    return "#" + "".join(f"{round(part):02x}" for part in parts)


_TINTS: Mapping[str, str] = MappingProxyType({tinted(colour): name for colour, name in NAMES.items()})


def css_value(colour: str) -> tuple[str, str] | None:
    """Return the short name and the CSS value of a colour that pages may change; None for one that stays.

    Args:
        colour: As ``#rrggbb``.
    """
    if colour in NAMES:
        return NAMES[colour], f"var(--gw-{NAMES[colour]},{colour})"
    if colour in _TINTS:
        name = _TINTS[colour]
        whole = next(value for value, word in NAMES.items() if word == name)
        mixed = f"color-mix(in srgb,var(--gw-{name},{whole}) {100.0 * TINT:g}%,var(--gw-paper,{PAPER}))"
        return f"{name}-t", mixed
    return None
