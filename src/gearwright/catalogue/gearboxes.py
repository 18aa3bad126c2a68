"""Published gearboxes with their masses, and published mesh load factors of planetary stages."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

from gearwright.base import HORSEPOWER, POUND, RPM, Mass, Number, Power, Ratio, Speed, Torque
from gearwright.catalogue.tables import data_rows

# ----------------------------------------------------------------------------------------------------------------------
# The 61 gearbox weights of NASA/TM-2009-215680: real weights against which a method can be held.
#
# The report's figure plots the weight of more than fifty gearboxes of rotorcraft, tiltrotors and turboprops over
# β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15. The points were read off the figure (about ± 1 %); the aircraft are not
# named, and neither power nor speeds are given, only β.
# ----------------------------------------------------------------------------------------------------------------------


SOURCE = "NASA/TM-2009-215680, figure of actual gearbox weights, as digitised in AeroSandbox studies/GearboxMassFits"


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
