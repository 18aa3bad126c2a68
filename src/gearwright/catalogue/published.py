"""Published engines and gearboxes with their masses as they are printed, and mesh load factors of planetary stages."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

from gearwright.base import HORSEPOWER, POUND, RPM, DesignError, Mass, Number, Power, Problem, Ratio, Speed, Torque
from gearwright.catalogue.tables import data_rows

# ----------------------------------------------------------------------------------------------------------------------
# The 121 engines of Pulvirenti (2023), tables 1.3-1.15, as they are printed, and what is known to be wrong with them.
#
# The gearbox masses of these tables are estimates by a formula and not weights; `weights.methods`
# recomputes them. The engine speed is not printed: each series has a rule that reproduces its printed masses.
# ----------------------------------------------------------------------------------------------------------------------


PULVIRENTI_2023 = "Pulvirenti 2023, tables 1.3-1.15"
_KW = 1e3


@dataclass(frozen=True)
class Printed:
    """A number as it stands in a table: its digits say how well it is known."""

    text: str
    """The digits as printed."""

    @property
    def value(self) -> float:
        """The number in the unit of its column."""
        return float(self.text)

    @property
    def decimals(self) -> int:
        """Digits after the point."""
        return len(self.text.partition(".")[2])

    @property
    def half_digit(self) -> float:
        """Half a unit of the last printed digit, in the unit of the column."""
        return 0.5 * 10.0**-self.decimals

    @property
    def bounds(self) -> tuple[float, float]:
        """The numbers that round to the printed one, in the unit of the column."""
        return self.value - self.half_digit, self.value + self.half_digit


@dataclass(frozen=True)
class Note:
    """What is known about one printed column of one row, or of every row of a series."""

    series: str
    model: str
    """Model, or ``*`` for every row of the series."""
    column: str
    """Name of the column as in `Engine.printed`, or ``model``."""
    verdict: str
    """``last digit``, ``differs``, ``misplaced``, ``meaningless``; ``other source`` where the row is doubtful."""
    reads_as: str
    """For a misplaced number, the column to which it belongs."""
    reason: str


@dataclass(frozen=True)
class Series:
    """A family of engines, one table of the thesis, with the rule for its engine speed."""

    name: str
    table: str
    """Number of the table in Pulvirenti (2023)."""
    manufacturer: str
    kind: str
    """``turboprop`` or ``turboshaft``."""
    rule: str
    """``ratio`` (engine speed over propeller speed) or ``speed_rpm``."""
    value: float
    """Ratio [-], or engine speed [rpm]."""
    reason: str
    """Why this rule: the interval of values that reproduces the printed masses."""


@dataclass(frozen=True)
class Engine:
    """One row of the tables."""

    series: Series
    model: str
    row: int
    """Place in its table, from 1; two models of table 1.13 appear twice."""
    printed: tuple[tuple[str, Printed], ...]
    """Column name and printed number; a column that is left empty in print is not here."""
    notes: tuple[Note, ...]

    def as_printed(self, column: str) -> Printed | None:
        """Return what stands under a column, misplaced or not.

        Args:
            column: Such as ``torque_nm``.
        """
        return dict(self.printed).get(column)

    def as_meant(self, column: str) -> Printed | None:
        """Return what belongs to a column: misplaced numbers are read where they belong.

        Args:
            column: Such as ``torque_nm``.
        """
        for note in self.notes:
            if note.reads_as == column:
                return self.as_printed(note.column)
        return None if self.note(column, "misplaced") else self.as_printed(column)

    def note(self, column: str, verdict: str = "") -> Note | None:
        """Return the note on a column, if there is one.

        Args:
            column: Such as ``torque_nm``.
            verdict: Only a note with this verdict, if given.
        """
        return next(
            (note for note in self.notes if note.column == column and verdict in ("", note.verdict)),
            None,
        )

    @property
    def power(self) -> Power:
        """Take-off power of the engine [W]."""
        return self._input("power_kw") * _KW

    @property
    def propeller_speed(self) -> Speed:
        """Speed of the propeller or of the output shaft [rad/s]."""
        return self._input("propeller_rpm") * RPM

    @property
    def engine_speed(self) -> Speed:
        """Speed of the power turbine by the rule of the series [rad/s]."""
        if self.series.rule == "ratio":
            return self.series.value * self.propeller_speed
        return self.series.value * RPM

    @property
    def has_gearbox(self) -> bool:
        """False where the printed gearbox columns mean nothing."""
        return self.note("gearbox_mass_kg", "meaningless") is None

    def _input(self, column: str) -> float:
        return dict(self.printed)[column].value


@cache
def all_series() -> tuple[Series, ...]:
    """Return the series in the order of the tables."""
    return tuple(
        Series(
            name=row["series"],
            table=row["table"],
            manufacturer=row["manufacturer"],
            kind=row["kind"],
            rule=row["rule"],
            value=float(row["value"]),
            reason=row["reason"],
        )
        for row in data_rows("engine_series.csv")
    )


@cache
def notes() -> tuple[Note, ...]:
    """Return everything that is known to be wrong or doubtful in the tables."""
    return tuple(Note(**row) for row in data_rows("engine_notes.csv"))


@cache
def engines() -> tuple[Engine, ...]:
    """Return the 121 engines in the order of the tables."""
    of_name = {series.name: series for series in all_series()}
    place = dict.fromkeys(of_name, 0)
    table = []
    for row in data_rows("engines.csv"):
        name, model = row.pop("series"), row.pop("model")
        place[name] += 1
        printed = tuple((column, Printed(text)) for column, text in row.items() if text)
        remarks = tuple(note for note in notes() if note.series == name and note.model in ("*", model))
        table.append(Engine(of_name[name], model, place[name], printed, remarks))
    return tuple(table)


def select(
    *,
    series: str = "",
    manufacturer: str = "",
    kind: str = "",
    model: str = "",
    power: tuple[float, float] | None = None,
) -> tuple[Engine, ...]:
    """Return the engines that answer to every criterion; names match by any part of them, in any case.

    Args:
        series: Such as ``PW100``.
        manufacturer: Such as ``pratt``.
        kind: ``turboprop`` or ``turboshaft``.
        model: Such as ``127``.
        power: Least and greatest power [W].

    Raises:
        DesignError: No engine answers to them.
    """
    wanted = ((series, "name"), (manufacturer, "manufacturer"), (kind, "kind"))
    low, high = power or (0.0, math.inf)
    matching = tuple(
        engine
        for engine in engines()
        if all(text.casefold() in getattr(engine.series, field).casefold() for text, field in wanted)
        and model.casefold() in engine.model.casefold()
        and low <= engine.power <= high
    )
    if not matching:
        raise DesignError([Problem("engines", f"no engine of the catalogue answers to this; {_choice()}")])
    return matching


def _choice() -> str:
    powers = [engine.power / _KW for engine in engines()]
    names = ", ".join(series.name for series in all_series())
    return f"series: {names}; power {min(powers):g} to {max(powers):g} kW"


def nearest(power: float, engine_speed: float, propeller_speed: float, *, count: int = 5) -> tuple[Engine, ...]:
    """Return the engines that are most alike in power and in both speeds, the nearest first.

    The distance is that of the logarithms, so a factor counts the same in each of the three. Engines whose printed
    gearbox means nothing are left out, and of engines of a series with the same power and speed only the first counts.

    Args:
        power: [W].
        engine_speed: [rad/s].
        propeller_speed: [rad/s].
        count: How many [-].
    """

    def distance(engine: Engine) -> float:
        return math.hypot(
            math.log(engine.power / power),
            math.log(engine.engine_speed / engine_speed),
            math.log(engine.propeller_speed / propeller_speed),
        )

    distinct = {
        (engine.series.name, engine.power, engine.propeller_speed): engine
        for engine in reversed(engines())
        if engine.has_gearbox
    }
    return tuple(sorted(distinct.values(), key=distance)[:count])


# ----------------------------------------------------------------------------------------------------------------------
# The 61 gearbox weights of NASA/TM-2009-215680: real weights against which a method can be held.
#
# The report's figure plots the weight of more than fifty gearboxes of rotorcraft, tiltrotors and turboprops over
# β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15. The points were read off the figure (about ± 1 %); the aircraft are not
# named, and neither power nor speeds are given, only β.
# ----------------------------------------------------------------------------------------------------------------------


NASA_2009 = "NASA/TM-2009-215680, figure of actual gearbox weights, as digitised in AeroSandbox studies/GearboxMassFits"


@dataclass(frozen=True)
class WeighedGearbox:
    """One real gearbox."""

    beta: Number
    """(hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15, in the units of the report."""
    mass: Mass
    """Dry mass of the gearbox [kg]."""


@cache
def weighed_gearboxes() -> tuple[WeighedGearbox, ...]:
    """Return the weighed gearboxes in the order of β.

    Source:
        NASA/TM-2009-215680; points digitised by P. Sharpe, AeroSandbox, studies/GearboxMassFits.
    """
    return tuple(
        WeighedGearbox(10.0 ** float(row["log10_beta"]), 10.0 ** float(row["log10_weight_lb"]) * POUND)
        for row in data_rows("gearbox_weights.csv")
    )


@dataclass(frozen=True)
class GearboxClass:
    """Typical inputs of a class of gearbox: from general knowledge, not from a type certificate."""

    name: str
    power: Power
    """[W]."""
    engine_speed: Speed
    """Speed of the input [rad/s]."""
    output_speed: Speed
    """Speed of the propeller or rotor [rad/s]."""


@cache
def gearbox_classes() -> tuple[GearboxClass, ...]:
    """Return seven classes of gearbox that span turboprops and main rotors."""
    return tuple(
        GearboxClass(
            name=row["name"],
            power=float(row["power_hp"]) * HORSEPOWER,
            engine_speed=float(row["engine_rpm"]) * RPM,
            output_speed=float(row["output_rpm"]) * RPM,
        )
        for row in data_rows("gearbox_classes.csv")
    )


# ----------------------------------------------------------------------------------------------------------------------
# Whole gearboxes with published requirement and mass: what sums of parts are held against.
#
# A catalogue's gearbox is one that is sold; a study's mass is a design value, a model's the sum of its bodies.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class PublishedGearbox:
    """One gearbox with what it must do and what it weighs."""

    name: str
    kind: str
    """By which design it is sized: wind-small, wind-large, simpack-5mw, geared-fan or propeller-pair."""
    power: Power
    """Rated [W]."""
    torque: Torque
    """At its slow shaft [N m]."""
    ratio: Ratio
    """Fast speed over slow speed [-]."""
    mass: Mass
    """As published [kg]."""
    status: str
    """catalogue, study, model, design or press."""
    source: str


@cache
def published_gearboxes() -> Mapping[str, PublishedGearbox]:
    """Return the published gearboxes by name."""
    sources = {row["key"]: row["source"] for row in data_rows("published_gearbox_sources.csv")}
    return MappingProxyType(
        {
            row["name"]: PublishedGearbox(
                name=row["name"],
                kind=row["kind"],
                power=float(row["power_kw"]) * 1e3,
                torque=float(row["torque_knm"]) * 1e3,
                ratio=float(row["ratio"]),
                mass=float(row["mass_kg"]),
                status=row["status"],
                source=sources[row["source"]],
            )
            for row in data_rows("published_gearboxes.csv")
        }
    )


@dataclass(frozen=True)
class MassClass:
    """A class of published gearboxes, and how their masses stand to the sums of parts of the same requirements."""

    name: str
    """wind or aircraft."""
    factor: Ratio
    """Published masses over sums of parts, fitted; 1 where nothing was [-]."""
    scatter: Ratio
    """Factor of one standard deviation, each gearbox left out of the fit that it is held against [-]."""
    gearboxes: int
    """To which the factor was fitted [-]."""
    members: str
    """What they are."""


@cache
def mass_classes() -> Mapping[str, MassClass]:
    """Return the classes of published gearboxes by name (benchmarks/gearbox_masses.py --fit --write)."""
    rows = data_rows("mass_classes.csv")
    return MappingProxyType({
        row["name"]: MassClass(
            row["name"], float(row["factor"]), float(row["scatter"]), int(row["gearboxes"]), row["members"]
        )
        for row in rows
    })  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Mesh load factors of planetary sets in print: standards by number of planets, and measurements.
#
# The levels of AGMA 6123 are taken where a design states no factor; the others stand beside computed values. The tables
# were written down from memory; each row says how sure it is.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class LoadFactor:
    """One printed or measured mesh load factor."""

    source: str
    """Standard, or authors and year."""
    case: str
    """Class of application, or what was measured."""
    planets: int
    """Number of planets."""
    load_factor: Number
    """K_γ [-]."""
    confidence: str
    """How the number was got."""
    measured: bool
    """True if measured, False if a standard's table."""

    @property
    def name(self) -> str:
        """Source and case."""
        return f"{self.source}, {self.case}"


@cache
def load_factors() -> tuple[LoadFactor, ...]:
    """Return the published mesh load factors, standards before measurements.

    Source:
        IEC 61400-4:2012; ANSI/AGMA 6123-B06, table 7; Guo & Keller, AGMA Fall Technical Meeting 2020.
    """
    return tuple(
        LoadFactor(
            source=row["source"],
            case=row["case"],
            planets=int(row["planets"]),
            load_factor=float(row["load_factor"]),
            confidence=row["confidence"],
            measured=row["kind"] == "measured",
        )
        for row in data_rows("load_factors.csv")
    )


def load_factor_tables() -> Mapping[str, Mapping[int, float]]:
    """Return the standards' tables: name -> number of planets -> K_γ [-]."""
    tables: dict[str, dict[int, float]] = {}
    for row in load_factors():
        if not row.measured:
            tables.setdefault(row.name, {})[row.planets] = row.load_factor
    return tables


LEAST_SHARING = 1.05
"""K_γ of planets that no table goes below here [-]: what tolerances leave of sharing without error, an estimate."""


def level_load_factor(level: int, planets: int) -> float:
    """Return K_γ of planets by a level of AGMA 6123, at least 1.05 [-]; 1 of a single planet.

    Beyond the table it grows as errors do that float does not take up, √((p − 3)/p).

    Args:
        level: 1 to 4.
        planets: Number of planets [-].

    Source:
        ANSI/AGMA 6123-B06, table 7, from memory.

    >>> [level_load_factor(3, planets) for planets in (3, 4, 5, 6)]
    [1.05, 1.15, 1.19, 1.23]
    """
    if planets < 2:
        return 1.0
    table = load_factor_tables()[f"AGMA 6123-B06, level {level}"]
    most = max(table)
    if planets > most:
        spread = math.sqrt((1.0 - 3.0 / planets) / (1.0 - 3.0 / most))
        return 1.0 + (table[most] - 1.0) * spread
    return max(table[planets], LEAST_SHARING)
