"""What a mission says of its power plant beyond ratings: strategies, cells, windings, spools, heat.

Records alone; `spec/flying` checks what does not fit together, `mission` flies them.
"""

from gearwright.spec.power.oil import OilNetworkRules
from gearwright.spec.power.spool import SpoolRules
from gearwright.spec.power.strategies import KEYS_OF, NEEDED, StrategyRules
from gearwright.spec.power.warmth import CellRules, WindingRules

__all__ = ["KEYS_OF", "NEEDED", "CellRules", "OilNetworkRules", "SpoolRules", "StrategyRules", "WindingRules"]
