"""Air and the gas that burnt kerosene makes of it: heat capacity, enthalpy and entropy over temperature."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

Terms = tuple[float, ...]
REFERENCE = 298.15
"""Temperature of the enthalpies' zero, and of the heating value [K]."""
GAS_CONSTANT = 287.05
"""R of air and of its products with kerosene, which differ by less than 1e-6 [J/(kg K)]; Walsh and Fletcher, F3.22."""
_AIR = (
    0.992313e3, 0.236688e3, -1.852148e3, 6.083152e3, -8.893933e3, 7.097112e3, -3.234725e3, 0.794571e3, -0.081873e3,
)  # fmt: skip
_BURNT = (-0.718874e3, 8.747481e3, -15.863157e3, 17.254096e3, -10.233795e3, 3.081778e3, -0.361112e3, -0.003919e3, 0.0)
"""Coefficients of c_p over powers of T/1000 K [J/(kg K)]."""
_TOLERANCE = 1e-13
"""Part of a temperature to which an inverse is found [-]."""
_MOST_ROUNDS = 60


class Gas(NamedTuple):
    """What flows through a turbine."""

    fuel_ratio: float = 0.0
    """Burnt fuel over dry air f [-]."""

    @property
    def burnt(self) -> float:
        """f/(1 + f): how much of the products' coefficients counts [-]."""
        return self.fuel_ratio / (1.0 + self.fuel_ratio)


AIR = Gas()
"""Dry air."""


@lru_cache(maxsize=256)
def _coefficients(gas: Gas) -> tuple[Terms, Terms, float, Terms]:
    """Return those of c_p, of its integral, of ln T and of the rest of ∫ c_p dT/T, the highest power first."""
    capacity = tuple(a + gas.burnt * b for a, b in zip(_AIR, _BURNT, strict=True))
    integral = tuple(1e3 * value / (k + 1) for k, value in enumerate(capacity))
    rest = tuple(value / k for k, value in enumerate(capacity) if k)
    return capacity[::-1], integral[::-1], capacity[0], rest[::-1]


def _horner(terms: Terms, part: float) -> float:
    total = 0.0
    for term in terms:
        total = total * part + term
    return total


def heat_capacity(gas: Gas, temperature: float) -> float:
    """Return c_p of air or of burnt gas [J/(kg K)].

    Args:
        gas: The gas.
        temperature: T [K].

    Source: Walsh and Fletcher, Gas Turbine Performance (2004), F3.23 and F3.24.

    Valid for: 200 to 2000 K, f up to 0.05; a little below 200 K the polynomial goes on smoothly.

    >>> round(heat_capacity(AIR, 300.0), 1)
    1003.9
    """
    return _horner(_coefficients(gas)[0], temperature / 1000.0)


def enthalpy(gas: Gas, temperature: float) -> float:
    """Return the enthalpy over that at 298.15 K [J/kg].

    Args:
        gas: The gas.
        temperature: T [K].

    Source: integral of `heat_capacity`, term by term.
    """
    terms, part, zero = _coefficients(gas)[1], temperature / 1000.0, REFERENCE / 1000.0
    return _horner(terms, part) * part - _horner(terms, zero) * zero


def entropy(gas: Gas, temperature: float) -> float:
    """Return the part of the entropy that depends on temperature, φ = ∫ c_p dT/T [J/(kg K)].

    Args:
        gas: The gas.
        temperature: T [K].

    Source: integral of `heat_capacity` over T, term by term; Walsh and Fletcher, F3.28.
    """
    _, _, first, rest = _coefficients(gas)
    part = temperature / 1000.0
    return first * math.log(part) + _horner(rest, part) * part


def temperature_of(gas: Gas, wanted: float) -> float:
    """Return the temperature at which a gas has an enthalpy [K].

    Args:
        gas: The gas.
        wanted: h over that at 298.15 K [J/kg].

    Source: Newton's method on `enthalpy`, whose slope is `heat_capacity`.

    >>> round(temperature_of(AIR, enthalpy(AIR, 700.0)), 9)
    700.0
    """
    temperature = REFERENCE + wanted / 1050.0
    for _ in range(_MOST_ROUNDS):
        step = (wanted - enthalpy(gas, temperature)) / heat_capacity(gas, temperature)
        temperature += step
        if abs(step) <= _TOLERANCE * temperature:
            break
    return temperature


def isentropic(gas: Gas, temperature: float, ratio: float) -> float:
    """Return the temperature behind a change of pressure without loss [K].

    Args:
        gas: The gas.
        temperature: T before it [K].
        ratio: Pressure after over pressure before [-].

    Source: φ(T_2) = φ(T_1) + R ln(p_2/p_1); Newton's method.
    """
    wanted = entropy(gas, temperature) + GAS_CONSTANT * math.log(ratio)
    found = temperature * math.pow(ratio, 0.28)
    for _ in range(_MOST_ROUNDS):
        step = (wanted - entropy(gas, found)) * found / heat_capacity(gas, found)
        found += step
        if abs(step) <= _TOLERANCE * found:
            break
    return found
