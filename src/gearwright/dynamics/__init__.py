"""Dynamics: a drive train as bodies and lines; its statics, modes and motion."""

from gearwright.dynamics.code_cache import VARIABLE, compiled, compiled_callback
from gearwright.dynamics.equations.modes import Modes, modes
from gearwright.dynamics.equations.statics import Equilibrium, statics
from gearwright.dynamics.model.beam import Segment, bending_shaft
from gearwright.dynamics.model.line import DampingRatio, Line, Periodic
from gearwright.dynamics.model.model import Model
from gearwright.dynamics.model.system import Arrays, Labels, System
from gearwright.dynamics.motion.ensemble import Ensemble, simulate_many
from gearwright.dynamics.motion.recorder import Outputs
from gearwright.dynamics.motion.simulate import replay, simulate
from gearwright.dynamics.motion.stepsize import Accuracy
from gearwright.dynamics.motion.trace import Orders, Samples, Statistics, Trace
from gearwright.dynamics.vibration.campbell import Campbell, campbell
from gearwright.dynamics.vibration.response import Response, frequency_response
from gearwright.dynamics.vibration.spectra import Waterfall, tone_amplitudes, waterfall
from gearwright.dynamics.vibration.speed_map import SpeedMap, speed_map
from gearwright.dynamics.vibration.steady import Orbit, periodic

__all__ = [
    "VARIABLE",
    "Accuracy",
    "Arrays",
    "Campbell",
    "DampingRatio",
    "Ensemble",
    "Equilibrium",
    "Labels",
    "Line",
    "Model",
    "Modes",
    "Orbit",
    "Orders",
    "Outputs",
    "Periodic",
    "Response",
    "Samples",
    "Segment",
    "SpeedMap",
    "Statistics",
    "System",
    "Trace",
    "Waterfall",
    "bending_shaft",
    "campbell",
    "compiled",
    "compiled_callback",
    "frequency_response",
    "modes",
    "periodic",
    "replay",
    "simulate",
    "simulate_many",
    "speed_map",
    "statics",
    "tone_amplitudes",
    "waterfall",
]
