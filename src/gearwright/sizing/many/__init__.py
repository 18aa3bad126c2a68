"""Many designs sized at once, into columns with a reason for every row that cannot be sized.

Each row is what `size` gives of it alone.
"""

from gearwright.sizing.many.sizings import Sizings, Structure, in_lanes, size_many, structure_of

__all__ = [
    "Sizings",
    "Structure",
    "in_lanes",
    "size_many",
    "structure_of",
]
