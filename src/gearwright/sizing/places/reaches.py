"""From where to where every shaft reaches along its axis, among others in line.

Masses and solids of shafts follow it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.identity import Kind
from gearwright.sizing.places.bells import Span, along, bells
from gearwright.sizing.places.plates import plates_of
from gearwright.sizing.result import Sizing
from gearwright.sizing.shafts import cut_steps

IN_LINE = 1e-6
"""How far two axes may be apart and count as one [m]."""
END = 2e-4
"""By which a shaft ends inside the face of what sits at its end, so that shafts in line do not touch [m]."""


class Run(NamedTuple):
    """A shaft, or a piece of one, from end to end."""

    shaft: str
    steps: tuple[tuple[float, float, float], ...]
    """Start, end and radius of each, from the shaft's first end [m]."""
    bore: float
    """Radius [m]."""
    piece: int = 1
    """Of the shaft, from its first end: one that is the cage of a set in between has two."""

    @property
    def volume(self) -> float:
        """Of its metal [m³]."""
        return math.pi * sum((radius**2 - self.bore**2) * (end - start) for start, end, radius in self.steps)

    @property
    def label(self) -> str:
        """As the scene names it."""
        return f"shaft {self.shaft}" if self.piece == 1 else f"shaft {self.shaft}, piece {self.piece}"


def runs(sizing: Sizing) -> tuple[tuple[Run, ...], tuple[str, ...]]:
    """Return every shaft, and in sentences which are cut because another one stands in their place.

    Args:
        sizing: As sized.
    """
    built = {shaft.name: shaft for shaft in sizing.built_shafts}
    spans = {shaft.name: _reach(sizing, shaft.name, shaft.length) for shaft in sizing.shafts}
    cut = _cleared(sizing, spans)
    found, words = [], []
    for shaft in sizing.shafts:
        low, high = cut[shaft.name]
        if shaft.name not in built and _is_cage(sizing, shaft.name):
            words.append(f"shaft {shaft.name} is the cage of its planets alone: nothing else sits on it, none is drawn")
            continue
        if shaft.name not in built and any(shaft.name in pair for pair in sizing.arrangement.within):
            found += [
                Run(shaft.name, ((start, end, shaft.diameter / 2.0),), shaft.bore / 2.0, k + 1)
                for k, (start, end) in enumerate(_pieces(sizing, shaft.name))
            ]
            continue
        if shaft.name in built:
            steps = cut_steps(sizing, built[shaft.name])
            found.append(Run(shaft.name, steps, built[shaft.name].bore / 2.0))
            continue
        found.append(Run(shaft.name, ((low, high, shaft.diameter / 2.0),), shaft.bore / 2.0))
        less = spans[shaft.name][1] - spans[shaft.name][0] - (high - low)
        if less > IN_LINE:
            words.append(
                f"shaft {shaft.name} is drawn {1e3 * less:.3g} mm shorter than sized: another body stands there"
            )
    return tuple(found), tuple(words)


def _is_cage(sizing: Sizing, shaft: str) -> bool:
    """Tell whether a shaft is a carrier's alone, so that nothing goes on from its plate."""
    plan = sizing.arrangement.plans[shaft]
    return len(plan.places) == 1 and any(stage.carrier == shaft for stage in sizing.design.sets.values())


def _pieces(sizing: Sizing, shaft: str) -> list[Span]:
    """Return the stretches of a shaft in or around another one, with the hubs of what sits on it.

    Within a set, the shaft of its carrier or ring is the set's own cage or bell.
    """
    bodies = [body for body in sizing.arrangement.bodies if body.shaft == shaft]
    rings = {gear.part for gear in sizing.gears if gear.rim}
    spans = [along(sizing, shaft, body) for body in bodies if body.part.kind is Kind.SHAFT]
    seated = [body for body in bodies if body.part.kind is not Kind.SHAFT and body.part not in rings]
    hubs = [along(sizing, shaft, body) for body in seated]
    hubs = [(low + END, high - END) for low, high in hubs]
    hubs += [bell.disc for bell in bells(sizing) if bell.ring.shafts[0] == shaft]
    merged: list[Span] = []
    for low, high in sorted((min(span), max(span)) for span in (*spans, *hubs)):
        if merged and low <= merged[-1][1] + 2.0 * END:
            merged[-1] = (merged[-1][0], max(merged[-1][1], high))
        else:
            merged.append((low, high))
    return merged


def _own(sizing: Sizing, shaft: str) -> list[Span]:
    """Return where a shaft's own gears, plates and bearings sit on it; rings are tied to it by a disc."""
    rings = {gear.part for gear in sizing.gears if gear.rim}
    seated = (body for body in sizing.arrangement.bodies if body.shaft == shaft and body.part.kind is not Kind.SHAFT)
    bodies = (body for body in seated if body.part not in rings)
    return [along(sizing, shaft, body) for body in bodies] + [
        (min(bell.disc), max(bell.disc)) for bell in bells(sizing) if bell.ring.shafts[0] == shaft
    ]


def _reach(sizing: Sizing, shaft: str, length: float) -> Span:
    """Return a shaft from its first end to its second one, and on through what sits at its ends."""
    own = [(low + END, high - END) for low, high in _own(sizing, shaft) if high - low > 4.0 * END]
    return min([0.0, *(low for low, _ in own)]), max([length, *(high for _, high in own)])


def _cleared(sizing: Sizing, spans: Mapping[str, Span]) -> dict[str, Span]:
    """Return the shafts without what hangs over their own parts into another one in line, which has parts there."""
    cut, frames = dict(spans), sizing.arrangement.frames
    built = {shaft.name for shaft in sizing.built_shafts}
    names = [name for name in spans if name not in built]
    for name in names:
        core = _hull(_own(sizing, name))
        if core is None:
            continue
        for other in spans:
            offset = _in_line(sizing, name, other)
            if other == name or offset is None:
                continue
            sign = 1.0 if np.dot(frames[name].along, frames[other].along) > 0.0 else -1.0
            taken = sorted(offset + sign * end for end in cut[other])
            low, high = cut[name]
            if low < taken[1] and taken[0] < core[0] and taken[1] <= core[0] + IN_LINE:
                low = max(low, taken[1]) if taken[0] <= low else core[0]
            if high > taken[0] and taken[1] > core[1] and taken[0] >= core[1] - IN_LINE:
                high = min(high, taken[0]) if taken[1] >= high else core[1]
            cut[name] = (min(low, core[0]), max(high, core[1]))
        cut[name] = _before_plates(sizing, name, core, cut[name])
    return cut


def _before_plates(sizing: Sizing, shaft: str, core: Span, span: Span) -> Span:
    """Return a shaft that ends before plates of carriers beside it, beyond its own parts."""
    frame, (low, high) = sizing.arrangement.frames[shaft], span
    radius = next(one.diameter for one in sizing.shafts if one.name == shaft) / 2.0
    for plate in (plate for stage in sizing.design.sets for plate in plates_of(sizing, stage)):
        between = np.asarray(plate.origin) - np.asarray(frame.origin)
        beside = float(np.linalg.norm(between - (between @ np.asarray(frame.along)) * np.asarray(frame.along)))
        tilt = float(np.linalg.norm(np.cross(plate.direction, frame.along)))
        if tilt > IN_LINE or not IN_LINE < beside < plate.radius + radius:
            continue
        near, far = along(sizing, shaft, plate)
        if core[1] <= near + IN_LINE and near < high:
            high = max(near, core[1])
        if far - IN_LINE <= core[0] and low < far:
            low = min(far, core[0])
    return low, high


def _hull(spans: Sequence[Span]) -> Span | None:
    return (min(low for low, _ in spans), max(high for _, high in spans)) if spans else None


def _in_line(sizing: Sizing, shaft: str, other: str) -> float | None:
    """Return where the first end of another shaft lies along a shaft on one axis with it; None of other axes [m]."""
    one, two = (sizing.arrangement.frames[name] for name in (shaft, other))
    between = np.asarray(two.origin) - np.asarray(one.origin)
    far = float(between @ np.asarray(one.along))
    beside = float(np.linalg.norm(between - far * np.asarray(one.along)))
    tilt = float(np.linalg.norm(np.cross(one.along, two.along)))
    return far if beside < IN_LINE and tilt < IN_LINE else None
