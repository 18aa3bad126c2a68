"""The hands of helices: what the axial forces of a sizing belong to, and what a drawing says."""

from __future__ import annotations

from collections.abc import Mapping

from gearwright.spec import Design
from gearwright.train import PowerFlow, Train


def helix_hand(design: Design, train: Train, flows: Mapping[str, PowerFlow], shaft: str) -> float:
    """Return +1 for right-hand helices, −1 for left-hand ones.

    All helices on a shaft have one hand, so that the axial forces of a driven and a driving gear on it oppose each
    other. Mating gears turn opposite ways and have opposite hands, or the same with an internal gear; the sense of
    rotation therefore gives a choice of hands that always fits, and so does its mirror image.

    Args:
        design: As read.
        train: Its graph.
        flows: Load case -> power flow.
        shaft: That carries the gear.
    """
    reference = next(iter(flows.values()))
    turning = -1.0 if reference.speeds[shaft] < 0.0 else 1.0
    return -turning if _mirrored(design, train, reference) else turning


def _mirrored(design: Design, train: Train, rated: PowerFlow) -> bool:
    """Tell whether all helices change hands, so that one on the shaft of a bevel pinion opposes the bevel's force."""
    for name, pair in design.pairs.items():
        if pair.kind != "bevel" or not isinstance(pair.pinion, str):
            continue
        away_from_first = pair.pinion_apex == "first"
        for mesh in train.meshes:
            other = design.pairs.get(mesh.stage)
            if other is None or mesh.stage == name or other.kind != "cylindrical" or pair.pinion not in mesh.nodes[:2]:
                continue
            # Unmirrored, a driven gear pushes its shaft towards the first end, a driving one towards the second.
            torque = rated.meshes[mesh.name].torques[mesh.nodes.index(pair.pinion)]
            return (torque * rated.speeds[pair.pinion] < 0.0) == away_from_first
    return False
