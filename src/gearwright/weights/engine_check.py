"""The engine tables of the thesis computed again, with a verdict on every printed number.

Each column is computed from the printed inputs of its row, so that an error does not spread: the gearbox mass by
NASA'15 with the engine speed of the series, the others from power, speed, printed gearbox mass and the engine's mass.
That mass is not printed; it is the middle of the interval of masses that reproduces every printed density and
percentage of the row at once. Columns are in the units of the tables.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from types import MappingProxyType
from typing import NamedTuple

from gearwright.catalogue import Engine, Printed, engines
from gearwright.showing import Shown
from gearwright.weights.laws import mass_afdd00

COLUMNS: Mapping[str, tuple[str, str, str]] = MappingProxyType(
    {
        "gearbox_mass_kg": ("m_GB", "kg", "NASA'15 at the engine speed of the series"),
        "torque_nm": ("Q", "N m", "P / ω_prop"),
        "engine_kw_kg": ("Pd_engine", "kW/kg", "P / m_engine"),
        "turbine_kw_kg": ("Pd_GT", "kW/kg", "P / (m_engine − m_GB)"),
        "gearbox_kw_kg": ("Pd_GB", "kW/kg", "P / m_GB"),
        "torque_nm_kg": ("Qd", "N m/kg", "Q / m_engine"),
        "gearbox_percent": ("%GB", "%", "100 m_GB / m_engine"),
    }
)
"""Column of the tables -> symbol, unit, formula."""


class Verdict(StrEnum):
    """How a printed number compares with the computed one."""

    AGREES = "agrees"
    ROUNDED = "agrees within the rounding of its inputs"
    LAST_DIGIT = "last digit"
    DIFFERS = "differs"
    MISPLACED = "misplaced"
    MEANINGLESS = "meaningless"
    BLANK = "not printed"


@dataclass(frozen=True)
class Check:
    """One printed number beside the computed one, in the unit of its column."""

    column: str
    printed: Printed | None
    computed: float | None
    """None where the row does not say enough."""
    verdict: Verdict
    reason: str
    """Why it is flagged; empty where it agrees."""

    @property
    def difference(self) -> float | None:
        """Computed minus printed, where both are there."""
        return None if self.printed is None or self.computed is None else self.computed - self.printed.value


@dataclass(frozen=True, repr=False)
class CheckedEngine(Shown):
    """One row of the tables with the engine's mass that it implies."""

    engine: Engine
    engine_mass: tuple[float, float] | None
    """Least and greatest mass of the engine [kg] that reproduces the printed row; none where no mass does."""
    checks: tuple[Check, ...]

    @property
    def flagged(self) -> tuple[Check, ...]:
        """The numbers that do not agree."""
        return tuple(
            check for check in self.checks if check.verdict not in (Verdict.AGREES, Verdict.ROUNDED, Verdict.BLANK)
        )

    def check(self, column: str) -> Check:
        """Return the check of a column.

        Args:
            column: Key of `COLUMNS`.
        """
        return next(check for check in self.checks if check.column == column)


@cache
def checked_engines() -> tuple[CheckedEngine, ...]:
    """Return the 121 rows with every printed number checked."""
    return tuple(check_engine(engine) for engine in engines())


def check_engine(engine: Engine) -> CheckedEngine:
    """Return a row with its numbers computed again.

    Args:
        engine: A row of the catalogue.
    """
    mass = _engine_mass(engine)
    spans = _spans(engine, mass)
    checks = tuple(_check(engine, column, spans.get(column)) for column in COLUMNS)
    return CheckedEngine(engine, mass, checks)


def gearbox_mass(engine: Engine) -> float:
    """Return the gearbox mass of an engine by the formula of the tables [kg].

    Args:
        engine: A row of the catalogue.

    Source:
        `ndarc.mass_afdd00` with one rotor (Pulvirenti 2023, eq. 1.2 corrected).
    """
    return mass_afdd00(engine.power, engine.engine_speed, engine.propeller_speed)


class _Span(NamedTuple):
    """What a column may be by computation, as the rounding of the printed inputs allows."""

    minimum: float
    nominal: float
    greatest: float


def _spans(engine: Engine, engine_mass: tuple[float, float] | None) -> dict[str, _Span]:
    power, box = engine.as_printed("power_kw"), engine.as_printed("gearbox_mass_kg")
    assert power is not None and box is not None  # every row has both
    speed = engine.propeller_speed
    torque = 1e3 / speed
    (p0, p1), (m0, m1) = power.bounds, box.bounds
    p, m = power.value, box.value
    by_formula = [mass_afdd00(1e3 * kilowatts, engine.engine_speed, speed) for kilowatts in (p0, p, p1)]
    spans: dict[str, _Span] = {
        "gearbox_mass_kg": _Span(*by_formula),
        "torque_nm": _Span(p0 * torque, p * torque, p1 * torque),
        "gearbox_kw_kg": _Span(p0 / m1, p / m, p1 / m0),
    }
    if engine_mass is not None:
        e0, e1 = engine_mass
        e = 0.5 * (e0 + e1)
        spans |= {
            "engine_kw_kg": _Span(p0 / e1, p / e, p1 / e0),
            "turbine_kw_kg": _Span(p0 / (e1 - m0), p / (e - m), p1 / (e0 - m1)),
            "torque_nm_kg": _Span(p0 * torque / e1, p * torque / e, p1 * torque / e0),
            "gearbox_percent": _Span(100.0 * m0 / e1, 100.0 * m / e, 100.0 * m1 / e0),
        }
    return spans


def _engine_mass(engine: Engine) -> tuple[float, float] | None:
    """Return the masses of the engine that reproduce all four columns in which it stands; None where none does."""
    power, box = engine.as_printed("power_kw"), engine.as_printed("gearbox_mass_kg")
    assert power is not None and box is not None
    p, (m0, m1) = power.value, box.bounds
    torque = 1e3 * p / engine.propeller_speed
    lows, highs = [], []
    for column, low, high, offset in (
        ("engine_kw_kg", p, p, (0.0, 0.0)),
        ("torque_nm_kg", torque, torque, (0.0, 0.0)),
        ("turbine_kw_kg", p, p, (m0, m1)),
        ("gearbox_percent", 100.0 * m0, 100.0 * m1, (0.0, 0.0)),
    ):
        printed = engine.as_meant(column)
        if printed is not None:
            lows.append(low / printed.bounds[1] + offset[0])
            highs.append(high / printed.bounds[0] + offset[1])
    return (max(lows), min(highs)) if lows and max(lows) <= min(highs) else None


def _check(engine: Engine, column: str, span: _Span | None) -> Check:
    printed = engine.as_printed(column)
    computed = None if span is None else span.nominal
    note = engine.note(column)
    if note is not None:
        return Check(column, printed, computed, Verdict(note.verdict), note.reason)
    if printed is None:
        return Check(column, None, computed, Verdict.BLANK, "")
    if span is None:
        return Check(
            column, printed, None, Verdict.DIFFERS, "no engine mass reproduces the columns of this row together"
        )
    return Check(column, printed, computed, *_judge(printed, span))


def _judge(printed: Printed, span: _Span) -> tuple[Verdict, str]:
    low, high = printed.bounds
    slack = 1e-9 * printed.value  # halves in binary
    if low - slack <= span.nominal <= high + slack:
        return Verdict.AGREES, ""
    if span.minimum <= high + slack and span.greatest >= low - slack:
        return Verdict.ROUNDED, ""
    return Verdict.DIFFERS, f"computed {span.nominal:.5g} from the printed inputs"
