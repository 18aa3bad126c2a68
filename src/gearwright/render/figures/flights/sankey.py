"""Where the energy of a flight came from and where it went: a Sankey diagram in which width is energy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from gearwright.mission import Balance, Flight
from gearwright.render.figures.flights.flight import LOSSES
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.units import KWH

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
