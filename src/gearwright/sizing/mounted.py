"""What sizing yields of shafts as they are built: steps, seats, bearings and joints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, NamedTuple

from gearwright.catalogue import Bearing, ModifiedLife
from gearwright.ranking import smallest
from gearwright.units import Force, Length, Life, Mass, Origin, Quantity, Ratio, Slope, Speed, Stress, Torque


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
    life: Annotated[float, Quantity("life"), Origin("L_10h = (C/P)^p 10⁶/(60 n)", "ISO 281:2007")]
    """Basic rating life [s]; ∞ where no case loads the bearing."""
    wanted_life: Life
    """[s]"""
    static_safety: Annotated[float, Quantity("ratio"), Origin("s_0 = C_0/P_0", "ISO 76:2006")]
    """At the largest load [-]; ∞ where no case loads the bearing."""
    wanted_static_safety: Ratio
    """[-]"""
    judged_life: Life = 0.0
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
    ]
    """On flank or fit [Pa]; zero for one piece."""
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
