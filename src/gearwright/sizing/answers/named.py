"""Results of a sizing by name, for studies and scripts: ``mass``, ``motor_mass``, ``gears.first.sun.module`` …"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import fields
from types import MappingProxyType
from typing import NamedTuple, get_args, get_type_hints

from gearwright.errors import DesignError, Problem, near
from gearwright.sizing.answers.passing import ways_of
from gearwright.sizing.answers.totals import excitation, flank_area
from gearwright.sizing.arrangement import envelope
from gearwright.sizing.carrying import CarrierSizing, ShaftSizing
from gearwright.sizing.losses import lost_power
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.result import GearSizing, MachineSizing, Sizing
from gearwright.train import PowerFlow
from gearwright.units import Quantity, marks_at
from gearwright.verbs import verb

TEXT = "text"
"""Dimension of a result that is a name, such as the part that governs."""


class Named(NamedTuple):
    """A result with its dimension."""

    value: float | str
    """In SI; a text where the result is a name."""
    dimension: str
    """Such as ``"mass"``, a key of the table of shown units; ``TEXT`` of a text."""


@verb
def named_results(sizing: Sizing) -> dict[str, Named]:
    """Return every number of a sizing by its dotted name.

    Args:
        sizing: What was sized.
    """
    return {**_totals(sizing, [*_TOTALS, *_SUMS, *_MORE]), **dict(_parts(sizing))}


def total_results(sizing: Sizing) -> dict[str, Named]:
    """Return what a sizing amounts to, by name.

    Args:
        sizing: What was sized.
    """
    return {name: total(sizing) for name, total in _TOTALS.items()}


def complete_results(sizing: Sizing) -> dict[str, Named]:
    """Return the sum of all parts and the limits of its band of 68 %, by name.

    Args:
        sizing: What was sized.
    """
    mass = complete_mass(sizing)
    return {name: Named(value, "mass") for name, value in zip(_SUMS, (mass.total, *mass.band), strict=True)}


def asked_results(sizing: Sizing, asked: Collection[str]) -> dict[str, Named]:
    """Return results of a sizing with those that are asked among them, where it has them; little more than need be.

    Args:
        sizing: What was sized.
        asked: Their names.
    """
    if all(name in _TOTALS or name in _SUMS or name in _MORE for name in asked):
        return _totals(sizing, asked)
    return named_results(sizing)


def _totals(sizing: Sizing, asked: Collection[str]) -> dict[str, Named]:
    """Return totals by name, each computed only where it is asked for."""
    sums = complete_results(sizing) if set(asked) & set(_SUMS) else {}
    more = {**_TOTALS, **_MORE}
    return {name: sums[name] if name in sums else more[name](sizing) for name in asked}


def _backwards(sizing: Sizing) -> Named:
    """Return the efficiency of a gearbox that its driven machines drive; what is not above zero locks itself."""
    ways = ways_of(sizing, sizing.reference, ("",)) if sizing.reference.loss else {}
    return Named(ways[""].backwards if "" in ways else 1.0, "ratio")


def _efficiency(flow: PowerFlow) -> float:
    """Return power out over power in, of mesh losses alone [-]."""
    return 1.0 - flow.loss / sum(power for power in flow.machine_powers.values() if power > 0.0)


_SUMS = ("complete_mass", "complete_mass.low", "complete_mass.high")
"""Results of the complete mass."""
_TOTALS: Mapping[str, Callable[[Sizing], Named]] = MappingProxyType({
    "mass": lambda sizing: Named(sizing.mass, "mass"),
    "gear_mass": lambda sizing: Named(sizing.gear_mass, "mass"),
    "shaft_mass": lambda sizing: Named(sizing.shaft_mass, "mass"),
    "carrier_mass": lambda sizing: Named(sizing.carrier_mass, "mass"),
    "motor_mass": lambda sizing: Named(sizing.motor_mass, "mass"),
    "total_mass": lambda sizing: Named(sizing.mass + sizing.motor_mass, "mass"),
    "power_density": lambda sizing: Named(sizing.power_density, "specific_power"),
    "total_power_density": lambda sizing: Named(sizing.total_power_density, "specific_power"),
    "worst_margin": lambda sizing: Named(sizing.worst_margin, "ratio"),
    "efficiency": lambda sizing: Named(_efficiency(sizing.reference), "ratio"),
    "efficiency_backwards": _backwards,
})  # fmt: skip
"""What a sizing amounts to, each computed only where it is asked for."""
_MORE: Mapping[str, Callable[[Sizing], Named]] = MappingProxyType({
    "loss": lambda sizing: Named(lost_power(sizing), "power"),
    "excitation": lambda sizing: Named(excitation(sizing), "force"),
    "flank_area": lambda sizing: Named(flank_area(sizing), "area"),
    "envelope.width": lambda sizing: Named(envelope(sizing).width, "length"),
    "envelope.height": lambda sizing: Named(envelope(sizing).height, "length"),
    "envelope.length": lambda sizing: Named(envelope(sizing).length, "length"),
    "envelope.volume": lambda sizing: Named(envelope(sizing).volume, "volume"),
})  # fmt: skip
"""More of them, of which nobody is told who asks for none by name."""


@verb
def pick(results: dict[str, Named], name: str) -> Named:
    """Return one result.

    Args:
        results: From `named_results`.
        name: Its name.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    if name not in results:
        raise DesignError([Problem(f"results.{name}", f"there is no such result; {near(name, results)}")])
    return results[name]


def _parts(sizing: Sizing) -> Iterator[tuple[str, Named]]:
    """Yield the numbers of every gear, mesh, shaft, carrier and machine."""
    for group in ("gears", "meshes", "shafts", "carriers", "machines"):
        for part in getattr(sizing, group):
            name = getattr(part, "stage" if group == "carriers" else "name")
            for field, dimension in _QUANTITIES[type(part)]:
                value = getattr(part, field)
                if value is not None:
                    yield f"{group}.{name}.{field}", Named(float(value), dimension)
    for case, flow in sizing.flows.items():
        for shaft, speed in flow.speeds.items():
            yield f"cases.{case}.{shaft}.speed", Named(speed, "speed")
        for machine, power in flow.machine_powers.items():
            yield f"cases.{case}.{machine}.power", Named(power, "power")
            yield f"cases.{case}.{machine}.torque", Named(flow.machine_torques[machine], "torque")


def _quantities(kind: type) -> tuple[tuple[str, str], ...]:
    """Return the numbers of a record: those with a dimension, whole ones, and those that a record inside made."""
    hints = get_type_hints(kind, include_extras=True)
    values = []
    for field in fields(kind):
        marks = [mark for mark in get_args(hints[field.name])[1:] if isinstance(mark, Quantity)]
        if marks:
            values.append((field.name, marks[0].dimension))
        elif hints[field.name] is int:
            values.append((field.name, "number"))
    handed = [
        name for name, entry in vars(kind).items() if isinstance(entry, property) and marks_at(kind, name).made_in
    ]
    return (*values, *((name, marks_at(kind, name).dimension) for name in handed))


_QUANTITIES = {kind: _quantities(kind) for kind in (GearSizing, MeshSizing, ShaftSizing, CarrierSizing, MachineSizing)}
"""Record -> its numbers, looked up once."""
