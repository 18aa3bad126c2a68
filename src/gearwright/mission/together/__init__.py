"""All intervals of a flight at once, or those of many flights, as arrays.

What one interval asks and gets is in `mission`; here it is asked for all of them, with the same formulas.
"""

from gearwright.mission.together.flight import Reached, flights_together, log_at_once

__all__ = ["Reached", "flights_together", "log_at_once"]
