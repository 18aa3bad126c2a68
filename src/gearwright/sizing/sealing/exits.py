"""Exits: where a shaft leaves the housing towards a machine, and the lip that may run there.

Of elastomers the first is taken whose speed (SKF, by diameter) is not exceeded in any load case and that bears the oil:
lips are warmer than the oil before them by 20 to 50 K (a maker's guide, SVKS), of which the least is asked. What no lip
bears, as input shafts of turbines often are, has a labyrinth or a carbon face seal: neither is sized, weighed by more
than an estimate, or drawn.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gearwright.catalogue import ELASTOMERS, Elastomer, RadialSeal, lip_speed, next_seal_shaft, seals_for
from gearwright.latest import of_latest
from gearwright.sizing.result import Sizing
from gearwright.sizing.sealing.leaving import NEAR, leaving_of
from gearwright.units import text

LIP_WARMER = 20.0
"""How much warmer a lip is than the oil before it, the least of what makers name [K]."""
INSTEAD = "a labyrinth or a carbon face seal, as aircraft's gearboxes have, is to be designed: none is sized or drawn"


class Exit(NamedTuple):
    """Where a shaft leaves the housing."""

    machine: str
    """Towards which it leaves."""
    shaft: str
    way: int
    """−1 at the first end of a built shaft, +1 at the second; 0 of a shaft of the first sizing."""
    diameter: float
    """Of the shaft where a lip runs on it [m]; of a shaft of the first sizing its one diameter."""
    velocity: float
    """Of its surface there, the largest of all load cases [m/s]."""
    elastomer: Elastomer | None
    """Of a lip that bears it, or that the design asks for; None where none does."""
    seal: RadialSeal | None
    """Its smallest size; None without a lip, and of shafts of the first sizing."""
    lacking: str
    """Why it has no seal, and what helps; empty where it has one."""

    @property
    def limit(self) -> float | None:
        """Speed that its lip bears [m/s]; None without one."""
        return None if self.elastomer is None else lip_speed(self.diameter, self.elastomer)


@of_latest
def exits_of(sizing: Sizing) -> tuple[Exit, ...]:
    """Return where shafts leave the housing; nothing where the gearbox has none of its own.

    Args:
        sizing: As sized.
    """
    return (*_built(sizing), *_first(sizing)) if sizing.design.housing.own else ()


def _built(sizing: Sizing) -> Iterator[Exit]:
    for end in leaving_of(sizing):
        plan = sizing.arrangement.plans[end.shaft]
        beyond = [name for name, node in sizing.train.machines.items()
                  if node == end.shaft and end.way * (plan.places[name] - end.face) > -NEAR]  # fmt: skip
        machine = min(beyond, key=lambda name: abs(plan.places[name] - end.face))
        made = _lip(sizing, machine, end.shaft, end.way, end.diameter)
        sizes = seals_for(end.diameter)
        if made.elastomer is not None and not sizes:
            wide, best = 1e3 * end.diameter, next_seal_shaft(end.diameter)
            more = "none is larger" if best is None else f"the next is for {1e3 * best:g} mm"
            lacking = f"ISO 6194-1 and SKF have no seal for {wide:g} mm, {more}: make the shaft that thick there"
            made = made._replace(lacking=lacking)
        yield made._replace(seal=sizes[0]) if made.elastomer is not None and sizes else made


def _first(sizing: Sizing) -> Iterator[Exit]:
    built = {shaft.name for shaft in sizing.built_shafts}
    diameters = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    for machine, shaft in sizing.train.machines.items():
        if shaft in diameters and shaft not in built:
            made = _lip(sizing, machine, shaft, 0, diameters[shaft])
            if made.elastomer is not None:
                told = f"{text(made.velocity, 'velocity')} on a first {1e3 * made.diameter:.3g} mm"
                bears = f"a lip of {made.elastomer.mark} bears {text(made.limit or 0.0, 'velocity')}"
                made = made._replace(lacking=f"{told}, and {bears}; shafts with [bearings] get seals")
            yield made


def _lip(sizing: Sizing, machine: str, shaft: str, way: int, diameter: float) -> Exit:
    """Return an exit with what its lip is of, as yet without a size."""
    asked, warm = sizing.design.shafting.seal, sizing.design.oil.temperature + LIP_WARMER
    velocity = max(abs(flow.speeds[shaft]) for flow in sizing.flows.values()) * diameter / 2.0
    bare = Exit(machine, shaft, way, diameter, velocity, None, None, "")
    if asked == "none":
        return bare._replace(lacking='the design asks for none (seal = "none")')
    if asked != "auto":
        return bare._replace(elastomer=next(one for one in ELASTOMERS if one.name == asked))
    for one in ELASTOMERS:
        if velocity <= lip_speed(diameter, one) and warm <= one.hottest:
            return bare._replace(elastomer=one)
    best = ELASTOMERS[-1]
    bears = text(lip_speed(diameter, best), "velocity")
    if warm > best.hottest:
        return bare._replace(lacking=f"no lip bears {warm:g} °C; {INSTEAD}")
    said = f"{text(velocity, 'velocity')} on {1e3 * diameter:.3g} mm are more than a lip of {best.mark} bears, {bears}"
    return bare._replace(lacking=f"{said}; {INSTEAD}")
