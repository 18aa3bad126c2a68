"""Load spectra of a flight, Miner sum of flanks and roots, scuffing and micropitting."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.base import (
    CELSIUS,
    Check,
    DesignError,
    Floats,
    Ints,
    PartId,
    Problem,
    Ratio,
    Role,
    by_name,
    largest_first,
    verb,
)
from gearwright.mission.flight import Flight
from gearwright.mission.lives.bearings import seat_duties
from gearwright.sizing import Sizing, made_of, rating_as_sized
from gearwright.sizing.rating import (
    Ask,
    Damage,
    Load,
    LoadedMesh,
    MeshSpectrum,
    Rating,
    method_for,
    reverse_parts,
    row_ask,
)
from gearwright.spec import Design, GearLifeRules
from gearwright.train import Gear, Mesh

# ----------------------------------------------------------------------------------------------------------------------
# The duty spectrum of a flight: turns and time against load for every mesh, shaft and bearing.
# ----------------------------------------------------------------------------------------------------------------------


CLASSES = 40
"""Load classes between nothing and the greatest load [-]."""


@dataclass(frozen=True)
class DutyBin:
    """One class of a spectrum."""

    load: float
    """Mean over its turns, without sign: torque on gear a of one mesh or inside a shaft [N m], radial force [N]."""
    speed: float
    """Mean over its time, without sign: of gear a relative to the carrier, of the shaft, or of the bearing [rad/s]."""
    time: float
    """[s]"""
    turns: float
    """Revolutions, of the same [-]."""


@verb
def mesh_spectrum(flight: Flight, mesh: str, *, classes: int = CLASSES) -> tuple[DutyBin, ...]:
    """Return the spectrum of one mesh.

    Args:
        flight: As flown.
        mesh: Name of its row, such as ``first.sun-planet``.
        classes: Number of load classes [-].
    """
    row = by_name(mesh, {candidate.name: candidate for candidate in flight.sizing.train.meshes}, "mesh")
    rolling = flight.speed(row.nodes[0]) - flight.speed(row.nodes[2])
    return _binned(flight, flight.meshes[mesh].torque, rolling, classes)


@verb
def shaft_spectrum(flight: Flight, shaft: str, *, classes: int = CLASSES) -> tuple[DutyBin, ...]:
    """Return the spectrum of one shaft.

    Args:
        flight: As flown.
        shaft: Its name.
        classes: Number of load classes [-].
    """
    node = by_name(shaft, flight.nodes, "shaft")
    return _binned(flight, node.torque, node.speed, classes)


@verb
def bearing_spectra(flight: Flight, *, classes: int = CLASSES) -> dict[str, tuple[DutyBin, ...]]:
    """Return the spectrum of the radial force in every bearing seat, by the seat's name.

    Args:
        flight: As flown.
        classes: Number of load classes [-].
    """
    return {seat.name: _binned(flight, duty.radial, duty.speed, classes) for seat, duty in seat_duties(flight)}


class Classed(NamedTuple):
    """Spectra of several flights; every array has a row for each flight and a column for each class."""

    load: Floats
    """Mean over its turns, without sign; over its time where there are none."""
    speed: Floats
    """Mean over its time, without sign [rad/s]."""
    time: Floats
    """[s]; 0 in empty classes."""
    turns: Floats
    """[-]"""

    def bins(self, flight: int) -> list[DutyBin]:
        """Return the classes of one flight that are not empty.

        Args:
            flight: Its number.
        """
        columns = (column[flight] for column in self)
        return [DutyBin(*row) for row in zip(*(column.tolist() for column in columns), strict=True) if row[2] > 0.0]


def classed(loads: Sequence[Floats], speeds: Sequence[Floats], times: Sequence[Floats], classes: int) -> Classed:
    """Sum what falls into each class of equal width, between nothing and the greatest load of each flight.

    Args:
        loads: Of every flight, shape (intervals,); signs do not count.
        speeds: As the loads [rad/s].
        times: Duration of every interval [s].
        classes: Number of load classes [-].
    """
    count = len(loads)
    load, speed, time = (np.concatenate(columns) for columns in (loads, speeds, times))
    load, speed = np.abs(load), np.abs(speed)
    owner = np.repeat(np.arange(count), [len(one) for one in loads])
    top = np.array([float(np.abs(one).max()) or 1.0 for one in loads])[owner]
    place = owner * classes + np.minimum((load / top * classes).astype(int), classes - 1)

    def summed(values: Floats) -> Floats:
        return np.asarray(np.bincount(place, values, count * classes).reshape(count, classes), dtype=float)

    turns = speed * time / (2.0 * np.pi)
    whole, total = summed(time), summed(turns)
    with np.errstate(invalid="ignore"):  # empty classes
        by_turns, by_time = summed(load * turns) / total, summed(load * time) / whole
        mean = summed(speed * time) / whole
    return Classed(np.where(total > 0.0, by_turns, by_time), mean, whole, total)


def _binned(flight: Flight, load: Floats, speed: Floats, classes: int) -> tuple[DutyBin, ...]:
    return tuple(classed([load], [speed], [flight.history.duration], classes).bins(0))


# ----------------------------------------------------------------------------------------------------------------------
# What a flight does to the gears: Miner's sum of flanks and roots by the method of each stage.
# ----------------------------------------------------------------------------------------------------------------------


PITTING, BENDING = "pitting", "bending"
_LEAST_TORQUE = 1e-3
"""Load below which a bin does no damage [N m]."""


@dataclass(frozen=True)
class GearDamage:
    """One gear and one way to fail."""

    part: PartId
    """Such as the sun of a stage."""
    mode: str
    """``pitting`` or ``bending``."""
    damage: Ratio
    """Miner's sum of one flight [-]."""
    hours: float
    """Of the flight [h]."""

    @property
    def gear(self) -> str:
        """Its label, such as ``first.sun``."""
        return str(self.part)

    @property
    def flights(self) -> float:
        """Flights until the sum is 1; ∞ where nothing is damaged [-]."""
        return 1.0 / self.damage if self.damage > 0.0 else math.inf

    @property
    def life(self) -> float:
        """Flight hours until then [h]."""
        return self.flights * self.hours


@verb
def gear_damage(flight: Flight) -> tuple[GearDamage, ...]:
    """Return the damage of every gear in pitting and bending, the worst first.

    Args:
        flight: As flown; its mission names the steel of gears whose method knows no life (Lewis and Hertz).

    Source: Miner 1945, with the stresses and the S-N curves of each stage's method in each class of the spectrum (ISO
        6336-6:2019, clause 5; AGMA 2001-D04, clause 17), K_A = 1.
        Several meshes on the same flank add up; a planet's two meshes load two flanks, and the worse one counts.

    Raises:
        DesignError: Teeth that the method does not cover; with the mesh.

    Valid for: cylindrical and bevel gears (ISO 10300 rates the latter); those of `unrated_stages` are left out.
    """
    (found,) = gear_damages([flight])
    if isinstance(found, DesignError):
        raise found
    return found


@verb
def gear_damages(flights: Sequence[Flight]) -> list[tuple[GearDamage, ...] | DesignError]:
    """Return the damage of the gears for each of many flights, with the bits that it has alone.

    Args:
        flights: Of one gearbox.

    Source: `gear_damage`.
    """
    try:
        return list(_damages(flights))
    except DesignError as error:
        return [error] if len(flights) == 1 else [found for flight in flights for found in gear_damages([flight])]


def _damages(flights: Sequence[Flight]) -> list[tuple[GearDamage, ...]]:
    """Return the damage of the gears for each of many flights, all of which can be rated."""
    if not flights:
        return []
    train, unrated = flights[0].sizing.train, unrated_stages(flights[0].sizing.design)
    sums: list[dict[tuple[str, str], list[float]]] = [{} for _ in flights]
    loads = [extremes(flight) for flight in flights]
    for mesh in train.meshes:
        if mesh.stage in unrated:
            continue
        try:
            damages = _mesh_damages(flights, mesh, loads)
        except DesignError as error:
            raise DesignError([Problem(mesh.name, problem.message) for problem in error.problems]) from None
        for by_gear, both in zip(sums, damages, strict=True):
            for gear, modes in zip(mesh.gears, both, strict=True):
                for mode, damage in zip((PITTING, BENDING), modes, strict=True):
                    by_gear.setdefault((gear, mode), []).append(damage)
    return [_worst_first(flight, by_gear) for flight, by_gear in zip(flights, sums, strict=True)]


def _worst_first(flight: Flight, sums: Mapping[tuple[str, str], Sequence[float]]) -> tuple[GearDamage, ...]:
    hours, train = flight.duration / 3600.0, flight.sizing.train
    rows = [
        GearDamage(train.gear(gear).part, mode, _joined(train.gear(gear), parts), hours)
        for (gear, mode), parts in sums.items()
    ]
    return tuple(largest_first(rows, lambda row: row.damage))


@verb
def unrated_stages(design: Design) -> tuple[str, ...]:
    """Return the stages whose gears have no damage here: face gears, which no standard rates.

    Args:
        design: As read.
    """
    return tuple(name for name, pair in design.pairs.items() if pair.kind == "face")


def _joined(gear: Gear, parts: Sequence[float]) -> float:
    return max(parts) if gear.role is Role.PLANET else sum(parts)


def extremes(flight: Flight) -> dict[str, tuple[float, float]]:
    """Return mesh row -> least and greatest torque on its first gear [N m].

    Args:
        flight: As flown.
    """
    return {name: (float(mesh.torque.min()), float(mesh.torque.max())) for name, mesh in flight.meshes.items()}


def _mesh_damages(
    flights: Sequence[Flight], mesh: Mesh, loads: Sequence[Mapping[str, tuple[float, float]]]
) -> list[tuple[Damage, Damage]]:
    """Return what each flight does to gear a and gear b of a mesh, in pitting and bending.

    Flights with the same steel, whose teeth are loaded on the same flanks, are rated together, class by class.
    """
    sizing = flights[0].sizing
    rolling = [flight.speed(mesh.nodes[0]) - flight.speed(mesh.nodes[2]) for flight in flights]
    torques = [flight.meshes[mesh.name].torque for flight in flights]
    spectra = classed(torques, rolling, [flight.history.duration for flight in flights], CLASSES)
    counts = damaging(spectra)
    damages: list[tuple[Damage, Damage]] = [(Damage(0.0, 0.0), Damage(0.0, 0.0))] * len(flights)
    for ask, steel, members in alike(flights, mesh, loads, [bool(row.any()) for row in counts]):
        kept = counts[members]
        load, speed, turns = (column[members][kept] for column in (spectra.load, spectra.speed, spectra.turns))
        spectrum = spectrum_of(sizing, mesh, ask, steel, load=load, speed=speed, turns=turns)
        both = method_for(spectrum.rating).damage(spectrum)
        ends = np.cumsum(kept.sum(axis=1)).tolist()
        for flight, start, end in zip(members, [0, *ends], ends, strict=False):
            damages[flight] = (both[0].within(start, end), both[1].within(start, end))
    return damages


def damaging(spectra: Classed) -> NDArray[np.bool_]:
    """Return which classes load a tooth at all, shape (flights, classes).

    Args:
        spectra: Of a mesh.
    """
    return np.asarray((spectra.load > _LEAST_TORQUE) & (spectra.turns > 0.0))


def spectrum_of(
    sizing: Sizing, mesh: Mesh, ask: Ask, steel: GearLifeRules, *, load: Floats, speed: Floats, turns: Floats
) -> MeshSpectrum:
    """Return what loads ask of a mesh, K_A = 1.

    Args:
        sizing: As sized.
        mesh: Row of it.
        ask: Of its teeth.
        steel: Of the mission.
        load: Torques on the first gear, of one mesh [N m].
        speed: Of the first gear against the carrier at each [rad/s].
        turns: Of it at each [-].
    """
    rating = rating_as_sized(sizing, mesh.stage).of_mesh(mesh)
    gears = [gear for name in mesh.gears for gear in sizing.gears if gear.name == name]
    return MeshSpectrum(
        rating=replace(rating, service=rating.service.model_copy(update={"application_factor": 1.0})),
        ask=ask,
        module=gears[0].module,
        face_width=min(gear.face_width for gear in gears),
        torques=(load * rating.load_factor).tolist(),
        speeds=speed.tolist(),
        turns=turns.tolist(),
        steel=steel,
    )


def alike(
    flights: Sequence[Flight], mesh: Mesh, loads: Sequence[Mapping[str, tuple[float, float]]], loaded: Sequence[bool]
) -> list[tuple[Ask, GearLifeRules, list[int]]]:
    """Return which flights that load a mesh ask the same of it, of gears of the same steel.

    Args:
        flights: Of one gearbox.
        mesh: Row of it.
        loads: `extremes` of each flight.
        loaded: Which of them load it.
    """
    groups: list[tuple[Ask, GearLifeRules, list[int]]] = []
    for k, flight in enumerate(flights):
        if not loaded[k]:
            continue
        train, steel = flight.sizing.train, flight.mission.gears
        ask = row_ask(train, flight.sizing.teeth, mesh, loads[k], flight.sizing.design)
        sized = next(row for row in flight.sizing.meshes if row.name == mesh.name)
        ask = ask._replace(reverse=reverse_parts(train, mesh, loads[k]), made=made_of(sized))
        members = next((found for same, made, found in groups if same == ask and made == steel), None)
        if members is None:
            groups.append((ask, steel, [k]))
        else:
            members.append(k)
    return groups


# ----------------------------------------------------------------------------------------------------------------------
# Loads of a flight beside the load changes that teeth bear at each: the spectrum, the S-N curve and Miner's parts.
# ----------------------------------------------------------------------------------------------------------------------


LADDER = np.geomspace(0.1, 4.0, 61)
"""Loads of an S-N curve over the greatest of the flight [-]."""


@dataclass(frozen=True, eq=False)
class LoadLife:
    """One gear in one mesh, and one way to fail."""

    part: PartId
    """Such as the sun of a stage."""
    mesh: str
    """Whose flank it is, such as ``first.sun-planet``."""
    mode: str
    """``pitting`` or ``bending``."""
    force: Floats
    """Tangential force of one mesh in each class of the spectrum [N], shape (classes,)."""
    changes: Floats
    """Load changes of a tooth in each class in one flight [-], shape (classes,)."""
    damage: Floats
    """Miner's part of each class in one flight [-], shape (classes,)."""
    ladder: Floats
    """Forces of the S-N curve, rising [N], shape (steps,)."""
    borne: Floats
    """Load changes that the tooth bears at each; ∞ where it bears any number [-], shape (steps,)."""

    @property
    def total(self) -> float:
        """Miner's sum of one flight [-]."""
        return float(self.damage.sum())


@verb
def load_lives(flight: Flight) -> tuple[LoadLife, ...]:
    """Return every flank and root with its spectrum and its S-N curve, the most damaged first.

    Of a planet, whose two meshes load two flanks, the more damaged one is told.

    Args:
        flight: As flown.

    Source: `gear_damage`, class by class; N of a load from Miner's part of one load change, 1/D.

    Raises:
        DesignError: Teeth that the method of a stage does not cover.

    Valid for: the mean speed of each mesh, on which the film factors of ISO 6336-2 depend.
    """
    unrated = unrated_stages(flight.sizing.design)
    rows: dict[tuple[str, str], LoadLife] = {}
    for mesh in flight.sizing.train.meshes:
        for row in _load_lives_of_mesh(flight, mesh) if mesh.stage not in unrated else ():
            known = rows.get((str(row.part), row.mode))
            if known is None or row.total > known.total:
                rows[str(row.part), row.mode] = row
    return tuple(largest_first(list(rows.values()), lambda row: row.total))


def _load_lives_of_mesh(flight: Flight, mesh: Mesh) -> Iterator[LoadLife]:
    rolling = flight.speed(mesh.nodes[0]) - flight.speed(mesh.nodes[2])
    duty = flight.meshes[mesh.name]
    classes = classed([duty.torque], [rolling], [flight.history.duration], CLASSES)
    kept = damaging(classes)[0]
    if not kept.any():
        return
    ((ask, steel, _),) = alike([flight], mesh, [extremes(flight)], [True])
    load, speed, turns = classes.load[0][kept], classes.speed[0][kept], classes.turns[0][kept]
    arm = float(np.max(np.abs(duty.torque)) / np.max(np.abs(duty.force)))
    ladder = load.max() * LADDER
    both = spectrum_of(flight.sizing, mesh, ask, steel, load=load, speed=speed, turns=turns)
    mean = np.full(len(ladder), np.average(speed, weights=turns))
    curve = spectrum_of(flight.sizing, mesh, ask, steel, load=ladder, speed=mean, turns=np.ones(len(ladder)))
    method = method_for(both.rating)
    first, second = (float(np.asarray(teeth)) for teeth in ask.teeth)
    pairs = zip(mesh.gears, method.damage(both), method.damage(curve), (1.0, first / second), ask.passes, strict=True)
    for name, parts, steps, ratio, passes in pairs:
        for mode in (PITTING, BENDING):
            damage, one = (np.array(getattr(found, mode)) for found in (parts, steps))
            with np.errstate(divide="ignore"):
                borne = ratio * passes / one
            yield LoadLife(
                flight.sizing.train.gear(name).part, mesh.name, mode, load / arm, turns * ratio * passes, damage,
                ladder / arm, borne,
            )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# What warm oil does to flanks in flight: scuffing and micropitting where load, speed and temperature are worst.
# ----------------------------------------------------------------------------------------------------------------------


MODES = ("scuffing", "micropitting")
"""Judgements of a mesh that hang on the temperature of its oil."""
FILMED = ("iso6336", "iso6336-2006", "din3990", "iso10300")
"""Methods that judge films."""
_LEAST_FILM_TORQUE = 1e-6
"""Torque below which nothing is loaded [N m]."""


def film_checks_of(flight: Flight) -> Iterator[Check]:
    """Yield scuffing and micropitting of meshes with the oil as warm as the flight makes it, the worst of each.

    Args:
        flight: As flown, with a network of temperatures; others, and stages that no such method rates, yield nothing.

    Source: the judgements of sizing (ISO/TS 6336-20, -21, -22) at the intervals that no other surpasses in load,
        temperature and speed, or in load, temperature and slowness; K_A as in sizing.
    """
    warm = flight.history.oil_temperature
    if warm is None:
        return
    for mesh in flight.sizing.train.meshes:
        yield from _films_of_mesh(flight, mesh, warm - CELSIUS)


def _films_of_mesh(flight: Flight, mesh: Mesh, warm: Floats) -> Iterator[Check]:
    sizing = flight.sizing
    rating = rating_as_sized(sizing, mesh.stage).of_mesh(mesh)
    if rating.method not in FILMED:
        return
    torque = np.abs(flight.meshes[mesh.name].torque)
    speed = np.abs(flight.speed(mesh.nodes[0]) - flight.speed(mesh.nodes[2]))
    loaded = np.flatnonzero((torque > _LEAST_FILM_TORQUE) & (speed > 0.0))
    worst = dict[tuple[str, str], Check]()
    for k in np.union1d(_extreme(torque, warm, speed, loaded), _extreme(torque, warm, -speed, loaded)).tolist():
        at = (float(torque[k]), float(speed[k]), float(warm[k]))
        for check in _judged(flight, mesh, rating, at, flight.phase[k]):
            key = (check.mode, check.clause)
            if key not in worst or _ratio(check) < _ratio(worst[key]):
                worst[key] = check
    yield from worst.values()


def _judged(flight: Flight, mesh: Mesh, rating: Rating, at: tuple[float, float, float], phase: str) -> Iterator[Check]:
    """Yield the judgements at a torque [N m], a speed [rad/s] and a temperature of the oil [°C]."""
    torque, speed, warm = at
    sizing, rules = flight.sizing, rating.rules
    warmed = replace(
        rating,
        rules=rules.model_copy(update={"iso6336": rules.iso6336.model_copy(update={"oil_temperature": warm})}),
    )
    gears = [gear for name in mesh.gears for gear in sizing.gears if gear.name == name]
    ask = row_ask(sizing.train, sizing.teeth, mesh, extremes(flight), sizing.design)
    sized = next(row for row in sizing.meshes if row.name == mesh.name)
    ask = ask._replace(speed=speed, made=made_of(sized))
    load = Load(phase, torque * rating.load_factor, ask, rating.service.life)
    width = min(gear.face_width for gear in gears)
    loaded = LoadedMesh(warmed, gears[0].module, width, load, (load,), (0.0, 0.0))
    method = method_for(warmed)
    for check in method.checks(method.rate(loaded), mesh.part, (gears[0].part, gears[1].part)):
        if check.mode in MODES:
            yield replace(check, case=phase, place=", ".join(filter(None, (check.place, f"oil of {warm:.0f} °C"))))


def _ratio(check: Check) -> float:
    return math.inf if check.ratio is None else check.ratio


def _extreme(torque: Floats, warm: Floats, speed: Floats, among: Ints) -> Ints:
    """Return the intervals that no other surpasses in all three."""
    points = np.column_stack([torque, warm, speed])[among]
    unique, first = np.unique(np.round(points, 9), axis=0, return_index=True)
    beaten = [bool(np.any(np.all(unique >= one, axis=1) & np.any(unique > one, axis=1))) for one in unique]
    return np.asarray(among[first[~np.array(beaten, bool)]])
