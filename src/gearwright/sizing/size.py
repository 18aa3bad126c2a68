"""Sizing of a transmission from its design, with the torque, mass and inertia of its machines."""

from __future__ import annotations

import heapq
import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import count
from operator import itemgetter
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from gearwright.base import (
    BEYOND_SIZING,
    ROUNDING,
    Check,
    DesignError,
    Kind,
    PartId,
    Role,
    accepted,
    largest,
    refuse,
    smallest_first,
    unknown_waivers,
    verb,
)
from gearwright.machines import (
    LENGTH_RATIO,
    cooling_mass,
    inverter_mass,
    motor_diameter,
    motor_mass,
    motor_mass_ndarc,
    motor_mass_power_law,
    propeller_inertia,
    rotor_inertia,
    turbine_diameter,
    turbine_inertia,
)
from gearwright.sizing.answers import locking_checks
from gearwright.sizing.bearing_seats import named_room
from gearwright.sizing.bearings import planet_lives
from gearwright.sizing.installation import installation_checks
from gearwright.sizing.losses import dipping
from gearwright.sizing.mass import as_made, complete_mass, refuse_dishes
from gearwright.sizing.places import (
    beside_checks,
    coaxial_checks,
    hollow_checks,
    keep_out_checks,
    order_checks,
    pin_checks,
    room_checks,
    settle,
)
from gearwright.sizing.places.frames import CLAUSE as ROOM
from gearwright.sizing.planets import bearing_margins, film_checks, fit_planets
from gearwright.sizing.rating import MESHES, Context, Known, load_sharing, rating_of
from gearwright.sizing.result import GearSizing, MachineSizing, Sizing, refuse_no_numbers
from gearwright.sizing.shafts import built_checks, carrier_checks, shaft_checks
from gearwright.sizing.shafts.stretches import face_load_checks
from gearwright.sizing.stage_sizes import AS_NEAR, NEAR, StageSize
from gearwright.sizing.stages import Geared, geared, gearings, with_face, with_module
from gearwright.sizing.teeth import CONSIDERED, EQUAL, Chosen, StageTeeth, choose_teeth, stage_teeth
from gearwright.sizing.teeth.candidates import is_given, planet_counts
from gearwright.sizing.webs import web_checks
from gearwright.spec import Airscrew, Design, ElectricMachine, Epicyclic, Machine, Turbine
from gearwright.spec.design import BUILT, CONCEPT, PRELIMINARY, RATINGS, Given, Rotor, given_values, module_owners
from gearwright.train import Train, build_train

# ----------------------------------------------------------------------------------------------------------------------
# Machines as the gearbox needs them: torque, mass of motors, inertia of what turns; how fast tips of rotors are.
# ----------------------------------------------------------------------------------------------------------------------


FASTEST_TIP = 250.0
"""Tip speed of a rotor that leaves the advancing blade some forward speed [m/s]: Mach 0.73 at sea level. The UH-1H with
14.63 m at 324 rpm has 248 m/s, faster than helicopters since; 200 to 225 m/s are usual."""
_MASS_LAWS: Mapping[str, Callable[[float, float], float]] = MappingProxyType({
    "public": motor_mass,
    "ndarc": lambda torque, _: motor_mass_ndarc(torque),
    "thesis": lambda torque, _: motor_mass_power_law(torque),
})  # fmt: skip
"""Law of the mass of an electric machine, of torque [N m] and speed [rad/s]."""


def size_machines(context: Context) -> tuple[MachineSizing, ...]:
    """Return every machine.

    Args:
        context: What sizing reads.
    """
    return tuple(_machine(context, name, machine) for name, machine in context.design.machines.items())


def machine_checks(context: Context) -> Iterator[Check]:
    """Yield the tip speed of every rotor in the case that turns it the fastest.

    Args:
        context: What sizing reads.
    """
    for name, machine in context.design.machines.items():
        if isinstance(machine, Rotor):
            case, speed = largest(
                ((case, abs(flow.speeds[machine.shaft])) for case, flow in context.flows.items()),
                lambda turning: turning[1],
            )
            yield Check(
                PartId(Kind.MACHINE, name), "tip speed", "UH-1H: 248 m/s, Mach 0.73", speed * machine.diameter / 2.0,
                FASTEST_TIP, "velocity", at_most=True, exponent=None, case=case,
            )  # fmt: skip


def _machine(context: Context, name: str, machine: Machine) -> MachineSizing:
    if machine.rating is not None and machine.asked_speed is not None:
        torque = machine.rating / machine.asked_speed
    else:
        torque = max(abs(flow.machine_torques[name]) for flow in context.flows.values())
    mass = _mass(context, name, machine, torque)
    inverter, cooling = _beside(context, name, machine)
    given: float | None = getattr(machine, "inertia", None)
    return MachineSizing(
        name=name,
        kind=type(machine).__name__.lower(),
        shaft=machine.shaft,
        torque=torque,
        mass=mass,
        inertia=_inertia(machine, mass) if given is None else given,
        inertia_is_given=given is not None,
        inverter=inverter,
        cooling=cooling,
    )


def _mass(context: Context, name: str, machine: Machine, torque: float) -> float | None:
    if not isinstance(machine, ElectricMachine):
        return context.given.get(f"{name}.mass")
    return context.given.get(f"{name}.mass", _MASS_LAWS[machine.mass_law](torque, machine.speed))


def _beside(context: Context, name: str, machine: Machine) -> tuple[float | None, float | None]:
    """Return the masses of a machine's inverter and cooling, counted beside the public law or where asked for [kg]."""
    if not isinstance(machine, ElectricMachine):
        return None, None
    counted = machine.mass_law == "public" and f"{name}.mass" not in context.given
    inverter = cooling = None
    if machine.inverter is not None:
        inverter = inverter_mass(machine.power, machine.inverter)
    elif counted:
        inverter = inverter_mass(machine.power)
    if machine.cooling is not None:
        cooling = cooling_mass(machine.power, machine.cooling)
    elif counted:
        cooling = cooling_mass(machine.power)
    return context.given.get(f"{name}.inverter_mass", inverter), context.given.get(f"{name}.cooling_mass", cooling)


def _inertia(machine: Machine, mass: float | None) -> float:
    """Return the estimated inertia; none of what is too various to estimate [kg m²]."""
    match machine:
        case Turbine():
            return turbine_inertia(machine.diameter or turbine_diameter(machine.speed))
        case ElectricMachine():
            return rotor_inertia(mass or 0.0, motor_diameter(mass or 0.0, LENGTH_RATIO[machine.flux]))
        case Airscrew():
            return propeller_inertia(machine.diameter, machine.blades)
        case _:
            return 0.0


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a design becomes a sized transmission.
# ----------------------------------------------------------------------------------------------------------------------


COMPLETED = {CONCEPT: (3, 10), PRELIMINARY: (3, 12), BUILT: (1, 1)}
"""Level -> gears, of one or several choices of teeth, that are completed before the lightest that passes is taken; and
at most, where none passes so far [-]."""
TOGETHER = 7
"""Stages of all gears that are completed, where they are few: one after the other costs a few milliseconds [-]."""
UNFIT, NARROW = 4, 20
"""Gears that have no bearing of planets which serves, and gears passed over as no larger than such, that count as a
transmission [-]."""
FINEST = 1e-3
"""Step of face widths that are tried for bearings of planets [m]."""
NEARLY = 0.8
"""Face width from which sizes are looked for over that which bearings of planets seem to ask for [-]."""
NO_MARGIN = 0.05
"""Margin of a bearing below which none is believed [-]."""
HOPE = 0.7
"""Margin of the worst check that some transmission has come to, or only half as many are completed [-]."""
LITTLE = 0.3
"""The same below which a wider face cannot help, so that teeth are not chosen anew by what it should be [-]."""
CROWDED, ALIKE = 3, 0.05
"""Transmissions whose bodies have no room, after which none with such modules is completed until one passes, and part
by which modules may differ that count as the same [-]."""
FILMS = 0.05
"""By how much a bevel pair is heavier than the search has it, over all gears, for its films to be looked at [-]."""
SIZED = 12
"""Choices of teeth that are sized at most [-]."""
FIRST = 4
"""How many of them are sized before what they weigh tells how far the estimates of the others are off [-]."""


@verb
def size(design: Design) -> Sizing:
    """Return the sized transmission: teeth, modules, widths, stresses, margins, shafts, carriers, masses.

    Of several choices of teeth, modules and widths that are completed the lightest is taken that passes its checks, or
    where none does, of which the fewest fail.

    Args:
        design: As `gearwright.read` gives it. Rated powers and every case of it are carried.

    Raises:
        DesignError: If speeds, teeth or torques cannot be had; with the path and what would do.
    """
    return _sized(design)


def size_unturned(design: Design) -> Sizing:
    """Return a sizing whose open axes stand where they stand first: masses to compare, no room to rely on.

    Args:
        design: As `size` takes it.

    Raises:
        DesignError: As `size`.
    """
    return _sized(design, still=True)


@np.errstate(all="ignore")  # what overflows or is no number does not pass the gate
def _sized(design: Design, *, still: bool = False) -> Sizing:
    """Return the transmission of the teeth that are taken at the level of a design."""
    given = given_values(design)
    refuse(given.problems)
    return _lightest(design, build_train(design), given.values, still=still)


def is_settled(design: Design) -> bool:
    """Tell whether a design gives all teeth, and the modules of all gears that a standard rates.

    Args:
        design: As read.
    """
    given = given_values(design).values
    if not all(is_given(stage) and len(planet_counts(name, design)) == 1 for name, stage in design.stages.items()):
        return False
    for name, owner in {**{name: name for name in design.epicyclics}, **module_owners(design)}.items():
        stage = design.stages[name]
        keys = stage.toothed if isinstance(stage, Epicyclic) else ()
        paths = [f"{owner}.module", f"{owner}.outer_module", *(f"{name}.{gear}.module" for gear in keys)]
        if RATINGS[design.rating(name)].table and not any(path in given for path in paths):
            return False
    return True


class Fitted(NamedTuple):
    """Gears whose planets have the bearings that the design asks for."""

    found: Geared
    gears: tuple[GearSizing, ...]
    margins: Mapping[str, float]
    """Set of which something is open -> the least of what bearings of its planets have over what they must have [-]."""

    @classmethod
    def of(cls, found: Geared, fixed: frozenset[str] = frozenset()) -> Fitted:
        """Return gears with what their planets turn on.

        Args:
            found: Gears and meshes.
            fixed: Sets of which nothing is open.

        Raises:
            DesignError: No bearing has room in a planet.
        """
        gears = fit_planets(found.context, found.gears)
        margins = bearing_margins(found.context, found.gears, gears)
        return cls(found, gears, {stage: margin for stage, margin in margins.items() if stage not in fixed})

    @property
    def margin(self) -> float:
        """Least of them [-]."""
        return min(self.margins.values(), default=math.inf)

    def asked_face(self, stage: str) -> float:
        """Return the face with which bearings of a set that do not serve may do so, as their margins rise with it [m].

        Args:
            stage: Of those that fall short.
        """
        width = self.short_of[stage].face_width
        return max(width / max(self.margins[stage], NO_MARGIN), width + FINEST)

    @property
    def short_of(self) -> Mapping[str, GearSizing]:
        """Set whose bearings do not serve -> its planets."""
        return {
            gear.stage: gear
            for gear in self.gears
            if gear.role is Role.PLANET and self.margins.get(gear.stage, math.inf) < 1.0 - ROUNDING
        }


@dataclass
class _Looked:
    """What came of the gears that were looked at."""

    fixed: frozenset[str] = frozenset()
    """Sets of which nothing is open, so that no choice helps the bearings of their planets."""
    sized: int = 0
    """Choices of teeth whose gears came out [-]."""
    off: float = math.inf
    """Mass of sized gears over the estimate of the search, the least of all [-]."""
    narrow: int = 0
    """Gears that are passed over as their planets are no larger than those of others that are unfit [-]."""
    crowded: int = 0
    """Gears that are passed over as bodies of several others with such modules have no room [-]."""
    unfit: list[Fitted] = field(default_factory=list)
    """Gears whose planets have no bearing that serves."""
    short: list[Geared] = field(default_factory=list)
    """Gears of those that fall short of what is asked of them."""
    refused: list[DesignError] = field(default_factory=list)
    whole: list[Sizing] = field(default_factory=list)
    """Transmissions that are completed."""

    def complete(self, gears: Geared | Fitted, given: Mapping[str, Given], *, still: bool) -> None:
        """Add the transmission of some gears, or why there is none."""
        try:
            fitted = gears if isinstance(gears, Fitted) else Fitted.of(gears, self.fixed)
            self.whole.append(completed(fitted, given, still=still))
        except DesignError as error:
            self.refused.append(error)

    def asked_faces(self, gears: Geared) -> dict[str, float]:
        """Return set -> face that bearings ask for in planets that are no smaller, no narrower and no fewer [m].

        Of sets whose planets are no larger, no wider and no more than some in which no bearing serves.

        Args:
            gears: Of a transmission that is not completed yet.
        """
        planets = {gear.stage: gear for gear in gears.gears if gear.role is Role.PLANET}
        found = dict[str, float]()
        for one in self.unfit:
            for stage, planet in one.short_of.items():
                if _is_within(planets[stage], planet):
                    found[stage] = max(found.get(stage, 0.0), one.asked_face(stage))
        return found

    @property
    def passing(self) -> list[Sizing]:
        """Those that pass all their checks that a choice can help."""
        return [sizing for sizing in self.whole if not self.failing(sizing)]

    def failing(self, sizing: Sizing) -> list[Check]:
        """Return the checks that fail, but for bearings of planets that no choice helps.

        Args:
            sizing: That is completed.
        """
        return [check for check in sizing.checks if check.fails and not self._is_fixed(check.part)]

    def _is_fixed(self, part: PartId) -> bool:
        return part.kind is Kind.BEARING and part.role is Role.PLANET and part.name in self.fixed

    @property
    def hope(self) -> float:
        """Margin of the worst check of the transmission that comes nearest to passing, or of its bearings [-]."""
        worst = (min((check.margin or 0.0 for check in self.failing(sizing)), default=1.0) for sizing in self.whole)
        return max((*worst, *(one.margin for one in self.unfit)), default=1.0)

    @property
    def nearest(self) -> Geared | None:
        """Of the gears that fall short those that come nearest to what is asked, of equals the lightest; None: none."""
        best: Geared | None = None
        for gears in self.short:
            ahead = 0.0 if best is None else gears.nearness - best.nearness
            if best is None or ahead > EQUAL or (ahead >= -EQUAL and gears.estimate < best.estimate * (1.0 - EQUAL)):
                best = gears
        return best

    def nearest_unfit(self, most: int) -> list[Fitted]:
        """Return of the lightest gears whose planets have no bearing that serves those that come nearest to it.

        Args:
            most: How many at most [-].
        """
        least = min((one.found.estimate for one in self.unfit), default=0.0)
        light = [one for one in self.unfit if one.found.estimate <= NEAR * least * (1.0 + EQUAL)]
        return sorted(light, key=lambda one: round(-one.margin / AS_NEAR))[:most]

    def ranked(self) -> list[tuple[float, Sizing]]:
        """Return those of which the fewest checks fail, with what they weigh complete, the lightest first [kg].

        Of equals the first; one alone is not weighed.
        """
        if not self.whole:
            raise self.refused[0]
        fewest = min(map(_failing, self.whole))
        among = [sizing for sizing in self.whole if _failing(sizing) == fewest]
        if len(among) == 1:
            return [(math.inf, among[0])]
        return smallest_first([(complete_mass(sizing).total, sizing) for sizing in among], itemgetter(0))


def _is_within(planet: GearSizing, other: GearSizing) -> bool:
    """Tell whether planets of a set are no larger, no wider and no more than others, but for rounding."""
    most = 1.0 + EQUAL
    return (
        planet.bodies <= other.bodies
        and planet.pitch_diameter <= other.pitch_diameter * most
        and planet.face_width <= other.face_width * most
    )


def _fixed_sets(design: Design, given: Mapping[str, Given]) -> frozenset[str]:
    """Return the planetary sets of which teeth, planets, module and face width are given."""
    return frozenset(
        name
        for name, stage in design.planetaries.items()
        if is_given(stage)
        and len(planet_counts(name, design)) == 1
        and f"{name}.module" in given
        and f"{name}.face_width" in given
    )


def _failing(sizing: Sizing) -> int:
    """Return how many checks fail [-]."""
    return sum(check.fails for check in sizing.checks)


def _lightest(design: Design, train: Train, given: Mapping[str, Given], *, still: bool = False) -> Sizing:
    """Return of the choices of teeth and sizes that are completed the lightest that passes, or the nearest to it."""
    looked, known = _Looked(_fixed_sets(design, given)), MESHES.now()
    if design.compares_sizes:
        _compare(design, train, given, looked, still=still)
        return _told(looked, failing=len(looked.short))
    for choice in choose_teeth(design, train):
        try:
            gears = geared(design, train, choice, given=given, known=known)
        except DesignError as error:
            looked.refused.append(error)
            continue
        looked.complete(gears, given, still=still)
    looked.sized = len(looked.whole)
    return _told(looked, failing=len(looked.whole) - len(looked.passing))


def _told(looked: _Looked, *, failing: int) -> Sizing:
    """Return the best with what was looked at."""
    ranked = looked.ranked()
    best = ranked[0][1]
    if best.search is None or looked.sized + len(looked.refused) == 1:
        return best
    search = replace(
        best.search,
        sized=looked.sized,
        failing=failing,
        refused=len(looked.refused),
        next_sized_mass=ranked[1][0] if len(ranked) > 1 else math.inf,
    )
    return replace(best, search=search)


class _Course(NamedTuple):
    """A choice of teeth, or gears with them and, after them, those of other sizes."""

    place: int
    """Of the choice of teeth [-]."""
    gears: Geared | None = None
    """None where they are not sized yet."""
    others: Iterator[Geared] = iter(())
    mass: float = 0.0
    """By which it stands in the queue, where its gears are not sized yet [kg]."""
    unfit: Fitted | None = None
    """The same with narrower faces, in whose planets no bearing serves."""


def _compare(design: Design, train: Train, given: Mapping[str, Given], looked: _Looked, *, still: bool) -> None:
    """Size teeth and complete gears with them, always what weighs least by the estimate, until it is enough."""
    search = _Comparison(design, train, given, looked, choose_teeth(considering(design), train))
    while not search.is_enough():
        if search.asks_for_faces():
            search.begin_anew()
        if search.asks_for_films():
            search.begin_with_films()
        if (course := search.lightest()) is None:
            break
        if course.gears is not None:
            search.complete(course, course.gears, still=still)
        elif search.has_enough_teeth():
            continue
        elif (expected := search.expected(course)) > course.mass * (1.0 + EQUAL):
            search.put_back(course, expected)
        else:
            search.size_gears(course)
    for unfit in [] if looked.passing else looked.nearest_unfit(COMPLETED[design.level][1]):
        looked.complete(unfit, given, still=still)
    if not looked.whole and (nearest := looked.nearest) is not None:
        looked.complete(nearest, given, still=still)


class _Comparison:
    """Choices of teeth, and gears with them in several sizes, of which the lightest by the estimate comes next."""

    def __init__(
        self, design: Design, train: Train, given: Mapping[str, Given], looked: _Looked, choices: Sequence[Chosen]
    ) -> None:
        self.design, self.train, self.given, self.looked = design, train, given, looked
        self.choices = list(choices)
        self.known = MESHES.now()
        self.queue = [
            (choice.gear_mass, place, _Course(place, mass=choice.gear_mass)) for place, choice in enumerate(choices)
        ]
        """What they weigh by the estimate [kg], then in which order they came."""
        heapq.heapify(self.queue)
        self.order = count(len(choices))
        self.waiting = list[_Course]()
        """Gears of which the next size is not looked for yet."""
        self.poor = set[StageTeeth]()
        """Teeth of stages that fell short."""
        self.areas = dict[str, float]()
        """Set -> least face times diameter of all its planets, as far as their bearings have told [m²]."""
        self.narrow = dict[int, set[tuple[str, StageSize]]]()
        """Choice of teeth -> sizes of sets in whose planets no bearing serves."""
        self.crowded = Counter[frozenset[tuple[str, int]]]()
        """Modules of all stages, about -> transmissions with them that fail as bodies have no room [-]."""
        self.done = set[tuple[int, frozenset[tuple[str, StageSize]]]]()
        """Choices of teeth with sizes that were looked at: wider ones may come twice."""
        self.sized = 0
        """Choices of teeth that were sized before that was known [-]."""
        self.scuffed = frozenset[str]()
        """Bevel pairs whose teeth are chosen anew by what their films ask for."""
        self.heavier = dict[frozenset[StageTeeth], float]()
        """Teeth of stages that are sized together -> by how much they are heavier than the search has it [kg]."""

    def is_enough(self) -> bool:
        """Tell whether so many transmissions are completed that no more are, as one passes or none comes near to it."""
        looked, (enough, most) = self.looked, COMPLETED[self.design.level]
        spared = 1 if most == 1 else 2  # of those that are refused half, as other sizes may be built
        tried = len(looked.whole) + len(looked.refused) // spared + (looked.narrow + looked.crowded) // NARROW
        tried += len(looked.unfit) // UNFIT
        if looked.passing:
            several = TOGETHER // len(self.design.stages) if most > 1 else 1
            return tried >= max(enough, several, self.design.teeth.sized)
        return tried >= (most if looked.hope >= HOPE else most // 2)

    def has_enough_teeth(self) -> bool:
        """Tell whether so many choices of teeth are sized that no more are."""
        sized = self.looked.sized - self.sized
        return sized >= max(FIRST if self.looked.passing else SIZED, self.design.teeth.sized)

    def asks_for_faces(self) -> bool:
        """Tell whether so many gears are unfit, and none passes, that teeth are chosen anew by the faces they ask."""
        looked = self.looked
        if self.areas or looked.passing or looked.hope < LITTLE:
            return False
        return len(looked.unfit) + looked.narrow >= UNFIT

    def begin_anew(self) -> None:
        """Choose teeth with faces as wide as bearings of planets about ask for, by what came nearest to them."""
        looked = self.looked
        for stage in {stage for one in looked.unfit for stage in one.short_of}:
            own = [one for one in looked.unfit if stage in one.short_of]
            nearest = max(own, key=lambda one: one.margins[stage])
            planet = nearest.short_of[stage]
            self.areas[stage] = NEARLY * nearest.asked_face(stage) * planet.pitch_diameter * planet.bodies
        self.queue = [row for row in self.queue if row[2].unfit is not None]
        self._choose_anew()
        self.looked.narrow = 0

    def asks_for_films(self) -> bool:
        """Tell whether a bevel pair came out so much heavier than the search has it that it is weighed with its films.

        What else the search leaves out of bevel pairs weighs less.
        """
        if self.scuffed:
            return False
        stages = {row[0]: heavier for own, heavier in self.heavier.items() for row in own if len(own) == 1}
        self.scuffed = frozenset(
            stage for stage, heavier in stages.items()
            if heavier > FILMS * self.choices[0].gear_mass and rating_of(self.design, stage).kind == "bevel"
        )  # fmt: skip
        return bool(self.scuffed)

    def begin_with_films(self) -> None:
        """Choose teeth anew with what the films of bevel pairs ask for."""
        self.queue = [row for row in self.queue if row[2].gears is not None]
        self.heavier.clear()
        self.looked.off = math.inf
        self._choose_anew()

    def _choose_anew(self) -> None:
        """Choose teeth anew by what is known now; they come after those that are sized."""
        looked, first = self.looked, len(self.choices)
        self.choices += choose_teeth(considering(self.design), self.train, self.areas, self.scuffed)
        self.queue += [
            (choice.gear_mass, place, _Course(place, mass=choice.gear_mass))
            for place, choice in enumerate(self.choices)
            if place >= first
        ]
        heapq.heapify(self.queue)
        self.order = count(len(self.choices) + next(self.order))
        self.waiting.clear()
        self.sized = looked.sized

    def lightest(self) -> _Course | None:
        """Return what weighs least by the estimate; None where nothing is left."""
        while self.waiting:
            course = self.waiting.pop()
            if (gears := next((gears for gears in course.others if gears.passes), None)) is not None:
                self._put(gears.estimate, course._replace(gears=gears))
        return heapq.heappop(self.queue)[2] if self.queue else None

    def _put(self, mass: float, course: _Course) -> None:
        heapq.heappush(self.queue, (mass, next(self.order), course))

    def complete(self, course: _Course, gears: Geared, *, still: bool) -> None:
        """Complete gears, but for those whose planets have no bearing that serves.

        Args:
            course: Where they stand; those of other sizes come after them.
            gears: Those.
            still: Whether open axes stay where they stand first.
        """
        looked = self.looked
        self.waiting.append(course)
        if (known := (course.place, frozenset(gears.sizes.items()))) in self.done:
            return
        self.done.add(known)
        alike = frozenset((part, round(math.log(size.module) / ALIKE)) for part, size in gears.sizes.items())
        if self.crowded[alike] >= CROWDED and not looked.passing:
            looked.crowded += 1
            return
        if faces := looked.asked_faces(gears):
            looked.narrow += 1
            self._widen(gears, faces, course)
            return
        try:
            fitted = Fitted.of(gears, looked.fixed)
        except DesignError as error:
            looked.refused.append(error)
            return
        if fitted.short_of:
            looked.unfit.append(fitted)
            faces = {stage: fitted.asked_face(stage) for stage in fitted.short_of}
            self._widen(gears, faces, course._replace(unfit=fitted))
        else:
            before = len(looked.whole)
            looked.complete(self._narrowed(fitted, course.unfit) if course.unfit else fitted, self.given, still=still)
            lacking = [check for sizing in looked.whole[before:] for check in looked.failing(sizing)]
            self.crowded[alike] += bool(lacking) and all(check.clause == ROOM for check in lacking)

    def _widen(self, gears: Geared, faces: Mapping[str, float], course: _Course) -> None:
        """Put gears into the queue with faces, and where these may not be so wide modules, that bearings may ask for.

        All sets that fall short grow at once; other combinations with a size that is too narrow are passed over.
        """
        self.narrow.setdefault(course.place, set()).update((stage, gears.sizes[stage]) for stage in faces)
        for larger in (False, True):
            if (wider := _wider(gears, faces, larger=larger)) is not None:
                self._put(wider.estimate, _Course(course.place, wider, unfit=course.unfit))

    def _narrowed(self, fitted: Fitted, unfit: Fitted) -> Fitted:
        """Return gears with the narrowest faces at which bearings of their planets serve, by halves from unfit ones."""
        for stage, planet in unfit.short_of.items():
            low = planet.face_width
            high = fitted.found.sizes[stage].face_width
            while high - low > 1.5 * FINEST:
                middle = low + FINEST * math.ceil(0.5 * (high - low) / FINEST - 0.25)
                between = with_face(fitted.found, stage, middle, high - FINEST)
                tried = None if between is None else Fitted.of(between, self.looked.fixed)
                if tried is None:
                    high = middle
                elif tried.short_of:
                    low = tried.found.sizes[stage].face_width
                else:
                    fitted, high = tried, tried.found.sizes[stage].face_width
        return fitted

    def put_back(self, course: _Course, mass: float) -> None:
        """Put a choice of teeth where it is expected by what others came to.

        Args:
            course: That choice.
            mass: What it is expected to weigh by the estimate [kg].
        """
        heapq.heappush(self.queue, (mass, course.place, course._replace(mass=mass)))

    def expected(self, course: _Course) -> float:
        """Return what gears are expected to weigh, by what others with the same teeth of some stages came to [kg].

        Args:
            course: A choice of teeth that is not sized yet.
        """
        choice, looked = self.choices[course.place], self.looked
        off = looked.off if looked.sized >= FIRST and looked.off < math.inf else 1.0
        teeth = stage_teeth(self.train, choice)
        more = sum(heavier for own, heavier in self.heavier.items() if own <= teeth)
        return max(choice.gear_mass * off, choice.gear_mass + more)

    def _learn(self, gears: Geared, choice: Chosen) -> None:
        """Keep by how much stages are heavier than the search has them."""
        owners, teeth = module_owners(self.design), stage_teeth(self.train, choice)
        for stages, mass in gears.ranked.items():
            groups = {owners.get(stage, stage) for stage in stages}
            if groups <= choice.masses.keys():
                own = frozenset(row for row in teeth if row[0] in stages)
                self.heavier[own] = mass - sum(choice.masses[group] for group in groups)

    def size_gears(self, course: _Course) -> None:
        """Size gears with a choice of teeth, unless a stage with the same teeth fell short before.

        Args:
            course: That choice.
        """
        looked, choice = self.looked, self.choices[course.place]
        if (teeth := stage_teeth(self.train, choice)) & self.poor:
            return
        try:
            others = gearings(
                self.design, self.train, choice, given=self.given, known=self.known, areas=self.areas,
                narrow=self.narrow.setdefault(course.place, set()),
            )  # fmt: skip
            gears = next(others)
        except DesignError as error:
            looked.refused.append(error)
            return
        looked.sized += 1
        if gears.passes:
            looked.off = min(looked.off, gears.estimate / max(choice.gear_mass, 1e-9))
            self._learn(gears, choice)
            self._put(gears.estimate, _Course(course.place, gears, others))
        else:
            looked.short.append(gears)
            self.poor |= {own for own in teeth if own[0] in gears.failing}


def _wider(found: Geared, faces: Mapping[str, float], *, larger: bool) -> Geared | None:
    """Return gears with faces that bearings of their planets may ask for; None where they may not be so wide.

    Args:
        found: Gears.
        faces: Set -> face that is asked for [m].
        larger: Whether those sets that may not have it get a larger module; None where all may have it.
    """
    gears: Geared | None = found
    grown = False
    for stage, face in faces.items():
        if gears is None or load_sharing(gears.context.design, stage).by_size:
            return None
        wider = with_face(gears, stage, face)
        if larger and (wider is None or wider.sizes[stage].face_width < face * (1.0 - ROUNDING)):
            wider, grown = with_module(gears, stage, face), True
        gears = wider
    return gears if grown or not larger else None


def considering(design: Design) -> Design:
    """Return a design of which the search tells as many combinations as a preliminary sizing considers.

    Args:
        design: As read.
    """
    sized = max(design.teeth.sized, CONSIDERED)
    return design.model_copy(update={"teeth": design.teeth.model_copy(update={"sized": sized})})


def sized_with(
    design: Design, train: Train, choice: Chosen, *, given: Mapping[str, Given], known: Known | None = None
) -> Sizing:
    """Return the transmission with chosen teeth and numbers of planets.

    Args:
        design: As read.
        train: Its graph.
        choice: Teeth, and numbers of planets that the design leaves open.
        given: Path -> value that the user gives instead of the computed one.
        known: What meshes have given with other teeth of the design, and are to give.
    """
    return completed(Fitted.of(geared(design, train, choice, given=given, known=known)), given)


def completed(fitted: Fitted, given: Mapping[str, Given], *, still: bool = False) -> Sizing:
    """Return the transmission of sized gears: what carries them, and where all stands.

    Args:
        fitted: Gears, and what their planets turn on.
        given: Path -> value that the user gives instead of the computed one.
        still: Whether open axes stay where they stand first, room or not.
    """
    found, gears = fitted.found, fitted.gears
    context, meshes = found.context, found.meshes
    design, train, flows = context.design, context.train, context.flows
    settled = settle(context, gears, still=still)
    arrangement, shafts, carriers = settled.arrangement, settled.shafts, settled.carriers
    checks = [
        *found.checks,
        *(check for shaft in shafts for check in shaft_checks(shaft)),
        *(check for carrier in carriers for check in carrier_checks(carrier)),
        *(check for shaft in settled.built for check in built_checks(shaft, design)),
        *face_load_checks(context, gears, meshes, settled.built_shafts),
        *named_room(design, gears),
        *planet_lives(context, gears, carriers),
        *film_checks(context, gears, carriers),
        *pin_checks(design, {gear.name: gear for gear in gears}, carriers),
        *room_checks(arrangement, settled.rules),
        *coaxial_checks(arrangement, settled.rules.sets, settled.rules.built),
        *hollow_checks(context, gears, arrangement),
        *order_checks(context, arrangement),
        *beside_checks(context, arrangement),
        *keep_out_checks(design, arrangement.bodies),
        *locking_checks(design, train, context.teeth, flows),
        *machine_checks(context),
    ]
    sizing = Sizing(
        design=design,
        train=train,
        teeth=context.teeth,
        flows=flows,
        gears=gears,
        meshes=meshes,
        arrangement=arrangement,
        shafts=shafts,
        carriers=carriers,
        machines=size_machines(context),
        built_shafts=settled.built_shafts,
        bearings=settled.bearings,
        joints=settled.joints,
        given=given,
        search=found.choice.search,
    )
    dipping(sizing, design.losses.dip, "losses.dip")
    refuse_dishes(sizing)
    checks += [*web_checks(sizing), *installation_checks(sizing)]
    refuse(unknown_waivers(checks, design.waivers, left=BEYOND_SIZING))
    return refuse_no_numbers(as_made(replace(sizing, checks=accepted(checks, design.waivers))))
