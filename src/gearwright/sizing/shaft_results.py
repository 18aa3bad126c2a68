"""Results of a sizing for shafts, carriers, their bearings and planet bearings."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, NamedTuple

from gearwright.base import (
    Endless,
    Force,
    Length,
    Life,
    Mass,
    Origin,
    PartId,
    Quantity,
    Ratio,
    Slope,
    Speed,
    Stress,
    Torque,
    carrier_part,
    smallest,
)
from gearwright.catalogue import Bearing, ModifiedLife
from gearwright.parts.bearings import Journal
from gearwright.parts.shafts import torsional_stiffness

# ----------------------------------------------------------------------------------------------------------------------
# What sizing yields of shafts as they are built: steps, seats, bearings and joints.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ShaftStep:
    """A cylinder of a stepped shaft."""

    start: Length
    """From the shaft's first end [m]."""
    end: Length
    """From the shaft's first end [m]."""
    diameter: Length
    """Outer diameter [m]."""
    seat: str = ""
    """Bearing, gear or machine that sits on it; empty between seats."""


@dataclass(frozen=True)
class SectionStrength:
    """A section of a shaft in the case that tires it most."""

    shaft: str
    place: str
    """What notches it, such as ``shoulder at bearing 1a``."""
    case: str
    """Load case with the least safety against fatigue."""
    position: Length
    """From the shaft's first end [m]."""
    diameter: Length
    """Outer diameter; of a spline its root [m]."""
    bending_moment: Torque
    """Turning with respect to the shaft, hence fully reversed [N m]."""
    torque: Torque
    """Mean [N m]."""
    bending_notch: Annotated[
        float, Quantity("ratio"), Origin("K_f = 1 + q (K_t − 1)", "DIN 743-2 (K_t), Shigley, eq. 6-32")
    ]
    """K_f [-]."""
    torsion_notch: Annotated[
        float, Quantity("ratio"), Origin("K_fs = 1 + q (K_ts − 1)", "DIN 743-2 (K_ts), Shigley, eq. 6-32")
    ]
    """K_fs [-]."""
    fatigue_safety: Annotated[
        float,
        Quantity("ratio"),
        Origin("DE-ASME elliptic, -Goodman, -Gerber, -Soderberg", "Shigley, 10th ed., ch. 7"),
    ]
    """n_f [-]."""
    yield_safety: Annotated[float, Quantity("ratio"), Origin("R_p0.2/σ_vM,max", "Shigley, 10th ed., eq. 7-16")]
    """n_y, of the greatest load: application factor and torque swing included [-]."""
    din743_safety: Annotated[
        float, Quantity("ratio"), Origin("S_D = 1/√((σ_ba/σ_bADK)² + (τ_ta/τ_tADK)²)", "DIN 743-1")
    ]
    """S_D, the other method's answer [-]; 0 where the mean stress leaves no fatigue strength."""
    fillet: Length = 0.0
    """Radius of the shoulder's fillet; zero where there is no shoulder [m]."""
    limit_safety: Annotated[
        float | None, Quantity("ratio"), Origin("min(R_p0.2, R_m/1.5)/σ_vM", "CS-25.303, CS-25.305")
    ] = None
    """Against limit loads, with 1.5 times them against rupture [-]; None where none are taken by default."""


@dataclass(frozen=True)
class BuiltShaft:
    """A shaft with its steps, its strength at every notch, its stiffness and its critical speed."""

    name: str
    steps: tuple[ShaftStep, ...]
    """From the first end on, without gaps."""
    bore: Length
    """[m]; zero where it is solid."""
    sections: tuple[SectionStrength, ...]
    """Every notch and every load, in order along the shaft."""
    slopes: tuple[tuple[str, Slope], ...]
    """Gear or bearing -> slope of the bent shaft there [rad]."""
    deflections: tuple[tuple[str, Length], ...]
    """Gear -> deflection of the bent shaft there [m]."""
    critical_speed: Annotated[
        float | None,
        Quantity("speed"),
        Origin("lowest bending mode on rigid bearings", "influence numbers, Stodola 1927"),
    ]
    """First critical speed in bending [rad/s]; None where nothing bends it."""
    highest_speed: Speed
    """Largest of all load cases [rad/s]."""

    @property
    def weakest(self) -> SectionStrength:
        """The section with the least safety against fatigue."""
        return smallest(self.sections, lambda section: section.fatigue_safety)

    def stiffness_between(self, first: float, second: float, shear_modulus: float) -> float:
        """Return the torsional stiffness of what lies between two places along the shaft [N m/rad]; infinite at one.

        Args:
            first: From the shaft's first end [m].
            second: Likewise, before or behind it [m].
            shear_modulus: G [Pa].

        Source: springs in series, each π G (d⁴ − d_i⁴)/(32 l).
        """
        low, high = sorted((first, second))
        inside = [(step, min(step.end, high) - max(step.start, low)) for step in self.steps]
        compliance = sum(
            1.0 / torsional_stiffness(step.diameter, length, shear_modulus, bore=self.bore)
            for step, length in inside
            if length > 0.0
        )
        return 1.0 / compliance if compliance else math.inf


class Running(NamedTuple):
    """What a bearing bears beside its life and its static load."""

    lightest_load: float
    """Least P of all cases in which it turns [N]; 0 where none does."""
    least_load: float
    """What it must bear so as not to skid [N]."""
    highest_speed: float
    """Of all cases [rad/s]."""
    reference_speed: float
    """n_θr [rad/s]."""
    speed_factor: float
    """n d_m at the highest speed [mm/min]."""


@dataclass(frozen=True)
class BearingSizing:
    """One bearing in its seat."""

    name: str
    """As the design calls it."""
    shaft: str
    position: Length
    """From the shaft's first end [m]."""
    bearing: Bearing
    """From the catalogue."""
    case: str
    """Load case with the largest static load."""
    radial: Force
    """F_r in that case [N]."""
    axial: Force
    """F_a in that case, induced thrust of taper bearings included [N]."""
    equivalent_load: Annotated[
        float, Quantity("force"), Origin("P = X F_r + Y F_a, mean over the service", "ISO 281:2007")
    ]
    """P [N]."""
    life: Annotated[float, Quantity("life"), Origin("L_10h = (C/P)^p 10⁶/(60 n)", "ISO 281:2007"), Endless()]
    """Basic rating life [s]; ∞ where no case loads the bearing."""
    wanted_life: Life
    """[s]"""
    static_safety: Annotated[float, Quantity("ratio"), Origin("s_0 = C_0/P_0", "ISO 76:2006"), Endless()]
    """At the largest load [-]; ∞ where no case loads the bearing."""
    wanted_static_safety: Ratio
    """[-]"""
    judged_life: Annotated[Life, Endless()] = 0.0
    """The life that is asked of it, basic or modified [s]."""
    modified_life: Annotated[float | None, Quantity("life"), Origin("L_nmh = a_1 a_ISO L_10h", "ISO 281:2007, 9.3")] = (
        None
    )
    """With its oil [s]; None where nothing loads it, or the standard gives none."""
    life_factor: Annotated[float | None, Quantity("ratio"), Origin("a_1 a_ISO", "ISO 281:2007, 9.3")] = None
    """Modified over basic life [-]."""
    viscosity_ratio: Annotated[float | None, Quantity("ratio"), Origin("κ = ν/ν_1", "ISO 281:2007, 9.3")] = None
    """Least of all cases [-]."""
    contamination: Annotated[float | None, Quantity("ratio"), Origin("e_C", "ISO 281:2007, table 13 or A.4")] = None
    """[-]"""
    lightest_load: Annotated[float, Quantity("force"), Origin("P = X F_r + Y F_a, least case", "ISO 281:2007")] = 0.0
    """[N]"""
    least_load: Annotated[float, Quantity("force"), Origin("0.01 C, rollers 0.02 C", "SKF, minimum load")] = 0.0
    """Below which rolling elements may skid [N]."""
    highest_speed: Speed = 0.0
    """Of all cases [rad/s]."""
    reference_speed: Annotated[float, Quantity("speed"), Origin("heat of friction = q_r A_r", "ISO 15312:2003")] = 0.0
    """Thermal reference speed n_θr [rad/s]."""
    speed_factor: Annotated[float, Quantity("number"), Origin("n d_m", "makers' catalogues")] = 0.0
    """[mm/min]"""

    @property
    def oiled(self) -> ModifiedLife | None:
        """Its life with its oil; None where nothing loads it, or the standard gives none."""
        known = (self.modified_life, self.life_factor, self.viscosity_ratio, self.contamination)
        return None if None in known else ModifiedLife(*(value or 0.0 for value in known))

    @property
    def running(self) -> Running:
        """What it bears at least, and its speeds."""
        loads = (self.lightest_load, self.least_load)
        return Running(*loads, self.highest_speed, self.reference_speed, self.speed_factor)

    @property
    def designation(self) -> str:
        """Name in the catalogue."""
        return self.bearing.designation

    @property
    def inner_diameter(self) -> Length:
        """d [m]."""
        return self.bearing.bore

    @property
    def outer_diameter(self) -> Length:
        """D [m]."""
        return self.bearing.outer_diameter

    @property
    def width(self) -> Length:
        """B, of a taper bearing T [m]."""
        return self.bearing.width

    @property
    def dynamic_rating(self) -> Force:
        """C [N]."""
        return self.bearing.dynamic_rating

    @property
    def static_rating(self) -> Force:
        """C_0 [N]."""
        return self.bearing.static_rating

    @property
    def mass(self) -> Mass:
        """[kg]."""
        return self.bearing.mass


@dataclass(frozen=True)
class JointSizing:
    """What joins a gear or a machine to its shaft."""

    part: str
    """Gear or machine."""
    shaft: str
    position: Length
    """Middle, from the shaft's first end [m]."""
    kind: str
    """integral, key, spline or press-fit."""
    designation: str
    """Such as ``DIN 6885 - A 18 x 11 x 100`` or ``DIN 5480 - W 55 x 2 x 26``; empty for one piece."""
    torque: Torque
    """Largest of all cases, application factor included [N m]."""
    diameter: Length
    """Shaft, or reference diameter of the spline [m]."""
    length: Length
    """Bearing length [m]."""
    pressure: Annotated[
        float,
        Quantity("stress"),
        Origin("p = 2 T/(d h l i), of a press fit 2 T S/(π d² l μ)", "DIN 6892, DIN 5480, DIN 7190"),
        Endless(),
    ]
    """On flank or fit [Pa]; zero for one piece, ∞ of a key of which round ends leave no flank."""
    allowed_pressure: Stress
    """[Pa]"""
    interference: Length = 0.0
    """Of a press fit, as made [m]."""
    running_pressure: Annotated[
        float,
        Quantity("stress"),
        Origin("p of U less ρ ω² d³/(16 E) (3 + ν)(1/Q_a² − Q_i²)", "DIN 7190-1, Lamé with body forces"),
    ] = 0.0
    """Of a press fit at the highest speed [Pa]; 0 where it is loose."""
    needed_pressure: Annotated[float, Quantity("stress"), Origin("p = 2 T S/(π d² l μ)", "DIN 7190-1")] = 0.0
    """Of a press fit, for its torque [Pa]."""
    speed: Speed = 0.0
    """Highest of all cases [rad/s]."""
    rim: Annotated[float | None, Quantity("ratio"), Origin("s_R/h_t, h_t = 2.25 m_n", "ISO 6336-3:2019, Y_B")] = None
    """Metal between hub seat and tooth root over the height of the teeth [-]; None for one piece and for machines."""
    form: str = ""
    """Of a key: A with round ends, B with square ones."""
    module: Length = 0.0
    """Of a spline [m]; zero for others."""


def hub_bore_of(joint: JointSizing) -> Length:
    """Return what a hub slides over [m]: its seat, of a spline what the hub's tips leave, d_B − 2 m (DIN 5480-1).

    Args:
        joint: As sized.
    """
    return joint.diameter - 2.0 * joint.module


# ----------------------------------------------------------------------------------------------------------------------
# What carries gears: shafts with the loads of their bearings and their diagrams, and carriers.
# ----------------------------------------------------------------------------------------------------------------------


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
    margin: Annotated[float, Quantity("ratio"), Origin("R_p0.2 / S over the stress", f"{_THESIS}, eq. 2.47"), Endless()]
    """Allowable over actual stress [-]; ∞ where nothing loads the shaft."""
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
        Origin(
            "d³ = 32 M/(π σ (1 − κ⁴)), M = F b/2, two plates F (b + 2 t)/8; at least the bearing's seat",
            f"{_THESIS}, §2.4, cantilever; beam on two supports",
        ),
    ]
    """Diameter of a pin [m]."""
    pin_stress: Annotated[
        float,
        Quantity("stress"),
        Origin(
            "σ = 32 M/(π d³ (1 − κ⁴)), M = F b/2, two plates F (b + 2 t)/8",
            f"{_THESIS}, §2.4, cantilever; beam on two supports",
        ),
    ]
    """Bending stress of a pin: at its root, or in its middle between two plates [Pa]."""
    pin_margin: Annotated[float, Quantity("ratio"), Origin("R_p0.2 / S over the stress", "first sizing"), Endless()]
    """Allowable over actual stress of the pins [-]; ∞ where nothing loads them."""
    plate_thickness: Annotated[
        float, Quantity("length"), Origin("share of b; τ = 2 T_c/(π d² t); p = F/(d_p t)", "first sizing")
    ]
    """Thickness of the plate [m]."""
    plate_stress: Annotated[float, Quantity("stress"), Origin("τ = 2 T_c / (π d² t)", "equilibrium at the hub")]
    """Shear stress of the plate at its hub [Pa]; zero on a carrier that stands still."""
    plate_margin: Annotated[float | None, Quantity("ratio"), Origin("R_p0.2 / (2 S) over the stress", "Tresca")]
    """Allowable over actual shear stress of the plate [-]; None on a carrier that stands still."""
    eye_wall: Annotated[
        float,
        Quantity("length"),
        Origin("F = 2 w t τ, of two plates F/2; at least a quarter of a solid pin", "tear-out; estimate"),
    ]
    """Metal of the plate outside the holes for pins [m]."""
    eye_stress: Annotated[
        float, Quantity("stress"), Origin("τ = F / (2 w t), of two plates F/2", "tear-out along two planes")
    ]
    """Shear stress of the plate outside the pin that is loaded most [Pa]."""
    eye_margin: Annotated[float, Quantity("ratio"), Origin("R_p0.2 / (2 S) over τ", "Tresca"), Endless()]
    """Allowable over actual shear stress outside that pin [-]; ∞ where nothing loads it."""
    hole_pressure: Annotated[float, Quantity("stress"), Origin("p = F / (d_p t), of two plates F/2", "projected area")]
    """Pressure of that pin in its hole [Pa]."""
    hole_margin: Annotated[float, Quantity("ratio"), Origin("R_p0.2 / S over the pressure", "first sizing"), Endless()]
    """Allowable over actual pressure in that hole [-]; ∞ where nothing loads it."""
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
    free_plate: Annotated[float | None, Quantity("length"), Origin("share of b/2; p = F/(2 d_p t)", "first sizing")] = (
        None
    )
    """Thickness of a second plate that shares the force of the pins [m]; None where one plate bears all of it."""
    bridge_width: Annotated[
        float | None, Quantity("length"), Origin("lightest with F_βx ≤ half of f_Hβ, σ ≤ R_p0.2/S", "slope-deflection")
    ] = None
    """Of a bridge between both plates, around the axis [m]; None without bridges, and at level concept."""
    bridge_depth: Annotated[float | None, Quantity("length"), Origin("room between planets", "geometry")] = None
    """Of a bridge, away from the axis [m]."""
    bridge_radius: Annotated[float | None, Quantity("length"), Origin("room between planets", "geometry")] = None
    """Of the middle of a bridge, from the axis [m]."""
    misalignment: Annotated[
        float | None, Quantity("length"), Origin("F_βx = 1.33 B_1 b × tilt", "ISO 6336-1:2006, table 8; beams")
    ] = None
    """Of planets' teeth over their face, what helix correction takes left out [m]; None at level concept."""
    largest_misalignment: Annotated[float | None, Quantity("length"), Origin("half of f_Hβ", "ISO 1328-1:2013")] = None
    """That is allowed [m]."""
    alone: bool = False
    """Whether one plate holds the pins where a second one would have room: the lighter, or as the design says."""

    @property
    def part(self) -> PartId:
        """Who it is."""
        return carrier_part(self.stage)


# ----------------------------------------------------------------------------------------------------------------------
# What sizing yields of the bearings between planets and their pins: kind, size, what of it turns, what it weighs.
# ----------------------------------------------------------------------------------------------------------------------


_CYLINDERS = Origin("cylinders of rings, rolling elements and cage", "geometry")


@dataclass(frozen=True)
class PlanetBearingSizing:
    """What one planet turns on."""

    kind: str
    """cylindrical, needle, integral, ceramic or plain, as the design asks."""
    bearing: Bearing | None
    """One of the rolling bearings; None where a film bears."""
    side_by_side: int
    """Equal ones on a pin [-]."""
    pin_diameter: Annotated[float, Quantity("length"), Origin("smallest that serves", "choice of planet bearings")]
    """d: bore of the bearing, or of the pin under rollers or film [m]."""
    outer_diameter: Length
    """Bore of the planet [m]."""
    width: Length
    """Of all on a pin [m]."""
    clearance: Ratio
    """ψ of a plain bearing [-]; 0 of others."""
    turning_mass: Annotated[float, Quantity("mass"), _CYLINDERS]
    """What a carrier swings with the planet: outer rings, rolling elements, cages [kg]."""
    turning_inertia: Annotated[float, Quantity("inertia"), _CYLINDERS]
    """Of that about the pin, at the planet's speed: rolling elements turn at (1 + γ)/2 of it [kg m²]."""
    standing_mass: Annotated[float, Quantity("mass"), _CYLINDERS]
    """Inner rings on the pin [kg]."""

    @property
    def mass(self) -> Mass:
        """Of all bearings of one planet [kg]."""
        return self.turning_mass + self.standing_mass

    @property
    def journal(self) -> Journal | None:
        """The plain bearing that it is; None where it rolls."""
        return Journal(self.pin_diameter, self.width, self.clearance) if self.bearing is None else None

    @property
    def designation(self) -> str:
        """Name in the catalogue, or kind and size in mm."""
        if self.bearing is not None:
            return self.bearing.designation
        return f"plain {1e3 * self.pin_diameter:.4g}x{1e3 * self.width:.4g}"
