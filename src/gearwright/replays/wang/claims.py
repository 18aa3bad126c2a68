"""The claims of Wang, Zhao, Tao, Jia & Guo on the face-gear split torque held against what gearwright computes.

Every verdict is that of the numbers, which come from the given sizing; the paper leaves masses, stiffnesses and the
hand of the layout open, so that some of its claims hold only under a condition.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from gearwright.dynamics.sharing import (
    LoadSharing,
    Method,
    SharingProblem,
    influences,
    load_sharing,
    sharing_problem,
    support_sweep,
    tooth_cycle_means,
)
from gearwright.replays.pulvirenti.claims import Verdict
from gearwright.sizing import Sizing, size

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


def split_torque_claims(sizing: Sizing) -> tuple[SplitClaim, ...]:
    """Return every claim of the paper with its verdict.

    Args:
        sizing: Of the shipped design ``face-gear-split-torque``, or of a variant with the same names.

    Source: Wang, Zhao, Tao, Jia & Guo, "Floating shaft load sharing method for face gear split torque transmission
        system", case study and conclusion.
    """
    effects = _effects(sharing_problem(sizing, "second"))
    sharings = {each: _sharing(sizing, each, "second") for each in (RIGID, HALF, FLOATING)}
    return (
        _unequal(sharings[RIGID]),
        _improves(sharings),
        _moves_more(sizing),
        _calmer(sizing),
        _gears(effects),
        _shafts(sizing, effects),
        _three_percent(effects),
        _axial(effects),
        _identical(effects),
        _one_error(effects),
    )


def with_support(sizing: Sizing, stiffness: float) -> Sizing:
    """Return a sizing whose input shaft is held by another stiffness.

    Args:
        sizing: With a support of the shaft ``input``.
        stiffness: Across the shaft [N/m].
    """
    supports = sizing.design.supports
    softer = {**supports, "input": supports["input"].model_copy(update={"radial": stiffness})}
    return replace(sizing, design=sizing.design.model_copy(update={"supports": softer}))


def _sharing(sizing: Sizing, stiffness: float, stage: str, method: Method = "sidebands") -> LoadSharing:
    problem = sharing_problem(with_support(sizing, stiffness), stage)
    return load_sharing(problem.system, problem.lines, method=method)


def _effects(problem: SharingProblem) -> dict[str, float]:
    """Return error -> largest change of b [-]."""
    return {each.source: each.effect for each in influences(problem.train, problem.sources, problem.places)}


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
    slow = [_worst(sharings[each]) for each in (RIGID, HALF, FLOATING)]
    fast = [float(np.ptp(sharings[each].instantaneous)) for each in (HALF, FLOATING)]
    falls = slow[0] > slow[1] > slow[2]
    why = (
        f"over a tooth cycle b leaves 1 by {slow[0]:.1%}, {slow[1]:.1%}, {slow[2]:.1%} at 2e9, 5e7, 1e7 N/m; at every "
        f"instant the tooth ripple stays, and the range falls only from {fast[0]:.2f} to {fast[1]:.2f}"
    )
    calm = falls and fast[1] / fast[0] < slow[2] / slow[1] * 1.2
    return SplitClaim(
        "Sharing becomes better as the support softens", "figures 3, 4, 6", _verdict(always=calm, partly=falls), why
    )


def _moves_more(sizing: Sizing) -> SplitClaim:
    moved = 1e6 * support_sweep(sizing, "input", (RIGID, HALF, FLOATING)).displacement
    why = f"{moved[0]:.0f}, {moved[1]:.0f}, {moved[2]:.0f} µm at 2e9, 5e7, 1e7 N/m; it nears a kinematic limit"
    return SplitClaim(
        "The displacement of the shaft grows", "figures 5, 7", _verdict(always=bool(np.all(np.diff(moved) > 0))), why
    )


def _calmer(sizing: Sizing) -> SplitClaim:
    quiet = replace(sizing, design=sizing.design.model_copy(update={"errors": {}}))
    stiffnesses = (RIGID, BETWEEN, HALF, FLOATING)
    ripple = {stage: [_ripple(_sharing(quiet, each, stage)) for each in stiffnesses] for stage in ("first", "second")}
    falling = [one[0] > one[2] > one[3] for one in ripple.values()]
    first, second = (", ".join(f"{each:.1%}" for each in one) for one in ripple.values())
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


_GEARS = ("first.pinion", "first.wheel.left", "second.pinion.left", "second.wheel")


def _gears(effects: dict[str, float]) -> SplitClaim:
    gear = {name: effects[f"{name} eccentricity"] for name in _GEARS}
    largest = max(gear, key=lambda name: gear[name]) == "second.pinion.left"
    others = [value for name, value in gear.items() if name != "second.pinion.left"]
    same = max(others) / min(others) <= 1.0 + ALIKE
    why = "; ".join(f"{name} {value:.2%}" for name, value in gear.items())
    words = "Eccentric gears 4 and 5 matter most, the others about the same"
    return SplitClaim(
        words, "figures 8 to 13", _verdict(always=largest and same, partly=largest), f"change of b: {why}"
    )


def _shafts(sizing: Sizing, effects: dict[str, float]) -> SplitClaim:
    layout = sizing.design.layout
    turned = layout["output"].model_copy(update={"angle": (layout["output"].angle or 0.0) - math.pi})
    other = size(sizing.design.model_copy(update={"layout": {**layout, "output": turned}}))
    mirrored = _effects(sharing_problem(other, "second"))
    here, there = (_largest_shaft(each) == "left" for each in (effects, mirrored))
    why = (
        f"shaft 2 {effects['left eccentricity']:.2%}, shaft 3 {effects['right eccentricity']:.2%}; with shaft 4 on the "
        f"other side {mirrored['left eccentricity']:.2%} and {mirrored['right eccentricity']:.2%}: the paper does not "
        "say on which"
    )
    return SplitClaim("Of the shafts, an eccentric shaft 2 matters most", "figures 14 to 16",
                      _verdict(always=here and there, partly=here or there), why)  # fmt: skip


def _largest_shaft(effects: dict[str, float]) -> str:
    return max(("input", "left", "right", "output"), key=lambda name: effects[f"{name} eccentricity"])


def _three_percent(effects: dict[str, float]) -> SplitClaim:
    worst = max(effects.values())
    why = f"the largest of all errors of 25 µm changes b by {worst:.2%} at table 1's support"
    return SplitClaim("One error can make the paths unequal by 3 %", "text on figure 16",
                      _verdict(always=0.025 <= worst < 0.035), why)  # fmt: skip


def _axial(effects: dict[str, float]) -> SplitClaim:
    left, right = effects["left axial"], effects["right axial"]
    same = math.isclose(left, right, rel_tol=1e-6)
    why = f"{left:.3%} and {right:.3%}: by geometry and at any support, not because the pinion floats"
    return SplitClaim("Axial errors of shafts 2 and 3 matter alike because the pinion floats", "figures 17, 18",
                      _verdict(always=False, partly=same), why)  # fmt: skip


def _identical(effects: dict[str, float]) -> SplitClaim:
    pairs = (("input", "first.pinion"), ("output", "second.wheel"))
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
