"""Cylindrical gears by ISO 6336, method B, with scuffing by ISO/TS 6336-21."""

from gearwright.sizing.rating.iso6336.inputs import quality_of, steel_of, steels_of
from gearwright.sizing.rating.iso6336.method import Iso6336
from gearwright.sizing.rating.iso6336.record import Iso6336Rating
from gearwright.sizing.rating.iso6336.scuffing import scuffing_safeties

__all__ = ["Iso6336", "Iso6336Rating", "quality_of", "scuffing_safeties", "steel_of", "steels_of"]
