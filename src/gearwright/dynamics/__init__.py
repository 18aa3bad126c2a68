"""Dynamics: a drive train as bodies and lines; its statics, modes and motion."""

from gearwright.dynamics.beam import Segment, bending_shaft
from gearwright.dynamics.campbell import Campbell, campbell
from gearwright.dynamics.ensemble import Ensemble, simulate_many
from gearwright.dynamics.line import DampingRatio, Line, Periodic
from gearwright.dynamics.model import Model
from gearwright.dynamics.modes import Modes, modes
from gearwright.dynamics.recorder import Outputs
from gearwright.dynamics.response import Response, frequency_response
from gearwright.dynamics.simulate import replay, simulate
from gearwright.dynamics.spectra import Waterfall, tone_amplitudes, waterfall
from gearwright.dynamics.speed_map import SpeedMap, speed_map
from gearwright.dynamics.statics import Equilibrium, statics
from gearwright.dynamics.steady import Orbit, periodic
from gearwright.dynamics.stepsize import Accuracy
from gearwright.dynamics.system import Arrays, Labels, System
from gearwright.dynamics.trace import Orders, Samples, Statistics, Trace

__all__ = [
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
