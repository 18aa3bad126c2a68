"""Elastic bodies that were reduced elsewhere: their matrices, their files, and what is wrong with them.

How a body joins a system is in `gearwright.dynamics.model`.
"""

from gearwright.spec.bodies.body_files import read_body
from gearwright.spec.bodies.reduced_body import ReducedBody

__all__ = ["ReducedBody", "read_body"]
