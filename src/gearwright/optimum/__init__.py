"""The best designs along the freedoms of a study: ask and tell, a search in layers, and what is known of its answer.

How designs are evaluated, and the journal that keeps them, is in `study`.
"""

from gearwright.optimum.asking import Search, search
from gearwright.optimum.freedoms import DESIGN, is_continuous

__all__ = ["DESIGN", "Search", "is_continuous", "search"]
