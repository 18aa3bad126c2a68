"""Peers: the same equations given to other integrators, each as its users would write them.

Every solver is a function (case, setting) that returns states on the common grid, shape (instants, states). Dense
matrices are used where a peer is made for arrays (numpy, JAX, CasADi), loops where it compiles loops (numba).
"""

from __future__ import annotations

import importlib.util
import shutil
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numba import njit
from scipy.integrate import solve_ivp

from gearwright.dynamics import Outputs, System, simulate
from gearwright.dynamics.codegen import summarise
from gearwright.dynamics.equations import line_state
from gearwright.dynamics.model import Arrays, line_matrix
from gearwright.dynamics.motion import blank_record, blank_summary, stepper


@dataclass
class Case:
    """One system, its start and the grid on which answers are compared."""

    arrays: Arrays
    start: np.ndarray
    duration: float
    intervals: int
    system: System | None = None
    """Where the arrays are from: what the public verb takes."""

    @property
    def grid(self) -> np.ndarray:
        """Common instants [s]."""
        return np.linspace(0.0, self.duration, self.intervals + 1)


@dataclass
class Dense:
    """Matrices: k and e as constant + cosine and sine parts by tone."""

    weights: np.ndarray
    stiffness: tuple[np.ndarray, np.ndarray]
    error: tuple[np.ndarray, np.ndarray]


def dense(arrays: Arrays) -> Dense:
    """Return a system as dense matrices."""
    lines, tones = len(arrays.stiffness), len(arrays.tone_rate)
    parts = []
    for series, scale in ((arrays.variation, arrays.stiffness), (arrays.error, np.ones(lines))):
        cos, sin = np.zeros((lines, tones)), np.zeros((lines, tones))
        row = np.repeat(np.arange(lines), np.diff(series.start))
        np.add.at(cos, (row, series.tone), series.cosine * scale[row])
        np.add.at(sin, (row, series.tone), series.sine * scale[row])
        parts.append((cos, sin))
    return Dense(line_matrix(arrays), *parts)


def array_slope(arrays: Arrays, module) -> Callable:
    """Return dy/dt(t, y) in numpy's or JAX's own words."""
    xp, form, size = module, dense(arrays), len(arrays.mass)
    weights, mass, constant = xp.asarray(form.weights), xp.asarray(arrays.mass), xp.asarray(arrays.loads.constant)
    (kc, ks), (ec, es) = ([xp.asarray(part) for part in pair] for pair in (form.stiffness, form.error))
    mean, damping, rate = xp.asarray(arrays.stiffness), xp.asarray(arrays.damping), xp.asarray(arrays.tone_rate)
    backlash = xp.asarray(arrays.backlash)

    def slope(t, y):
        cos, sin = xp.cos(rate * t), xp.sin(rate * t)
        deflection = weights @ y[:size] - ec @ cos - es @ sin
        speed = weights @ y[size:] - (es * rate) @ cos + (ec * rate) @ sin
        contact = xp.where(
            backlash > 0.0, xp.maximum(deflection, 0.0) + xp.minimum(deflection + backlash, 0.0), deflection
        )
        force = (mean + kc @ cos + ks @ sin) * contact + damping * speed
        return xp.concatenate([y[size:], (constant - weights.T @ force) / mass])

    return slope


def numba_slope(arrays: Arrays) -> Callable:
    """Return dy/dt(t, y) as a compiled loop over the sparse lines."""
    slope, stiffness = numba_slope_of(arrays), arrays.stiffness

    @njit(error_model="numpy", fastmath=True)
    def alone(t, y):
        return slope(t, y, stiffness)

    return alone


def numba_slope_of(arrays: Arrays) -> Callable:
    """Return dy/dt(t, y, k) as a compiled loop over the sparse lines; k: mean stiffnesses."""
    fill, size = numba_fill_of(arrays), len(arrays.mass)

    @njit(error_model="numpy", fastmath=True)
    def slope(t, y, mean):
        out = np.empty(2 * size)
        fill(t, y, mean, out)
        return out

    return slope


def numba_fill_of(arrays: Arrays) -> Callable:
    """Return what fills dy/dt for (t, y, k)."""
    push, rate = line_forces_of(arrays), arrays.tone_rate
    mass, constant, size = arrays.mass, arrays.loads.constant, len(arrays.mass)

    @njit(error_model="numpy", fastmath=True)
    def fill(t, y, mean, out):
        out[:size], out[size:] = y[size:], constant
        push(np.cos(rate * t), np.sin(rate * t), y, mean, out)
        out[size:] /= mass

    return fill


def line_forces_of(arrays: Arrays) -> Callable:
    """Return what takes the forces of all lines from the coordinates' own, by cosines and sines of the tones."""
    start, dof, weight, size = arrays.line_start, arrays.line_dof, arrays.line_weight, len(arrays.mass)
    damping, backlash, rate = arrays.damping, arrays.backlash, arrays.tone_rate
    vs, vt, vc, vn = arrays.variation
    es, et, ec, en = arrays.error

    @njit(error_model="numpy", fastmath=True, inline="always")
    def push(cos, sin, y, mean, out):
        for j in range(len(mean)):
            d, v, k = 0.0, 0.0, 1.0
            for i in range(start[j], start[j + 1]):
                d += weight[i] * y[dof[i]]
                v += weight[i] * y[size + dof[i]]
            for i in range(vs[j], vs[j + 1]):
                k += vc[i] * cos[vt[i]] + vn[i] * sin[vt[i]]
            for i in range(es[j], es[j + 1]):
                d -= ec[i] * cos[et[i]] + en[i] * sin[et[i]]
                v -= rate[et[i]] * (en[i] * cos[et[i]] - ec[i] * sin[et[i]])
            g = max(d, 0.0)
            if d < -backlash[j]:
                g = d + backlash[j]
            f = mean[j] * k * g + damping[j] * v
            for i in range(start[j], start[j + 1]):
                out[size + dof[i]] -= weight[i] * f

    return push


def gearwright(case: Case, setting: float) -> Callable[[], np.ndarray]:
    """Our own generated code; setting: steps in an interval of the grid."""
    steps = int(setting)
    h = case.duration / (case.intervals * steps)
    advance, width = stepper(case.arrays, "runge-kutta", h), len(case.start)
    record = blank_record(case.arrays, 512)
    summary = blank_summary(record.shape[1])

    def run() -> np.ndarray:
        state, rows = np.concatenate([case.start, np.zeros(6)]), []
        for first in range(0, case.intervals * steps + 1, 512):
            part = record[: min(512, case.intervals * steps + 1 - first)]
            advance(first, part, state)
            summarise(part, summary)
            rows.append(part[-first % steps :: steps, :width].copy())
        return np.concatenate(rows)

    return run


def gearwright_public(case: Case, setting: float) -> Callable[[], np.ndarray]:
    """Our public verb with all that it does: a second run that measures the error, statistics, energies, notes."""
    h, size = case.duration / (case.intervals * int(setting)), len(case.arrays.mass)
    start, outputs = (case.start[:size], case.start[size:]), Outputs(samples=case.intervals + 1)

    def run() -> np.ndarray:
        samples = simulate(case.system, case.duration, step=h, start=start, outputs=outputs).samples
        return np.hstack([samples.position, samples.velocity])

    return run


def gearwright_adaptive(case: Case, setting: float) -> Callable[[], np.ndarray]:
    """Our adaptive steps, rows on the grid; setting: tolerance over the root of the energy at the start."""
    h, size = case.duration / case.intervals, len(case.arrays.mass)
    lines = line_state(case.arrays, 0.0, case.start[:size], case.start[size:])
    held = 0.5 * float(np.sum(lines.stiffness * lines.contact**2))
    advance, width = stepper(case.arrays, "tsit5", h, tolerance=setting * held**0.5), len(case.start)
    record = blank_record(case.arrays, case.intervals + 1)

    def run() -> np.ndarray:
        advance(0, record, np.concatenate([case.start, np.zeros(6)]))
        return record[:, :width].copy()

    return run


def scipy_run(slope: Callable, method: str) -> Callable:
    """A method of scipy's solve_ivp; setting: relative tolerance."""

    def make(case: Case, setting: float) -> Callable[[], np.ndarray]:
        compiled = slope(case.arrays)
        compiled(0.0, case.start)
        span, scale = (0.0, case.duration), np.max(np.abs(case.start))

        def run() -> np.ndarray:
            return solve_ivp(
                compiled, span, case.start, method, t_eval=case.grid, rtol=setting, atol=setting * scale
            ).y.T

        return run

    return make


def jax_runge_kutta(case: Case, setting: float) -> Callable[[], np.ndarray]:
    """Fixed-step RK4 under jit and scan; setting: steps in an interval of the grid."""
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", val=True)
    slope, steps = array_slope(case.arrays, jnp), int(setting)
    h = case.duration / (case.intervals * steps)

    def step(carry, _):
        t, y = carry
        k1 = slope(t, y)
        k2 = slope(t + h / 2, y + h / 2 * k1)
        k3 = slope(t + h / 2, y + h / 2 * k2)
        k4 = slope(t + h, y + h * k3)
        return (t + h, y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)), None

    def interval(carry, _):
        carry, _ = jax.lax.scan(step, carry, None, length=steps)
        return carry, carry[1]

    @jax.jit
    def whole(y):
        return jax.lax.scan(interval, (0.0, y), None, length=case.intervals)[1]

    return lambda: np.vstack([case.start, np.asarray(whole(case.start))])


def diffrax_run(name: str) -> Callable:
    """A solver of diffrax with its adaptive controller; setting: relative tolerance."""

    def make(case: Case, setting: float) -> Callable[[], np.ndarray]:
        import diffrax
        import jax
        import jax.numpy as jnp

        jax.config.update("jax_enable_x64", val=True)
        slope = array_slope(case.arrays, jnp)
        control = diffrax.PIDController(rtol=setting, atol=setting * float(np.max(np.abs(case.start))))
        save, solver = diffrax.SaveAt(ts=jnp.asarray(case.grid)), getattr(diffrax, name)()
        term = diffrax.ODETerm(lambda t, y, _: slope(t, y))

        @jax.jit
        def whole(y):
            return diffrax.diffeqsolve(
                term, solver, 0.0, case.duration, 1e-6, y, saveat=save, stepsize_controller=control, max_steps=10**6
            ).ys

        return lambda: np.asarray(whole(case.start))

    return make


def numbalsoda_dop853(case: Case, setting: float) -> Callable[[], np.ndarray]:
    """DOP853 of numbalsoda, the slope compiled behind a pointer; setting: relative tolerance."""
    from numba import carray, cfunc
    from numbalsoda import dop853, lsoda_sig

    fill, mean, count = numba_fill_of(case.arrays), case.arrays.stiffness, len(case.start)

    @cfunc(lsoda_sig)
    def slope(t, y, out, _):
        fill(t, carray(y, (count,)), mean, carray(out, (count,)))

    scale, grid = float(np.max(np.abs(case.start))), case.grid
    return lambda: dop853(slope.address, case.start, grid, np.zeros(1), rtol=setting, atol=setting * scale)[0]


def casadi_slope(arrays: Arrays):
    """Return the function (t, y) → dy/dt in CasADi's words, sparse."""
    import casadi

    form, size = dense(arrays), len(arrays.mass)
    t, y = casadi.SX.sym("t"), casadi.SX.sym("y", 2 * size)
    weights, rate = casadi.sparsify(casadi.DM(form.weights)), arrays.tone_rate
    cos, sin = casadi.cos(rate * t), casadi.sin(rate * t)
    (kc, ks), (ec, es) = ([casadi.sparsify(casadi.DM(part)) for part in pair] for pair in (form.stiffness, form.error))
    deflection = weights @ y[:size] - ec @ cos - es @ sin
    speed = weights @ y[size:] - es @ (rate * cos) + ec @ (rate * sin)
    gap = casadi.fmax(deflection, 0) + casadi.fmin(deflection + arrays.backlash, 0)
    contact = casadi.if_else(arrays.backlash > 0.0, gap, deflection)
    force = (arrays.stiffness + kc @ cos + ks @ sin) * contact + arrays.damping * speed
    slope = casadi.vertcat(y[size:], (arrays.loads.constant - weights.T @ force) / arrays.mass)
    return casadi.Function("slope", [t, y], [slope])


def casadi_cvodes(jit: dict[str, object]) -> Callable:
    """CVODES through CasADi, Adams with functional iteration; setting: relative tolerance."""

    def make(case: Case, setting: float) -> Callable[[], np.ndarray]:
        import casadi

        t, y = casadi.SX.sym("t"), casadi.SX.sym("y", len(case.start))
        options = {"reltol": setting, "abstol": setting * float(np.max(np.abs(case.start))), "max_num_steps": 10**6}
        options |= {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional", **jit}
        equations = {"x": y, "t": t, "ode": casadi_slope(case.arrays)(t, y)}
        solver = casadi.integrator("f", "cvodes", equations, 0.0, list(case.grid[1:]), options)
        return lambda: np.vstack([case.start, np.asarray(solver(x0=case.start)["xf"]).T])

    return make


IN_C = {"jit": True, "compiler": "shell", "jit_options": {"compiler": "gcc", "flags": ["-O3", "-march=native"]}}
"""Makes CasADi write its functions as C, compile and load them."""


def has(module: str) -> bool:
    """Return whether an optional peer is there."""
    return importlib.util.find_spec(module) is not None


LOOSE = [10.0 ** (-power / 3) for power in range(6, 37)]
STEPS = [2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 20, 24, 28, 32, 40, 48, 64]
PEERS: dict[str, tuple[Callable, list[float]]] = {
    "gearwright RK4": (gearwright, STEPS),
    "gearwright simulate()": (gearwright_public, STEPS[1:]),
    "gearwright Tsit5": (gearwright_adaptive, LOOSE),
    "scipy RK45, numba slope": (scipy_run(numba_slope, "RK45"), LOOSE),
    "scipy DOP853, numba slope": (scipy_run(numba_slope, "DOP853"), LOOSE),
    "scipy RK45, numpy slope": (scipy_run(lambda arrays: array_slope(arrays, np), "RK45"), LOOSE),
}
if has("numbalsoda"):
    PEERS["numbalsoda DOP853"] = (numbalsoda_dop853, LOOSE)
if has("jax"):
    PEERS["JAX RK4, jit"] = (jax_runge_kutta, STEPS)
if has("diffrax"):
    PEERS |= {f"diffrax {name}": (diffrax_run(name), LOOSE) for name in ("Tsit5", "Dopri8")}
if has("casadi"):
    PEERS["CasADi CVODES Adams, virtual machine"] = (casadi_cvodes({}), LOOSE)
    if shutil.which("gcc"):
        PEERS["CasADi CVODES Adams, C"] = (casadi_cvodes(IN_C), LOOSE)
