"""What planets turn on: bearings of a catalogue, rollers made into them, or films of oil, chosen for room and load.

Lives of rolling bearings are `bearings`'s; pins are `shafts`'s.
"""

from gearwright.sizing.planets.film_checks import film_checks
from gearwright.sizing.planets.films import STANDING, film_oil
from gearwright.sizing.planets.fit import fit_planets

__all__ = ["STANDING", "film_checks", "film_oil", "fit_planets"]
