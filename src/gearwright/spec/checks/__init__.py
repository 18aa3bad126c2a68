"""What the types of a design cannot see: names that must exist, teeth that must fit, shafts that must be held.

Bounds of single fields stand with the fields.
"""

from gearwright.spec.checks.design import reference_problems, table_of
from gearwright.spec.checks.epicyclics import relief_problem
from gearwright.spec.checks.gears import STEEL_KEYS
from gearwright.spec.checks.mounting import APART, KINDS, MOST_HOLLOW, bearing_problems

__all__ = [
    "APART",
    "KINDS",
    "MOST_HOLLOW",
    "STEEL_KEYS",
    "bearing_problems",
    "reference_problems",
    "relief_problem",
    "table_of",
]
