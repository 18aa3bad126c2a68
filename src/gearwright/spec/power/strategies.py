"""Hybrid strategies by name: how turbines and motors divide the power of a phase, interval by interval."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Power, Ratio

Rule = Literal["share", "boost", "turbine-alone", "electric-taxi", "regenerate", "charge", "optimal"]
"""Rules by which a strategy divides power."""


class StrategyRules(Record):
    """A strategy that phases name."""

    rule: Rule = Field(description="How power is divided")
    electric_share: Ratio | None = Field(
        None, ge=-0.9, le=1, description="Of `share`: motors' part of the machines' power; negative charges"
    )
    turbine_power: Power | None = Field(
        None, gt=0, le=1e9,
        description="Of `boost`: turbines give up to this, motors what is more; left out: what the turbines can give",
    )  # fmt: skip
    charge_power: Power | None = Field(
        None, gt=0, le=1e9, description="Of `charge`: what the motors take from the gearbox, as far as turbines give it"
    )
    until_charge: Ratio | None = Field(
        None, gt=0, le=1, description="Of `charge` and `regenerate`: state of charge that ends it; left out: 0.95"
    )
    end_charge: Ratio | None = Field(
        None, ge=0, le=1, description="Of `optimal`: state of charge at its last phase's end; left out: minimum_charge"
    )
    shares: int | None = Field(
        None, ge=3, le=401, description="Of `optimal`: shares that are tried, from the lowest to 1; left out: 41"
    )
    lowest_share: Ratio | None = Field(
        None, ge=-0.9, le=0, description="Of `optimal`: lowest of them; negative charges; left out: 0"
    )
    charges: int | None = Field(
        None, ge=3, le=1001, description="Of `optimal`: states of charge that are looked at; left out: 101"
    )


KEYS_OF: dict[str, tuple[str, ...]] = {
    "share": ("electric_share",),
    "boost": ("turbine_power",),
    "turbine-alone": (),
    "electric-taxi": (),
    "regenerate": ("until_charge",),
    "charge": ("charge_power", "until_charge"),
    "optimal": ("end_charge", "shares", "lowest_share", "charges"),
}
"""Rule -> the keys that it reads."""
NEEDED = {"share": "electric_share", "charge": "charge_power"}
"""Rule -> the key that it cannot do without."""
