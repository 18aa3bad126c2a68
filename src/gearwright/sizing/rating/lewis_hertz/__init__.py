"""The first sizing: bending by Lewis and contact by Hertz, after Pulvirenti 2023, chapter 2."""

from gearwright.sizing.rating.lewis_hertz.method import LewisHertz
from gearwright.sizing.rating.lewis_hertz.record import LewisHertzRating
from gearwright.sizing.rating.lewis_hertz.strength import form_factor, width_ratio

__all__ = ["LewisHertz", "LewisHertzRating", "form_factor", "width_ratio"]
