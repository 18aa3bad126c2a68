"""Straight and spiral bevel gears by ANSI/AGMA 2003, with the geometry factors of its annex C."""

from gearwright.sizing.rating.agma2003.method import Agma2003
from gearwright.sizing.rating.agma2003.record import Agma2003Rating

__all__ = ["Agma2003", "Agma2003Rating"]
