"""How a journal bearing runs: where heat that its film makes and heat that its oil carries away stand in balance."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts.bearings.plain import (
    LEAST_ECCENTRICITY,
    MOST_ECCENTRICITY,
    NARROWEST,
    TAYLOR,
    WIDEST,
    film_load,
    friction_variable,
    side_flow,
)

_STEPS = 481
"""Of the tables over ε that one bearing is read from: linear between them errs by less than 1e-4 [-]."""
_HOTTEST = 400.0
"""Rise of the oil's mean temperature beyond which none is looked for [K]."""
_HALVINGS = 40
_SIZES = (0.063, 0.160, 0.400, 1.0)
"""Diameters up to which each row of the least films holds [m]."""
_SPEEDS = (1.0, 3.0, 10.0, 30.0)
"""Sliding speeds up to which each of its columns holds [m/s]."""
_FILMS = ((3, 4, 5, 7, 10), (4, 5, 7, 9, 12), (6, 7, 9, 11, 14), (8, 9, 11, 13, 16), (10, 12, 14, 16, 18))
"""Least film, by rows of size and columns of speed [µm]."""


class Journal(NamedTuple):
    """A full cylindrical journal bearing."""

    diameter: float
    """D [m]."""
    width: float
    """B [m]."""
    clearance: float
    """ψ: difference of both diameters over D [-]."""

    @property
    def width_ratio(self) -> float:
        """B/D within what the laws of the film cover [-]."""
        return min(max(self.width / self.diameter, NARROWEST), WIDEST)


class FilmOil(NamedTuple):
    """The oil of a film."""

    viscosity: Callable[[float], float]
    """Dynamic viscosity η [Pa s] over its temperature [K]."""
    density: float
    """ρ [kg/m³]."""
    heat_capacity: float
    """c [J/(kg K)]."""
    supply: float
    """Temperature at which it enters [K]."""


class FilmState(NamedTuple):
    """How a journal bearing runs under one load at one speed."""

    pressure: float
    """p = F/(B D) [Pa]."""
    sliding_speed: float
    """Of both surfaces on each other [m/s]."""
    sommerfeld: float
    """So = p ψ²/(η ω) [-]."""
    eccentricity: float
    """ε [-]."""
    film: float
    """Least film thickness h_min = D ψ (1 − ε)/2 [m]."""
    friction: float
    """Coefficient of friction [-]."""
    power: float
    """Lost [W]."""
    flow: float
    """Oil that leaves at both sides [m³/s]."""
    rise: float
    """Of the oil's temperature from entry to exit [K]."""
    exit: float
    """Temperature at which it leaves [K]."""
    reynolds: float
    """ρ u c/η [-]."""


def run_film(bearing: Journal, load: float, speed: float, oil: FilmOil) -> FilmState:
    """Return how a journal bearing runs when the oil that its film presses out carries all heat away.

    The film has the viscosity of the mean of entry and exit. Oil that a pump presses through beside it, and heat that
    the metal gives off, are left out, which is on the safe side.

    Args:
        bearing: Its size.
        load: F, steady in direction [N].
        speed: ω_h that builds the film, of `film_speed` [rad/s].
        oil: That enters.

    Source: DIN 31652-1 and ISO 7902-1: f F u = ρ c Q (T_ex − T_en), T_eff = (T_en + T_ex)/2; laws of `plain`.
    """
    low, high = oil.supply, oil.supply + _HOTTEST
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        if oil.supply + _at(bearing, load, speed, oil, middle).rise / 2.0 > middle:
            low = middle
        else:
            high = middle
    return _at(bearing, load, speed, oil, 0.5 * (low + high))


def _at(bearing: Journal, load: float, speed: float, oil: FilmOil, temperature: float) -> FilmState:
    """Return how it runs with the viscosity of a temperature [K]."""
    width, diameter, clearance = bearing.width, bearing.diameter, bearing.clearance
    viscosity, laws = oil.viscosity(temperature), _laws(bearing.width_ratio)
    pressure, sliding = load / (width * diameter), speed * diameter / 2.0
    number = pressure * clearance**2 / (viscosity * speed)
    eccentricity = float(np.interp(number, laws.load, laws.eccentricity))
    friction = clearance * float(np.interp(eccentricity, laws.eccentricity, laws.friction))
    flow = diameter**3 * clearance * speed * float(np.interp(eccentricity, laws.eccentricity, laws.flow))
    if number < laws.load[0]:  # Petroff: what hardly bears rubs by its speed alone
        friction = math.pi * clearance / number
    power = friction * load * sliding
    rise = power / (oil.density * oil.heat_capacity * flow)
    return FilmState(
        pressure=pressure,
        sliding_speed=sliding,
        sommerfeld=number,
        eccentricity=eccentricity,
        film=diameter * clearance * (1.0 - eccentricity) / 2.0,
        friction=friction,
        power=power,
        flow=flow,
        rise=rise,
        exit=oil.supply + rise,
        reynolds=oil.density * sliding * diameter * clearance / (2.0 * viscosity),
    )


class _Laws(NamedTuple):
    """Laws of one width over the eccentricity."""

    eccentricity: Floats
    load: Floats
    friction: Floats
    flow: Floats


@lru_cache(maxsize=512)
def _laws(width_ratio: float) -> _Laws:
    eccentricity = 1.0 - np.geomspace(1.0 - LEAST_ECCENTRICITY, 1.0 - MOST_ECCENTRICITY, _STEPS)
    laws = (law(eccentricity, np.array(width_ratio)) for law in (film_load, friction_variable, side_flow))
    return _Laws(eccentricity, *laws)


def laminar_limit(clearance: float) -> float:
    """Return the Reynolds number up to which a film is laminar [-].

    Args:
        clearance: ψ [-].

    Source: Taylor (1923): ρ u c/η ≤ 41.3 √(R/c), with c/R = ψ.

    >>> round(laminar_limit(1e-3))
    1306
    """
    return TAYLOR / math.sqrt(clearance)


def usual_clearance(sliding_speed: float) -> float:
    """Return the relative clearance that is usual for a speed, ψ [-].

    Args:
        sliding_speed: u [m/s].

    Source: Vogelpohl: ψ = 0.8e-3 u^(1/4) with u in m/s, as textbooks print it; from memory, not checked against him.

    >>> round(1e3 * usual_clearance(16.0), 3)
    1.6
    """
    return 0.8e-3 * math.sqrt(math.sqrt(max(sliding_speed, 1e-3)))


def usual_least_film(diameter: float, sliding_speed: float) -> float:
    """Return the least film thickness of ISO 7902-3 for shafts of R_z ≤ 4 µm, h_lim [m].

    Args:
        diameter: D [m].
        sliding_speed: u [m/s].

    Source: ISO 7902-3, table of h_lim, as textbooks print it; from memory, not checked against the standard.

    >>> round(1e6 * usual_least_film(0.05, 20.0))
    7
    """
    row = _FILMS[int(np.searchsorted(_SIZES, diameter))]
    return 1e-6 * row[int(np.searchsorted(_SPEEDS, sliding_speed))]
