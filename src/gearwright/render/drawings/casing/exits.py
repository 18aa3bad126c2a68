"""Machines towards which a housing has no opening: what their shafts would go through is metal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.drawings.casing.plane_section import pieces_of
from gearwright.shape import Scene
from gearwright.shape.solids import depth_in
from gearwright.sizing import Sizing
from gearwright.sizing.places import runs

STEP = 2e-3
"""Between points at which metal is looked for [m]: less than the thinnest wall."""


def closed_towards(sizing: Sizing, scene: Scene) -> tuple[str, ...]:
    """Return the machines whose shafts would have to go through walls of the housing.

    Args:
        sizing: What was sized.
        scene: Its solids with those of the housing.
    """
    return tuple(machine for machine, ray in _rays(sizing, scene) if _is_met(scene, ray))


def _rays(sizing: Sizing, scene: Scene) -> Iterator[tuple[str, Floats]]:
    """Yield every machine with points along the axis of its shaft from the shaft's end out of the housing."""
    pieces = pieces_of(scene)
    if not pieces:
        return
    far = max(float(np.max(np.abs(solid.outer))) + max(map(abs, solid.span)) + abs(float(node.axes.origin[0]))
              for node, solid in pieces)  # fmt: skip
    drawn = runs(sizing)[0]
    for machine, shaft in sizing.train.machines.items():
        steps = [step for run in drawn if run.shaft == shaft for step in run.steps]
        if not steps:
            continue
        frame, place = sizing.arrangement.frames[shaft], sizing.arrangement.plans[shaft].places[machine]
        low, high = min(step[0] for step in steps), max(step[1] for step in steps)
        end, sense = (low, -1.0) if place - low < high - place else (high, 1.0)
        along = np.array(frame.along)
        yield machine, np.array(frame.origin) + (end + sense * np.arange(0.0, 2.0 * far, STEP))[:, None] * along


def _is_met(scene: Scene, points: Floats) -> bool:
    return any(
        depth_in((points - node.axes.origin) @ node.axes.turned, solid) > 0.0 for node, solid in pieces_of(scene)
    )


def exit_notes(closed: Sequence[str]) -> Iterator[str]:
    """Yield what is said of machines towards which there is no opening.

    Args:
        closed: From `closed_towards`.
    """
    if closed:
        yield f"No opening is cut towards {', '.join(closed)}: shafts of the first sizing end within the housing."
