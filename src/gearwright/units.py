"""Units: suffixes that users write (``power_kw``) to SI, and SI to what an engineer reads (mm, N, MPa, kW, rpm).

Everything inside gearwright is SI: m, kg, s, N, Pa, W, rad, K. A record's field says its dimension in its type
(``power: Power``), and that one mark serves the reader of files, the JSON Schema, the tables and the reports.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType, UnionType
from typing import Annotated, Any, NamedTuple, Union, get_args, get_origin, get_type_hints

RPM = 2.0 * math.pi / 60.0
"""One revolution per minute in rad/s."""
INCH = 0.0254
"""One inch in m (exact, international yard and pound agreement 1959)."""
POUND = 0.45359237
"""One pound in kg (exact, same agreement)."""
GRAVITY = 9.80665
"""Standard gravity in m/s² (exact, 3rd CGPM 1901)."""
FOOT = 12.0 * INCH
"""[m]"""
NAUTICAL_MILE = 1852.0
"""[m]"""
KNOT = NAUTICAL_MILE / 3600.0
"""[m/s]"""
CELSIUS = 273.15
"""0 °C [K]."""
KWH = 3.6e6
"""[J]"""
POUND_FORCE = POUND * GRAVITY
HORSEPOWER = 550.0 * FOOT * POUND_FORCE
"""One mechanical horsepower in W."""

NOISE = 1e-9
"""Magnitude, in the unit that is shown, below which a number is rounding."""
EXACT = 12
"""Digits of a number that no rounding touches [-]: a half is decided by these."""
SMALLEST_PLAIN = 1e-3
"""Magnitude below which a number is written with a power of ten."""
LARGEST_PLAIN = 1e12
"""Magnitude from which on it is so, too: a life without end, say."""

SUFFIXES: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "angle": {"deg": math.pi / 180.0, "rad": 1.0},
        "area": {"mm2": 1e-6, "m2": 1.0},
        "density": {"kg_m3": 1.0},
        "distance": {"m": 1.0, "km": 1e3, "nmi": NAUTICAL_MILE},
        "energy": {"j": 1.0, "kj": 1e3, "mj": 1e6, "kwh": KWH},
        "force": {"n": 1.0, "kn": 1e3, "lbf": POUND_FORCE},
        "frequency": {"hz": 1.0, "khz": 1e3},
        "inertia": {"kg_m2": 1.0},
        "length": {"mm": 1e-3, "m": 1.0, "um": 1e-6, "in": INCH, "ft": FOOT},
        "life": {"h": 3600.0},
        "mass": {"kg": 1.0, "g": 1e-3, "lb": POUND},
        "power": {"kw": 1e3, "w": 1.0, "mw": 1e6, "hp": HORSEPOWER},
        "slope": {"mrad": 1e-3, "rad": 1.0},
        "specific_mass": {"kg_kw": 1e-3, "kg_w": 1.0},
        "specific_power": {"kw_kg": 1e3, "w_kg": 1.0},
        "speed": {"rpm": RPM, "rad_s": 1.0},
        "stiffness": {"n_m": 1.0, "n_um": 1e6, "n_mm": 1e3},
        "stress": {"mpa": 1e6, "pa": 1.0, "gpa": 1e9, "psi": POUND_FORCE / INCH**2},
        "time": {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0},
        "torque": {"nm": 1.0, "knm": 1e3, "lbf_ft": POUND_FORCE * FOOT},
        "torsional_damping": {"nm_s_rad": 1.0},
        "torsional_stiffness": {"nm_rad": 1.0, "knm_rad": 1e3},
        "velocity": {"m_s": 1.0, "km_h": 1.0 / 3.6, "kt": KNOT, "ft_min": FOOT / 60.0},
        "volume": {"m3": 1.0, "l": 1e-3, "mm3": 1e-9},
    }
)
"""Dimension -> suffix of the key -> SI value of one such unit."""


class _Shown(NamedTuple):
    """How a dimension is shown, kept, and written in a key."""

    unit: str
    """In which an engineer reads it."""
    factor: float
    """SI value of one such unit."""
    si: str
    """Unit in which it is kept."""
    suffix: str
    """Of a key that holds it in the unit in which it is shown; empty for what has none."""


_SHOWN: Mapping[str, _Shown] = MappingProxyType({
    "angle": _Shown("°", math.pi / 180.0, "rad", "deg"),
    "area": _Shown("mm²", 1e-6, "m²", "mm2"),
    "density": _Shown("kg/m³", 1.0, "kg/m³", "kg_m3"),
    "distance": _Shown("NM", NAUTICAL_MILE, "m", "nmi"),
    "electric_energy": _Shown("kWh", KWH, "J", "kwh"),
    "energy": _Shown("kJ", 1e3, "J", "kj"),
    "force": _Shown("N", 1.0, "N", "n"),
    "frequency": _Shown("Hz", 1.0, "Hz", "hz"),
    "inertia": _Shown("kg m²", 1.0, "kg m²", "kg_m2"),
    "length": _Shown("mm", 1e-3, "m", "mm"),
    "film_thickness": _Shown("µm", 1e-6, "m", "um"),
    "life": _Shown("h", 3600.0, "s", "h"),
    "mass": _Shown("kg", 1.0, "kg", "kg"),
    "power": _Shown("kW", 1e3, "W", "kw"),
    "specific_mass": _Shown("kg/kW", 1e-3, "kg/W", "kg_kw"),
    "specific_power": _Shown("kW/kg", 1e3, "W/kg", "kw_kg"),
    "specific_torque": _Shown("N m/kg", 1.0, "N m/kg", "nm_kg"),
    "slope": _Shown("mrad", 1e-3, "rad", "mrad"),
    "speed": _Shown("rpm", RPM, "rad/s", "rpm"),
    "stiffness": _Shown("N/µm", 1e6, "N/m", "n_um"),
    "stress": _Shown("MPa", 1e6, "Pa", "mpa"),
    "time": _Shown("s", 1.0, "s", "s"),
    "torque": _Shown("N m", 1.0, "N m", "nm"),
    "torsional_damping": _Shown("N m s/rad", 1.0, "N m s/rad", "nm_s_rad"),
    "torsional_stiffness": _Shown("kN m/rad", 1e3, "N m/rad", "knm_rad"),
    "velocity": _Shown("m/s", 1.0, "m/s", "m_s"),
    "volume": _Shown("l", 1e-3, "m³", "l"),
    "number": _Shown("", 1.0, "1", ""),
    "ratio": _Shown("", 1.0, "1", ""),
    "percent": _Shown("%", 0.01, "1", "percent"),
    "altitude": _Shown("ft", FOOT, "m", "ft"),
    "flight_time": _Shown("min", 60.0, "s", "min"),
    "bearing_force": _Shown("kN", 1e3, "N", "kn"),
    "elasticity_factor": _Shown("√MPa", 1e3, "√Pa", "sqrt_mpa"),
    "mass_per_length": _Shown("g/mm", 1.0, "kg/m", "g_mm"),
    "temperature": _Shown("°C", 1.0, "°C", "degc"),
    "absolute_temperature": _Shown("K", 1.0, "K", "k"),
    "current": _Shown("A", 1.0, "A", "a"),
    "voltage": _Shown("V", 1.0, "V", "v"),
    "fuel_per_energy": _Shown("kg/kWh", 1.0 / KWH, "kg/J", "kg_kwh"),
    "air_flow": _Shown("kg/s", 1.0, "kg/s", "kg_s"),
    "height": _Shown("m", 1.0, "m", "m"),
    "mass_flow": _Shown("kg/h", 1.0 / 3600.0, "kg/s", "kg_h"),
    "oil_flow": _Shown("l/min", 1e-3 / 60.0, "m³/s", "l_min"),
    "acceleration": _Shown("m/s²", 1.0, "m/s²", "m_s2"),
    "ground_roll": _Shown("m", 1.0, "m", "m"),
})  # fmt: skip
"""Dimension -> how it is shown and kept."""


@dataclass(frozen=True)
class Quantity:
    """Marks a field as a physical quantity of one dimension, in SI."""

    dimension: str
    """A key of `SUFFIXES`, or a dimension that is only shown (``ratio``, ``specific_power``)."""


@dataclass(frozen=True)
class Reciprocal:
    """Marks a quantity of a file that may be written as its reciprocal, too, under a name that is usual for it."""

    key: str
    """As written, such as ``diametral_pitch``."""
    scale: float
    """What the quantity is where the key has 1, in SI: the quantity is this over the key."""
    suffix: str
    """Its unit, as a suffix would name it, such as ``per_in``."""


@dataclass(frozen=True)
class Origin:
    """Where a computed field comes from."""

    equation: str
    """The equation in the field's symbols."""
    source: str
    """Author, year, equation or clause."""


@dataclass(frozen=True)
class OriginOf:
    """Marks a field whose value another record made: its origin is that of the field of the same name there."""

    field: str
    """Field that holds that record."""


@dataclass(frozen=True)
class Endless:
    """Marks a computed field that is infinite where nothing loads the part, limits it, or bears; no other may be."""


Angle = Annotated[float, Quantity("angle")]
Distance = Annotated[float, Quantity("distance")]
Area = Annotated[float, Quantity("area")]
Density = Annotated[float, Quantity("density")]
Energy = Annotated[float, Quantity("energy")]
Force = Annotated[float, Quantity("force")]
Frequency = Annotated[float, Quantity("frequency")]
Inertia = Annotated[float, Quantity("inertia")]
Length = Annotated[float, Quantity("length")]
Life = Annotated[float, Quantity("life")]
Mass = Annotated[float, Quantity("mass")]
Number = Annotated[float, Quantity("number")]
Power = Annotated[float, Quantity("power")]
Ratio = Annotated[float, Quantity("ratio")]
Slope = Annotated[float, Quantity("slope")]
SpecificMass = Annotated[float, Quantity("specific_mass")]
SpecificPower = Annotated[float, Quantity("specific_power")]
Speed = Annotated[float, Quantity("speed")]
Stiffness = Annotated[float, Quantity("stiffness")]
Stress = Annotated[float, Quantity("stress")]
Time = Annotated[float, Quantity("time")]
Torque = Annotated[float, Quantity("torque")]
TorsionalDamping = Annotated[float, Quantity("torsional_damping")]
TorsionalStiffness = Annotated[float, Quantity("torsional_stiffness")]
Velocity = Annotated[float, Quantity("velocity")]
Volume = Annotated[float, Quantity("volume")]


def unit(dimension: str) -> str:
    """Return the unit in which a dimension is shown.

    Args:
        dimension: Such as ``"length"``.
    """
    return _SHOWN[dimension].unit


_SYMBOLS: Mapping[str, str] = MappingProxyType({
    "deg": "°", "mm2": "mm²", "m2": "m²", "kg_m3": "kg/m³", "j": "J", "kj": "kJ", "mj": "MJ", "kwh": "kWh", "n": "N",
    "kn": "kN", "hz": "Hz", "khz": "kHz", "kg_m2": "kg m²", "um": "µm", "kw": "kW", "w": "W", "mw": "MW",
    "rad_s": "rad/s", "n_m": "N/m", "n_um": "N/µm", "n_mm": "N/mm", "mpa": "MPa", "pa": "Pa", "gpa": "GPa",
    "nm": "N m", "knm": "kN m", "lbf_ft": "lbf ft", "nm_rad": "N m/rad", "knm_rad": "kN m/rad", "m_s": "m/s",
    "km_h": "km/h", "ft_min": "ft/min", "m3": "m³", "mm3": "mm³", "per_in": "1/in", "kg_kw": "kg/kW", "kg_w": "kg/W",
    "kw_kg": "kW/kg", "w_kg": "W/kg",
})  # fmt: skip
"""Suffix of a key -> symbol of its unit, where they differ."""


def suffix_unit(suffix: str) -> str:
    """Return the unit that a suffix of a key names, as engineers write it.

    Args:
        suffix: A key of one of the dimensions of `SUFFIXES`.

    >>> suffix_unit("kw"), suffix_unit("kg_m2"), suffix_unit("mm")
    ('kW', 'kg m²', 'mm')
    """
    return _SYMBOLS.get(suffix, suffix)


def key_suffix(dimension: str) -> str:
    """Return the suffix of a key that holds a dimension in the unit in which it is shown; empty for what has none.

    Args:
        dimension: Such as ``"length"``; empty for words and counts.

    >>> key_suffix("length"), key_suffix("specific_power"), key_suffix("ratio")
    ('mm', 'kw_kg', '')
    """
    return _SHOWN[dimension].suffix if dimension in _SHOWN else ""


def shown(value: float, dimension: str) -> float:
    """Return an SI value in the unit in which its dimension is shown.

    Args:
        value: In SI.
        dimension: Such as ``"length"``.

    >>> shown(0.0254, "length")
    25.4
    """
    return value / _SHOWN[dimension].factor


def text(value: float, dimension: str, digits: int = 4) -> str:
    """Return a value with its unit, as a user reads it.

    Args:
        value: In SI.
        dimension: Such as ``"length"``.
        digits: Significant digits [-].

    >>> text(2094.395, "speed"), text(-0.0, "speed")
    ('20000 rpm', '0 rpm')
    """
    number = shown(value, dimension) + 0.0
    digits = _enough(number, digits) if dimension == "ratio" else digits
    written = f"{number:.0f}" if abs(number) >= 10 ** (digits - 1) else f"{number:.{digits}g}"
    return f"{written} {unit(dimension)}".rstrip()


def written(number: float, digits: int = 4) -> str:
    """Return a number with so many significant digits, trailing zeros kept; what differs by rounding alone reads alike.

    Args:
        number: In the unit that is shown.
        digits: Significant digits [-].

    >>> written(1.0), written(-16035.0), written(0.0), written(-1e-30), written(196.25), written(196.25 + 1e-12)
    ('1.000', '−16035', '0', '0', '196.2', '196.2')
    """
    if abs(number) < NOISE:
        return "0"
    if number < 0.0:
        return f"−{written(-number, digits)}"
    if math.isinf(number):
        return "∞"
    number = float(f"{number:.{EXACT}g}")
    if abs(number) >= LARGEST_PLAIN:
        return f"{number:.{digits - 1}e}"
    if abs(number) >= 10 ** (digits - 1):
        return f"{number:.0f}"
    if abs(number) < SMALLEST_PLAIN:
        return f"{number:.{digits - 1}e}"
    return f"{number:#.{digits}g}".rstrip(".")


def margin_text(margin: float, digits: int = 3) -> str:
    """Return a margin as it is read: rounded like any number, but what is below 1 never reads as 1.

    Args:
        margin: Or an efficiency, or any other part of what is asked, of which 1 is all [-].
        digits: Significant digits [-]; more where fewer would hide that it is below 1.

    >>> margin_text(0.7196), margin_text(0.7196, 4), margin_text(0.9996), margin_text(0.99996), margin_text(1.0004)
    ('0.720', '0.7196', '0.9996', '0.99996', '1.00')
    """
    return written(margin, _enough(margin, digits))


def _enough(margin: float, digits: int) -> int:
    """Return so many digits, or more where fewer would round what is below 1 to it."""
    below = margin < 1.0 - NOISE
    return next(more for more in range(digits, 99) if not below or float(f"{margin:.{more}g}") < 1.0)


def number_text(value: float, dimension: str, digits: int = 4) -> str:
    """Return a value without its unit as tables and headlines have it, so that both round it alike.

    Args:
        value: In SI.
        dimension: Such as ``"length"``; empty for what has none.
        digits: Significant digits [-].

    >>> number_text(0.0254, "length"), number_text(0.99996, "ratio"), number_text(0.99996, "mass")
    ('25.40', '0.99996', '1.000')
    """
    if dimension == "ratio":
        return margin_text(value, digits)
    return written(shown(value, dimension) if dimension else value, digits)


def digits_apart(first: float, second: float, digits: int = 4) -> int:
    """Return how many significant digits tell two numbers apart that are compared [-].

    Args:
        first: In the unit that is shown.
        second: In the same.
        digits: That suffice where the numbers are equal, and are taken at least [-].
    """
    apart = (more for more in range(digits, EXACT + 1) if written(first, more) != written(second, more))
    return next(apart, digits)


def apart(first: float, second: float, dimension: str, digits: int = 4) -> tuple[str, str]:
    """Return two values that are compared, with their unit and as many digits as tell them apart.

    Args:
        first: In SI.
        second: In SI.
        dimension: Of both, such as ``"power"``.
        digits: Significant digits [-], where these suffice.

    >>> apart(1469.2e3, 1468.9e3, "power"), apart(0.2, 0.1, "length")
    (('1469.2 kW', '1468.9 kW'), ('200 mm', '100 mm'))
    """
    enough = digits_apart(shown(first, dimension), shown(second, dimension), digits)
    return text(first, dimension, enough), text(second, dimension, enough)


def si_unit(dimension: str) -> str:
    """Return the unit in which a dimension is kept.

    Args:
        dimension: Such as ``"length"``.

    >>> si_unit("speed")
    'rad/s'
    """
    return _SHOWN[dimension].si


class Marks(NamedTuple):
    """What the marks of a field say."""

    dimension: str
    """Key of the units; empty for words and counts."""
    origin: Origin | None
    """Equation and source of a computed field."""
    made_in: str = ""
    """Field that holds the record whose field of the same name has the origin."""
    endless: bool = False
    """Whether it may be infinite."""


def marks_in(hint: Any) -> Marks:
    """Return what an annotation says of its field, also inside a union.

    Args:
        hint: Annotation with its marks.
    """
    inside = get_args(hint) if get_origin(hint) in (Union, UnionType) else ()
    marks = [mark for part in (hint, *inside) for mark in getattr(part, "__metadata__", ())]
    dimension = next((mark.dimension for mark in marks if isinstance(mark, Quantity)), "")
    origin = next((mark for mark in marks if isinstance(mark, Origin)), None)
    made_in = next((mark.field for mark in marks if isinstance(mark, OriginOf)), "")
    return Marks(dimension, origin, made_in, any(isinstance(mark, Endless) for mark in marks))


def marks_of(record: type) -> Mapping[str, Marks]:
    """Return the marks of every field of a record.

    Args:
        record: Its class.
    """
    return _marks_of(record)


@cache
def _marks_of(record: Any) -> Mapping[str, Marks]:
    return MappingProxyType({name: marks_in(hint) for name, hint in _hints(record).items()})


def marks_at(record: type, name: str) -> Marks:
    """Return the marks of a field or property of a record.

    Args:
        record: Its class.
        name: Of the field or property.
    """
    return _marks_at(record, name)


@cache
def _marks_at(record: Any, name: str) -> Marks:
    entry = getattr(record, name, None)
    made = entry.fget if isinstance(entry, property) else getattr(entry, "func", None)
    return marks_in(_hints(record)[name] if made is None else _hints(made)["return"])


@cache
def _hints(described: Any) -> Mapping[str, Any]:
    """Return the annotations of a class or a function."""
    return get_type_hints(described, include_extras=True)


def origin_of(record: object, name: str) -> Origin | None:
    """Return where a value of a record comes from: by the mark of its field, or by the record that made it.

    Args:
        record: A dataclass.
        name: Of its field or property.
    """
    marks = marks_at(type(record), name)
    return origin_of(getattr(record, marks.made_in), name) if marks.made_in else marks.origin
