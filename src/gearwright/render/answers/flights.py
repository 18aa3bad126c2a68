"""Answers about what flies: missions, mixes of them, measured duties, propellers, engines.

How a record becomes JSON is in `plain` and `described`.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from typing import Annotated, Any

from gearwright.base import Angle, Force, Frequency, Life, Mass, Power, Quantity, Ratio, Speed, Time, Torque
from gearwright.catalogue import (
    DeckRow,
    DesignPoint,
    EngineTransient,
    MadeEngine,
    MadePropeller,
    MissionKeys,
    PropellerLoads,
    RatioRow,
)
from gearwright.dynamics import Trace
from gearwright.dynamics.vibration import DynamicLoad, ShaftLoad
from gearwright.machines.propellers import activity_factor, integrated_lift
from gearwright.mission import (
    Balance,
    Durability,
    DutySpectrum,
    Flight,
    FlownMix,
    History,
    LifeSizing,
    MeasuredDuty,
    PackWear,
    PhaseForces,
    PhaseSummary,
    bearing_spectra,
    mesh_spectrum,
    phase_forces,
    phase_summaries,
    shaft_spectrum,
)
from gearwright.mission.lives import DutyBin, torque_cycles
from gearwright.mission.windows import DynamicWindow
from gearwright.parts.shaft_fatigue import Residue
from gearwright.render.answers.review import Factor
from gearwright.render.tables.flights import (
    RESIDUES,
    RULE,
    DutyClass,
    MissionOfMix,
    PartOfMix,
    TorqueCycle,
    cycle_rows,
    duty_classes,
    mission_rows,
    part_rows,
)
from gearwright.render.words.flights import Range, duty_notes as notes, not_rated, ranges, verdict, work
from gearwright.reviews import Review, Verdict

# ----------------------------------------------------------------------------------------------------------------------
# Answers about flights: what a mission burns and wears, and what a window of it does to every tooth.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Answer about a life of several missions.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class MixAnswer:
    """A life of several missions, of one gearbox."""

    mix: str
    verdict: str
    """In words."""
    flights: int
    """Of the whole life."""
    life: Life
    """Flight time of all flights."""
    fuel: Mass
    """Of all flights."""
    from_battery: Annotated[float, Quantity("electric_energy")]
    """Of all flights, what is charged in flight taken off."""
    damage: Ratio
    """Largest Miner's sum of any part after all flights; it fails at 1."""
    missions: tuple[MissionOfMix, ...]
    parts: tuple[PartOfMix, ...]
    """The one that governs first."""
    damage_by_mission: Mapping[str, Mapping[str, Ratio]]
    """Part and way to fail -> mission -> Miner's sum after all its flights."""
    not_rated: tuple[str, ...]
    """What is not rated in some mission or falls short there, and why."""


def mix_answer(flown: FlownMix) -> MixAnswer:
    """Return what `gearwright mix --json` answers.

    Args:
        flown: As flown.
    """
    return MixAnswer(
        mix=flown.mix.name,
        verdict=verdict(flown),
        flights=flown.mix.flights,
        life=flown.duration,
        fuel=flown.fuel,
        from_battery=flown.battery,
        damage=flown.damage,
        missions=mission_rows(flown),
        parts=part_rows(flown),
        damage_by_mission={f"{part.name}, {part.mode}": flown.damage_by_mission(part) for part in flown.life.parts},
        not_rated=tuple(not_rated(flown)),
    )


# ----------------------------------------------------------------------------------------------------------------------
# Answer about a measured duty: its classes, and the lines for a design file.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class DutyAnswer:
    """A measured duty as a load spectrum."""

    rows_read: int
    """Of the file, without the last, which only ends the one before."""
    duration: Time
    largest_torque: Torque
    """Without sign."""
    mean_speed: Speed
    """Over the whole time, without sign."""
    work: Annotated[float, Quantity("electric_energy")]
    """That in the other direction taken off."""
    lowest_temperature: Annotated[float | None, Quantity("absolute_temperature")]
    """Null where none was measured; temperatures are not used."""
    highest_temperature: Annotated[float | None, Quantity("absolute_temperature")]
    rule: str
    """How classes are counted."""
    classes: tuple[DutyClass, ...]
    """The smallest torque first."""
    text: str
    """Load case and spectrum as a design file has them; shares are parts of the revolutions."""
    notes: tuple[str, ...]
    residue: str | None
    """Rule by which cycles were counted; null where none were asked for."""
    cycles: tuple[TorqueCycle, ...]
    """Of torque, by rainflow, the largest range first; empty where none were asked for."""


def duty_answer(duty: MeasuredDuty, spectrum: DutySpectrum, text: str, residue: Residue | None = None) -> DutyAnswer:
    """Return what `gearwright duty --json` answers.

    Args:
        duty: As read.
        spectrum: Its classes.
        text: Lines for a design file.
        residue: Rule by which cycles of torque are counted; None: they are not.
    """
    temperature = duty.temperature
    return DutyAnswer(
        rows_read=len(duty.time),
        duration=spectrum.time,
        largest_torque=float(abs(duty.torque).max()),
        mean_speed=float((spectrum.speed * spectrum.share).sum()),
        work=work(duty),
        lowest_temperature=None if temperature is None else float(temperature.min()),
        highest_temperature=None if temperature is None else float(temperature.max()),
        rule=RULE,
        classes=tuple(duty_classes(spectrum)),
        text=text,
        notes=tuple(notes(duty)),
        residue=residue and RESIDUES[residue],
        cycles=() if residue is None else cycle_rows(torque_cycles(duty, residue=residue)),
    )


# ----------------------------------------------------------------------------------------------------------------------
# Answer about a made propeller: its blades, every advance ratio, and a point of flight; its rows are the map.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class MapPoint:
    """One point of a map."""

    tip_mach: Ratio
    """0: without compressibility."""
    advance_ratio: Ratio
    blade_angle: Angle
    power_coefficient: Annotated[float, Quantity("number")]
    thrust_coefficient: Annotated[float, Quantity("number")]


@dataclass(frozen=True)
class PropellerAnswer:
    """A made propeller."""

    by: str
    """``elements`` or ``charts``."""
    blades: int | None
    """Of the elements; null of the charts."""
    activity_factor: Annotated[float | None, Quantity("number")]
    design_lift: Annotated[float | None, Quantity("number")]
    """Integrated."""
    feather_angle: Annotated[float | None, Quantity("angle")]
    """Blade angle at which it stands still; null of charts."""
    feather_drag: Annotated[float | None, Quantity("number")]
    """Drag there over dynamic pressure and D²."""
    advance_ratios: tuple[RatioRow, ...]
    """What stands out at each."""
    flight: PropellerLoads | None
    """Null where no point of flight is asked for."""
    rows: tuple[MapPoint, ...]
    """The whole map."""


def map_points(made: MadePropeller) -> Iterator[MapPoint]:
    """Yield every point of a map.

    Args:
        made: The map.
    """
    for mach, chart in made.maps:
        for row, ratio in enumerate(chart.advance_ratio):
            for column in range(int(chart.first[row]), int(chart.last[row]) + 1):
                power, thrust = float(chart.power[row, column]), float(chart.thrust[row, column])
                yield MapPoint(mach, float(ratio), float(chart.blade_angle[column]), power, thrust)


def propeller_answer(made: MadePropeller, flight: PropellerLoads | None) -> PropellerAnswer:
    """Return what `gearwright propeller --json` answers.

    Args:
        made: The map.
        flight: Loads at a point of flight, if there is one.
    """
    shape, feather = made.blades, made.feather
    return PropellerAnswer(
        by=made.by,
        blades=shape.number if shape else None,
        activity_factor=activity_factor(shape) if shape else None,
        design_lift=integrated_lift(shape) if shape else None,
        feather_angle=feather.angle if feather else None,
        feather_drag=feather.drag_area if feather else None,
        advance_ratios=made.rows,
        flight=flight,
        rows=tuple(map_points(made)),
    )


# ----------------------------------------------------------------------------------------------------------------------
# Answer about a turboshaft engine: its deck, and seconds of it where they are asked for; its rows are the deck.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class TurboshaftAnswer:
    """A turboshaft engine."""

    engine: DesignPoint
    power_turbine: Ratio
    """Isentropic efficiency that the design point implies."""
    hottest: Annotated[float, Quantity("absolute_temperature")]
    """T_45 of the design point."""
    keys: MissionKeys
    """What a mission's [engine] says of it without a deck."""
    slam: EngineTransient | None
    """Null where none is asked for."""
    start: EngineTransient | None
    """The same."""
    rows: tuple[DeckRow, ...]
    """The deck."""


def turboshaft_answer(
    made: MadeEngine, slam: EngineTransient | None, start: EngineTransient | None
) -> TurboshaftAnswer:
    """Return what `gearwright turboshaft --json` answers.

    Args:
        made: The engine.
        slam: Of its lever or rotor.
        start: From rest.
    """
    return TurboshaftAnswer(made.design, made.power_turbine, made.hottest, made.keys, slam, start, made.rows)
