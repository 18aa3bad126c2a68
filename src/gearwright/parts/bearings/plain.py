"""Hydrodynamic journal bearings of finite width: load capacity, friction, oil flow, heat balance."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.elementwise import Values, functions

# ----------------------------------------------------------------------------------------------------------------------
# Hydrodynamic journal bearings of finite width under a steady load: what their film bears, rubs and lets out.
#
# Dimensionless laws over eccentricity ε and width B/D for a full cylindrical bearing whose film begins where the gap
# is widest and ruptures where pressure would fall below that around it (Reynolds' condition). Both limits are closed:
# the very narrow bearing of Ocvirk, the very wide one of Sommerfeld and Gümbel. Between them stand constants that
# were fitted to solutions of Reynolds' equation by finite differences, which
# `tests/verification/test_journal_film.py` makes anew.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_ECCENTRICITY, MOST_ECCENTRICITY = 0.02, 0.98
"""Range of ε that the fit of the load covers [-]."""
NARROWEST, WIDEST = 0.1, 2.0
"""Range of B/D that the fits cover [-]."""
_WIDE = (-0.4882, 0.6227)
_BLEND = ((0.9411, -0.0074, 0.0723, -0.1745), (0.0617, -0.1662, -0.0681), (-0.003, 0.1302))
"""Fitted: what rupture adds to the wide limit over ε² and ε⁴; the exponent that joins both limits, as polynomials of ε
before 1, B/D and (B/D)²."""
_FLOW = (0.8956, -0.0313, -0.0329, 0.1428)
_ATTITUDE = (-0.4589, 2.2464, -3.037, 1.3529, 0.0599, -0.8336)
TAYLOR = 41.3
"""Of the Reynolds number at which vortices begin between cylinders of which one turns [-] (Taylor 1923)."""


def narrow_load(eccentricity: Floats, width_ratio: Floats) -> Floats:
    """Return the Sommerfeld number of a very narrow bearing [-].

    Args:
        eccentricity: ε [-].
        width_ratio: B/D [-].

    Source: DuBois and Ocvirk, NACA TR 1157 (1953): So = (B/D)² ε/(2 (1 − ε²)²) √(π² (1 − ε²) + 16 ε²).
    """
    left = 1.0 - eccentricity**2
    return np.asarray(
        width_ratio**2 * eccentricity / (2.0 * left**2) * np.sqrt(np.pi**2 * left + 16.0 * eccentricity**2)
    )


def wide_load(eccentricity: Floats) -> Floats:
    """Return the Sommerfeld number of a very wide bearing whose film ends at the narrowest place [-].

    Args:
        eccentricity: ε [-].

    Source: Sommerfeld (1904) with Gümbel's half film: So = 3 ε √(π² (1 − ε²) + 4 ε²)/((2 + ε²)(1 − ε²)).
    """
    square = eccentricity**2
    force = 3.0 * eccentricity * np.sqrt(np.pi**2 * (1.0 - square) + 4.0 * square)
    return np.asarray(force / ((2.0 + square) * (1.0 - square)))


def film_load(eccentricity: Floats, width_ratio: Floats) -> Floats:
    """Return the Sommerfeld number that an eccentricity bears, So = p ψ²/(η ω) [-].

    Args:
        eccentricity: ε [-].
        width_ratio: B/D [-].

    Source: Reynolds' equation, Reynolds' rupture; fitted to 1.3 % for 0.02 ≤ ε ≤ 0.97, 2.6 % at 0.98.

    Valid for: 0.1 ≤ B/D ≤ 2; laminar, isoviscous oil, rigid and parallel surfaces.
    """
    eps, ratio = np.asarray(eccentricity, dtype=np.float64), np.asarray(width_ratio, dtype=np.float64)
    wide = wide_load(eps) * (1.0 + _WIDE[0] * eps**2 + _WIDE[1] * eps**4)
    free, once, twice = (np.polynomial.polynomial.polyval(eps, np.array(row)) for row in _BLEND)
    joined = free + ratio * once + ratio**2 * twice
    return np.asarray((narrow_load(eps, ratio) ** -joined + wide**-joined) ** (-1.0 / joined))


def attitude_angle(eccentricity: Floats, width_ratio: Floats) -> Floats:
    """Return the angle between the load and the narrowest place of the gap, β [rad].

    Args:
        eccentricity: ε [-].
        width_ratio: B/D [-].

    Source: Ocvirk's tan β = π √(1 − ε²)/(4 ε), and what a finite width adds, fitted to 1.1°.

    Valid for: 0.1 ≤ ε ≤ 0.98 and 0.1 ≤ B/D ≤ 2.
    """
    eps, ratio = np.asarray(eccentricity), np.asarray(width_ratio)
    first, second, third, fourth, wide, slim = _ATTITUDE
    more = (first + second * eps + third * eps**2 + fourth * eps**3) * ratio / (1.0 + wide * ratio + slim * eps)
    return np.asarray(np.arctan(np.pi * np.sqrt(1.0 - eps**2) / (4.0 * eps) * (1.0 + more)))


def friction_variable(eccentricity: Floats, width_ratio: Floats) -> Floats:
    """Return the coefficient of friction over the relative clearance, f/ψ [-].

    Args:
        eccentricity: ε [-].
        width_ratio: B/D [-].

    Source: shear of a film all around, and the moment of its load: π/(So √(1 − ε²)) + ε sin β/2 (DIN 31652-1).
    """
    eps = np.asarray(eccentricity)
    shear = np.pi / (film_load(eps, width_ratio) * np.sqrt(1.0 - eps**2))
    return np.asarray(shear + eps / 2.0 * np.sin(attitude_angle(eps, width_ratio)))


def side_flow(eccentricity: Floats, width_ratio: Floats) -> Floats:
    """Return the oil that the film's own pressure presses out at both sides, over D³ ψ ω [-].

    Args:
        eccentricity: ε [-].
        width_ratio: B/D [-].

    Source: very narrow bearings ε (B/D)/4 (Ocvirk); a finite width lets out tanh(k B/D)/(k B/D) of it, k fitted to
        1.4 %.

    Valid for: 0.1 ≤ B/D ≤ 2.
    """
    eps, ratio = np.asarray(eccentricity), np.asarray(width_ratio)
    reach = ratio * (_FLOW[0] + _FLOW[1] * ratio + _FLOW[2] * eps + _FLOW[3] * ratio * eps)
    return np.asarray(0.25 * eps * ratio * np.tanh(reach) / reach)


def film_speed(journal: float, bush: float, load: float = 0.0) -> float:
    """Return the speed that builds a film: of both surfaces against the load's direction together [rad/s].

    A film of a load that stands still is dragged in by the mean of both surfaces. Seen from a load that turns, both
    turn less by its speed. A planet's load stands still in its carrier, and so does its pin: what builds the film is
    the planet's speed against the carrier, whole.

    Args:
        journal: Of the pin [rad/s].
        bush: Of the planet [rad/s].
        load: Of the direction of the load; of a planet that of its carrier [rad/s].

    Source: Reynolds' equation, ω_h = ω_J + ω_B − 2 ω_F (DIN 31652-1, ISO 7902-1).

    >>> film_speed(470.0, 470.0 + 1300.0, 470.0)
    1300.0
    >>> film_speed(100.0, 0.0, 50.0)  # a load that turns at half the speed of the shaft is not borne
    0.0
    """
    return abs(journal + bush - 2.0 * load)


# ----------------------------------------------------------------------------------------------------------------------
# How a journal bearing runs: where heat that its film makes and heat that its oil carries away stand in balance.
# ----------------------------------------------------------------------------------------------------------------------


_STEPS = 481
"""Of the tables over ε that one bearing is read from: linear between them errs by less than 1e-4 [-]."""
_HOTTEST = 400.0
"""Rise of the oil's mean temperature beyond which none is looked for [K]."""
_ROUNDS = 40
"""In which that mean is found, at most: mostly six are enough [-]."""
_STILL = 1e-9
"""Difference of that mean and what heat makes of it, that counts as none [K]."""
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

    viscosity: Callable[[Values], Values]
    """Dynamic viscosity η [Pa s] over its temperature [K]."""
    density: float
    """ρ [kg/m³]."""
    heat_capacity: float
    """c [J/(kg K)]."""
    supply: Values
    """Temperature at which it enters [K]."""


class FilmState(NamedTuple):
    """How a journal bearing runs under one load at one speed."""

    pressure: Values
    """p = F/(B D) [Pa]."""
    sliding_speed: Values
    """Of both surfaces on each other [m/s]."""
    sommerfeld: Values
    """So = p ψ²/(η ω) [-]."""
    eccentricity: Values
    """ε [-]."""
    film: Values
    """Least film thickness h_min = D ψ (1 − ε)/2 [m]."""
    friction: Values
    """Coefficient of friction [-]."""
    power: Values
    """Lost [W]."""
    flow: Values
    """Oil that leaves at both sides [m³/s]."""
    rise: Values
    """Of the oil's temperature from entry to exit [K]."""
    exit: Values
    """Temperature at which it leaves [K]."""
    reynolds: Values
    """ρ u c/η [-]."""


def run_film(bearing: Journal, load: Values, speed: Values, oil: FilmOil) -> FilmState:
    """Return how a journal bearing runs when the oil that its film presses out carries all heat away.

    The film has the viscosity of the mean of entry and exit. Oil that a pump presses through beside it, and heat that
    the metal gives off, are left out, which is on the safe side.

    Args:
        bearing: Its size.
        load: F, steady in direction, above 0 [N].
        speed: ω_h that builds the film, of `film_speed`, above 0 [rad/s].
        oil: That enters.

    Source: DIN 31652-1 and ISO 7902-1: f F u = ρ c Q (T_ex − T_en), T_eff = (T_en + T_ex)/2; laws of `plain`. The mean
        temperature by the rule of false position, which halves what an end has that stays (Illinois).
    """
    of = functions(load, speed, oil.supply)

    def colder(mean: Values) -> Values:
        return oil.supply + _at(bearing, load, speed, oil, mean).rise / 2.0 - mean

    low, high = oil.supply, oil.supply + _HOTTEST
    at_low, at_high = colder(low), colder(high)
    stayed, mean = 0.0, high
    for _ in range(_ROUNDS):
        mean = (low * at_high - high * at_low) / of.where(at_high < at_low, at_high - at_low, -1.0)
        mean = of.where(at_high < 0.0, mean, high)
        at_mean = colder(mean)
        if np.all(np.abs(at_mean) < _STILL):
            break
        warmer = at_mean > 0.0
        at_low, at_high = (
            of.where(warmer, at_mean, of.where(stayed < 0.0, 0.5, 1.0) * at_low),
            of.where(warmer, of.where(stayed > 0.0, 0.5, 1.0) * at_high, at_mean),
        )
        low, high, stayed = of.where(warmer, mean, low), of.where(warmer, high, mean), of.where(warmer, 1.0, -1.0)
    return _at(bearing, load, speed, oil, mean)


def _at(bearing: Journal, load: Values, speed: Values, oil: FilmOil, temperature: Values) -> FilmState:
    """Return how it runs with the viscosity of a temperature [K]."""
    width, diameter, clearance = bearing.width, bearing.diameter, bearing.clearance
    viscosity, laws = oil.viscosity(temperature), _laws(bearing.width_ratio)
    pressure, sliding = load / (width * diameter), speed * diameter / 2.0
    of, number = functions(load, speed, temperature), pressure * clearance**2 / (viscosity * speed)
    eccentricity = of.interp(number, laws.load, laws.eccentricity)
    friction = clearance * of.interp(eccentricity, laws.eccentricity, laws.friction)
    flow = diameter**3 * clearance * speed * of.interp(eccentricity, laws.eccentricity, laws.flow)
    # Petroff: what hardly bears rubs by its speed alone.
    friction = of.where(number < laws.load[0], math.pi * clearance / number, friction)
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
