"""Functions in a small part of Python as machine code: loops around generated code, which numba would take seconds for.

What is translated runs as plain Python too. What is computed with it is decided by those who write the functions.
"""

from gearwright.dynamics.codegen.loops.expressions import at, call, floats
from gearwright.dynamics.codegen.loops.library import Held, Library, Room, library, packed

__all__ = ["Held", "Library", "Room", "at", "call", "floats", "library", "packed"]
