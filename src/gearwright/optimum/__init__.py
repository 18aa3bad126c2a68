"""The best designs along the freedoms of a study: ask and tell, a search in layers, and what is known of its answer.

How designs are evaluated, and the journal that keeps them, is in `study`.
"""

from gearwright.optimum.generations import DESIGN, is_continuous
from gearwright.optimum.optimise import Search, optimise, restarted, search
from gearwright.optimum.optimum import Best, Binding, Counts, Fit, Gap, Influence, Optimum, Price, Regret, hypervolume

__all__ = [
    "DESIGN",
    "Best",
    "Binding",
    "Counts",
    "Fit",
    "Gap",
    "Influence",
    "Optimum",
    "Price",
    "Regret",
    "Search",
    "hypervolume",
    "is_continuous",
    "optimise",
    "restarted",
    "search",
]
