"""Validation: published numbers, each with its source, and what gearwright finds for them."""

from gearwright.validate.case import Case, Checked, check
from gearwright.validate.cases import published

__all__ = ["Case", "Checked", "check", "published"]
