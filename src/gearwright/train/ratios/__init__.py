"""The ratios asked of stages whose teeth are free, and what speeds and tooth ratios they can reach."""

from gearwright.train.ratios.ranges import speed_range, tooth_ratio_range
from gearwright.train.ratios.targets import Targets, targets

__all__ = [
    "Targets",
    "speed_range",
    "targets",
    "tooth_ratio_range",
]
