"""All that acts on one shaft in every load case, held in balance by its two radial bearings.

To the meshes and machines of `loads` come the rotors: a propeller's thrust along the shaft, its force across and the
moment at its hub. These two turn with the flow and not with the shaft, so that they bend a turning shaft as a mesh
does. Where they point is not known, the moment but in the sense in which the force bends: every bearing and every
section is judged with them where they load it most, and diagrams and deflections show them where they bend the shaft
most. They act in every load case.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts.shafts import Diagram, PointLoads, diagram, supported
from gearwright.sizing.arranged import ShaftPlan
from gearwright.sizing.carrying import BearingLoad, ShaftDiagram
from gearwright.sizing.loads.shaft_loads import shaft_loads
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.spec import Airscrew

_ROUNDING = 1e-6
"""Moment over the largest one below which it is rounding [-]."""
_BESIDE = 1e-9
"""How far left and right of a section its moments are read [m]; they jump where a couple acts."""


class Part(NamedTuple):
    """Some of what acts on one shaft, in balance by itself."""

    loads: PointLoads
    """The two last ones are the reactions of its bearings."""
    drawn: Diagram


class ShaftForces(NamedTuple):
    """What acts on one shaft, reactions included, and what that makes inside it."""

    plan: ShaftPlan
    whole: PointLoads
    """Loads in balance; where anything bends the shaft, the two last ones are the reactions of its bearings."""
    drawn: Diagram
    axial: Floats
    """Force along the shaft that its bearings take, positive towards its second end [N], (cases,)."""
    bends: bool
    apart: tuple[Part, ...] = ()
    """Where rotors bend the shaft: the meshes alone, and each rotor alone, which may point anywhere."""

    def radial(self) -> Floats:
        """Return the forces of both radial bearings [N], (cases, 2 planes, 2); zero where nothing bends."""
        return self.whole.force[..., -2:] if self.bends else np.zeros((len(self.axial), 2, 2))

    def largest_radial(self) -> Floats:
        """Return what both radial bearings must bear [N], (cases, 2): rotors point where they load each one most."""
        parts = [part.loads.force[..., -2:] for part in self.apart] or [self.radial()]
        return np.asarray(np.sum([np.hypot(part[:, 0], part[:, 1]) for part in parts], axis=0))

    def moments(self, positions: Floats) -> tuple[Floats, Floats]:
        """Return bending moment and torque at sections, the larger of both sides [N m], each (cases, n).

        Args:
            positions: From the shaft's first end [m], (n,). Rotors point where they bend each one most.
        """
        parts = [part.drawn for part in self.apart] or [self.drawn]
        beside, count = np.concatenate([positions - _BESIDE, positions + _BESIDE]), len(positions)
        sides = [sum(both) for both in zip(*(_at(part, beside) for part in parts), strict=True)]
        bending, torque = (np.maximum(values[:, :count], values[:, count:]) for values in sides)
        return _cleaned(bending), _cleaned(torque)

    def bearing_loads(self, case: int) -> tuple[BearingLoad, ...]:
        """Return what both radial bearings give to the shaft in one case; none where only torque acts.

        Args:
            case: Its number [-].
        """
        pairs = self.radial()[case].T.tolist() if self.bends else []
        return tuple(BearingLoad(at, (y, z)) for at, (y, z) in zip(self.plan.bearings, pairs, strict=False))

    def diagram(self, case: int) -> ShaftDiagram:
        """Return shear, bending and torsion of one case.

        Args:
            case: Its number [-].
        """
        shear, bending = self.drawn.shear[case].tolist(), self.drawn.bending[case].tolist()
        return ShaftDiagram(
            position=tuple(self.drawn.position.tolist()),
            shear=(tuple(shear[0]), tuple(shear[1])),
            bending=(tuple(bending[0]), tuple(bending[1])),
            torsion=tuple(self.drawn.torsion[case].tolist()),
        )


def _cleaned(values: Floats) -> Floats:
    """Return values without what the width of `_BESIDE` and rounding leave at free ends."""
    return np.where(values > _ROUNDING * values.max(initial=0.0), values, 0.0)


def _at(drawn: Diagram, positions: Floats) -> tuple[Floats, Floats]:
    """Return bending moment of both planes together, and torque, at places between the stations."""
    places = drawn.position
    right = np.minimum(np.maximum(places.searchsorted(positions), 1), len(places) - 1)
    left, inside = right - 1, (positions >= places[0]) & (positions <= places[-1])
    start = places[left]
    steps = places[right] - start
    weight = (positions - start) / np.where(steps > 0.0, steps, np.inf)
    bending = drawn.bending.take(left, axis=-1) * (1.0 - weight) + drawn.bending.take(right, axis=-1) * weight
    return np.hypot(bending[:, 0], bending[:, 1]) * inside, np.abs(drawn.torsion.take(left, axis=-1)) * inside


def shaft_forces(
    context: Context, name: str, plan: ShaftPlan, *, axes: Mapping[str, complex], gears: Mapping[str, GearSizing]
) -> ShaftForces:
    """Return what acts on a shaft in every load case.

    Args:
        context: What sizing reads.
        name: Of the shaft.
        plan: Where things sit along it.
        axes: Where all axes stand, y + i z [m].
        gears: By name.

    Raises:
        DesignError: If a load stands outside the shaft.
    """
    meshes, axial = shaft_loads(context, name, plan, axes=axes, gears=gears)
    loads, apart = meshes, [meshes]
    for rotor_name, rotor in context.design.airscrews.items():
        if rotor.shaft == name:
            side = rotor_side(plan, rotor_name)
            axial = axial + side * rotor.thrust
            if rotor.in_plane_force or rotor.hub_moment:
                alone = _alone(loads, plan, rotor, position=plan.places[rotor_name])
                loads, apart = _joined(loads, alone, plan), [*apart, alone]
    bends = bool(loads.force.any() or loads.couple.any())
    balanced = supported(loads, plan.bearings, length=plan.length) if bends else loads
    parts = tuple(_part(part_loads, plan) for part_loads in apart) if len(apart) > 1 else ()
    return ShaftForces(plan, balanced, diagram(balanced), axial, bends, parts)


def _part(loads: PointLoads, plan: ShaftPlan) -> Part:
    held = supported(loads, plan.bearings, length=plan.length)
    return Part(held, diagram(held))


def rotor_side(plan: ShaftPlan, rotor: str) -> float:
    """Return the end of the shaft, as a sign, that a rotor looks at: away from all else on the shaft.

    Args:
        plan: Where things sit along the shaft.
        rotor: Name of the propeller.
    """
    others = [*plan.bearings, *(place for part, place in plan.places.items() if part != rotor)]
    return 1.0 if plan.places[rotor] >= sum(others) / len(others) else -1.0


def _alone(loads: PointLoads, plan: ShaftPlan, rotor: Airscrew, *, position: float) -> PointLoads:
    """Return a rotor's force and moment along y, beside other loads of nothing."""
    side = 1.0 if position >= sum(plan.bearings) / 2.0 else -1.0
    wider = _padded(loads, position)
    alone = PointLoads(wider.position, *(np.zeros_like(load) for load in wider[1:]))
    alone.force[:, 0, -1], alone.couple[:, 0, -1] = rotor.in_plane_force, side * rotor.hub_moment
    return alone


def _joined(loads: PointLoads, alone: PointLoads, plan: ShaftPlan) -> PointLoads:
    """Return loads with a rotor's among them, in the direction that bends the shaft most."""
    joined = _padded(loads, alone.position[-1])
    rotor_bending, others = (np.swapaxes(_part(loads, plan).drawn.bending, 0, 1) for loads in (alone, joined))
    direction = _worst_direction(rotor_bending[0], others)
    joined.force[..., -1] = alone.force[:, :1, -1] * direction
    joined.couple[..., -1] = alone.couple[:, :1, -1] * direction
    return joined


def _worst_direction(rotor: Floats, others: Floats) -> Floats:
    """Return in which direction a rotor bends a shaft most in every case, along y and z [-].

    Args:
        rotor: Its bending along y at sections [N m], (cases, n).
        others: Bending of all else [N m], (2, cases, n).
    """
    meshes = others[0] + 1j * others[1]
    worst = np.argmax(np.abs(meshes) + np.abs(rotor), axis=-1)
    cases = np.arange(len(worst))
    turn = np.exp(1j * np.angle(meshes[cases, worst] * np.sign(rotor[cases, worst])))
    return np.stack([turn.real, turn.imag], axis=-1)


def _padded(loads: PointLoads, position: float) -> PointLoads:
    """Return loads with one more, of nothing, at a place."""
    wider = [np.concatenate([load, np.zeros((*load.shape[:-1], 1))], axis=-1) for load in loads[1:]]
    return PointLoads(np.append(loads.position, position), *wider)
