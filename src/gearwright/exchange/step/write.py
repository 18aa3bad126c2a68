"""The verb: a sized gearbox as a STEP file, an assembly of named and coloured solids."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.util import find_spec

from gearwright.errors import Problem, install, refuse
from gearwright.shape import scene
from gearwright.showing import Shown
from gearwright.sizing import Sizing
from gearwright.verbs import verb


@dataclass(frozen=True, repr=False)
class StepFile(Shown):
    """A STEP file."""

    content: bytes
    """As ISO 10303-21 has it, schema AP214, lengths in millimetres."""
    solids: int
    """Different ones [-]."""
    bodies: int
    """Places at which they stand [-]."""


@verb
def to_step(sizing: Sizing) -> StepFile:
    """Return gears, shafts, carriers and envelopes of bearings as an assembly in STEP AP214, named and coloured.

    Args:
        sizing: As sized.

    Raises:
        DesignError: If Open CASCADE, of the extra ``cad``, is not here.
    """
    if find_spec("OCP") is None:
        refuse([Problem("--to", f"step needs Open CASCADE, which is not here; {install('cad')}, or use glb")])
    from gearwright.exchange.step.assembly import assembly

    built = scene(sizing, detail="smooth")
    return StepFile(assembly(built), len(built.solids), sum(bool(node.surface) for node in built.nodes))
