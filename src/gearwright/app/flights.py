"""What the page asks of missions: a flight over its time, what it does to parts, and seconds of it in motion."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from gearwright.app.asked import Answer, Progress, Question, Tell, as_json, packed, sized
from gearwright.app.thinned import extremes, instants
from gearwright.arrays import Floats
from gearwright.errors import DesignError

if TYPE_CHECKING:
    from gearwright.mission import Flight


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
    from gearwright.render.answers.flights.flight import fly_answer
    from gearwright.render.answers.plain import plain
    from gearwright.render.figures.flights.sankey import sankey_figure
    from gearwright.render.style import theme
    from gearwright.render.words.headline import headline
    from gearwright.reviews import review_of

    flight = _flown(question)
    tell(Progress(0.4, "lives of the parts"))
    parts = durability(flight)
    tell(Progress(0.6, "review"))
    review = review_of(flight.sizing, flight, parts)
    answer = plain(fly_answer(flight, parts, review))
    answer.pop("spectrum")
    head = {"headline": headline(review), **answer, "sankey": theme.to_svg(sankey_figure(flight), "sankey"),
            "stretches": _stretches(flight), "windows": dict(_windows(flight))}  # fmt: skip
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


def _stretches(flight: Flight) -> list[dict[str, Any]]:
    """Return name, start and end of every phase [min]."""
    found, clock, names = [], 0.0, np.array(flight.phase)
    for name in flight.mission.phases:
        length = float(flight.history.duration[names == name].sum()) / 60.0
        found.append({"name": name, "start": clock, "end": clock + length})
        clock += length
    return found


def _histories(flight: Flight) -> tuple[list[dict[str, str]], dict[str, Floats]]:
    """Return what is recorded: name, unit and group of each history, and its values in that unit."""
    from gearwright.mission.history import History
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
    from gearwright.render.answers.flights.flight import window_answer
    from gearwright.render.answers.plain import plain
    from gearwright.render.words.flights.window import window_verdict

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
