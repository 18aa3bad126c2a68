"""Functions in a small part of Python as machine code: loops around generated code, which numba would take seconds for.

What is translated runs as plain Python too. What is computed with it is decided by those who write the functions.
"""

from gearwright.dynamics.codegen.loops.library import Held, Library, Room, library, packed
from gearwright.dynamics.codegen.loops.words import at, call, floats

__all__ = ["Held", "Library", "Room", "at", "call", "floats", "library", "packed"]
