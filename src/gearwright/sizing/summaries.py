"""Summaries of sized stages and gear pairs: ratio and mass, tooth data, load factors, tips in fillets."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, NamedTuple

from gearwright.base import Origin, Quantity, Role, gear_part
from gearwright.parts.bevel_geometry import BevelBlank, bevel_blank, least_cutter_radius
from gearwright.parts.gears import form_radius, span_measurement, spanned_teeth
from gearwright.parts.iso6336 import DynamicFactorBySpeed, MeshGeometry
from gearwright.sizing.gear_geometry import cylindrical_gear
from gearwright.sizing.mass import tooth_of
from gearwright.sizing.rating import METHODS, Factor, bevel_pair, cylindrical_mesh, factor_rows, load_sharing, rating_of
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.result import GearSizing, MeshSizing, Sizing
from gearwright.spec import Design, Epicyclic, Planetary
from gearwright.train import INTERNAL

# ----------------------------------------------------------------------------------------------------------------------
# Stage by stage: kind, ratio, meshes that share the torque, size and mass, to hold designs beside each other.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class StageSummary:
    """One stage of one design."""

    design: str
    stage: str
    kind: str
    """planetary, star, differential, pair or parallel pairs."""
    ratio: Annotated[float, Quantity("ratio"), Origin("z_2/z_1 or 1 + z_r/z_s", "teeth")]
    """[-]"""
    meshes: int
    """Meshes that share the torque of its first gear."""
    torque: Annotated[float, Quantity("torque"), Origin("T K_γ / N at its worst case", "power flow")]
    """On pinion or sun, of one mesh [N m]."""
    module: Annotated[float, Quantity("length"), Origin("m_n ≥ max(bending, contact)", "rating of its meshes")]
    """[m]"""
    face_width: Annotated[
        float, Quantity("length"), Origin("b = λ m_n, or the least that serves", "rating of its meshes")
    ]
    """[m]"""
    mass: Annotated[float, Quantity("mass"), Origin("its gears", "geometry")]
    """[kg]"""


def stage_summaries(sizing: Sizing, design: str) -> Iterator[StageSummary]:
    """Yield what every stage of a design does and weighs.

    Args:
        sizing: As sized.
        design: What the design is called beside others.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    for stage in sizing.design.stages:
        rows = [mesh for mesh in sizing.meshes if mesh.stage == stage]
        first = gears[rows[0].gears[0]]
        planetary = stage in sizing.design.sets
        yield StageSummary(
            design=design,
            stage=stage,
            kind=_kind(sizing, stage, len(rows)),
            ratio=_ratio(sizing, stage),
            meshes=rows[0].count * (1 if planetary else len(rows)),
            torque=max(row.tangential_force * row.working_diameter / 2.0 for row in rows if row.gears[0] == first.name),
            module=first.module,
            face_width=first.face_width,
            mass=sum(gear.mass * gear.bodies for gear in sizing.gears if gear.stage == stage),
        )


def _kind(sizing: Sizing, stage: str, rows: int) -> str:
    record = sizing.design.stages[stage]
    if isinstance(record, Epicyclic):
        return "compound set"
    if isinstance(record, Planetary):
        if "ground" not in (record.sun, record.ring, record.carrier):
            return "differential"
        return "star" if record.carrier == "ground" else "planetary"
    return "parallel pairs" if rows > 1 else "pair"


def _ratio(sizing: Sizing, stage: str) -> float:
    record, teeth = sizing.design.stages[stage], sizing.teeth
    if isinstance(record, Epicyclic):
        return _fastest_over_slowest(sizing, record)
    if isinstance(record, Planetary):
        sun, ring = (teeth[str(gear_part(stage, role))] for role in (Role.SUN, Role.RING))
        ratio = ring / sun
        return ratio if record.carrier == "ground" else 1.0 + ratio
    mesh = next(mesh for mesh in sizing.train.meshes if mesh.stage == stage)
    return teeth[mesh.gears[1]] / teeth[mesh.gears[0]]


def _fastest_over_slowest(sizing: Sizing, epicyclic: Epicyclic) -> float:
    """Return the largest speed of a compound set's members over the smallest but zero, in the first case [-]."""
    flow = next(iter(sizing.flows.values()))
    speeds = [abs(flow.speeds[shaft]) for shaft in epicyclic.members if flow.speeds[shaft]]
    return max(speeds, default=0.0) / min(speeds, default=1.0)


# ----------------------------------------------------------------------------------------------------------------------
# The geometry of a rated pair as a tooth-data table states it: cylindrical gears, and bevel gears by their cones.
# ----------------------------------------------------------------------------------------------------------------------


_ISO = "ISO 21771:2007"
_BEVEL = "ISO 23509:2016"
Both = tuple[float, float]


@dataclass(frozen=True)
class CylindricalPairData:
    """A cylindrical pair."""

    teeth: Annotated[tuple[int, int], Quantity("number"), Origin("z", "chosen or given")]
    """z_1, z_2 [-]."""
    module: Annotated[float, Quantity("length"), Origin("m_n", "ISO 54 where rounded")]
    """m_n [m]."""
    pressure_angle: Annotated[float, Quantity("angle"), Origin("α_n", "ISO 53")]
    """α_n [rad]."""
    helix_angle: Annotated[float, Quantity("angle"), Origin("β", "design")]
    """β [rad]."""
    profile_shift: Annotated[Both, Quantity("ratio"), Origin("x", "design")]
    """x_1, x_2 [-]."""
    face_width: Annotated[float, Quantity("length"), Origin("b", "common face width")]
    """b [m]."""
    centre_distance: Annotated[float, Quantity("length"), Origin("a_w = a cos α_t/cos α_wt", _ISO)]
    """Working centre distance a_w [m]."""
    pitch_diameter: Annotated[Both, Quantity("length"), Origin("d = z m_n/cos β", _ISO)]
    """d [m]."""
    base_diameter: Annotated[Both, Quantity("length"), Origin("d_b = d cos α_t", _ISO)]
    """d_b [m]."""
    tip_diameter: Annotated[Both, Quantity("length"), Origin("d_a = d ± 2 (1 + x + k) m_n", _ISO)]
    """d_a [m]."""
    root_diameter: Annotated[Both, Quantity("length"), Origin("d_f = d ∓ 2 (1.25 − x) m_n", _ISO)]
    """d_f [m]."""
    spanned_teeth: Annotated[tuple[int, int] | None, Quantity("number"), Origin("k", _ISO)]
    """Teeth between the anvils [-]; None with a ring."""
    span: Annotated[
        Both | None, Quantity("length"), Origin("W_k = m_n cos α_n ((k − ½) π + z inv α_t + 2 x tan α_n)", _ISO)
    ]
    """Span without backlash allowance [m]; None with a ring."""
    transverse_contact_ratio: Annotated[float, Quantity("ratio"), Origin("ε_α", _ISO)]
    """ε_α [-]."""
    overlap_ratio: Annotated[float, Quantity("ratio"), Origin("ε_β = b sin β/(π m_n)", _ISO)]
    """ε_β [-]."""


@dataclass(frozen=True)
class BevelPairData:
    """A bevel pair."""

    teeth: Annotated[tuple[int, int], Quantity("number"), Origin("z", "chosen or given")]
    """z_1, z_2 [-]."""
    outer_module: Annotated[float, Quantity("length"), Origin("m_et", "ISO 678 where rounded")]
    """Outer transverse module [m]."""
    mean_module: Annotated[float, Quantity("length"), Origin("m_mn = m_et cos β_m R_m/R_e", _BEVEL)]
    """Mean normal module [m]."""
    pressure_angle: Annotated[float, Quantity("angle"), Origin("α_n", "design")]
    """α_n [rad]."""
    spiral_angle: Annotated[float, Quantity("angle"), Origin("β_m", "design")]
    """β_m [rad]."""
    shaft_angle: Annotated[float, Quantity("angle"), Origin("Σ", "design")]
    """Σ [rad]."""
    pitch_angle: Annotated[Both, Quantity("angle"), Origin("tan δ_1 = z_1/z_2", _BEVEL)]
    """δ_1, δ_2 [rad]."""
    face_width: Annotated[float, Quantity("length"), Origin("b ≤ R_e/3, 10 m_et", _BEVEL)]
    """b [m]."""
    cone_distance: Annotated[float, Quantity("length"), Origin("R_e = d_e1/(2 sin δ_1)", _BEVEL)]
    """R_e [m]."""
    mean_cone_distance: Annotated[float, Quantity("length"), Origin("R_m = R_e − b/2", _BEVEL)]
    """R_m [m]."""
    outer_diameter: Annotated[Both, Quantity("length"), Origin("d_e = z m_et", _BEVEL)]
    """Outer pitch diameters [m]."""
    mean_diameter: Annotated[Both, Quantity("length"), Origin("d_m = d_e R_m/R_e", _BEVEL)]
    """Mean pitch diameters [m]."""
    addendum: Annotated[Both, Quantity("length"), Origin("h_am", _BEVEL)]
    """Mean addenda [m]."""
    dedendum: Annotated[Both, Quantity("length"), Origin("h_fm", _BEVEL)]
    """Mean dedenda [m]."""
    blank: BevelBlank | None
    """Cones, outer depths and diameters; None where the cutter is too small for them."""


def pair_data(sizing: Sizing, mesh: MeshSizing) -> CylindricalPairData | BevelPairData:
    """Return the geometry of a pair or of one mesh of a planetary set.

    Args:
        sizing: As sized.
        mesh: One of its meshes, rated by ISO 6336 or ISO 10300.
    """
    by_name = {gear.name: gear for gear in sizing.gears}
    pinion, wheel = (by_name[name] for name in mesh.gears)
    row = next(row for row in sizing.train.meshes if row.name == mesh.name)
    rating = rating_of(sizing.design, pinion.stage, sizing.teeth).of_mesh(row)
    if rating.kind == "bevel":
        return _bevel(sizing, pinion, wheel)
    internal = row.sign == INTERNAL
    width = min(pinion.face_width, wheel.face_width)
    geometry = cylindrical_mesh((pinion.teeth, wheel.teeth), pinion.module, width, rating,
                                internal=internal)  # fmt: skip
    return _cylindrical(sizing.design, geometry, pinion, wheel)


def _cylindrical(design: Design, mesh: MeshGeometry, pinion: GearSizing, wheel: GearSizing) -> CylindricalPairData:
    external = bool(mesh.side > 0)
    shifts = tuple(float(tooth.profile_shift) for tooth in mesh.proportions)
    gears = [cylindrical_gear(design, gear) for gear in (pinion, wheel)]
    spanned = tuple(spanned_teeth(gear) for gear in gears)
    spans = tuple(span_measurement(gear, count) for gear, count in zip(gears, spanned, strict=True))
    tips = [2.0 * float(radius) for radius in mesh.tip_radii]
    roots = [tip - sign * 2.0 * float(height) for tip, height, sign in
             zip(tips, mesh.tooth_heights, (1.0, 1.0 if external else -1.0), strict=True)]  # fmt: skip
    return CylindricalPairData(
        teeth=(pinion.teeth, wheel.teeth),
        module=pinion.module,
        pressure_angle=float(mesh.pressure_angle),
        helix_angle=pinion.helix_angle,
        profile_shift=(shifts[0], shifts[1]),
        face_width=float(mesh.face_width),
        centre_distance=float(mesh.centre_distance),
        pitch_diameter=_both(mesh.pitch_diameters),
        base_diameter=_both(mesh.base_diameters),
        tip_diameter=(tips[0], tips[1]),
        root_diameter=(roots[0], roots[1]),
        spanned_teeth=(spanned[0], spanned[1]) if external else None,
        span=(spans[0], spans[1]) if external else None,
        transverse_contact_ratio=float(mesh.transverse_contact_ratio),
        overlap_ratio=float(mesh.overlap_ratio),
    )


def _both(values: tuple[object, object]) -> Both:
    return float(values[0]), float(values[1])  # type: ignore[arg-type]


def _bevel(sizing: Sizing, pinion: GearSizing, wheel: GearSizing) -> BevelPairData:
    rating = rating_of(sizing.design, pinion.stage, sizing.teeth)
    pair = bevel_pair((pinion.teeth, wheel.teeth), pinion.module, pinion.face_width, rating)
    cutter = rating.rules.cutter_radius
    cut = cutter is None or not pair.spiral_angle or cutter >= least_cutter_radius(pair)
    return BevelPairData(
        teeth=pair.teeth,
        outer_module=pair.outer_module,
        mean_module=pair.mean_module,
        pressure_angle=pair.pressure_angle,
        spiral_angle=pair.spiral_angle,
        shaft_angle=pair.shaft_angle,
        pitch_angle=pair.pitch_angles,
        face_width=pair.face_width,
        cone_distance=pair.outer_cone_distance,
        mean_cone_distance=pair.mean_cone_distance,
        outer_diameter=pair.outer_diameters,
        mean_diameter=pair.mean_diameters,
        addendum=pair.addenda,
        dedendum=pair.dedenda,
        blank=bevel_blank(pair, cutter) if cut else None,
    )


class RatedMesh(NamedTuple):
    """A mesh whose method has more than stresses and margins."""

    mesh: MeshSizing
    factors: tuple[Factor, ...]
    """Its geometry and its factors, in the heaviest case over the whole life."""


def rated_factors(sizing: Sizing) -> tuple[RatedMesh, ...]:
    """Return every mesh whose method has more than stresses and margins, with its geometry and its factors.

    Args:
        sizing: As sized.
    """
    rated = [(mesh, _factors(mesh)) for mesh in sizing.meshes]
    return tuple(
        RatedMesh(mesh, (*factor_rows(pair_data(sizing, mesh), "geometry"), *factors))
        for mesh, factors in rated
        if factors
    )


def _factors(mesh: MeshSizing) -> tuple[Factor, ...]:
    return (*METHODS[mesh.rating.method].factors(mesh.rating),) if mesh.rating.method else ()


# ----------------------------------------------------------------------------------------------------------------------
# What every mesh rated by ISO 6336 bears beyond its nominal load, with what its teeth are made to.
# ----------------------------------------------------------------------------------------------------------------------


_PART1 = "ISO 6336-1:2019"


@dataclass(frozen=True)
class MeshFactors:
    """One mesh."""

    name: str
    load_factor: Annotated[float, Quantity("ratio"), Origin("K_γ", f"{_PART1}, clause 4")]
    """[-]"""
    shared: str
    """By what K_γ is had."""
    case: str
    """Case in which the mesh runs nearest to its main resonance."""
    resonance_ratio: Annotated[float | None, Quantity("ratio"), Origin("N = n_1/n_E1", f"{_PART1}, 6.5.3")]
    """In that case [-]; None by method C."""
    dynamic_factor: Annotated[float, Quantity("ratio"), Origin("K_V", f"{_PART1}, 6.5")]
    """In the heaviest case [-]."""
    relief_term: Annotated[float | None, Quantity("ratio"), Origin("B_k", f"{_PART1}, 6.5.5")]
    """In the heaviest case [-]; None by method C."""
    tip_relief: Annotated[float, Quantity("film_thickness"), Origin("C_a", f"{_PART1}, 6.5.5")]
    """[m]"""
    tolerance_class: int
    """Of ISO 1328-1 [-]."""


def mesh_factors(sizing: Sizing) -> Iterator[MeshFactors]:
    """Yield every mesh that ISO 6336 rates.

    Args:
        sizing: As sized.
    """
    for mesh in sizing.meshes:
        rated = mesh.rating
        if not isinstance(rated, Iso6336Rating):
            continue
        factors, nearest = rated.factors, rated.nearest
        dynamic = factors.dynamic
        term = None if isinstance(dynamic, DynamicFactorBySpeed) else float(dynamic.relief_term)
        yield MeshFactors(
            mesh.name, mesh.load_factor, load_sharing(sizing.design, mesh.stage).words,
            rated.case if nearest is None else nearest.case, None if nearest is None else nearest.ratio,
            float(factors.loads.dynamic), term, rated.made.relief, int(rated.made.grade),
        )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Rings whose tips reach below the involutes of their mates, into the fillets that a rack leaves there.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDED = 1e-6
"""How far tips may reach below an involute by rounding [m]."""
SHADE = 1e-4
"""What is added to a tip alteration so that it suffices when written with four decimals [-]."""


class InFillet(NamedTuple):
    """Tips of a ring in the fillets of a mate."""

    mesh: MeshSizing
    below: float
    """How far below the beginning of the mate's involute they touch [m]."""
    path: str
    """Of the ring's tip alteration in the design."""
    tip_alteration: float
    """k of the ring with which they end where the involute begins [-]."""

    @property
    def sentence(self) -> str:
        """What is wrong, and what mends it."""
        mate, ring = self.mesh.gears
        return (
            f"tips of {ring} reach {1e6 * self.below:.3g} µm below the involutes of {mate}, into fillets that a rack "
            f"leaves: {self.path} = {self.tip_alteration:.4f} keeps them out"
        )


def tips_in_fillets(sizing: Sizing) -> tuple[InFillet, ...]:
    """Return the rings whose tips reach below the involutes of their mates.

    Args:
        sizing: As sized.

    Source: radius at which a ring's tip touches, r_1² = r_b1² + (√(r_a2² − r_b2²) − a_w sin α_wt)² (ISO 21771:2007),
        and the same solved for r_a2.
    """
    gears, found = {gear.name: gear for gear in sizing.gears}, list[InFillet]()
    for row in sizing.meshes:
        if row.gears[1] not in sizing.train.internal:
            continue
        mate, ring = (tooth_of(sizing, gears[name]) for name in row.gears)
        line = row.centre_distance * math.sin(row.working_pressure_angle)
        touched = math.sqrt(max(ring.tip_radius**2 - ring.base_radius**2, 0.0)) - line
        form = form_radius(mate)
        below = form - math.hypot(mate.base_radius, max(touched, 0.0))
        if below > ROUNDED:
            tip = math.hypot(ring.base_radius, line + math.sqrt(max(form**2 - mate.base_radius**2, 0.0)))
            own = gears[row.gears[1]]
            shortened = own.tip_alteration - (tip - ring.tip_radius) / own.module - SHADE
            found.append(InFillet(row, below, _path(sizing.design, own), shortened))
    return tuple(found)


def _path(design: Design, ring: GearSizing) -> str:
    """Return where a design has the tip alteration of a ring."""
    own = f"rings.{ring.own}.tip_alteration" if ring.own else f"{ring.role}_tip_alteration"
    return f"{design.table(ring.stage)}.{own}"
