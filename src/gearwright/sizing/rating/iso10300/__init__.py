"""Bevel gears by ISO 10300, method B1."""

from gearwright.sizing.rating.iso10300.method import Iso10300
from gearwright.sizing.rating.iso10300.record import Iso10300Rating

__all__ = ["Iso10300", "Iso10300Rating"]
