"""How the teeth of a sizing were chosen: how many combinations there were, and how far the next one is."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from gearwright.units import Mass, Origin, Quantity


@dataclass(frozen=True)
class TeethSearch:
    """What the search for teeth looked at."""

    combinations: Annotated[float, Quantity("number"), Origin("Π of candidates within the rules of [teeth]", "search")]
    """Combinations of tooth numbers and planets that were told apart; what cannot win before all stages have teeth
    counts once [-]."""
    weighed: int
    """Candidates of single stages that were weighed for it [-]."""
    gear_mass: Mass
    """What the gears weigh by the search's own estimate [kg]."""
    next_mass: Mass
    """What the gears of the next-lightest combination weigh by it; infinite where there is none [kg]."""
    proven: bool
    """True where none of the combinations can be lighter by that estimate; False where there were too many to hold."""
    sized: int = 1
    """Combinations, those of the lightest gears first, that were sized in full and came out; at a preliminary level
    those whose gears were sized [-]."""
    failing: int = 0
    """How many of these fail a check; where all do, the lightest of them is taken, else of the others; at a preliminary
    level a check of their gears, and then the nearest is taken [-]."""
    refused: int = 0
    """Combinations that were sized and are refused [-]."""
    next_sized_mass: Mass = math.inf
    """What the next-lightest transmission of those weighs from which one is taken; infinite where there is none [kg].
    """
