"""Load sharing of a sized design, elastic and with manufacturing errors, and its check against K_γ."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from gearwright.base import (
    GEARBOX,
    Bools,
    Check,
    DesignError,
    Floats,
    GearwrightError,
    Ints,
    Kind,
    Origin,
    PartId,
    Problem,
    Quantity,
    Role,
    Row,
    Shown,
    by_name,
    gear_part,
    largest,
    mesh_part,
    near,
    not_assessed,
    one_blas_thread,
    smallest,
    verb,
)
from gearwright.dynamics.assembly import assemble, contacts_of, gear_pairs
from gearwright.dynamics.equations import Redundancy, errors_at, line_forces, redundancy, statics
from gearwright.dynamics.model import Contact, Member, Model, PlanetarySet, PlanetError, System, add_planetary
from gearwright.dynamics.motion import line_numbers
from gearwright.dynamics.sharing.solutions import (
    Allocation,
    Clocking,
    Distribution,
    ErrorSource,
    Influence,
    LoadSharing,
    Method,
    allocate,
    clocking_optimum,
    drawn_set,
    error_sources,
    influences,
    load_sharing,
    monte_carlo,
    share_coefficients,
    with_errors,
)
from gearwright.parts.planetary import even_positions, pin_error_share
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import Sizing, governing_case, planet_positions
from gearwright.spec import Epicyclic, Pair, Planetary, case_named

# ----------------------------------------------------------------------------------------------------------------------
# The load sharing of a sized design: its parallel meshes, what its errors do to them, what helps.
# ----------------------------------------------------------------------------------------------------------------------


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


INSTANTS = 4000
"""Of a turn that is drawn."""
SPREAD = tuple(float(factor) for factor in np.geomspace(1e-2, 1e2, 41))
"""Stiffnesses of a support that are shown, over the design's [-]."""
SHAFTS = 4
"""On supports, whose paths are shown."""


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
    force = line_forces(problem.train, errors_at(problem.system, _turn(problem.system)))
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


def slow_displacement(problem: SharingProblem, shaft: str, time: Floats) -> Floats:
    """Return a shaft's quasi-static displacement across itself under its errors [m], shape (instants, 2).

    Args:
        problem: From `sharing_problem`.
        shaft: That moves.
        time: [s], shape (instants,).
    """
    return shaft_displacement(problem, shaft, line_forces(problem.train, errors_at(problem.system, time)))


@dataclass(frozen=True, eq=False, repr=False)
class Floating(Shown):
    """What the supports of a design's shafts buy."""

    stiffness: float
    """Of the softest support [N/m]."""
    sweep: SupportSweep
    """Of the shaft on it."""
    paths: Mapping[str, Floats]
    """Shaft -> its displacement across itself over a turn [m], shape (instants, 2)."""


def floating(sizing: Sizing) -> Floating | None:
    """Return what the supports of shafts buy; None without supports or without errors.

    Args:
        sizing: What was sized.
    """
    supports = sizing.design.supports
    if not supports or not sizing.design.errors:
        return None
    shaft = smallest(supports, lambda name: supports[name].radial)
    stiffness, problem = supports[shaft].radial, sharing_problem(sizing)
    time = one_turn([problem])
    return Floating(
        stiffness,
        support_sweep(sizing, shaft, [stiffness * factor for factor in SPREAD]),
        {name: slow_displacement(problem, name, time) for name in list(supports)[:SHAFTS]},
    )


def one_turn(problems: Iterable[SharingProblem]) -> Floats:
    """Return instants over one turn of the slowest part that turns [s].

    Args:
        problems: Whose errors turn.
    """
    rates = [abs(source.rate) for problem in problems for source in problem.sources if source.rate]
    return np.linspace(0.0, 2.0 * np.pi / min(rates), INSTANTS) if rates else np.zeros(1)


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


# ----------------------------------------------------------------------------------------------------------------------
# How parallel meshes share their load when the gearbox is elastic and without errors.
# ----------------------------------------------------------------------------------------------------------------------


IDLE = 1e-9
"""Share of the load below which a path idles and is not listed [-]."""


@dataclass(frozen=True)
class PathShare:
    """One of several meshes side by side."""

    mesh: str
    case: str
    train: Annotated[float, Quantity("percent"), Origin("equal, or as the design states", "design")]
    """Share of the load in the train's statics [-]."""
    elastic: Annotated[float, Quantity("percent"), Origin("Σ d f = Q at mean stiffness", "System statics")]
    """Share of the load in the elastic gearbox [-]."""
    ratio: Annotated[float, Quantity("ratio"), Origin("elastic / train", "definition")]
    """Elastic over train share [-]."""


@verb
@one_blas_thread()
def elastic_shares(sizing: Sizing, case: str | None = None) -> dict[str, dict[str, float]]:
    """Return the share of each parallel mesh of every pair that meshes with several, from the System's statics [-].

    The train shares equally, or as the design states; the elastic answer differs where the paths differ.

    Args:
        sizing: What was sized.
        case: Load case; left out: the governing one, which has the least margin.

    Returns:
        Pair -> mesh -> share; the shares of a pair add up to 1.
    """
    case = case or governing_case(sizing)
    system = assemble(sizing, case, stiffness="constant")
    force = dict(zip(system.labels.lines, statics(system).force, strict=True))
    shares = {}
    for stage in sizing.design.pairs:
        rows = _rows(sizing, stage)
        total = sum(force[row] for row in rows)
        if len(rows) > 1 and total:
            shares[stage] = {row: float(force[row] / total) for row in rows}
    return shares


def path_shares(sizing: Sizing) -> tuple[PathShare, ...]:
    """Return the shares of all parallel meshes in the governing case; none where no pair has several meshes.

    Args:
        sizing: What was sized.
    """
    if all(len(_rows(sizing, stage)) < 2 for stage in sizing.design.pairs):
        return ()
    case = governing_case(sizing)
    meshes, paths = sizing.flows[case].meshes, []
    for stage, shares in elastic_shares(sizing, case).items():
        total = sum(meshes[mesh].multiplier for mesh in _rows(sizing, stage))
        for mesh, elastic in shares.items():
            train = meshes[mesh].multiplier / total
            if abs(train) > IDLE:
                paths.append(PathShare(mesh, case, train, elastic, elastic / train))
    return tuple(paths)


def _rows(sizing: Sizing, stage: str) -> list[str]:
    return [mesh.name for mesh in sizing.train.meshes if mesh.stage == stage]


# ----------------------------------------------------------------------------------------------------------------------
# How parallel meshes share their load by the errors of a design, held against the K_γ that they are rated with.
# ----------------------------------------------------------------------------------------------------------------------


MODE = "load sharing"
"""Name of the check."""
_CLAUSE = "ISO 6336-1:2006, clause 4; force method, slow errors"


def stages_in_parallel(sizing: Sizing) -> list[str]:
    """Return the stages whose meshes share by their errors: of several paths, without shares that the design states.

    Args:
        sizing: As sized.
    """
    stated = {name for name, pair in sizing.design.pairs.items() if pair.share is not None}
    return [stage for stage in parallel_meshes(sizing) if stage not in stated]


@verb
@one_blas_thread()
def load_factors(sizing: Sizing) -> Mapping[str, float]:
    """Return stage -> K_γ by the errors that a design states: of the case whose most loaded mesh bears most [-].

    Errors stand or turn slowly here; what teeth do to one another as they mesh is the dynamic factor's.

    Args:
        sizing: As sized; stages of which no error shifts load have none.
    """
    if not sizing.design.errors:
        return {}
    found = {stage: _factor(sizing, stage) for stage in stages_in_parallel(sizing)}
    return {stage: factor for stage, factor in found.items() if factor is not None}


def _factor(sizing: Sizing, stage: str) -> float | None:
    """Return K_γ of a stage [-]; None where equilibrium alone shares its load, or no case has an equilibrium."""
    largest, factor = 0.0, None
    for case in sizing.flows:
        if case_named(sizing.design, case).static:
            continue
        try:
            problem = sharing_problem(sizing, stage, case=case)
            sharing = load_sharing(problem.system, problem.lines, method="quasi-static")
        except GearwrightError:
            continue
        mean = abs(float(sharing.force.mean()))
        if problem.shifts and sharing.load_factor * mean > largest:
            largest, factor = sharing.load_factor * mean, sharing.load_factor
    return factor


def sharing_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield every stage of parallel meshes by its errors, and what no error and no load factor is stated of.

    Args:
        sizing: As sized.
    """
    factors = load_factors(sizing)
    for stage, factor in factors.items():
        rated = max(mesh.load_factor for mesh in sizing.meshes if mesh.stage == stage)
        yield Check(PartId(Kind.STAGE, stage), MODE, _CLAUSE, factor, rated, at_most=True, symbol="K_γ")
    silent = [stage for stage in stages_in_parallel(sizing) if stage not in factors and not _states(sizing, stage)]
    if silent:
        sized = {mesh.stage: mesh.load_factor for mesh in sizing.meshes}
        taken = ", ".join(f"{stage} {sized[stage]:.3g}" for stage in silent)
        why = f"no [errors] and no gears.mesh_load_factor; taken by the usual level of sharing: K_γ of {taken}"
        yield not_assessed(GEARBOX, MODE, _CLAUSE, why)


def _states(sizing: Sizing, stage: str) -> bool:
    """Tell whether a design says how a stage shares its load."""
    rules = sizing.design.rules(stage)
    return rules.mesh_load_factor is not None or bool(rules.planet_load_factors)


# ----------------------------------------------------------------------------------------------------------------------
# Load sharing against the number of planets: K_γ of many sets with random pin and tooth-thickness errors.
# ----------------------------------------------------------------------------------------------------------------------


UNIT = 1.0
"""Size of the errors whose effect is worked out once [m]: errors act in proportion."""


@dataclass(frozen=True)
class PlanetTolerances:
    """How far planets may differ from the drawing; errors are uniform within."""

    radial: float = 0.0
    """Pin in or out [m]."""
    tangential: float = 0.0
    """Pin ahead or behind [m]."""
    tooth_thickness: float = 0.0
    """Tooth too thick or too thin [m]."""


@dataclass(frozen=True, eq=False)
class PlanetSharing:
    """Mesh load factors of many random sets."""

    planets: tuple[int, ...]
    """Numbers of planets."""
    load_factor: Floats
    """K_γ of each set [-], shape (numbers of planets, sets)."""
    seed: int
    """Of the random numbers."""

    def percentile(self, percent: float) -> dict[int, float]:
        """Return number of planets -> K_γ that so many percent of all sets stay below [-].

        Args:
            percent: 0 to 100.
        """
        rows = zip(self.planets, self.load_factor, strict=True)
        return {count: float(np.percentile(row, percent)) for count, row in rows}


def planet_sharing(
    planetary: PlanetarySet,
    tolerances: PlanetTolerances,
    *,
    force: float,
    planets: Sequence[int] = (3, 4, 5, 6, 7),
    count: int = 5000,
    seed: int = 1,
) -> PlanetSharing:
    """Return the mesh load factor K_γ of random sets for several numbers of evenly spaced planets.

    Args:
        planetary: The set; its places and errors are replaced, its supports say what floats.
        tolerances: Of every planet.
        force: Sum of the tangential forces of all planets on their pins, the same for every number [N].
        planets: Numbers of planets to look at.
        count: Random sets for each.
        seed: Of the random numbers.

    Source: force method on the lines of Lin & Parker's set; K_γ as ISO 6336-1:2006, clause 4.
    """
    factors = [
        _factors(_even(planetary, number), tolerances, force=force, count=count, seed=seed) for number in planets
    ]
    return PlanetSharing(tuple(planets), np.array(factors), seed)


def _even(planetary: PlanetarySet, number: int) -> PlanetarySet:
    linear = replace(planetary, positions=even_positions(number), phases=None, errors={}, backlash=(0.0, 0.0))
    return replace(
        linear,
        sun_mesh=replace(linear.sun_mesh, cosine=(), sine=()),
        ring_mesh=replace(linear.ring_mesh, cosine=(), sine=()),
    )


def _factors(planetary: PlanetarySet, tolerances: PlanetTolerances, *, force: float, count: int, seed: int) -> Floats:
    """Return K_γ of random sets with one number of planets; teeth may part."""
    number = len(planetary.positions)
    system = _system(planetary, force, {})
    # Backlash without end lets the closed form part teeth that the errors pull at.
    free = system.arrays._replace(backlash=np.where(_is_mesh(system), np.inf, 0.0))
    train = redundancy(replace(system, arrays=free))
    basis = np.array([_unit_errors(planetary, force, error) for error in _units(number)])
    size = np.repeat([tolerances.radial, tolerances.tangential, tolerances.tooth_thickness], number)
    draw = np.random.default_rng(seed).uniform(-1.0, 1.0, (count, len(size)))
    suns = np.array(system.labels.places_of(mesh_part("", Row.SUN_PLANET)))
    pressed = line_forces(train, (draw * size) @ basis)[:, suns]
    return np.asarray(number * np.max(pressed, axis=1) / np.sum(pressed, axis=1))


def _is_mesh(system: System) -> Bools:
    return np.array([kind == "mesh" for kind in system.labels.line_kinds])


def _units(number: int) -> list[Mapping[int, PlanetError]]:
    """Return one unit error after the other: radial, tangential, thickness, each of every planet."""
    kinds = (PlanetError(radial=UNIT), PlanetError(tangential=UNIT), PlanetError(tooth_thickness=UNIT))
    return [{planet: kind} for kind in kinds for planet in range(1, number + 1)]


def _unit_errors(planetary: PlanetarySet, force: float, error: Mapping[int, PlanetError]) -> Floats:
    """Return what a unit error puts on every line [m]."""
    arrays = _system(planetary, force, error).arrays
    sums = np.zeros(len(arrays.stiffness))
    np.add.at(sums, np.repeat(np.arange(len(sums)), np.diff(arrays.error.start)), arrays.error.cosine)
    return sums


def _system(planetary: PlanetarySet, force: float, errors: Mapping[int, PlanetError]) -> System:
    """Return the set under load: sun driven, carrier held back, on the flanks that carry."""
    model = Model()
    add_planetary(model, replace(planetary, errors=errors, flank=1))
    angle = float(np.mean(np.cos(planetary.pressure_angles)))
    model.load("carrier", constant=-force * planetary.carrier.radius)
    model.load("sun", constant=force * planetary.sun.radius / (2.0 * angle))
    return model.build()


# ----------------------------------------------------------------------------------------------------------------------
# A design's planetary set with other numbers of planets: K_γ of random errors beside the closed form of one pin.
# ----------------------------------------------------------------------------------------------------------------------


_ANY = 1.0
"""Mass and inertia, on which forces that balance do not depend [kg] and [kg m²]."""


@dataclass(frozen=True, eq=False)
class PlanetCounts:
    """Mesh load factors of one set against the number of its planets."""

    stage: str
    """Planetary set."""
    tolerances: PlanetTolerances
    """The largest error of any planet in the design, of each kind."""
    random: PlanetSharing
    """Of random sets, the sun as the design supports it."""
    floating: Mapping[int, float]
    """Closed form: planets -> K_γ with one pin out of place tangentially, a member floats [-]; while all carry."""
    fixed: Mapping[int, float]
    """The same without a floating member [-]."""


def planet_counts(
    sizing: Sizing, problem: SharingProblem, *, planets: Sequence[int] = (3, 4, 5, 6, 7), seed: int = 1
) -> PlanetCounts | None:
    """Return K_γ against the number of planets; None for a stage without planets, or without errors of them.

    Args:
        sizing: What was sized.
        problem: Its sharing problem, of the stage and load case that count.
        planets: Numbers of planets; torque and gears are kept.
        seed: Of the random numbers.
    """
    tolerances = _tolerances(sizing, problem.stage)
    if problem.stage not in sizing.design.planetaries or tolerances == PlanetTolerances():
        return None
    set_ = _rigid_set(sizing, problem)
    cosine = float(np.mean(np.cos(set_.pressure_angles)))
    force = 2.0 * cosine * abs(float(np.sum(problem.train.perfect[problem.places])))
    random = planet_sharing(set_, tolerances, force=force, planets=planets, seed=seed)
    floating, fixed = (_one_pin(set_, tolerances.tangential, force, planets, floating=way) for way in (True, False))
    return PlanetCounts(problem.stage, tolerances, random, floating, fixed)


def _tolerances(sizing: Sizing, stage: str) -> PlanetTolerances:
    planetary, errors = sizing.design.planetaries.get(stage), sizing.design.errors
    numbers = range(1, (planetary.planets if planetary else 0) + 1)
    planets = [str(gear_part(stage, Role.PLANET, number=number)) for number in numbers]
    rows = [errors[name] for name in planets if name in errors]
    return PlanetTolerances(
        radial=max((abs(row.pin_radial) for row in rows), default=0.0),
        tangential=max((abs(row.pin_tangential) for row in rows), default=0.0),
        tooth_thickness=max((abs(row.tooth_thickness) for row in rows), default=0.0),
    )


def _rigid_set(sizing: Sizing, problem: SharingProblem) -> PlanetarySet:
    """Return the set with its mean stiffnesses, all rigid but for the sun's support; the ring holds the reaction."""
    stage, system = problem.stage, problem.system
    pairs, planetary = gear_pairs(sizing), sizing.design.planetaries[stage]
    rows = [mesh_part(stage, row) for row in (Row.SUN_PLANET, Row.PLANET_RING)]
    inner, outer = (pairs[str(row)] for row in rows)
    lines = [system.labels.places_of(row)[0] for row in rows]
    support = sizing.design.supports.get(planetary.sun)
    return PlanetarySet(
        sun=Member(_ANY, _ANY, inner.driver.base_radius, support=support.radial if support else math.inf),
        ring=Member(_ANY, _ANY, outer.driven.base_radius, torsion=math.inf),
        carrier=Member(_ANY, _ANY, inner.centre_distance),
        planet=Member(_ANY, _ANY, inner.driven.base_radius),
        sun_mesh=StiffnessCurve(float(system.arrays.stiffness[lines[0]])),
        ring_mesh=StiffnessCurve(float(system.arrays.stiffness[lines[1]])),
        pressure_angles=(inner.working_pressure_angle, outer.working_pressure_angle),
        positions=planet_positions(sizing.design, stage, sizing.teeth),
    )


def _one_pin(
    set_: PlanetarySet, error: float, force: float, planets: Sequence[int], *, floating: bool
) -> dict[int, float]:
    """Return planets -> K_γ of the closed form, where every planet keeps its load; without the others."""
    stiffness, angle = (set_.sun_mesh.mean, set_.ring_mesh.mean), float(np.mean(set_.pressure_angles))
    factors = {}
    for count in planets:
        share = pin_error_share(count, error, force, stiffness=stiffness, pressure_angle=angle, floating=floating)
        free = 3 if floating else 1
        if count == free:
            factors[count] = count * share
        elif count > free:
            # A neighbour loses (1 + 2 cos 2π/N) K e/F of an equal share where a member floats, K e/F where none does.
            loss = (count * share - 1.0) / (count - free)
            loss *= 1.0 + 2.0 * math.cos(2.0 * math.pi / count) if floating else 1.0
            if loss <= 1.0:
                factors[count] = count * share
    return factors
