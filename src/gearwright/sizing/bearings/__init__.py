"""Rolling bearings of shafts: what each bears over its service, and which size is taken.

The catalogue is `catalogue`'s.
"""

from gearwright.sizing.bearings.bearing_seats import Seat, bearing_seats, seat_forces
from gearwright.sizing.bearings.choice import Seating, bearing_sizings, seating

__all__ = ["Seat", "Seating", "bearing_seats", "bearing_sizings", "seat_forces", "seating"]
