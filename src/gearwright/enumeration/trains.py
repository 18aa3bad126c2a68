"""Kinds of stages, and every gear train of a few stages that gives a ratio."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import product
from typing import Any

from gearwright.base import RPM, DesignError, Problem, Role, gear_part, refuse
from gearwright.catalogue import bearings
from gearwright.parts.bearings import BearingKind
from gearwright.sizing import Sizing, size
from gearwright.spec import GROUND, Design, as_concept, drives_of, edited
from gearwright.spec.design import Drive, Motor, Turbine
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# Kinds of stages that a train may be made of: what each takes, which ratios it gives, and its tables in a design.
# ----------------------------------------------------------------------------------------------------------------------


Tables = Mapping[str, Mapping[str, Any]]
"""Kind of table (``pairs``, ``planetaries``) -> name of a stage -> what it states, in SI."""
HELIX = math.radians(20.0)
"""Helix angle of double-helical pairs whose design states none [rad] (Pulvirenti 2023, table 3.2)."""


@dataclass(frozen=True)
class Kind:
    """A kind of stage, or of several that belong together."""

    name: str
    """In words of the trade."""
    short: str
    """In the names of files."""
    stages: int
    """How many stages it counts as [-]."""
    least: float
    """Smallest ratio of each of its stages [-]."""
    most: float
    """Largest ratio of each of them [-]."""
    senses: int
    """1: its output turns as its input does; -1: the other way."""
    tables: Callable[[Link], Tables]
    """What it is between two shafts."""
    toothed: bool = False
    """Whether a motor's pinion may mesh with its wheel."""
    branched: bool = False
    """Whether two shafts side by side carry its power."""
    balanced: bool = False
    """Whether the motor turns its ring, so that two speeds and both torques meet in it."""


@dataclass(frozen=True)
class Link:
    """Where a kind stands in a train."""

    names: tuple[str, ...]
    """Of its stages."""
    driving: str
    """Shaft that turns it."""
    driven: str
    """Shaft that it turns."""
    ratios: tuple[float, ...]
    """Of each of its stages [-]."""
    asked: tuple[bool, ...]
    """Whether each is asked for; else the speeds beside it give it."""
    helix: float
    """Helix angle of pairs [rad]."""
    ring: str = GROUND
    """Shaft of the motor that turns a differential's ring."""


def halved(helix: float) -> dict[str, Any]:
    """Return what a double-helical pair states.

    Args:
        helix: Helix angle [rad].
    """
    return {"halves": 2, "gears": {"helix_angle": helix}}


def _asked(table: dict[str, Any], link: Link, stage: int, ratio: float) -> dict[str, Any]:
    """Return a table with the ratio that a stage is asked for."""
    return {**table, "ratio": ratio} if link.asked[stage] else table


def _pair(link: Link) -> Tables:
    stated = {"pinion": link.driving, "wheel": link.driven, **halved(link.helix)}
    return {"pairs": {link.names[0]: _asked(stated, link, 0, link.ratios[0])}}


def branches(link: Link) -> list[str]:
    """Return the two shafts between the meshes of a split path.

    Args:
        link: Where it stands.
    """
    return [f"{link.names[0]}-left", f"{link.names[0]}-right"]


def _split(link: Link) -> Tables:
    first, second = link.names
    between = branches(link)
    return {
        "pairs": {
            first: _asked({"pinion": link.driving, "wheel": between, **halved(link.helix)}, link, 0, link.ratios[0]),
            second: _asked({"pinion": between, "wheel": link.driven, **halved(link.helix)}, link, 1, link.ratios[1]),
        }
    }


def _set(sun: str, ring: str, carrier: str) -> Callable[[Link], Tables]:
    """Return how a planetary set is written whose members are the driving shaft, the driven one and the ground.

    Args:
        sun: ``driving``, ``driven`` or ``ground``, as the others.
        ring: As the sun.
        carrier: As the sun.
    """

    def tables(link: Link) -> Tables:
        shafts = {"driving": link.driving, "driven": link.driven, GROUND: GROUND}
        stated = {"sun": shafts[sun], "ring": shafts[ring], "carrier": shafts[carrier]}
        ratio = BASIC[carrier, sun](link.ratios[0])
        counted: dict[str, Any] = {**stated, "planets": planets_beside(ratio)}
        return {"planetaries": {link.names[0]: _asked(counted, link, 0, ratio)}}

    return tables


def planets_beside(ratio: float) -> int:
    """Return how many planets stand beside each other in a set, five at most [-].

    Their tips clear each other where sin(π/N) (z_s + z_p) > z_p + 2, here of a sun of 25 teeth.

    Args:
        ratio: 1 + z_r/z_s [-].
    """
    planet = ratio / 2.0 - 1.0
    return next((count for count in (5, 4) if math.sin(math.pi / count) * (1.0 + planet) > planet + _TIPS), 3)


_TIPS = 2.0 / 25.0
"""Two tooth heights over the sun's teeth [-]."""
BASIC: Mapping[tuple[str, str], Callable[[float], float]] = {
    ("driven", "driving"): lambda ratio: ratio,
    (GROUND, "driving"): lambda ratio: ratio + 1.0,
    ("driven", GROUND): lambda ratio: ratio / (ratio - 1.0),
}
"""(carrier, sun) -> 1 + z_r/z_s, which a design asks of a planetary set, from the ratio of its speeds [-] (Willis)."""


def _stepped(carrier: str, ring: str) -> Callable[[Link], Tables]:
    """Return how a set with stepped planets is written, sun first.

    Args:
        carrier: ``driven`` or ``ground``.
        ring: The other one.
    """

    def tables(link: Link) -> Tables:
        shafts = {"driven": link.driven, GROUND: GROUND}
        wide, narrow = link.ratios[0], link.ratios[1]
        if carrier == "driven":
            narrow -= 1.0 / wide  # 1 + (z_1/z_s)(z_r/z_2) is the ratio of the whole
        sun, first, second, ring_teeth = stepped_teeth(wide, narrow)
        return {
            "epicyclics": {
                link.names[0]: {
                    "carrier": shafts[carrier], "sets": STEPPED_SETS,
                    "suns": {"sun": {"shaft": link.driving, "teeth": sun}},
                    "rings": {"ring": {"shaft": shafts[ring], "teeth": ring_teeth}},
                    "planets": {"wide": {"teeth": first, "meshes": ["sun"]},
                                "narrow": {"teeth": second, "meshes": ["ring"], "in_one_piece_with": "wide"}},
                }
            }
        }  # fmt: skip

    return tables


STEPPED_SETS = 3
"""Planets of a stepped set: the wide step leaves room for no more from a ratio of 2.1 on [-]."""
_SUNS = (21, 24, 27)
_SECONDS = range(20, 31)


def stepped_teeth(wide: float, narrow: float) -> tuple[int, int, int, int]:
    """Return teeth of sun, first step, second step and ring that come nearest to two ratios.

    Sun and ring have multiples of the number of planets, so that equally spaced planets of one timing mesh everywhere.

    Args:
        wide: First step over sun [-].
        narrow: Ring over second step [-].
    """

    def off(teeth: tuple[int, int, int, int]) -> tuple[float, int]:
        sun, first, second, ring = teeth
        return abs(first / sun * ring / second / (wide * narrow) - 1.0), sum(teeth)

    every = (
        (sun, round(wide * sun), second, STEPPED_SETS * round(narrow * second / STEPPED_SETS))
        for sun in _SUNS for second in _SECONDS
    )  # fmt: skip
    return min(every, key=off)


def _differential(link: Link) -> Tables:
    """Return a set of which engine and motor turn sun and ring, and the carrier turns what follows."""
    stated = {"sun": link.driving, "ring": link.ring, "carrier": link.driven, "ratio": link.ratios[0]}
    return {"planetaries": {link.names[0]: {**stated, "planets": planets_beside(link.ratios[0])}}}


PAIR = Kind("pair", "pair", 1, 1.3, 7.0, -1, _pair, toothed=True)
SPLIT = Kind("split path", "split", 2, 1.3, 7.0, 1, _split, toothed=True, branched=True)
PLANETARY = Kind("planetary set", "planetary", 1, 2.9, 11.0, 1, _set("driving", GROUND, "driven"))
STAR = Kind("star", "star", 1, 1.9, 10.0, -1, _set("driving", "driven", GROUND))
SOLAR = Kind("solar set", "solar", 1, 1.12, 1.52, 1, _set(GROUND, "driving", "driven"))
STEPPED = Kind("stepped set", "stepped", 2, 2.8, 5.5, 1, _stepped("driven", GROUND))
STEPPED_STAR = Kind("stepped star", "steppedstar", 2, 2.8, 5.5, -1, _stepped(GROUND, "driven"))
DIFFERENTIAL = Kind("differential", "differential", 1, 2.9, 11.0, 1, _differential, balanced=True)
KINDS = {kind.name: kind for kind in (PAIR, SPLIT, PLANETARY, STAR, SOLAR, STEPPED, STEPPED_STAR, DIFFERENTIAL)}
"""By name. Ratios: 1 + z_r/z_s of planetary sets lies between 2.9 and 11, where three planets stand beside each other
(z_p < 6.4 z_s) and are not smaller than the sun's own teeth allow; a differential's is that of its ring held. A stepped
set has two: of its first step over the sun, and what is left, both where three planets have room."""


# ----------------------------------------------------------------------------------------------------------------------
# Every train of a few stages that can give a ratio, with every place for a motor: structures alone, no numbers.
# ----------------------------------------------------------------------------------------------------------------------


class Seat(StrEnum):
    """How a motor drives a train."""

    NONE = "no motor"
    SHAFT = "on shaft"
    """It turns as the shaft does."""
    PAIR = "through a pair on shaft"
    """Its pinion drives a wheel of its own."""
    WHEEL = "through a pinion on the wheel of"
    """Its pinion meshes with a wheel that is there."""
    BRANCH = "on a branch of"
    """On one of two branches, which bears its torque alone."""
    PINIONS = "through a pinion between the branches of"
    """Its pinion meshes with the pinions of both branches."""
    RING = "on the ring of"
    """It turns the ring of a differential."""
    RIM = "through a pair on the ring of"
    """Its pinion meshes with teeth around the ring of a differential."""


@dataclass(frozen=True)
class Place:
    """Where a motor is."""

    seat: Seat
    at: int = 0
    """Number of the shaft, counted from the engine's, or of the stage, both from 0."""


@dataclass(frozen=True)
class Architecture:
    """A train of stages from engine to propeller, and where its motor is."""

    kinds: tuple[str, ...]
    """Names of the kinds of its stages, from the engine on."""
    motor: Place

    @property
    def members(self) -> tuple[Kind, ...]:
        """Its kinds."""
        return tuple(KINDS[name] for name in self.kinds)

    @property
    def stages(self) -> int:
        """How many stages it has [-]."""
        return sum(kind.stages for kind in self.members)

    @property
    def name(self) -> str:
        """In words: ``star, planetary set; motor on shaft 1``."""
        return f"{', '.join(self.kinds)}; {self._motor}"

    @property
    def _motor(self) -> str:
        """Where its motor is, in words."""
        seat, at = self.motor.seat, self.motor.at
        if seat is Seat.NONE:
            return str(seat)
        named = {0: "of the engine", len(self.kinds): "of the propeller"}.get(at, str(at))
        whose = named if seat in (Seat.SHAFT, Seat.PAIR) else f"{self.kinds[at]} {at + 1}"
        return f"motor {seat} {whose}"

    @property
    def slug(self) -> str:
        """Name of its file."""
        motor = "" if self.motor.seat is Seat.NONE else f"-motor-{self.motor.seat.name.lower()}-{self.motor.at}"
        return "-".join(kind.short for kind in self.members) + motor


def trains(
    ratio: float, *, stages: Sequence[int] = (2, 3), motor: bool = True, added: float = 0.0
) -> Iterator[Architecture]:
    """Yield every architecture that can give a ratio, each once, the ones of fewer stages first.

    Args:
        ratio: Speed of the engine over that of the propeller [-].
        stages: How many stages a train may have.
        motor: Whether there is one.
        added: Power of the motor over that of the engine, by which a differential's output is faster [-].
    """
    for count in stages:
        for length in range(1, count + 1):
            for members in product(KINDS.values(), repeat=length):
                if sum(kind.stages for kind in members) == count and reaches(members, ratio, added=added):
                    names = tuple(kind.name for kind in members)
                    yield from (Architecture(names, place) for place in _places(members, motor=motor))


def held(members: Sequence[Kind], ratio: float, added: float) -> float:
    """Return the ratio that stages must give together, the ring of a differential held [-].

    The ring adds the motor's power at the sun's torque: ω_s + ρ ω_r = (1 + ρ) ω_c with ρ ω_r = ω_s P_m/P_s (Willis).

    Args:
        members: Kinds of the stages.
        ratio: Wanted of them all [-].
        added: Power of the motor over that of the engine [-].
    """
    return ratio * (1.0 + added) if any(kind.balanced for kind in members) else ratio


def reaches(members: Sequence[Kind], ratio: float, *, added: float = 0.0) -> bool:
    """Return whether stages can give a ratio together.

    Args:
        members: Kinds of the stages.
        ratio: Wanted of them all [-].
        added: Power of the motor over that of the engine [-].
    """
    ratio = held(members, ratio, added)
    least = math.prod(kind.least**kind.stages for kind in members)
    return least <= ratio <= math.prod(kind.most**kind.stages for kind in members)


def _places(members: Sequence[Kind], *, motor: bool) -> Iterator[Place]:
    """Yield every place of a motor, or the one that says there is none."""
    balanced = [number for number, kind in enumerate(members) if kind.balanced]
    if balanced:
        if motor and len(balanced) == 1:
            yield from (Place(Seat.RING, balanced[0]), Place(Seat.RIM, balanced[0]))
        return
    if not motor:
        yield Place(Seat.NONE)
        return
    for shaft in range(len(members) + 1):
        yield from (Place(Seat.SHAFT, shaft), Place(Seat.PAIR, shaft))
    for number, kind in enumerate(members):
        if kind.toothed:
            yield Place(Seat.WHEEL, number)
        if kind.branched:
            yield from (Place(Seat.BRANCH, number), Place(Seat.PINIONS, number))


# ----------------------------------------------------------------------------------------------------------------------
# What a train is asked for: the machines, cases and rules of a design, whatever stages that design has itself.
# ----------------------------------------------------------------------------------------------------------------------


_SLOWEST_RATIO = 1.5
"""Least ratio that two stages are looked for [-]."""


@dataclass(frozen=True)
class Requirement:
    """One engine, one propeller, at most one motor."""

    design: Design
    """Whose machines, cases and rules count."""
    engine: str
    """Name of the turbine."""
    propeller: str
    """Name of the propeller."""
    motor: str | None
    """Name of the motor; None where there is none."""
    fastest: float
    """Speed that a motor may have [rad/s]."""

    @property
    def engine_speed(self) -> float:
        """Of the turbine [rad/s]."""
        return self.design.turbines[self.engine].speed

    @property
    def propeller_speed(self) -> float:
        """Asked of the propeller [rad/s]."""
        return self.design.propellers[self.propeller].speed

    @property
    def ratio(self) -> float:
        """Of the whole train [-]."""
        return self.engine_speed / self.propeller_speed

    @property
    def added(self) -> float:
        """Rated power of the motor over that of the engine; 0 without one [-]."""
        if self.motor is None:
            return 0.0
        return self.design.motors[self.motor].power / self.design.turbines[self.engine].power

    @property
    def added_in(self) -> dict[str, float]:
        """Case -> power of the motor over that of the engine [-]."""
        if self.motor is None:
            return {}
        found = dict[str, float]()
        for case in self.design.cases:
            drives = drives_of(self.design, case)
            engine = _power(self.design.turbines[self.engine], drives[self.engine])
            motor = _power(self.design.motors[self.motor], drives[self.motor])
            found[case] = motor / engine if engine > 0.0 else math.inf
        return found

    @property
    def slowed(self) -> tuple[str, float]:
        """Case in which a differential turns the propeller slowest, and that speed over the asked one [-].

        Its torques stand in a fixed ratio, so that a motor that gives less turns slower, and the propeller with it.
        """
        speeds = {case: (1.0 + added) / (1.0 + self.added) for case, added in self.added_in.items()}
        return min(speeds.items(), key=lambda item: item[1], default=("", 1.0))

    @property
    def helix(self) -> float | None:
        """Helix angle of its gears [rad]; None where the design states none."""
        return self.design.gears.helix_angle or None


def _power(machine: Turbine | Motor, drive: Drive) -> float:
    """Return what a machine gives in a case [W]."""
    if drive.power is not None:
        return drive.power
    if drive.torque is not None:
        return drive.torque * (drive.speed or machine.speed)
    return (drive.rating or 0.0) * machine.power


def requirement_of(design: Design, *, fastest: float | None = None) -> Requirement:
    """Return what a design asks of any train in its place.

    Args:
        design: With one turbine and one propeller, and perhaps a motor.
        fastest: Speed that the motor may have [rad/s]; left out: that of the faster of motor and turbine.

    Raises:
        DesignError: Where it has other machines, or its propeller is not slower than its turbine.
    """
    refuse(_problems(design, fastest), design.name)
    engine, propeller = next(iter(design.turbines)), next(iter(design.propellers))
    motor = next(iter(design.motors), None)
    speeds = [design.turbines[engine].speed, *(one.speed for one in design.motors.values())]
    return Requirement(design, engine, propeller, motor, max(speeds) if fastest is None else fastest)


def _problems(design: Design, fastest: float | None) -> Iterator[Problem]:
    """Yield what no train of these architectures serves."""
    for table, least, most in (("turbines", 1, 1), ("propellers", 1, 1), ("motors", 0, 1)):
        count = len(getattr(design, table))
        if not least <= count <= most:
            asked = "one" if least else "at most one"
            fix = "state one" if count < least else "leave the others out"
            yield Problem(table, f"there are {count}; architectures are enumerated for {asked}: {fix}")
    for table in ("rotors", "generators", "accessories", "loads"):
        if getattr(design, table):
            names = ", ".join(getattr(design, table))
            yield Problem(table, f"{names}: architectures have engine, motor and propeller alone; leave it out")
    if fastest is not None and not 0.0 < fastest < math.inf:
        yield Problem("fastest", f"a motor of {fastest:g} rad/s is asked; it must be above 0 and finite")
    for name, turbine in list(design.turbines.items())[:1]:
        for driven, propeller in list(design.propellers.items())[:1]:
            if turbine.speed < _SLOWEST_RATIO * propeller.speed:
                yield Problem(
                    f"propellers.{driven}.speed_rpm",
                    f"is not below {1 / _SLOWEST_RATIO:.2f} of the speed of {name}: there is nothing to reduce",
                )


# ----------------------------------------------------------------------------------------------------------------------
# What stepped planets turn on: places of both steps along the pin, and the strongest bearing that each step holds.
# ----------------------------------------------------------------------------------------------------------------------


GAP = 5e-3
"""Between the plate and the wide step, and between the steps [m]; an estimate."""
STEPS = ("wide", "narrow")
"""Of a stepped planet, from the plate on."""
_SMALLEST = "NU 202"
_MM = 1e-3


def borne(design: Design) -> Design:
    """Return a design whose stepped planets have places and cylindrical roller bearings in both steps.

    Rolling bearings in a stepped planet are not chosen by sizing: each step gets the strongest of the catalogue that
    its rim and its face hold. Whether that lives is for the checks to say. Designs without such sets stay as they are.

    Args:
        design: At level preliminary.

    Raises:
        DesignError: As `size`.
    """
    if not design.epicyclics:
        return design
    standing = edited(design, dict(_standing(size(design))))
    return edited(standing, dict(_strongest(size(standing))))


def _standing(sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield where both steps of every stepped planet stand along their pin, with the smallest bearing in each."""
    for name in sizing.design.epicyclics:
        place = GAP
        for step in STEPS:
            width = next(gear.face_width for gear in sizing.gears if (gear.stage, gear.own) == (name, step))
            yield f"{_path(name, step)}.place_mm", (place + width / 2.0) / _MM
            yield f"{_path(name, step)}.bearing", {"designation": _SMALLEST}
            place += width + GAP


def _strongest(sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield the cylindrical roller bearing with the largest rating that stands in each step."""
    rollers = [one for one in bearings().values() if one.kind is BearingKind.CYLINDRICAL]
    for name in sizing.design.epicyclics:
        for step in STEPS:
            gear = next(gear for gear in sizing.gears if (gear.stage, gear.own) == (name, step))
            room = next(_rooms(sizing, name, step), 0.0)
            fitting = [one for one in rollers if one.outer_diameter <= room and one.width <= gear.face_width]
            if fitting:
                best = max(fitting, key=lambda one: (one.dynamic_rating, one.designation))
                yield f"{_path(name, step)}.bearing", {"designation": best.designation}


def _rooms(sizing: Sizing, stage: str, step: str) -> Iterator[float]:
    """Yield the largest outside that the rim of a step leaves a bearing [m]."""
    for check in sizing.checks:
        if check.mode == "room in the rim" and (check.part.name, check.part.own) == (stage, step):
            yield check.limit or 0.0


def _path(stage: str, step: str) -> str:
    return f"epicyclics.{stage}.planets.{step}"


# ----------------------------------------------------------------------------------------------------------------------
# An architecture with numbers becomes a design: ratios of its stages, speed of its motor.
# ----------------------------------------------------------------------------------------------------------------------


_ORDINALS: tuple[str, ...] = ("first", "second", "third", "fourth")
_ENGINE, _PROPELLER, _MOTOR = "input", "output", "motor"
_MOTOR_STAGE = "motor-stage"
SLOWER, FASTER = 0.7, 6.0
"""Ratios between which a pair may reduce a motor's speed [-]."""
_PLACED = ("layout", "keep_out", "supports", "errors", "bearings", "joints", "waivers", "overrides", "origins")
_STAGES = ("pairs", "planetaries", "epicyclics", "clutches", "dampers")
_STANDS = (Seat.SHAFT, Seat.BRANCH)
_RING = "ring"
_SPARE = 1.03
"""Rating of a motor that balances over what is asked of it: teeth give the ratio of torques only nearly [-]."""
_SLOWEST = 0.1
"""That a design may give a motor, where it gives nothing in a case and only holds [rad/s]."""


@dataclass(frozen=True)
class Built:
    """A design of an architecture."""

    design: Design
    ratios: tuple[float, ...]
    """Of its stages, one after the other [-]."""
    motor_speed: float | None
    """[rad/s]; None where there is no motor."""


def freedoms(architecture: Architecture) -> int:
    """Return how many numbers an architecture has: ratios that are not left over, and perhaps the speed of its motor.

    Args:
        architecture: Of any kinds.
    """
    return architecture.stages - 1 + (architecture.motor.seat in (Seat.PAIR, Seat.WHEEL, Seat.PINIONS, Seat.RIM))


def built(requirement: Requirement, architecture: Architecture, places: Sequence[float]) -> Built:
    """Return the design of an architecture at a place in the range of its numbers.

    Args:
        requirement: Machines, cases and rules.
        architecture: That is to serve it.
        places: Of every number within its range, from 0 to 1 [-].

    Raises:
        DesignError: Where no motor's speed is within reach, or the design cannot be.
    """
    ratios = _ratios(architecture, held(architecture.members, requirement.ratio, requirement.added), places)
    shafts, links = _links(requirement, architecture, ratios)
    motor = _motor_speed(requirement, architecture, ratios, places)
    if architecture.motor.seat in _STANDS:
        links = _left_open(architecture, links)
    tables = _together([kind.tables(link) for kind, link in zip(architecture.members, links, strict=True)])
    stage = _motor_stage(architecture, links, shafts)
    if architecture.motor.seat is Seat.RIM and motor is not None:
        stage["pairs"][_MOTOR_STAGE]["ratio"] = motor / _turned(requirement, architecture, ratios)
    tables = _together([tables, stage])
    balanced = architecture.motor.seat in (Seat.RING, Seat.RIM)
    shafts = [*shafts, *([_RING] if architecture.motor.seat is Seat.RIM else []),
              *([_MOTOR] if stage or balanced else [])]  # fmt: skip
    split = [link for kind, link in zip(architecture.members, links, strict=True) if kind.branched]
    named = [*shafts, *(name for link in split for name in branches(link))]
    changes: dict[str, Any] = {name: {} for name in (*_PLACED, *_STAGES)} | dict(tables)
    changes |= as_concept(requirement.design)
    changes |= {"shafts": named, "name": f"{requirement.design.name}: {architecture.name}"}
    changes["description"] = f"One of the architectures for the machines of {requirement.design.name}."
    changes[f"turbines.{requirement.engine}.shaft"] = _ENGINE
    changes[f"propellers.{requirement.propeller}.shaft"] = _PROPELLER
    if requirement.motor is not None and motor is not None:
        changes[f"motors.{requirement.motor}.shaft"] = _motor_shaft(architecture, links, shafts)
        changes[f"motors.{requirement.motor}.speed_rpm"] = motor / RPM
        if balanced:
            changes |= dict(_balanced(requirement, architecture, motor))
    return Built(edited(requirement.design, changes), ratios, motor)


def _balanced(requirement: Requirement, architecture: Architecture, motor: float) -> Iterator[tuple[str, Any]]:
    """Yield what makes a motor balance a differential: in every case the speed at which it gives its power.

    The set fixes the ratio of the torques, so that a motor that gives less turns slower, and the propeller with it.
    """
    path = f"motors.{requirement.motor}"
    yield f"{path}.balances", True
    yield f"{path}.power_w", _SPARE * requirement.added * requirement.design.turbines[requirement.engine].power
    before = math.prod(kind.senses for kind in architecture.members[: architecture.motor.at])
    yield f"{path}.reverse", before == (1 if architecture.motor.seat is Seat.RIM else -1)
    for case, added in requirement.added_in.items():
        speed = max(motor * added / requirement.added, _SLOWEST)
        drive = f"cases.{case}.{requirement.motor}"
        yield from ((f"{drive}.{given}", None) for given in ("power_w", "torque_nm", "rating"))
        yield from ((f"{drive}.balances", True), (f"{drive}.speed_rpm", speed / RPM))
        yield f"cases.{case}.{requirement.engine}.speed_rpm", requirement.engine_speed / RPM


def _ratios(architecture: Architecture, ratio: float, places: Sequence[float]) -> tuple[float, ...]:
    """Return the ratio of every stage: each within its kind's range and where the others can give what is left."""
    kinds = [kind for kind in architecture.members for _ in range(kind.stages)]
    chosen, left = list[float](), ratio
    for number, kind in enumerate(kinds[:-1]):
        following = kinds[number + 1 :]
        least = max(kind.least, left / math.prod(after.most for after in following))
        most = min(kind.most, left / math.prod(after.least for after in following))
        chosen.append(least * (most / least) ** places[number])
        left /= chosen[-1]
    return (*chosen, left)


def _links(
    requirement: Requirement, architecture: Architecture, ratios: Sequence[float]
) -> tuple[list[str], list[Link]]:
    """Return the shafts from engine to propeller, and where each kind stands between them."""
    members = architecture.members
    inner = [f"shaft-{number + 1}" for number in range(len(members) - 1)]
    shafts = [_ENGINE, *inner, _PROPELLER]
    asked = [True] * (len(ratios) - 1) + [False]
    links, first = list[Link](), 0
    for number, kind in enumerate(members):
        own = slice(first, first + kind.stages)
        links.append(
            Link(
                _ORDINALS[own],
                shafts[number],
                shafts[number + 1],
                tuple(ratios[own]),
                tuple(asked[own]),
                requirement.helix or HELIX,
                {Seat.RING: _MOTOR, Seat.RIM: _RING}.get(architecture.motor.seat, GROUND),
            )
        )
        first += kind.stages
    return shafts, links


def _speeds(requirement: Requirement, architecture: Architecture, ratios: Sequence[float]) -> list[float]:
    """Return the speed of every shaft from engine to propeller, in size [rad/s]."""
    speeds, first = [requirement.engine_speed], 0
    for kind in architecture.members:
        faster = 1.0 + requirement.added if kind.balanced else 1.0
        speeds.append(speeds[-1] * faster / math.prod(ratios[first : first + kind.stages]))
        first += kind.stages
    return speeds


def _branch_speed(architecture: Architecture, speeds: Sequence[float], ratios: Sequence[float]) -> float:
    """Return the speed of the branches of the split path beside which the motor is [rad/s]."""
    at = architecture.motor.at
    return speeds[at] / ratios[sum(kind.stages for kind in architecture.members[:at])]


def _motor_speed(
    requirement: Requirement, architecture: Architecture, ratios: Sequence[float], places: Sequence[float]
) -> float | None:
    """Return the speed of the motor [rad/s]: its shaft's, or within what a pair can reduce."""
    seat = architecture.motor.seat
    if seat is Seat.NONE:
        return None
    turned = _turned(requirement, architecture, ratios)
    if seat in (*_STANDS, Seat.RING):
        return _within(turned, requirement.fastest)
    least, most = SLOWER * turned, min(FASTER * turned, requirement.fastest)
    if least > most:
        raise DesignError([Problem("motors", f"no pair brings at most {requirement.fastest / RPM:.0f} rpm there")])
    place: float = places[-1]
    return least * math.pow(most / least, place)


def _turned(requirement: Requirement, architecture: Architecture, ratios: Sequence[float]) -> float:
    """Return the speed of what the motor turns [rad/s]."""
    seat, at = architecture.motor.seat, architecture.motor.at
    speeds = _speeds(requirement, architecture, ratios)
    if seat in (Seat.RING, Seat.RIM):
        basic = ratios[sum(kind.stages for kind in architecture.members[:at])]
        return speeds[at] * requirement.added / (basic - 1.0)
    if seat in (Seat.BRANCH, Seat.PINIONS) or (seat is Seat.WHEEL and architecture.members[at].stages > 1):
        return _branch_speed(architecture, speeds, ratios)
    return speeds[at + (seat is Seat.WHEEL)]


def _within(speed: float, fastest: float) -> float:
    if speed > fastest * (1.0 + 1e-9):
        turns = f"its shaft turns at {speed / RPM:.0f} rpm, a motor may at {fastest / RPM:.0f}"
        raise DesignError([Problem("motors", turns)])
    return speed


def _left_open(architecture: Architecture, links: list[Link]) -> list[Link]:
    """Return links of which the stage before the motor's shaft asks for no ratio: the motor's speed does."""
    seat, at = architecture.motor.seat, architecture.motor.at
    if seat is Seat.SHAFT and not 0 < at < len(links):
        return links
    link = links[at] if seat is Seat.BRANCH else links[at - 1]
    open_one = 0 if seat is Seat.BRANCH else len(link.ratios) - 1
    asked = tuple(number != open_one and is_asked for number, is_asked in enumerate(link.asked))
    changed = replace(link, asked=asked)
    return [changed if one is link else one for one in links]


def _motor_stage(architecture: Architecture, links: Sequence[Link], shafts: Sequence[str]) -> Tables:
    """Return the motor's own pair; nothing where it sits on a shaft that is there."""
    seat, at = architecture.motor.seat, architecture.motor.at
    if seat not in (Seat.PAIR, Seat.WHEEL, Seat.PINIONS, Seat.RIM):
        return {}
    wheel = {
        Seat.RIM: lambda: _RING, Seat.PAIR: lambda: shafts[at],
        Seat.WHEEL: lambda: str(gear_part(links[at].names[0], Role.WHEEL)),
        Seat.PINIONS: lambda: str(gear_part(links[at].names[1], Role.PINION)),
    }[seat]()  # fmt: skip
    stated: dict[str, Any] = {"pinion": _MOTOR, "wheel": wheel, **halved(links[0].helix)}
    return {"pairs": {_MOTOR_STAGE: stated}}


def _motor_shaft(architecture: Architecture, links: Sequence[Link], shafts: Sequence[str]) -> str:
    """Return the shaft that the motor drives."""
    seat, at = architecture.motor.seat, architecture.motor.at
    if seat is Seat.SHAFT:
        return shafts[at]
    return branches(links[at])[1] if seat is Seat.BRANCH else _MOTOR


def _together(tables: Sequence[Tables]) -> Tables:
    """Return the tables of several as one."""
    kinds = dict.fromkeys(name for table in tables for name in table)
    return {name: {key: row for table in tables for key, row in table.get(name, {}).items()} for name in kinds}
