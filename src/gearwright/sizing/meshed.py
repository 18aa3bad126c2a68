"""What sizing yields of a row of meshes: its forces, and what the method of its stage makes of them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

from gearwright.identity import PartId, Row, mesh_part
from gearwright.sizing.rating import MeshRating
from gearwright.units import Origin, OriginOf, Quantity, Ratio

_THESIS = "Pulvirenti 2023"


@dataclass(frozen=True)
class MeshSizing:
    """One row of equal meshes at its worst case."""

    stage: str
    """Pair or planetary set that it belongs to."""
    row: Row
    """Which meshes of the stage it holds."""
    gears: tuple[str, str]
    """Names of the two gears."""
    count: int
    """Number of equal meshes."""
    case: str
    """Load case that governs."""
    load_factor: Ratio
    """Mesh load factor K_γ [-]."""
    tangential_force: Annotated[float, Quantity("force"), Origin("F_t = 2 T K_γ / (N d_w)", f"{_THESIS}, eq. 2.9")]
    """Tangential force of one mesh at its working pitch circles [N]."""
    radial_force: Annotated[
        float,
        Quantity("force"),
        Origin(
            "F_r = F_t tan α_wt; bevel: F_t (tan α_n cos δ ∓ sin β_m sin δ) / cos β_m",
            "ISO 21771:2007; ISO 23509:2016",
        ),
    ]
    """Radial force of one mesh [N]; of a bevel mesh on its pinion."""
    axial_force: Annotated[
        float,
        Quantity("force"),
        Origin(
            "F_a = F_t (d_w/d) tan β; bevel: F_t (tan α_n sin δ ± sin β_m cos δ) / cos β_m",
            "ISO 21771:2007; ISO 23509:2016",
        ),
    ]
    """Axial force of one mesh [N]; balanced inside a double-helical gear; of a bevel mesh on its pinion."""
    pitch_line_velocity: Annotated[float, Quantity("velocity"), Origin("v = (ω − ω_c) d_w/2", "kinematics")]
    """Pitch-line velocity relative to the carrier [m/s]."""
    centre_distance: Annotated[
        float,
        Quantity("length"),
        Origin("a_w: given, or where x_1 + x_2 leave no backlash; bevel: r_1 + r_2", "ISO 21771:2007"),
    ]
    """Working centre distance a_w [m]; of a bevel mesh what the drawn shafts stand apart."""
    working_pressure_angle: Annotated[
        float,
        Quantity("angle"),
        Origin("cos α_wt = a cos α_t/a_w", "ISO 21771:2007"),
    ]
    """Transverse pressure angle at the working pitch circles α_wt [rad]."""
    working_diameter: Annotated[
        float, Quantity("length"), Origin("d_w1 = 2 a_w z_1/(z_1 + z_2)", "ISO 21771:2007, z_2 < 0 in a ring")
    ]
    """Working pitch diameter of the first gear d_w1 [m]; of bevel and face gears d."""
    rating: MeshRating
    """What the method of its stage makes of it, with that method's equations and sources."""

    @property
    def module_bending(self) -> Annotated[float, Quantity("length"), OriginOf("rating")]:
        """Module that bending asks for [m]."""
        return self.rating.module_bending

    @property
    def module_contact(self) -> Annotated[float, Quantity("length"), OriginOf("rating")]:
        """Module that contact asks for [m]."""
        return self.rating.module_contact

    @property
    def bending_stress(self) -> Annotated[float, Quantity("stress"), OriginOf("rating")]:
        """Of the higher stressed root [Pa]."""
        return self.rating.bending_stress

    @property
    def bending_margin(self) -> Annotated[float, Quantity("ratio"), OriginOf("rating")]:
        """Allowable over actual bending stress, or safety over the asked one [-]; 1 is just enough."""
        return self.rating.bending_margin

    @property
    def contact_stress(self) -> Annotated[float, Quantity("stress"), OriginOf("rating")]:
        """Of the higher stressed flank [Pa]."""
        return self.rating.contact_stress

    @property
    def contact_margin(self) -> Annotated[float, Quantity("ratio"), OriginOf("rating")]:
        """Allowable over actual contact stress, or safety over the asked one [-]; 1 is just enough."""
        return self.rating.contact_margin

    branch: str = ""
    """Shaft that tells it from the other rows of a pair; empty where the pair has one."""
    own: str = ""
    """What the design calls its two gears, in a compound set."""

    @cached_property
    def part(self) -> PartId:
        """Who it is."""
        return mesh_part(self.stage, self.row, self.branch, own=self.own)

    @cached_property
    def name(self) -> str:
        """Its label, such as ``first.sun-planet``."""
        return str(self.part)
