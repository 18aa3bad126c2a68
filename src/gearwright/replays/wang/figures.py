"""Counterparts of the paper's figures 3 to 18, with the claims, as its part of the page on load sharing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.dynamics.sharing import (
    TRANSIENT,
    LoadSharing,
    SharingProblem,
    load_sharing,
    parallel_meshes,
    sharing_problem,
)
from gearwright.render.figures.sharing import displacement_figure, one_turn, sharing_figure, single_error_figure
from gearwright.render.pages.sharing import ClaimRow, Drawn, Paper
from gearwright.replays.verdict import Verdict
from gearwright.replays.wang.claims import FLOATING, HALF, RIGID, split_torque_claims, with_support
from gearwright.replays.wang.split_torque import SplitTorque, split_torque
from gearwright.sizing import Sizing

_SIGNS = {Verdict.HOLDS: "yes", Verdict.CONDITION: "partly", Verdict.FAILS: "no"}


def paper(sizing: Sizing) -> Paper | None:
    """Return the paper's figures and claims for a face-gear split torque; None for any other train.

    Args:
        sizing: Of any design.
    """
    parts = split_torque(sizing.design)
    if parts is None:
        return None
    claims = split_torque_claims(sizing, parts)
    rows = (
        ClaimRow(claim.place, claim.printed, claim.verdict.value, _SIGNS[claim.verdict], claim.why) for claim in claims
    )
    return Paper(paper_figures(sizing, parts), tuple(rows))


def paper_figures(sizing: Sizing, parts: SplitTorque) -> Iterator[Drawn]:
    """Yield the counterparts of the paper's figures 3 to 18, with captions.

    Args:
        sizing: Of the shipped design ``face-gear-split-torque``, or of another of this kind.
        parts: Its parts, from `split_torque`.

    Source: Wang, Zhao, Tao, Jia & Guo, "Floating shaft load sharing method for face gear split torque transmission
        system".
    """
    for stiffness, number in ((RIGID, "Figure 3"), (HALF, "Figure 4"), (FLOATING, "Figure 6")):
        softer = with_support(sizing, parts.pinion, stiffness)
        problems = {stage: sharing_problem(softer, stage) for stage in parallel_meshes(softer)}
        yield f"{number}: load sharing, support of shaft 1 {stiffness:.0e} N/m", sharing_figure(_solved(problems))
    soft = {stiffness: with_support(sizing, parts.pinion, stiffness) for stiffness in (HALF, FLOATING)}
    problems = {f"{stiffness:.0e} N/m": sharing_problem(softer) for stiffness, softer in soft.items()}
    words = "Figures 5 and 7: displacement of shaft 1 by slow errors, without tooth ripple"
    yield words, displacement_figure(problems, parts.pinion, one_turn(problems))
    alone = sharing_problem(sizing)
    span = (TRANSIENT, TRANSIENT + float(one_turn({"": alone})[-1]))
    words = "Figures 8 to 18: one error at a time, and those that the paper leaves out"
    yield words, single_error_figure(alone, span, parts.single_errors)


def _solved(problems: Mapping[str, SharingProblem]) -> dict[str, LoadSharing]:
    return {name: load_sharing(problem.system, problem.lines, method="sidebands") for name, problem in problems.items()}
