"""Names and units of gearwright as OpenMDAO has them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType

from gearwright.units import si_unit, suffix_unit
from gearwright.verbs import verb

_OTHER: Mapping[str, str] = MappingProxyType({
    "°": "deg", "°C": "degC", "K": "degK", "in": "inch", "kt": "knot", "l": "L", "nmi": "NM", "1": "", "√Pa": "",
    "nm_s_rad": "N*m*s/rad", "per_in": "1/inch",
})  # fmt: skip
"""Unit -> what OpenMDAO calls it, where that is more than other signs; empty of what has none there."""


@verb
def variable(name: str) -> str:
    """Return the name of a variable of OpenMDAO for a dotted path or result.

    Args:
        name: Such as ``motors.electric.speed_rpm``.

    >>> variable("gears.first stage.sun-gear.mass")
    'gears:first_stage:sun_gear:mass'
    """
    return re.sub(r"[^\w:]", "_", name.split(",")[0].strip().replace(".", ":"))


def unit_written(suffix: str) -> str | None:
    """Return the unit of a key as OpenMDAO writes it; None of what has none.

    Args:
        suffix: Of the key, such as ``lbf_ft``; empty for what has no unit.

    >>> unit_written("lbf_ft"), unit_written("mm2"), unit_written("in")
    ('lbf*ft', 'mm**2', 'inch')
    """
    return _in_its_signs(suffix_unit(suffix)) if suffix else None


def unit_of_result(dimension: str) -> str | None:
    """Return the SI unit of a result as OpenMDAO writes it; None of a ratio, a count, and what it has no words for.

    Args:
        dimension: Such as ``"torque"``.

    >>> unit_of_result("torque"), unit_of_result("ratio")
    ('N*m', None)
    """
    return _in_its_signs(si_unit(dimension))


def _in_its_signs(unit: str) -> str | None:
    plain = unit.replace("²", "**2").replace("³", "**3").replace("µ", "u").replace(" ", "*")
    return _OTHER.get(unit, plain) or None
