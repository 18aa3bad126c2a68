"""Published part load of turboshaft engines: the fuel of two decks, whose design points are given."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from gearwright.machines.power import Inlet, Rated, Turboshaft, engine_of, state_for
from gearwright.units import HORSEPOWER, POUND
from gearwright.validate.case import Case

_AVIARY = "NASA Aviary, aviary/models/engines"
_HOUR = 3600.0
_STANDARD = Inlet(288.15, 101325.0, 101325.0)
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


def _fuel(engine: Turboshaft, powers: Sequence[float]) -> list[float]:
    """Return what an engine burns at rest at sea level [lb/h]."""
    states = (state_for(engine, _STANDARD, power * HORSEPOWER, _START)[1] for power in powers)
    return [state.fuel_flow * _HOUR / POUND for state in states]


CASES = (
    Case("fuel of a turboshaft of 1120 hp at 88, 70, 52 and 40 % of its power", f"{_AVIARY}/turboshaft_1120hp", "lb/h",
         (584.447, 497.7, 410.785, 352.3),
         lambda: _fuel(_engine(1120.0, 644.0, 7.9568, 9.0), (985.511, 784.0, 582.446, 448.0)), 0.05,
         "pressure ratio and efficiencies are assumptions; the turbines keep theirs at part load"),
    Case("fuel of a turboshaft of 4465 hp at 80, 62 and 44 % of its power", f"{_AVIARY}/turboshaft_4465hp", "lb/h",
         (2185.8, 1842.1, 1513.6),
         lambda: _fuel(_engine(4465.2, 2577.5, 30.5, 9.5), (3574.9, 2780.5, 1986.1)), 0.06,
         "pressure ratio and efficiencies are assumptions; the turbines keep theirs at part load"),
)  # fmt: skip
"""Decks at sea level, Mach 0."""
