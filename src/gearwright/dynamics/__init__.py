"""Dynamics: a drive train as bodies and lines; its statics, modes and motion."""

from gearwright.dynamics.line import DampingRatio, Line, Periodic
from gearwright.dynamics.model import Model
from gearwright.dynamics.system import Arrays, Labels, System

__all__ = ["Arrays", "DampingRatio", "Labels", "Line", "Model", "Periodic", "System"]
