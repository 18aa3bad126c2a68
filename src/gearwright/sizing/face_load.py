"""K_Hβ by the bending lines of the shafts that carry a mesh, once they are built (ISO 6336-1, clause 7, method B)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from gearwright.checks import Check, not_assessed
from gearwright.parts.iso6336 import Misalignment, face_load_factor, mesh_springs
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.mounted import BuiltShaft
from gearwright.sizing.rating import Context, cylindrical_mesh, method_for
from gearwright.sizing.rating.iso6336 import Iso6336Rating, quality_of, steels_of
from gearwright.sizing.result import GearSizing
from gearwright.train import INTERNAL

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
