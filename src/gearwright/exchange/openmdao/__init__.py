"""A design as a component of OpenMDAO: dotted paths in, results by name out, each with its unit, and its partials.

What is computed are the results of a study's case; drivers, mission models and their optimum are OpenMDAO's.
"""

from gearwright.exchange.openmdao.making import component
from gearwright.exchange.openmdao.names import variable

__all__ = ["component", "variable"]
