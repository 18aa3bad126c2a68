"""What a turboshaft does at rest at a speed, and at rest with a power."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines.power.turboshaft import HOTTEST, EngineState, Inlet, Turboshaft, state_at


def steady_state(engine: Turboshaft, inlet: Inlet, speed: float) -> EngineState:
    """Return an engine at rest at a speed of its gas generator: the heat that holds it.

    Args:
        engine: The engine.
        inlet: The air before it.
        speed: N1 [rad/s].

    Source: P_turbine = P_compressor, over T_4.

    Raises:
        ValueError: No heat holds it: beyond its ceiling or its speeds.
    """

    from scipy.optimize import brentq

    def surplus(hot: float) -> float:
        return state_at(engine, inlet, speed, hot).surplus

    low = state_at(engine, inlet, speed, HOTTEST).compressor_exit + 1.0
    if surplus(HOTTEST) < 0.0 or surplus(low) > 0.0:
        raise ValueError(f"no gas up to {HOTTEST:g} K holds {speed / engine.rated.speed:.3f} of N1")
    return state_at(engine, inlet, speed, float(brentq(surplus, low, HOTTEST, xtol=1e-9, rtol=1e-14)))


def state_for(engine: Turboshaft, inlet: Inlet, power: float, guess: tuple[float, float]) -> tuple[float, EngineState]:
    """Return the speed of the gas generator at which an engine at rest gives a power [rad/s], and its state.

    Args:
        engine: The engine.
        inlet: The air before it.
        power: Of the power turbine [W].
        guess: Speed [rad/s] and T_4 [K] near it.

    Source: Newton's method on surplus and power, over N1 and T_4.

    Raises:
        ValueError: It cannot give the power at rest.
    """
    scale = np.array([engine.rated.speed, 1000.0])

    def missing(at: Floats) -> Floats:
        if not (0.2 < at[0] < 1.6 and 0.3 < at[1] < 1e-3 * HOTTEST):
            raise ValueError(f"{power / 1e3:.4g} kW are beyond what it gives at rest in this air")
        state = state_at(engine, inlet, *(at * scale))
        return np.array([state.surplus, state.power - power]) / engine.rated.power

    at = np.array(guess) / scale
    wrong = missing(at)
    for _ in range(40):
        if np.max(np.abs(wrong)) <= 1e-12:
            break
        slopes = np.column_stack([(missing(at + step) - wrong) / 1e-6 for step in 1e-6 * np.eye(2)])
        step = -np.linalg.solve(slopes, wrong)
        at = at + step * min(1.0, 0.15 / float(np.max(np.abs(step))))
        wrong = missing(at)
    return float(at[0] * scale[0]), state_at(engine, inlet, *(at * scale))
