"""The verb: a design becomes a gearbox that meets everything, written out, or says what no freedom meets."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from gearwright.checks import Check, Status, accepted
from gearwright.closure.closed import Closed, Round, Step, Unmet
from gearwright.closure.flown import OnMission, lived, named
from gearwright.closure.life import stage_lives
from gearwright.closure.loop import CONFIRMS, Settled, Task, settled
from gearwright.closure.moves import borne, lightened, separated
from gearwright.closure.proportion import written_out
from gearwright.closure.requirements import REQUIREMENTS, requirement_of, wanted
from gearwright.closure.start import start_of
from gearwright.closure.wishes import Wishes
from gearwright.dynamics.sharing import sharing_checks
from gearwright.dynamics.vibration import peak_checks, resonance_checks
from gearwright.sizing.making import built_checks
from gearwright.sizing.rating import remembering
from gearwright.spec import Design
from gearwright.spec.design import given_values
from gearwright.verbs import verb

MOST_RUNS = 4
"""Simulations after each of which stages whose peaks exceed their rating are proportioned anew [-]."""
ABOVE = 1.01
"""Factor on the dynamic factor that a peak asks for, as the next size shakes a little otherwise [-]."""


@verb
@remembering()
def close(
    design: Design,
    *,
    wishes: Wishes | None = None,
    on_mission: OnMission | None = None,
    tell: Callable[[str], None] | None = None,
) -> Closed:
    """Return a design whose free sizes meet every requirement that its checks know, written out for `review`.

    Proportion: the least module and width of every stage under all its strengths, then shafts, pins and plates.
    Confirm: dynamic factors by the forced response at the speeds of every case, and proportion again, at most eight
    rounds. Bear: what planets turn on, where that is open. Separate: other teeth or modules where critical speeds lie
    too near. Lighten: what the wishes leave free. Simulate: the peaks of a run.

    Args:
        design: As `gearwright.read` gives it; what it gives is kept, and told where it does not do.
        wishes: Life, rounding, what is left out; left out: as the design says.
        on_mission: What its gears live through beside their cases; left out: no flight.
        tell: Called with what is being done.

    Raises:
        DesignError: If the design cannot be sized.
    """
    asked, say = wishes or Wishes(), tell or _silent
    start = start_of(design, asked)
    say("proportioning and confirming")
    state = settled(Task(start, asked))
    state = borne(state, say)
    if asked.separate and "critical speeds" not in asked.left_out:
        state = separated(state, say)
    if asked.lighten:
        state = lightened(state, say)
    state, peaks = _simulated(state, say)
    flown = list[Check]()
    if on_mission is not None:
        before = state.proportioned
        state, flown = lived(state, on_mission, say)
        state = named(state)
        if state.proportioned is not before:
            state, peaks = _simulated(state, say)
    return _closed(design, state, [*peaks, *flown])


def _silent(_: str) -> None:
    """Say nothing."""


def _simulated(state: Settled, say: Callable[[str], None]) -> tuple[Settled, list[Check]]:
    """Return a design whose peaks in a run stay within its rating, and the checks of them."""
    if CONFIRMS in state.task.wishes.left_out:
        return state, []
    for _ in range(MOST_RUNS):
        say("simulating every case")
        peaks = list(peak_checks(state.sizing))
        failing = [check for check in peaks if check.status is Status.FAILS]
        if not (factors := _asked_by(state, failing)):
            break
        words = "; ".join(f"{stage} K_V {factor:.3f}" for stage, factor in factors.items())
        lacking = min(check.margin or 0.0 for check in failing)
        round_ = Round(Step.SIMULATE, state.sizing.mass, lacking, 0.0, f"peaks ask for {words}")
        task = replace(state.task, factors={**state.task.factors, **factors})
        again = settled(task)
        state = replace(again, rounds=(*state.rounds, round_, *again.rounds))
    return state, peaks


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


def _closed(design: Design, state: Settled, moved: list[Check]) -> Closed:
    asked = state.task.wishes
    written, sizing, _ = written_out(state.proportioned, asked.left_out)
    checks = [*sizing.checks, *built_checks(sizing), *sharing_checks(sizing), *moved, *resonance_checks(sizing)]
    checks = [*wanted(checks, asked.left_out), state.converged]
    judged = accepted(checks, sizing.design.waivers)
    return Closed(
        design=written,
        sizing=sizing,
        checks=judged,
        rounds=state.rounds,
        unmet=tuple(_unmet(design, check) for check in judged if check.fails),
        lives=stage_lives(sizing, asked.left_out),
        kept=tuple(given_values(design).values),
        wishes=asked,
    )


def _unmet(design: Design, check: Check) -> Unmet:
    """Return what is not met, with what the design keeps the closure from changing."""
    name = requirement_of(check)
    kept = [path for path in given_values(design).values if path.partition(".")[0] == check.part.name]
    return Unmet(name, check, ", ".join(kept), REQUIREMENTS[name].helps)
