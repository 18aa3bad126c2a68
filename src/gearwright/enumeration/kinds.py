"""Kinds of stages, and every gear train of a few stages that gives a ratio."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import product
from typing import Any

from gearwright.spec import GROUND

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
