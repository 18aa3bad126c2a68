"""Figures of what a flight does to parts: duty spectra of meshes, bearings and shafts, lives, the mass of a life."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.mission import Durability, Flight, LifeSizing
from gearwright.mission.lives import seat_duties
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure

MODE_COLOURS = {"bending": theme.BLUE, "pitting": theme.SKY, "rolling fatigue": theme.AMBER}
"""Colour of each way to fail."""
_KILO = 1e3


class Duty(NamedTuple):
    """Loads of one part over all intervals."""

    name: str
    """Of the part."""
    load: Floats
    """In the unit of its panel."""
    turns: Floats
    """Of every interval [-]."""


@theme.drawn
def spectrum_figure(flight: Flight) -> Figure:
    """Return the duty spectra of one flight: turns at which a load is reached or passed.

    Args:
        flight: As flown.
    """
    groups = [
        ("Meshes", "force of one mesh [kN]", list(_meshes(flight))),
        ("Bearings", "radial force [kN]", list(_seats(flight))),
        ("Shafts", "torque inside [kN m]", list(_shafts(flight))),
    ]
    drawn = [group for group in groups if group[2]]
    figure = theme.sheet(WIDTH, 78.0)
    panels = figure.grid(1, len(drawn))[0]
    for panel, (title, label, duties) in zip(panels, drawn, strict=True):
        _spectrum(panel, duties)
        panel.set(title=title, ylabel=label, xlabel="turns at this load or more [-]")
    return figure


def _spectrum(axes: Axes, duties: Iterable[Duty]) -> None:
    for colour, duty in zip(cycle(theme.CYCLE), duties, strict=False):
        order = np.argsort(-np.abs(duty.load), kind="stable")
        reached = np.maximum(np.cumsum(duty.turns[order]), 1e-3)
        load = np.abs(duty.load)[order]
        axes.step([reached[0] * 0.3, *reached], [load[0], *load], where="pre", color=colour, label=duty.name)
    axes.set_xscale("log")
    axes.set_xlim(left=1.0)
    axes.set_ylim(bottom=0.0)
    axes.legend("below", size=6.5)


def _turns(flight: Flight, speed: Floats) -> Floats:
    return np.abs(speed) * flight.history.duration / (2.0 * np.pi)


def _shafts(flight: Flight) -> Iterator[Duty]:
    for name in flight.sizing.design.shafts:
        yield Duty(name, flight.nodes[name].torque / _KILO, _turns(flight, flight.nodes[name].speed))


def _meshes(flight: Flight) -> Iterator[Duty]:
    for mesh in flight.sizing.train.meshes:
        carrier = flight.speed(mesh.nodes[2])
        force = flight.meshes[mesh.name].force / _KILO
        yield Duty(mesh.name, force, _turns(flight, flight.speed(mesh.nodes[0]) - carrier))


def _seats(flight: Flight) -> Iterator[Duty]:
    for seat, duty in seat_duties(flight):
        yield Duty(seat.name, duty.radial / _KILO, duty.turns)


@theme.drawn
def life_figure(parts: Durability) -> Figure:
    """Return the flights that every part lives, the one that governs first.

    Args:
        parts: Lives of gears and bearings.
    """
    rows = parts.failing
    figure = theme.sheet(WIDTH, 24.0 + 5.4 * len(rows))
    axes = figure.panel()
    for place, row in enumerate(rows):
        axes.barh(place, row.flights, left=0.5, height=0.72, color=MODE_COLOURS[row.mode])
        axes.annotate(
            f"{row.flights:,.0f} flights, {row.life:,.0f} h", (row.flights, place), (4, 0), fontsize=7.5, va="center"
        )
    for mode in dict.fromkeys(row.mode for row in rows):
        axes.barh([0], [0.0], color=MODE_COLOURS[mode], label=mode)
    axes.set_yticks(range(len(rows)), [row.name for row in rows])
    axes.set(xscale="log", xlim=(1.0, 1e4 * max(row.flights for row in rows)))
    axes.invert_yaxis()
    axes.set_xlabel("flights until Miner's sum is 1 [-]")
    axes.legend("upper right")
    axes.only_grid("x")
    return figure


@theme.drawn
def mass_of_life_figure(life: LifeSizing) -> Figure:
    """Return the mass of the gearbox against the life of its weakest gear, round by round.

    Args:
        life: From `size_for_life`.
    """
    hours, masses = (list(column) for column in zip(*life.path, strict=True))
    figure = theme.sheet(WIDTH, 64.0)
    axes = figure.panel()
    axes.plot(hours, masses, color=theme.BLUE, marker="o", ms=3.5)
    axes.axvline(life.hours, color=theme.ORANGE, lw=0.9, ls="--")
    axes.annotate(f"asked: {life.hours:,.0f} h", (life.hours, masses[0]), (-4, 0),
                  ha="right", color=theme.ORANGE)  # fmt: skip
    _ends(axes, hours, masses)
    axes.set_xscale("log")
    axes.set_xlabel("life of the gear that fails first [flight hours]")
    axes.set_ylabel("gears, shafts,\ncarriers [kg]")
    axes.margins(x=0.08, y=0.2)
    return figure


def _ends(axes: Axes, hours: Sequence[float], masses: Sequence[float]) -> None:
    """Write life and mass beside the first and the last round."""
    for k, shift in ((0, (6, -10)), (-1, (-6, 7))):
        axes.annotate(
            f"{hours[k]:,.0f} h, {masses[k]:.2f} kg",
            (hours[k], masses[k]),
            shift,
            ha="left" if k == 0 else "right",
            fontsize=7.5,
        )
