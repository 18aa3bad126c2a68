"""What the page asks of dynamics: modes on the solids, critical speeds, a run in time with its spectra, many speeds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from gearwright.app.asked import Answer, Progress, Question, Tell, as_json, case_of, packed, sized
from gearwright.app.thinned import extremes, instants
from gearwright.arrays import Floats

if TYPE_CHECKING:
    from gearwright.dynamics import Samples, System, Trace
    from gearwright.dynamics.vibration import Order, SpeedCase
    from gearwright.sizing import Sizing

WINDOW = 0.005
"""Of the end of a run that is kept at every step, as `gearwright simulate` keeps it [s]."""
MOST_DURATION = 2.0
"""Longest run that is asked of the page; the command line has no such limit [s]."""
MOST_SPEEDS = 101
SHOWN = 400
"""Instants at which the solids are shown [-]."""


def modes(question: Question, tell: Tell) -> Answer:
    """Return natural frequencies, and by how much every body turns in each mode, 1 where it turns most.

    Args:
        question: With the load case.
        tell: Takes how far it is; there is nothing to tell.
    """
    from gearwright.dynamics import modes as found_modes
    from gearwright.dynamics.assembly import assemble
    from gearwright.dynamics.assembly.turns import turns_of
    from gearwright.render.answers.motion import modes_answer
    from gearwright.render.answers.plain import plain
    from gearwright.shape import scene

    sizing = sized(question)
    case = case_of(question, sizing)
    system = assemble(sizing, case)
    found = found_modes(system)
    turned = turns_of(sizing, scene(sizing, detail="coarse"), system, found.shapes.T)
    most = np.max([np.abs(turn) for turn in turned.values()], axis=0)
    shapes = {name: (turn / np.where(most > 0.0, most, 1.0)).tolist() for name, turn in turned.items()}
    frequencies = [round(float(value), 6) for value in found.frequency]
    return Answer(as_json({
        **plain(modes_answer(found, case)), "frequencies": frequencies, "shapes": shapes,
        "energy": {line: shares.tolist() for line, shares in zip(found.labels.lines, found.line_energy, strict=True)},
    }))  # fmt: skip


def campbell(question: Question, tell: Tell) -> Answer:
    """Return the Campbell diagram of the speeds of a load case, its orders by name, and its critical speeds.

    Args:
        question: With the load case.
        tell: Takes how far it is; there is nothing to tell.
    """
    from gearwright.dynamics.vibration import critical_speeds
    from gearwright.render.answers.plain import plain
    from gearwright.render.answers.vibration import campbell_answer
    from gearwright.render.figures.dynamics import operating_speed

    sizing = sized(question)
    (speeds,) = critical_speeds(sizing, cases=[case_of(question, sizing)])
    shaft, rpm = operating_speed(sizing, speeds)
    told = plain(campbell_answer([speeds], ()))["cases"][0]
    diagram = speeds.campbell
    return packed(
        {**told, "shaft": shaft, "rpm": rpm, "orders": list(_orders(sizing, speeds)),
         "modes": int(diagram.frequency.shape[1])},
        {"factor": diagram.factor, "frequency": diagram.frequency.T.ravel()},
    )  # fmt: skip


def _orders(sizing: Sizing, speeds: SpeedCase) -> Iterator[dict[str, Any]]:
    for order in speeds.campbell.orders:
        name, kind = _named(sizing, order)
        yield {"name": name, "kind": kind, "frequency": order.frequency}


def _named(sizing: Sizing, order: Order) -> tuple[str, str]:
    """Return what an order is called, and whether teeth, shafts or machines make it."""
    from gearwright.dynamics.vibration import order_name

    if order.excitation is not None:
        return order.excitation.name, "machine"
    name = order_name(sizing, order.tone)
    return str(name), "mesh" if name.stage else "shaft"


def simulate(question: Question, tell: Tell) -> Answer:
    """Return a run: what is recorded of it, spectra of its end with the orders named, and how the bodies turn.

    Args:
        question: With load case and duration [s].
        tell: Takes how far it is.
    """
    from gearwright.dynamics import Outputs
    from gearwright.dynamics import simulate as run_system
    from gearwright.dynamics.assembly import assemble
    from gearwright.render.answers.motion import simulate_answer
    from gearwright.render.answers.plain import plain
    from gearwright.render.figures.motion import every_step, mesh_frequencies

    sizing = sized(question)
    case, duration = case_of(question, sizing), question.number("duration", 0.05, MOST_DURATION)
    system = assemble(sizing, case)
    window = (max(0.0, duration - WINDOW), duration)
    outputs = Outputs(start=duration / 4.0, windows=(window,))
    trace = run_system(system, duration, outputs=outputs, progress=lambda share: tell(Progress(share)))
    close = every_step(trace)
    head = {
        **plain(simulate_answer({case: trace})), "lines": _lines(trace),
        "meshes": {name: value for name, value in mesh_frequencies(sizing, case).items() if value > 0.0},
    }  # fmt: skip
    columns = {f"run {name}": values for name, values in _columns(trace.samples).items()}
    if close is not None:
        columns |= {f"end {name}": values for name, values in _columns(close).items()} | _spectra(close)
        columns |= _turned(sizing, system, close, case)
    return packed(head, columns)


def _lines(trace: Trace) -> list[dict[str, str]]:
    """Return name, unit and family of every line: the planets of a set are one family."""
    from gearwright.render.figures.motion import families

    labels = trace.labels
    return [
        {"name": name, "unit": "N" if unit == "m" else "N m", "family": family}
        for unit in dict.fromkeys(labels.line_units)
        for family, names in families(labels, unit).items()
        for name in names
    ]


def _columns(samples: Samples) -> dict[str, Floats]:
    """Return time [ms] and the force or torque of every line."""
    forces = zip(samples.labels.lines, samples.line_force.T, strict=True)
    return {"time": instants(samples.time * 1e3), **{name: extremes(force) for name, force in forces}}


def _spectra(samples: Samples) -> dict[str, Floats]:
    """Return frequency [Hz] and amplitude of every line's force."""
    from gearwright.render.figures.motion import spectrum

    found: dict[str, Floats] = {}
    for name, forces in zip(samples.labels.lines, samples.line_force.T, strict=True):
        found["spectrum frequency"], found[f"spectrum {name}"] = spectrum(samples.time, forces)
    return found


def _turned(sizing: Sizing, system: System, samples: Samples, case: str) -> Mapping[str, Floats]:
    """Return the instants at which the solids are shown [s], and how far each body turns beside the rigid motion."""
    from gearwright.dynamics.assembly.turns import turns_of
    from gearwright.shape import scene

    stride = max(1, len(samples.time) // SHOWN)
    position = samples.position[::stride]
    found = turns_of(sizing, scene(sizing, detail="coarse"), system, position - position.mean(axis=0))
    return {"turn time": samples.time[::stride], **{f"turn {name}": turn for name, turn in found.items()}}


def runup(question: Question, tell: Tell) -> Answer:
    """Return runs at many speeds: spectra of one force over speed, and where every mesh is loudest.

    Args:
        question: With load case, lowest and highest speed over the operating one, and how many.
        tell: Takes how far it is.
    """
    from gearwright.dynamics.assembly import assemble
    from gearwright.dynamics.vibration import first_meshes, loudest_speeds, run_up, turning_shaft
    from gearwright.render.answers.plain import plain
    from gearwright.units import RPM

    sizing = sized(question)
    case = case_of(question, sizing)
    system = assemble(sizing, case)
    lowest, highest = question.number("lowest", 0.3, 10.0), question.number("highest", 1.3, 10.0)
    factors = np.linspace(lowest, highest, int(question.number("speeds", 21, MOST_SPEEDS))).tolist()
    lines = first_meshes(sizing, system)
    swept = run_up(sizing, system, factors, lines=lines, progress=lambda share: tell(Progress(share)))
    shaft = turning_shaft(sizing, case) or sizing.machines[0].shaft
    speed = abs(sizing.flows[case].speeds[shaft])
    loudest = [plain(row) for row in loudest_speeds(swept, speed)]
    orders = [{"name": str(name), "frequency": float(at)}
              for name, at in zip(swept.orders, swept.order_frequency, strict=True)]  # fmt: skip
    spectra = {f"amplitude {line}": swept.amplitude[:, k].ravel() for k, line in enumerate(swept.lines)}
    return packed(
        {"shaft": shaft, "rpm": speed / RPM, "lines": list(swept.lines), "loudest": loudest, "orders": orders,
         "notes": list(swept.notes)},
        {"factor": swept.factor, "frequency": swept.frequency, **spectra},
    )  # fmt: skip
