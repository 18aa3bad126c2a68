"""Whole gearboxes with published requirement and mass: what sums of parts are held against.

A catalogue's gearbox is one that is sold; a study's mass is a design value, a model's the sum of its bodies.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

from gearwright.catalogue.tables import data_rows
from gearwright.units import Mass, Power, Ratio, Torque


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
