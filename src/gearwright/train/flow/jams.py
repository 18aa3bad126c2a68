"""Why losses leave a load case no state in which the train turns, or several: what locks, and what would do."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from gearwright.errors import SolveError
from gearwright.train.flow.carried import PowerFlow
from gearwright.train.flow.efficiencies import Efficiency
from gearwright.train.flow.recirculation import recirculation
from gearwright.train.graph import Train


def jammed(
    train: Train, lossless: PowerFlow, found: Sequence[PowerFlow], ways: Mapping[str, Efficiency], *, complete: bool
) -> SolveError:
    """Return the error of a case that losses leave no state, several, or one that may not be the only one.

    Args:
        train: The graph.
        lossless: The case without losses.
        found: The states with losses.
        ways: Stage -> how it passes power in the senses of the lossless case; the train under an empty name.
        complete: Whether there is certainly no other state.
    """
    reasons = "; ".join(_reasons(train, lossless, ways))
    what = _several(found) if found else "with the losses of its teeth no torques balance: the train locks itself"
    if not complete:
        what = f"whether losses leave one state is not decided; {len(found)} found so far"
    fix = "Drive it from the other side, use higher efficiencies, or other teeth"
    if len(found) > 1:
        fix = "Let the machine whose power is stated balance, and state that of the other"
    return SolveError(f"cases.{lossless.case}: {what}{f' ({reasons})' if reasons else ''}. {fix}")


def _several(found: Sequence[PowerFlow]) -> str:
    """Return the states in words: what each machine whose power differs between them gives."""
    differing = [
        machine
        for machine, power in found[0].machine_powers.items()
        if any(abs(flow.machine_powers[machine] - power) > 1e-9 * abs(power) for flow in found[1:])
    ]
    states = ", or ".join(
        " and ".join(f"{machine} {flow.machine_powers[machine] / 1e3:+.4g} kW" for machine in differing)
        for flow in found
    )
    return f"with the losses of its teeth {len(found)} states balance: {states}"


def _reasons(train: Train, lossless: PowerFlow, ways: Mapping[str, Efficiency]) -> Iterator[str]:
    stages = {stage: way for stage, way in ways.items() if stage and way.locked}
    for stage, way in stages.items():
        yield f"{stage} is self-locking: {way.locking}"
    if not stages:
        for loop in recirculation(train, lossless):
            yield f"{loop.power / 1e3:.4g} kW would run in a circle: {', '.join(loop.path)}"
