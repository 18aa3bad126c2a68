"""Rolling bearings of shafts and planets: what each bears over its service, and which size is taken.

The catalogue is `catalogue`'s.
"""

from gearwright.sizing.bearings.bearing_seats import bearing_seats
from gearwright.sizing.bearings.choice import Seating, bearing_sizings, seating
from gearwright.sizing.bearings.planet_bodies import as_made, planet_bodies
from gearwright.sizing.bearings.planet_lives import planet_lives
from gearwright.sizing.bearings.planet_room import named_room, planet_room
from gearwright.sizing.bearings.seat import Seat, seat_forces

__all__ = [
    "Seat",
    "Seating",
    "as_made",
    "bearing_seats",
    "bearing_sizings",
    "named_room",
    "planet_bodies",
    "planet_lives",
    "planet_room",
    "seat_forces",
    "seating",
]
