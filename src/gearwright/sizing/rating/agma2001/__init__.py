"""External spur and helical gears by ANSI/AGMA 2001-D04, with the geometry factors of AGMA 908-B89."""

from gearwright.sizing.rating.agma2001.method import Agma2001
from gearwright.sizing.rating.agma2001.record import Agma2001Rating

__all__ = ["Agma2001", "Agma2001Rating"]
