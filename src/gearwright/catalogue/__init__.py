"""Data that comes with gearwright: materials, engines, gearbox weights; each with its provenance."""

from gearwright.catalogue.bearing_choice import (
    BearingCheck,
    BearingDuty,
    BearingSpectrum,
    check_bearing,
    equivalent_loads,
    fitting_bearings,
    least_ratings,
)
from gearwright.catalogue.bearing_oil import BearingOil, ModifiedLife, bearing_friction, modified_life
from gearwright.catalogue.bearings import STEEL_DENSITY, STEEL_SHARE, Bearing, bearing, bearings, with_ratings
from gearwright.catalogue.engines import Engine, Printed, Series, all_series, engines, nearest, notes, select
from gearwright.catalogue.fits import LARGEST, SEAT_SOURCE, SMALLEST, seat_tolerance, shaft_limits, standard_tolerance
from gearwright.catalogue.gear_fits import CENTRE_FITS, THICKNESS_FITS, centre_allowance, thickness_allowances
from gearwright.catalogue.gear_strength import (
    USUAL_HARDNESS,
    gear_steel,
    gear_steel_names,
    is_cast_iron,
    rated_steel,
)
from gearwright.catalogue.gearbox_weights import gearbox_classes, weighed_gearboxes
from gearwright.catalogue.housing_materials import HousingMaterial, housing_materials
from gearwright.catalogue.keys import LENGTHS, StandardKey, key_for_shaft, standard_keys
from gearwright.catalogue.load_factors import load_factor_tables, load_factors
from gearwright.catalogue.materials import material_of, materials
from gearwright.catalogue.propellers import (
    ALL_STATES,
    MAPS,
    carried_on,
    charted_point,
    compressed,
    hamilton_standard_charts,
    map_of,
    map_text,
    propeller_map,
    read_propeller_map,
)
from gearwright.catalogue.published_gearboxes import PublishedGearbox, published_gearboxes
from gearwright.catalogue.retaining_rings import RetainingRing, retaining_ring, retaining_rings

__all__ = [
    "ALL_STATES",
    "CENTRE_FITS",
    "LARGEST",
    "LENGTHS",
    "MAPS",
    "SEAT_SOURCE",
    "SMALLEST",
    "STEEL_DENSITY",
    "STEEL_SHARE",
    "THICKNESS_FITS",
    "USUAL_HARDNESS",
    "Bearing",
    "BearingCheck",
    "BearingDuty",
    "BearingOil",
    "BearingSpectrum",
    "Engine",
    "HousingMaterial",
    "ModifiedLife",
    "Printed",
    "PublishedGearbox",
    "RetainingRing",
    "Series",
    "StandardKey",
    "all_series",
    "bearing",
    "bearing_friction",
    "bearings",
    "carried_on",
    "centre_allowance",
    "charted_point",
    "check_bearing",
    "compressed",
    "engines",
    "equivalent_loads",
    "fitting_bearings",
    "gear_steel",
    "gear_steel_names",
    "gearbox_classes",
    "hamilton_standard_charts",
    "housing_materials",
    "is_cast_iron",
    "key_for_shaft",
    "least_ratings",
    "load_factor_tables",
    "load_factors",
    "map_of",
    "map_text",
    "material_of",
    "materials",
    "modified_life",
    "nearest",
    "notes",
    "propeller_map",
    "published_gearboxes",
    "rated_steel",
    "read_propeller_map",
    "retaining_ring",
    "retaining_rings",
    "seat_tolerance",
    "select",
    "shaft_limits",
    "standard_keys",
    "standard_tolerance",
    "thickness_allowances",
    "weighed_gearboxes",
    "with_ratings",
]
