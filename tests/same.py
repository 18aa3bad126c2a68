"""Equality of values, kind for kind and bit for bit."""

import math
from dataclasses import fields, is_dataclass
from types import MappingProxyType

import numpy as np
from pydantic import BaseModel


def same(one, two):
    """Tell whether two values are equal, kind for kind and bit for bit; NaN equals NaN."""
    if type(one) is not type(two):
        return False
    if isinstance(one, BaseModel):
        return one == two and one.model_fields_set == two.model_fields_set
    if is_dataclass(one):
        return all(same(getattr(one, field.name), getattr(two, field.name)) for field in fields(one))
    if isinstance(one, np.ndarray | np.generic):
        alike = one.dtype == two.dtype and one.shape == two.shape
        return alike and np.array_equal(one, two, equal_nan=one.dtype.kind in "fc") and _signs(one, two)
    if isinstance(one, dict | MappingProxyType):
        return list(one) == list(two) and all(same(one[key], two[key]) for key in one)
    if isinstance(one, tuple | list):
        return len(one) == len(two) and all(same(*pair) for pair in zip(one, two, strict=True))
    if isinstance(one, complex):
        return same(one.real, two.real) and same(one.imag, two.imag)
    if isinstance(one, float):
        return (math.isnan(one) and math.isnan(two)) or (one == two and math.copysign(1, one) == math.copysign(1, two))
    return one == two


def _signs(one, two):
    kinds = [np.real, np.imag] if one.dtype.kind == "c" else [np.asarray]
    if one.dtype.kind not in "fc":
        return True
    return all(np.array_equal(np.signbit(kind(one)), np.signbit(kind(two))) or np.isnan(one).any() for kind in kinds)
