"""STEP files (ISO 10303, AP214) of a scene's solids by Open CASCADE, of the extra ``cad``; tessellations are `shape`'s.

Only `write.py` may be imported where Open CASCADE is not installed: it loads the rest when a file is asked for.
"""

from gearwright.exchange.step.write import StepFile, to_step

__all__ = ["StepFile", "to_step"]
