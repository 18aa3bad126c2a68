"""Figures of what flies: histories, energy, spectra and lives, mixes, windows, propellers.

Figures of motion without a mission are beside this folder.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np

from gearwright.base import CELSIUS, FOOT, KNOT, KWH, RPM, Floats, shown
from gearwright.dynamics import Samples, Trace
from gearwright.machines import PropellerMap
from gearwright.mission import Balance, Durability, Flight, FlownMix, LifeSizing
from gearwright.mission.lives import LoadLife, seat_duties
from gearwright.mission.windows import DynamicWindow
from gearwright.render import style as theme
from gearwright.render.figures.motion import families
from gearwright.render.style import WIDTH, stacked
from gearwright.render.tables.flights import MOST_PARTS as MOST_ROWS
from gearwright.render.vector.figure import Axes, Curve, Figure

# ----------------------------------------------------------------------------------------------------------------------
# Figures of a flight over its time: profile, powers and torques, fuel and charge, heat and oil.
# ----------------------------------------------------------------------------------------------------------------------


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


class PhaseSpan(NamedTuple):
    """One phase on the axis of time."""

    name: str
    mode: str
    start: float
    """[min]"""
    end: float
    """[min]"""


def stretches(flight: Flight) -> tuple[PhaseSpan, ...]:
    """Return the phases of a flight on its axis of time.

    Args:
        flight: As flown.
    """
    phases, clock, names = [], 0.0, np.array(flight.phase)
    for name, phase in flight.mission.phases.items():
        length = float(flight.history.duration[names == name].sum()) / _MINUTE
        phases.append(PhaseSpan(name, "hybrid" if phase.strategy else phase.mode, clock, clock + length))
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


def _strip(axes: Axes, parts: Sequence[PhaseSpan], end: float) -> None:
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


# ----------------------------------------------------------------------------------------------------------------------
# Where the energy of a flight came from and where it went: a Sankey diagram in which width is energy.
# ----------------------------------------------------------------------------------------------------------------------


_NODE = 0.018
"""Width of a node, over the width of the figure [-]."""
_COLUMNS = (0.0, 0.30, 0.60, 0.82)
"""Where sources, machines, gearbox and sinks stand, over the width of the figure [-]."""
_GAP = 0.05
"""Between bands that part, over the height of all energy [-]."""
_TEXT_GAP = 0.062
"""Between two labels, over the same [-]."""


class Sink(NamedTuple):
    """Where energy ends."""

    name: str
    energy: float
    """[J]"""
    colour: str


class Energies(NamedTuple):
    """A flight's energies as they flow; all are 0 or more [J]."""

    fuel: float
    battery: float
    slowed: float
    """From what turns, as it slows down."""
    air: float
    """From a propeller that the air has driven."""
    turbine: float
    """Turbines to gearbox."""
    electric: float
    """Motors to gearbox."""
    generated: float
    """Gearbox to motors: regeneration, or motors that are dragged."""
    hot: tuple[Sink, ...]
    """Of the turbines."""
    used: tuple[Sink, ...]
    """Of the gearbox."""
    lost: tuple[Sink, ...]
    """Of motors and battery."""


def energies(balance: Balance) -> Energies:
    """Return the flows between machines and gearbox that a balance implies.

    Args:
        balance: Of a flight.

    Source: balance of each node; charge and discharge of one flight are netted, and so is the propeller's work.
    """
    from_motors = balance.battery - balance.battery_loss - balance.motor_loss
    gearbox = [Sink(words, getattr(balance, name), colour) for name, (words, colour) in LOSSES.items()]
    return Energies(
        fuel=balance.fuel,
        battery=max(balance.battery, 0.0),
        slowed=max(-balance.stored, 0.0),
        air=max(-balance.propeller, 0.0),
        turbine=balance.fuel - balance.turbine_heat,
        electric=max(from_motors, 0.0),
        generated=max(-from_motors, 0.0),
        hot=_positive([
            Sink("exhaust of the turbines", balance.exhaust_heat, theme.MUTED),
            Sink("casings of the turbines", balance.casing_heat, theme.MUTED),
        ]),
        used=_positive([
            Sink("work of the propeller", balance.propeller, theme.GREEN),
            Sink("accessories and other loads", balance.consumers, theme.BLUE), *gearbox,
            Sink("spin of rotors and gears", max(balance.stored, 0.0), theme.SKY),
        ]),
        lost=_positive([
            Sink("motors and inverters", balance.motor_loss, theme.ORANGE),
            Sink("battery's resistance", balance.battery_loss, theme.AMBER),
            Sink("charge of the battery", max(-balance.battery, 0.0), theme.PURPLE),
        ]),
    )  # fmt: skip


def _positive(sinks: Sequence[Sink]) -> tuple[Sink, ...]:
    return tuple(sink for sink in sinks if sink.energy > 0.0)


@theme.drawn
def sankey_figure(flight: Flight) -> Figure:
    """Return the energy flow of one gearbox over a flight, with a bar that magnifies the gearbox's own losses.

    Args:
        flight: As flown.
    """
    flows = energies(flight.balance)
    figure = theme.sheet(WIDTH, 112.0)
    axes, bar = figure.grid(2, 1, heights=[5.2, 1.0])[:, 0]
    _flows(axes, flows, flight.balance.came_in)
    _magnified(bar, flight.balance, 1.0 - flight.efficiency())
    return figure


def _flows(axes: Axes, flows: Energies, unit: float) -> None:
    """Stack nodes from above: fuel over battery; turbines over gearbox over motors; their sinks in that order."""
    gap = _GAP
    first, second, third, _ = _COLUMNS
    heat = sum(sink.energy for sink in flows.hot) / unit
    turbine, electric, generated = (energy / unit for energy in (flows.turbine, flows.electric, flows.generated))
    fuel, battery, slowed, air = (energy / unit for energy in (flows.fuel, flows.battery, flows.slowed, flows.air))
    used, lost = (sum(sink.energy for sink in sinks) / unit for sinks in (flows.used, flows.lost))
    motors_top, gearbox_top = -(fuel + 4.0 * gap), -(heat + 2.0 * gap)
    below = gearbox_top - turbine - electric
    sinks = _Sinks(axes, unit)
    if fuel:
        _node(axes, first, 0.0, fuel, f"fuel  {flows.fuel / KWH:,.0f} kWh")
        _band(axes, (first + _NODE, 0.0), (second, 0.0), fuel, theme.SKY)
        _node(axes, second, 0.0, fuel, "turbines")
        sinks.draw(flows.hot, second + _NODE, 0.0, 0.0)
        _band(axes, (second + _NODE, -heat), (third, gearbox_top), turbine, theme.BLUE)
    _node(axes, third, gearbox_top, max(turbine + electric + slowed + air, used + generated), "gearbox")
    _band(axes, (third - 0.06, below), (third, below), slowed, theme.SKY)
    sinks.draw(flows.used, third + _NODE, gearbox_top, gearbox_top)
    if air:  # it comes from the right, below what leaves there
        wind = Sink("from the air", flows.air, theme.GREEN)
        sinks.draw([wind], third + _NODE, gearbox_top - used, gearbox_top - used)
    if battery or lost:
        _node(axes, first, motors_top, battery, f"battery  {flows.battery / KWH:,.0f} kWh" if battery else "")
        _band(axes, (first + _NODE, motors_top), (second, motors_top), battery, theme.AMBER)
        _node(axes, second, motors_top, max(battery + generated, electric + lost), "motors")
        _band(axes, (second + _NODE, motors_top), (third, gearbox_top - turbine), electric, theme.ORANGE)
        _band(axes, (third, gearbox_top - used), (second + _NODE, motors_top - battery), generated, theme.PURPLE)
        sinks.draw(flows.lost, second + _NODE, motors_top - electric, motors_top - electric)
    sinks.label()
    axes.set(xlim=(0.0, 1.2), ylim=(min(motors_top - max(battery, lost), sinks.lowest) - 0.03, 0.08))
    axes.set_axis_off()


class _Sinks:
    """Draws bands to the right edge and labels them all at once, so that no label covers another."""

    def __init__(self, axes: Axes, unit: float) -> None:
        self.axes, self.unit = axes, unit
        self.ends: list[tuple[float, float, Sink]] = []

    def draw(self, sinks: Sequence[Sink], left: float, top: float, right_top: float) -> None:
        """Draw the bands of one node from their place on it to the right edge."""
        for sink in sinks:
            high = sink.energy / self.unit
            end = min(right_top, self._below(high))
            _band(self.axes, (left, top), (_COLUMNS[-1], end), high, sink.colour)
            self.axes.rectangle((_COLUMNS[-1], end - high), 0.5 * _NODE, high, fc=sink.colour)
            self.ends.append((end, high, sink))
            top -= high

    def _below(self, high: float) -> float:
        """Return the highest top of a band that clears the one above and its label."""
        if not self.ends:
            return 0.0
        top, tall, _ = self.ends[-1]
        return min(top - tall - 0.4 * _GAP, top - tall / 2.0 - _TEXT_GAP + high / 2.0)

    @property
    def lowest(self) -> float:
        """Bottom of the lowest label."""
        return min((end - high for end, high, _ in self.ends), default=0.0) - 0.5 * _TEXT_GAP

    def label(self) -> None:
        """Write name, energy and share of every sink beside its band."""
        for end, high, sink in self.ends:
            words = f"{sink.name}  {sink.energy / KWH:,.1f} kWh, {sink.energy / self.unit:.1%}"
            if sink.energy / self.unit < 1e-3:
                words = f"{sink.name}  {sink.energy / KWH:,.2f} kWh"
            self.axes.text(_COLUMNS[-1] + 0.02, end - high / 2.0, words, va="center", fontsize=7.5)


def _node(axes: Axes, left: float, top: float, high: float, words: str) -> None:
    axes.rectangle((left, top - high), _NODE, high, fc=theme.INK)
    axes.annotate(words, (left, top), (0, 3), fontsize=8.0, weight="bold", va="bottom")


def _band(axes: Axes, start: tuple[float, float], end: tuple[float, float], high: float, colour: str) -> None:
    """Draw a band whose upper edge runs from start to end."""
    if not high:
        return
    (a, b), (c, d) = start, end
    middle = (a + c) / 2.0
    corners = [(a, b), (middle, b), (middle, d), (c, d), (c, d), (c, d - high), (c, d - high), (middle, d - high),
               (middle, b - high), (a, b - high)]  # fmt: skip
    axes.shape(corners, fc=colour, ec=colour, alpha=0.55, lw=0.3, cubic=True)


def _magnified(axes: Axes, balance: Balance, share: float) -> None:
    """Draw the gearbox's own losses, a share of what enters it, as one bar of their own scale."""
    left, total = 0.0, balance.gearbox_loss
    for name, (words, colour) in LOSSES.items():
        part = getattr(balance, name) / total
        if part:
            label = f"{words} {getattr(balance, name) / KWH:.2f} kWh, {part:.0%}"
            axes.barh(0.0, part, left=left, height=0.8, color=colour, label=label)
            left += part
    axes.set_title(f"The gearbox's own losses, magnified: {total / KWH:.2f} kWh, {share:.2%} of what enters it")
    axes.set_xlim(0.0, 1.0)
    axes.legend("below", columns=4)
    axes.set_axis_off()


# ----------------------------------------------------------------------------------------------------------------------
# Figures of what a flight does to parts: duty spectra of meshes, bearings and shafts, lives, the mass of a life.
# ----------------------------------------------------------------------------------------------------------------------


FAILURE_COLOURS = {"bending": theme.BLUE, "pitting": theme.SKY, "rolling fatigue": theme.AMBER}
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
        axes.barh(place, row.flights, left=0.5, height=0.72, color=FAILURE_COLOURS[row.mode])
        axes.annotate(
            f"{row.flights:,.0f} flights, {row.life:,.0f} h", (row.flights, place), (4, 0), fontsize=7.5, va="center"
        )
    for mode in dict.fromkeys(row.mode for row in rows):
        axes.barh([0], [0.0], color=FAILURE_COLOURS[mode], label=mode)
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


# ----------------------------------------------------------------------------------------------------------------------
# S-N curves of flanks and roots with the spectrum of a flight laid on them, and Miner's part of every class.
# ----------------------------------------------------------------------------------------------------------------------


SHOWN = 6
"""Flanks and roots that are drawn, the most damaged ones."""
LONGEST = 1e13
"""Load changes at which the axis ends [-]."""
LARGEST = 60.0
"""Area of the disc of a class that does all of the damage [pt²]."""


@theme.drawn
def load_life_figure(rows: Sequence[LoadLife], flights: float = 1.0) -> Figure:
    """Return a panel for each flank and root: what it bears, what it gets in so many flights, and where it is damaged.

    Args:
        rows: From `load_lives`, the most damaged first; the first few are drawn.
        flights: Of the life that is asked for [-].
    """
    shown = rows[:SHOWN]
    figure, grid = theme.tiles(len(shown), 3, frame=20.0, row=56.0)
    for axes, row in zip(grid.flat, shown, strict=False):
        _draw(axes, row, flights)
    for axes in grid[:, 0]:
        axes.set_ylabel("mesh force [kN]")
    for axes in grid[-1]:
        axes.set_xlabel("load changes [-]")
    figure.shared_key = 3
    return figure


def _draw(axes: Axes, row: LoadLife, flights: float) -> None:
    order = np.argsort(-row.force, kind="stable")
    force, reached = row.force[order] / _KILO, np.cumsum(row.changes[order]) * flights
    bears = (row.borne > 1.0) & (row.borne < LONGEST)
    axes.plot(row.borne[bears][::-1], row.ladder[bears][::-1] / _KILO, color=theme.ORANGE, label="borne: S-N curve")
    axes.step(
        [min(reached[0], 1.0), *reached], [force[0], *force], where="pre", color=theme.BLUE, label="asked: spectrum"
    )
    if row.total > 0.0:
        broken = np.isinf(row.damage[order])
        parts = broken.astype(float) if broken.any() else row.damage[order] / row.total
        axes.scatter(reached, force, np.maximum(LARGEST * parts, 1e-3), color=theme.BLUE, alpha=0.5,
                     label="area: its part of the damage")  # fmt: skip
    part, way = str(row.part), {"pitting": "flank", "bending": "root"}[row.mode]
    axes.set_title(f"{part} {way}: D = {row.total * flights:.2g}", fontsize=8.0)
    axes.set(xscale="log", xlim=(1e2, LONGEST), ylim=(0.0, 1.8 * float(force[0])))


# ----------------------------------------------------------------------------------------------------------------------
# Figure of a life of several missions: Miner's sum of every part that matters, and which mission eats it.
# ----------------------------------------------------------------------------------------------------------------------


LEAST = 1e-6
"""Miner's sum after the whole life below which a part is not drawn [-]."""


@theme.drawn
def eaten_figure(flown: FlownMix) -> Figure:
    """Return the parts of the damage of every part by mission, the part that governs first on top.

    Args:
        flown: As flown.
    """
    known = [part for part in flown.life.parts if LEAST < part.damage * flown.mix.flights < float("inf")][:MOST_ROWS]
    figure = theme.sheet(WIDTH, 30.0 + 6.0 * max(len(known), 1))
    axes = figure.panel()
    left = [0.0] * len(known)
    for colour, name in zip(cycle(theme.CYCLE), flown.flights, strict=False):
        sums = [flown.damage_by_mission(part) for part in known]
        widths = [100.0 * damage[name] / sum(damage.values()) for damage in sums]
        axes.barh(range(len(known)), widths, left=left, height=0.72, color=colour, label=name)
        left = [start + width for start, width in zip(left, widths, strict=True)]
    for place, part in enumerate(known):
        axes.annotate(f"{part.damage * flown.mix.flights:.3g}", (100.0, place), (4, 0), fontsize=7.5, va="center")
    axes.set_yticks(range(len(known)), [f"{part.name}, {part.mode}" for part in known])
    axes.set(xlim=(0.0, 116.0), xlabel="part of the damage [%]; behind the bars Miner's sum of the whole life")
    axes.invert_yaxis()
    axes.legend("above", columns=4)
    axes.only_grid("x")
    return figure


# ----------------------------------------------------------------------------------------------------------------------
# Figure of a dynamic window: speeds, shaft torques, mesh forces and pitch against time, and its end at every step.
# ----------------------------------------------------------------------------------------------------------------------


HEIGHT = 150.0
"""[mm]"""


@theme.drawn
def window_figure(window: DynamicWindow) -> Figure:
    """Return what a window did.

    Args:
        window: As flown.
    """
    trace = window.trace
    figure = theme.sheet(WIDTH, HEIGHT)
    grid = figure.grid(3, 2)
    _speeds(grid[0, 0], trace)
    _pitches(grid[0, 1], window)
    _bands(grid[1, 0], trace, "rad")
    _bands(grid[1, 1], trace, "m")
    _close(grid[2, 0], trace, "rad")
    _close(grid[2, 1], trace, "m")
    for axes in grid[:2].flat:
        axes.set_xlabel("time [s]")
        axes.margins(x=0.0)
        if window.rules.event != "none":
            axes.axvline(window.rules.event_at, color=theme.MUTED, lw=0.7, ls=":")
    return figure


def _speeds(axes: Axes, trace: Trace) -> None:
    for name, speed in _drive_histories(trace.samples, "speed").items():
        label = f"{name}, {shown(float(speed[0]), 'speed'):.0f} rpm"
        axes.plot(trace.samples.time, 100.0 * (speed / speed[0] - 1.0), label=label, lw=0.9)
    axes.set(title="Speeds over those at the start", ylabel="[%]")
    axes.legend("best", size=6.5)


def _pitches(axes: Axes, window: DynamicWindow) -> None:
    samples = window.trace.samples
    for pitch in _drive_histories(samples, "pitch").values():
        axes.plot(samples.time, np.degrees(pitch), color=theme.GREEN, label="pitch")
    axes.set(title="Pitch and torque of the propeller", ylabel="pitch [°]")
    other = axes.twinx()
    for name in _drive_histories(samples, "pitch"):
        torque = samples.drive(f"{name} torque")
        sense = np.sign(torque[0]) or 1.0  # what a stream drives is negative
        other.plot(samples.time, sense * torque / 1e3, color=theme.ORANGE, lw=0.9, label="torque")
    other.set_ylabel("torque [kN m]")
    axes.legend("best", size=6.5)


def _bands(axes: Axes, trace: Trace, unit: str) -> None:
    """Draw means with bands from least to greatest of every time bin."""
    edges = trace.force.edges
    middle = 0.5 * (edges[1:] + edges[:-1])
    for place, (family, names) in enumerate(families(trace.labels, unit).items()):
        colour = theme.CYCLE[place % len(theme.CYCLE)]
        bins = [trace.force.of(name) for name in names]
        lowest, highest = np.min([bin["minimum"] for bin in bins], 0), np.max([bin["maximum"] for bin in bins], 0)
        axes.fill_between(middle, lowest / 1e3, highest / 1e3, color=colour, alpha=0.25, lw=0.0)
        axes.plot(middle, bins[0]["mean"] / 1e3, color=colour, lw=0.9, label=family)
    axes.set(title="Shaft torques" if unit == "rad" else "Mesh forces", ylabel="[kN m]" if unit == "rad" else "[kN]")
    axes.legend("best", size=6.0, columns=2)


def _close(axes: Axes, trace: Trace, unit: str) -> None:
    """Draw the end of the window, every step: the first line of each family, torques over their mean."""
    samples = trace.windows[-1]
    for place, names in enumerate(families(trace.labels, unit).values()):
        force = samples.force(names[0])
        values = force - np.mean(force) if unit == "rad" else force / 1e3
        axes.plot(1e3 * (samples.time - samples.time[0]), values, color=theme.CYCLE[place % len(theme.CYCLE)], lw=0.8)
    axes.set_title("Its end, over the mean" if unit == "rad" else "Its end, one mesh of each row")
    axes.set_ylabel("[N m]" if unit == "rad" else "[kN]")
    axes.set_xlabel("time [ms]")
    axes.margins(x=0.0)


def _drive_histories(samples: Samples, what: str) -> dict[str, Floats]:
    """Return one kind of history of all drives that have it, by drive, positive at the start.

    Args:
        samples: Of a run with drives.
        what: Such as ``"speed"``.
    """
    owners = enumerate(samples.labels.drive_owners)
    return {
        str(owner.part): samples.drives[:, place] * (np.sign(samples.drives[0, place]) or 1.0)
        for place, owner in owners
        if owner.what == what
    }


# ----------------------------------------------------------------------------------------------------------------------
# Figure of a propeller map: C_P, C_T and efficiency over the advance ratio, a curve for each blade angle.
# ----------------------------------------------------------------------------------------------------------------------


MOST_CURVES = 14
"""Blade angles that are drawn, at most, of those at which the propeller pulls somewhere."""
_FLOOR = -0.15
"""Lowest coefficient that is drawn, over the highest [-]."""


@theme.drawn
def propeller_figure(chart: PropellerMap, title: str) -> Figure:
    """Return C_P, C_T and efficiency over the advance ratio.

    Args:
        chart: The map.
        title: Of the figure.
    """
    figure = theme.sheet(theme.WIDTH, 165.0)
    power, thrust, efficiency = figure.grid(3, 1, share_x=True)[:, 0]
    columns = _pulling(chart)
    rises = np.gradient(chart.thrust, axis=1)
    for place, column in enumerate(columns):
        rows = (chart.first <= column) & (column <= chart.last)
        ratio, taken, given = chart.advance_ratio[rows], chart.power[rows, column], chart.thrust[rows, column]
        stalled = (rises[rows, column] <= 0.0) & (given > 0.0)
        taken, given = np.where(stalled, np.nan, taken), np.where(stalled, np.nan, given)
        pulls = (taken > 0.0) & (given > 0.0)
        colour = theme.CYCLE[place % len(theme.CYCLE)]
        name = f"{math.degrees(chart.blade_angle[column]):.3g}°"
        for axes, values in ((power, taken), (thrust, given)):
            axes.plot(ratio, values, color=colour, lw=0.9)
        part = np.where(pulls, ratio * given / np.where(pulls, taken, 1.0), np.nan)
        efficiency.plot(ratio, part, color=colour, lw=0.9)
        _named(efficiency, ratio, part, name)
    for axes, label in ((power, "power coefficient C_P"), (thrust, "thrust coefficient C_T")):
        highest = max((float(np.nanmax(values)) for values in _shown(axes)), default=1.0)
        axes.set(ylabel=label, ylim=(_FLOOR * highest, 1.05 * highest))
        axes.axhline(0.0, color=theme.MUTED, lw=0.6)
    efficiency.set(ylabel="efficiency", ylim=(0.0, 1.0), xlabel="advance ratio J")
    power.set_title(f"{title}, blades that are not stalled")
    return figure


def _shown(axes: Axes) -> list[Floats]:
    curves = [curve.y for curve in axes.of(Curve)]
    return [values for values in curves if not np.isnan(values).all()]


def _pulling(chart: PropellerMap) -> list[int]:
    pulls = np.flatnonzero(((chart.thrust > 0.0) & (chart.power > 0.0)).any(axis=0))
    return [int(k) for k in pulls[:: -(-len(pulls) // MOST_CURVES)]]


def _named(axes: Axes, ratio: Floats, values: Floats, name: str) -> None:
    """Write the blade angle where its curve is highest."""
    if np.isnan(values).all():
        return
    top = int(np.nanargmax(values))
    axes.annotate(name, (ratio[top], values[top]), (2, 1), fontsize=6.0, color=theme.INK)
