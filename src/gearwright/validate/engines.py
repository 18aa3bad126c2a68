"""Published engines and propellers: part load of turboshafts, and propeller maps."""

import math
from collections.abc import Sequence
from functools import cache

import numpy as np

from gearwright.air import air_at, stagnation_ratios
from gearwright.base import FOOT, HORSEPOWER, POUND, Floats
from gearwright.catalogue import hamilton_standard_charts, inlet_at
from gearwright.machines import Blades, Rated, Turboshaft, engine_of, performance, state_for
from gearwright.machines.propellers import BladeShape, SectionLoads, loads
from gearwright.validate.case import Case

# ----------------------------------------------------------------------------------------------------------------------
# Published part load of turboshaft engines: the fuel of two decks, whose design points are given.
# ----------------------------------------------------------------------------------------------------------------------


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
ENGINE_CASES = (
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


# ----------------------------------------------------------------------------------------------------------------------
# Published propellers: the Hamilton Standard method in other programs' hands, and a blade-element textbook.
# ----------------------------------------------------------------------------------------------------------------------


_KNOT = 1852.0 / 3600.0
_GASP: Sequence[tuple[Blades, float, float, float, float, float]] = (
    (Blades(4, 114.0, 0.5), 10.5, 0.0, 0.1, 1850.0, 800.0),
    (Blades(4, 114.0, 0.5), 10.5, 0.0, 125.0, 1850.0, 800.0),
    (Blades(4, 150.0, 0.5), 12.0, 1e4, 200.0, 1000.0, 769.7),
    (Blades(3, 150.0, 0.5), 12.0, 1e4, 200.0, 1000.0, 750.0),
    (Blades(4, 150.0, 0.65), 12.0, 1e4, 200.0, 900.0, 750.0),
    (Blades(4, 150.0, 0.65), 12.0, 1e4, 200.0, 750.0, 750.0),
)
"""Blades, diameter [ft], altitude [ft], speed [kt], power [hp], tip speed [ft/s]."""


def _charted() -> list[float]:
    """Return C_T of GASP's propellers."""
    charts, thrusts = hamilton_standard_charts(), []
    for blades, feet, altitude, knots, horsepower, tip in _GASP:
        air, diameter, airspeed = air_at(altitude * FOOT), feet * FOOT, knots * _KNOT
        turns = tip * FOOT / (math.pi * diameter)
        found = performance(
            charts,
            blades,
            airspeed / (turns * diameter),
            power_coefficient=horsepower * HORSEPOWER / (air.density * turns**3 * diameter**5),
            mach=airspeed / air.sound_speed,
            tip_mach=tip * FOOT / air.sound_speed,
        )
        thrusts.append(found.thrust_coefficient)
    return thrusts


def _linear(angle: Floats, design_lift: Floats, thickness: Floats, mach: Floats) -> SectionLoads:
    """Return c_l = 6.2 α, c_d = 0.008 - 0.003 c_l + 0.01 c_l²."""
    del design_lift, thickness, mach
    lift = 6.2 * angle
    return SectionLoads(lift, 0.008 - 0.003 * lift + 0.01 * lift**2)


def _textbook() -> tuple[list[float], list[float]]:
    """Return thrust [N] and torque [N m] of a propeller of 1.6 m at 2100 rpm and 1, 10, 20, 30 and 40 m/s."""
    radius, diameter, turns, density = np.linspace(0.08, 0.8, 11), 1.6, 35.0, 1.225
    at, none = math.atan(1.0 / (2.0 * math.pi * 0.6)), np.zeros(11)
    shape = BladeShape(
        number=2,
        radius=radius / 0.8,
        width=np.full(11, 0.09),
        chord=np.full(11, 0.125),
        twist=np.arctan(1.0 / (2.0 * math.pi * radius)) - at,
        design_lift=none,
        thickness=none,
        polar=_linear,
        losses=False,
    )
    found = loads(shape, np.array([1.0, 10.0, 20.0, 30.0, 40.0]) / (turns * diameter), at)
    unit = density * turns**2 * diameter**4
    return (found.thrust * unit).tolist(), (found.power * unit * diameter / (2.0 * math.pi)).tolist()


_BOOK = "Aerodynamics for Students, as pinned in CCBlade.jl's tests"
PROPELLER_CASES = (
    Case("propeller thrust coefficient by the Hamilton Standard method, six propellers",
         "GASP, in NASA Aviary's test_propeller_performance.py", "-",
         (0.27651, 0.20518, 0.09694, 0.10189, 0.08523, 0.06463), _charted, 1.4e-3, "GASP stops its search at 1e-3"),
    Case("propeller of two blades by blade elements, 1 to 40 m/s, thrust", _BOOK, "N",
         (1045.361193, 843.134981, 551.815917, 195.775319, -213.169213), lambda: _textbook()[0], 2e-5,
         "where its iteration stops"),
    Case("propeller of two blades by blade elements, 1 to 40 m/s, torque", _BOOK, "N m",
         (80.363869, 80.514192, 68.246728, 33.971104, -30.398095), lambda: _textbook()[1], 3e-5,
         "where its iteration stops"),
)  # fmt: skip
"""Charts and elements."""
