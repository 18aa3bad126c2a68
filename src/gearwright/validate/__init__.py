"""Validation: published numbers, each with its source, and what gearwright finds for them."""

from gearwright.validate.case import Case, Checked, check
from gearwright.validate.cases import published, validate
from gearwright.verbs import callable_layer

__all__ = ["Case", "Checked", "check", "published", "validate"]

callable_layer(__name__, validate)
