"""Published part load of turboshaft engines: the fuel of two decks, whose design points are given."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache

from gearwright.air import air_at, stagnation_ratios
from gearwright.catalogue.turboshafts import inlet_at
from gearwright.machines.power import Rated, Turboshaft, engine_of, state_for
from gearwright.units import FOOT, HORSEPOWER, POUND
from gearwright.validate.case import Case

_AVIARY = "NASA Aviary, aviary/models/engines"
_HOUR = 3600.0
_START = (4300.0, 1250.0)
"""N1 [rad/s] and T_4 [K] from which a state is looked for."""


@cache
def _engine(power: float, fuel: float, air: float, ratio: float) -> Turboshaft:
    """Return an engine of a power [hp], a fuel flow [lb/h], an air flow [lb/s] and an assumed pressure ratio [-]."""
    rated = Rated(
        power=power * HORSEPOWER,
        fuel_flow=fuel * POUND / _HOUR,
        air_flow=air * POUND,
        pressure_ratio=ratio,
        compressor=0.81,
        turbine=0.86,
        speed=4500.0,
    )
    return engine_of(rated)


def _fuel(engine: Turboshaft, powers: Sequence[float], feet: float = 0.0, mach: float = 0.0) -> list[float]:
    """Return what an engine burns at rest at powers, both over δ_t √θ_t [lb/h]."""
    theta, delta = stagnation_ratios(air_at(feet * FOOT), mach)
    factor, inlet = delta * math.sqrt(theta), inlet_at(feet * FOOT, mach)
    states = (state_for(engine, inlet, factor * power * HORSEPOWER, _START)[1] for power in powers)
    return [state.fuel_flow / factor * _HOUR / POUND for state in states]


_NOTE = "pressure ratio and efficiencies are assumptions"
_CORRECTED = f"{_NOTE}; power and fuel over δ_t √θ_t, the fuel by its size"
CASES = (
    Case("fuel of a turboshaft of 1120 hp at 88, 70, 52, 40, 28, 16 and 10 % of its power",
         f"{_AVIARY}/turboshaft_1120hp", "lb/h", (584.447, 497.7, 410.785, 352.3, 293.06, 230.177, 195.8),
         lambda: _fuel(_engine(1120.0, 644.0, 7.9568, 9.0),
                       (985.511, 784.0, 582.446, 448.0, 313.528, 179.345, 112.0)), 0.09, _NOTE),
    Case("fuel of a turboshaft of 4465 hp at 80, 62, 44, 27 and 18 % of its power",
         f"{_AVIARY}/turboshaft_4465hp", "lb/h", (2185.8, 1842.1, 1513.6, 1194.5, 1035.9),
         lambda: _fuel(_engine(4465.2, 2577.5, 30.5, 9.5), (3574.9, 2780.5, 1986.1, 1191.6, 794.4)), 0.05, _NOTE),
    Case("fuel of the first at 20 000 ft and Mach 0.5, full, 67 and 40 % of its power", f"{_AVIARY}/turboshaft_1120hp",
         "lb/h", (810.0, 558.862, 401.9),
         lambda: _fuel(_engine(1120.0, 644.0, 7.9568, 9.0), (1619.9, 1036.82, 648.0), 20e3, 0.5), 0.05, _CORRECTED),
    Case("fuel of the second at 20 000 ft and Mach 0.5, full, 64 and 37 % of its power", f"{_AVIARY}/turboshaft_4465hp",
         "lb/h", (3541.7, 2456.0, 1718.7),
         lambda: _fuel(_engine(4465.2, 2577.5, 30.5, 9.5), (7055.1, 4517.0, 2581.2), 20e3, 0.5), 0.1, _CORRECTED),
)  # fmt: skip
"""Decks at sea level without speed, and in flight."""
