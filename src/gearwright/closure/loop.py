"""The loop of design closure: initial design, proportioning, and confirmation of dynamic and load factors."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from gearwright.base import GEARBOX, Check, GearwrightError, worst
from gearwright.closure.proportion import Proportioned, proportioned
from gearwright.closure.requirements import HOUR, Round, Step, Wishes, wanted
from gearwright.dynamics.sharing import load_factors
from gearwright.dynamics.vibration import forced_factors
from gearwright.sizing import Sizing
from gearwright.spec import Design, against_fatigue, edited
from gearwright.spec.design import RATINGS, case_named
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# What a closure starts from: the design with a rating that knows fatigue, the life that is asked, nothing chosen.
# ----------------------------------------------------------------------------------------------------------------------


def start_of(design: Design, wishes: Wishes) -> Design:
    """Return the design as a closure begins with it.

    Stages that Lewis and Hertz rate are rated by ISO 6336, as no life can be asked of static strength; the rules that
    only those two read are left out with them.

    Args:
        design: As read.
        wishes: What is asked.

    Raises:
        DesignError: Values that the keys of the design do not allow.
    """
    return against_fatigue(design, _lives(wishes))


def _lives(wishes: Wishes) -> Mapping[str, Value]:
    if wishes.life is None:
        return {}
    hours = wishes.life / HOUR
    return {"service.life_h": hours, "service.bearing_life_h": hours}


# ----------------------------------------------------------------------------------------------------------------------
# Confirm: dynamic factors by a forced response at the speeds of every case, load factors by the stated errors.
# ----------------------------------------------------------------------------------------------------------------------


STEP = 1e-3
"""To which a dynamic factor is written, upwards [-]."""
LARGEST = 5.0
"""That the key takes [-]."""
LARGEST_SHARE = 3.0
"""K_γ that the key takes [-]."""
ABOVE = 1.002
"""Factor on K_γ, as the next size shares its load a little otherwise [-]."""


class Factors(NamedTuple):
    """By how much teeth bear more than their torque says."""

    dynamic: Mapping[str, float]
    """Stage -> K_V [-]."""
    sharing: Mapping[str, float]
    """Stage -> K_γ [-]."""


def shared(sizing: Sizing) -> dict[str, float]:
    """Return stage -> K_γ by the errors of the design, of those that do not state one themselves [-].

    Args:
        sizing: As proportioned.
    """
    return {stage: ABOVE * factor for stage, factor in load_factors(sizing).items()}


def confirmed(sizing: Sizing) -> dict[str, float]:
    """Return stage -> largest dynamic factor of its meshes in all cases that last, by forced response [-].

    A case of which no equilibrium is found has none; its run says why, as a check that is not assessed.

    Args:
        sizing: As proportioned.
    """
    factors: dict[str, float] = {}
    stages = {mesh.name: mesh.stage for mesh in sizing.meshes}
    for case in sizing.flows:
        if case_named(sizing.design, case).static:
            continue
        try:
            forced = forced_factors(sizing, case)
        except GearwrightError:
            continue
        for mesh, factor in forced.items():
            factors[stages[mesh]] = max(factors.get(stages[mesh], 1.0), factor)
    return factors


def beyond_rating(sizing: Sizing) -> dict[str, float]:
    """Return stage -> dynamic factor by forced response, of those whose rating takes less [-].

    Args:
        sizing: As written.
    """
    application = sizing.design.service.application_factor
    used = dict[str, float]()
    for mesh in sizing.meshes:
        used[mesh.stage] = min(used.get(mesh.stage, math.inf), mesh.rating.peaks / application)
    return {stage: factor for stage, factor in confirmed(sizing).items() if factor > used[stage] * (1.0 + STILL)}


def takes_factor(design: Design, stage: str) -> bool:
    """Tell whether the method of a stage takes a dynamic factor.

    Args:
        design: With its rules.
        stage: Pair or set.
    """
    return RATINGS[design.rating(stage)].table == "iso6336" and design.rating(stage) != "iso10300"


def changes_of(design: Design, factors: Factors) -> dict[str, Value]:
    """Return the changes that give confirmed factors to the stages that take them.

    Args:
        design: Where they are written; what it asks for itself holds where it is more, and its own K_γ always.
        factors: As confirmed.
    """
    changes: dict[str, Value] = {}
    for stage, factor in factors.dynamic.items():
        if takes_factor(design, stage):
            own = design.rules(stage).iso6336.least_dynamic_factor
            upwards = min(_upwards(factor), LARGEST)
            if upwards > own:
                changes[f"{design.table(stage)}.gears.iso6336.least_dynamic_factor"] = upwards
    for stage, factor in factors.sharing.items():
        if takes_share(design, stage):
            changes[f"{design.table(stage)}.gears.mesh_load_factor"] = min(_upwards(factor), LARGEST_SHARE)
    return changes


def takes_share(design: Design, stage: str) -> bool:
    """Tell whether a design leaves the load factor of a stage open.

    Args:
        design: With its rules.
        stage: Pair or set.
    """
    rules = design.rules(stage)
    return rules.mesh_load_factor is None and not rules.planet_load_factors


def _upwards(factor: float) -> float:
    return round(-(-factor // STEP) * STEP, 3)


# ----------------------------------------------------------------------------------------------------------------------
# The loop: proportion, confirm, proportion again, until dynamic and load factors stand still.
# ----------------------------------------------------------------------------------------------------------------------


MOST_ROUNDS = 8
"""Rounds after which a loop counts as one that does not converge [-]."""
STILL = 0.005
"""Relative change of a dynamic factor that counts as none [-]."""
CONFIRMS = "peaks"
"""Requirement for which dynamic factors are confirmed."""
SHARES = "sharing"
"""Requirement for which load factors are."""
RATCHET = 4
"""Round from which dynamic factors no longer fall, so that a train that swings between two sizes comes to rest [-]."""


@dataclass(frozen=True)
class Task:
    """A design to close."""

    design: Design
    """As it starts."""
    wishes: Wishes
    chosen: Mapping[str, Value] = field(default_factory=dict)
    """Path -> value that the closure chose against resonance: teeth and modules."""
    factors: Mapping[str, float] = field(default_factory=dict)
    """Stage -> K_V to start with, from peaks of a run [-]."""
    targets: Mapping[str, float] = field(default_factory=dict)
    """Stage -> margin that a flight asks of its strengths [-]."""
    planets: Mapping[str, float] = field(default_factory=dict)
    """Set -> life in the cases that a flight asks of what its planets turn on [h]."""
    start: Sizing | None = None
    """Sizing with the teeth that are chosen, from whose modules the search begins; None: they are free."""

    @property
    def changed(self) -> Design:
        """The design with what the closure chose, its sizes still free."""
        return edited(self.design, self.chosen) if self.chosen else self.design


@dataclass(frozen=True)
class Settled:
    """What the loop ends with."""

    task: Task
    proportioned: Proportioned
    factors: Factors
    """K_V and K_γ of its stages."""
    rounds: tuple[Round, ...]
    converged: Check

    @property
    def sizing(self) -> Sizing:
        """Of the written design."""
        return self.proportioned.sizing


def settled(task: Task) -> Settled:
    """Return a design whose sizes, dynamic and load factors agree, or the last round with a check that fails.

    Args:
        task: With its freedoms.

    Raises:
        DesignError: If the design cannot be sized.
    """
    rounds, before = list[Round](), task.start
    factors = Factors(dict(task.factors), {})
    for number in range(1, MOST_ROUNDS + 1):
        stated = edited(task.design, {**task.chosen, **changes_of(task.design, factors)})
        own = proportioned(stated, task.wishes, before=before, targets=task.targets)
        before = own.sizing
        rounds.append(Round(Step.PROPORTION, before.mass, _margin(own, task), 0.0, _sizes(own)))
        following = _following(task, before, factors, number)
        change = max(_changes(before, factors, following), default=0.0)
        rounds.append(Round(Step.CONFIRM, before.mass, _margin(own, task), change, _factors(following, before)))
        if change <= STILL:
            break
        factors = following
    return Settled(task, own, factors, tuple(rounds), _convergence(change))


def _following(task: Task, sizing: Sizing, held: Factors, number: int) -> Factors:
    """Return the factors of a round; from the fourth on none is less than the one before."""
    left_out, late = task.wishes.left_out, number >= RATCHET
    found = confirmed(sizing) if CONFIRMS not in left_out else {}
    floor = held.dynamic if late else task.factors
    dynamic = {stage: max(value, floor.get(stage, 1.0)) for stage, value in {**task.factors, **found}.items()}
    sharing = shared(sizing) if SHARES not in left_out else {}
    least = held.sharing if late else {}
    return Factors(dynamic, {stage: max(value, least.get(stage, 1.0)) for stage, value in sharing.items()})


def _changes(sizing: Sizing, held: Factors, found: Factors) -> Iterator[float]:
    """Yield by how much every factor differs from the one that the stage was sized with [-]."""
    yield from (_change(sizing, stage, held.dynamic, found.dynamic) for stage in found.dynamic)
    for stage, factor in found.sharing.items():
        if takes_share(sizing.design, stage) or stage in held.sharing:
            sized = max(mesh.load_factor for mesh in sizing.meshes if mesh.stage == stage)
            yield abs(factor / held.sharing.get(stage, sized) - 1.0)


def _change(sizing: Sizing, stage: str, held: Mapping[str, float], found: Mapping[str, float]) -> float:
    """Return by how much a stage's factor differs from the one it was sized with; 0 where its method's own is more."""
    if not takes_factor(sizing.design, stage):
        return 0.0
    application = sizing.design.service.application_factor
    used = min(mesh.rating.peaks / application for mesh in sizing.meshes if mesh.stage == stage)
    before, after = held.get(stage, 1.0), found[stage]
    return 0.0 if max(before, after) <= used * (1.0 - STILL) else abs(after / before - 1.0)


def _margin(own: Proportioned, task: Task) -> float:
    first = worst(wanted(own.sizing.checks, task.wishes.left_out))
    return math.inf if first is None or first.margin is None else first.margin


def _sizes(own: Proportioned) -> str:
    sizes = own.sizes.items()
    return "; ".join(f"{name} m {1e3 * row.module:.4g} b {1e3 * row.face_width:.4g} mm" for name, row in sizes)


def _factors(factors: Factors, sizing: Sizing) -> str:
    """Return the factors of a round: of K_V the one that governs, by the rating or by the forced response."""
    application = sizing.design.service.application_factor
    dynamic = list[str]()
    for stage, factor in factors.dynamic.items():
        rated = max(mesh.rating.peaks / application for mesh in sizing.meshes if mesh.stage == stage)
        by = "by forced response" if factor >= rated else f"by its rating; forced response {factor:.3f}"
        dynamic.append(f"{stage} K_V {max(factor, rated):.3f} {by}")
    return "; ".join([*dynamic, *(f"{stage} K_γ {factor:.3f}" for stage, factor in factors.sharing.items())])


def _convergence(change: float) -> Check:
    """Return the check of the loop itself."""
    clause = f"{MOST_ROUNDS} rounds: K_V and K_γ stand within {STILL:.1%}"
    return Check(GEARBOX, "convergence of the closure", clause, change, STILL, at_most=True, exponent=None)
