"""Stages with their teeth chosen: modules, widths, gears, meshes, and the checks of the gears.

Where they stand is for `arrangement`.
"""

from gearwright.sizing.stages.geared import Geared, geared

__all__ = ["Geared", "geared"]
