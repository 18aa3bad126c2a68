"""Every body of a sized transmission at its place in space, and whether all have room.

Axes in the cross-section and places along shafts, which loads need before shafts are sized, are for `arrangement`.
"""

from gearwright.sizing.arrangement import PLATE_GAP
from gearwright.sizing.places.bells import Bell, bells, ring_torque
from gearwright.sizing.places.bodies import Parts, bodies_of, placed
from gearwright.sizing.places.coaxial import CLAUSE, axes_among, coaxial_checks, of_one_set
from gearwright.sizing.places.keep_out import keep_out_checks
from gearwright.sizing.places.orders import hollow_checks, order_checks
from gearwright.sizing.places.pins import pin_checks
from gearwright.sizing.places.plates import along_body, planets_span, plates_of
from gearwright.sizing.places.reaches import IN_LINE, Run, runs
from gearwright.sizing.places.room import BOSS, Meeting, Rules, beside_checks, meetings, room_checks, rules_of
from gearwright.sizing.places.settle import ROUNDS, Settled, settle
from gearwright.sizing.places.solids import Room, Solid, box_of, room_between, solid_of, solid_room

__all__ = [
    "BOSS",
    "CLAUSE",
    "IN_LINE",
    "PLATE_GAP",
    "ROUNDS",
    "Bell",
    "Meeting",
    "Parts",
    "Room",
    "Rules",
    "Run",
    "Settled",
    "Solid",
    "along_body",
    "axes_among",
    "bells",
    "beside_checks",
    "bodies_of",
    "box_of",
    "coaxial_checks",
    "hollow_checks",
    "keep_out_checks",
    "meetings",
    "of_one_set",
    "order_checks",
    "pin_checks",
    "placed",
    "planets_span",
    "plates_of",
    "ring_torque",
    "room_between",
    "room_checks",
    "rules_of",
    "runs",
    "settle",
    "solid_of",
    "solid_room",
]
