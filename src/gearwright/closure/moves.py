"""Single changes of a proportioned design: rims and webs, planet bearings, critical speeds and mass.

The loop that settles a change is for `closure/loop.py`, what becomes of one change for `closure/loop.py`.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

from gearwright.base import Check, GearwrightError, Role, Status, smallest_first
from gearwright.closure.loop import (
    MOVED,
    Candidate,
    Confirmed,
    Option,
    Settled,
    StageChange,
    Task,
    changes_of,
    complete_of,
    judged,
    options,
    settled,
)
from gearwright.closure.proportion import Proportioned, is_tied, proportioned, searched, teeth_of
from gearwright.closure.requirements import STRENGTH, Round, Step, Wishes, now, requirement_of, sized, wanted
from gearwright.parts.gears import ISO53_A
from gearwright.sizing import Sizing
from gearwright.sizing.making import built_checks
from gearwright.sizing.mass.bodies import gear_blanks
from gearwright.sizing.rating import BACKUP, LEAST_RING, STANDARD_MODULES
from gearwright.spec import Design, edited
from gearwright.spec.design import RATINGS, Pair, Planetary, module_owners
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# Other teeth and modules of the stages that are searched.
# ----------------------------------------------------------------------------------------------------------------------


MENDED = (*STRENGTH, *MOVED, "bearings", "room of planets", "carriers", "sharing")
"""Those that larger modules and other teeth may meet, too."""
TEETH = (-6, -4, -3, -2, -1, 1, 2, 3, 4, 6)
"""By how many teeth the sun or the pinion of a stage is changed [-]."""
TEETH_OF_SETS = ("sun_teeth", "planet_teeth", "ring_teeth")
"""Keys of the teeth of a planetary set."""
TEETH_OF_PAIRS = ("pinion_teeth", "wheel_teeth")
"""Keys of the teeth of a pair."""
MODULE_ROUNDING = 1e-9
"""Of modules [-]."""
_MM = 1e-3
DRIVING = (Role.SUN, Role.PINION)
"""Gears whose teeth are varied; a pair has none of its own where its pinion is a gear of another stage."""


def other_teeth(state: Settled, steps: Iterable[int] = TEETH) -> Iterator[StageChange]:
    """Yield other numbers of teeth of suns and pinions, stage by stage, where the design leaves them open or free.

    Args:
        state: With the teeth of now.
        steps: By how many teeth [-].
    """
    design, steps = state.task.design, tuple(steps)
    for names in _sharing_gears(design):
        together = _of_teeth(state, names, steps)
        yield from together or (change for name in names for change in _of_teeth(state, (name,), steps))


def _of_teeth(state: Settled, names: tuple[str, ...], steps: Iterable[int]) -> list[StageChange]:
    """Return other teeth of some stages together; none where one of them gives some that are not free."""
    design = state.task.design
    keys = {name: _tooth_keys(design.simple_stages[name]) for name in names}
    driving = {gear.stage: gear for gear in state.sizing.gears if gear.stage in names and gear.role in DRIVING}
    given: dict[str, Value] = {
        f"{design.table(name)}.{key}": None
        for name in names
        for key in keys[name]
        if getattr(design.simple_stages[name], key) is not None
    }
    if not driving or (given and "teeth" not in state.task.wishes.free):
        return []
    now().searched[f"teeth of {' and '.join(names)}"] = None
    frees = tuple(f"{design.table(name)}.{key}" for name in names for key in keys[name])
    first = next(iter(driving.values())).teeth
    return [
        StageChange(
            tuple(map(design.table, names)),
            {
                **given,
                **{
                    f"{design.table(name)}.{keys[name][0]}": gear.teeth + round(step * gear.teeth / first)
                    for name, gear in driving.items()
                },
            },
            frees,
        )
        for step in steps
    ]


def _tooth_keys(stage: Pair | Planetary) -> tuple[str, ...]:
    return TEETH_OF_SETS if isinstance(stage, Planetary) else TEETH_OF_PAIRS


def _sharing_gears(design: Design) -> Iterator[tuple[str, ...]]:
    """Yield the stages whose size is searched, those that share gears together: their ratios change together."""
    names, owners = searched(design), module_owners(design)
    for owner in dict.fromkeys(owners[name] for name in names):
        yield tuple(name for name in names if owners[name] == owner)


def open_modules(state: Settled) -> dict[str, float]:
    """Return stage -> module of those that are searched and give none [m].

    Args:
        state: As settled.
    """
    design = state.task.design
    modules = {gear.stage: gear.module for gear in state.sizing.gears}
    return {name: modules[name] for name in searched(design) if design.simple_stages[name].module is None}


def standard_modules(own: float, steps: Iterable[int]) -> tuple[float, ...]:
    """Return modules of ISO 54 so many steps from the largest that is not above one's own [mm].

    Args:
        own: Module [m].
        steps: Upwards [-].
    """
    place = sum(value * _MM <= own * (1.0 + MODULE_ROUNDING) for value in STANDARD_MODULES) - 1
    return tuple(STANDARD_MODULES[place + step] for step in steps if 0 <= place + step < len(STANDARD_MODULES))


def words_of(chosen: Mapping[str, Value]) -> str:
    """Return what was chosen, for a round.

    Args:
        chosen: Path -> value.
    """
    return "; ".join(
        f"{path} = {value:.12g}" if isinstance(value, float) else f"{path} = {value}" for path, value in chosen.items()
    )


# ----------------------------------------------------------------------------------------------------------------------
# Rims and webs of gears, thinner and thicker: as far as roots bear them and standards know them.
# ----------------------------------------------------------------------------------------------------------------------


THINNEST_WEB = 0.2
"""Web over face width [-]: the least for which ISO 6336-1:2006, clause 9 knows how a blank yields (C_R)."""


class Body(NamedTuple):
    """A thickness under teeth that may be changed."""

    key: str
    """Of `[gears]` of a stage."""
    steps: tuple[float, ...]
    """By which it is changed [-]."""
    most: float
    """Thickest one that is tried: more makes nothing stronger [-]."""
    least: Callable[[Sizing, str], float]
    """Thinnest one of a stage [-]."""
    limit: str
    """What that is."""
    has: Callable[[Design, str], bool]
    """Whether a stage has it."""
    beside: Callable[[Design, str], Mapping[str, Value]] = lambda *_: {}
    """Key -> value of the same table that is stated with it."""


def _cylindrical(design: Design, stage: str) -> bool:
    return stage in design.planetaries or design.pairs[stage].kind == "cylindrical"


def _has_rim(design: Design, stage: str) -> bool:
    pair = design.pairs.get(stage)
    return "rim_ratio" in RATINGS[design.rating(stage)].reads and (pair is None or not pair.internal)


def _has_ring(design: Design, stage: str) -> bool:
    return stage in design.planetaries or design.pairs[stage].internal


def _rim_of_planets(design: Design, stage: str) -> Mapping[str, Value]:
    """Return the rim of planets: not stated, it would follow the ring's where their bearings ask for room."""
    return {"rim_ratio": _now(design, stage, "rim_ratio")} if stage in design.planetaries else {}


def _now(design: Design, stage: str, key: str) -> float:
    """Return a thickness as its rules have it; of rims alone they may say nothing."""
    own: float | None = getattr(design.rules(stage), key)
    return BACKUP if own is None else own


def _has_web(design: Design, stage: str) -> bool:
    return stage in design.pairs and not design.pairs[stage].internal


def _solid_share(design: Design, stage: str) -> Mapping[str, Value]:
    """Return that no share of the solid body is stated beside the web."""
    return {"web_ratio": 1.0} if design.rules(stage).web_ratio < 1.0 else {}


def least_web(sizing: Sizing, stage: str) -> float:
    """Return the thinnest web of a pair over its face width [-]: τ = 2 T/(π d² t) at the hub, or the range of C_R.

    Args:
        sizing: As sized.
        stage: The pair.

    Source: equilibrium of a disc in shear (Tresca), at the largest torque of all cases.
    """
    design, blanks = sizing.design, gear_blanks(sizing)
    strength = design.gear_material(stage).yield_strength or design.shaft_material.yield_strength
    least = THINNEST_WEB
    for gear in (gear for gear in sizing.gears if gear.stage == stage):
        rows = [(mesh.name, mesh.gears.index(gear.name)) for mesh in sizing.train.meshes if gear.name in mesh.gears]
        torque = max(sum(abs(flow.meshes[row].torques[side]) for row, side in rows) for flow in sizing.flows.values())
        shear = (strength or math.inf) / design.shafting.safety / 2.0
        hub = 2.0 * blanks[gear.name].hub_radius
        least = max(least, 2.0 * torque / (math.pi * hub**2 * shear) / gear.face_width)
    return least


BODIES: Mapping[str, tuple[Body, ...]] = MappingProxyType({
    "rims": (
        Body("rim_ratio", (-0.6, -0.2, -0.05, 0.05, 0.2), BACKUP, lambda *_: 0.55,
             "what Y_B rates (ISO 6336-3, clause 9)", _has_rim),
        Body("rim_thickness_ratio", (-0.9, -0.3, -0.1, 0.1, 0.3), 3.5 + ISO53_A.dedendum,
             lambda *_: LEAST_RING + ISO53_A.dedendum + 0.05, "what Y_B rates (ISO 6336-3, clause 9)",
             _has_ring, _rim_of_planets),
    ),
    "webs": (
        Body("web_thickness_ratio", (-0.1, -0.02, 0.02, 0.1), 1.0, least_web,
             "what C_R knows (ISO 6336-1, clause 9), or its shear at the hub", _has_web, _solid_share),
    ),
})  # fmt: skip
"""Name of a freedom -> the thicknesses that it is about."""


class Thickness(NamedTuple):
    """One thickness of one stage, as it is."""

    body: Body
    table: str
    """Of its rules in the design file."""
    now: float
    least: float
    beside: Mapping[str, Value]

    def at(self, value: float) -> dict[str, Value]:
        """Return what makes it thicker or thinner: path -> value.

        Args:
            value: Over tooth height, module or face width [-].
        """
        return {f"{self.table}.{key}": own for key, own in {self.body.key: round(value, 4), **self.beside}.items()}

    @property
    def path(self) -> str:
        """Of it in the design file."""
        return f"{self.table}.{self.body.key}"

    @property
    def others(self) -> list[float]:
        """Those beside it, within its limits [-]."""
        near = (min(max(self.now + step, self.least), self.body.most) for step in self.body.steps)
        return [value for value in dict.fromkeys(near) if abs(value - self.now) > 1e-6]


def thicknesses(design: Design, sizing: Sizing, freedom: str) -> Iterator[Thickness]:
    """Yield the thicknesses of every stage that a freedom is about.

    Args:
        design: With its rules.
        sizing: As sized.
        freedom: Of `BODIES`.
    """
    for body in BODIES[freedom]:
        for stage in design.simple_stages:
            if _cylindrical(design, stage) and body.has(design, stage):
                now, least = _now(design, stage, body.key), body.least(sizing, stage)
                yield Thickness(body, f"{design.table(stage)}.gears", now, least, body.beside(design, stage))


# ----------------------------------------------------------------------------------------------------------------------
# What planets turn on, where a design leaves it open: the lightest kind that lives, wider planets included.
# ----------------------------------------------------------------------------------------------------------------------


OF_PLANETS = ("bearings", "room of planets", "carriers")
"""Requirements that they must meet in their set."""
ROLLING = (("cylindrical", 1), ("cylindrical", 2), ("integral", 1), ("needle", 1), ("ceramic", 1))
"""Kinds and numbers side by side that are tried first."""
FILM = (("plain", 1),)
"""Tried where no rolling bearing does: it asks for pressed oil from the start."""
SMALLER = 3
"""Steps of ISO 54 by which the module is made smaller, the planet with it, and the face wider, where none does [-]."""


class BearingSet(NamedTuple):
    """A set with one kind of bearing."""

    changes: Mapping[str, Value]
    """Path -> value."""
    short: float
    """What its checks lack of their limits [-]."""
    rank: int
    """Rolling ones first [-]."""
    mass: float
    """Of gears, shafts and carriers [kg]."""

    @property
    def order(self) -> tuple[float, int, float]:
        """What meets more comes first, then rolling bearings, then what is lighter."""
        return round(self.short, 6), self.rank, self.mass


def borne(state: Settled, tell: Callable[[str], None]) -> Settled:
    """Return the design with a bearing in the planets of every set that leaves it open, proportioned anew.

    Args:
        state: From the loop.
        tell: Called with what is being done.
    """
    chosen: dict[str, Value] = {}
    for stage in open_sets(state):
        tell(f"choosing what the planets of {stage} turn on")
        now().searched[f"bearings of the planets of {stage}"] = None
        best = min(_tried(state, stage), key=lambda row: row.order, default=None)
        if best is not None:
            chosen |= best.changes
    if not chosen:
        return state
    words = words_of(chosen)
    round_ = Round(Step.BEAR, state.sizing.mass, 1.0, 0.0, words)
    again = settled(replace(state.task, chosen={**state.task.chosen, **chosen}, start=None, factors=state.task.factors))
    return replace(again, rounds=(*state.rounds, round_, *again.rounds))


def open_sets(state: Settled) -> list[str]:
    """Return the planetary sets whose design names no bearing, and for which none is chosen.

    Args:
        state: From the loop.
    """
    design, chosen = state.task.design, state.task.chosen
    open_ = [name for name, stage in design.planetaries.items() if "planet_bearing" not in stage.model_fields_set]
    return [name for name in open_ if f"{design.table(name)}.planet_bearing.kind" not in chosen]


def short_of(sizing: Sizing, stage: str, left_out: frozenset[str]) -> float:
    """Return what planets, pins and bearings of a set lack of their limits [-].

    Args:
        sizing: As sized.
        stage: The set.
        left_out: Requirements that do not count.
    """
    counted = wanted(sizing.checks, left_out)
    return sum(1.0 - (check.margin or 0.0) for check in counted if _lacks(check, stage))


def _lacks(check: Check, stage: str) -> bool:
    return check.part.name == stage and check.status is Status.FAILS and requirement_of(check) in OF_PLANETS


def _tried(state: Settled, stage: str) -> Iterator[BearingSet]:
    """Yield every kind at the size as it is, and on smaller modules with wider faces until one kind serves."""
    for module, own in _sizes(state, stage):
        rows = [*_kinds(own, stage, module, state.task)]
        yield from rows
        if any(row.short <= 0.0 for row in rows):
            return


def _sizes(state: Settled, stage: str) -> Iterator[tuple[float | None, Proportioned]]:
    """Yield the set as it is and with smaller modules [mm]."""
    yield None, state.proportioned
    design, sizing, task = state.task.design, state.sizing, state.task
    if stage not in state.proportioned.sizes or design.planetaries[stage].module is not None:
        return
    module = state.proportioned.sizes[stage].module
    smaller = [value for value in STANDARD_MODULES if value * _MM < module * (1.0 - 1e-9)]
    for value in reversed(smaller[-SMALLER:]):
        change = {**dict(teeth_of(task.changed, sizing)), f"planetaries.{stage}.module_mm": value}
        stated = edited(edited(task.changed, change), changes_of(design, state.factors))
        own = proportioned(stated, task.wishes, before=sizing, targets=task.targets)
        if own.sizes[stage].margin < 1.0:
            return
        yield value, own


def _kinds(own: Proportioned, stage: str, module: float | None, task: Task) -> Iterator[BearingSet]:
    """Yield a set on every kind of bearing."""
    path = f"planetaries.{stage}"
    for rank, (kind, count) in enumerate(ROLLING + FILM):
        changes: dict[str, Value] = {f"{path}.planet_bearing.kind": kind}
        if count > 1:
            changes[f"{path}.planet_bearing.side_by_side"] = count
        if stage in task.planets and kind != "plain":
            changes[f"{path}.planet_bearing.life_h"] = task.planets[stage]
        try:
            sizing = sized(edited(own.design, changes))
        except GearwrightError:
            continue
        if module is not None:
            changes[f"{path}.module_mm"] = module
        yield BearingSet(changes, short_of(sizing, stage, task.wishes.left_out), int(rank >= len(ROLLING)), sizing.mass)


# ----------------------------------------------------------------------------------------------------------------------
# Critical speeds kept away from operating ones: other teeth or another module of one stage, the lightest that does.
# ----------------------------------------------------------------------------------------------------------------------


SWEEPS = 5
"""Changes that are made one after another [-]."""
MOST_TURNED = 12
"""Choices of a sweep whose axes are turned to make room, the most promising first [-]."""
CONFIRMED_OF_SWEEP = 3
"""The most promising choices of a sweep that are confirmed [-]."""
STEPS = (-14, -12, -10, -8, *TEETH, 8, 10, 12, 14)
"""By how many teeth the sun or the pinion of a stage is changed: far enough to step over its main resonance [-]."""
MODULES_UPWARDS = (1, 2)
"""By how many steps of ISO 54 the module alone is changed, upwards: smaller ones do not bear the load [-]."""
BESIDE = (-1, 0, 1)
"""By how many steps of ISO 54 it is changed together with the teeth [-]."""
LARGER = (1.05, 1.1, 1.15)
"""Factors on the modules of stages on common axes, which have no standard ones [-]."""
NEARNESS_ROUNDING = 1e-6
"""Of what a design lacks [-]."""


def separated(state: Settled, tell: Callable[[str], None]) -> Settled:
    """Return the lightest design among other teeth and modules whose critical speeds are clear, or the nearest to it.

    Each sweep changes one stage, by its teeth, its module or both, and proportions and confirms every choice anew. What
    was met before, such as lives of planet bearings, is met afterwards. Where changes of given teeth, which are free,
    lead nowhere, it is tried once more without them: what they save is for what makes a design lighter to find.

    Args:
        state: That the loop ended with.
        tell: Called with what is being done.
    """
    lacks = _other_lacks(judged(state))
    best, wishes = _moved(state, lacks, tell), state.task.wishes
    if _clear(best, lacks) or "teeth" not in wishes.free:
        return best.settled
    fewer = replace(wishes, free=tuple(name for name in wishes.free if name != "teeth"))
    other = _moved(_wishing(state, fewer), lacks, tell)
    return _wishing(min(best, other, key=lambda row: row.rank).settled, wishes)


def mended(state: Settled, tell: Callable[[str], None]) -> Settled:
    """Return a design that meets what it lacks, by other teeth and modules, or the nearest to it; else as it is.

    What the least module and width of every stage leave unmet, such as room for bearings in planets, larger ones meet.

    Args:
        state: From the loop.
        tell: Called with what is being done.
    """
    checks = wanted([*state.sizing.checks, *built_checks(state.sizing)], state.task.wishes.left_out)
    lacking = {requirement_of(check) for check in checks if check.fails}
    if not lacking & set(MENDED):
        return state
    return _moved(state, 0.0, tell, words="looking for what meets more").settled


def _wishing(state: Settled, wishes: Wishes) -> Settled:
    return replace(state, task=replace(state.task, wishes=wishes))


def _moved(
    state: Settled, lacks: float, tell: Callable[[str], None], words: str = "separating critical speeds"
) -> Candidate:
    """Return what up to five changes lead to, each the best of its sweep."""
    best = judged(state)
    for sweep in range(SWEEPS):
        if _clear(best, lacks):
            break
        tell(f"{words}, sweep {sweep + 1}")
        found = min(_settled_of(best.settled, lacks), key=lambda row: row.rank, default=None)
        if found is None or found.rank >= best.rank:
            break
        best = _taken(best, found, Step.SEPARATE, words_of(found.settled.task.chosen))
    return best


def _taken(best: Candidate, found: Confirmed, step: Step, words: str) -> Candidate:
    """Return a change that is made, with the rounds to it."""
    now().taken += 1
    round_ = Round(step, found.settled.sizing.mass, 1.0 - found.short, 0.0, words)
    rounds = (*best.settled.rounds, round_, *found.settled.rounds)
    candidate = Candidate(replace(found.settled, rounds=rounds), found.short, found.near)
    now().best = candidate.settled
    return candidate


def _other_lacks(candidate: Candidate) -> float:
    """Return what checks other than critical speeds and room lack [-]."""
    return candidate.short - candidate.near


def _clear(found: Candidate | Confirmed, lacks: float) -> bool:
    """Tell whether no critical speed is near, and nothing else lacks more than it may [-]."""
    return found.near <= 0.0 and found.short <= lacks + NEARNESS_ROUNDING


def _settled_of(state: Settled, lacks: float) -> Iterator[Confirmed]:
    """Yield the most promising changes, confirmed, until one is clear and lacks no more than it may [-]."""
    for near in _most_promising(options(state, (*_changes_away(state), *_together(state), *_beyond(state)))):
        found = near.confirmed()
        if found.can_be_sized:
            yield found
            if _clear(found, lacks):
                return


def _most_promising(rows: Iterable[Option]) -> list[Option]:
    """Return the options that lack least: who lacks more as it stands is not shaken, as that only adds to it."""
    best, turned = list[Option](), 0
    for row in sorted(rows, key=lambda row: (round(row.stands, 6), row.mass)):
        if len(best) == CONFIRMED_OF_SWEEP and (round(row.stands, 6), row.mass) > best[-1].rank:
            break
        turned += not row.has_room
        if turned > MOST_TURNED and not row.has_room:
            continue
        best = sorted([*best, row], key=lambda one: one.rank)[:CONFIRMED_OF_SWEEP]
    return [row for row in best if row.short < math.inf]


def _changes_away(state: Settled) -> Iterator[StageChange]:
    """Yield other numbers of teeth, other modules, and both at once, stage by stage, where they are open."""
    design, owners = state.task.design, module_owners(state.task.design)
    alone = (entry for entry in open_modules(state).items() if not is_tied(design, entry[0], owners))
    open_ = {design.table(name): own for name, own in alone}
    for change in other_teeth(state, STEPS):
        yield change
        for table in change.tables if len(change.tables) == 1 else ():
            values = standard_modules(open_[table], BESIDE) if table in open_ else ()
            yield from (_with_module(change, table, value) for value in values)
    for table, own in open_.items():
        if f"{table}.module_mm" not in state.task.chosen:
            yield from (
                _with_module(StageChange((), {}), table, value) for value in standard_modules(own, MODULES_UPWARDS)
            )


def _with_module(change: StageChange, table: str, value: float) -> StageChange:
    return change._replace(values={**change.values, f"{table}.module_mm": value})


def _together(state: Settled) -> Iterator[StageChange]:
    """Yield larger modules of the stages on common axes, all by one factor, where the design leaves them open."""
    design, owners = state.task.design, module_owners(state.task.design)
    tied = [name for name in searched(design) if is_tied(design, name, owners)]
    modules = {gear.stage: gear.module for gear in state.sizing.gears}
    if tied and all(design.simple_stages[name].module is None for name in tied):
        own = {name: modules[name] for name in tied if owners[name] == name}
        for factor in LARGER:
            yield StageChange((), {f"{design.table(name)}.module_mm": factor * own[name] / _MM for name in own})


# ----------------------------------------------------------------------------------------------------------------------
# Modules that the sizing chooses and the proportioning does not: of compound sets, bevel pairs and face gears.
# ----------------------------------------------------------------------------------------------------------------------


BEYOND = (-3, -2, *range(1, 13), -1)
"""By how many steps of ISO 54 such a module is changed [-]."""


def modules_beyond(design: Design, sizing: Sizing) -> Iterator[tuple[str, str, float]]:
    """Yield path, name and module [m] of what has one of its own that is open and no stage that is searched.

    The gear groups of a compound set have modules in a fixed ratio, so that the one of its first gear speaks for all.

    Args:
        design: With its stages.
        sizing: As sized.
    """
    modules = {gear.name: gear.module for gear in sizing.gears}
    for name, compound in design.epicyclics.items():
        if all(gear.module is None for gear in compound.toothed.values()):
            first = next(iter(compound.toothed))
            kind = next(kind for kind in ("suns", "rings", "planets") if first in getattr(compound, kind))
            yield f"{design.table(name)}.{kind}.{first}.module_mm", name, modules[f"{name}.{first}"]
    for name, pair in design.pairs.items():
        own = next((gear.module for gear in sizing.gears if gear.stage == name), None)
        if pair.kind == "bevel" and pair.outer_module is None and own is not None:
            yield f"{design.table(name)}.outer_module_mm", name, own
        elif pair.kind == "face" and pair.module is None and own is not None:
            yield f"{design.table(name)}.module_mm", name, own


def _beyond(state: Settled, steps: Iterable[int] = BEYOND) -> Iterator[StageChange]:
    """Yield other modules of compound sets, bevel pairs and face gears: standard ones, or by factors."""
    steps = tuple(steps)
    for path, name, own in modules_beyond(state.task.design, state.sizing):
        now().searched[f"module of {name}"] = None
        if state.task.wishes.rounded and state.task.design.rules(name).iso6336.standard_modules:
            values = [value for value in standard_modules(own, steps) if abs(value * _MM / own - 1.0) > MODULE_ROUNDING]
        else:
            values = [factor * own / _MM for factor in (*FACTORS, *LARGER)]
        yield from (StageChange((), {path: value}) for value in values)


# ----------------------------------------------------------------------------------------------------------------------
# A settled design made lighter by single changes of what is free: modules, teeth, shifts, steel, rims and so on.
# ----------------------------------------------------------------------------------------------------------------------


MOST_CHANGES = 12
"""Changes that are made one after another [-]."""
CONFIRMED = 4
"""The lightest choices that are confirmed before a design counts as one to which nothing lighter is near [-]."""
LIGHTER_TEETH = (-12, -5, -2, -1, 1, 2, 5, 12)
"""By how many teeth the sun or the pinion of a stage is changed [-]."""
LIGHTER_MODULES = (-1, 1, 2)
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
        best = _taken(best, found, Step.LIGHTEN, words_of(found.option.change.values))
    return best.settled


def _lighter(best: Candidate) -> Iterator[Confirmed]:
    """Yield changes that meet no less and are lighter, confirmed, the lightest as screened first."""
    now_ = complete_of(best.settled)
    rows = options(best.settled, _changes_of_freedoms(best.settled))
    able = [row for row in rows if row.complete < (1.0 + NEARLY) * now_]
    confirmed = 0
    for row in smallest_first(able, lambda row: row.complete):
        if confirmed == CONFIRMED:
            return
        most = best.short + ROUNDING
        if row.stands > most or row.short > most:
            continue
        confirmed += 1
        found = row.confirmed()
        if found.can_be_sized and found.short <= most and found.complete < (1.0 - LIGHTER) * now_:
            yield found


def _changes_of_freedoms(state: Settled) -> Iterator[StageChange]:
    """Yield every single change of what is free; teeth that the design leaves open always are."""
    yield from _modules(state)
    yield from _beyond(state, LIGHTER_MODULES)
    for name in dict.fromkeys(("teeth", *state.task.wishes.free)):
        yield from CHANGES[name](state)


def _modules(state: Settled) -> Iterator[StageChange]:
    """Yield other modules where they are open, wider or narrower faces with them: standard ones, or by factors."""
    design, owners = state.task.design, module_owners(state.task.design)
    open_ = {name: own for name, own in open_modules(state).items() if owners[name] == name}
    tied = {name: own for name, own in open_.items() if is_tied(design, name, owners)}
    for name, own in open_.items():
        for value in _other_modules(state, name, own) if name not in tied else ():
            one = _scaled(state, {name: value})
            yield one
            yield from _as_large(state, name, one, own / value)
    for factor in FACTORS if tied else ():
        yield _scaled(state, {name: factor * own for name, own in tied.items()})


def _as_large(state: Settled, stage: str, change: StageChange, factor: float) -> Iterator[StageChange]:
    """Yield another module with other teeth, so that the gears stay about as large, where both are open."""
    gear = next(gear for gear in state.sizing.gears if gear.stage == stage)
    table = state.task.design.table(stage)
    steps = {round(factor * gear.teeth) + more - gear.teeth for more in (-1, 0, 1)}
    for other in other_teeth(state, sorted(steps - {0})):
        if other.tables == (table,):
            yield other._replace(values={**other.values, **change.values})


def _other_modules(state: Settled, stage: str, own: float) -> Iterator[float]:
    """Yield modules beside the one that is [m]."""
    if not (state.task.wishes.rounded and state.task.design.rules(stage).iso6336.standard_modules):
        yield from (factor * own for factor in FACTORS)
        return
    yield from (value * _MM for value in standard_modules(own, LIGHTER_MODULES))


def _scaled(state: Settled, modules: Mapping[str, float]) -> StageChange:
    """Return the change to some modules [m]."""
    return StageChange((), {f"{state.task.design.table(name)}.module_mm": own / _MM for name, own in modules.items()})


def _teeth(state: Settled) -> Iterator[StageChange]:
    """Yield other teeth of pinions and suns."""
    yield from other_teeth(state, LIGHTER_TEETH)


def _shifts(state: Settled) -> Iterator[StageChange]:
    """Yield other profile shifts of pinions and suns."""
    for name in searched(state.task.design):
        gear = next((gear for gear in state.sizing.gears if gear.stage == name and gear.role in DRIVING), None)
        if gear is not None:
            path = f"{state.task.design.table(name)}.{gear.role}_shift"
            yield from (StageChange((), {path: round(gear.profile_shift + step, 3)}) for step in SHIFTS)


def _planets(state: Settled) -> Iterator[StageChange]:
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
                    StageChange((table,), {**given, f"{table}.planets": count, frees[0]: sun + step}, frees)
                    for step in SUNS
                )


def _given(design: Design, name: str) -> Mapping[str, None]:
    """Return the keys of teeth that the design gives, so that they follow anew."""
    stage, table = design.simple_stages[name], design.table(name)
    return {f"{table}.{key}": None for key in TEETH_OF_SETS if getattr(stage, key) is not None}


def _helix(state: Settled) -> Iterator[StageChange]:
    """Yield other helix angles of the pairs."""
    design = state.task.changed
    if any(pair.kind == "cylindrical" for pair in design.pairs.values()):
        angle = math.degrees(design.gears.helix_angle)
        others = (round(angle + step, 6) for step in ANGLES)
        yield from (
            StageChange((), {"gears.helix_angle_deg": other}) for other in others if 0.0 <= other <= WIDEST_ANGLE
        )


def _steels(state: Settled) -> Iterator[StageChange]:
    """Yield the other steels of the catalogue, and the grades of the one that is, where no class is stated."""
    design = state.task.changed
    rules = design.gears.iso6336
    yield from (StageChange((), {"gears.iso6336.grade": grade}) for grade in GRADES if grade != rules.grade)
    if rules.steel is None:
        names = [name for name, one in design.known_materials.items() if one.steel and name != design.gears.material]
        yield from (StageChange((), {"gears.material": name}) for name in names)


def _bodies(freedom: str) -> Callable[[Settled], Iterator[StageChange]]:
    """Return what yields thinner and thicker rims or webs."""

    def changes(state: Settled) -> Iterator[StageChange]:
        for own in thicknesses(state.task.changed, state.sizing, freedom):
            yield from (StageChange((), own.at(value)) for value in own.others)

    return changes


CHANGES: Mapping[str, Callable[[Settled], Iterator[StageChange]]] = {
    "teeth": _teeth, "shifts": _shifts, "planets": _planets, "helix": _helix, "material": _steels,
    **{name: _bodies(name) for name in BODIES},
}  # fmt: skip
"""Name of a freedom -> its changes."""
