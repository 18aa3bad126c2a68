"""Rims and webs of gears, thinner and thicker: as far as roots bear them and standards know them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import NamedTuple

from gearwright.parts.gears import ISO53_A
from gearwright.sizing import Sizing
from gearwright.sizing.mass.bodies import gear_blanks
from gearwright.sizing.rating import BACKUP, LEAST_RING
from gearwright.spec import Design
from gearwright.spec.design import RATINGS
from gearwright.spec.edit import Value

THINNEST_WEB = 0.2
"""Web over face width [-]: the least for which ISO 6336-1:2006, clause 9 knows how a blank yields (C_R)."""


class Body(NamedTuple):
    """A thickness under teeth that may be changed."""

    key: str
    """Of `[gears]` of a stage."""
    steps: tuple[float, ...]
    """By which it is changed [-]."""
    most: float
    """Thickest one that is tried: more makes nothing stronger [-]."""
    least: Callable[[Sizing, str], float]
    """Thinnest one of a stage [-]."""
    limit: str
    """What that is."""
    has: Callable[[Design, str], bool]
    """Whether a stage has it."""
    beside: Callable[[Design, str], Mapping[str, Value]] = lambda *_: {}
    """Key -> value of the same table that is stated with it."""


def _cylindrical(design: Design, stage: str) -> bool:
    return stage in design.planetaries or design.pairs[stage].kind == "cylindrical"


def _has_rim(design: Design, stage: str) -> bool:
    pair = design.pairs.get(stage)
    return "rim_ratio" in RATINGS[design.rating(stage)].reads and (pair is None or not pair.internal)


def _has_ring(design: Design, stage: str) -> bool:
    return stage in design.planetaries or design.pairs[stage].internal


def _rim_of_planets(design: Design, stage: str) -> Mapping[str, Value]:
    """Return the rim of planets: not stated, it would follow the ring's where their bearings ask for room."""
    return {"rim_ratio": _now(design, stage, "rim_ratio")} if stage in design.planetaries else {}


def _now(design: Design, stage: str, key: str) -> float:
    """Return a thickness as its rules have it; of rims alone they may say nothing."""
    own: float | None = getattr(design.rules(stage), key)
    return BACKUP if own is None else own


def _has_web(design: Design, stage: str) -> bool:
    return stage in design.pairs and not design.pairs[stage].internal


def _solid_share(design: Design, stage: str) -> Mapping[str, Value]:
    """Return that no share of the solid body is stated beside the web."""
    return {"web_ratio": 1.0} if design.rules(stage).web_ratio < 1.0 else {}


def least_web(sizing: Sizing, stage: str) -> float:
    """Return the thinnest web of a pair over its face width [-]: τ = 2 T/(π d² t) at the hub, or the range of C_R.

    Args:
        sizing: As sized.
        stage: The pair.

    Source: equilibrium of a disc in shear (Tresca), at the largest torque of all cases.
    """
    design, blanks = sizing.design, gear_blanks(sizing)
    strength = design.gear_material(stage).yield_strength or design.shaft_material.yield_strength
    least = THINNEST_WEB
    for gear in (gear for gear in sizing.gears if gear.stage == stage):
        rows = [(mesh.name, mesh.gears.index(gear.name)) for mesh in sizing.train.meshes if gear.name in mesh.gears]
        torque = max(sum(abs(flow.meshes[row].torques[side]) for row, side in rows) for flow in sizing.flows.values())
        shear = (strength or math.inf) / design.shafting.safety / 2.0
        hub = 2.0 * blanks[gear.name].hub_radius
        least = max(least, 2.0 * torque / (math.pi * hub**2 * shear) / gear.face_width)
    return least


BODIES: Mapping[str, tuple[Body, ...]] = MappingProxyType({
    "rims": (
        Body("rim_ratio", (-0.6, -0.2, -0.05, 0.05, 0.2), BACKUP, lambda *_: 0.55,
             "what Y_B rates (ISO 6336-3, clause 9)", _has_rim),
        Body("rim_thickness_ratio", (-0.9, -0.3, -0.1, 0.1, 0.3), 3.5 + ISO53_A.dedendum,
             lambda *_: LEAST_RING + ISO53_A.dedendum + 0.05, "what Y_B rates (ISO 6336-3, clause 9)",
             _has_ring, _rim_of_planets),
    ),
    "webs": (
        Body("web_thickness_ratio", (-0.1, -0.02, 0.02, 0.1), 1.0, least_web,
             "what C_R knows (ISO 6336-1, clause 9), or its shear at the hub", _has_web, _solid_share),
    ),
})  # fmt: skip
"""Name of a freedom -> the thicknesses that it is about."""


class Thickness(NamedTuple):
    """One thickness of one stage, as it is."""

    body: Body
    table: str
    """Of its rules in the design file."""
    now: float
    least: float
    beside: Mapping[str, Value]

    def at(self, value: float) -> dict[str, Value]:
        """Return what makes it thicker or thinner: path -> value.

        Args:
            value: Over tooth height, module or face width [-].
        """
        return {f"{self.table}.{key}": own for key, own in {self.body.key: round(value, 4), **self.beside}.items()}

    @property
    def path(self) -> str:
        """Of it in the design file."""
        return f"{self.table}.{self.body.key}"

    @property
    def others(self) -> list[float]:
        """Those beside it, within its limits [-]."""
        near = (min(max(self.now + step, self.least), self.body.most) for step in self.body.steps)
        return [value for value in dict.fromkeys(near) if abs(value - self.now) > 1e-6]


def thicknesses(design: Design, sizing: Sizing, freedom: str) -> Iterator[Thickness]:
    """Yield the thicknesses of every stage that a freedom is about.

    Args:
        design: With its rules.
        sizing: As sized.
        freedom: Of `BODIES`.
    """
    for body in BODIES[freedom]:
        for stage in design.simple_stages:
            if _cylindrical(design, stage) and body.has(design, stage):
                now, least = _now(design, stage, body.key), body.least(sizing, stage)
                yield Thickness(body, f"{design.table(stage)}.gears", now, least, body.beside(design, stage))
