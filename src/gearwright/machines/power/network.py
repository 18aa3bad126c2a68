"""A network of heat: capacities, conductances between them and to what they cannot warm, exact over an interval."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats


class Network(NamedTuple):
    """Bodies of one temperature each, in one order."""

    capacity: Floats
    """C of each body, shape (bodies,) [J/K]."""
    between: Floats
    """G between bodies, symmetric, its diagonal not read, shape (bodies, bodies) [W/K]."""
    outside: Floats
    """G from bodies to surroundings, shape (bodies, surroundings) [W/K]."""


class Warmed(NamedTuple):
    """A network after an interval."""

    temperature: Floats
    """Of each body at its end, shape (bodies,) [K]."""
    mean: Floats
    """Mean of the interval, shape (bodies,) [K]."""
    rejected: Floats
    """Mean heat into each of the surroundings, shape (surroundings,) [W]."""


def _matrix(network: Network) -> Floats:
    """Return K of Q = K T - G_out T_out, shape (bodies, bodies) [W/K]."""
    links = network.between - np.diag(np.diag(network.between))
    return np.asarray(np.diag(links.sum(axis=1) + network.outside.sum(axis=1)) - links)


def steady(network: Network, heat: Floats, surroundings: Floats) -> Floats:
    """Return the temperatures at which a network comes to rest, shape (bodies,) [K].

    Args:
        network: The network.
        heat: Into each body, shape (bodies,) [W].
        surroundings: Their temperatures, shape (surroundings,) [K].

    Source: K T = Q + G_out T_out.
    """
    return np.asarray(np.linalg.solve(_matrix(network), heat + network.outside @ surroundings), float)


def warmed(network: Network, temperature: Floats, heat: Floats, *, surroundings: Floats, duration: float) -> Warmed:
    """Return a network after an interval of constant heat and surroundings.

    What it stores and rejects adds up to what heats it, to rounding: no step is too long.

    Args:
        network: The network.
        temperature: Of each body at the start, shape (bodies,) [K].
        heat: Into each body, shape (bodies,) [W].
        surroundings: Their temperatures, shape (surroundings,) [K].
        duration: [s].

    Source: C dT/dt = Q - K T + G_out T_out, by the modes of C^-1/2 K C^-1/2; e^-x and φ(x) = (1 - e^-x)/x are exact.
    """
    root = np.sqrt(network.capacity)
    rates, modes = np.linalg.eigh(_matrix(network) / np.outer(root, root))
    decays = np.maximum(rates, 0.0) * duration
    first = _mean_decay(decays)
    start, driven = modes.T @ (root * temperature), modes.T @ ((heat + network.outside @ surroundings) / root)
    end = np.exp(-decays) * start + first * duration * driven
    middle = first * start + _mean_rise(decays, first) * duration * driven
    mean = modes @ middle / root
    rejected = network.outside.T @ mean - network.outside.sum(axis=0) * surroundings
    return Warmed(modes @ end / root, mean, rejected)


def _mean_decay(decays: Floats) -> Floats:
    small = np.where(decays < 1e-8, 1.0, decays)
    return np.where(decays < 1e-8, 1.0 - 0.5 * decays, -np.expm1(-small) / small)


def _mean_rise(decays: Floats, first: Floats) -> Floats:
    """(1 - φ)/x, by its series where it would cancel."""
    small = np.where(decays < 1e-3, 1.0, decays)
    series = 0.5 - decays / 6.0 + decays**2 / 24.0 - decays**3 / 120.0
    return np.where(decays < 1e-3, series, (1.0 - first) / small)
