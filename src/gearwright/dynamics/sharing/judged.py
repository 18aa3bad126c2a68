"""How parallel meshes share their load by the errors of a design, held against the K_γ that they are rated with."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.blas_threads import one_blas_thread
from gearwright.checks import Check, not_assessed
from gearwright.dynamics.sharing.of_design import parallel_meshes, sharing_problem
from gearwright.dynamics.sharing.solutions import load_sharing
from gearwright.errors import GearwrightError
from gearwright.identity import GEARBOX, Kind, PartId
from gearwright.sizing import Sizing
from gearwright.spec.design import case_named
from gearwright.verbs import verb

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
