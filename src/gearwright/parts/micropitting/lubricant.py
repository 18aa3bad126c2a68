"""An oil between flanks: viscosity, density and pressure-viscosity coefficient over temperature (ISO/TS 6336-22)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gearwright.parts.iso6336 import Value, as_value
from gearwright.parts.losses import oil_viscosity

_MM2_S = 1e-6
_KELVIN = 273.0
_AT_38 = 38.0 + _KELVIN


@dataclass(frozen=True)
class OilBase:
    """What the base stock of an oil does to friction and film."""

    lubricant: float
    """X_L in the coefficient of friction [-]."""
    scale: float
    """α_38 of an oil of 1 Pa s [1/Pa]."""
    exponent: float
    """Power of η_38 in α_38 [-]."""


_MINERAL, _PAO, _PAG = (2.657e-8, 0.1348), (1.466e-8, 0.0507), (1.392e-8, 0.1572)
BASES = {
    "mineral": OilBase(1.0, *_MINERAL),
    "polyalphaolefin": OilBase(0.8, *_PAO),
    "polyglycol": OilBase(0.7, *_PAG),
    "water-soluble polyglycol": OilBase(0.6, *_PAG),
    "phosphate ester": OilBase(1.3, *_MINERAL),
    "traction": OilBase(1.5, *_MINERAL),
}
"""Base stock -> X_L (ISO/TS 6336-22, table 3) and α_38 (eqs 9 to 11: mineral, PAO, PAG; others as mineral)."""


@dataclass(frozen=True)
class OilGrade:
    """An oil by two viscosities."""

    viscosity_40: float
    """ν_40 [m²/s]."""
    viscosity_100: float | None = None
    """ν_100 [m²/s]; None: it thins as a turbine oil does."""
    density_15: float | None = None
    """ρ_15 [kg/m³]; None: by ν_40."""
    base: OilBase = BASES["mineral"]
    """Base stock."""

    def kinematic(self, temperature: Value) -> Value:
        """Return ν [m²/s].

        Args:
            temperature: Of the oil [°C].

        Source: ISO/TR 15144-1:2014, eqs 17 to 19: lg lg(ν + 0.7) falls straight over lg T.
        """
        hot = self.viscosity_100
        if hot is None:
            hot = self.viscosity_40 * oil_viscosity(373.15) / oil_viscosity(313.15)
        warm, end = (math.log10(math.log10(viscosity / _MM2_S + 0.7)) for viscosity in (self.viscosity_40, hot))
        places = math.log10(40.0 + _KELVIN), math.log10(100.0 + _KELVIN)
        slope = (warm - end) / (places[1] - places[0])
        at = warm - slope * (np.log10(np.asarray(temperature) + _KELVIN) - places[0])
        return as_value((10.0 ** (10.0**at) - 0.7) * _MM2_S)

    def density(self, temperature: Value) -> Value:
        """Return ρ [kg/m³].

        Args:
            temperature: Of the oil [°C].

        Source: ISO/TR 15144-1:2014, eqs 20 and 21: ρ_15 − 0.7 (T − 289 K), ρ_15 = 43.37 lg ν_40 + 805.5 where unknown.
        """
        known = self.density_15
        at_15 = 43.37 * math.log10(self.viscosity_40 / _MM2_S) + 805.5 if known is None else known
        return as_value(at_15 - 0.7 * (np.asarray(temperature) + _KELVIN - 289.0))

    def dynamic(self, temperature: Value) -> Value:
        """Return η [Pa s].

        Args:
            temperature: Of the oil [°C].

        Source: ISO/TR 15144-1:2014, eq. 16.
        """
        return as_value(self.kinematic(temperature) * self.density(temperature))

    def pressure_coefficient(self, temperature: Value) -> Value:
        """Return the pressure-viscosity coefficient α [1/Pa].

        Args:
            temperature: Of the oil [°C].

        Source: ISO/TR 15144-1:2014, eqs 8 to 11: α_38 (1 + 516 (1/T − 1/311 K)).
        """
        at_38 = self.base.scale * float(self.dynamic(38.0)) ** self.base.exponent
        return as_value(at_38 * (1.0 + 516.0 * (1.0 / (np.asarray(temperature) + _KELVIN) - 1.0 / _AT_38)))
