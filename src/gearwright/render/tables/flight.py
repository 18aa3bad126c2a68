"""Tables of a flight's page: phases, losses by kind, lives of parts, bearings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Annotated

import numpy as np

from gearwright.mission import Balance, BearingDamage, Durability, Flight, PhaseSummary, phase_forces, phase_summaries
from gearwright.mission.lives import ENDLESS, USUAL_RELIABILITY
from gearwright.render.grid.table import Table, table
from gearwright.spec import Phase
from gearwright.units import (
    CELSIUS,
    FOOT,
    KNOT,
    NAUTICAL_MILE,
    Distance,
    Mass,
    Number,
    Origin,
    Power,
    Quantity,
    marks_of,
)

ElectricEnergy = Annotated[float, Quantity("electric_energy")]
GEAR_RELIABILITY = "0.99"
"""Probability of damage of 1 % belongs to the strengths of ISO 6336-5."""


@dataclass(frozen=True)
class AskedView:
    """One phase as the mission asks for it."""

    name: str
    mode: str
    to: Annotated[float, Quantity("altitude")]
    airspeed: str
    lasts: str
    asks: str
    electric_share: float | None
    propeller: Annotated[float, Quantity("speed")]


@dataclass(frozen=True)
class PhaseView:
    """One phase."""

    name: str
    mode: str
    time: Annotated[float, Quantity("flight_time")]
    fuel: Mass
    from_battery: ElectricEnergy
    propeller: ElectricEnergy
    greatest_power: Power
    """Of the propeller."""
    gearbox_heat: ElectricEnergy
    efficiency: Annotated[float, Quantity("percent"), Origin("E_given/E_taken", "energies of the phase")]
    oil_out: Number
    """Hottest, behind the gearbox [°C]."""


@dataclass(frozen=True)
class ModeView:
    """All phases of one propulsion mode."""

    name: str
    time: Annotated[float, Quantity("flight_time")]
    fuel: Mass
    from_battery: ElectricEnergy
    propeller: ElectricEnergy
    gearbox_heat: ElectricEnergy


@dataclass(frozen=True)
class LossView:
    """One kind of loss."""

    name: str
    energy: ElectricEnergy
    share: Annotated[float, Quantity("percent")]
    """Of what came in."""
    model: str
    source: str


@dataclass(frozen=True)
class LifeView:
    """One part and one way to fail."""

    name: str
    mode: str
    damage_a_flight: Annotated[float, Quantity("ratio"), Origin("D = Σ n_i/N_i", "Miner; ISO 6336-6, ISO 281")]
    flights: Number
    flight_hours: Annotated[float, Quantity("life")]
    reached_by: str


@dataclass(frozen=True)
class BearingView:
    """The bearing of a seat."""

    name: str
    bearing: str
    number: int
    equivalent_load: Annotated[float, Quantity("bearing_force"), Origin("P = (Σ P_i^p N_i/Σ N_i)^(1/p)", "ISO 281")]
    dynamic_rating: Annotated[float, Quantity("bearing_force"), Origin("C of one", "ISO 281, or its maker")]
    speed: Annotated[float, Quantity("speed")]
    static_safety: Annotated[float, Quantity("ratio"), Origin("s_0 = C_0/P_0", "ISO 76")]
    life: Annotated[float, Quantity("life"), Origin("L_10 = (C/P)^p 10⁶ turns", "ISO 281:2007")]
    mass: Mass
    origin: str


LOSSES = {
    "exhaust_heat": "exhaust of the turbines",
    "casing_heat": "casings of the turbines",
    "mesh_loss": "meshes",
    "bearing_loss": "bearings",
    "windage_loss": "windage",
    "churning_loss": "churning",
    "motor_loss": "motors and inverters",
    "battery_loss": "battery",
}
"""Loss in the balance -> words."""


def asked_table(flight: Flight) -> Table:
    """Return what the mission asks of each phase.

    Args:
        flight: As flown.
    """
    rows = [_asked(name, phase) for name, phase in flight.mission.phases.items()]
    return table("Phases as asked", rows, _names(AskedView))


def _asked(name: str, phase: Phase) -> AskedView:
    speed = f"Mach {phase.mach:g}" if phase.mach is not None else ""
    for words, value in (("CAS", phase.cas), ("TAS", phase.tas)):
        speed = f"{value / KNOT:.4g} kt {words}" if value is not None else speed
    lasts = f"{(phase.duration or 0.0) / 60.0:.4g} min"
    if phase.distance is not None:
        lasts = f"{phase.distance / NAUTICAL_MILE:.4g} NM"
    if phase.path_angle is not None:
        lasts = f"at {math.degrees(phase.path_angle):.3g}°"
    if phase.kind is not None and phase.duration is phase.distance is phase.path_angle is None:
        lasts = "as it follows"
    if phase.rate_of_climb is not None:
        lasts = f"at {phase.rate_of_climb / (FOOT / 60.0):.4g} ft/min"
    return AskedView(
        name,
        phase.strategy or phase.mode,
        phase.altitude,
        speed,
        lasts,
        _asks(phase),
        phase.electric_share,
        phase.propeller_speed,
    )


def _asks(phase: Phase) -> str:
    """Return what sets the power of a phase, and what is out."""
    words = "thrust of flight"
    if phase.pitch is not None:
        words = f"blade angle {math.degrees(phase.pitch):.4g}°"
    elif phase.power is not None:
        end = "" if phase.end_power is None else f" to {phase.end_power / 1e3:.4g}"
        words = f"{phase.power / 1e3:.4g}{end} kW"
    working = "" if phase.engines is None else f", {phase.engines} gearboxes work"
    return words + working + (f", without {', '.join(phase.inoperative)}" if phase.inoperative else "")


@dataclass(frozen=True)
class ForcesView:
    """Forces of one phase, of the whole aircraft."""

    name: str
    distance: Distance
    mass: Mass
    thrust: Annotated[float | None, Quantity("bearing_force")]
    drag: Annotated[float, Quantity("bearing_force"), Origin("q S (C_D0 + k C_L²) + μ (m g − L)", "drag polar")]
    path: Annotated[float, Quantity("bearing_force"), Origin("m (g sin γ + dV/dt)", "Newton")]
    left_over: Annotated[float | None, Quantity("bearing_force")]
    jump: Annotated[float, Quantity("velocity")]
    """Of the airspeed, at its start."""


def forces_table(flight: Flight) -> Table | None:
    """Return thrust beside drag and path of each phase; None where the mission has no aircraft.

    Args:
        flight: As flown.
    """
    rows = [
        ForcesView(
            row.name, row.distance, row.mass, row.thrust, row.drag, row.path, left_over=row.left_over, jump=row.jump
        )
        for row in phase_forces(flight)
    ]
    note = "Means of the phase, of the aircraft: thrust that is left over would accelerate it; 0 where it flies so."
    return table("Forces of the aircraft", rows, _names(ForcesView), note=note) if rows else None


def phase_table(flight: Flight) -> Table:
    """Return fuel, charge, work, heat and efficiency of each phase.

    Args:
        flight: As flown.
    """
    rows = [_phase(flight, row) for row in phase_summaries(flight)]
    note = "Of one gearbox; energy from the battery counts its own loss, negative charges it; oil in °C."
    return table("Phases", rows, _names(PhaseView), note=note)


def _names(view: type) -> tuple[str, ...]:
    return tuple(field.name for field in fields(view))


def _phase(flight: Flight, row: PhaseSummary) -> PhaseView:
    inside = np.array(flight.phase) == row.name
    return PhaseView(
        name=row.name,
        mode=(phase := flight.mission.phases[row.name]).strategy or phase.mode,
        time=row.duration,
        fuel=row.fuel,
        from_battery=row.battery,
        propeller=row.propeller,
        greatest_power=float(flight.history.propeller_power[inside].max()),
        gearbox_heat=row.loss,
        efficiency=row.efficiency,
        oil_out=float(flight.oil_outlet[inside].max()) - CELSIUS,
    )


def mode_table(flight: Flight) -> Table:
    """Return fuel, charge, work and heat of each propulsion mode.

    Args:
        flight: As flown.
    """
    rows: dict[str, list[PhaseView]] = {}
    for row in (_phase(flight, summary) for summary in phase_summaries(flight)):
        rows.setdefault(row.mode, []).append(row)
    sums = [
        ModeView(mode, *(sum(getattr(row, name) for row in phases) for name in _names(ModeView)[1:]))
        for mode, phases in rows.items()
    ]
    return table("Propulsion modes", sums, _names(ModeView))


def loss_table(flight: Flight) -> Table:
    """Return every kind of loss, its share of what came in, and the model behind it.

    Args:
        flight: As flown.
    """
    came = flight.balance.came_in
    origins = {name: marks.origin for name, marks in marks_of(Balance).items() if marks.origin is not None}
    rows = [
        LossView(
            words, lost := getattr(flight.balance, name), lost / came, origins[name].equation, origins[name].source
        )
        for name, words in LOSSES.items()
    ]
    return table("Losses", [row for row in rows if row.energy], _names(LossView))


def life_table(flight: Flight, parts: Durability) -> Table:
    """Return the parts and ways to fail that a flight wears out, the one that governs first.

    Args:
        flight: As flown.
        parts: Lives of its gears and bearings.
    """
    more = len(parts.parts) - len(parts.failing)
    note = f"{more} other ways to fail take more than {ENDLESS:,.0f} flights." if more else ""
    return table("Lives", list(_lives(flight, parts)), _names(LifeView), note=note)


def _lives(flight: Flight, parts: Durability) -> Iterator[LifeView]:
    rules = flight.mission.bearings
    for row in parts.failing:
        reached = f"{rules.reliability if rules else USUAL_RELIABILITY:.4g}" if row.is_bearing else GEAR_RELIABILITY
        yield LifeView(row.name, row.mode, row.damage, row.flights, 3600.0 * row.life, reached)


def bearing_table(parts: Durability) -> Table:
    """Return the bearings that are known, the worst first.

    Args:
        parts: Lives of gears and bearings.
    """
    return table("Bearings", [_bearing(row) for row in parts.bearings.rows], _names(BearingView))


def _bearing(row: BearingDamage) -> BearingView:
    return BearingView(
        name=row.seat,
        bearing=row.bearing.designation,
        number=row.count,
        equivalent_load=row.mean_load,
        dynamic_rating=row.bearing.dynamic_rating,
        speed=row.mean_speed,
        static_safety=row.static_safety,
        life=3600.0 * row.life,
        mass=row.mass,
        origin=_origin(row),
    )


def _origin(row: BearingDamage) -> str:
    if row.asked is None:
        return "named by the design"
    return f"nearest to {row.asked:,.0f} h" if row.falls_short else f"lightest for {row.asked:,.0f} h"
