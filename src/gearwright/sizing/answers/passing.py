"""How a train and its epicyclic sets pass power in every case, driven from either side; what locks itself, by name."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

from gearwright.checks import Check
from gearwright.identity import GEARBOX, Kind, PartId
from gearwright.sizing.result import Sizing
from gearwright.spec import Design, Pair
from gearwright.train import Efficiency, PowerFlow, Train, efficiencies, shaft_powers
from gearwright.units import Origin, Ratio

SOURCE = "equilibrium with the loss of every mesh, relative to its carrier (Müller 1998, Die Umlaufgetriebe)"


@dataclass(frozen=True)
class Passing:
    """Efficiency of the teeth of a train or of one of its sets, in one case."""

    case: str
    part: str
    """The gearbox, or a planetary or compound set."""
    driving: str
    """Shafts that give power to it, the largest first."""
    driven: str
    """Shafts that take power from it."""
    forwards: Annotated[Ratio, Origin("η = P_out/P_in", SOURCE)]
    """As the case drives it [-]."""
    backwards: Annotated[Ratio, Origin("η with every torque turned", SOURCE)]
    """Where the driven shafts drive it [-]; what is not above zero locks."""
    locking: str
    """Who cannot drive it, and who can, where it is self-locking; else empty."""


def passing(sizing: Sizing) -> tuple[Passing, ...]:
    """Return how power passes in every case with losses: the gearbox, and each set where it has several stages.

    Args:
        sizing: As sized.
    """
    return tuple(
        _row(case, part, way)
        for case, flow in sizing.flows.items()
        if flow.loss
        for part, way in _shown(sizing.design, ways_of(sizing, flow))
    )


def ways_of(sizing: Sizing, flow: PowerFlow, parts: Collection[str] | None = None) -> dict[str, Efficiency]:
    """Return how every stage passes power in a case, and the gearbox under an empty name.

    Args:
        sizing: As sized.
        flow: One of its cases.
        parts: Stages that are asked for, or the empty name; left out: all.
    """
    return efficiencies(sizing.design, sizing.train, sizing.teeth, flow, sizing.design.efficiencies, parts=parts)


def locking_checks(
    design: Design, train: Train, teeth: Mapping[str, float], flows: Mapping[str, PowerFlow]
) -> Iterator[Check]:
    """Yield a check that fails of every stage to which all its shafts give power: a case drives it as it locks.

    Args:
        design: With the efficiencies of its meshes.
        train: Its graph.
        teeth: Tooth number of every gear.
        flows: Its cases.
    """
    for case, flow in flows.items():
        powers = shaft_powers(train, flow)
        given = {stage: [power for (giver, _), power in powers.items() if giver == stage] for stage in design.stages}
        swallowing = [stage for stage, own in given.items() if _swallows(own)]
        ways = efficiencies(design, train, teeth, flow, design.efficiencies) if swallowing else {}
        for stage in swallowing:
            way = ways.get(stage)
            if way is not None and way.forwards <= 0.0:
                yield Check(
                    part=PartId(Kind.STAGE, stage), mode="self-locking", clause=SOURCE, case=case, exponent=None,
                    value=-sum(given[stage]), limit=0.0, dimension="power",
                    at_most=True, why=way.locking,
                )  # fmt: skip


def _swallows(powers: Sequence[float]) -> bool:
    """Tell whether a stage that gives such powers to its shafts [W] gives none any of what it gets; beside rounding."""
    least, most = min(powers, default=0.0), max(powers, default=0.0)
    return least < 0.0 and most <= -1e-9 * least


def _shown(design: Design, ways: Mapping[str, Efficiency]) -> Iterator[tuple[str, Efficiency]]:
    """Yield the gearbox and its epicyclic sets, of a gearbox that is one set the set alone."""
    sets = {stage: way for stage, way in ways.items() if stage and not isinstance(design.stages[stage], Pair)}
    if "" in ways and not (len(design.stages) == 1 and sets):
        yield str(GEARBOX), ways[""]
    yield from sets.items()


def _row(case: str, part: str, way: Efficiency) -> Passing:
    driving, driven = ", ".join(way.driving), ", ".join(way.driven)
    locking = f"self-locking: {way.locking}" if way.locking else ""
    return Passing(case, part, driving, driven, way.forwards, way.backwards, locking)
