"""Rolling bearings of shafts: what each bears over its service, and which size is taken.

The catalogue is `catalogue`'s.
"""

from gearwright.sizing.bearings.bearing_seats import Seat, bearing_seats, seat_forces
from gearwright.sizing.bearings.choice import Seating, bearing_sizings, seating
from gearwright.sizing.bearings.planet_room import named_room, planet_room

__all__ = [
    "Seat",
    "Seating",
    "bearing_seats",
    "bearing_sizings",
    "named_room",
    "planet_room",
    "seat_forces",
    "seating",
]
