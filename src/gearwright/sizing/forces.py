"""All that acts on one shaft in every load case, held in balance by its two radial bearings.

To the meshes and machines of `loads` come the rotors: a propeller's thrust along the shaft, its force across and the
moment at its hub. These two turn with the flow and not with the shaft, so that they bend a turning shaft as a mesh
does. Where they point is not known; they are taken to point where they bend the shaft most, the moment in the sense
in which the force bends it. They act in every load case.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.parts.beam import Diagram, PointLoads, diagram, supported
from gearwright.sizing.context import Context
from gearwright.sizing.layout import ShaftPlan
from gearwright.sizing.loads import shaft_loads
from gearwright.sizing.result import BearingLoad, GearSizing, ShaftDiagram
from gearwright.spec import Propeller

Array = NDArray[np.float64]
_ROUNDING = 1e-6
"""Moment over the largest one below which it is rounding [-]."""
_BESIDE = 1e-9
"""How far left and right of a section its moments are read [m]; they jump where a couple acts."""


class ShaftForces(NamedTuple):
    """What acts on one shaft, reactions included, and what that makes inside it."""

    plan: ShaftPlan
    whole: PointLoads
    """Loads in balance; where anything bends the shaft, the two last ones are the reactions of its bearings."""
    drawn: Diagram
    axial: Array
    """Force along the shaft that its bearings take, positive towards its second end [N], (cases,)."""
    bends: bool

    def radial(self) -> Array:
        """Return the forces of both radial bearings [N], (cases, 2 planes, 2); zero where nothing bends."""
        return self.whole.force[..., -2:] if self.bends else np.zeros((len(self.axial), 2, 2))

    def moments(self, positions: Array) -> tuple[Array, Array]:
        """Return bending moment and torque at sections, the larger of both sides [N m], each (cases, n).

        Args:
            positions: From the shaft's first end [m], (n,).
        """
        left, right = (_at(self.drawn, positions + beside) for beside in (-_BESIDE, _BESIDE))
        return _cleaned(np.maximum(left[0], right[0])), _cleaned(np.maximum(left[1], right[1]))

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


def _cleaned(values: Array) -> Array:
    """Return values without what the width of `_BESIDE` and rounding leave at free ends."""
    return np.where(values > _ROUNDING * values.max(initial=0.0), values, 0.0)


def _at(drawn: Diagram, positions: Array) -> tuple[Array, Array]:
    """Return bending moment of both planes together, and torque, at places between the stations."""
    right = np.clip(np.searchsorted(drawn.position, positions), 1, len(drawn.position) - 1)
    left, inside = right - 1, (positions >= drawn.position[0]) & (positions <= drawn.position[-1])
    steps = drawn.position[right] - drawn.position[left]
    weight = np.divide(positions - drawn.position[left], steps, out=np.zeros_like(positions), where=steps > 0.0)
    bending = drawn.bending[..., left] * (1.0 - weight) + drawn.bending[..., right] * weight
    return np.hypot(bending[:, 0], bending[:, 1]) * inside, np.abs(drawn.torsion[:, left]) * inside


def shaft_forces(
    given: Context, name: str, plan: ShaftPlan, *, axes: Mapping[str, complex], gears: Mapping[str, GearSizing]
) -> ShaftForces:
    """Return what acts on a shaft in every load case.

    Args:
        given: What sizing reads.
        name: Of the shaft.
        plan: Where things sit along it.
        axes: Where all axes stand, y + i z [m].
        gears: By name.

    Raises:
        DesignError: If a load stands outside the shaft.
    """
    loads, axial = shaft_loads(given, name, plan, axes=axes, gears=gears)
    for each, rotor in given.design.propellers.items():
        if rotor.shaft == name:
            side = rotor_side(plan, each)
            axial = axial + side * rotor.thrust
            if rotor.in_plane_force or rotor.hub_moment:
                loads = _with_rotor(loads, plan, rotor, position=plan.places[each])
    bends = bool(loads.force.any() or loads.couple.any())
    whole = supported(loads, plan.bearings, length=plan.length) if bends else loads
    return ShaftForces(plan, whole, diagram(whole), axial, bends)


def rotor_side(plan: ShaftPlan, rotor: str) -> float:
    """Return the end of the shaft, as a sign, that a rotor looks at: away from all else on the shaft.

    Args:
        plan: Where things sit along the shaft.
        rotor: Name of the propeller.
    """
    others = [*plan.bearings, *(place for each, place in plan.places.items() if each != rotor)]
    return 1.0 if plan.places[rotor] >= sum(others) / len(others) else -1.0


def _with_rotor(loads: PointLoads, plan: ShaftPlan, rotor: Propeller, *, position: float) -> PointLoads:
    """Return loads with a rotor's force and moment among them, in the direction that bends the shaft most."""
    side = 1.0 if position >= sum(plan.bearings) / 2.0 else -1.0
    without = _padded(loads, position)
    alone = PointLoads(*(np.zeros_like(each) for each in without))._replace(position=without.position)
    alone.force[:, 0, -1], alone.couple[:, 0, -1] = rotor.in_plane_force, side * rotor.hub_moment
    own, others = (
        diagram(supported(each, plan.bearings, length=plan.length)).bending.swapaxes(0, 1) for each in (alone, without)
    )
    meshes = others[0] + 1j * others[1]
    worst = np.argmax(np.abs(meshes) + np.abs(own[0]), axis=-1)
    cases = np.arange(len(worst))
    turn = np.exp(1j * np.angle(meshes[cases, worst] * np.sign(own[0][cases, worst])))
    direction = np.stack([turn.real, turn.imag], axis=-1)
    without.force[..., -1] = rotor.in_plane_force * direction
    without.couple[..., -1] = side * rotor.hub_moment * direction
    return without


def _padded(loads: PointLoads, position: float) -> PointLoads:
    """Return loads with one more, of nothing, at a place."""
    wider = [np.concatenate([each, np.zeros((*each.shape[:-1], 1))], axis=-1) for each in loads[1:]]
    return PointLoads(np.append(loads.position, position), *wider)
