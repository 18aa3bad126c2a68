"""Vibration and missions in the workbench: modes, simulation, spectra, flights and thinned time histories."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from gearwright.app.questions import Answer, Progress, Question, Tell, as_json, case_of, packed, sized
from gearwright.arrays import Floats
from gearwright.errors import DesignError

if TYPE_CHECKING:
    from gearwright.dynamics import Samples, System, Trace
    from gearwright.dynamics.vibration import OrderLine, SpeedCase
    from gearwright.mission import Flight
    from gearwright.sizing import Sizing


# ----------------------------------------------------------------------------------------------------------------------
# Long histories for a screen: of every stretch its lowest and its highest value, so that no peak is lost.
# ----------------------------------------------------------------------------------------------------------------------


MOST = 12_000
"""Instants that a page draws, several to a pixel of any screen [-]."""


def instants(time: Floats, *, most: int = MOST) -> Floats:
    """Return the instants of a thinned history: where every stretch begins, and its middle.

    Args:
        time: Of the history.
        most: Instants that may stay; as many or fewer stay as they are.

    Returns:
        Instants, at most `most`.
    """
    if len(time) <= most:
        return time
    length = _length(len(time), most)
    missing = np.arange(1.0, -len(time) % length + 1.0)  # of the last stretch, which goes on in equal steps
    stretches = np.concatenate([time, time[-1] + missing * (time[-1] - time[-2])]).reshape(-1, length)
    return stretches[:, [0, stretches.shape[1] // 2]].ravel()


def extremes(values: Floats, *, most: int = MOST) -> Floats:
    """Return the lowest and the highest value of every stretch, in the order in which they come.

    Args:
        values: Of a history, at its instants.
        most: Instants that may stay; as many or fewer stay as they are.

    Returns:
        Values at `instants`.

    >>> extremes(np.array([0.0, 0.0, 9.0, 1.0, 2.0, -3.0, 2.0, 2.0]), most=4)
    array([ 0.,  9.,  2., -3.])
    """
    if len(values) <= most:
        return values
    # Values in rows of equal length; the last row is filled with the last value.
    length = _length(len(values), most)
    stretches = np.pad(values, (0, -len(values) % length), mode="edge").reshape(-1, length)
    places = np.sort(np.stack([stretches.argmin(axis=1), stretches.argmax(axis=1)], axis=1), axis=1)
    return np.take_along_axis(stretches, places, axis=1).ravel()


def _length(count: int, most: int) -> int:
    """Return how many instants a stretch has, of which two are drawn."""
    return -(-count // (most // 2))


# ----------------------------------------------------------------------------------------------------------------------
# What the page asks of dynamics: modes on the solids, critical speeds, a run in time with its spectra, many speeds.
# ----------------------------------------------------------------------------------------------------------------------


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
    from gearwright import assemble, modes as found_modes, scene
    from gearwright.dynamics.assembly.bodies import turns_of
    from gearwright.render.answers.motion import modes_answer
    from gearwright.render.answers.schema import plain

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
    from gearwright.render.answers.motion import campbell_answer
    from gearwright.render.answers.schema import plain
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


def _named(sizing: Sizing, order: OrderLine) -> tuple[str, str]:
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
    from gearwright.dynamics import Outputs, simulate as run_system
    from gearwright.dynamics.assembly import assemble
    from gearwright.render.answers.motion import simulate_answer
    from gearwright.render.answers.schema import plain
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
    from gearwright.dynamics.assembly.bodies import turns_of
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
    from gearwright.render.answers.schema import plain
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


# ----------------------------------------------------------------------------------------------------------------------
# What the page asks of missions: a flight over its time, what it does to parts, and seconds of it in motion.
# ----------------------------------------------------------------------------------------------------------------------


def mission(question: Question, tell: Tell) -> Answer:
    """Return what a mission's text says: its phases and windows by name; what is wrong with it is told at its line.

    Args:
        question: With the mission's text.
        tell: Takes how far it is; there is nothing to tell.
    """
    from gearwright.spec import parse_mission

    read = parse_mission(question.words("mission"), folder=Path(question.folder))
    windows = {name: f"{rules.phase}, {rules.event}, {rules.duration:g} s" for name, rules in read.windows.items()}
    return Answer(as_json({"name": read.name, "phases": list(read.phases), "windows": windows}))


def fly(question: Question, tell: Tell) -> Answer:
    """Return a flight: fuel, charge, heat, what fails first, and every history over its time.

    Args:
        question: With the mission's text.
        tell: Takes how far it is.
    """
    from gearwright.mission import durability
    from gearwright.render import style as theme
    from gearwright.render.answers.flights import fly_answer
    from gearwright.render.answers.schema import plain
    from gearwright.render.figures.flights import sankey_figure
    from gearwright.render.words.sizing import headline
    from gearwright.reviews import review_of

    flight = _flown(question)
    tell(Progress(0.4, "lives of the parts"))
    parts = durability(flight)
    tell(Progress(0.6, "review"))
    review = review_of(flight.sizing, flight, parts)
    answer = plain(fly_answer(flight, parts, review))
    answer.pop("spectrum")
    head = {"headline": headline(review), **answer, "sankey": theme.to_svg(sankey_figure(flight), "sankey"),
            "stretches": _phases_of(flight), "windows": dict(_windows(flight))}  # fmt: skip
    series, columns = _histories(flight)
    return packed({**head, "series": series}, columns)


def _flown(question: Question) -> Flight:
    """Return the flight of the text's mission; what cannot be flown is told at its line in the mission."""
    from gearwright.mission import fly as flown
    from gearwright.spec import parse_mission, placed

    sizing, text, folder = sized(question), question.words("mission"), Path(question.folder)
    read = parse_mission(text, folder=folder)
    try:
        return flown(sizing, read, folder=folder)
    except DesignError as error:
        raise DesignError(placed(error.problems, text)) from None


def _windows(flight: Flight) -> dict[str, str]:
    return {name: f"{rules.phase}, {rules.event}" for name, rules in flight.mission.windows.items()}


def _phases_of(flight: Flight) -> list[dict[str, Any]]:
    """Return name, start and end of every phase [min]."""
    found, clock, names = [], 0.0, np.array(flight.phase)
    for name in flight.mission.phases:
        length = float(flight.history.duration[names == name].sum()) / 60.0
        found.append({"name": name, "start": clock, "end": clock + length})
        clock += length
    return found


def _histories(flight: Flight) -> tuple[list[dict[str, str]], dict[str, Floats]]:
    """Return what is recorded: name, unit and group of each history, and its values in that unit."""
    from gearwright.mission.flight import History
    from gearwright.units import marks_of, shown, unit

    series: list[dict[str, str]] = []
    columns: dict[str, Floats] = {"time": flight.history.time / 60.0}

    def take(name: str, group: str, values: Floats, dimension: str) -> None:
        series.append({"name": name, "group": group, "unit": unit(dimension)})
        columns[name] = np.array([shown(float(value), dimension) for value in values])

    marks = marks_of(History)
    for name in (field.name for field in fields(History)):
        values, quantity = getattr(flight.history, name), marks[name].dimension
        if values is not None and name not in ("time", "duration") and np.ptp(values) + np.max(np.abs(values)) > 0.0:
            take(name.replace("_", " "), "flight", values, quantity)
    for name, machine in flight.machines.items():
        take(f"power of {name}", "machines", machine.power, "power")
    for name in flight.sizing.design.shafts:
        take(f"torque in {name}", "shafts", flight.nodes[name].torque, "torque")
    for name, mesh in flight.meshes.items():
        take(f"force in {name}", "meshes", mesh.force, "force")
    take("oil behind the gearbox", "flight", flight.oil_outlet, "absolute_temperature")
    return series, columns


def window(question: Question, tell: Tell) -> Answer:
    """Return seconds of a mission on the elastic train: peaks beside rated loads, and every line over time.

    Args:
        question: With the mission's text and the window's name.
        tell: Takes how far it is.
    """
    from gearwright.mission.windows import fly_window
    from gearwright.render.answers.flights import window_answer
    from gearwright.render.answers.schema import plain
    from gearwright.render.words.flights import window_verdict

    flight = _flown(question)
    tell(Progress(0.1, "the window"))
    found = fly_window(flight, question.words("window"))
    samples, labels = found.trace.samples, found.trace.labels
    lines = [
        {
            "name": name,
            "unit": "N" if unit == "m" else "N m",
            "group": "loads",
            "what": "force along the line of action" if kind == "mesh" else "",
        }
        for name, unit, kind in zip(labels.lines, labels.line_units, labels.line_kinds, strict=True)
    ]
    drives = [{"name": name, "unit": unit, "group": "machines"}
              for name, unit in zip(labels.drives, labels.drive_units, strict=True)]  # fmt: skip
    columns = {"time": instants(samples.time), **{row["name"]: extremes(values) for row, values in
               zip([*lines, *drives], [*samples.line_force.T, *samples.drives.T], strict=True)}}  # fmt: skip
    return packed({"headline": window_verdict(found), **plain(window_answer(found)), "series": [*lines, *drives]},
                  columns)  # fmt: skip
