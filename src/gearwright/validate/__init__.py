"""Validation: published numbers, each with its source, and what gearwright finds for them."""

from gearwright.base import callable_layer
from gearwright.validate.case import Case, Checked, check
from gearwright.validate.cases import published, validate

__all__ = ["Case", "Checked", "check", "published", "validate"]

callable_layer(__name__, validate)
