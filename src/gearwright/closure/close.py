"""Closure of a design, with its mission, at written sizes; requirements that conflict, and designs beside it."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from gearwright.base import (
    CELSIUS,
    GEARBOX,
    RPM,
    Check,
    DesignError,
    GearwrightError,
    Mass,
    Problem,
    Shown,
    Status,
    accepted,
    margin_text,
    refuse,
    verb,
)
from gearwright.catalogue import bearing, bore_around
from gearwright.closure.loop import (
    CONFIRMS,
    MOST_ROUNDS,
    Factors,
    Settled,
    Task,
    beyond_rating,
    changes_of,
    judged,
    settled,
    start_of,
)
from gearwright.closure.moves import (
    BODIES,
    OF_PLANETS,
    TEETH_OF_PAIRS,
    TEETH_OF_SETS,
    Thickness,
    borne,
    lightened,
    mended,
    separated,
    thicknesses,
)
from gearwright.closure.proportion import Proportioned, searched, sized_as, teeth_of, written_out
from gearwright.closure.requirements import (
    FREEDOMS,
    HOUR,
    REQUIREMENTS,
    STRENGTH,
    Closed,
    Course,
    Effort,
    Outcome,
    Round,
    Step,
    Unmet,
    Wishes,
    now,
    requirement_of,
    sized,
    stage_lives,
    under_way,
    wanted,
)
from gearwright.dynamics.sharing import sharing_checks
from gearwright.dynamics.vibration import peak_checks, resonance_checks
from gearwright.mission import Flight, durability, flight_checks, fly
from gearwright.mission.lives import housing_checks, known_sections
from gearwright.sizing import Sizing, size
from gearwright.sizing.bearing_seats import ENDS, planet_bodies
from gearwright.sizing.making import built_checks
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.rating import MESHES
from gearwright.spec import GROUND, Design, Mission, design_text, edited, parse
from gearwright.spec.design import NOTHING_GIVEN, Pair, given_values, module_owners
from gearwright.spec.edit import Value, design_text_like

# ----------------------------------------------------------------------------------------------------------------------
# A design as it was sized: every size written, so that other loads meet the same gearbox.
# ----------------------------------------------------------------------------------------------------------------------


_MM = 1e-3


def as_sized(design: Design) -> Design:
    """Return a design with teeth, modules, widths, shafts and pins written as they are sized.

    Planets on rolling bearings still choose them, and with them their bores, for the loads that they meet.

    Args:
        design: With freedoms, of a level below ``built``.

    Raises:
        DesignError: If it cannot be sized, or has parts that are chosen anew for other loads: built shafts, bevels and
            compound sets whose modules are left open.
    """
    sizing = size(design)
    refuse(list(_open(design, sizing)))
    own = edited(design, dict(teeth_of(design, sizing)))
    whole = edited(own, dict(sized_as(own, sizing)))
    return written_out(Proportioned(whole, size(whole), {})).design


def _open(design: Design, sizing: Sizing) -> Iterator[Problem]:
    """Yield what cannot be written as it is sized."""
    if sizing.level == "built":
        message = "a built gearbox chooses its shafts and bearings for its loads; give a level below it"
        yield Problem("level", message)
    for stage in dict.fromkeys(gear.stage for gear in sizing.gears):
        own = design.simple_stages.get(stage)
        if own is None or (isinstance(own, Pair) and own.kind == "bevel"):
            key = "module" if own is None else "outer_module"
            if f"{stage}.{key}" not in sizing.given:
                message = f"its module follows from the loads; give {key}_mm and face_width_mm to keep its size"
                yield Problem(f"{design.table(stage)}.{key}_mm", message)


# ----------------------------------------------------------------------------------------------------------------------
# A closed design on a mission: what does not live through its flights is proportioned or chosen anew, and its oil.
# ----------------------------------------------------------------------------------------------------------------------


IN_FLIGHT = "life in flight"
"""Requirement for which stages are proportioned anew."""
OF_OIL = ("scuffing", "flank")
"""Requirements that warmer oil moves: scuffing and micropitting."""
ABOVE_FLIGHT = 1.001
"""Factor on the margin that a flight asks for, as the next size is loaded a little otherwise [-]."""

BORE_PER_LOAD = 0.5
"""Power of what a bearing must bear more with which its bore grows [-]: C goes with about the square of the bore."""
TOOTH_SPACE = 2.5
"""Pitch diameter less that of the roots, over the module [-] (ISO 53), without profile shift."""
LONGER = 1.02
"""Factor on the life that a flight asks of a bearing, for the same reason [-]."""


@dataclass(frozen=True)
class OnMission:
    """What is flown."""

    mission: Mission
    folder: Path | None = None
    """Where a propeller map is looked for that is a file."""


class Wanted(NamedTuple):
    """What a flight asks for beside the cases of a design."""

    gears: Mapping[str, float]
    """Stage -> factor by which its gears would have to bear more [-]."""
    planets: Mapping[str, float]
    """Set -> life that what its planets turn on must have in the cases [h]."""
    seats: Mapping[str, float]
    """Bearing of a shaft -> the same [h]."""
    shafts: Mapping[str, float]
    """Shaft of one diameter -> how thick it must be for bearings that live around it [m]."""
    oil: float | None
    """Temperature of the oil to rate with [°C]; None: as it is."""

    @property
    def words(self) -> str:
        """What is asked for; empty where a flight asks for no more than the cases."""
        words = [f"{stage} bears {factor:.3f} times its cases" for stage, factor in self.gears.items()]
        words += [f"planets of {stage} turn {hours:.6g} h in the cases" for stage, hours in self.planets.items()]
        words += [f"bearing {name} {hours:.6g} h in the cases" for name, hours in self.seats.items()]
        words += [f"{name} is {1e3 * bore:g} mm thick for its bearings" for name, bore in self.shafts.items()]
        return "; ".join(words + ([] if self.oil is None else [f"oil of {self.oil:g} °C"]))


def lived(state: Settled, asked: OnMission, tell: Callable[[str], None]) -> tuple[Settled, tuple[Check, ...]]:
    """Return a design whose gears and bearings live through their flights, rated with the oil as warm as it gets.

    At most eight flights; if what the closure may change does not live then, a check of the convergence comes with it,
    which fails.

    Args:
        state: From the loop.
        asked: What is flown.
        tell: Called with what is being done.

    Raises:
        DesignError: If the mission cannot be flown.
    """
    for number in range(1, MOST_ROUNDS + 1):
        tell(f"flying {asked.mission.name}")
        flight = fly(state.sizing, asked.mission, folder=asked.folder)
        checks = wanted(flight_checks(flight, durability(flight)), state.task.wishes.left_out)
        more = _wanted(state, flight, [check for check in checks if check.status is Status.FAILS])
        if not more.words:
            return state, ()
        if number == MOST_ROUNDS:
            break
        state = _again(state, more, tell)
    short = [*more.gears, *more.planets, *more.seats, *more.shafts]
    clause = f"{MOST_ROUNDS} flights: {', '.join(short)} live through them"
    least = min([1.0 / factor for factor in more.gears.values()], default=1.0 / ABOVE_FLIGHT)
    return state, (Check(GEARBOX, "convergence of the closure in flight", clause, least, 1.0, exponent=None),)


def _again(state: Settled, more: Wanted, tell: Callable[[str], None]) -> Settled:
    """Return the design proportioned anew with what a flight asked for; planets may turn on something else."""
    task, design = state.task, state.task.design
    least = min([1.0 / factor for factor in more.gears.values()], default=1.0)
    round_ = Round(Step.FLY, state.sizing.mass, least, 0.0, more.words)
    anew = tuple(f"{design.table(stage)}.planet_bearing." for stage in more.planets)
    chosen = {path: value for path, value in task.chosen.items() if not path.startswith(anew)}
    chosen |= {f"bearings.{name}.life_h": hours for name, hours in more.seats.items()}
    chosen |= {f"layout.{name}.diameter_mm": 1e3 * bore for name, bore in more.shafts.items()}
    chosen |= {} if more.oil is None else {"oil.temperature": more.oil}
    targets = {stage: task.targets.get(stage, 1.0) * ABOVE_FLIGHT * factor for stage, factor in more.gears.items()}
    task = replace(task, chosen=chosen, targets={**task.targets, **targets}, planets={**task.planets, **more.planets})
    again = borne(settled(replace(task, start=None)), tell)
    return replace(again, rounds=(*state.rounds, round_, *again.rounds))


def _wanted(state: Settled, flight: Flight, failing: Sequence[Check]) -> Wanted:
    """Return what fails in a flight and the closure may change."""
    planets, seats = _bearings(state, failing)
    oil = _oil(state, flight, failing)
    asked = (IN_FLIGHT,) if oil is not None else (IN_FLIGHT, *OF_OIL)
    gears = _gears(state, [check for check in failing if requirement_of(check) in asked])
    return Wanted(gears, planets, seats, _shafts(state, failing), oil)


def _gears(state: Settled, failing: Iterable[Check]) -> dict[str, float]:
    """Return stage -> factor by which its gears would have to bear more, where the search may change it [-]."""
    open_, factors = set(searched(state.task.design)), dict[str, float]()
    for check in failing:
        if check.reserve and check.part.name in open_:
            factors[check.part.name] = max(factors.get(check.part.name, 1.0), 1.0 / check.reserve)
    return factors


def _bearings(state: Settled, failing: Iterable[Check]) -> tuple[dict[str, float], dict[str, float]]:
    """Return the lives that open bearings of sets and of shafts must have: as much longer as flights shorten them.

    A set in which none with room lived as long as was asked last is asked for no more.
    """
    task, planets, seats = state.task, dict[str, float](), dict[str, float]()
    asked = task.design.service.bearing_life / HOUR
    bodies = {str(body.part): body.stage for body in planet_bodies(state.sizing.design, state.sizing.gears)}
    worn = {check.part.name for check in state.sizing.checks if check.mode == "life" and check.fails}
    for check in failing:
        hours = (check.value or 0.0) / HOUR
        if check.mode != "bearing life" or not 0.0 < hours < asked:
            continue
        name, longer = check.part.name, LONGER * asked / hours
        stage, seat = task.design.planetaries.get(bodies.get(name, "")), task.design.bearings.get(name)
        if bodies.get(name) in worn:
            continue
        if stage is not None and "planet_bearing" not in stage.model_fields_set:
            planets[bodies[name]] = longer * task.planets.get(bodies[name], asked)
        elif seat is not None and seat.designation is None and seat.life is None:
            now = task.chosen.get(f"bearings.{name}.life_h")
            seats[name] = longer * (float(now) if isinstance(now, float) else asked)
    return planets, seats


def _shafts(state: Settled, failing: Iterable[Check]) -> dict[str, float]:
    """Return how thick open shafts of one diameter must be for bearings that live, below the roots of gears [m]."""
    sizing, layout, thicker = state.sizing, state.task.design.layout, dict[str, float]()
    built = {shaft.name for shaft in sizing.built_shafts}
    usual = {f"{shaft.name}.{end}": shaft.name for shaft in sizing.shafts if shaft.name not in built for end in ENDS}
    for check in failing:
        shaft = usual.get(check.part.name)
        if shaft is None or not check.reserve or layout.get(shaft, NOTHING_GIVEN).diameter is not None:
            continue
        fitted = bearing(check.place)
        try:
            bore = bore_around(fitted.kind, fitted.bore * max(check.reserve**-BORE_PER_LOAD, ABOVE_FLIGHT))
        except DesignError:
            continue  # no bearing is as large
        roots = [gear.pitch_diameter - TOOTH_SPACE * gear.module for gear in sizing.gears if shaft in gear.shafts]
        if bore < min(roots, default=math.inf):
            thicker[shaft] = max(thicker.get(shaft, 0.0), bore)
    return thicker


def _oil(state: Settled, flight: Flight, failing: Iterable[Check]) -> float | None:
    """Return the temperature that teeth and bearings are rated with anew [°C]; None where it does, or is given."""
    warmer = flight.hottest_supply > state.sizing.design.oil.temperature + CELSIUS
    short = any(check.mode == "oil temperature" or requirement_of(check) in OF_OIL for check in failing)
    if not (short and warmer) or "temperature" in state.task.design.oil.model_fields_set:
        return None
    return math.ceil(10.0 * (flight.hottest_supply - CELSIUS)) / 10.0


def named(state: Settled) -> Settled:
    """Return a design in which bearings of shafts that a flight asked for are named, as a review takes them.

    Args:
        state: That lives through its flights.
    """
    seats = [seat for seat in state.sizing.bearings if f"bearings.{seat.name}.life_h" in state.task.chosen]
    if not seats:
        return state
    lives = {f"bearings.{seat.name}.life_h" for seat in seats}
    names = {f"bearings.{seat.name}.designation": seat.bearing.designation for seat in seats}
    chosen = {path: value for path, value in state.task.chosen.items() if path not in lives}
    again = settled(replace(state.task, chosen={**chosen, **names}, start=state.sizing))
    return replace(again, rounds=(*state.rounds, *again.rounds))


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a design becomes a gearbox that meets everything, written out, or says what no freedom meets.
# ----------------------------------------------------------------------------------------------------------------------


MOST_RUNS = 4
"""Simulations after each of which stages whose peaks exceed their rating are proportioned anew [-]."""
ABOVE = 1.01
"""Factor on the dynamic factor that a peak asks for, as the next size shakes a little otherwise [-]."""


class Source(NamedTuple):
    """The file that a design was read from."""

    text: str
    """In TOML; its comments, order and units stay."""
    folder: Path | None = None
    """Where files that it names are looked for."""


class Written(NamedTuple):
    """A design as its text says it."""

    text: str
    design: Design
    sizing: Sizing


@verb
@MESHES.sharing()
def close(
    design: Design,
    *,
    wishes: Wishes | None = None,
    on_mission: OnMission | None = None,
    source: Source | None = None,
    start: Design | None = None,
    course: Course | None = None,
    tell: Callable[[str], None] | None = None,
) -> Closed:
    """Return a design whose free sizes meet every requirement that its checks know, written out for `review`.

    Proportion: the least module and width of every stage under all its strengths, then shafts, pins and plates.
    Confirm: dynamic factors by the forced response at the speeds of every case, and proportion again, at most eight
    rounds. Bear: what planets turn on, where that is open. Separate: other teeth or modules where critical speeds lie
    too near. Mend: the same where anything else is lacking. Lighten: what the wishes leave free. Simulate: the peaks of
    a run. The written text is read, sized and judged anew.

    Args:
        design: As `gearwright.read` gives it; what it gives is kept, and told where it does not do.
        wishes: Life, rounding, what is left out; left out: as the design says.
        on_mission: What its gears live through beside their cases; left out: no flight.
        source: File that the design was read from, as whose text it is written; left out: written anew.
        start: Design of the same stages that was closed before: its teeth and modules are a second start of the search.
        course: Counts what is done, knows what a journal knows, and holds the best design so far.
        tell: Called with what is being done.

    Raises:
        DesignError: If the design cannot be sized, or the start has other stages.
    """
    with under_way(course or Course()) as running:
        return _close(_Request(design, wishes or Wishes(), on_mission, source, tell or _silent), start, running)


class _Request(NamedTuple):
    """What a closure is asked for."""

    design: Design
    wishes: Wishes
    on_mission: OnMission | None
    source: Source | None
    say: Callable[[str], None]


def _close(asked: _Request, start: Design | None, course: Course) -> Closed:
    own, say = start_of(asked.design, asked.wishes), asked.say
    states = [_searched(Task(own, asked.wishes), say)]
    if start is not None:
        say("searching from the design that was closed before")
        states.append(_searched(Task(own, asked.wishes, chosen=_choices_of(start, own)), say))
    state = min(states, key=_order)
    course.best = state
    state, written, checks = _simulated(state, asked)
    if asked.on_mission is not None:
        before = state.proportioned
        state, restless = lived(state, asked.on_mission, say)
        state = named(state)
        if state.proportioned is not before:
            state, written, checks = _simulated(state, asked)
        flight = fly(written.sizing, asked.on_mission.mission, folder=asked.on_mission.folder)
        checks = [*checks, *wanted(flight_checks(flight, durability(flight)), asked.wishes.left_out), *restless]
    return _closed(asked, state, written, checks)


def _order(state: Settled) -> tuple[float, float]:
    return round(judged(state).short, 6), complete_mass(state.sizing).total


def _searched(task: Task, say: Callable[[str], None]) -> Settled:
    """Return the design to which the search leads from one start."""
    now().starts += 1
    for name in searched(task.design):
        module = "module and " if task.design.simple_stages[name].module is None else ""
        now().searched[f"{module}face width of {name}"] = None
    say("proportioning and confirming")
    state = _noted(settled(task))
    state = _noted(borne(state, say))
    if task.wishes.separate and "critical speeds" not in task.wishes.left_out:
        state = _noted(separated(state, say))
    state = _noted(mended(state, say))
    return _noted(lightened(state, say)) if task.wishes.lighten else state


def _noted(state: Settled) -> Settled:
    """Note a design as the best so far."""
    now().best = state
    return state


def _choices_of(start: Design, own: Design) -> dict[str, Value]:
    """Return the teeth, modules and planet bearings of a closed design: path -> value.

    Raises:
        DesignError: If it has other stages.
    """
    if start.simple_stages.keys() != own.simple_stages.keys():
        there, here = (", ".join(one.simple_stages) or "none" for one in (start, own))
        refuse([Problem("start", f"has the stages {there}, the design {here}; give one of the same stages")])
    owners, chosen = module_owners(own), dict[str, Value]()
    for name, stage in start.simple_stages.items():
        mine, table = own.simple_stages[name], own.table(name)
        for key in (*TEETH_OF_SETS, *TEETH_OF_PAIRS):
            if getattr(stage, key, None) is not None and getattr(mine, key, None) is None:
                chosen[f"{table}.{key}"] = getattr(stage, key)
        if stage.module is not None and mine.module is None and owners[name] == name:
            chosen[f"{table}.module_mm"] = stage.module / _MM
    for name, planetary in start.planetaries.items():
        seat = planetary.planet_bearing
        if seat is not None and "planet_bearing" not in own.planetaries[name].model_fields_set:
            chosen[f"planetaries.{name}.planet_bearing.kind"] = seat.kind
            if "side_by_side" in seat.model_fields_set:
                chosen[f"planetaries.{name}.planet_bearing.side_by_side"] = seat.side_by_side
        if f"planetaries.{name}.sun_teeth" in chosen and not own.planetaries[name].planets_given:
            chosen[f"planetaries.{name}.planets"] = planetary.planets
    ratios = {f"{own.table(name)}.ratio": None for name, one in own.simple_stages.items() if one.ratio is not None}
    return {**chosen, **{path: None for path in ratios if any(key.startswith(path[:-5]) for key in chosen)}}


def _silent(_: str) -> None:
    """Say nothing."""


# ----------------------------------------------------------------------------------------------------------------------
# What is written: rounded as a shop does it, read again from its text, and judged as it stands there.
# ----------------------------------------------------------------------------------------------------------------------


SHOP = (1e-3, 2e-4, 2e-6)
"""Steps to which diameters and thicknesses are made larger, the next where one leaves more unmet than none [m]."""
SHORT = 1e-6
"""Of what a design lacks [-]."""
AS_SHORT = 0.05
"""What one that lacks something may lack more by its rounding [-]."""


def written_as(state: Settled, source: Source | None, before: Design) -> Written:
    """Return the text of a settled design, its sizes rounded as a shop makes them, and what is read from it.

    Args:
        state: From the loop.
        source: File as whose text it is written; None: written anew.
        before: Read from that file.
    """
    if not state.task.wishes.rounded:
        return _read_again(state, source, before, 0.0)
    exact = judged(state).short
    for step in SHOP:
        written = _read_again(state, source, before, step)
        lacks = judged(replace(state, proportioned=Proportioned(written.design, written.sizing, {}))).short
        if lacks <= exact + (SHORT if exact <= SHORT else AS_SHORT):
            break
    return written


def _read_again(state: Settled, source: Source | None, before: Design, step: float) -> Written:
    found = written_out(state.proportioned, state.task.wishes.left_out, step=step)
    design = found.design
    if CONFIRMS not in state.task.wishes.left_out and design is not state.proportioned.design:
        design = edited(design, changes_of(design, Factors(beyond_rating(found.sizing), {})))
    text = _text_of(design, source, before)
    again = parse(text, folder=None if source is None else source.folder)
    return Written(text, again, sized(again))


def _text_of(design: Design, source: Source | None, before: Design) -> str:
    return design_text(design) if source is None else design_text_like(design, source.text, before)


def best_so_far(state: Settled, source: Source | None, before: Design) -> Written:
    """Return a design as it stands where a closure is broken off: its sizes as they are, rounded or not.

    Args:
        state: The best so far.
        source: File as whose text it is written; None: written anew.
        before: Read from that file.
    """
    step = SHOP[0] if state.task.wishes.rounded else 0.0
    found = written_out(state.proportioned, state.task.wishes.left_out, step=step)
    return Written(_text_of(found.design, source, before), found.design, found.sizing)


def _simulated(state: Settled, asked: _Request) -> tuple[Settled, Written, list[Check]]:
    """Return a design whose peaks in a run stay within its rating, as it is written, and the checks of them."""
    written = written_as(state, asked.source, asked.design)
    if CONFIRMS in state.task.wishes.left_out:
        return state, written, []
    for _ in range(MOST_RUNS):
        asked.say("simulating every case")
        peaks = list(peak_checks(written.sizing))
        failing = [check for check in peaks if check.status is Status.FAILS]
        if not (factors := _asked_by(state, failing)):
            break
        words = "; ".join(f"{stage} K_V {factor:.3f}" for stage, factor in factors.items())
        lacking = min(check.margin or 0.0 for check in failing)
        round_ = Round(Step.SIMULATE, state.sizing.mass, lacking, 0.0, f"peaks ask for {words}")
        task = replace(state.task, factors={**state.task.factors, **factors})
        again = settled(task)
        state = _noted(replace(again, rounds=(*state.rounds, round_, *again.rounds)))
        written = written_as(state, asked.source, asked.design)
    return state, written, peaks


def _asked_by(state: Settled, failing: Iterable[Check]) -> dict[str, float]:
    """Return stage -> dynamic factor with which its strengths bear the peaks of a run [-]."""
    factors: dict[str, float] = {}
    application = state.sizing.design.service.application_factor
    for check in failing:
        mesh = next((mesh for mesh in state.sizing.meshes if mesh.part == check.part), None)
        if mesh is not None and check.ratio:
            used = mesh.rating.peaks / application
            factors[mesh.stage] = max(factors.get(mesh.stage, 1.0), ABOVE * used / check.ratio)
    return {stage: factor for stage, factor in factors.items() if factor > state.factors.dynamic.get(stage, 1.0)}


def looked_at(sizing: Sizing, peaks: Iterable[Check]) -> list[Check]:
    """Return what a closure looks at of a gearbox in motion and at rest.

    Args:
        sizing: As sized.
        peaks: Of a run of it.
    """
    return [*sizing.checks, *built_checks(sizing), *sharing_checks(sizing), *peaks, *resonance_checks(sizing)]


def _closed(asked: _Request, state: Settled, written: Written, moved: list[Check]) -> Closed:
    wishes, sizing = asked.wishes, written.sizing
    checks = looked_at(sizing, moved)
    sections, why = known_sections(sizing, None, complete_mass(sizing).total)
    checks += housing_checks(sizing, sections, why=why)
    checks = [*wanted(checks, wishes.left_out), state.converged]
    accepted_ = accepted(checks, sizing.design.waivers)
    effort = now().effort(tuple(_not_searched(asked)))
    return Closed(
        design=written.design,
        sizing=sizing,
        checks=accepted_,
        rounds=state.rounds,
        unmet=tuple(_unmet(asked.design, check, effort) for check in accepted_ if check.fails),
        lives=stage_lives(sizing, wishes.left_out),
        kept=tuple(given_values(asked.design).values),
        wishes=wishes,
        effort=effort,
        text=written.text,
        changes_nothing=asked.source is not None and written.text.strip() == asked.source.text.strip(),
    )


def _not_searched(asked: _Request) -> Iterator[str]:
    """Yield the freedoms that the wishes leave closed."""
    yield from (f"{words} (--free {name})" for name, words in FREEDOMS.items() if name not in asked.wishes.free)
    if not asked.wishes.lighten:
        yield "anything lighter than the teeth as sized"
    if not asked.wishes.separate:
        yield "teeth and modules away from critical speeds"


def _unmet(design: Design, check: Check, effort: Effort) -> Unmet:
    """Return what is not met, with what the design keeps the closure from changing."""
    name = requirement_of(check)
    kept = [path for path in given_values(design).values if path.partition(".")[0] == check.part.name]
    searched_ = ", ".join(effort.searched) or "nothing: the design gives all that a closure may change"
    return Unmet(name, check, ", ".join(kept), REQUIREMENTS[name].helps, searched_)


# ----------------------------------------------------------------------------------------------------------------------
# What stands against a requirement that is not met, or against thinner rims and webs where they are free.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDING = 1e-9
"""Of a thickness [-]."""
MOVED = ("flank", "root", "scuffing", "static strength", "teeth", "sharing", "peaks", "critical speeds", "bearings")
"""Requirements that ask for other sizes, so that leaving one out leaves room for others."""


@dataclass(frozen=True, repr=False)
class Contradiction(Shown):
    """Things that are asked of a gearbox and that no freedom of the closure meets together."""

    against: str
    """A requirement, or what the design gives, as it is written there; without it the others are met. Of a closed
    design the next thinner rim or web."""
    unmet: tuple[str, ...]
    """Names of the checks that fail beside it, or the limit that a rim or web would leave."""
    requirements: tuple[str, ...]
    """That they belong to."""
    mass: Mass
    """Of gears, shafts and carriers without the other [kg]."""


@verb
def contradictions(
    design: Design, closed: Closed, *, tell: Callable[[str], None] | None = None
) -> tuple[Contradiction, ...]:
    """Return what stands against the requirements that a closure does not meet.

    Every other requirement is left out once, and every value that the design gives in the stages concerned, one at a
    time; what is then met contradicts what was left out. Of a closed design whose rims or webs were free every one is
    made thinner until something fails, all other sizes as they are.

    Args:
        design: As it was closed.
        closed: What came of it.
        tell: Called with what is being tried.

    Raises:
        DesignError: If the design is none.
    """
    if closed.outcome is Outcome.CLOSED:
        return tuple(_thinner(closed))
    found = list[Contradiction]()
    for name, own, wishes in _relaxed(design, closed):
        if tell is not None:
            tell(f"closing without {name}")
        try:
            again = close(own, wishes=replace(wishes, lighten=False))
        except GearwrightError:
            continue
        still = {row.check.name for row in again.unmet}
        met = [row for row in closed.unmet if row.check.name not in still and row.requirement != name]
        if met:
            names = tuple(dict.fromkeys(row.check.name for row in met))
            found.append(Contradiction(name, names, tuple(dict.fromkeys(row.requirement for row in met)), again.mass))
    return tuple(found)


def _thinner(closed: Closed) -> Iterator[Contradiction]:
    """Yield every rim and web that was free, thinner, with what speaks against it."""
    for freedom in (name for name in closed.wishes.free if name in BODIES):
        yield from (_against(closed, own) for own in thicknesses(closed.design, closed.sizing, freedom))


def _against(closed: Closed, own: Thickness) -> Contradiction:
    """Return the first thinner rim or web that fails a check, else the limit of what is known of it."""
    step = min(abs(step) for step in own.body.steps)
    value = own.now - step
    while value >= own.least - ROUNDING:
        sizing = size(edited(closed.design, own.at(value)))
        if failing := [check for check in wanted(sizing.checks, closed.wishes.left_out) if check.fails]:
            names = tuple(dict.fromkeys(check.name for check in failing))
            kinds = tuple(dict.fromkeys(map(requirement_of, failing)))
            return Contradiction(f"{own.path} = {value:.4g}", names, kinds, sizing.mass)
        value -= step
    return Contradiction(f"{own.path} < {own.least:.4g}", (own.body.limit,), (), closed.mass)


def _relaxed(design: Design, closed: Closed) -> Iterator[tuple[str, Design, Wishes]]:
    """Yield name, design and wishes of every closure with one thing less to meet."""
    asked, unmet = closed.wishes, {row.requirement for row in closed.unmet}
    alone = unmet.pop() if len(unmet) == 1 else ""
    parts = {row.check.part.name for row in closed.unmet}
    for path, given in given_values(design).values.items():
        if path.partition(".")[0] in parts and given.entry not in design.overrides:
            yield f"{given.entry} = {given.amount:g}", edited(design, {given.entry: None}), asked
    for name in MOVED:
        if name != alone and name not in asked.left_out:
            yield name, design, replace(asked, left_out=asked.left_out | {name})


# ----------------------------------------------------------------------------------------------------------------------
# Variants of a design that cannot meet everything: what it gives is changed, the least first, until one closes.
# ----------------------------------------------------------------------------------------------------------------------


SHAKEN = frozenset({"peaks", "critical speeds"})
"""Requirements that a variant need not meet at first, since they take the time."""
_DEGREE_STEPS = (5.0, -5.0)
"""By which helix angles are changed [°]."""
SPEEDS = (1.05, 0.95, 1.1, 0.9)
"""Factors on the speed of a motor against resonance [-]."""
SLOWER = (0.9, 0.75, 0.6)
"""Factors on the speed of a motor beside planets that do not live, whose carrier it may turn with [-]."""
BEST_GRADE = "ME"
"""Of ISO 6336-5."""
_GIVEN_TEETH = ("pinion_teeth", "wheel_teeth", "sun_teeth", "planet_teeth", "ring_teeth")


class Change(NamedTuple):
    """What a variant gives otherwise than its design."""

    what: str
    """In words."""
    values: Mapping[str, Value]
    """Path -> value."""


@dataclass(frozen=True)
class Variant:
    """A design of which something given was changed, closed."""

    what: str
    """What was changed, in words."""
    changes: Mapping[str, Value]
    """Path -> value; None: left out."""
    design: Design
    """With it, before it is closed."""
    closed: Closed


@dataclass(frozen=True)
class Tried:
    """A change that did not lead to a gearbox that meets everything."""

    what: str
    why: str
    """What it does not meet, with its margin, or why it cannot be sized."""


@dataclass(frozen=True, repr=False)
class Variants(Shown):
    """The nearest variant of a design that meets everything, and what was tried before."""

    nearest: Variant | None
    """None where none of them does, or where the design itself does."""
    tried: tuple[Tried, ...]


@verb
def nearest_variant(design: Design, closed: Closed, *, tell: Callable[[str], None] | None = None) -> Variants:
    """Return the first of the changed designs that meets everything, from the smallest change to the largest.

    Given teeth are left to the search, the helix angle, motor speeds and numbers of planets change by a step, the steel
    is of the best grade, and at last a set whose planets do not live becomes a star: its carrier stands still.

    Args:
        design: As it was closed.
        closed: What came of it.
        tell: Called with what is being done.

    Raises:
        DesignError: If the design is none.
    """
    tried = list[Tried]()
    for change in _changes(design, closed) if closed.outcome is Outcome.OPEN else ():
        if tell is not None:
            tell(f"trying {change.what}")
        try:
            own = edited(design, change.values)
            found = _closed_variant(own, closed, change, tell)
        except GearwrightError as error:
            tried.append(Tried(change.what, " ".join(str(error).split())))
            continue
        if found.outcome is Outcome.CLOSED:
            return Variants(Variant(change.what, dict(change.values), own, found), tuple(tried))
        tried.append(
            Tried(
                change.what,
                "; ".join(f"{row.check.name} {margin_text(row.check.margin or 0.0, 4)}" for row in found.unmet),
            )
        )
    return Variants(None, tuple(tried))


def _closed_variant(own: Design, before: Closed, change: Change, tell: Callable[[str], None] | None) -> Closed:
    """Return a variant closed; where strengths and bearings alone are not met already, without what shakes them."""
    asked = before.wishes
    first = close(own, wishes=replace(asked, separate=False, lighten=False, left_out=asked.left_out | SHAKEN))
    if first.unmet:
        return first
    return close(own, wishes=asked, tell=None if tell is None else lambda words: tell(f"{change.what}: {words}"))


def _changes(design: Design, closed: Closed) -> Iterator[Change]:
    """Yield what may help with what is not met, each as small as can be, the smallest first."""
    unmet = {row.requirement for row in closed.unmet}
    stages = sorted({row.check.part.name for row in closed.unmet} & design.simple_stages.keys())
    if "critical speeds" in unmet and not unmet & {*OF_PLANETS, *STRENGTH}:
        yield from _freed(design, _shaken(design, closed))
        yield from _angles(design)
        yield from _speeds(design, SPEEDS)
    if unmet & set(STRENGTH):
        yield from _graded(design)
        yield from _freed(design, stages)
    if unmet & {*OF_PLANETS, *STRENGTH}:
        yield from _counted(design, [stage for stage in stages if stage in design.planetaries])
    if unmet & set(OF_PLANETS):
        sets = _bearing_sets(design, closed)
        yield from _speeds(design, SLOWER, on={design.planetaries[name].carrier for name in sets})
        yield from _stars(design, sets)


def _shaken(design: Design, closed: Closed) -> list[str]:
    """Return the stages whose meshes shake too near an operating speed, then all others."""
    words = " ".join(row.check.mode for row in closed.unmet if row.requirement == "critical speeds")
    return sorted(design.simple_stages, key=lambda name: name not in words)


def _freed(design: Design, stages: Iterable[str]) -> Iterator[Change]:
    """Yield stages whose given teeth are left to the search."""
    for name in stages:
        stage = design.simple_stages[name]
        given = [key for key in _GIVEN_TEETH if getattr(stage, key, None) is not None]
        if given:
            yield Change(f"teeth of {name} free", {f"{design.table(name)}.{key}": None for key in given})


def _angles(design: Design) -> Iterator[Change]:
    """Yield another helix angle, where gears are helical."""
    angle = math.degrees(design.gears.helix_angle)
    for step in _DEGREE_STEPS if angle > 0.0 else ():
        yield Change(f"helix angle {angle + step:g} °", {"gears.helix_angle_deg": round(angle + step, 9)})


def _speeds(design: Design, factors: Iterable[float], *, on: Collection[str] | None = None) -> Iterator[Change]:
    """Yield motors at other speeds, all or those on some shafts."""
    for name, motor in design.motors.items():
        for factor in factors if motor.speed and (on is None or motor.shaft in on) else ():
            rpm = float(f"{factor * motor.speed / RPM:.6g}")
            yield Change(f"{name} at {rpm:g} rpm", {f"motors.{name}.speed_rpm": rpm})


def _graded(design: Design) -> Iterator[Change]:
    """Yield the best grade of the same class of steel."""
    if design.gears.iso6336.grade != BEST_GRADE:
        yield Change(f"steel of grade {BEST_GRADE}", {"gears.iso6336.grade": BEST_GRADE})


def _counted(design: Design, stages: Iterable[str]) -> Iterator[Change]:
    """Yield sets with a planet more or fewer."""
    for name in stages:
        count = design.planetaries[name].planets_given
        for other in (count + 1, count - 1) if count else ():
            yield Change(f"{other} planets in {name}", {f"planetaries.{name}.planets": other})


def _bearing_sets(design: Design, closed: Closed) -> list[str]:
    """Return the sets whose planets have no bearing that lives."""
    lacking = {row.check.part.name for row in closed.unmet if row.requirement in OF_PLANETS}
    return [name for name in design.planetaries if name in lacking]


def _stars(design: Design, stages: list[str]) -> Iterator[Change]:
    """Yield a star in place of the planetary set, one set after another and then all of them."""
    rows = {name: _star(design, name) for name in stages}
    able = {name: row for name, row in rows.items() if row}
    for name, row in able.items():
        yield Change(f"{name} as a star", row)
    if len(able) > 1:
        values = {key: value for row in able.values() for key, value in row.items()}
        yield Change(f"{' and '.join(able)} as stars", values)


def _star(design: Design, name: str) -> dict[str, Value]:
    """Return what makes a set a star: what its carrier turned its ring turns; empty where its ring does not stand."""
    stage = design.planetaries[name]
    if stage.ring != GROUND or stage.carrier == GROUND:
        return {}
    swapped = {"ring": stage.carrier, "carrier": GROUND}
    return {f"planetaries.{name}.{member}": shaft for member, shaft in swapped.items()}
