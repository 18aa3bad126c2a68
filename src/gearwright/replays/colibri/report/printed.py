"""What the EC120B "Colibri" term project prints: 236 numbers, what they silently assume, and what is wrong with them.

The numbers are facts of the source, digit for digit; `gearwright.replays.colibri.replay` computes every one again. The
errata say which numbers are wrong and why; the correct values are computed, too.
"""

from __future__ import annotations

import csv
import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from types import MappingProxyType
from typing import Any

from gearwright.units import RPM

SOURCE = "Uyar, Kılıç, Koşar & Bölükbaş, Transmission System Design for Colibri, Istanbul Technical University"
_UNITS = {
    "": 1.0, "mm": 1e-3, "mm/s": 1e-3, "N": 1.0, "N mm": 1e-3, "N/mm²": 1e6, "rpm": RPM, "°": math.pi / 180.0,
}  # fmt: skip
"""Unit of the report -> SI."""


@dataclass(frozen=True)
class PrintedNumber:
    """One number of the report."""

    key: str
    """Part and quantity, such as ``shaft-1.torque``."""
    place: str
    """Where it stands, by the report's own headings."""
    symbol: str
    """As the report writes it."""
    unit: str
    """Unit in which it is printed."""
    printed: str
    """Its digits, with a point for the comma."""
    is_stated: bool
    """Whether the report gives it without computing it."""

    @property
    def part(self) -> str:
        """First half of the key."""
        return self.key.partition(".")[0]

    @property
    def scale(self) -> float:
        """Its unit in SI."""
        return _UNITS[self.unit]

    @property
    def value(self) -> float:
        """As printed, in SI."""
        return float(self.printed) * self.scale


@dataclass(frozen=True)
class Assumption:
    """What the report does not say, and what its digits show."""

    key: str
    """H1 to H9."""
    text: str
    """What has to be assumed."""
    evidence: str
    """Why it is taken to be so."""


@dataclass(frozen=True)
class ColibriErratum:
    """One mistake of the report, and the numbers that carry it."""

    key: str
    """E1 and so on."""
    title: str
    """In few words."""
    rows: tuple[str, ...]
    """Keys of the numbers that are wrong by it; empty where it concerns no single number."""
    why: str
    """Reason; numbers in braces are filled in from the computation."""


@cache
def printed_numbers() -> tuple[PrintedNumber, ...]:
    """Return every number of the report in its order."""
    rows = csv.DictReader(_text("numbers.csv").splitlines())
    return tuple(
        PrintedNumber(row["key"], row["place"], row["symbol"], row["unit"], row["printed"], row["stated"] == "yes")
        for row in rows
    )


@cache
def assumptions() -> Mapping[str, Assumption]:
    """Return what the report silently assumes, by key."""
    return MappingProxyType({row["key"]: Assumption(**row) for row in _notes()["assumptions"]})


@cache
def colibri_errata() -> tuple[ColibriErratum, ...]:
    """Return the report's mistakes in its order."""
    return tuple(ColibriErratum(row["key"], row["title"], tuple(row["rows"]), row["why"]) for row in _notes()["errata"])


def _notes() -> dict[str, Any]:
    return tomllib.loads(_text("notes.toml"))


def _text(name: str) -> str:
    return files("gearwright.replays.colibri").joinpath(f"data/{name}").read_text(encoding="utf-8")
