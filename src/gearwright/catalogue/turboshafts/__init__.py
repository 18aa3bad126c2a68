"""Turboshaft engines: decks that are read or made, seconds of slams, held rotors and starts.

The components are machines' and are not here; flights read decks and do not make them.
"""

from gearwright.catalogue.turboshafts.decks import deck_of, deck_text, read_engine_deck
from gearwright.catalogue.turboshafts.made import (
    ALTITUDES,
    MACHS,
    PARTS,
    DeckRow,
    DesignPoint,
    MadeEngine,
    MissionKeys,
    inlet_at,
    turboshaft,
)
from gearwright.catalogue.turboshafts.transients import (
    EngineTransient,
    Rotor,
    Slam,
    StartRules,
    TransientRow,
    engine_slam,
    engine_start,
)

__all__ = [
    "ALTITUDES",
    "MACHS",
    "PARTS",
    "DeckRow",
    "DesignPoint",
    "EngineTransient",
    "MadeEngine",
    "MissionKeys",
    "Rotor",
    "Slam",
    "StartRules",
    "TransientRow",
    "deck_of",
    "deck_text",
    "engine_slam",
    "engine_start",
    "inlet_at",
    "read_engine_deck",
    "turboshaft",
]
