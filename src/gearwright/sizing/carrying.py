"""What carries gears: shafts with the loads of their bearings and their diagrams, and carriers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from gearwright.identity import PartId, carrier_part
from gearwright.units import Force, Length, Origin, Quantity, Speed, Torque

_THESIS = "Pulvirenti 2023"


@dataclass(frozen=True)
class BearingLoad:
    """What one bearing gives to its shaft in the case that governs the shaft."""

    position: Length
    """Middle of the bearing, from the shaft's first end [m]."""
    force: tuple[Force, Force]
    """Along y and along z of the cross-section [N]."""

    @property
    def radial_force(self) -> Force:
        """Both planes together [N]."""
        return math.hypot(*self.force)


@dataclass(frozen=True)
class ShaftDiagram:
    """Shear, bending and torsion just left and just right of every load; straight lines lie between."""

    position: tuple[Length, ...]
    """From the shaft's first end, each one twice [m]."""
    shear: tuple[tuple[Force, ...], tuple[Force, ...]]
    """Along y and along z [N]."""
    bending: tuple[tuple[Torque, ...], tuple[Torque, ...]]
    """By the forces along y and by those along z [N m]."""
    torsion: tuple[Torque, ...]
    """[N m]"""


@dataclass(frozen=True)
class ShaftSizing:
    """One shaft."""

    name: str
    case: str
    """Load case that governs."""
    speed: Speed
    """In that case [rad/s]."""
    torque: Annotated[float, Quantity("torque"), Origin("T(x) = Σ T_k left of x", "equilibrium")]
    """Torque inside the shaft at the section that governs [N m]."""
    bending_moment: Annotated[
        float, Quantity("torque"), Origin("M = √(M_y² + M_z²)", f"{_THESIS}, eqs 2.43–2.46 corrected")
    ]
    """Bending moment of both planes at the section that governs [N m]."""
    axial_force: Annotated[float, Quantity("force"), Origin("Σ F_t tan β of single helices", "ISO 21771:2007")]
    """What the meshes leave for a thrust bearing, positive towards the shaft's second end [N]."""
    length: Length
    """[m]"""
    diameter: Annotated[float, Quantity("length"), Origin("√(σ_b² + 4 τ²) = R_p0.2 / S", f"{_THESIS}, eq. 2.47")]
    """Outer diameter; of a built shaft the thickest between its gears [m]."""
    bore: Length
    """Inner diameter [m]."""
    stress: Annotated[float, Quantity("stress"), Origin("√(σ_b² + 4 τ²)", f"{_THESIS}, eq. 2.47")]
    """Tresca stress [Pa]."""
    margin: Annotated[float, Quantity("ratio"), Origin("R_p0.2 / S over the stress", f"{_THESIS}, eq. 2.47")]
    """Allowable over actual stress [-]."""
    mass: Annotated[float, Quantity("mass"), Origin("cylinders", "geometry")]
    """Of a built shaft without what lies inside its gears, which count as solid [kg]."""
    inertia: Annotated[float, Quantity("inertia"), Origin("cylinder", "geometry")]
    """[kg m²]"""
    stiffness: Annotated[
        float,
        Quantity("torsional_stiffness"),
        Origin("K = π G (d⁴ − d_i⁴) / (32 L), steps in series", f"{_THESIS}, eq. 3.12, with a bore"),
    ]
    """Torsional stiffness over the whole length [N m/rad]."""
    axis: tuple[Length, Length]
    """Where its axis stands in the cross-section, y and z [m]."""
    bearings: tuple[BearingLoad, ...]
    """Its two bearings; none where only torque acts."""
    diagram: ShaftDiagram
    """In the case that governs."""


@dataclass(frozen=True)
class CarrierSizing:
    """The carrier of one planetary set."""

    stage: str
    shaft: str
    """Shaft that it is part of, or ``ground``."""
    case: str
    """Load case that governs the pins."""
    torque: Torque
    """Largest torque T_c [N m]."""
    tangential_force: Annotated[
        float, Quantity("force"), Origin("F_t = T_c K_γ / (N r_c); compound sets: of all meshes", f"{_THESIS}, §2.4")
    ]
    """Force of the teeth of one planet on its pin [N]."""
    centrifugal_force: Annotated[
        float,
        Quantity("force"),
        Origin("F_c = m_p r_c ω_c², with what turns of its bearing", "kinematics"),
    ]
    """Centrifugal force of one planet on its pin [N]."""
    radial_force: Annotated[
        float,
        Quantity("force"),
        Origin("F_r = F_t tan((α_ws − α_wr)/2); compound sets: of all meshes", "equilibrium of a planet"),
    ]
    """Of the teeth of one planet on its pin, outwards [N]."""
    pin_force: Annotated[float, Quantity("force"), Origin("F = √(F_t² + (F_c + F_r)²)", "equilibrium of a planet")]
    """Force of one planet on its pin [N]."""
    radius: Annotated[float, Quantity("length"), Origin("r_c = a_w", "geometry")]
    """Radius of the pin circle [m]."""
    pin_diameter: Annotated[
        float,
        Quantity("length"),
        Origin("d³ = 32 (F b/2) / (π σ), at least the bearing's seat", f"{_THESIS}, §2.4, cantilever"),
    ]
    """Diameter of a pin [m]."""
    pin_stress: Annotated[
        float, Quantity("stress"), Origin("σ = 32 (F b/2) / (π d³ (1 − κ⁴))", f"{_THESIS}, §2.4, cantilever")
    ]
    """Bending stress at the root of a pin [Pa]."""
    pin_margin: Annotated[float, Quantity("ratio"), Origin("R_p0.2 / S over the stress", "first sizing")]
    """Allowable over actual stress of the pins [-]."""
    plate_thickness: Annotated[
        float, Quantity("length"), Origin("share of b; τ = 2 T_c/(π d² t); p = F/(d_p t)", "first sizing")
    ]
    """Thickness of the plate [m]."""
    plate_stress: Annotated[float, Quantity("stress"), Origin("τ = 2 T_c / (π d² t)", "equilibrium at the hub")]
    """Shear stress of the plate at its hub [Pa]; zero on a carrier that stands still."""
    plate_margin: Annotated[float | None, Quantity("ratio"), Origin("R_p0.2 / (2 S) over the stress", "Tresca")]
    """Allowable over actual shear stress of the plate [-]; None on a carrier that stands still."""
    eye_wall: Annotated[
        float, Quantity("length"), Origin("F = 2 w t τ; at least a quarter of a solid pin", "tear-out; estimate")
    ]
    """Metal of the plate outside the holes for pins [m]."""
    eye_stress: Annotated[float, Quantity("stress"), Origin("τ = F / (2 w t)", "tear-out along two planes")]
    """Shear stress of the plate outside the pin that is loaded most [Pa]."""
    eye_margin: Annotated[float, Quantity("ratio"), Origin("R_p0.2 / (2 S) over τ", "Tresca")]
    """Allowable over actual shear stress outside that pin [-]."""
    hole_pressure: Annotated[float, Quantity("stress"), Origin("p = F / (d_p t)", "projected area")]
    """Pressure of that pin in its hole [Pa]."""
    hole_margin: Annotated[float, Quantity("ratio"), Origin("R_p0.2 / S over the pressure", "first sizing")]
    """Allowable over actual pressure in that hole [-]."""
    reach: Annotated[float, Quantity("length"), Origin("r_c + d_p/2 + w", "geometry")]
    """Outer radius of the plate, beyond its outermost pins [m]."""
    mass: Annotated[float, Quantity("mass"), Origin("pins and plate", "geometry")]
    """Pins and plate, without planets [kg]."""
    inertia: Annotated[float, Quantity("inertia"), Origin("pins and plate", "geometry")]
    """Pins and plate, without planets [kg m²]."""
    pin_bore: Annotated[
        float | None, Quantity("length"), Origin("1 − κ⁴ = (d_needed/d)³, κ ≤ 0.8", "equal strength")
    ] = None
    """Bore of pins that are thicker than their strength asks [m]; None where they are solid."""

    @property
    def part(self) -> PartId:
        """Who it is."""
        return carrier_part(self.stage)
