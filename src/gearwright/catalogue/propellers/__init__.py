"""Propellers: the Hamilton Standard charts, maps that are shipped, read or made, blades from files, loads, rotors.

The methods themselves are machines' and are not here; flights read maps and do not make them.
"""

from gearwright.catalogue.propellers.blade_files import read_blades
from gearwright.catalogue.propellers.charts import charted_point, hamilton_standard_charts
from gearwright.catalogue.propellers.in_flight import FlightPoint, PropellerLoads, propeller_loads
from gearwright.catalogue.propellers.made import ANGLES, RATIOS, MadePropeller, RatioRow, carried_on, propeller
from gearwright.catalogue.propellers.maps import map_of, map_text, read_propeller_map
from gearwright.catalogue.propellers.rotor_flight import Helicopter, RotorRow, RotorTrim, TailRotor, rotor
from gearwright.catalogue.propellers.shipped import ALL_STATES, MAPS, compressed, propeller_map

__all__ = [
    "ALL_STATES",
    "ANGLES",
    "MAPS",
    "RATIOS",
    "FlightPoint",
    "Helicopter",
    "MadePropeller",
    "PropellerLoads",
    "RatioRow",
    "RotorRow",
    "RotorTrim",
    "TailRotor",
    "carried_on",
    "charted_point",
    "compressed",
    "hamilton_standard_charts",
    "map_of",
    "map_text",
    "propeller",
    "propeller_loads",
    "propeller_map",
    "read_blades",
    "read_propeller_map",
    "rotor",
]
