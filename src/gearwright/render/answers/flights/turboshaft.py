"""Answer about a turboshaft engine: its deck, and seconds of it where they are asked for; its rows are the deck."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.catalogue import DesignPoint, EngineTransient, MadeEngine
from gearwright.catalogue.turboshafts import DeckRow, MissionKeys
from gearwright.units import Quantity, Ratio


@dataclass(frozen=True)
class TurboshaftAnswer:
    """A turboshaft engine."""

    engine: DesignPoint
    power_turbine: Ratio
    """Isentropic efficiency that the design point implies."""
    hottest: Annotated[float, Quantity("absolute_temperature")]
    """T_45 of the design point."""
    keys: MissionKeys
    """What a mission's [engine] says of it without a deck."""
    slam: EngineTransient | None
    """Null where none is asked for."""
    start: EngineTransient | None
    """The same."""
    rows: tuple[DeckRow, ...]
    """The deck."""


def turboshaft_answer(
    made: MadeEngine, slam: EngineTransient | None, start: EngineTransient | None
) -> TurboshaftAnswer:
    """Return what `gearwright turboshaft --json` answers.

    Args:
        made: The engine.
        slam: Of its lever or rotor.
        start: From rest.
    """
    return TurboshaftAnswer(made.design, made.power_turbine, made.hottest, made.keys, slam, start, made.rows)
