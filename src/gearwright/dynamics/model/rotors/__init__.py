"""Shafts as beams on bearings, what they carry, gears that couple them, and bodies of reduced matrices around them.

It adds coordinates and lines to a model; lumped shafts between two gears are in `beam`.
"""

from gearwright.dynamics.model.rotors.elastic_body import Placed, add_body
from gearwright.dynamics.model.rotors.joints import Bearing, GearContact, add_bearing, add_gear_contact
from gearwright.dynamics.model.rotors.rotor import Disc, Rotor, add_rotor
from gearwright.dynamics.model.rotors.shaft_element import element

__all__ = [
    "Bearing",
    "Disc",
    "GearContact",
    "Placed",
    "Rotor",
    "add_bearing",
    "add_body",
    "add_gear_contact",
    "add_rotor",
    "element",
]
