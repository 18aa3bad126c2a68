"""Changes of a settled design, each proportioned anew: what planets turn on, critical speeds, lighter ones.

The loop that settles a change is for `closure/loop.py`.
"""

from gearwright.closure.moves.bodies import BODIES, Thickness, thicknesses
from gearwright.closure.moves.lighten import lightened
from gearwright.closure.moves.planet_bearings import OF_PLANETS, borne
from gearwright.closure.moves.separate import separated

__all__ = ["BODIES", "OF_PLANETS", "Thickness", "borne", "lightened", "separated", "thicknesses"]
