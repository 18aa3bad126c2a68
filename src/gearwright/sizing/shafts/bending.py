"""How a built shaft bends: slopes at bearings and gears, deflection, first critical speed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts import Material
from gearwright.parts.shafts import BentLine, Sections, bent_line, between, critical_speed, influence, lumped_shaft
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.shafts.stretches import Stretch
from gearwright.spec.design import BearingSeat

GEAR_SLOPE = 0.5e-3
"""Largest slope of a shaft under a gear that is not crowned [rad] (Shigley, table 7-2)."""
BEARING_SLOPES = {"deep-groove": 3e-3, "cylindrical": 1.2e-3, "taper": 1.2e-3}
"""Kind of bearing -> largest slope of the shaft in it [rad] (Shigley, table 7-2, upper values)."""


@dataclass(frozen=True)
class Bent:
    """A built shaft, bent by all load cases."""

    sections: Sections
    line: BentLine | None
    """None where only torque acts."""
    bearings: tuple[float, float]
    """Middles of the radial bearings [m]."""
    material: Material

    def slope(self, place: float) -> float:
        """Return the largest slope of all cases [rad].

        Args:
            place: From the shaft's first end [m].
        """
        return 0.0 if self.line is None else self._largest(self.line.slope, place)

    def deflection(self, place: float) -> float:
        """Return the largest deflection of all cases [m].

        Args:
            place: From the shaft's first end [m].
        """
        return 0.0 if self.line is None else self._largest(self.line.deflection, place)

    def _largest(self, values: Floats, place: float) -> float:
        assert self.line is not None
        planes = between(self.line.position, values, np.array([place]))[..., 0].tolist()
        return max(math.hypot(*case) for case in planes)

    def critical_speed(self, places: Mapping[str, float], masses: Mapping[str, float]) -> float | None:
        """Return the first critical speed in bending of the shaft with its gears, in rigid bearings [rad/s].

        Args:
            places: Gear -> middle [m].
            masses: Gear -> mass [kg].
        """
        if self.line is None:
            return None
        middles, pieces = lumped_shaft(self.sections, self.material.density)
        where = np.append(middles, [places[name] for name in masses])
        weights = np.append(pieces, [masses[name] for name in masses])
        order = np.argsort(where, kind="stable")
        shape = influence(self.sections, self.bearings, where[order], elastic_modulus=self.material.elastic_modulus)
        return critical_speed(shape, weights[order])


def bend(forces: ShaftForces, stretches: Sequence[Stretch], material: Material, *, bore: float) -> Bent:
    """Return a shaft bent by what acts on it.

    Args:
        forces: In every load case.
        stretches: From end to end.
        material: Steel.
        bore: Of the shaft [m].
    """
    edges = np.array([stretches[0].start, *(stretch.end for stretch in stretches)])
    diameters = np.array([stretch.diameter for stretch in stretches])
    sections = Sections(edges, diameters, np.full(len(diameters), bore))
    line = None
    if forces.bends:
        line = bent_line(forces.drawn, sections, forces.plan.bearings, elastic_modulus=material.elastic_modulus)
    return Bent(sections, line, forces.plan.bearings, material)


def slope_excess(bent: Bent, seats: Mapping[str, BearingSeat], gears: Mapping[str, float]) -> float:
    """Return the largest slope over what is allowed there [-]; up to 1 the shaft is stiff enough.

    Args:
        bent: The shaft.
        seats: Its bearings.
        gears: Gear -> middle [m].
    """
    ratios = [bent.slope(place) / GEAR_SLOPE for place in gears.values()]
    ratios += [
        bent.slope(seat.position) / BEARING_SLOPES[seat.kind] for seat in seats.values() if seat.kind in BEARING_SLOPES
    ]
    return max(ratios, default=0.0)
