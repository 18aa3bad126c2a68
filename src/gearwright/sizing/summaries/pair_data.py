"""The geometry of a rated pair as a tooth-data table states it: cylindrical gears, and bevel gears by their cones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.parts.bevel import BevelBlank, bevel_blank, least_cutter_radius
from gearwright.parts.gears import span_measurement, spanned_teeth
from gearwright.parts.iso6336 import MeshGeometry
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.rating import bevel_pair, cylindrical_mesh, rating_of
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.sizing.tooth_shape import cylindrical_gear
from gearwright.spec import Design
from gearwright.train import INTERNAL
from gearwright.units import Origin, Quantity

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
