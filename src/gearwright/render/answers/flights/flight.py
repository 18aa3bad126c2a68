"""Answers about flights: what a mission burns and wears, and what a window of it does to every tooth."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from typing import Annotated, Any

from gearwright.dynamics import Trace
from gearwright.dynamics.vibration import DynamicLoad, ShaftLoad
from gearwright.mission import (
    Durability,
    Flight,
    LifeSizing,
    PhaseForces,
    bearing_spectra,
    mesh_spectrum,
    phase_forces,
    phase_summaries,
    shaft_spectrum,
)
from gearwright.mission.flight import Balance, PackWear, PhaseSummary
from gearwright.mission.history import History
from gearwright.mission.lives.spectrum import DutyBin
from gearwright.mission.windows import DynamicWindow
from gearwright.render.answers.review import Factor
from gearwright.render.words.flights.window import Range, ranges
from gearwright.reviews import Review, Verdict
from gearwright.units import Force, Frequency, Life, Mass, Power, Quantity, Ratio, Speed, Time, Torque

_HOUR = 3600.0
_MINUTE = 60.0


@dataclass(frozen=True)
class PartDamage:
    """One part and one way to fail."""

    part: str
    mode: str
    damage: Ratio
    """Miner's sum of one flight."""
    flights: float
    """Until the sum is 1; null where nothing is damaged."""
    life: Life
    """Flight time until then; null where nothing is damaged."""


@dataclass(frozen=True)
class SeatBearing:
    """The bearing of one seat, or of several equal ones."""

    seat: str
    designation: str
    count: int
    mean_load: Force
    """Equivalent load that tires it as the spectrum does."""
    static_safety: Ratio
    life: Life
    """Flight time; null where nothing loads it."""
    mass: Mass
    """Of all of them."""


@dataclass(frozen=True)
class TorqueBin:
    """One class of a duty spectrum of torques."""

    torque: Torque
    """Mean over its turns, without sign: on gear a of one mesh, or inside a shaft."""
    speed: Speed
    """Mean over its time, without sign: of gear a relative to the carrier, or of the shaft."""
    time: Time
    turns: float


@dataclass(frozen=True)
class ForceBin:
    """One class of a duty spectrum of radial forces on a bearing."""

    force: Force
    speed: Speed
    time: Time
    turns: float


@dataclass(frozen=True)
class Spectra:
    """Duty of one flight by classes of load."""

    meshes: Mapping[str, tuple[TorqueBin, ...]]
    shafts: Mapping[str, tuple[TorqueBin, ...]]
    bearings: Mapping[str, tuple[ForceBin, ...]]


@dataclass(frozen=True)
class LifeAnswer:
    """What an asked life costs."""

    asked: Life
    mass: Mass
    """Of gears, shafts and carriers, strengthened."""
    mass_before: Mass
    rounds: int
    """How often a stage was strengthened."""


@dataclass(frozen=True)
class DryAnswer:
    """How long a gearbox runs without oil."""

    lasts: Time
    """Until the first limit; null where none is reached within six hours."""
    part: str
    """What reaches its limit first."""
    gears: Annotated[float, Quantity("absolute_temperature")]
    bearings: Annotated[float, Quantity("absolute_temperature")]


@dataclass(frozen=True)
class FlyAnswer:
    """A flown mission, of one gearbox."""

    mission: str
    verdict: Verdict
    """Of the review of design and mission."""
    worst: str | None
    """Name of the worst check; null where nothing is assessed."""
    margin: Factor
    """Of the worst check."""
    duration: Time
    fuel: Mass
    balance: Balance
    pack: PackWear | None
    """Null for a plain battery, or none."""
    phases: tuple[PhaseSummary, ...]
    forces: tuple[PhaseForces, ...]
    """Of the aircraft, phase by phase; empty where the mission has none."""
    oil_flow: Annotated[float, Quantity("oil_flow")]
    oil_hottest: Annotated[float, Quantity("absolute_temperature")]
    """Behind the gearbox."""
    dry: DryAnswer | None
    """Null where the mission does not ask for it."""
    damage: tuple[PartDamage, ...]
    """The worst first."""
    bearings: tuple[SeatBearing, ...]
    not_rated: tuple[str, ...]
    """What is not rated, and why."""
    spectrum: Spectra
    life: LifeAnswer | None
    """With --life-h alone."""


def fly_answer(flight: Flight, parts: Durability, review: Review, *, life: LifeSizing | None = None) -> FlyAnswer:
    """Return what `gearwright fly --json` answers.

    Args:
        flight: As flown.
        parts: Lives of its gears and bearings.
        review: Of the design with this mission.
        life: How the design was strengthened, if it was.
    """
    worst = review.worst
    return FlyAnswer(
        mission=flight.mission.name,
        verdict=review.verdict,
        worst=None if worst is None else worst.name,
        margin=None if worst is None else worst.margin,
        duration=flight.duration,
        fuel=flight.fuel,
        balance=flight.balance,
        pack=flight.pack,
        phases=phase_summaries(flight),
        forces=phase_forces(flight),
        oil_flow=flight.oil_flow,
        oil_hottest=flight.hottest_oil,
        dry=None if flight.dry is None else DryAnswer(*flight.dry),
        damage=tuple(PartDamage(row.name, row.mode, row.damage, row.flights, row.life * _HOUR) for row in parts.parts),
        bearings=tuple(
            SeatBearing(
                row.seat,
                row.bearing.designation,
                row.count,
                row.mean_load,
                row.static_safety,
                row.life * _HOUR,
                row.mass,
            )
            for row in parts.bearings.rows
        ),
        not_rated=tuple(parts.notes),
        spectrum=_spectra(flight),
        life=None if life is None else LifeAnswer(life.hours * _HOUR, life.sizing.mass, life.mass_before, life.rounds),
    )


def _spectra(flight: Flight) -> Spectra:
    def torques(bins: tuple[DutyBin, ...]) -> tuple[TorqueBin, ...]:
        return tuple(TorqueBin(row.load, row.speed, row.time, row.turns) for row in bins)

    return Spectra(
        {mesh.name: torques(mesh_spectrum(flight, mesh.name)) for mesh in flight.sizing.train.meshes},
        {shaft: torques(shaft_spectrum(flight, shaft)) for shaft in flight.sizing.design.shafts},
        {
            seat: tuple(ForceBin(row.load, row.speed, row.time, row.turns) for row in bins)
            for seat, bins in bearing_spectra(flight).items()
        },
    )


@dataclass(frozen=True)
class Moment:
    """A line of `--jsonl`: one interval of a flight."""

    phase: str
    history: History[float]
    """Air, propeller, machines, battery and losses."""
    oil_outlet: Annotated[float, Quantity("absolute_temperature")]
    """Behind the gearbox."""
    speed: Mapping[str, Speed]
    """Of shafts, and of the planets of stages."""
    torque: Mapping[str, Torque]
    """That they transmit."""
    power: Mapping[str, Power]
    """Of machines, into the train."""
    force: Mapping[str, Force]
    """Tangential, of one mesh of each row."""


def moments(flight: Flight) -> Iterator[Moment]:
    """Yield a flight interval by interval.

    Args:
        flight: As flown.
    """
    columns = {field.name: getattr(flight.history, field.name) for field in fields(History)}
    for k, phase in enumerate(flight.phase):
        now: dict[str, Any] = {name: None if values is None else float(values[k]) for name, values in columns.items()}
        yield Moment(
            phase,
            History(**now),
            float(flight.oil_outlet[k]),
            {name: float(node.speed[k]) for name, node in flight.nodes.items()},
            {name: float(node.torque[k]) for name, node in flight.nodes.items()},
            {name: float(machine.power[k]) for name, machine in flight.machines.items()},
            {name: float(mesh.force[k]) for name, mesh in flight.meshes.items()},
        )


@dataclass(frozen=True)
class GovernorCycle:
    """An oscillation that the governor sustains by itself."""

    frequency: Frequency
    amplitude: Speed
    """Of the propeller's speed, half of its swing."""


@dataclass(frozen=True)
class WindowAnswer:
    """Seconds of a mission with propeller, governor and machines on the elastic train."""

    window: str
    phase: str
    event: str
    start: Time
    """From the start of the mission."""
    duration: Time
    step: Time
    error: Ratio
    """Measured, of the peaks of line forces."""
    rms_error: Ratio
    """And of their root mean squares."""
    energy_imbalance: Ratio
    limit_cycle: GovernorCycle | None
    """Null where the governor comes to rest."""
    rest: Time | None
    """When a sudden stop has come to rest, from the window's start; null where it has not, and for other events."""
    ranges: tuple[Range, ...]
    """What speeds, torques, pitch and line forces did, in the unit of each."""
    meshes: tuple[DynamicLoad, ...]
    """Peak of every mesh row beside what it is sized for, the worst first."""
    shafts: tuple[ShaftLoad, ...]
    """Peak of every shaft beside what it is sized for, the worst first."""
    notes: tuple[str, ...]


def window_answer(window: DynamicWindow) -> WindowAnswer:
    """Return what `gearwright window --json` answers.

    Args:
        window: As flown.
    """
    trace: Trace = window.trace
    cycle = window.limit_cycle
    return WindowAnswer(
        window=window.name,
        phase=window.rules.phase,
        event=window.rules.event,
        start=window.start,
        duration=trace.duration,
        step=trace.step,
        error=trace.error,
        rms_error=trace.rms_error,
        energy_imbalance=trace.work.imbalance,
        limit_cycle=None if cycle is None else GovernorCycle(cycle.frequency, cycle.amplitude),
        rest=window.rest,
        ranges=ranges(window),
        meshes=window.meshes,
        shafts=window.shafts,
        notes=tuple(trace.notes),
    )
