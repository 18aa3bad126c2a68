"""By how much every body of a scene turns in a motion of its train: shapes of modes and simulated runs on solids."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.model import System
from gearwright.identity import Kind
from gearwright.ranking import smallest
from gearwright.shape import Node, Scene
from gearwright.sizing import Sizing
from gearwright.verbs import verb


@verb
@one_blas_thread()
def turns_of(sizing: Sizing, scene: Scene, system: System, position: Floats) -> Mapping[str, Floats]:
    """Return node → its turn about its own axis, against the carrier that it is on [rad]; what stands is left out.

    A shaft, which has no coordinate of its own, turns as the mean of what sits on it. Bodies are turned alone, not
    moved aside.

    Args:
        sizing: What was sized.
        scene: Of it.
        system: Assembled from it.
        position: q, measured from the rigid motion [rad], shape (..., coordinates).
    """
    places = {name: k for k, name in enumerate(system.labels.coordinates) if system.labels.coordinate_units[k] == "rad"}
    sitting = {name: [places[one] for one in names if one in places] for name, names in _sitting(sizing).items()}
    found: dict[str, Floats] = {}
    for node in scene.nodes:
        own = [places[node.name]] if node.name in places else sitting.get(node.name, [])
        if own:
            base = [places[node.on]] if node.on in places else []
            turn = np.mean(position[..., own], axis=-1)
            turn = turn - np.mean(position[..., base], axis=-1) if base else turn
            found[node.name] = _sense(node, system, own, base) * turn
    return found | dict(_joined(scene, found))


def _joined(scene: Scene, found: Mapping[str, Floats]) -> Iterator[tuple[str, Floats]]:
    """Yield what has no coordinate, such as ties and second toothings: it turns with what it is joined to."""
    for node in scene.nodes:
        if node.name not in found and any(node.spins.values()):
            alike = [one for one in scene.nodes if one.name in found and (one.on, one.spins) == (node.on, node.spins)]
            alike.sort(key=lambda one: one.part.number != node.part.number)
            if alike:
                yield node.name, found[alike[0].name]


def _sitting(sizing: Sizing) -> dict[str, list[str]]:
    """Return node of a shaft → coordinates of what sits on it."""
    found: dict[str, list[str]] = {f"shaft {shaft.name}": [] for shaft in sizing.shafts}
    for shaft, name in _seats(sizing):
        found.get(f"shaft {shaft}", []).append(name)
    return found


def _seats(sizing: Sizing) -> Iterator[tuple[str, str]]:
    for gear in sizing.gears:
        for shaft in gear.shafts:
            yield shaft, str(gear.part) if len(gear.shafts) == 1 else str(gear.part._replace(branch=shaft))
    for carrier in sizing.carriers:
        yield carrier.shaft, str(carrier.part)
    for machine in sizing.machines:
        yield machine.shaft, machine.name


def _sense(node: Node, system: System, own: list[int], base: list[int]) -> float:
    """Return 1, or −1 where a body's own axis points against the direction in which speeds of the train count."""
    if node.part.kind is Kind.SHAFT and not any(node.spins.values()):
        return 1.0
    speed = system.arrays.speed
    relative = float(speed[own[0]] - (speed[base[0]] if base else 0.0))
    spins = [spin for spin in node.spins.values() if spin * relative]
    if not spins:
        return 1.0
    nearest = smallest(spins, lambda spin: abs(abs(spin) - abs(relative)))
    return float(np.sign(nearest * relative))
