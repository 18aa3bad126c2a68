"""Compiled integrators: the adaptive Runge-Kutta pair of Tsitouras, and implicit steps for truly stiff systems."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic

from gearwright.base import Floats
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.equations import kernel
from gearwright.dynamics.equations.kernel import drive_columns
from gearwright.dynamics.model import Arrays, Profile, line_matrix

# ----------------------------------------------------------------------------------------------------------------------
# Call: generated code from compiled loops, by its address.
# ----------------------------------------------------------------------------------------------------------------------


def _call(_: Any, address: Any, p: Any, row: Any, y: Any, dy: Any, out: Any) -> Any:
    """Return how numba is to call code at an address."""
    signature = types.void(address, p, row, y, dy, out)

    def build(context: Any, builder: Any, _: Any, arguments: Any) -> Any:
        pointer = ir.IntType(8).as_pointer()
        function = ir.FunctionType(ir.VoidType(), [pointer] * 5).as_pointer()
        places = [builder.inttoptr(argument, pointer) for argument in arguments[1:]]
        builder.call(builder.inttoptr(arguments[0], function), places)
        return context.get_dummy_value()

    return signature, build


call_generated: Any = intrinsic(_call)
"""(address, parameters, clock row, state, slope, output), all addresses: calls a right-hand side of `Compiled`."""


# ----------------------------------------------------------------------------------------------------------------------
# Adaptive steps: the 5(4) pair of Tsitouras with a PI controller, over the generated or the generic right-hand side.
#
# Steps are as long as the local error allows; the record's rows, evenly spaced, are read off the interpolant. Each
# block begins afresh with a step of one row, so that a run that is taken up again at a checkpoint repeats itself bit
# for bit.
#
# Source: Tsitouras 2011, Comput. Math. Appl. 62, 770, table 1 (pair and interpolant); Hairer, Nørsett, Wanner 1993,
# Solving Ordinary Differential Equations I, IV.2 of part II (controller).
# ----------------------------------------------------------------------------------------------------------------------


NODES = np.array([0.0, 0.161, 0.327, 0.9, 0.9800255409045097, 1.0, 1.0])
STAGES = np.zeros((7, 7))
STAGES[1, :1] = 0.161
STAGES[2, :2] = -0.008480655492356989, 0.335480655492357
STAGES[3, :3] = 2.8971530571054935, -6.359448489975075, 4.3622954328695815
STAGES[4, :4] = 5.325864828439257, -11.748883564062828, 7.4955393428898365, -0.09249506636175525
STAGES[5, :5] = 5.86145544294642, -12.92096931784711, 8.159367898576159, -0.071584973281401, -0.028269050394068383
STAGES[6, :6] = 0.09646076681806523, 0.01, 0.4798896504144996, 1.379008574103742, -3.2900695154360807, 2.324710524099774
EMBEDDED = np.zeros(7)
EMBEDDED[:4] = 0.001780011052225777, 0.0008164344596567469, -0.007880878010261995, 0.1447110071732629
EMBEDDED[4:] = -0.5823571654525552, 0.45808210592918697, -1.0 / 66.0
"""Weights of the fifth-order result less those of the embedded fourth-order one."""


def _interpolant() -> Floats:
    """Return the slopes' weights in y(t + θ h) − y: coefficients of θ, θ², θ³, θ⁴ for each, shape (7, 4)."""
    quadratics = [
        (1.4364028541716351, 0.7139816917074209),
        (2.1966568338249754, 1.2949852507374631),
        (2.38535645472061657, 1.57803468208092486),
        (1.21712927295533244 + 0.61620406037800089, 1.21712927295533244 * 0.61620406037800089),
        (1.203071208372362603 + 0.658047292653547382, 1.203071208372362603 * 0.658047292653547382),
        (1.2 + 2.0 / 3.0, 0.8),
        (1.6, 0.6),
    ]
    leading = (-1.0530884977290216, 0.1017, 2.490627285651252793, -16.54810288924490272, 47.37952196281928122)
    rows = [
        scale * np.array([0.0, product, -total, 1.0])
        for scale, (total, product) in zip((*leading, -34.87065786149660974, 2.5), quadratics, strict=True)
    ]
    total, product = quadratics[0]
    rows[0] = leading[0] * np.convolve([-1.3299890189751412, 1.0], [product, -total, 1.0])
    return np.array(rows)


INTERPOLANT = _interpolant()
LONGEST = 32.0
"""Longest step in rows of the record, so that no short load is stepped over [-]."""
SHORTEST = 1e-9
"""Shortest step in rows of the record: below it the motion cannot be followed [-]."""
SAFETY, LEAST, MOST, PROPORTIONAL, MEMORY = 0.9, 0.2, 10.0, 0.17, 0.04
"""The controller: h times 0.9 err^−0.17 err_before^0.04, between a fifth and ten times."""


class Right(NamedTuple):
    """A right-hand side."""

    address: int
    """Of the generated code; 0 runs the generic one."""
    numbers: Floats
    """Parameters of the generated code."""
    row: Floats
    """Its row of the clock table."""
    now: kernel.Instant
    """The same for the generic code."""


class Step(NamedTuple):
    """One adaptive step."""

    start: float
    """[s]."""
    length: float
    """[s]."""


class Limits(NamedTuple):
    """What a step may be off by."""

    mass: Floats
    """Weight of each squared error of velocity in its energy [kg or kg m²], shape (coordinates,)."""
    stiffness: Floats
    """Weight of each squared error of position [N/m or N m/rad], shape (coordinates,)."""
    energy: float
    """Energy that the error of one step may hold [J]."""


def limits(arrays: Arrays, tolerance: float) -> Limits:
    """Return the limits of a step: the energy of its error, every coordinate by itself.

    Args:
        arrays: The system's numbers.
        tolerance: Root of the energy [√J].
    """
    stiffness = (line_matrix(arrays) ** 2).T @ arrays.stiffness
    return Limits(0.5 * arrays.mass, 0.5 * stiffness, tolerance**2)


@compiled
def _set_clock(arrays: Arrays, right: Right, time: float) -> None:
    """Set what the clock alone decides."""
    if right.address == 0:
        kernel.set_instant(arrays, time, right.now)
        return
    profile: Profile = arrays.profile
    factor, slope, travel = kernel.speed_factor(profile, time)
    schedules = arrays.loads.schedules
    waves = (len(right.row) - 2 - len(schedules.dof) - len(arrays.drives.inputs.dof)) // 2
    for i in range(len(arrays.tone_rate)):
        angle = arrays.tone_rate[i] * travel
        right.row[i], right.row[waves + i] = np.cos(angle), np.sin(angle)
    right.row[2 * waves], right.row[2 * waves + 1] = factor, slope
    for i in range(len(schedules.dof)):
        points = slice(schedules.start[i], schedules.start[i + 1])
        right.row[2 * waves + 2 + i] = np.interp(time, schedules.time[points], schedules.value[points])
    if len(arrays.drives.table):
        kernel.fill_inputs(arrays.drives.inputs, time, right.row[2 * waves + 2 + len(schedules.dof) :])


@compiled
def _slope(arrays: Arrays, right: Right, state: Floats, slope: Floats, output: Floats) -> None:
    """Fill derivative, line forces and deflections at the instant that is set."""
    if right.address == 0:
        kernel.derivative(arrays, right.now, state, slope, output)
    else:
        numbers, row, y = right.numbers.ctypes.data, right.row.ctypes.data, state.ctypes.data
        call_generated(right.address, numbers, row, y, slope.ctypes.data, output.ctypes.data)


@compiled
def _combine(start: Floats, length: float, weights: Floats, slopes: Floats, result: Floats) -> None:
    """Fill start + length Σ weight slope."""
    for i in range(len(result)):
        result[i] = start[i]
    for stage in range(len(weights)):
        share = length * weights[stage]
        if share != 0.0:
            for i in range(len(result)):
                result[i] += share * slopes[stage, i]


@compiled
def _error(limit: Limits, length: float, slopes: Floats, result: Floats) -> float:
    """Return the step's local error over the one that is allowed."""
    result[:] = 0.0
    _combine(result, length, EMBEDDED, slopes, result)
    size, energy = len(limit.mass), 0.0
    for i in range(size):
        energy += limit.stiffness[i] * result[i] ** 2 + limit.mass[i] * result[size + i] ** 2
    return float(np.sqrt(energy / limit.energy))


@compiled
def attempt(arrays: Arrays, right: Right, step: Step, state: Floats, slopes: Floats, ahead: Floats) -> None:
    """Fill the slopes of a step and the state after it."""
    output = np.empty(2 * len(arrays.stiffness) + drive_columns(arrays.drives.table, arrays.drives.start))
    for stage in range(1, 7):
        if stage < 6:
            _set_clock(arrays, right, step.start + NODES[stage] * step.length)
        _combine(state, step.length, STAGES[stage, :stage], slopes, ahead)
        _slope(arrays, right, ahead, slopes[stage], output)


@compiled
def march_adaptive(
    arrays: Arrays, right: Right, first: int, h: float, limit: Limits, record: Floats, state: Floats
) -> tuple[int, bool, float]:
    """Advance over the rows of `record` with steps of any length.

    Return how many were tried, whether the block's end was reached, and the time reached: motions that cannot be
    followed end early.
    """
    width, size = len(state), len(arrays.mass)
    slopes, ahead, spare = np.zeros((7, width)), np.empty(width), np.empty(width)
    start, end = first * h, len(record) * h
    time, pace, before, row, tried, late = 0.0, h, 1e-4, 0, 0, False
    _set_clock(arrays, right, start)
    _slope(arrays, right, state, slopes[0], record[0, 2 * size :])
    while time < end:
        length = min(pace, end - time)
        last = length >= end - time
        if not length > SHORTEST * h and not last:
            break
        step = Step(start + time, length)
        attempt(arrays, right, step, state, slopes, ahead)
        error, tried = _error(limit, length, slopes, spare), tried + 1
        if not error <= 1.0:
            # An error that is no number shortens the step as far as any.
            pace = length * (max(LEAST, SAFETY * error**-PROPORTIONAL) if error < np.inf else LEAST)
            late = True
            continue
        while row < len(record) and (last or row * h <= time + length):
            read_row(arrays, right, step, row * h - time, state, slopes, record[row])
            row += 1
        growth = SAFETY * max(error, 1e-10) ** -PROPORTIONAL * before**MEMORY
        pace = min(length * min(1.0 if late else MOST, max(LEAST, growth)), LONGEST * h)
        before, late = max(error, 1e-4), False
        time = end if last else time + length
        state[:], slopes[0] = ahead, slopes[6]
    return tried, time >= end, start + time


@compiled
def read_row(
    arrays: Arrays, right: Right, step: Step, since: float, state: Floats, slopes: Floats, row: Floats
) -> None:
    """Fill a row of the record (q, q̇, forces, deflections) from a step's interpolant, some time after its start."""
    size, theta = len(arrays.mass), since / step.length
    weights, inside, slope = np.empty(7), np.empty(len(state)), np.empty(len(state))
    for stage in range(7):
        b = INTERPOLANT[stage]
        weights[stage] = theta * (b[0] + theta * (b[1] + theta * (b[2] + theta * b[3])))
    _combine(state, step.length, weights, slopes, inside)
    _set_clock(arrays, right, step.start + since)
    _slope(arrays, right, inside, slope, row[2 * size :])
    row[: 2 * size] = inside[: 2 * size]


# ----------------------------------------------------------------------------------------------------------------------
# Implicit steps for truly stiff systems: the generalized-α method with Newton's method on contact and stiffness.
#
# Source: Chung, Hulbert 1993, J. Appl. Mech. 60, 371: second order, stable at any step, its high-frequency damping set
# by ρ∞. It starts afresh at every block, so that a replay repeats itself.
# ----------------------------------------------------------------------------------------------------------------------


RADIUS = 0.8
"""ρ∞: what is left of an unresolved vibration after each step [-]."""
NEWTON = 12
"""Rounds in which contact must settle within a step; what is left then shows in the error estimate."""
SETTLED = 1e-10
"""Change of acceleration over the largest at which Newton's method stops [-]."""


class Shares(NamedTuple):
    """By how much the unbalanced force changes with the acceleration at the end of a step."""

    damping: float
    """Through the velocity there [s]."""
    stiffness: float
    """Through the position there [s²]."""
    mass: float
    """Through the inertia force [-]."""


@compiled
def fill_tangent(arrays: Arrays, shares: Shares, damping: Floats, closed: Floats, tangent: Floats) -> None:
    """Fill the derivative of the unbalanced force by the acceleration."""
    for i in range(len(arrays.mass)):
        for j in range(len(arrays.mass)):
            tangent[i, j] = shares.damping * damping[i, j]
        tangent[i, i] += shares.mass * arrays.mass[i]
    for line in range(len(closed)):
        for a in range(arrays.line_start[line], arrays.line_start[line + 1]):
            for b in range(arrays.line_start[line], arrays.line_start[line + 1]):
                stiffness = arrays.line_weight[a] * arrays.line_weight[b] * closed[line]
                tangent[arrays.line_dof[a], arrays.line_dof[b]] += shares.stiffness * stiffness


@compiled
def touching_stiffness(arrays: Arrays, now: kernel.Instant, deflection: Floats, out: Floats) -> None:
    """Fill the stiffness of each line, nothing where it stands open."""
    for j in range(len(out)):
        open_ = arrays.backlash[j] > 0.0 and -arrays.backlash[j] <= deflection[j] <= 0.0
        out[j] = 0.0 if open_ else now.stiffness[j]


@compiled
def march_implicit(
    arrays: Arrays, now: kernel.Instant, first: int, h: float, damping: Floats, record: Floats, state: Floats
) -> None:
    """Advance by one step for each row of `record`, as `kernel.runge_kutta` does; `damping` of the whole system."""
    size, lines = len(arrays.mass), len(arrays.stiffness)
    am, af = (2.0 * RADIUS - 1.0) / (RADIUS + 1.0), RADIUS / (RADIUS + 1.0)
    gamma = 0.5 - am + af
    beta = 0.25 * (gamma + 0.5) ** 2
    shares = Shares(h * gamma, h * h * beta, (1.0 - am) / (1.0 - af))
    slope, ahead, trial = np.empty_like(state), np.empty_like(state), state.copy()
    output, closed, tangent = np.empty(2 * lines), np.empty(lines), np.empty((size, size))
    kernel.set_instant(arrays, first * h, now)
    kernel.derivative(arrays, now, state, slope, output)
    inner = slope[size : 2 * size].copy()
    for row in range(len(record)):
        record[row, : 2 * size], record[row, 2 * size : 2 * (size + lines)] = state[: 2 * size], output
        kernel.set_instant(arrays, (first + row + 1) * h, now)
        guess = inner.copy()
        for _ in range(NEWTON):
            trial[:size] = state[:size] + h * (state[size : 2 * size] + h * ((0.5 - beta) * inner + beta * guess))
            trial[size : 2 * size] = state[size : 2 * size] + h * ((1.0 - gamma) * inner + gamma * guess)
            kernel.derivative(arrays, now, trial, ahead, output)
            wanted = ((1.0 - am) * guess + am * inner - af * slope[size : 2 * size]) / (1.0 - af)
            rest = arrays.mass * (ahead[size : 2 * size] - wanted)
            touching_stiffness(arrays, now, output[lines:], closed)
            fill_tangent(arrays, shares, damping, closed, tangent)
            change = np.linalg.solve(tangent, rest)
            guess += change
            if np.max(np.abs(change)) <= SETTLED * (np.max(np.abs(guess)) + 1e-300):
                break
        trial[2 * size :] = state[2 * size :] + 0.5 * h * (slope[2 * size :] + ahead[2 * size :])
        state[:], slope[:], inner[:] = trial, ahead, guess
