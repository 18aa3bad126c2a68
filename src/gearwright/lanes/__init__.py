"""One computation for many designs at once: numbers in lanes, and twins of modules that compute with them.

Here stands how; which modules have twins, and what is asked of them, is for `sizing.many`.
"""

from gearwright.lanes.builtin import chosen
from gearwright.lanes.lanes import Diverged, Lanes, Unsupported, each, lanes_of
from gearwright.lanes.twins import change_twins, twin

__all__ = ["Diverged", "Lanes", "Unsupported", "change_twins", "chosen", "each", "lanes_of", "twin"]
