"""Turbine, motor and propeller as the gearbox sees them: mass and inertia by closed laws."""

from gearwright.machines.battery import EMPTY, FULL, Battery, BatteryStep, battery_step, highest_current, stored_energy
from gearwright.machines.chart_reading import SMALL_THRUST, Blades, Charts, ideal_power
from gearwright.machines.gas_turbine import HEATING_VALUE, Engine, PowerLimits, fuel_flow, power_limits
from gearwright.machines.governor import (
    Governor,
    GovernorState,
    LimitCycle,
    Rotor,
    governor_rates,
    limit_cycle,
    marched,
)
from gearwright.machines.hamilton_standard import compressibility, performance
from gearwright.machines.motor import (
    LENGTH_RATIO,
    MotorLosses,
    motor_diameter,
    motor_loss,
    motor_mass_ndarc,
    motor_mass_power_law,
    rated_losses,
    rotor_inertia,
)
from gearwright.machines.propeller_map import (
    INSIDE,
    PropellerMap,
    angle_for_power,
    angle_for_thrust,
    blade_angles,
    coefficients,
    look_up,
)
from gearwright.machines.rotors import propeller_inertia, turbine_diameter, turbine_inertia

__all__ = [
    "EMPTY",
    "FULL",
    "HEATING_VALUE",
    "INSIDE",
    "LENGTH_RATIO",
    "SMALL_THRUST",
    "Battery",
    "BatteryStep",
    "Blades",
    "Charts",
    "Engine",
    "Governor",
    "GovernorState",
    "LimitCycle",
    "MotorLosses",
    "PowerLimits",
    "PropellerMap",
    "Rotor",
    "angle_for_power",
    "angle_for_thrust",
    "battery_step",
    "blade_angles",
    "coefficients",
    "compressibility",
    "fuel_flow",
    "governor_rates",
    "highest_current",
    "ideal_power",
    "limit_cycle",
    "look_up",
    "marched",
    "motor_diameter",
    "motor_loss",
    "motor_mass_ndarc",
    "motor_mass_power_law",
    "performance",
    "power_limits",
    "propeller_inertia",
    "rated_losses",
    "rotor_inertia",
    "stored_energy",
    "turbine_diameter",
    "turbine_inertia",
]
