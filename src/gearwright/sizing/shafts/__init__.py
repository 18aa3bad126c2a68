"""Shafts of one diameter and built ones: stretches, sections, joints, bending, room, checks.

Carriers are beside them in `sizing`.
"""

from gearwright.sizing.shafts.checks import checks_of
from gearwright.sizing.shafts.sections import Section, Strength, strengths
from gearwright.sizing.shafts.shafts import shaft_material, size_shafts

__all__ = ["Section", "Strength", "checks_of", "shaft_material", "size_shafts", "strengths"]
