"""Shafts and carriers as they are made: whole shafts through their gears, carriers of two plates with bridges."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.sizing.mass.cages import cage_of
from gearwright.sizing.mass.record import MassItem
from gearwright.sizing.places import runs
from gearwright.sizing.result import Sizing

SURE_SHAFT = 0.25
"""One standard deviation of shafts over their value, an estimate: lengths before everything has its place [-]."""
SURE_CARRIER = 0.30
"""One standard deviation of carriers over their value, an estimate [-]."""


def shaft_items(sizing: Sizing) -> Iterator[MassItem]:
    """Yield every shaft from end to end, through its gears, whose bodies are bored here, as far as its place asks.

    Args:
        sizing: As sized.
    """
    built = {shaft.name for shaft in sizing.built_shafts}
    density, (reaches, _) = sizing.design.shaft_material.density, runs(sizing)
    for shaft in sizing.shafts:
        given = sizing.given.get(f"{shaft.name}.mass")
        if given is not None:
            yield MassItem(shaft.name, "shafts", 1, given.value, 0.02, "given", given.origin or "the design")
            continue
        volume = sum(run.volume for run in reaches if run.shaft == shaft.name)
        if volume == 0.0:  # the cage of planets, which is weighed as their carrier
            continue
        sure, source = (0.08, "its steps") if shaft.name in built else (SURE_SHAFT, "its place on its axis")
        yield MassItem(shaft.name, "shafts", 1, density * volume, sure, "Σ π/4 (d² − d_i²) l ρ", source)


def carrier_items(sizing: Sizing) -> Iterator[MassItem]:
    """Yield every carrier: a plate on both sides, hollow pins between them, and bridges.

    Args:
        sizing: As sized.
    """
    density, (reaches, _) = sizing.design.shaft_material.density, runs(sizing)
    for carrier in sizing.carriers:
        formula, source = "hollow pins; two plates; bridges", "first sizing; geometry"
        given = sizing.given.get(f"{carrier.part}.mass")
        if given is not None:
            yield MassItem(str(carrier.part), "carriers", 1, given.value, 0.02, "given", given.origin or "the design")
            continue
        mass = density * cage_of(sizing, carrier, reaches).volume
        yield MassItem(str(carrier.part), "carriers", 1, mass, SURE_CARRIER, formula, source)
