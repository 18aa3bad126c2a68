"""Axes on which no order gives all that stands there room, and gears that are hollow around another shaft."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.checks import Check
from gearwright.identity import Kind, PartId, Role
from gearwright.sizing.arranged import Arrangement
from gearwright.sizing.arrangement import Axle, axles_in, best_way
from gearwright.sizing.places.coaxial import CLAUSE
from gearwright.sizing.rating import BACKUP, TOOTH_HEIGHT, Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.roots import root_diameter


def order_checks(context: Context, arrangement: Arrangement) -> Iterator[Check]:
    """Yield every axis on which nothing was found that lets all its shafts turn, and what would help.

    Args:
        context: What sizing reads.
        arrangement: Its axes and plans.
    """
    if not arrangement.unordered:
        return
    for axle in axles_in(context):
        if best_way(axle) is None:
            yield Check(
                PartId(Kind.SHAFT, axle.shafts[0]),
                "order along its axis",
                CLAUSE,
                0.0,
                1.0,
                exponent=None,
                why=_help(axle),
            )


def _help(axle: Axle) -> str:
    """Return what would make an order."""
    free = best_way(axle._replace(wished=()))
    if free is not None:
        names = ", ".join(axle.tokens[k].name for k in free.order)
        return f"no order that keeps to [layout] lets all shafts pass each other; without order and places: {names}"
    helps = [token.name for k, token in enumerate(axle.tokens) if token.kind != "set" and _without(axle, k)]
    if helps:
        return f"no order lets all shafts pass each other; one does without {' or without '.join(helps)}: move it"
    return "no order lets all shafts pass each other; join other members of the sets, or use a layshaft"


def _without(axle: Axle, left: int) -> bool:
    """Tell whether there is an order without one of the tokens."""
    tokens = (*axle.tokens[:left], *axle.tokens[left + 1 :])
    return best_way(Axle(axle.shafts, tokens, (), ())) is not None


def hollow_checks(context: Context, gears: Sequence[GearSizing], arrangement: Arrangement) -> Iterator[Check]:
    """Yield the rim of every gear of a hollow shaft around another one, over the height of its teeth.

    Args:
        context: What sizing reads.
        gears: As sized.
        arrangement: With its bodies.
    """
    hollow = {outer for _, outer in arrangement.within}
    for gear in gears if hollow else ():
        if gear.rim or gear.role is Role.PLANET or hollow.isdisjoint(gear.shafts):
            continue
        own = {gear.part, *(gear.body(shaft) for shaft in gear.shafts)}
        bore = max((body.bore for body in arrangement.bodies if body.part in own), default=0.0)
        rim = root_diameter(context, gear) / 2.0 - bore
        yield Check(
            gear.part, "rim around its bore", "ISO 6336-3:2019, Y_B", rim / (TOOTH_HEIGHT * gear.module), BACKUP,
            exponent=None, symbol="s_R/h_t",
        )  # fmt: skip
