"""Peers at settings of their experts: numbers that time alone decides are tabulated, nothing is allocated on the way.

What is tried beside them stands in docs/benchmarks/integrators.md: matrices, sums and straight-line code for JAX,
forward mode, constant steps and a PI controller for diffrax.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numba import carray, cfunc
from peers import LOOSE, STEPS, Case, array_slope, dense, has, line_forces_of


def numbalsoda_free(case: Case, setting: float) -> Callable[[], np.ndarray]:
    """DOP853 of numbalsoda, its slope without an allocation; setting: relative tolerance."""
    from numbalsoda import dop853, lsoda_sig

    arrays, count = case.arrays, len(case.start)
    push, mean, rate, tones = line_forces_of(arrays), arrays.stiffness, arrays.tone_rate, len(arrays.tone_rate)
    mobility, constant, size = 1.0 / arrays.mass, arrays.loads.constant, len(arrays.mass)

    @cfunc(lsoda_sig)
    def slope(t, y, out, room):
        wave, state, change = carray(room, (2 * tones,)), carray(y, (count,)), carray(out, (count,))
        for i in range(tones):
            wave[i], wave[tones + i] = math.cos(rate[i] * t), math.sin(rate[i] * t)
        for i in range(size):
            change[i], change[size + i] = state[size + i], constant[i]
        push(wave[:tones], wave[tones:], state, mean, change)
        for i in range(size):
            change[size + i] *= mobility[i]

    scale, grid, room = float(np.max(np.abs(case.start))), case.grid, np.zeros(2 * tones)
    return lambda: dop853(slope.address, case.start, grid, room, rtol=setting, atol=setting * scale)[0]


def jax_tables(kind: str) -> Callable:
    """RK4 under jit and scan over a table of stiffnesses and errors; kind: matrices, sums or straight-line code."""

    def make(case: Case, setting: float) -> Callable[[], np.ndarray]:
        import jax
        import jax.numpy as jnp

        jax.config.update("jax_enable_x64", val=True)
        arrays, form, steps, size = case.arrays, dense(case.arrays), int(setting), len(case.arrays.mass)
        h = case.duration / (case.intervals * steps)
        (kc, ks), (ec, es) = form.stiffness, form.error
        angle = np.outer(np.arange(2 * case.intervals * steps + 1) * h / 2, arrays.tone_rate)
        cos, sin, rate = np.cos(angle), np.sin(angle), arrays.tone_rate
        parts = [arrays.stiffness + cos @ kc.T + sin @ ks.T, cos @ ec.T + sin @ es.T]
        table = np.stack([*parts, cos @ (es * rate).T - sin @ (ec * rate).T], 1)
        rows = np.stack([table[0:-2:2], table[1:-1:2], table[2::2]], 1)
        rows = jnp.asarray(rows.reshape(case.intervals, steps, 3, 3, -1))
        along, onto = _products(form.weights, kind, jnp)
        damping, constant, mobility, gap = map(
            jnp.asarray, (arrays.damping, arrays.loads.constant, 1.0 / arrays.mass, arrays.backlash)
        )
        loose = bool(np.any(arrays.backlash > 0.0))

        def pulled(row, q, v):
            d, u = along(q) - row[1], along(v) - row[2]
            if loose:
                d = jnp.where(gap > 0.0, jnp.maximum(d, 0.0) + jnp.minimum(d + gap, 0.0), d)
            return (constant - onto(row[0] * d + damping * u)) * mobility

        def step(carry, row):
            q, v = carry
            a1 = pulled(row[0], q, v)
            v2 = v + h / 2 * a1
            a2 = pulled(row[1], q + h / 2 * v, v2)
            v3 = v + h / 2 * a2
            a3 = pulled(row[1], q + h / 2 * v2, v3)
            v4 = v + h * a3
            a4 = pulled(row[2], q + h * v3, v4)
            return (q + h / 6 * (v + 2 * v2 + 2 * v3 + v4), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)), None

        def interval(carry, part):
            carry, _ = jax.lax.scan(step, carry, part)
            return carry, jnp.concatenate(carry)

        whole = jax.jit(lambda q, v, rows: jax.lax.scan(interval, (q, v), rows)[1])
        q, v = jnp.asarray(case.start[:size]), jnp.asarray(case.start[size:])
        return lambda: np.vstack([case.start, np.asarray(whole(q, v, rows))])

    return make


def _products(weights: np.ndarray, kind: str, jnp) -> tuple[Callable, Callable]:
    """Return what multiplies with the lines' weights and with their transpose."""
    if kind == "straight-line":

        def terms(matrix):
            rows = [[(float(row[i]), int(i)) for i in np.flatnonzero(row)] for row in matrix]
            return lambda x: jnp.stack([sum(w * x[i] for w, i in row) for row in rows])

        return terms(weights), terms(weights.T)
    both = [jnp.asarray(weights), jnp.asarray(weights.T.copy())]
    if kind == "sums":
        return tuple((lambda x, m=m: jnp.sum(m * x[None, :], axis=1)) for m in both)
    return tuple((lambda x, m=m: m @ x) for m in both)


def diffrax_forward(name: str, *, constant: bool = False) -> Callable:
    """A solver of diffrax in forward mode, with its PI controller or constant steps."""

    def make(case: Case, setting: float) -> Callable[[], np.ndarray]:
        import diffrax
        import jax
        import jax.numpy as jnp

        jax.config.update("jax_enable_x64", val=True)
        slope, scale = array_slope(case.arrays, jnp), float(np.max(np.abs(case.start)))
        save, solver = diffrax.SaveAt(ts=jnp.asarray(case.grid)), getattr(diffrax, name)()
        control = diffrax.ConstantStepSize() if constant else diffrax.PIDController(
            rtol=setting, atol=setting * scale, pcoeff=0.2, icoeff=0.5)  # fmt: skip
        begin = case.duration / (case.intervals * int(setting)) if constant else 1e-6

        @jax.jit
        def whole(y):
            return diffrax.diffeqsolve(
                diffrax.ODETerm(lambda t, y, _: slope(t, y)), solver, 0.0, case.duration, begin, y, saveat=save,
                stepsize_controller=control, max_steps=10**5, adjoint=diffrax.ForwardMode(),
            ).ys  # fmt: skip

        return lambda: np.asarray(whole(case.start))

    return make


BETTER: dict[str, tuple[Callable, list[float]]] = {}
if has("numbalsoda"):
    BETTER["numbalsoda DOP853, nothing allocated"] = (numbalsoda_free, LOOSE)
if has("jax"):
    for kind in ("matrices", "sums", "straight-line"):
        BETTER[f"JAX RK4, tables, {kind}"] = (jax_tables(kind), STEPS)
if has("diffrax"):
    BETTER["diffrax Tsit5, PI, forward mode"] = (diffrax_forward("Tsit5"), LOOSE)
    BETTER["diffrax Dopri5, constant steps"] = (diffrax_forward("Dopri5", constant=True), STEPS)
