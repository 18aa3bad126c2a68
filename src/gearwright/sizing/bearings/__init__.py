"""Rolling bearings of shafts and planets: what each bears over its service, and which size is taken.

The catalogue is `catalogue`'s.
"""

from gearwright.sizing.bearings.bearing_seats import ENDS, bearing_seats
from gearwright.sizing.bearings.borne import PlanetLoad, borne_by, planet_duty
from gearwright.sizing.bearings.choice import Checked, Seating, bearing_sizings, seating
from gearwright.sizing.bearings.fitted import Fitted, fitted_in
from gearwright.sizing.bearings.planet_bodies import PlanetBody, as_made, planet_bodies
from gearwright.sizing.bearings.planet_lives import planet_lives
from gearwright.sizing.bearings.planet_room import named_room, planet_room
from gearwright.sizing.bearings.planet_seats import Carrying, planet_seats, room_in
from gearwright.sizing.bearings.run_checks import highest_speed_factor, life_check, limit_checks, speed_factor_check
from gearwright.sizing.bearings.running import oil_of, oiled_life, running_of
from gearwright.sizing.bearings.seat import Seat, seat_forces, seat_forces_along
from gearwright.sizing.bearings.unit_loads import unit_loads

__all__ = [
    "ENDS",
    "Carrying",
    "Checked",
    "Fitted",
    "PlanetBody",
    "PlanetLoad",
    "Seat",
    "Seating",
    "as_made",
    "bearing_seats",
    "bearing_sizings",
    "borne_by",
    "fitted_in",
    "highest_speed_factor",
    "life_check",
    "limit_checks",
    "named_room",
    "oil_of",
    "oiled_life",
    "planet_bodies",
    "planet_duty",
    "planet_lives",
    "planet_room",
    "planet_seats",
    "room_in",
    "running_of",
    "seat_forces",
    "seat_forces_along",
    "seating",
    "speed_factor_check",
    "unit_loads",
]
