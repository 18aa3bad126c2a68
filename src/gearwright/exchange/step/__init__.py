"""STEP files (ISO 10303, AP214) of a scene's solids by Open CASCADE, of the extra ``cad``.

Tessellations are `shape`'s.
"""

from gearwright.exchange.step.write import StepFile, to_step

__all__ = ["StepFile", "to_step"]
