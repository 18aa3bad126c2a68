"""K_γ of every stage: as the design states it, or by how well its planets or parallel paths share their load."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.catalogue import level_load_factor
from gearwright.spec import Design, Pair, Planetary
from gearwright.spec.design import RATINGS, split_levels

USUAL_LEVEL = "level-3"
"""How planets share where nothing is said: one member floats, tolerances are close."""
PATHS = {"clocked": 1.06, "rigid": 1.20, "quill": 1.03, "floating": 1.03}
"""How parallel paths share -> K_γ of two of them [-]: 53 % in one of two clocked gearboxes (Krantz & Delgado 1996, NASA
TM-107202); 1 to 4 % over a floating pinion with soft supports (Wang et al. 2023); the others are estimates."""
_EQUAL = "all share alike"


@dataclass(frozen=True)
class LoadSharing:
    """K_γ of a stage, and by what."""

    factor: float
    """K_γ [-]."""
    words: str
    """By what, for people."""
    usual: bool = False
    """True where the design says nothing of it."""
    by_size: bool = False
    """True where it follows from the sizes of gears and their loads, by tolerances or clocking."""


def load_sharing(design: Design, name: str, planets: int | None = None) -> LoadSharing:
    """Return how a stage shares its load among planets or parallel paths, as far as it is known without its sizes.

    A method without fatigue has all share alike, as the thesis on turboprop gearboxes has it.

    Args:
        design: As read.
        name: Of a pair or set.
        planets: Of a set whose number is to be chosen, a number to look at; left out: as the design has it [-].
    """
    rules, stage = design.rules(name), design.stages[name]
    count = stage.planets if isinstance(stage, Planetary) else 1 if isinstance(stage, Pair) else stage.sets
    count = count if planets is None else planets
    if not isinstance(stage, Pair) and rules.planet_load_factors:
        return LoadSharing(rules.load_factor_of(count), f"stated for {count} planets")
    if rules.mesh_load_factor is not None:
        return LoadSharing(rules.mesh_load_factor, "stated")
    if not RATINGS[design.rating(name)].fatigue:
        return LoadSharing(1.0, _EQUAL, usual=True)
    if isinstance(stage, Pair):
        return _of_paths(design, name, stage)
    level = stage.load_sharing or USUAL_LEVEL
    if level == "tolerances":
        factor = level_load_factor(3, count)
        return LoadSharing(factor, "by the tolerances of the pins", by_size=True)
    words = f"AGMA 6123, {level.replace('-', ' ')}, {count} planets"
    return LoadSharing(level_load_factor(int(level[-1]), count), words, usual=stage.load_sharing is None)


def _of_paths(design: Design, name: str, pair: Pair) -> LoadSharing:
    """Return how a pair on a loop of parallel paths shares its load; a pair on none carries what it carries."""
    levels = split_levels(design).get(name, 0.0)
    if not levels:
        return LoadSharing(1.0, "one path")
    way = pair.load_sharing or "clocked"
    words = f"{2.0**levels:g} parallel paths, {way}"
    usual = pair.load_sharing is None
    return LoadSharing(PATHS[way] ** levels, words, usual=usual, by_size=pair.clocking is not None)
