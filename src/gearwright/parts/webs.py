"""Webs of wheels as annular plates: diametral modes with the mass of the rim, and bending by forces along the axis."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats
from gearwright.parts.material import Material

# ----------------------------------------------------------------------------------------------------------------------
# Modes of n nodal diameters: a plate that is held at the hub and free outside, with the rim's mass at its edge.
#
# f_n = λ_n²/(2π R²) √(D/(ρ t)), D = E t³/(12 (1 − ν²)). Of a bare plate λ² is tabulated; a rim as heavy as the web
# changes the shape, too, so that it is found by Ritz's method with w = Σ a_k ((r − b)/(R − b))^(k+2) cos n θ, which
# gives the tabulated ones to their digits. Left out, so that the frequency is a lower bound from two diameters on: the
# stiffness of the rim against bending and twist, a dish; and holes, which lower stiffness and mass alike.
# ----------------------------------------------------------------------------------------------------------------------


MOST_DIAMETERS = 8
"""Nodal diameters that are looked at, at most [-]."""
_TERMS = 7
"""Terms of the series [-]."""
_POINTS = 24
"""Points of the quadrature along the radius, exact for the polynomials but for 1/r [-]."""
_POISSON = 0.3


class Web(NamedTuple):
    """A flat web between hub and rim."""

    outer_radius: float
    """R, inside the rim [m]."""
    hub_radius: float
    """b [m]."""
    thickness: float
    """t [m]."""
    rim_mass: float
    """Of all outside the web, teeth among it [kg]."""


class _Forms(NamedTuple):
    """Energies of the terms on a plate of radius and stiffness 1."""

    stiffness: Floats
    mass: Floats
    """Of an area density 1."""


@lru_cache(maxsize=4096)
def _forms(ratio: float, diameters: int) -> _Forms:
    """Return the energies of the terms, for hub over outer radius and a number of nodal diameters."""
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    radius = 0.5 * (1.0 - ratio) * points + 0.5 * (1.0 + ratio)
    area = 0.5 * (1.0 - ratio) * weights * radius
    power, depth, n = np.arange(_TERMS) + 2, 1.0 - ratio, float(diameters)
    along = ((radius - ratio) / depth)[:, None]
    r = radius[:, None]
    shape, slope = along**power, power * along ** (power - 1) / depth
    bent = power * (power - 1) * along ** (power - 2) / depth**2
    around, twist = slope / r - (n / r) ** 2 * shape, n / r * (slope - shape / r)

    def over(first: Floats, second: Floats) -> Floats:
        return np.asarray((first * area[:, None]).T @ second)

    whole, odd = (2.0 * math.pi, 0.0) if diameters == 0 else (math.pi, math.pi)
    mixed = over(bent, around)
    stiffness = whole * (over(bent, bent) + over(around, around) + _POISSON * (mixed + mixed.T))
    stiffness = stiffness + 2.0 * (1.0 - _POISSON) * odd * over(twist, twist)
    return _Forms(stiffness, whole * over(shape, shape))


def frequency_number(ratio: float, diameters: int, rim: float = 0.0) -> float:
    """Return λ² of the lowest mode of a plate held inside and free outside, with a rim's mass at its edge [-].

    Args:
        ratio: Radius of the hub over that of the plate [-].
        diameters: Nodal diameters n [-].
        rim: Mass of the rim over that of the plate [-].

    Source: Ritz's method; of the bare plate Leissa, Vibration of Plates, NASA SP-160 (1969), table 2.30: 4.24, 3.48,
        5.62 and 12.4 of no to three diameters at a ratio of 0.1, 13.0, 13.3, 14.7 and 18.5 at 0.5.

    >>> [round(frequency_number(0.5, n), 1) for n in range(4)]
    [13.0, 13.3, 14.7, 18.6]
    """
    forms = _forms(round(ratio, 6), diameters)
    whole = 2.0 * math.pi if diameters == 0 else math.pi
    edge = rim * math.pi * (1.0 - ratio**2) / (2.0 * math.pi) * whole  # every term is 1 at the edge
    lower = np.linalg.cholesky(forms.mass + edge)
    half = np.linalg.solve(lower, forms.stiffness)
    return math.sqrt(float(np.linalg.eigvalsh(np.linalg.solve(lower, half.T)).min()))


def web_frequency(web: Web, diameters: int, material: Material) -> float:
    """Return the frequency of the lowest mode of a web with so many nodal diameters [Hz].

    Args:
        web: With the mass of its rim.
        diameters: n [-].
        material: Of the wheel.

    Source: f = λ²/(2π R²) √(E t²/(12 (1 − ν²) ρ)).
    """
    ratio = web.hub_radius / web.outer_radius
    plate = material.density * math.pi * (web.outer_radius**2 - web.hub_radius**2) * web.thickness
    number = frequency_number(ratio, diameters, web.rim_mass / plate)
    stiff = material.elastic_modulus / (12.0 * (1.0 - material.poisson_ratio**2) * material.density)
    return number / (2.0 * math.pi * web.outer_radius**2) * web.thickness * math.sqrt(stiff)


# ----------------------------------------------------------------------------------------------------------------------
# Bending of a web by a force along the axis at the teeth: a moment that turns with respect to the wheel.
#
# The rim stays plane and tilts. w = (A r + B r ln r + C r³ + E/r) cos θ is held at the hub, w = w' = 0, and tilts with
# the rim, w' = w/R; of these B alone carries a moment, M = 4π D B. At the hub the stress is E t w''/(2 (1 − ν²)).
# ----------------------------------------------------------------------------------------------------------------------


def tilting_factor(ratio: float) -> float:
    """Return β of σ = β M/(R t²) at the hub of a web whose rim tilts under a moment [-].

    Args:
        ratio: Radius of the hub over that of the plate, β = b/R [-].

    Source: plate theory, as Roark's Formulas for Stress and Strain, annular plates with a central trunnion.
    """
    b = ratio
    rows = np.array(
        [
            [b, b**3, 1.0 / b],  # w(b)
            [1.0, 3.0 * b**2, -1.0 / b**2],  # w'(b)
            [0.0, 2.0, -2.0],  # w'(1) − w(1)
        ]
    )
    logs = np.array([b * math.log(b), math.log(b) + 1.0, 1.0])
    _, cubic, inverse = np.linalg.solve(rows, -logs)
    bent = 1.0 / b + 6.0 * cubic * b + 2.0 * inverse / b**3
    return float(abs(6.0 * bent / (4.0 * math.pi)))


def tilting_stress(web: Web, moment: float) -> float:
    """Return the bending stress of a web at its hub under a moment across the axis [Pa].

    Args:
        web: Its sizes.
        moment: Of a force along the axis about the wheel's middle [N m].

    Source: `tilting_factor`.
    """
    return tilting_factor(web.hub_radius / web.outer_radius) * moment / (web.outer_radius * web.thickness**2)
