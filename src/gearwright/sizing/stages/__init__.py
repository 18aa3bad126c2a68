"""Stages with their teeth chosen: modules, widths, gears, meshes, and the checks of the gears.

Where they stand is for `arrangement`.
"""

from gearwright.sizing.stages.compound_sizes import compound_sizes
from gearwright.sizing.stages.gear_checks import gear_checks
from gearwright.sizing.stages.gears import size_gears, size_meshes
from gearwright.sizing.stages.pass_checks import pass_checks
from gearwright.sizing.stages.stage_sizes import stage_sizes

__all__ = [
    "compound_sizes",
    "gear_checks",
    "pass_checks",
    "size_gears",
    "size_meshes",
    "stage_sizes",
]
