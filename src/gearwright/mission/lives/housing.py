"""Fatigue of the housing: forces on every seat over load cases or a mission, stresses of sections, Miner's sum."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.base import (
    GRAVITY,
    HOUSING,
    Check,
    DesignError,
    Endless,
    Floats,
    GearwrightError,
    Kind,
    Origin,
    PartId,
    Quantity,
    Ratio,
    largest,
    not_assessed,
)
from gearwright.catalogue import HousingMaterial, housing_materials
from gearwright.dynamics.vibration import SupportForce, row_swings, support_forces
from gearwright.elementwise import Values
from gearwright.mission.flight import Flight
from gearwright.mission.gearbox import flown_airscrew
from gearwright.mission.lives.bearings import held_shafts, located, thrust_on
from gearwright.parts.housing_fatigue import (
    StressCycles,
    arm_stress,
    collar_stress,
    corner_concentration,
    fatigue_safety,
    lug_stress,
    miner_sum,
    mount_force,
    pulled_concentration,
    pushed_wall,
    seat_stress,
    shell_stress,
    shoulder_concentration,
    tilted_wall,
    web_stress,
)
from gearwright.parts.housings import bearing_wall, torque_arm_volume
from gearwright.parts.shaft_fatigue import rainflow
from gearwright.shape.casings import CENTRE, DEPTH, LUGS, lug_width
from gearwright.sizing import Sizing
from gearwright.sizing.airscrew_loads import usual_thrust
from gearwright.sizing.bearing_seats import Seat, bearing_seats, pushed
from gearwright.sizing.casing import BOSS, PARALLEL, Carried, housed, shell_of, web_shares
from gearwright.sizing.housing_shell import SEAT, section_across
from gearwright.sizing.mass import (
    MOUNTS,
    carried_in_walls,
    held_torques,
    reaction_torque,
    torque_about,
    weighed_wall,
)
from gearwright.spec.design import case_named, levels_of, shares_of

# ----------------------------------------------------------------------------------------------------------------------
# What the housing bears over one cycle of use: load cases with their levels one after the other, or a flight.
# ----------------------------------------------------------------------------------------------------------------------


START = 3600.0
"""From start to start where a design says nothing [s], an assumption."""


class Duty(NamedTuple):
    """One cycle of use, from start to stop: one row for each load, shape (n,) or (n, meshes)."""

    torques: Floats
    """On gear a of one single mesh of each row [N m]."""
    swings: Floats
    """Amplitude of the vibration of each row of meshes over its force, planets together [-]."""
    rates: Floats
    """Mesh frequency of each row of meshes [Hz]."""
    machines: Mapping[str, Floats]
    """Machine -> torque on its shaft [N m]."""
    supports: Mapping[str, Floats]
    """Shaft that the design lets move -> amplitude of what its bearings give to the housing [N]."""
    thrusts: Mapping[str, Floats]
    """Shaft -> thrust of propellers and rotors on it [N]."""
    time: Floats
    """How long each lasts [s]."""
    names: tuple[str, ...]
    """Load case or phase of each."""
    uses: float
    """Cycles of use in the life [-]."""


def duty_of_cases(sizing: Sizing) -> Duty:
    """Return a cycle of use as the load cases of a design have it: each of them and its levels, once.

    Args:
        sizing: As sized.

    Limit loads are left out. From one level of a spectrum to the next loads go by the lowest. All are times K_A. What a
    mesh's force swings is that of the forced response in its case.
    """
    design, train = sizing.design, sizing.train
    interval, _ = _interval(sizing)
    shares = shares_of(design) or {sizing.reference.case: 1.0}
    rows = list[tuple[str, float, float]]()
    for case in sizing.flows:
        if not case_named(design, case).static:
            levels = levels_of(design, case)
            lowest = min(level for level, _ in levels)
            for level, share in levels:
                rows += [(case, level, share * shares.get(case, 0.0) * interval), (case, lowest, 0.0)]
    factor = design.service.application_factor
    loads = factor * np.array([level for _, level, _ in rows])
    swings, supports = _swings(sizing, tuple(dict.fromkeys(case for case, _, _ in rows)))
    flows = [sizing.flows[case] for case, _, _ in rows]
    return Duty(
        torques=loads[:, None]
        * np.array([[flow.meshes[mesh.name].torques[0] / mesh.count for mesh in train.meshes] for flow in flows]),
        swings=np.array([swings[case] for case, _, _ in rows]),
        rates=np.array([_rates(sizing, flow.speeds.__getitem__) for flow in flows]),
        machines={
            name: loads * np.array([flow.machine_torques.get(name, 0.0) for flow in flows]) for name in train.machines
        },
        supports={
            shaft: loads * np.array([supports[case][shaft].swing for case, _, _ in rows]) for shaft in design.supports
        },
        thrusts={shaft: loads * _usual(sizing, shaft) for shaft in sizing.arrangement.plans},
        time=np.array([time for _, _, time in rows]),
        names=tuple(case for case, _, _ in rows),
        uses=design.service.life / interval,
    )


def _rates(sizing: Sizing, speed: Callable[[str], Values]) -> list[Values]:
    """Return the mesh frequency of each row of meshes [Hz]."""
    return [
        abs(speed(mesh.nodes[0]) - speed(mesh.nodes[2])) * (sizing.teeth[mesh.gears[0]] / (2.0 * math.pi))
        for mesh in sizing.train.meshes
    ]


def _usual(sizing: Sizing, shaft: str) -> float:
    in_bearings = bool(sizing.arrangement.plans[shaft].seats)
    return usual_thrust(sizing.design, sizing.flows, shaft, in_bearings=in_bearings)


def _interval(sizing: Sizing) -> tuple[float, bool]:
    """Return from start to start [s], and whether the design says it."""
    design = sizing.design
    if design.housing.start_interval is not None:
        return design.housing.start_interval, True
    durations = [case.duration for case in design.cases.values() if not case.static]
    whole = sum(duration or 0.0 for duration in durations)
    return (whole, True) if whole and None not in durations else (START, False)


def _swings(
    sizing: Sizing, cases: Sequence[str]
) -> tuple[dict[str, list[float]], dict[str, Mapping[str, SupportForce]]]:
    """Return case -> what each row of meshes swings over its force [-], and case -> what supports give.

    A case of which no response is found swings as its rating's torque does.
    """
    swings, supports = dict[str, list[float]](), dict[str, Mapping[str, SupportForce]]()
    usual = sizing.design.service.torque_swing
    for case in cases:
        try:
            swung, supports[case] = row_swings(sizing, case), support_forces(sizing, case)
        except GearwrightError:
            swung = {mesh.name: usual for mesh in sizing.train.meshes}
            supports[case] = {shaft: SupportForce(0.0, 0.0) for shaft in sizing.design.supports}
        swings[case] = [swung.get(mesh.name, 0.0) for mesh in sizing.train.meshes]
    return swings, supports


def duty_of_flight(flight: Flight) -> Duty:
    """Return a flight as a cycle of use.

    Args:
        flight: As flown.

    What a mesh's force swings is that of the forced response in the case that speaks for the design, by the torque.
    """
    sizing = flight.sizing
    count, reference = len(flight.phase), sizing.reference
    swings, supports = _swings(sizing, (reference.case,))
    torques = np.stack([flight.meshes[mesh.name].torque for mesh in sizing.train.meshes], axis=-1)
    machines = {name: _quotient(history.power, history.speed) for name, history in flight.machines.items()}
    screw = flown_airscrew(sizing)
    speed = flight.speed(sizing.train.machines[screw])
    machines[screw] = -_quotient(flight.history.propeller_power, speed)
    rated = abs(reference.machine_torques[screw]) or 1.0
    return Duty(
        torques=torques,
        swings=np.tile(swings[reference.case], (count, 1)),
        rates=np.stack(_rates(sizing, flight.speed), axis=-1),
        machines={name: machines.get(name, np.zeros(count)) for name in sizing.train.machines},
        supports={
            shaft: force.swing * np.abs(machines[screw]) / rated for shaft, force in supports[reference.case].items()
        },
        thrusts={shaft: thrust_on(flight, shaft) for shaft in sizing.arrangement.plans},
        time=flight.history.duration,
        names=flight.phase,
        uses=sizing.design.service.life / flight.duration,
    )


def _quotient(power: Floats, speed: Floats) -> Floats:
    return np.divide(power, speed, out=np.zeros_like(power), where=speed != 0.0)


# ----------------------------------------------------------------------------------------------------------------------
# What every seat gives to the housing: a steady force, and what vibrates at mesh frequency.
#
# A housing stands still in the force that turns past a shaft: its force is steady as long as the load is. What
# alternates is start and stop, change of load, and the vibration of the meshes.
# ----------------------------------------------------------------------------------------------------------------------


class Loading(NamedTuple):
    """What one section bears over a cycle of use, shape (n,), in any unit of load."""

    steady: Floats
    """With its sense."""
    swing: Floats
    """Amplitude of what vibrates, without sign."""
    rate: Floats
    """At which it does [Hz]."""

    def times(self, factor: float) -> Loading:
        """Return the loading in another unit.

        Args:
            factor: Of that for one of this.
        """
        return self._replace(steady=factor * self.steady, swing=abs(factor) * self.swing)


class SeatLoading(NamedTuple):
    """What one seat gives to the housing."""

    radial: Loading
    """[N]"""
    axial: Floats
    """Without sign [N]."""


def seat_loadings(sizing: Sizing, duty: Duty) -> dict[str, SeatLoading]:
    """Return seat of a shaft -> what it gives to the housing.

    Args:
        sizing: As sized.
        duty: A cycle of use.

    Radial forces are counted along the line of the largest, those of propellers and rotors with the sense of the rest.
    Vibration is that of the meshes that push on the seat, each by its forced response, as if they met; on shafts that
    the design lets move that of their supports, in equal parts.

    Raises:
        DesignError: If nothing takes a force along a shaft.
    """
    seats = {seat.name: seat for seat in bearing_seats(sizing)}
    found = dict[str, SeatLoading]()
    for shaft, own in held_shafts(seats).items():
        pushes = {name: pushed(seat, duty.torques) for name, seat in own.items()}
        radial = {name: _radial(pushes[name], seat.across) for name, seat in own.items()}
        forces = {name: (np.abs(radial[name]), pushes[name][:, 2]) for name in own}
        axial = located(sizing, shaft, own, forces, thrust=duty.thrusts[shaft], cases=duty.names)
        for name, seat in own.items():
            swing, rate = _vibrating(seat, duty)
            if shaft in duty.supports:
                swing = duty.supports[shaft] / len(own)
                rate = np.where(rate > 0.0, rate, duty.rates.max(axis=1))
            found[name] = SeatLoading(Loading(radial[name], swing, rate), axial[name])
    return found


def _radial(push: Floats, across: float) -> Floats:
    """Return forces along the line of the largest, with what a rotor adds in any direction [N]."""
    size = np.hypot(push[:, 0], push[:, 1])
    worst = int(np.argmax(size))
    way = push[worst, :2] / size[worst] if size[worst] else np.zeros(2)
    along = push[:, :2] @ way
    return np.asarray(along + np.where(along < 0.0, -across, across))


def _vibrating(seat: Seat, duty: Duty) -> tuple[Floats, Floats]:
    """Return the amplitude of what meshes put on a seat as they vibrate [N], and the highest frequency [Hz]."""
    reach = np.hypot(seat.forward[:, 0], seat.forward[:, 1])
    swing = np.abs(duty.torques) * duty.swings * reach
    rate = np.where((reach > 0.0) & (duty.torques != 0.0), duty.rates, 0.0).max(axis=1)
    return swing.sum(axis=1), rate


def torque_loading(duty: Duty, torque: Floats) -> Loading:
    """Return a torque that the housing holds with its vibration: that of the mesh that swings most [N m].

    Args:
        duty: A cycle of use.
        torque: In each row of it [N m].
    """
    loaded = duty.torques != 0.0
    return Loading(
        torque,
        np.abs(torque) * np.where(loaded, duty.swings, 0.0).max(axis=1),
        np.where(loaded, duty.rates, 0.0).max(axis=1),
    )


# ----------------------------------------------------------------------------------------------------------------------
# Sections of the housing under their loadings: nominal stress, notch, cycles of every part of the load, safety.
# ----------------------------------------------------------------------------------------------------------------------


MINER = 0.3
"""Miner's sum that is allowed under loads of many sizes [-]: castings (Schönborn et al., Procedia Engineering 101
(2015) 440 to 449), the FKM guideline for aluminium."""
FILLET = 0.5
"""Radius of fillets over the wall [-], an assumption: usual in castings."""
NOTCH = shoulder_concentration(2.5, 2.0)
"""Stress in fillets at the feet of webs, bosses and lugs that are bent over the nominal one [-]: r = d/5 where D = 2 d,
an assumption."""
PULLED = pulled_concentration(2.5, 2.0)
"""The same of a wall that is pulled beside a boss [-]."""
BEYOND = 1.0 + 1e-9
"""Over the safety, where shares are taken: vibration that reaches the cut-off there does harm [-]."""
FLAT = "flat wall"
"""Section that says what a wall bears at least."""
EDGE = 1.25
"""Radius at which a flat wall is built in over that of the boss, at least [-], an assumption."""
WIDTH = 0.2
"""Of a bearing over its outside diameter, where it is not chosen [-]: light series of ISO 15."""
LOAD_FACTOR = 2.5
"""Of the weight on mounts, once in a cycle of use [-]: CS 25.337, least positive limit manoeuvring load factor."""


@dataclass(frozen=True)
class HousingSection:
    """One section of the housing over the life."""

    part: PartId
    """Bearing whose boss it is beside, or the housing."""
    section: str
    """shell, wall, flat wall, web, collar, mount or arm."""
    stress: Annotated[float, Quantity("stress"), Origin("nominal, of equal effect as a normal stress", "by section")]
    """Largest of the steady load, without notch [Pa]."""
    notch: Annotated[float, Quantity("ratio"), Origin("K_t", "fillets")]
    """[-]"""
    start_range: Annotated[float, Quantity("stress"), Origin("Δσ from standstill to the peak", "ASTM E1049")]
    """Of start and stop, vibration and notch included [Pa]."""
    starts: float
    """In the life [-]."""
    change_range: Annotated[float, Quantity("stress"), Origin("Δσ between loads", "ASTM E1049")]
    """Largest of changes between loads, notch included [Pa]; 0 where there are none."""
    changes: float
    """In the life [-]."""
    swing_range: Annotated[float, Quantity("stress"), Origin("2 σ (K − 1)", "forced response")]
    """Largest at mesh frequency, notch included [Pa]."""
    swings: float
    """In the life [-]."""
    damage: Ratio
    """Miner's sum over the life, as loaded [-]."""
    start_share: Ratio
    """By starts, of the sum at which it fails: with loads grown by the safety [-]."""
    swing_share: Ratio
    """At mesh frequency, of the same [-]."""
    safety: Annotated[float, Quantity("ratio"), Origin("S_D: Σ n/N(S_D K_t Δσ) = D", "Miner"), Endless()]
    """By which all loads may grow until the sum is the allowed one [-]."""


class Loaded(NamedTuple):
    """A section before its cycles are counted."""

    part: PartId
    section: str
    stress: Loading
    """Nominal, of equal effect as a normal one [Pa]."""
    notch: float


def housing_sections(sizing: Sizing, flight: Flight | None, mass: float) -> tuple[HousingSection, ...]:
    """Return the sections of a housing of the gearbox's own with what tires them, the least safe first.

    Args:
        sizing: As sized.
        flight: Of it; None: over its load cases.
        mass: Of the complete gearbox, which mounts carry [kg].

    Raises:
        DesignError: If nothing takes a force along a shaft.
    """
    if not sizing.design.housing.own:
        return ()
    duty = duty_of_cases(sizing) if flight is None else duty_of_flight(flight)
    material = housing_materials()[sizing.design.housing.material]
    found = [
        counted(one, duty, material)
        for one in (*_shell(sizing, duty), *_at_seats(sizing, duty), *_mounts(sizing, duty, mass))
        if one.stress.steady.any()
    ]
    return tuple(sorted(found, key=lambda one: (round(one.safety, 9), str(one.part), one.section)))


def known_sections(sizing: Sizing, flight: Flight | None, mass: float) -> tuple[tuple[HousingSection, ...], str]:
    """Return what tires the housing, or why that is not known.

    Args:
        sizing: As sized.
        flight: Of it; None: its load cases.
        mass: Of the whole gearbox [kg].
    """
    try:
        return housing_sections(sizing, flight, mass), ""
    except DesignError as error:  # nothing takes a force along a shaft
        return (), "; ".join(problem.message for problem in error.problems)


def counted(loaded: Loaded, duty: Duty, material: HousingMaterial) -> HousingSection:
    """Return a section with the cycles of its stress: start and stop, changes of load, vibration.

    Args:
        loaded: The section.
        duty: A cycle of use.
        material: Of the housing.

    Source: rainflow of standstill and every load, as a period that repeats (ASTM E1049, 5.4.5), vibration added to each
        load; beside them 2 σ_a f t cycles at mesh frequency.
    """
    steady, swing, rate = loaded.stress
    peaks = loaded.notch * (steady + np.where(steady < 0.0, -swing, swing))
    whole = rainflow([0.0, *peaks.tolist(), 0.0], residue="repeated")
    turned = [StressCycles(one.range, duty.uses * one.count) for one in whole]
    starts, changes = turned[:1], turned[1:]
    shaken = [
        StressCycles(2.0 * loaded.notch * float(amplitude), float(often))
        for amplitude, often in zip(swing, rate * duty.time * duty.uses, strict=True)
        if amplitude > 0.0 and often > 0.0
    ]
    curve, every = material.curve, [*turned, *shaken]
    safety = fatigue_safety(curve, every, spectrum=MINER)
    grown = safety * BEYOND if math.isfinite(safety) else 1.0
    sums = [miner_sum(curve, cycles, factor=grown) for cycles in (starts, changes, shaken)]
    whole_sum = sum(sums)
    return HousingSection(
        part=loaded.part,
        section=loaded.section,
        stress=float(np.abs(steady).max()),
        notch=loaded.notch,
        start_range=starts[0].range if starts else 0.0,
        starts=duty.uses,
        change_range=max((one.range for one in changes), default=0.0),
        changes=sum(one.number for one in changes),
        swing_range=max((one.range for one in shaken), default=0.0),
        swings=sum(one.number for one in shaken),
        damage=miner_sum(curve, every, factor=1.0),
        start_share=round(sums[0] / whole_sum, 6) if whole_sum else 0.0,
        swing_share=round(sums[2] / whole_sum, 6) if whole_sum else 0.0,
        safety=safety,
    )


def _shell(sizing: Sizing, duty: Duty) -> Iterator[Loaded]:
    """Yield the shell in torsion about that direction of machines' axes in which it is stressed most."""
    wall, material = weighed_wall(sizing).thickness, housing_materials()[sizing.design.housing.material]
    found = list[Loading]()
    for way, _ in held_torques(sizing):
        section = shell_of(sizing).section if abs(way.x) > 1.0 - PARALLEL else section_across(housed(sizing), way)
        held = torque_loading(duty, torque_about(sizing, duty.machines, way))
        found.append(held.times(shell_stress(1.0, section, wall) / material.shear_share))
    worst = largest(found, lambda one: float(np.abs(one.steady).max()))
    yield Loaded(HOUSING, "shell", worst, corner_concentration(wall, FILLET * wall))


def _at_seats(sizing: Sizing, duty: Duty) -> Iterator[Loaded]:
    """Yield walls, webs and collars at the seats of shafts."""
    loadings = seat_loadings(sizing, duty)
    bosses = carried_in_walls(sizing)
    carried = {name for one in bosses for name in one.bearings}
    for seat in bearing_seats(sizing):
        if seat.name in loadings and seat.name not in carried:
            diameter = SEAT * seat.bore
            seated = _Seated(seat.part, diameter, WIDTH * diameter, (0.5 + BOSS) * diameter)
            yield from _walls(sizing, seated, loadings[seat.name])
    for one in bosses:
        if one.found:
            yield from _carried(sizing, one, loadings)


def _carried(sizing: Sizing, carried: Carried, loadings: Mapping[str, SeatLoading]) -> Iterator[Loaded]:
    """Yield what carries the bosses of bearings that are beside each other."""
    own = [loadings[name] for name in carried.bearings if name in loadings]
    if not own:
        return
    together = SeatLoading(
        Loading(
            np.sum([one.radial.steady for one in own], axis=0),
            np.sum([one.radial.swing for one in own], axis=0),
            np.max([one.radial.rate for one in own], axis=0),
        ),
        np.sum([one.axial for one in own], axis=0),
    )
    part = PartId(Kind.BEARING, carried.bearings[0])
    bearing = next(bearing for bearing in sizing.bearings if bearing.name == carried.bearings[0])
    outer = (0.5 + BOSS) * bearing.outer_diameter
    for collar in carried.collars:
        unit = collar_stress(1.0, 0.0, collar.outer, collar.inner), collar_stress(0.0, 1.0, collar.outer, collar.inner)
        stress = _both(together, unit)
        yield Loaded(PartId(Kind.BEARING, collar.bearing), "collar", stress, NOTCH)
        outer = max(outer, collar.outer)
    units = _webs(sizing, carried)
    if units:
        most = float(np.abs(together.radial.steady).max()), float(together.axial.max())
        worst = largest(units, lambda unit: unit[0] * most[0] + unit[1] * most[1])
        yield Loaded(part, "web", _both(together, worst), NOTCH)
    else:
        yield from _walls(sizing, _Seated(part, bearing.outer_diameter, bearing.width, outer), together)


def _webs(sizing: Sizing, carried: Carried) -> list[tuple[float, float]]:
    """Return the stress of each web of a boss by one newton across and along its shaft [Pa].

    There are none where the boss stands in the wall on the side of the others, which then bears.
    """
    least = weighed_wall(sizing).thickness / 2.0
    radial, axial = (web_shares(carried.webs, forces, least) for forces in ((1.0, 0.0), (0.0, 1.0)))
    if radial is None or axial is None:
        return []
    return [
        (web_stress(float(pull), 0.0, web.width, web.thickness), web_stress(0.0, float(bend), web.width, web.thickness))
        for web, pull, bend in zip(carried.webs, radial.pulls, axial.moments, strict=True)
    ]


def _both(loading: SeatLoading, unit: tuple[float, float]) -> Loading:
    """Return the stress by a radial and an axial force of which each is known for one newton, both adding up [Pa]."""
    across, along = unit
    steady = loading.radial.steady
    size = across * np.abs(steady) + along * loading.axial
    return Loading(np.where(steady < 0.0, -size, size), across * loading.radial.swing, loading.radial.rate)


class _Seated(NamedTuple):
    """A bearing in a wall; lengths [m]."""

    part: PartId
    diameter: float
    """Outside of the bearing."""
    width: float
    """Of the bearing."""
    boss: float
    """Radius of what is rigid around it."""


def _walls(sizing: Sizing, seated: _Seated, loading: SeatLoading) -> Iterator[Loaded]:
    """Yield the wall in which a bearing stands: in its plane, and what it would bear at least as a flat wall.

    The flat wall has no ribs, is built in on a circle as large as the housing's largest section with the bearing in its
    middle, and stands at one end of the bearing. It is as thick as pads make it.
    """
    material, shell = housing_materials()[sizing.design.housing.material], shell_of(sizing)
    part, diameter, width, boss = seated
    wall = max(weighed_wall(sizing).thickness, _padded(sizing, part, diameter, material))
    edge = max(math.sqrt(shell.section / math.pi), EDGE * boss)
    pulled = seat_stress(1.0, boss, wall)
    yield Loaded(part, "wall", loading.radial.times(pulled), PULLED)
    pushed_by, tilted_by = pushed_wall(1.0, boss, edge, wall), tilted_wall(0.5 * width, boss, edge, wall)
    steady = loading.radial.steady
    size = pushed_by * loading.axial + (pulled + tilted_by) * np.abs(steady)
    swing = (pulled + tilted_by) * loading.radial.swing
    yield Loaded(part, FLAT, Loading(np.where(steady < 0.0, -size, size), swing, loading.radial.rate), NOTCH)


def _padded(sizing: Sizing, part: PartId, diameter: float, material: HousingMaterial) -> float:
    """Return how thick pads make the wall around the bearing of a shaft of the first sizing [m]."""
    forces = [bearing.radial_force for shaft in sizing.shafts if shaft.name == part.name for bearing in shaft.bearings]
    return max((bearing_wall(force, diameter, material.shear_strength) for force in forces), default=0.0)


def _mounts(sizing: Sizing, duty: Duty, mass: float) -> Iterator[Loaded]:
    """Yield what holds the gearbox: lugs as they are drawn, or torque arms.

    Lugs bear torque and weight around the housing, and the thrust of propellers and rotors in the direction in which
    they are weaker. What vibrates at mesh frequency the housing's own inertia holds: its mounts are soft beside it.
    """
    material, wall = housing_materials()[sizing.design.housing.material], weighed_wall(sizing).thickness
    ways = [torque_about(sizing, duty.machines, way) for way, _ in held_torques(sizing)]
    torque = largest(ways, lambda one: float(np.abs(one).max()))
    loading = Loading(torque, np.zeros_like(torque), np.zeros_like(torque))
    if sizing.design.housing.reaction == "torque-arms":
        volume = torque_arm_volume(reaction_torque(sizing), material.bending_strength)
        yield Loaded(HOUSING, "arm", loading.times(arm_stress(1.0, volume)), NOTCH)
        return
    shell = shell_of(sizing)
    width = lug_width(MOUNTS * shell.area * wall)
    radius = shell.girth / (2.0 * math.pi) + CENTRE * width
    lever, depth = CENTRE * width, DEPTH * width
    around, along = lug_stress(1.0, lever, width, depth), lug_stress(1.0, lever, depth, width)
    weight = mount_force(0.0, radius, LOAD_FACTOR * mass * GRAVITY, LUGS)
    thrust = np.sum([np.abs(one) for one in duty.thrusts.values()], axis=0) / LUGS
    steady = loading.steady
    size = around * (mount_force(1.0, radius, 0.0, LUGS) * np.abs(steady) + weight) + along * thrust
    yield Loaded(HOUSING, "mount", loading._replace(steady=np.where(steady < 0.0, -size, size)), NOTCH)


# ----------------------------------------------------------------------------------------------------------------------
# What all of this rests on.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Assumed:
    """One assumption."""

    what: str
    value: str
    source: str


def housing_assumptions(sizing: Sizing, flight: Flight | None) -> Iterator[Assumed]:
    """Yield what the fatigue of a housing rests on.

    Args:
        sizing: As sized.
        flight: Of it; None: its load cases.
    """
    rules, curve = sizing.design.housing, housing_materials()[sizing.design.housing.material].curve
    if flight is None:
        interval, known = _interval(sizing)
        said = "the design" if known else "assumed: no case has a duration, nor is [housing] start_interval_h given"
        yield Assumed("from start to start", f"{interval / 3600.0:.4g} h", said)
        yield Assumed("loads over nominal ones", f"K_A = {sizing.design.service.application_factor:g}", "[service]")
    else:
        yield Assumed("from start to start", f"{flight.duration / 3600.0:.4g} h", "the flight, over and over")
        yield Assumed("loads over nominal ones", "1", "those of the flight")
    yield Assumed("steady part", "force of a seat stands still in the housing", "starts, changes and meshes alternate")
    moves = "supports that move, else meshes" if sizing.design.supports else "meshes on rigid bearings"
    yield Assumed("vibration", moves, "forced response of each case, tones as if they met; mounts: none")
    corners = corner_concentration(1.0, FILLET)
    fillets = f"K_t = {NOTCH:.2f} bent, {PULLED:.2f} pulled, {corners:.2f} corners of the shell"
    yield Assumed("fillets", fillets, "r = d/5 where D = 2 d; corners t/2")
    lines = "-".join(f"{slope:g}" for slope in curve.slopes)
    class_of = f"Δσ = {1e-6 * curve.strength:g} MPa at {curve.cycles:g}, slopes {lines}, none below 1e8 cycles"
    yield Assumed("casting", class_of, _CLAUSES[rules.material])
    yield Assumed("Miner's sum", f"{MINER:g} of many sizes to 1 of one", "Schönborn et al. 2015; FKM guideline")
    if rules.reaction == "lugs":
        yield Assumed("weight on mounts", f"{LOAD_FACTOR:g} g once from start to start", "CS 25.337")


# ----------------------------------------------------------------------------------------------------------------------
# Every section against the asked safety.
# ----------------------------------------------------------------------------------------------------------------------


_CLAUSES = {
    "aluminium": "EN 1999-1-3, annex I; Miner",
    "magnesium": "estimate by EN 1999-1-3, annex I; Miner",
    "cast-iron": "FKM guideline; Miner",
    "composite": "estimate; Miner",
}
_HELP = "a thicker wall ([housing] wall_mm), a stronger material, or bearings of smaller force would help"


def housing_checks(
    sizing: Sizing, sections: Sequence[HousingSection], *, mission: str = "", why: str = ""
) -> Iterator[Check]:
    """Yield the safety of every section of the housing against fatigue, or why it is not judged.

    Args:
        sizing: As sized.
        sections: From `housing_sections`.
        mission: That was flown; empty: load cases.
        why: They are not known.
    """
    rules = sizing.design.housing
    clause = _CLAUSES[rules.material]
    if not rules.own:
        yield not_assessed(HOUSING, "shell fatigue", clause, "what stands around the gearbox is none of its own")
    elif why:
        yield not_assessed(HOUSING, "wall fatigue", clause, why)
    asked = rules.fatigue_safety
    for one in sections:
        if one.section != FLAT or one.safety >= asked:
            yield Check(
                one.part, f"{one.section} fatigue", clause, one.safety, asked, symbol="S_D", case=mission,
                why=_HELP if one.safety < asked else "",
            )  # fmt: skip
    thin = [one for one in sections if one.section == FLAT and one.safety < asked]
    if thin:
        wall = weighed_wall(sizing).thickness
        words = ", ".join(f"{one.part} ({1e3 * wall * math.sqrt(asked / one.safety):.2g} mm)" for one in thin)
        yield not_assessed(
            HOUSING, f"{FLAT} fatigue", clause,
            f"axial force and offset of bearings would bend flat walls of {1e3 * wall:.2g} mm too much at {words};"
            " what ribs, cones and pads bear nobody has laid out, and none is weighed for it",
        )  # fmt: skip
