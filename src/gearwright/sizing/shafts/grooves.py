"""Retaining ring grooves and lock nut threads in stepped shafts, and the remaining strength."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from gearwright.base import Check, Kind, PartId
from gearwright.catalogue import LockNut, ThreadUndercut, thread_run_out, thread_undercut
from gearwright.parts.shaft_fatigue import Shoulder
from gearwright.sizing.loads import shaft_forces
from gearwright.sizing.rating import context_of
from gearwright.sizing.result import Sizing
from gearwright.sizing.shaft_results import BuiltShaft, SectionStrength
from gearwright.sizing.shafts.ends import (
    holders_of,
)
from gearwright.sizing.shafts.retention import ends
from gearwright.sizing.shafts.sections import Section, Strength, strengths, undercuts_of

# ----------------------------------------------------------------------------------------------------------------------
# Threads of lock nuts in built shafts: from where to where they are cut, how they end, what they leave of the shaft.
#
# Full turns begin where the nut does, beyond its washer, and go on outwards as far as the shaft is as thick, since the
# nut comes from there. Inwards a thread ends beneath washer and inner ring: in an undercut DIN 76 - A where the design
# asks for undercuts at its shoulders, else in turns that run out over 2.5 P.
# ----------------------------------------------------------------------------------------------------------------------


class Thread(NamedTuple):
    """A thread on a shaft."""

    shaft: str
    beside: str
    """Part that its nut holds."""
    way: int
    """Towards which end the nut is screwed off."""
    nut: LockNut
    foot: float
    """Where undercut or run-out begin, from the shaft's first end [m]."""
    first: float
    """Where its full turns begin [m]."""
    last: float
    """Where it starts, with a chamfer [m]."""
    undercut: ThreadUndercut | None
    """None where its turns run out."""

    @property
    def turns(self) -> tuple[float, float]:
        """Lower and upper end of its full turns [m]."""
        return min(self.first, self.last), max(self.first, self.last)

    @property
    def fading(self) -> tuple[float, float]:
        """Lower and upper end of its undercut, or of the turns that run out [m]."""
        return min(self.foot, self.first), max(self.foot, self.first)

    @property
    def bottom(self) -> float:
        """Diameter of its undercut, where it has one, else of its core [m]."""
        return self.nut.core if self.undercut is None else self.nut.thread - self.undercut.below


def threads(sizing: Sizing) -> Iterator[Thread]:
    """Yield the threads of every built shaft.

    Args:
        sizing: As sized.
    """
    kinds = {(holder.shaft, holder.beside) for holder in holders_of(sizing) if holder.kind == "lock nut"}
    for end in ends(sizing) if kinds else ():
        nut = end.nut
        if (end.shaft, end.outermost) not in kinds or nut is None:
            continue
        first = end.place + end.way * nut.washer
        cut = thread_undercut(nut.pitch) if sizing.design.shafting.shoulders == "undercut" else None
        foot = first - end.way * (thread_run_out(nut.pitch) if cut is None else cut.width)
        yield Thread(end.shaft, end.outermost, end.way, nut, foot, first, end.level, cut)


# ----------------------------------------------------------------------------------------------------------------------
# Grooves of retaining rings, threads of lock nuts and their undercuts in built shafts: what they leave of strength.
#
# They are found after a shaft is built, beyond its outermost bearings and hubs: it does not grow by them. Its safeties
# there are checks of their own.
# ----------------------------------------------------------------------------------------------------------------------


GROOVE_RADIUS = 0.1
"""At the bottom of a ring's groove over the thickness of the ring, at most: DIN 471 [-]."""
ROOT_RADIUS = 0.125
"""At the root of a thread over its pitch, at least: ISO 965-1 [-]."""
_NEAR = 1e-9
"""Places that are nearer to each other are one [m]."""


class Groove(NamedTuple):
    """What is cut into a shaft for a ring or a nut."""

    shaft: str
    start: float
    """From the shaft's first end [m]."""
    end: float
    """[m]"""
    diameter: float
    """That is left: of a thread its core [m]."""
    radius: float
    """At the bottom [m]."""
    what: str
    """Such as ``groove of DIN 471 - 30 x 1.5``, ``thread M30 x 1.5`` or ``undercut of thread M30 x 1.5``."""
    around: float
    """Diameter beside a round groove, whose stress is that of its shape [m]; 0 of what is as sharp as a ring's."""
    is_thread: bool = False


def grooves(sizing: Sizing) -> Iterator[Groove]:
    """Yield the grooves, threads and undercuts of threads of every built shaft.

    Args:
        sizing: As sized.
    """
    kinds = {(holder.shaft, holder.beside) for holder in holders_of(sizing) if holder.kind == "retaining ring"}
    for end in ends(sizing) if kinds else ():
        if (end.shaft, end.outermost) in kinds and end.has_ring and end.ring is not None:
            low, high = sorted((end.place, end.place + end.way * end.ring.groove_width))
            radius = GROOVE_RADIUS * end.ring.thickness
            yield Groove(end.shaft, low, high, end.ring.groove, radius, f"groove of {end.ring.designation}", 0.0)
    for thread in threads(sizing):
        nut, sharp = thread.nut, ROOT_RADIUS * thread.nut.pitch
        what = f"thread {nut.cut}"
        low, high = thread.turns if thread.undercut else (min(thread.foot, thread.last), max(thread.foot, thread.last))
        yield Groove(thread.shaft, low, high, nut.core, sharp, what, 0.0, is_thread=True)
        if thread.undercut is not None:
            foot, first = thread.fading
            yield Groove(
                thread.shaft, foot, first, thread.bottom, thread.undercut.radius, f"undercut of {what}", nut.thread
            )


def cut_steps(sizing: Sizing, shaft: BuiltShaft) -> tuple[tuple[float, float, float], ...]:
    """Return the steps of a shaft with its undercuts and the grooves of its rings, as start, end and radius [m].

    Args:
        sizing: As sized.
        shaft: One of its built shafts.
    """
    own = [groove for groove in grooves(sizing) if groove.shaft == shaft.name and not groove.is_thread]
    taken = [(groove.start, groove.end, groove.diameter) for groove in own]
    taken += [(min(cut.place, cut.edge), max(cut.place, cut.edge), cut.bottom) for cut in undercuts_of(sizing, shaft)]
    steps = []
    for step in shaft.steps:
        edges = {step.start, step.end}
        edges |= {edge for start, end, _ in taken for edge in (start, end) if step.start < edge < step.end}
        places = sorted(edges)
        for low, high in pairwise(places):
            cut = [left for start, end, left in taken if start < high - _NEAR and end > low + _NEAR]
            steps.append((low, high, min([step.diameter, *cut]) / 2.0))
    return tuple(steps)


def groove_strengths(sizing: Sizing) -> Iterator[SectionStrength]:
    """Yield the safeties of every groove and thread.

    Args:
        sizing: As sized.
    """
    context = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    gears = {gear.name: gear for gear in sizing.gears}
    for shaft in sizing.built_shafts:
        own = [groove for groove in grooves(sizing) if groove.shaft == shaft.name]
        if not own:
            continue
        plan = sizing.arrangement.plans[shaft.name]
        forces = shaft_forces(context, shaft.name, plan, axes=sizing.arrangement.axes, gears=gears)
        judge = Strength(shaft.name, sizing.design, sizing.design.shaft_material, tuple(context.flows))
        blank = max(step.diameter for step in shaft.steps)
        sections = [_section(groove, at, blank) for groove in own for at in (groove.start, groove.end)]
        yield from strengths(sections, forces, judge, bore=shaft.bore)


def groove_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the safeties of every groove and thread against fatigue and yielding, the worse of its two edges.

    Args:
        sizing: As sized.
    """
    asked = sizing.design.service
    worst: dict[tuple[str, str], SectionStrength] = {}
    for found in groove_strengths(sizing):
        key = (found.shaft, found.place)
        if key not in worst or found.fatigue_safety < worst[key].fatigue_safety:
            worst[key] = found
    for (shaft, place), found in worst.items():
        part = PartId(Kind.SHAFT, shaft)
        clause = "DIN 743-2, round groove" if found.fillet else "Shigley, table 7-1"
        safeties = (("fatigue", "n_f", found.fatigue_safety, asked.shaft_fatigue_safety),
                    ("yield", "n_y", found.yield_safety, asked.shaft_yield_safety))  # fmt: skip
        for mode, symbol, safety, least in safeties:
            yield Check(part, f"{mode} at its {place}", clause, safety, least, symbol=symbol, case=found.case)


def _section(groove: Groove, place: float, blank: float) -> Section:
    """Return a section at an edge of a groove."""
    if not groove.around:
        return Section(groove.what, groove.what, place, groove.diameter, blank, hub="groove", radius=groove.radius)
    depth = (groove.around - groove.diameter) / 2.0
    round_groove = Shoulder(groove.diameter, groove.around, groove.radius, depth)
    return Section(groove.what, groove.what, place, groove.diameter, blank, round_groove)
