"""Diagrams of the design file: sketches whose dimensions say the keys of its lengths and angles.

Each says what its keys measure; drawings of sized parts are in `render/drawings`, whose strokes these are made of.
"""

from gearwright.render.diagrams.catalogue import DIAGRAMS
from gearwright.render.diagrams.diagram import Diagram

__all__ = ["DIAGRAMS", "Diagram"]
