"""Tables of what flies: phases, losses, lives of parts, mixes, duties, propellers, rotors, turboshafts."""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, fields
from types import MappingProxyType
from typing import Annotated

import numpy as np

from gearwright.base import (
    CELSIUS,
    FOOT,
    KNOT,
    NAUTICAL_MILE,
    Distance,
    Life,
    Mass,
    Number,
    Origin,
    Power,
    Quantity,
    Ratio,
    Speed,
    Time,
    Torque,
    largest,
    marks_of,
)
from gearwright.catalogue import EngineTransient, MadeEngine, MadePropeller, RotorTrim
from gearwright.mission import (
    Balance,
    BearingDamage,
    Durability,
    DutySpectrum,
    Flight,
    FlownMix,
    PartLife,
    PhaseSummary,
    phase_forces,
    phase_summaries,
)
from gearwright.mission.lives import ENDLESS, USUAL_RELIABILITY, bearings_of
from gearwright.parts.shaft_fatigue import LoadCycle, Residue
from gearwright.render.grid import Table, table
from gearwright.spec import Phase

# ----------------------------------------------------------------------------------------------------------------------
# Tables of a flight's page: phases, losses by kind, lives of parts, bearings.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Tables of a life of several missions: what each flies and eats, and how long parts live.
# ----------------------------------------------------------------------------------------------------------------------


MOST_PARTS = 12
"""Parts that are shown in words [-]."""
HOUR = 3600.0


@dataclass(frozen=True)
class MissionOfMix:
    """One mission of a life."""

    name: str
    mission: str
    """Name of what is flown."""
    share: Ratio
    """Part of all flights."""
    flights: float
    """In the life."""
    flight_time: Annotated[float, Quantity("flight_time")]
    """Of one flight."""
    fuel: Mass
    """Of one flight and one gearbox."""
    from_battery: Annotated[float, Quantity("electric_energy")]
    """Of one flight and one gearbox."""
    alone: float
    """Flights until the first part fails, were it flown alone; null where nothing is damaged."""
    eats: Ratio
    """Its part of the damage of the part that governs the mix."""


@dataclass(frozen=True)
class PartOfMix:
    """One part and one way to fail, over a life of several missions."""

    part: str
    mode: str
    bearing: str | None
    """Designation; null for gears."""
    damage: Annotated[Ratio, Origin("D = N Σ s_i D_i", "Palmgren 1924, Miner 1945")]
    """Miner's sum after all flights; it fails at 1."""
    flights: float
    """Of the mix until then; null where nothing is damaged."""
    flight_hours: Life
    """Flight time until then; null where nothing is damaged."""
    worst: str
    """Mission with the largest part of the damage."""
    worst_share: Ratio
    """That part."""


def mission_rows(flown: FlownMix) -> tuple[MissionOfMix, ...]:
    """Return the missions of a life.

    Args:
        flown: As flown.
    """
    eaten = shares_of_damage(flown, flown.life.parts[0]) if flown.life.parts else {}
    rows = []
    for name, flight in flown.flights.items():
        parts = flown.lives[name].parts
        rows.append(
            MissionOfMix(
                name=name,
                mission=flight.mission.name,
                share=flown.mix.shares[name],
                flights=flown.mix.count(name),
                flight_time=flight.duration,
                fuel=flight.fuel,
                from_battery=flight.balance.battery,
                alone=parts[0].flights if parts else float("inf"),
                eats=eaten.get(name, 0.0),
            )
        )
    return tuple(rows)


def part_rows(flown: FlownMix) -> tuple[PartOfMix, ...]:
    """Return the parts of a life, the one that governs first.

    Args:
        flown: As flown.
    """
    bearings, rows = bearings_of(flown), []
    for part in flown.life.parts:
        shares = shares_of_damage(flown, part)
        worst = largest(shares, shares.__getitem__)
        rows.append(
            PartOfMix(
                part=part.part,
                mode=part.mode,
                bearing=bearings.get(part.part) if part.is_bearing else None,
                damage=part.damage * flown.mix.flights,
                flights=part.flights,
                flight_hours=part.life * HOUR,
                worst=worst if part.damage else "",
                worst_share=shares[worst],
            )
        )
    return tuple(rows)


def shares_of_damage(flown: FlownMix, part: PartLife) -> dict[str, float]:
    """Return mission -> its part of the damage of a part [-]; what is damaged without bound shares it equally.

    Args:
        flown: As flown.
        part: One of the parts of its life.
    """
    damages = flown.damage_by_mission(part)
    endless = [name for name, damage in damages.items() if damage == float("inf")]
    if endless:
        return {name: (name in endless) / len(endless) for name in damages}
    whole = sum(damages.values())
    return {name: damage / whole if whole else 0.0 for name, damage in damages.items()}


def mission_table(flown: FlownMix) -> Table:
    """Return what each mission of a life flies, burns and eats.

    Args:
        flown: As flown.
    """
    names = ("name", "flights", "flight_time", "fuel", "from_battery", "alone", "eats")
    note = (
        "Fuel and energy from the battery are of one flight and one gearbox; alone: flights until the first part fails"
        " if nothing else is flown; eats: its part of the damage of the part that fails first."
    )
    return table("Missions", mission_rows(flown), names, note=note)


def part_table(flown: FlownMix) -> Table:
    """Return how long parts live, the one that governs first.

    Args:
        flown: As flown.
    """
    failing = [row for row in part_rows(flown) if row.flights < ENDLESS]
    more = len(flown.life.parts) - len(failing[:MOST_PARTS])
    note = f"{more} other ways to fail take longer." if more else ""
    names = ("part", "mode", "damage", "flights", "flight_hours", "worst", "worst_share")
    return table("Lives over the mix", failing[:MOST_PARTS], names, note=note)


# ----------------------------------------------------------------------------------------------------------------------
# Table of a measured duty: its classes of torque.
# ----------------------------------------------------------------------------------------------------------------------


RULE = (
    "Classes of equal width from 0 to the largest torque, without sign; each counts with its upper end"
    " (ISO 6336-6), and empty ones are left out"
)
"""How a duty is counted."""
MOST_CYCLES = 20
"""Cycles that are shown on the screen [-]."""
RESIDUES: Mapping[Residue, str] = MappingProxyType({
    "half-cycles": "Rainflow by ASTM E1049-85, 5.4.4: each range of what closes no loop is half a cycle",
    "repeated": "Rainflow by ASTM E1049-85, 5.4.5: the record repeats, from its largest torque on",
})  # fmt: skip
"""Rule of the residue -> in words."""


@dataclass(frozen=True)
class DutyClass:
    """One class of a measured duty."""

    number: int
    torque: Torque
    """Its upper end, without sign."""
    speed: Speed
    """Mean over its time, without sign."""
    time: Time
    share: Annotated[Ratio, Origin("t_i/Σ t", "time at level")]
    """Of the time."""
    turns: Annotated[float, Quantity("number"), Origin("n_i t_i", "revolutions")]
    """Revolutions of the shaft."""


def duty_classes(spectrum: DutySpectrum) -> Iterator[DutyClass]:
    """Yield the classes of a duty, the smallest torque first.

    Args:
        spectrum: As counted.
    """
    for k, (torque, speed, share) in enumerate(zip(spectrum.torque, spectrum.speed, spectrum.share, strict=True), 1):
        time = float(share) * spectrum.time
        yield DutyClass(k, float(torque), float(speed), time, float(share), float(speed) * time / (2.0 * math.pi))


@dataclass(frozen=True)
class TorqueCycle:
    """Cycles of torque of one size."""

    range: Torque
    """From the smallest to the largest torque of the cycle."""
    mean: Torque
    """Half of both."""
    cycles: Annotated[float, Quantity("number"), Origin("rainflow", "ASTM E1049-85")]
    """Half ones count as 0.5."""


def cycle_rows(cycles: Iterable[LoadCycle]) -> tuple[TorqueCycle, ...]:
    """Return cycles of torque as rows, the largest range first.

    Args:
        cycles: As counted.
    """
    return tuple(TorqueCycle(float(cycle.range), float(cycle.mean), cycle.count) for cycle in cycles)


def cycle_table(cycles: Iterable[LoadCycle], residue: Residue) -> Table:
    """Return the largest cycles of torque of a duty.

    Args:
        cycles: As counted.
        residue: By which rule.
    """
    rows = cycle_rows(cycles)
    more = f" {len(rows) - MOST_CYCLES} smaller ones are not shown." if len(rows) > MOST_CYCLES else ""
    return table(
        "Cycles of torque", rows[:MOST_CYCLES], ("range", "mean", "cycles"), note=f"{RESIDUES[residue]}.{more}"
    )


def duty_table(spectrum: DutySpectrum) -> Table:
    """Return the classes of a duty.

    Args:
        spectrum: As counted.
    """
    rows = list(duty_classes(spectrum))
    return table("Measured duty", rows, ("number", "torque", "speed", "time", "share", "turns"), note=f"{RULE}.")


# ----------------------------------------------------------------------------------------------------------------------
# Table of a made propeller map: what stands out at every advance ratio.
# ----------------------------------------------------------------------------------------------------------------------


FIELDS = (
    "advance_ratio", "best_angle", "power_coefficient", "thrust_coefficient", "efficiency", "windmilling_angle",
    "windmilling_thrust",
)  # fmt: skip
MOST_RATIOS = 21
"""Rows of a table; of more advance ratios every second, third … is shown."""


def propeller_table(made: MadePropeller) -> Table:
    """Return the best and the windmilling blade angle over the advance ratio, at the first Mach number of the map.

    Args:
        made: The map.
    """
    first = made.maps[0][0]
    rows = [row for row in made.rows if row.tip_mach == first]
    step = -(-len(rows) // MOST_RATIOS)
    title = f"Propeller at tip Mach {first:g}" if first else "Propeller without compressibility"
    return table(title, rows[::step], FIELDS, note=NOTE)


NOTE = (
    "Best: of efficiency, at standstill of C_T^1.5/C_P, among the map's blade angles; idle: where the blades windmill"
    " and take no power."
)
"""What the columns mean."""


# ----------------------------------------------------------------------------------------------------------------------
# Tables of a helicopter's rotors over its speed: thrust and stream, and where the power goes.
# ----------------------------------------------------------------------------------------------------------------------


THRUST = ("airspeed", "advance_ratio", "thrust", "loading", "tilt", "induced_velocity", "tail_thrust")
POWER = ("airspeed", "induced", "profile", "parasite", "climb", "power", "tail_power", "total", "torque")
OF_TAIL = {"tail_thrust", "tail_power"}
"""Columns that nothing stands in without a tail rotor."""


def rotor_tables(found: RotorTrim) -> tuple[Table, Table]:
    """Return what the rotors lift, and what they take.

    Args:
        found: Over the speed.
    """
    without = OF_TAIL if found.helicopter.tail is None else set[str]()
    thrust, power = ([name for name in fields if name not in without] for fields in (THRUST, POWER))
    return table("Rotors", found.rows, thrust), table("Their power", found.rows, power)


# ----------------------------------------------------------------------------------------------------------------------
# Tables of a turboshaft engine: its deck, and seconds of it.
# ----------------------------------------------------------------------------------------------------------------------


DECK = (
    "altitude", "mach", "power", "part", "fuel_flow", "consumption", "gas_generator", "between", "pressure_ratio",
)  # fmt: skip
SECONDS = ("time", "gas_generator", "rotor", "power", "fuel_flow", "between")
MIDDLE = 0.4
"""Part of the highest power that is shown beside it [-]."""
TITLES = {"slam": "Lever", "held rotor": "Rotor held by a governor on N2", "start": "Start; P is the starter's"}
"""Kind of a transient -> title of its table."""


def deck_table(made: MadeEngine) -> Table:
    """Return an engine's highest and a middle power at every place of its deck.

    Args:
        made: The engine.
    """
    parts = sorted({row.part for row in made.rows})
    shown = {parts[-1], min(parts, key=lambda part: abs(part - MIDDLE))}
    return table("Deck", [row for row in made.rows if row.part in shown], list(DECK))


def transient_table(found: EngineTransient) -> Table:
    """Return seconds of an engine.

    Args:
        found: As computed.
    """
    without = {"rotor"} if found.lowest_rotor is None else set[str]()
    return table(TITLES[found.kind], found.rows, [name for name in SECONDS if name not in without])
