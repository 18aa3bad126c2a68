"""What shakes a train and how it answers: Campbell diagram, critical speeds, responses, spectra, run-ups.

Single runs through time are in `motion`.
"""

from gearwright.dynamics.vibration.campbell import Campbell, Order, campbell
from gearwright.dynamics.vibration.critical_speeds import (
    RESONANCE,
    SEPARATION,
    SWING,
    Criterion,
    CriticalSpeed,
    SpeedCase,
    critical_speeds,
    order_name,
    turning_shaft,
)
from gearwright.dynamics.vibration.forced import forced_factors
from gearwright.dynamics.vibration.judged import motion_checks, peak_checks, resonance_checks
from gearwright.dynamics.vibration.planetary_results import load_shares, mode_families
from gearwright.dynamics.vibration.rated_peaks import DynamicLoad, ShaftLoad, dynamic_loads, shaft_loads
from gearwright.dynamics.vibration.response import Peak, Response, frequency_response, peaks
from gearwright.dynamics.vibration.runup import Loudest, RunUp, loudest_speeds, run_up
from gearwright.dynamics.vibration.spectra import Waterfall, tone_amplitudes, waterfall
from gearwright.dynamics.vibration.speed_map import SpeedMap, speed_map
from gearwright.dynamics.vibration.steady import Orbit, common_period, periodic
from gearwright.dynamics.vibration.transmission import answer, first_meshes

__all__ = [
    "RESONANCE",
    "SEPARATION",
    "SWING",
    "Campbell",
    "Criterion",
    "CriticalSpeed",
    "DynamicLoad",
    "Loudest",
    "Orbit",
    "Order",
    "Peak",
    "Response",
    "RunUp",
    "ShaftLoad",
    "SpeedCase",
    "SpeedMap",
    "Waterfall",
    "answer",
    "campbell",
    "common_period",
    "critical_speeds",
    "dynamic_loads",
    "first_meshes",
    "forced_factors",
    "frequency_response",
    "load_shares",
    "loudest_speeds",
    "mode_families",
    "motion_checks",
    "order_name",
    "peak_checks",
    "peaks",
    "periodic",
    "resonance_checks",
    "run_up",
    "shaft_loads",
    "speed_map",
    "tone_amplitudes",
    "turning_shaft",
    "waterfall",
]
