"""What the dynamic model assumes: mesh stiffness, damping, how far planetary sets may move on their bearings."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Ratio, Stiffness


class MeshCurve(Record):
    """A user's own stiffness of one mesh over a mesh cycle, from a file or written here."""

    file: str | None = Field(
        None, description="CSV file beside the design file, with the columns phase_cycles and stiffness_n_m"
    )
    phase_cycles: list[float] = Field(
        default_factory=list, description="Mesh phases as parts of a cycle, rising; 0 is contact at the pitch point"
    )
    stiffness_n_m: list[float] = Field(
        default_factory=list, description="Stiffness along the line of action at these phases [N/m]"
    )


class PlanetaryBearings(Record):
    """How the members of a planetary set are held where they may move; numbers left out are Lin & Parker's (1999)."""

    sun: Stiffness = Field(100e6, ge=0, description="Radial stiffness of the sun's bearing; 0 lets the sun float")
    carrier: Stiffness = Field(100e6, ge=0, description="Radial stiffness of the carrier's bearing; 0: floats")
    ring: Stiffness = Field(100e6, ge=0, description="Radial stiffness of the ring's seat; 0: floats")
    ring_tangential: Stiffness = Field(
        1000e6, gt=0, description="Tangential stiffness at the ring's base circle, where the ring stands still"
    )
    pin: Stiffness | None = Field(
        None,
        gt=0,
        description="Stiffness of a planet's pin with its bearing, in each direction; left out: the sized pin's alone",
    )
    rigid: list[Literal["sun", "carrier", "ring", "pin"]] = Field(
        default_factory=list, description="Members whose bearings do not give way at all"
    )


class DynamicsRules(Record):
    """Assumptions of the dynamic model."""

    mesh_damping: Ratio = Field(
        0.1, ge=0, lt=1, description="Damping ratio ζ of mesh lines (Pulvirenti 2023, eq. 3.29: 0.1)"
    )
    shaft_damping: Ratio = Field(
        0.1, ge=0, lt=1, description="Damping ratio ζ of shaft lines (Pulvirenti 2023, eq. 3.13: 0.1)"
    )
    stiffness: Literal["constant", "varying"] = Field(
        "varying", description="Mesh stiffness: mean, or a function of mesh phase"
    )
    mesh_stiffness: Literal["iso6336", "energy", "kuang-yang", "square-wave"] = Field(
        "iso6336",
        description="Mesh stiffness model: ISO 6336-1; strain energy of the teeth; Kuang & Yang; ISO's mean with the "
        "square wave of Pulvirenti 2023, eq. 3.35",
    )
    harmonics: int = Field(
        5, ge=1, le=40, description="Harmonics of the mesh frequency kept (Pulvirenti 2023, eq. 3.35: 5)"
    )
    curves: dict[str, MeshCurve] = Field(
        default_factory=dict, description="Own mesh stiffness, by mesh: first.sun-planet, first.planet-ring, a pair"
    )
    fidelity: Literal["rotational", "translational"] = Field(
        "rotational",
        description="Planetary sets turn in rigid bearings, or their members also move across on their bearings",
    )
    machines: Literal["inertia", "torque"] = Field(
        "inertia", description="Machines turn along on shafts of their own, or act by their torque alone"
    )
