"""Integration of a path: classical Runge-Kutta steps over speed, height, time or distance, whichever ends it."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from gearwright.mission.moments import Energy
from gearwright.units import GRAVITY


class State(NamedTuple):
    """Of an aircraft on its path."""

    time: float
    """From the start of the phase [s]."""
    altitude: float
    """[m]"""
    speed: float
    """True airspeed [m/s]."""
    distance: float
    """[m]"""
    mass: float
    """[kg]"""
    thrust_work: float
    """Of all propellers [J]."""
    drag_work: float
    """Of air and wheels [J]."""
    carried: float
    """Height and speed of the fuel that was burnt [J]."""

    @property
    def energy(self) -> float:
        """Of height and speed [J]."""
        return self.mass * (GRAVITY * self.altitude + 0.5 * self.speed**2)


Rates = Callable[[State], State]
"""State -> its derivatives over what is marched along."""


def march(rates: Rates, state: State, *, length: float, count: int, inner: int = 1) -> list[State]:
    """Return the states at the ends of equal steps, the first among them.

    Args:
        rates: Derivatives.
        state: At the start.
        length: Of the way, negative backwards.
        count: Steps that are returned.
        inner: Steps within each of them.

    Source: the classical Runge-Kutta method of fourth order.
    """
    states, step = [state], length / (count * inner)
    for _ in range(count):
        for _ in range(inner):
            state = _step(rates, state, step)
        states.append(state)
    return states


def _step(rates: Rates, state: State, step: float) -> State:
    first = rates(state)
    second = rates(_moved(state, first, 0.5 * step))
    third = rates(_moved(state, second, 0.5 * step))
    fourth = rates(_moved(state, third, step))
    mean = State(*((a + 2.0 * b + 2.0 * c + d) / 6.0 for a, b, c, d in zip(first, second, third, fourth, strict=True)))
    return _moved(state, mean, step)


def _moved(state: State, rate: State, step: float) -> State:
    return State(*(value + step * change for value, change in zip(state, rate, strict=True)))


def books(start: State, end: State) -> Energy:
    """Return where the energy of a path went.

    Args:
        start: Its first state.
        end: Its last state.
    """
    return Energy(
        end.thrust_work - start.thrust_work,
        end.drag_work - start.drag_work,
        end.carried - start.carried,
        end.energy - start.energy,
    )
