"""Figures of a flight over its time: profile, powers and torques, fuel and charge, heat and oil."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.mission import Flight
from gearwright.render.style import theme
from gearwright.render.style.compound import stacked
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.units import CELSIUS, FOOT, KNOT, RPM

MODE_COLOURS = {
    "conventional": theme.BLUE, "hybrid": theme.PURPLE, "electric": theme.ORANGE, "rated": theme.GREEN,
}  # fmt: skip
"""Colour of each propulsion mode."""
LOSSES = {
    "mesh_loss": ("meshes", theme.BLUE),
    "bearing_loss": ("bearings", theme.AMBER),
    "windage_loss": ("windage", theme.SKY),
    "churning_loss": ("churning", theme.GREEN),
}
"""Losses of the gearbox: name in the history -> words and colour."""
_MINUTE, _KILO, _HOUR = 60.0, 1e3, 3600.0
LEAST_TORQUE = 1.0
"""Of a shaft that is drawn [N m]."""
_LABEL_GAP = 0.055
"""Least distance of two phase names, over the width of the figure [-]."""


class Stretch(NamedTuple):
    """One phase on the axis of time."""

    name: str
    mode: str
    start: float
    """[min]"""
    end: float
    """[min]"""


def stretches(flight: Flight) -> tuple[Stretch, ...]:
    """Return the phases of a flight on its axis of time.

    Args:
        flight: As flown.
    """
    phases, clock, names = [], 0.0, np.array(flight.phase)
    for name, phase in flight.mission.phases.items():
        length = float(flight.history.duration[names == name].sum()) / _MINUTE
        phases.append(Stretch(name, "hybrid" if phase.strategy else phase.mode, clock, clock + length))
        clock += length
    return tuple(phases)


def apart(places: Sequence[float], gap: float) -> list[float]:
    """Return places in their order that are moved as little as keeps them a gap apart.

    It asks what `spread` asks of labels on sheets, and differs in last bits, which the ids in a figure show.

    Args:
        places: Rising.
        gap: Least distance.

    >>> apart([0.0, 0.0, 10.0], 2.0)
    [-1.0, 1.0, 10.0]
    """
    blocks: list[tuple[float, int]] = []
    for k, place in enumerate(places):
        blocks.append((place - gap * k, 1))
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            (level, count), (low, more) = blocks[-2], blocks[-1]
            blocks[-2:] = [((level * count + low * more) / (count + more), count + more)]
    levels = [level for level, count in blocks for _ in range(count)]
    return [level + gap * k for k, level in enumerate(levels)]


def _panels(flight: Flight, heights: Sequence[float]) -> tuple[Figure, list[Axes]]:
    """Return a figure with panels over the time, below a strip that names phases and modes [mm]."""
    figure = theme.sheet(WIDTH, 24.0 + sum(heights))
    ratios = [5.0, *heights]
    axes = list(figure.grid(len(ratios), 1, share_x=True, heights=ratios)[:, 0])
    parts = stretches(flight)
    end = parts[-1].end
    _strip(axes[0], parts, end)
    for panel in axes[1:]:
        for part in parts[1:]:
            panel.axvline(part.start, color=theme.HAIR, lw=0.8, zorder=0)
        panel.x.grid = False
    axes[-1].set(xlim=(0.0, end), xlabel="time [min]")
    return figure, axes[1:]


def _strip(axes: Axes, parts: Sequence[Stretch], end: float) -> None:
    places = apart([(part.start + part.end) / 2.0 for part in parts], _LABEL_GAP * end)
    for part, place in zip(parts, places, strict=True):
        axes.barh(0.0, part.end - part.start, left=part.start, height=1.0, color=MODE_COLOURS[part.mode],
                  edgecolor=theme.PAPER, linewidth=0.6)  # fmt: skip
        axes.annotate(part.name, (place, 1.25), rotation=32.0, fontsize=7.0, va="bottom",
                      leader=((part.start + part.end) / 2.0, 0.5))  # fmt: skip
    for mode in dict.fromkeys(part.mode for part in parts):
        axes.barh(0.0, 0.0, color=MODE_COLOURS[mode], label=mode)
    axes.legend("below", columns=4)
    axes.set_ylim(-0.5, 0.5)
    axes.set_axis_off()


def _minutes(flight: Flight) -> Floats:
    return flight.history.time / _MINUTE


@theme.drawn
def profile_figure(flight: Flight) -> Figure:
    """Return altitude, airspeed, propeller speed and pitch over the time, with the propulsion modes.

    Args:
        flight: As flown.
    """
    figure, (height, speed, turning, pitch) = _panels(flight, [28.0, 24.0, 20.0, 20.0])
    time, history = _minutes(flight), flight.history
    feet = history.altitude / FOOT
    height.fill_between(time, feet, color=theme.STEEL)
    height.plot(time, feet, color=theme.INK)
    height.set_ylabel("pressure\naltitude [ft]")
    height.set_ylim(bottom=0.0)
    speed.plot(time, history.true_airspeed / KNOT, color=theme.BLUE, label="true airspeed [kt]")
    speed.set_ylabel("true airspeed\n[kt]", color=theme.BLUE)
    mach = speed.twinx()
    mach.plot(time, history.mach, color=theme.MUTED, lw=0.8, ls="--")
    mach.set_ylabel("Mach\n(dashed)", color=theme.MUTED)
    mach.set_ylim(0.0, 1.25 * max(float(history.mach.max()), 0.05))
    turning.plot(time, history.propeller_speed / RPM, color=theme.GREEN)
    turning.set_ylabel("propeller\n[rpm]")
    for panel in (speed, turning):
        panel.set_ylim(bottom=0.0)
    if history.pitch is not None:
        pitch.plot(time, np.degrees(history.pitch), color=theme.PURPLE)
        pitch.set_ylabel("blade\nangle [°]")
    else:
        pitch.plot(time, history.air_density, color=theme.PURPLE)
        pitch.set_ylabel("air density\n[kg/m³]")
    return figure


@theme.drawn
def power_figure(flight: Flight) -> Figure:
    """Return the powers of all machines, what the turbines could give, and the torque of every shaft.

    Args:
        flight: As flown.
    """
    figure, (powers, torques) = _panels(flight, [46.0, 40.0])
    time, history = _minutes(flight), flight.history
    stacks = list(_machines(flight))
    for sign in (1.0, -1.0):
        parts = [np.maximum(sign * values, 0.0) * sign / _KILO for _, values, _ in stacks]
        if any(part.any() for part in parts):
            stacked(powers, time, parts, colours=[colour for *_, colour in stacks], alpha=0.85,
                    labels=[name for name, *_ in stacks] if sign > 0.0 else [])  # fmt: skip
    powers.plot(time, history.propeller_power / _KILO, color=theme.INK, label="propeller takes")
    if history.turbine_available.any():
        powers.plot(time, history.turbine_available / _KILO, color=theme.BLUE, lw=0.8, ls=":",
                    label="turbines could give")  # fmt: skip
    powers.set_ylabel("power [kW]")
    powers.legend("upper right", columns=2)
    most = max(float(history.propeller_power.max()), float(history.turbine_available.max())) / _KILO
    powers.set_ylim(min(0.0, powers.get_ylim()[0]), 1.3 * most)
    for colour, name in zip(cycle(theme.CYCLE), flight.sizing.design.shafts, strict=False):
        torques.plot(time, flight.nodes[name].torque, color=colour, label=name)
    torques.set_yscale("log")
    torques.set_ylim(bottom=LEAST_TORQUE)
    torques.set_ylabel("torque inside\nthe shaft [N m]")
    torques.legend("below", columns=4)
    return figure


def _machines(flight: Flight) -> Iterator[tuple[str, Floats, str]]:
    design = flight.sizing.design
    shades = {"turbine": (theme.BLUE, theme.SKY), "motor": (theme.ORANGE, theme.AMBER)}
    counts = {"turbine": 0, "motor": 0}
    for name, machine in flight.machines.items():
        kind = "turbine" if name in design.turbines else "motor"
        yield name, machine.power, shades[kind][counts[kind] % 2]
        counts[kind] += 1


@theme.drawn
def stores_figure(flight: Flight) -> Figure:
    """Return the fuel burnt, the state of charge, and the battery's voltage and current.

    Args:
        flight: As flown.
    """
    battery = flight.mission.battery is not None and bool(flight.history.battery_current.any())
    figure, (fuel, *others) = _panels(flight, [30.0, 22.0, 20.0, 20.0] if battery else [34.0])
    time, history = _minutes(flight), flight.history
    burnt = np.cumsum(history.fuel_flow * history.duration)
    fuel.fill_between(time, burnt, color=theme.STEEL)
    fuel.plot(time, burnt, color=theme.BLUE, label="burnt [kg]")
    fuel.plot(time, history.fuel_flow * _HOUR, color=theme.INK, lw=0.8, ls="--", label="flow [kg/h]")
    fuel.set_ylabel("fuel")
    fuel.set_ylim(0.0, 1.25 * max(float(burnt.max()), float(history.fuel_flow.max()) * _HOUR, 1.0))
    fuel.legend("upper left", columns=2)
    if battery:
        _charge(flight, time, others)
    return figure


def _charge(flight: Flight, time: Floats, panels: Sequence[Axes]) -> None:
    rules, history = flight.mission.battery, flight.history
    if rules is None:
        return
    charge, volts, rate = panels
    charge.plot(time, 100.0 * history.state_of_charge, color=theme.ORANGE)
    charge.axhline(100.0 * rules.minimum_charge, color=theme.MUTED, lw=0.7, ls="--")
    charge.annotate("minimum", (0.0, 100.0 * rules.minimum_charge), (3, 2), fontsize=7.0)
    charge.set(ylim=(0.0, 105.0), ylabel="state of\ncharge [%]")
    capacity = 2.0 * rules.energy / (rules.full_voltage_v + rules.empty_voltage_v)
    volts.plot(time, history.battery_voltage, color=theme.PURPLE)
    volts.set_ylabel("terminal\nvoltage [V]")
    rate.plot(time, _HOUR * history.battery_current / capacity, color=theme.GREEN)
    rate.axhline(0.0, color=theme.MUTED, lw=0.6)
    rate.set_ylabel(f"C-rate [1/h]\n(at most {rules.highest_c_rate:g})")


@theme.drawn
def heat_figure(flight: Flight) -> Figure:
    """Return the gearbox's losses by kind, its efficiency, and the oil's temperature behind it.

    Args:
        flight: As flown.
    """
    figure, (losses, share, oil) = _panels(flight, [34.0, 22.0, 26.0])
    time, history = _minutes(flight), flight.history
    kinds = {name: look for name, look in LOSSES.items() if getattr(history, name).any()}
    words, colours = zip(*kinds.values(), strict=True)
    stacked(losses, time, [getattr(history, name) / _KILO for name in kinds], colours=colours, labels=words)
    losses.set(ylabel="heat of the\ngearbox [kW]", ylim=(0.0, 1.25 * float(history.gearbox_heat.max()) / _KILO))
    losses.legend("upper right", columns=4)
    taken, delivered = flight.passed()
    share.plot(time, 100.0 * delivered / taken, color=theme.INK)
    share.set_ylabel("efficiency\n[%]")
    oil.plot(time, flight.oil_outlet - CELSIUS, color=theme.ORANGE, label="behind the gearbox")
    entering = np.full(len(time), flight.mission.oil.inlet_temperature_k - CELSIUS)
    oil.plot(time, entering, color=theme.BLUE, label="into it")
    oil.plot(time, history.air_temperature - CELSIUS, color=theme.SKY, lw=0.8, label="outside air")
    oil.set_ylabel("oil [°C]")
    oil.legend("below", columns=3)
    return figure
