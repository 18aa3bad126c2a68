"""Shafts and carriers as they are made: whole shafts through their gears, carriers of two plates with bridges."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.identity import Role
from gearwright.sizing.carrying import CarrierSizing
from gearwright.sizing.mass.record import MassItem
from gearwright.sizing.places import runs
from gearwright.sizing.result import GearSizing, Sizing

SURE_SHAFT = 0.25
"""One standard deviation of shafts over their value, an estimate: lengths before everything has its place [-]."""
SURE_CARRIER = 0.30
"""One standard deviation of carriers over their value, an estimate [-]."""
PIN_BORE = 0.6
"""Bore of planet pins over their diameter [-], an estimate: held on both sides, a pin as thick as a cantilever one
bears a quarter of the moment, for which a bore of 0.93 would do."""
BRIDGE = 0.5
"""Depth of a carrier's bridge over a planet's diameter [-], an estimate from drawings of two-plate carriers."""


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
        sure, source = (0.08, "its steps") if shaft.name in built else (SURE_SHAFT, "its place on its axis")
        yield MassItem(shaft.name, "shafts", 1, density * volume, sure, "Σ π/4 (d² − d_i²) l ρ", source)


def carrier_items(sizing: Sizing) -> Iterator[MassItem]:
    """Yield every carrier: pins and plate as sized, bored, with a plate on the other side, too, and bridges between.

    Args:
        sizing: As sized.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    for carrier in sizing.carriers:
        formula, source = "hollow pins; two plates; bridges", "first sizing; geometry"
        given = sizing.given.get(f"{carrier.part}.mass")
        if given is not None:
            yield MassItem(str(carrier.part), "carriers", 1, given.value, 0.02, "given", given.origin or "the design")
            continue
        planets = [gear for gear in gears.values() if gear.stage == carrier.stage and gear.role is Role.PLANET]
        mass = (
            carrier.mass
            - _bored(sizing, carrier, planets)
            + _plate(sizing, carrier)
            + _bridges(sizing, carrier, planets)
        )
        yield MassItem(str(carrier.part), "carriers", 1, mass, SURE_CARRIER, formula, source)


def _bored(sizing: Sizing, carrier: CarrierSizing, planets: list[GearSizing]) -> float:
    """Return what the bores of the pins take from pins that were sized solid [kg]."""
    density = sizing.design.shaft_material.density
    pins = max(gear.bodies for gear in planets) * max(gear.face_width for gear in planets)
    if carrier.pin_bore is not None:  # bored by sizing, under the bearing that the planets turn on
        return 0.0
    return math.pi / 4.0 * (PIN_BORE * carrier.pin_diameter) ** 2 * pins * density


def _plate(sizing: Sizing, carrier: CarrierSizing) -> float:
    """Return the mass of the second plate, which holds the pins' other ends and carries no torque to a shaft [kg]."""
    rules, density = sizing.design.carriers, sizing.design.shaft_material.density
    widths = [gear.face_width for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET]
    reach = carrier.radius + carrier.pin_diameter / 2.0
    return math.pi * reach**2 * rules.plate_ratio * max(widths) * rules.fill * density


def _bridges(sizing: Sizing, carrier: CarrierSizing, planets: list[GearSizing]) -> float:
    """Return the mass of what joins the plates where planets leave room on the pin circle [kg]."""
    widest = max(planets, key=lambda gear: gear.pitch_diameter)
    tip = widest.pitch_diameter + 2.0 * widest.module * (1.0 + widest.profile_shift)
    gap = 2.0 * carrier.radius * math.sin(math.pi / widest.bodies) - tip
    density = sizing.design.shaft_material.density
    return widest.bodies * max(gap, 0.0) * BRIDGE * tip * widest.face_width * density
