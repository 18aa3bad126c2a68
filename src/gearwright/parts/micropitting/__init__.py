"""Micropitting of external cylindrical pairs by ISO/TS 6336-22, method B: the film between rough flanks.

The oil by temperature is in `lubricant`, the film along the path of contact in `film`, the oil's test in `oil_test`.
"""

from gearwright.parts.micropitting.film import (
    POINTS,
    Film,
    FilmMesh,
    film_thickness,
    mean_friction,
    relief_factor,
)
from gearwright.parts.micropitting.lubricant import BASES, OilBase, OilGrade
from gearwright.parts.micropitting.micropitting import Micropitting, micropitting
from gearwright.parts.micropitting.oil_test import STAGES, film_of_test, permissible_film

__all__ = [
    "BASES",
    "POINTS",
    "STAGES",
    "Film",
    "FilmMesh",
    "Micropitting",
    "OilBase",
    "OilGrade",
    "film_of_test",
    "film_thickness",
    "mean_friction",
    "micropitting",
    "permissible_film",
    "relief_factor",
]
