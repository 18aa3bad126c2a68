"""The load sharing of a sized design: its parallel meshes, what its errors do to them, what helps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.assembly import assemble, contacts_of
from gearwright.dynamics.equations import Redundancy, errors_at, line_forces, redundancy
from gearwright.dynamics.model import Contact, System
from gearwright.dynamics.motion import line_numbers
from gearwright.dynamics.sharing.coefficients import share_coefficients
from gearwright.dynamics.sharing.effects_of_errors import (
    Clocking,
    Distribution,
    Influence,
    clocking_optimum,
    influences,
    monte_carlo,
)
from gearwright.dynamics.sharing.error_sources import ErrorSource, drawn_set, error_sources, with_errors
from gearwright.dynamics.sharing.solutions import LoadSharing, Method, load_sharing
from gearwright.dynamics.sharing.tolerance_allocation import Allocation, allocate
from gearwright.errors import DesignError, Problem, by_name, near
from gearwright.identity import Kind, Row, mesh_part
from gearwright.ranking import largest
from gearwright.showing import Shown
from gearwright.sizing import Sizing, governing_case
from gearwright.spec import Epicyclic, Pair, Planetary
from gearwright.verbs import verb

DETERMINATE = 1e-9
"""Force for each unit of error over the stiffness of a line below which equilibrium alone shares the load [-]."""


@dataclass(frozen=True, eq=False, repr=False)
class SharingProblem(Shown):
    """Parallel meshes of a design with all that decides their sharing."""

    stage: str
    """Pair or planetary set."""
    lines: tuple[str, ...]
    """Names of its parallel meshes."""
    system: System
    """The design in a load case."""
    contacts: tuple[Contact, ...]
    """Its meshes in space."""
    train: Redundancy
    """Its force states."""
    sources: tuple[ErrorSource, ...]
    """Every single error of the design."""
    stated: tuple[float, ...] | None = None
    """Shares that the design states and sizing takes [-]; the elastic ones do not follow them. None: equal shares."""

    @property
    def places(self) -> Ints:
        """Places of the parallel lines in the arrays."""
        return line_numbers(self.system, self.lines)

    @property
    def perfect(self) -> Floats:
        """Sharing coefficients without errors [-], shape (lines,)."""
        return share_coefficients(self.train.perfect[self.places])

    @property
    def shifts(self) -> bool:
        """True if an error can shift load between the lines; False where equilibrium alone shares it."""
        largest = np.max(np.abs(self.train.gain[:, self.places]), initial=0.0)
        return bool(largest > DETERMINATE * np.max(self.system.arrays.stiffness[self.places]))

    @property
    def clockable(self) -> bool:
        """True if gears turned on their shafts shift load: not planets, whose teeth stand where others put them."""
        sides = [side for contact in self.contacts if contact.line in self.lines for side in contact.sides]
        return self.shifts and all(side.place is None for side in sides)


@verb
@one_blas_thread()
def parallel_meshes(sizing: Sizing) -> dict[str, tuple[str, ...]]:
    """Return the stages whose load goes over several meshes, with the names of their lines.

    Args:
        sizing: What was sized.
    """
    lines = {
        name: tuple(str(mesh_part(name, Row.SUN_PLANET, number=k + 1)) for k in range(stage.planets))
        if isinstance(stage, Planetary)
        else _most_loaded_row(sizing, name, stage)
        if isinstance(stage, Epicyclic)
        else tuple(mesh.name for mesh in sizing.train.meshes if mesh.stage == name)
        for name, stage in sizing.design.stages.items()
    }
    return {name: parallel for name, parallel in lines.items() if len(parallel) > 1}


def _most_loaded_row(sizing: Sizing, name: str, stage: Epicyclic) -> tuple[str, ...]:
    """Return the lines of the row of a compound set that carries the largest force, one for each set of planets."""
    row = largest([mesh for mesh in sizing.meshes if mesh.stage == name], lambda mesh: mesh.tangential_force)
    return tuple(str(row.part._replace(number=k + 1)) for k in range(stage.sets))


@verb
@one_blas_thread()
def sharing_problem(sizing: Sizing, stage: str | None = None, *, case: str | None = None) -> SharingProblem:
    """Return the parallel meshes of a stage, ready for every study.

    Args:
        sizing: What was sized; its design's errors count. Teeth that errors pull apart carry nothing.
        stage: Left out: the last stage with parallel meshes, where the paths join.
        case: Load case; left out: the governing one, which has the least margin.

    Raises:
        DesignError: If no mesh is parallel to another.
    """
    groups = parallel_meshes(sizing)
    if not groups:
        raise DesignError([Problem("", "no mesh of this design is parallel to another, so nothing is shared")])
    if stage is not None and stage not in groups:
        raise DesignError([Problem("stage", f"{stage!r} has no parallel meshes; {near(stage, groups)}")])
    name = stage or list(groups)[-1]
    case = case or governing_case(sizing)
    system, contacts = one_sided(assemble(sizing, case)), contacts_of(sizing, sizing.flows[case])
    sources = error_sources(system, contacts, sizing.design.errors)
    rule = sizing.design.stages[name]
    stated = tuple(rule.share) if isinstance(rule, Pair) and rule.share is not None else None
    return SharingProblem(name, groups[name], system, contacts, redundancy(system), sources, stated)


def one_sided(system: System) -> System:
    """Return a system whose teeth can part: meshes without a given backlash have one without end.

    Args:
        system: Whose meshes may carry on both flanks, as a linear model has them.
    """
    mesh = np.array([kind == "mesh" for kind in system.labels.line_kinds])
    backlash = system.arrays.backlash
    free = np.where(mesh & (backlash == 0.0), np.inf, backlash)
    return replace(system, arrays=system.arrays._replace(backlash=free))


@dataclass(frozen=True, eq=False, repr=False)
class SharingStudy(Shown):
    """Answers about the load sharing of one stage."""

    problem: SharingProblem
    """What was studied."""
    sharing: LoadSharing
    """With the errors as the design gives them."""
    influences: tuple[Influence, ...]
    """What every error does alone, the largest first."""
    distribution: Distribution | None
    """All errors with random phases; None without errors."""
    clocking: Clocking | None
    """Angles that take the bias out; None where turning gears on their shafts shifts nothing."""
    allocation: Allocation | None
    """Tolerances for a target, if one was asked for."""


@verb
@one_blas_thread()
def sharing_study(
    problem: SharingProblem,
    *,
    method: Method = "auto",
    target: float | None = None,
    percent: float = 95.0,
    seed: int = 1,
) -> SharingStudy:
    """Return how a design shares its load, which errors matter, what chance does, how to clock, what to tighten.

    Args:
        problem: From `sharing_problem`.
        method: Of the sharing with the errors as given.
        target: Share of the most loaded path that is asked for [-]; left out: no allocation.
        percent: Percentage of gearboxes that must keep the target.
        seed: Of the random numbers.

    Raises:
        DesignError: If a target cannot be reached, or there are no errors to tighten.
    """
    train, sources, places = problem.train, problem.sources, problem.places
    if target is not None and not sources:
        message = "the design gives no error to tighten; add tables such as [errors.output] with eccentricity_um"
        raise DesignError([Problem("errors", message)])
    return SharingStudy(
        problem=problem,
        sharing=load_sharing(problem.system, problem.lines, method=method),
        influences=influences(train, sources, places),
        distribution=monte_carlo(train, sources, places, seed=seed) if sources else None,
        clocking=clocking_optimum(problem.system, problem.contacts, train, places) if problem.clockable else None,
        allocation=allocate(train, sources, places, target=target, percent=percent, seed=seed) if target else None,
    )


@verb
@one_blas_thread()
def sharing(
    sizing: Sizing,
    stage: str | None = None,
    *,
    case: str | None = None,
    method: Method = "auto",
    target: float | None = None,
    percent: float = 95.0,
    seed: int = 1,
) -> SharingStudy:
    """Return how a stage of a sizing shares its load, as `sharing_study` does of its `sharing_problem`.

    Args:
        sizing: What was sized.
        stage: With parallel meshes; left out: the last one.
        case: Load case; left out: the usual one.
        method: Of the sharing with the errors as given.
        target: Share of the most loaded path that is asked for [-]; left out: no allocation.
        percent: Percentage of gearboxes that must keep the target.
        seed: Of the random numbers.

    Raises:
        DesignError: If no stage has parallel meshes, or a target cannot be reached.
    """
    problem = sharing_problem(sizing, stage, case=case)
    return sharing_study(problem, method=method, target=target, percent=percent, seed=seed)


@dataclass(frozen=True, eq=False, repr=False)
class SupportSweep(Shown):
    """Sharing and displacement against the stiffness of one shaft's support."""

    shaft: str
    """Shaft whose support changes."""
    stiffness: Floats
    """[N/m], shape (n,)."""
    perfect: Floats
    """b of the first line without errors [-], shape (n,)."""
    minimum: Floats
    """Smallest b of the first line, quasi-static [-], shape (n,)."""
    maximum: Floats
    """Largest b of the first line, quasi-static [-], shape (n,)."""
    displacement: Floats
    """Largest displacement of the shaft, quasi-static [m], shape (n,)."""


@verb
@one_blas_thread()
def support_sweep(
    sizing: Sizing, shaft: str, stiffness: Sequence[float], *, stage: str | None = None, case: str | None = None
) -> SupportSweep:
    """Return what floating a shaft buys: sharing and displacement against its support's stiffness.

    Args:
        sizing: What was sized, with a support of the shaft and errors.
        shaft: That floats.
        stiffness: Radial stiffnesses to try [N/m].
        stage: Whose sharing; left out: the last stage with parallel meshes.
        case: Load case.

    Raises:
        DesignError: If the design does not support the shaft.
    """
    design = sizing.design
    if shaft not in design.supports:
        message = f"this shaft turns in rigid bearings; add [supports.{shaft}] with radial_n_m"
        raise DesignError([Problem(f"supports.{shaft}", message)])
    rows = []
    for value in stiffness:
        supports = {**design.supports, shaft: design.supports[shaft].model_copy(update={"radial": float(value)})}
        softer = replace(sizing, design=design.model_copy(update={"supports": supports}))
        rows.append(_sweep_row(sharing_problem(softer, stage, case=case), shaft))
    perfect, minimum, maximum, displacement = np.array(rows).T
    return SupportSweep(shaft, np.array(stiffness, dtype=np.float64), perfect, minimum, maximum, displacement)


def _sweep_row(problem: SharingProblem, shaft: str) -> tuple[float, float, float, float]:
    time = _turn(problem.system)
    force = line_forces(problem.train, errors_at(problem.system, time))
    share = share_coefficients(force[:, problem.places])[:, 0]
    moved = np.linalg.norm(shaft_displacement(problem, shaft, force), axis=1)
    return float(problem.perfect[0]), float(np.min(share)), float(np.max(share)), float(np.max(moved))


@verb
@one_blas_thread()
def shaft_displacement(problem: SharingProblem, shaft: str, force: Floats) -> Floats:
    """Return a shaft's displacement across itself from the forces of its bearings [m], shape (instants, 2).

    Args:
        problem: From `sharing_problem`.
        shaft: That moves.
        force: Line forces [N], shape (instants, lines).
    """
    supports, labels = dict[str, list[int]](), problem.system.labels
    for place, (kind, owner) in enumerate(zip(labels.line_kinds, labels.line_owners, strict=True)):
        if kind == "support" and owner.part is not None and owner.part.kind is Kind.SHAFT:
            supports.setdefault(owner.part.name, []).append(place)
    radial = by_name(shaft, supports, "shaft with a support")[:2]
    return np.asarray(force[:, radial] / problem.system.arrays.stiffness[radial])


def _turn(system: System) -> Floats:
    """Return instants over one turn of the slowest error, close enough for the fastest [s]."""
    rates = np.abs(system.arrays.tone_rate[np.unique(system.arrays.error.tone)])
    rates = rates[rates > 0.0]
    if not len(rates):
        return np.zeros(1)
    turn = 2.0 * np.pi / float(np.min(rates))
    return np.linspace(0.0, turn, 64 * int(np.ceil(np.max(rates) / np.min(rates))) + 1)


@verb
@one_blas_thread()
def single_error_sharing(
    problem: SharingProblem,
    source: ErrorSource,
    *,
    method: Method = "sidebands",
    span: tuple[float, float] | None = None,
) -> LoadSharing:
    """Return the sharing with one error alone, as the design gives it.

    Args:
        problem: From `sharing_problem`.
        source: One of its sources.
        method: As `load_sharing` takes it.
        span: (from, to) [s]; left out: one turn of the error.
    """
    (alone,) = with_errors(problem.system, drawn_set([source]))
    return load_sharing(alone, problem.lines, method=method, span=span)
