"""Closed-form machine elements: SI in, SI out, one idea a module, every formula with its source."""

from gearwright.parts.material import LifeLine, Material, contact_strength

__all__ = ["LifeLine", "Material", "contact_strength"]
