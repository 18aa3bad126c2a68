"""Claims of Wang, Zhao, Tao, Jia and Guo on the face-gear split torque, with tables and figures."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from rich.console import RenderableType

from gearwright.base import Floats, Role, gear_part, verb
from gearwright.dynamics.equations import steady_forces
from gearwright.dynamics.sharing import (
    SIDEBANDS,
    TRANSIENT,
    LoadSharing,
    SharingProblem,
    influences,
    load_sharing,
    one_turn,
    parallel_meshes,
    shaft_displacement,
    sharing_problem,
    single_error_sharing,
    slow_displacement,
    tooth_cycle_means,
)
from gearwright.render.figures.dynamics import displacement_figure, sharing_figure, single_error_figure
from gearwright.render.grid import table
from gearwright.render.pages.motion import ClaimRow, Drawn, Paper
from gearwright.render.words.sizing import table_text
from gearwright.replays.replay import Verdict
from gearwright.sizing import Sizing, size
from gearwright.spec import Design, Pair
from gearwright.spec.design import ShaftLayout

# ----------------------------------------------------------------------------------------------------------------------
# The face-gear split torque of Wang, Zhao, Tao, Jia & Guo, known by its train and its data, whatever its names are.
#
# A pinion between two face gears drives two layshafts, whose pinions drive one wheel.
# ----------------------------------------------------------------------------------------------------------------------


FIRST_FIGURE = 8
"""Number of the paper's first figure on one error alone."""


class SplitTorque(NamedTuple):
    """Names of its parts."""

    face: str
    """Pair of the pinion with the two face gears."""
    joining: str
    """Pair at which the paths join."""
    pinion: str
    """Shaft 1, which floats."""
    paths: tuple[str, str]
    """Shafts 2 and 3."""
    output: str
    """Shaft 4."""

    @property
    def gears(self) -> tuple[str, ...]:
        """Bodies of gears 1 to 6."""
        left, right = self.paths
        gears = (
            gear_part(self.face, Role.PINION),
            gear_part(self.face, Role.WHEEL, left),
            gear_part(self.face, Role.WHEEL, right),
            gear_part(self.joining, Role.PINION, left),
            gear_part(self.joining, Role.PINION, right),
            gear_part(self.joining, Role.WHEEL),
        )
        return tuple(map(str, gears))

    @property
    def shafts(self) -> tuple[str, ...]:
        """Shafts 1 to 4."""
        return (self.pinion, *self.paths, self.output)

    @property
    def single_errors(self) -> dict[str, str]:
        """Error -> the paper's figure on it alone."""
        eccentric = [f"{part} eccentricity" for part in (*self.gears, self.pinion, *self.paths)]
        axial = [f"{shaft} axial" for shaft in self.paths]
        return {error: f"Fig. {number}" for number, error in enumerate([*eccentric, *axial], start=FIRST_FIGURE)}


@verb
def split_torque(design: Design) -> SplitTorque | None:
    """Return the parts of a face-gear split torque that has the support and the errors of the paper's figures.

    Args:
        design: Any.

    Returns:
        None if the train is another one, or if shaft 1 has no support or a part not the error that a figure shows.

    Source: Wang, Zhao, Tao, Jia & Guo, "Floating shaft load sharing method for face gear split torque transmission
        system".
    """
    parts = _parts(design)
    return parts if parts is not None and parts.pinion in design.supports and _has_errors(design, parts) else None


def _parts(design: Design) -> SplitTorque | None:
    if len(design.stages) != 2 or len(design.pairs) != 2:
        return None
    for face, joining in (tuple(design.pairs), tuple(design.pairs)[::-1]):
        first, second = design.pairs[face], design.pairs[joining]
        if first.kind == "face" and second.kind == "cylindrical" and not second.internal:
            return _joined(face, joining, first, second)
    return None


def _joined(face: str, joining: str, first: Pair, second: Pair) -> SplitTorque | None:
    if not (isinstance(first.pinion, str) and isinstance(second.wheel, str)):
        return None
    if isinstance(first.wheel, str) or len(first.wheel) != 2 or sorted(first.wheel) != sorted(second.pinion):
        return None
    left, right = first.wheel
    return SplitTorque(face, joining, first.pinion, (left, right), second.wheel)


def _has_errors(design: Design, parts: SplitTorque) -> bool:
    eccentric = all(
        part in design.errors and design.errors[part].eccentricity for part in (*parts.gears, *parts.shafts)
    )
    return eccentric and all(design.errors[shaft].axial for shaft in parts.paths)


# ----------------------------------------------------------------------------------------------------------------------
# The claims of Wang, Zhao, Tao, Jia & Guo on the face-gear split torque held against what gearwright computes.
#
# Every verdict is that of the numbers, which come from the given sizing; the paper leaves masses, stiffnesses and the
# hand of the layout open, so that some of its claims hold only under a condition.
# ----------------------------------------------------------------------------------------------------------------------


RIGID, FLOATING = 2e9, 1e7
"""Support stiffness of the pinion's shaft without floating, as of the other shafts, and of table 1 [N/m]."""
HALF = 5e7
"""The stiffness between, of the paper's figures 4 and 5 [N/m]."""
BETWEEN = 3e8
"""A stiffness at which a natural frequency meets the second mesh frequency [N/m]."""
ACCEPTED = 0.1
"""Deviation of a sharing coefficient from 1 above which paths are called unequal [-]."""
ALIKE = 0.1
"""Relative difference up to which effects are called the same [-]."""


@dataclass(frozen=True)
class SplitClaim:
    """A claim of the paper and what the equations give."""

    printed: str
    """In few words."""
    place: str
    """Where it stands."""
    verdict: Verdict
    """What the numbers say."""
    why: str
    """Reason, with numbers."""


def split_torque_claims(sizing: Sizing, parts: SplitTorque) -> tuple[SplitClaim, ...]:
    """Return every claim of the paper with its verdict.

    Args:
        sizing: Of the shipped design ``face-gear-split-torque``, or of another of this kind.
        parts: Its parts, from `split_torque`.

    Source: Wang, Zhao, Tao, Jia & Guo, "Floating shaft load sharing method for face gear split torque transmission
        system", case study and conclusion.
    """
    effects = _effects(sharing_problem(sizing, parts.joining))
    problems = {stiffness: _supported(sizing, parts, stiffness) for stiffness in (RIGID, HALF, FLOATING)}
    sharings = {stiffness: _sharing(problem) for stiffness, problem in problems.items()}
    return (
        _unequal(sharings[RIGID]),
        _improves(sharings),
        _moves_more([_displacement(problems[problem], parts, sharings[problem].time) for problem in problems]),
        _calmer(sizing, parts),
        _gears(effects, parts),
        _shafts(sizing, effects, parts),
        _three_percent(effects),
        _axial(effects, parts),
        _identical(effects, parts),
        _one_error(effects),
    )


def with_support(sizing: Sizing, shaft: str, stiffness: float) -> Sizing:
    """Return a sizing whose shaft is held by another stiffness.

    Args:
        sizing: With a support of the shaft.
        shaft: Its name.
        stiffness: Across the shaft [N/m].
    """
    supports = sizing.design.supports
    softer = {**supports, shaft: supports[shaft].model_copy(update={"radial": stiffness})}
    return replace(sizing, design=sizing.design.model_copy(update={"supports": softer}))


def _supported(sizing: Sizing, parts: SplitTorque, stiffness: float, stage: str = "") -> SharingProblem:
    return sharing_problem(with_support(sizing, parts.pinion, stiffness), stage or parts.joining)


def _sharing(problem: SharingProblem) -> LoadSharing:
    return load_sharing(problem.system, problem.lines, method="sidebands")


def _displacement(problem: SharingProblem, parts: SplitTorque, time: Floats) -> float:
    """Return how far shaft 1 moves at most, tooth ripple included [m]."""
    force = steady_forces(problem.system, sidebands=SIDEBANDS).at(time)
    return float(np.max(np.linalg.norm(shaft_displacement(problem, parts.pinion, force), axis=1)))


def _effects(problem: SharingProblem) -> dict[str, float]:
    """Return error -> largest change of b [-]."""
    return {
        influence.source: influence.effect for influence in influences(problem.train, problem.sources, problem.places)
    }


def _worst(sharing: LoadSharing) -> float:
    return float(np.max(np.abs(sharing.tooth_cycle - 1.0)))


def _verdict(*, always: bool, partly: bool = False) -> Verdict:
    return Verdict.HOLDS if always else Verdict.CONDITION if partly else Verdict.FAILS


def _unequal(rigid: LoadSharing) -> SplitClaim:
    worst = _worst(rigid)
    why = f"b leaves 1 by {worst:.0%} over a tooth cycle at {RIGID:.0e} N/m"
    return SplitClaim(
        "Without floating, the paths are obviously unequal", "figure 3", _verdict(always=worst > ACCEPTED), why
    )


def _improves(sharings: Mapping[float, LoadSharing]) -> SplitClaim:
    slow = [_worst(sharings[stiffness]) for stiffness in (RIGID, HALF, FLOATING)]
    fast = [float(np.ptp(sharings[stiffness].instantaneous)) for stiffness in (HALF, FLOATING)]
    falls = slow[0] > slow[1] > slow[2]
    why = (
        f"over a tooth cycle b leaves 1 by {slow[0]:.1%}, {slow[1]:.1%}, {slow[2]:.1%} at 2e9, 5e7, 1e7 N/m; at every "
        f"instant the tooth ripple stays, and the range falls only from {fast[0]:.2f} to {fast[1]:.2f}"
    )
    calm = falls and fast[1] / fast[0] < slow[2] / slow[1] * 1.2
    return SplitClaim(
        "Sharing becomes better as the support softens", "figures 3, 4, 6", _verdict(always=calm, partly=falls), why
    )


def _moves_more(displacements: Sequence[float]) -> SplitClaim:
    rigid, half, floating = (1e6 * displacement for displacement in displacements)
    why = f"{rigid:.0f}, {half:.0f}, {floating:.0f} µm at 2e9, 5e7, 1e7 N/m; it nears a kinematic limit"
    return SplitClaim(
        "The displacement of the shaft grows", "figures 5, 7", _verdict(always=rigid < half < floating), why
    )


def _calmer(sizing: Sizing, parts: SplitTorque) -> SplitClaim:
    quiet = replace(sizing, design=sizing.design.model_copy(update={"errors": {}}))
    stiffnesses = (RIGID, BETWEEN, HALF, FLOATING)
    ripple = {
        stage: [_ripple(_sharing(_supported(quiet, parts, stiffness, stage))) for stiffness in stiffnesses]
        for stage in (parts.face, parts.joining)
    }
    falling = [forces[0] > forces[2] > forces[3] for forces in ripple.values()]
    first, second = (", ".join(f"{force:.1%}" for force in forces) for forces in ripple.values())
    why = (
        f"without errors the tooth ripple of the forces at 2e9, 3e8, 5e7, 1e7 N/m is {first} (rms) of the mean in the "
        f"first stage and {second} in the second: on its way the support passes a resonance with the second mesh"
    )
    return SplitClaim(
        "Vibration decreases as the support softens",
        "conclusion",
        _verdict(always=all(falling), partly=any(falling)),
        why,
    )


def _ripple(sharing: LoadSharing) -> float:
    """Return the rms of what a force does within its tooth cycle, over its mean [-]."""
    mean = tooth_cycle_means(sharing.time, sharing.force, sharing.period)
    first = (len(sharing.time) - len(mean)) // 2
    ripple = sharing.force[first : first + len(mean)] - mean
    return float(np.sqrt(np.mean(ripple[:, 0] ** 2)) / np.mean(sharing.force[:, 0]))


def _gears(effects: dict[str, float], parts: SplitTorque) -> SplitClaim:
    first, second, _, fourth, _, sixth = parts.gears
    gear = {name: effects[f"{name} eccentricity"] for name in (first, second, fourth, sixth)}
    largest = max(gear, key=lambda name: gear[name]) == fourth
    others = [value for name, value in gear.items() if name != fourth]
    same = max(others) / min(others) <= 1.0 + ALIKE
    why = "; ".join(f"{name} {value:.2%}" for name, value in gear.items())
    words = "Eccentric gears 4 and 5 matter most, the others about the same"
    return SplitClaim(
        words, "figures 8 to 13", _verdict(always=largest and same, partly=largest), f"change of b: {why}"
    )


def _shafts(sizing: Sizing, effects: dict[str, float], parts: SplitTorque) -> SplitClaim:
    layout = sizing.design.layout
    output = layout.get(parts.output, ShaftLayout())
    turned = output.model_copy(update={"angle": (output.angle or 0.0) - math.pi})
    mirror = size(sizing.design.model_copy(update={"layout": {**layout, parts.output: turned}}))
    left, right = (f"{shaft} eccentricity" for shaft in parts.paths)
    mirrored = _effects(sharing_problem(mirror, parts.joining))
    here, there = (_largest_shaft(errors, parts) == parts.paths[0] for errors in (effects, mirrored))
    why = (
        f"shaft 2 {effects[left]:.2%}, shaft 3 {effects[right]:.2%}; with shaft 4 on the other side "
        f"{mirrored[left]:.2%} and {mirrored[right]:.2%}: the paper does not say on which"
    )
    return SplitClaim("Of the shafts, an eccentric shaft 2 matters most", "figures 14 to 16",
                      _verdict(always=here and there, partly=here or there), why)  # fmt: skip


def _largest_shaft(effects: dict[str, float], parts: SplitTorque) -> str:
    return max(parts.shafts, key=lambda name: effects[f"{name} eccentricity"])


def _three_percent(effects: dict[str, float]) -> SplitClaim:
    worst = max(effects.values())
    why = f"the largest of all errors of 25 µm changes b by {worst:.2%} at table 1's support"
    return SplitClaim("One error can make the paths unequal by 3 %", "text on figure 16",
                      _verdict(always=0.025 <= worst < 0.035), why)  # fmt: skip


def _axial(effects: dict[str, float], parts: SplitTorque) -> SplitClaim:
    left, right = (effects[f"{shaft} axial"] for shaft in parts.paths)
    same = math.isclose(left, right, rel_tol=1e-6)
    why = f"{left:.3%} and {right:.3%}: by geometry and at any support, not because the pinion floats"
    return SplitClaim("Axial errors of shafts 2 and 3 matter alike because the pinion floats", "figures 17, 18",
                      _verdict(always=False, partly=same), why)  # fmt: skip


def _identical(effects: dict[str, float], parts: SplitTorque) -> SplitClaim:
    pairs = ((parts.pinion, parts.gears[0]), (parts.output, parts.gears[-1]))
    same = all(
        math.isclose(effects[f"{shaft} eccentricity"], effects[f"{gear} eccentricity"], rel_tol=1e-9)
        for shaft, gear in pairs
    )
    why = "a shaft with one gear displaces the same mesh points"
    return SplitClaim(
        "An eccentric shaft 1 acts as an eccentric gear 1, shaft 4 as gear 6",
        "figures 8, 14",
        _verdict(always=same),
        why,
    )


def _one_error(effects: dict[str, float]) -> SplitClaim:
    part = max(effects.values()) / sum(effects.values())
    why = f"the largest is {part:.0%} of the sum of all"
    return SplitClaim("Cutting one error alone does not help much", "conclusion", _verdict(always=part < 0.25), why)


# ----------------------------------------------------------------------------------------------------------------------
# The claims of the paper as a table for the terminal.
# ----------------------------------------------------------------------------------------------------------------------


def claims_table(claims: Sequence[ClaimRow]) -> RenderableType:
    """Return what the paper says, what becomes of it, and why.

    Args:
        claims: Of the paper.
    """
    return table_text(table("Claims of the paper", claims, ("place", "printed", "verdict", "why")))


# ----------------------------------------------------------------------------------------------------------------------
# Counterparts of the paper's figures 3 to 18, with the claims, as its part of the page on load sharing.
# ----------------------------------------------------------------------------------------------------------------------


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
    time = one_turn(problems.values())
    moved = {label: slow_displacement(problem, parts.pinion, time) for label, problem in problems.items()}
    yield words, displacement_figure(moved, parts.pinion, time)
    alone = sharing_problem(sizing)
    span = (TRANSIENT, TRANSIENT + float(one_turn([alone])[-1]))
    # Over a tooth cycle the ripple is gone, so that mean stiffness is enough.
    sharings = {
        source.name: single_error_sharing(alone, source, method="frequency response", span=span)
        for source in alone.sources
    }
    words = "Figures 8 to 18: one error at a time, and those that the paper leaves out"
    yield words, single_error_figure(sharings, parts.single_errors)


def _solved(problems: Mapping[str, SharingProblem]) -> dict[str, LoadSharing]:
    return {name: load_sharing(problem.system, problem.lines, method="sidebands") for name, problem in problems.items()}
