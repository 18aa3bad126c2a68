"""Bending of stepped shafts: deflection, slope, first critical speed, and face load factor K_Hβ."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.base import Check, Floats, not_assessed
from gearwright.parts import Material
from gearwright.parts.iso6336 import Misalignment, face_load_factor, mesh_springs
from gearwright.parts.shafts import BentLine, Sections, bent_line, between, critical_speed, influence, lumped_shaft
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.rating import Context, cylindrical_mesh, method_for
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso6336_inputs import quality_of, steels_of
from gearwright.sizing.result import GearSizing, MeshSizing
from gearwright.sizing.shaft_results import BuiltShaft
from gearwright.sizing.shafts.stretches import Stretch
from gearwright.spec.design import BearingSeat
from gearwright.train import INTERNAL

# ----------------------------------------------------------------------------------------------------------------------
# How a built shaft bends: slopes at bearings and gears, deflection, first critical speed.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# K_Hβ by the bending lines of the shafts that carry a mesh, once they are built (ISO 6336-1, clause 7, method B).
# ----------------------------------------------------------------------------------------------------------------------


_CLAUSE = "ISO 6336-1, clause 7, by the bending lines"
_OPEN = 'its shafts are not built; give their [bearings], or take face_method = "C"'


def face_load_checks(
    context: Context, gears: Sequence[GearSizing], meshes: Sequence[MeshSizing], built: Sequence[BuiltShaft]
) -> Iterator[Check]:
    """Yield, where a design asks for method B, K_Hβ by the shafts' bending lines against what the safeties leave.

    Args:
        context: What sizing reads.
        gears: As sized.
        meshes: As sized.
        built: Shafts with bearings.

    Source: ISO 6336-1:2006, clause 7.5: f_sh of method C for the pinion's own bend and twist, and b (θ_1 + θ_2) of the
        shafts under both gears, the largest slopes of all cases as if they opened the mesh together.
    """
    slopes = {place: slope for shaft in built for place, slope in shaft.slopes}
    known = {gear.name: gear for gear in gears}
    for mesh in meshes:
        rating = context.ratings[mesh.stage]
        if not isinstance(mesh.rating, Iso6336Rating) or rating.rules.iso6336.face_method != "B":
            continue
        if all(name in slopes for name in mesh.gears):
            factor = face_factor_by_lines(context, mesh, known, slopes)
            limit = float(mesh.rating.factors.face.contact) * method_for(rating).reserve(mesh.rating)
            yield Check(
                mesh.part, "face load", _CLAUSE, factor, limit, at_most=True, exponent=None, symbol="K_Hβ",
                case=mesh.rating.case,
            )  # fmt: skip
        else:
            yield not_assessed(mesh.part, "face load", _CLAUSE, _OPEN)


def face_factor_by_lines(
    context: Context, mesh: MeshSizing, gears: Mapping[str, GearSizing], slopes: Mapping[str, float]
) -> float:
    """Return K_Hβ with the slopes of the shafts under both gears [-].

    Args:
        context: What sizing reads.
        mesh: Rated by ISO 6336.
        gears: Name -> gear.
        slopes: Gear -> slope of its shaft there [rad].

    Source: ISO 6336-1:2006, clauses 7.5 and 7.6.
    """
    rating, rated = context.ratings[mesh.stage], mesh.rating
    assert isinstance(rated, Iso6336Rating)
    first, second = (gears[name] for name in mesh.gears)
    internal = any(row.name == mesh.name and row.sign == INTERNAL for row in context.train.meshes)
    pair = cylindrical_mesh((first.teeth, second.teeth), first.module, first.face_width, rating, internal=internal)
    loads = rated.factors.loads
    specific = float(rated.factors.tangential_force) / first.face_width * float(loads.application * loads.mesh_load)
    tilt = first.face_width * sum(slopes[name] for name in mesh.gears)
    steels = steels_of(rating, (first.role, second.role))
    found = face_load_factor(
        pair,
        Misalignment(rated.factors.face.deflection + tilt, rated.factors.face.manufacture),
        steels,
        stiffness=mesh_springs(pair, specific, steels=steels).face,
        specific_load=specific * loads.dynamic,
        speed=rated.factors.speed,
        modification=quality_of(rating, idlers=(False, False)).helix,
    )
    return float(found.contact)
