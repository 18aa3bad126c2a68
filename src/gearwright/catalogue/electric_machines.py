"""Public electric motors and generators with their masses, and the law of torque and speed that is fitted to them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np

from gearwright.base import RPM, Floats, Mass, Power, Speed, Torque
from gearwright.catalogue.tables import data_rows

ANY_TIME, WITHOUT, FOR_AIRCRAFT, NOT_READ = "continuous", "no", "aircraft", "no"
"""Words of the table: rating, inverter in the mass, use, and whether a text of the source was read."""


@dataclass(frozen=True)
class PublicMachine:
    """A motor or generator as it is published."""

    name: str
    power: Power
    """Rated [W]."""
    rating: str
    """``continuous``, ``peak`` or ``target``."""
    speed: Speed | None
    """At that power, from power and torque where no speed is stated [rad/s]; None where neither is."""
    mass: Mass
    """[kg]"""
    inverter: str
    """Whether the mass has one: ``yes``, ``no`` or ``unknown``."""
    cooling: str
    """``air``, ``liquid`` or ``combined``."""
    use: str
    """``aircraft`` or ``road``."""
    year: int
    """Of the source."""
    read: str
    """``yes``: a text of the machine; ``quoted``: a public collection of makers' sheets; ``no``: from memory."""
    source: str
    note: str

    @property
    def torque(self) -> Torque | None:
        """Rated torque [N m]; None where no speed is known."""
        return None if self.speed is None else self.power / self.speed

    @property
    def is_fitted(self) -> bool:
        """Whether the law is fitted to it: rated for any time, weighed alone, for aircraft, and not from memory."""
        words = (self.rating, self.inverter, self.use)
        known = self.speed is not None and self.read != NOT_READ
        return known and words == (ANY_TIME, WITHOUT, FOR_AIRCRAFT)


@cache
def public_machines() -> tuple[PublicMachine, ...]:
    """Return the public electric machines of the catalogue."""
    sources = {row["key"]: row["source"] for row in data_rows("electric_machine_sources.csv")}
    return tuple(
        PublicMachine(
            row["name"], 1e3 * float(row["power_kw"]), row["rating"], _speed(row), float(row["mass_kg"]),
            row["inverter"], row["cooling"], row["use"], int(row["year"]), row["read"], sources[row["source"]],
            row["note"],
        )
        for row in data_rows("electric_machines.csv")
    )  # fmt: skip


def _speed(row: dict[str, str]) -> float | None:
    if row["speed_rpm"]:
        return float(row["speed_rpm"]) * RPM
    return 1e3 * float(row["power_kw"]) / float(row["torque_nm"]) if row["torque_nm"] else None


class MassFit(NamedTuple):
    """A law m = a T^b n^c that is fitted to machines."""

    law: tuple[float, float, float]
    """a, b, c: T [N m], n [rpm], m [kg]."""
    band: float
    """Factor of one standard deviation [-]."""
    left_out_bias: float
    """Mean of what the law says of each machine that is left out, over its mass, less 1 [-]."""
    left_out_band: float
    """Factor of the root mean square of the same [-]."""


def fitted_law(machines: Sequence[PublicMachine]) -> MassFit:
    """Return the law that fits machines best in the logarithm of their masses.

    Args:
        machines: With torque and speed, four or more.

    Source: least squares; the residual of a row that is left out is r/(1 - h) with h of the diagonal of the projection.
    """
    terms = np.array([_terms(machine) for machine in machines])
    masses = np.log([machine.mass for machine in machines])
    found = np.linalg.lstsq(terms, masses, rcond=None)[0]
    residuals = masses - terms @ found
    leverage = np.einsum("ij,jk,ik->i", terms, np.linalg.inv(terms.T @ terms), terms)
    left_out: Floats = -residuals / (1.0 - leverage)
    a, b, c = map(float, found)
    return MassFit(
        (math.exp(a), b, c),
        math.exp(math.sqrt(float(residuals @ residuals) / (len(machines) - 3))),
        math.exp(float(left_out.mean())) - 1.0,
        math.exp(math.sqrt(float(np.mean(left_out**2)))),
    )


def _terms(machine: PublicMachine) -> tuple[float, float, float]:
    if machine.speed is None:
        raise ValueError(f"{machine.name}: no speed is known")
    return 1.0, math.log(machine.power / machine.speed), math.log(machine.speed / RPM)


def bias_and_band(machines: Sequence[PublicMachine], law: Callable[[float, float], float]) -> tuple[float, float]:
    """Return by how much a law is off on average, and the factor of its standard deviation about that [-].

    Args:
        machines: With torque and speed, two or more.
        law: Of torque [N m] and speed [rad/s] -> mass [kg].
    """
    known = [(machine.power / machine.speed, machine.speed, machine.mass) for machine in machines if machine.speed]
    ratios = np.log([law(torque, speed) / mass for torque, speed, mass in known])
    return math.exp(float(ratios.mean())) - 1.0, math.exp(float(ratios.std(ddof=1)))
