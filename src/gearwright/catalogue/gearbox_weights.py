"""The 61 gearbox weights of NASA/TM-2009-215680: real weights against which a method can be held.

The report's figure plots the weight of more than fifty gearboxes of rotorcraft, tiltrotors and turboprops over
β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15. The points were read off the figure (about ± 1 %); the aircraft are not
named, and neither power nor speeds are given, only β.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from gearwright.catalogue.tables import data_rows
from gearwright.units import HORSEPOWER, POUND, RPM, Mass, Number, Power, Speed

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
