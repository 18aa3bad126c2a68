"""The tail rotor in flight: a machine of the gearbox that takes what the trim of a helicopter says."""

from __future__ import annotations

from dataclasses import replace

from gearwright.errors import DesignError, Problem, near
from gearwright.mission.collect import Flown
from gearwright.mission.gearbox import Gearbox, Point
from gearwright.mission.loading import Asked, loaded
from gearwright.mission.moments import Moment, trimmed

_ROUNDS = 1
"""Corrections of the tail rotor's part of the power: losses hardly change with it [-]."""


def with_tail(flown: Flown, moment: Moment, asked: Asked, before: Point | None, *, burnt: float) -> Flown:
    """Return what flies, its tail rotor taking what the trim says; as it is where no trim sets the power.

    Args:
        flown: Gearbox, rotor, mission and machines.
        moment: Where it is flown.
        asked: Of the gearbox.
        before: Point of the interval before; None at the start.
        burnt: Fuel so far [kg].

    Raises:
        DesignError: The tail rotor is no machine of the design that takes power.
    """
    craft = flown.mission.rotorcraft
    if craft is None or craft.tail is None or moment.power is not None:
        return flown
    name, gearbox = craft.tail.machine, flown.gearbox
    if name not in gearbox.taken:
        message = f"no load or tail rotor of the design is called {name!r}; {near(name, gearbox.taken)}"
        raise DesignError([Problem("rotorcraft.tail.machine", message)])
    trim = trimmed(craft, flown.mission, moment, diameter=flown.blades.diameter, burnt=burnt)
    assert trim.tail is not None  # it has one
    part = trim.tail / (trim.main + trim.tail)
    for _ in range(_ROUNDS):
        flown = flown._replace(gearbox=_taking(gearbox, name, part))
        over = part / (1.0 - part) * trim.tail / -loaded(flown, moment, asked, before).powers[name]
        part = over / (1.0 + over)  # what all others take does not depend on it
    return flown._replace(gearbox=_taking(gearbox, name, part))


def _taking(gearbox: Gearbox, name: str, part: float) -> Gearbox:
    """Return a gearbox of which a machine takes a part of the power that is given."""
    return replace(gearbox, taken={**gearbox.taken, name: -part})
