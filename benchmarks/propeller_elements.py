"""Blade elements beside the Hamilton Standard charts, node by node and between: python benchmarks/propeller_elements.py

The generic blade and its section are fitted to the nodes (activity factor 150, C_Li 0.5); the points between them, of
other activity factors and design lifts, are not seen by that fit. The last line reads the elements' own coefficients
through the charts' method: how far the reading alone is from the elements between nodes. About two minutes.
"""

from __future__ import annotations

import math

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import hamilton_standard_charts
from gearwright.errors import SolveError
from gearwright.machines import Blades, Charts, performance
from gearwright.machines.propellers import generic_blade, loads

POINTS = 5000
"""Random points that are tried; those that the charts hold with an efficiency of 0.6 and more count."""
NODES = (2, 4, 6, 8)


def elements_thrust(blades: Blades, ratio: float, power: float, near: float) -> float:
    """C_T of the elements at a power, by the blade angle next to one that is known [rad]."""
    angles = near + np.radians(np.linspace(-12.0, 12.0, 49))
    made = loads(generic_blade(blades), ratio, angles)
    over = made.power - power
    crossed = np.flatnonzero((over[:-1] < 0.0) & (over[1:] >= 0.0))
    if not len(crossed):
        return math.nan
    k = crossed[np.argmin(np.abs(angles[crossed] - near))]
    return float(np.interp(0.0, over[k : k + 2], made.thrust[k : k + 2]))


def between(charts: Charts, draw: np.random.Generator, *, held_out: bool) -> Floats:
    """J, C_P per blade and activity factor of 150, and the elements' C_T over the charts', less 1."""
    rows = []
    for _ in range(POINTS):
        number = int(draw.choice([2, 3, 4, 5, 6, 8] if held_out else NODES))
        factor, lift = (draw.uniform(90.0, 180.0), draw.uniform(0.4, 0.6)) if held_out else (150.0, 0.5)
        blades, ratio = Blades(number, factor, lift), draw.uniform(0.8, 3.2)
        power = math.exp(draw.uniform(math.log(0.03), math.log(1.5)))
        try:
            point = performance(charts, blades, ratio, power_coefficient=power)
        except SolveError:
            continue
        if not point.held and ratio * point.thrust_coefficient >= 0.6 * power:
            thrust = elements_thrust(blades, ratio, power, point.blade_angle)
            rows.append((ratio, power / number * 150.0 / factor, thrust / point.thrust_coefficient - 1.0))
    return np.array(rows)


def nodes(charts: Charts, number: int) -> None:
    """Print efficiency and windmilling thrust at the charts' own points."""
    shape, count = generic_blade(Blades(number, 150.0, 0.5)), NODES.index(number)
    efficiency, windmill, taken = [], [], []
    for j, ratio in enumerate(charts.advance_ratio):
        made = loads(shape, ratio, np.radians(charts.blade_angle[j]))
        thrust, power = charts.thrust[count][j], charts.power[count][j]
        good = (power > 0.0) & (ratio * thrust >= 0.6 * power)
        efficiency += list(np.abs(made.thrust * power / (made.power * thrust) - 1.0)[good])
        windmill += list(np.abs(made.thrust - thrust)[thrust < 0.0])
        driven = (thrust < 0.0) & (power < 0.0)
        taken += list(np.abs(made.power / np.where(driven, power, 1.0) - 1.0)[driven])
    told(f"{number} blades, efficiency at the blade angle, nodes of 0.6 and more", efficiency)
    told(f"{number} blades, windmilling C_P", taken)
    print(f"{'':10} windmilling C_T, {len(windmill)} nodes: at most {max(windmill):.4f}")


def told(title: str, error: list[float] | Floats) -> None:
    """Print how errors are spread."""
    size = np.abs(error)
    spread = ", ".join(f"{share} % {100.0 * np.percentile(size, share):.1f}" for share in (50, 75, 90, 95, 99))
    print(f"{title}: {len(size)} points, {spread}; within 8 %: {100.0 * np.mean(size < 0.08):.0f} % of them")


def read_from_elements(charts: Charts) -> Charts:
    """Charts whose nodes are the elements' own."""
    power, thrust = [], []
    for number in NODES:
        shape = generic_blade(Blades(number, 150.0, 0.5))
        made = [
            loads(shape, ratio, np.radians(angles))
            for ratio, angles in zip(charts.advance_ratio, charts.blade_angle, strict=True)
        ]
        power.append(tuple(point.power for point in made))
        thrust.append(tuple(point.thrust for point in made))
    return charts._replace(power=tuple(power), thrust=tuple(thrust))


def main() -> None:
    """Print all of it."""
    charts, draw = hamilton_standard_charts(), np.random.default_rng(3)
    for number in NODES:
        nodes(charts, number)
    found = between(charts, draw, held_out=True)
    told("C_T at the charts' power, held out", found[:, 2])
    for low, high in ((0.0, 0.01), (0.01, 0.02), (0.02, 0.03), (0.03, 0.05), (0.05, 0.5)):
        part = (found[:, 1] >= low) & (found[:, 1] < high)
        told(f"  C_P per blade of AF 150 from {low:g} to {high:g}", found[part, 2])
    told("the charts' own reading between nodes", between(read_from_elements(charts), draw, held_out=False)[:, 2])


if __name__ == "__main__":
    main()
