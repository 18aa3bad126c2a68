"""A settled design made lighter by single changes of what is free: modules, teeth, shifts, steel, rims and so on."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

from gearwright.closure.closed import Round, Step
from gearwright.closure.loop import Settled
from gearwright.closure.moves.bodies import BODIES, thicknesses
from gearwright.closure.moves.neighbours import (
    DRIVING,
    TEETH_OF_SETS,
    Candidate,
    Change,
    confirmed_anew,
    judged,
    open_modules,
    other_teeth,
    screened,
    standard_modules,
)
from gearwright.closure.proportion import is_tied, searched
from gearwright.identity import Role
from gearwright.ranking import smallest_first
from gearwright.sizing.mass import complete_mass
from gearwright.spec import Design
from gearwright.spec.design import module_owners

MM = 1e-3
MOST_CHANGES = 12
"""Changes that are made one after another [-]."""
CONFIRMED = 4
"""The lightest choices that are confirmed before a design counts as one to which nothing lighter is near [-]."""
TEETH = (-12, -5, -2, -1, 1, 2, 5, 12)
"""By how many teeth the sun or the pinion of a stage is changed [-]."""
MODULES = (-1, 1, 2)
"""By how many steps of ISO 54 the module of a stage is changed [-]."""
FACTORS = (0.9, 0.95, 1.05, 1.1)
"""On modules that are no standard ones, of stages on common axes all together [-]."""
ROUNDING = 1e-6
"""Of what a design lacks [-]."""
LIGHTER = 1e-3
"""Part of the complete mass that a change must save [-]."""
NEARLY = 0.02
"""Part of it by which a change may weigh more as screened: its own dynamic factors may be less than those [-]."""
SHIFTS = (-0.2, -0.1, -0.05, 0.05, 0.1, 0.2)
"""By which the profile shift of a pinion or a sun is changed [-]."""
SUNS = (0, -1, 1, -2, 2, -3, 3)
"""By how many teeth the sun is changed where planets are taken away or put in [-]."""
ANGLES = (-5.0, -2.5, 2.5, 5.0)
"""By which the helix angle is changed [°]."""
WIDEST_ANGLE = 35.0
"""To which it is [°]."""
MOST_PLANETS = 8
"""That are tried [-]."""
GRADES = ("MQ", "ME")
"""Of ISO 6336-5, for which the strengths of the catalogue's steels hold."""


def lightened(state: Settled, say: Callable[[str], None]) -> Settled:
    """Return the lightest design that single changes of what is free lead to, each met as well as before.

    Of all single changes the lightest that meets no less is confirmed and taken, until none saves a thousandth. A
    design that does not meet everything with its own freedoms is left as it is, unless more is free.

    Args:
        state: From the loop.
        say: Called with what is being done.
    """
    best = judged(state)
    if best.short > ROUNDING and not state.task.wishes.free:
        return state
    for number in range(MOST_CHANGES):
        say(f"looking for something lighter, change {number + 1}")
        found = next(_lighter(best), None)
        if found is None:
            break
        change, row = found
        words = "; ".join(f"{path} = {value}" for path, value in change.values.items())
        round_ = Round(Step.LIGHTEN, row.settled.sizing.mass, 1.0 - row.short, 0.0, words)
        rounds = (*best.settled.rounds, round_, *row.settled.rounds)
        best = row._replace(settled=replace(row.settled, rounds=rounds))
    return best.settled


def _lighter(best: Candidate) -> Iterator[tuple[Change, Candidate]]:
    """Yield changes that meet no less and are lighter, confirmed, the lightest as screened first."""
    now = _mass(best.settled)
    rows = ((change, state) for change in _changes(best.settled) for state in screened(best.settled, [change]))
    able = [(mass, change, state) for change, state in rows if (mass := _mass(state)) < (1.0 + NEARLY) * now]
    confirmed = 0
    for _, change, state in smallest_first(able, lambda row: row[0]):
        if confirmed == CONFIRMED:
            return
        if judged(state).short > best.short + ROUNDING:
            continue
        confirmed += 1
        candidate = confirmed_anew(state)
        if candidate.short <= best.short + ROUNDING and _mass(candidate.settled) < (1.0 - LIGHTER) * now:
            yield change, candidate


def _mass(state: Settled) -> float:
    """Return the mass of everything in a gearbox [kg]."""
    return complete_mass(state.sizing).total


def _changes(state: Settled) -> Iterator[Change]:
    """Yield every single change of what is free; teeth that the design leaves open always are."""
    yield from _modules(state)
    for name in dict.fromkeys(("teeth", *state.task.wishes.free)):
        yield from CHANGES[name](state)


def _modules(state: Settled) -> Iterator[Change]:
    """Yield other modules where they are open, wider or narrower faces with them: standard ones, or by factors."""
    design, owners = state.task.design, module_owners(state.task.design)
    open_ = {name: own for name, own in open_modules(state).items() if owners[name] == name}
    tied = {name: own for name, own in open_.items() if is_tied(design, name, owners)}
    for name, own in open_.items():
        for value in _others(state, name, own) if name not in tied else ():
            one = _scaled(state, {name: value})
            yield one
            yield from _as_large(state, name, one, own / value)
    for factor in FACTORS if tied else ():
        yield _scaled(state, {name: factor * own for name, own in tied.items()})


def _as_large(state: Settled, stage: str, change: Change, factor: float) -> Iterator[Change]:
    """Yield another module with other teeth, so that the gears stay about as large, where both are open."""
    gear = next(gear for gear in state.sizing.gears if gear.stage == stage)
    table = f"{state.task.design.table(stage)}."
    steps = {round(factor * gear.teeth) + more - gear.teeth for more in (-1, 0, 1)}
    for other in other_teeth(state, sorted(steps - {0})):
        if f"{other.table}." == table:
            yield other._replace(values={**other.values, **change.values})


def _others(state: Settled, stage: str, own: float) -> Iterator[float]:
    """Yield modules beside the one that is [m]."""
    if not (state.task.wishes.rounded and state.task.design.rules(stage).iso6336.standard_modules):
        yield from (factor * own for factor in FACTORS)
        return
    yield from (value * MM for value in standard_modules(own, MODULES))


def _scaled(state: Settled, modules: Mapping[str, float]) -> Change:
    """Return the change to some modules [m]."""
    return Change("", {f"{state.task.design.table(name)}.module_mm": own / MM for name, own in modules.items()})


def _teeth(state: Settled) -> Iterator[Change]:
    """Yield other teeth of pinions and suns."""
    yield from other_teeth(state, TEETH)


def _shifts(state: Settled) -> Iterator[Change]:
    """Yield other profile shifts of pinions and suns."""
    for name in searched(state.task.design):
        gear = next((gear for gear in state.sizing.gears if gear.stage == name and gear.role in DRIVING), None)
        if gear is not None:
            path = f"{state.task.design.table(name)}.{gear.role}_shift"
            yield from (Change("", {path: round(gear.profile_shift + step, 3)}) for step in SHIFTS)


def _planets(state: Settled) -> Iterator[Change]:
    """Yield sets with a planet more or fewer, with suns near the one that is."""
    for name in searched(state.task.design):
        stage = state.sizing.design.planetaries.get(name)
        if stage is None:
            continue
        table = state.task.design.table(name)
        sun = next(gear.teeth for gear in state.sizing.gears if gear.stage == name and gear.role is Role.SUN)
        frees = tuple(f"{table}.{key}" for key in TEETH_OF_SETS)
        for count in (stage.planets - 1, stage.planets + 1):
            if 2 <= count <= MOST_PLANETS:
                given = _given(state.task.design, name)
                yield from (
                    Change(table, {**given, f"{table}.planets": count, frees[0]: sun + step}, frees) for step in SUNS
                )


def _given(design: Design, name: str) -> Mapping[str, None]:
    """Return the keys of teeth that the design gives, so that they follow anew."""
    stage, table = design.simple_stages[name], design.table(name)
    return {f"{table}.{key}": None for key in TEETH_OF_SETS if getattr(stage, key) is not None}


def _helix(state: Settled) -> Iterator[Change]:
    """Yield other helix angles of the pairs."""
    design = state.task.changed
    if any(pair.kind == "cylindrical" for pair in design.pairs.values()):
        angle = math.degrees(design.gears.helix_angle)
        others = (round(angle + step, 6) for step in ANGLES)
        yield from (Change("", {"gears.helix_angle_deg": other}) for other in others if 0.0 <= other <= WIDEST_ANGLE)


def _steels(state: Settled) -> Iterator[Change]:
    """Yield the other steels of the catalogue, and the grades of the one that is, where no class is stated."""
    design = state.task.changed
    rules = design.gears.iso6336
    yield from (Change("", {"gears.iso6336.grade": grade}) for grade in GRADES if grade != rules.grade)
    if rules.steel is None:
        names = [name for name, one in design.known_materials.items() if one.steel and name != design.gears.material]
        yield from (Change("", {"gears.material": name}) for name in names)


def _bodies(freedom: str) -> Callable[[Settled], Iterator[Change]]:
    """Return what yields thinner and thicker rims or webs."""

    def changes(state: Settled) -> Iterator[Change]:
        for own in thicknesses(state.task.changed, state.sizing, freedom):
            yield from (Change("", own.at(value)) for value in own.others)

    return changes


CHANGES: Mapping[str, Callable[[Settled], Iterator[Change]]] = {
    "teeth": _teeth, "shifts": _shifts, "planets": _planets, "helix": _helix, "material": _steels,
    **{name: _bodies(name) for name in BODIES},
}  # fmt: skip
"""Name of a freedom -> its changes."""
