"""How gears are rated and proportioned, and what tooth numbers are searched."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field

from gearwright.catalogue import CENTRE_FITS, THICKNESS_FITS
from gearwright.spec.bounds import OneOf
from gearwright.spec.design.rules.bands import ForbiddenBand
from gearwright.spec.design.rules.methods import RatingName
from gearwright.spec.design.rules.standards import Agma2001Rules, Agma2003Rules, Iso6336Rules
from gearwright.spec.record import Record
from gearwright.units import Angle, Length, Ratio

_DEGREE = math.pi / 180.0
ThicknessFit = Annotated[
    str, OneOf(THICKNESS_FITS, 'a series (a, ab, b, bc, c, cd, d, e, f, g, h) and a tolerance (21 to 30): "cd25"')
]
"""How much thinner than without backlash teeth are made, by DIN 3967."""
CentreFit = Annotated[str, OneOf(CENTRE_FITS)]
"""How far the axes of a mesh may miss their distance, by DIN 3964."""


class GearRules(Record):
    """How gears are rated and proportioned; a stage may state its own under ``gears``."""

    material: str = Field("nitriding-steel-785", description="Name in the catalogue or under [materials]")
    rating: RatingName = Field(
        "iso6336",
        description="First sizing by Lewis and Hertz; ISO 6336 or AGMA 2001, bevel gears by ISO 10300 or AGMA 2003;"
        " left out: as the level asks, iso6336 at preliminary, else lewis-hertz",
    )
    iso6336: Iso6336Rules = Field(
        default_factory=Iso6336Rules, description='Rules with rating = "iso6336" or "iso10300"'
    )
    agma2001: Agma2001Rules = Field(default_factory=Agma2001Rules, description='Rules with rating = "agma2001"')
    agma2003: Agma2003Rules = Field(default_factory=Agma2003Rules, description='Rules with rating = "agma2003"')
    pressure_angle: Angle = Field(
        20 * _DEGREE, ge=14 * _DEGREE, le=30 * _DEGREE, description="Normal pressure angle α_n"
    )
    helix_angle: Angle = Field(0.0, ge=0, le=45 * _DEGREE, description="Helix angle β of pairs; 0 is spur")
    face_width_ratio: Ratio | None = Field(
        None, gt=1, le=60, description="λ = b/m_n; left out: 10 for spur, the overlap ratio's for helical"
    )
    overlap_ratio: Ratio = Field(1.15, ge=1, le=5, description="Overlap ratio ε_β that sets the width of helical gears")
    bending_safety: Ratio = Field(2.5, ge=1, description="Factor on R_p0.2 in Lewis's bending")
    contact_safety: Ratio = Field(1.5, ge=1, description="Factor on 2.5 HB in Hertz's contact")
    mesh_load_factor: Ratio | None = Field(
        None,
        ge=1,
        le=3,
        description="K_γ, largest over mean load of parallel meshes; left out: by the load_sharing of the stage, 1 with"
        " Lewis and Hertz",
    )
    planet_load_factors: dict[str, Ratio] = Field(
        default_factory=dict,
        description="K_γ of sets by number of planets, { 3 = 1.1, 4 = 1.25 }: only those are chosen; left out:"
        " mesh_load_factor, or the load_sharing of the set",
    )
    idler_factor: Ratio = Field(
        1.0,
        ge=0.1,
        le=1,
        description="Share of the bending allowable for gears loaded both ways (planets); ISO 6336-3 takes 0.7",
    )
    profile_shift: Ratio = Field(
        0.0,
        ge=-0.5,
        le=1,
        description="Profile shift x of pinions and suns; it lowers the tooth number that is free of undercut",
    )
    balanced_shifts: Literal["sliding", "strength"] | None = Field(
        None,
        description="Shifts that are not given balance specific sliding, or the strength of the roots, of two gears",
    )
    allowance: ThicknessFit | None = Field(
        None,
        description='Allowance and tolerance of tooth thicknesses by DIN 3967: "cd25"; left out: as thick as can be',
    )
    centre_allowance: CentreFit | None = Field(
        None, description='Tolerance of centre distances by DIN 3964: "js7"; left out: the axes stand as drawn'
    )
    contact_angles: Literal["normal", "transverse"] = Field(
        "normal", description="Angles of the helical contact formula: α and β as the thesis prints, or α_t and β_b"
    )
    cutter_radius: Length | None = Field(
        None,
        gt=0,
        le=2,
        description="Cutter radius r_c0 of spiral bevel teeth, for their taper, K_F0 and K_x; left out: large",
    )
    mesh_efficiency: Ratio = Field(
        1.0, gt=0.5, le=1, description="Efficiency of one mesh; the driven gear receives that part of the tooth power"
    )
    web_ratio: Ratio = Field(
        1.0, ge=0.01, le=1, description="Mass of a wheel body over that of the solid disc; 1 is solid"
    )
    web_thickness_ratio: Ratio = Field(
        0.3,
        ge=0.05,
        le=1,
        description="Web over face width of gears in the complete mass, where rim and hub leave room; 1 is solid",
    )
    web_holes: Literal[0, 3, 4, 5, 6, 8, 10, 12] = Field(
        0,
        description="Holes that lighten the webs of cylindrical wheels of pairs, as wide as 0.6 of the room between rim"
        " and hub, or between neighbours",
    )
    web_dish: Ratio = Field(
        0.0,
        ge=-1,
        le=1,
        description="Dish of the webs of wheels of pairs: by how much they stand aside at the hub over their height,"
        " towards the shaft's second end, of bevel wheels away from the apex; their thickness along the axis is kept",
    )
    rim_thickness_ratio: Ratio = Field(
        3.95,
        ge=1,
        description="Ring wall from its pitch circle over the module; profile shift moves it with the root circle",
    )
    rim_ratio: Ratio | None = Field(
        None,
        gt=0.5,
        le=20,
        description="Rim of wheels and planets below the roots over the tooth height s_R/h_t, for Y_B; left out: solid",
    )

    def load_factor_of(self, planets: int) -> float:
        """Return K_γ of a set with so many planets, or of the first number in the table where that is not there [-].

        Args:
            planets: Number of planets, or of sets of planets [-].
        """
        table = self.planet_load_factors
        return table.get(str(planets), next(iter(table.values()), self.mesh_load_factor or 1.0))


SUN_LIMITS = (59, 120, 240, 400)
"""Largest tooth number of suns where none is given: as a rule, and then where no fewer teeth do [-]."""


class TeethRules(Record):
    """What the search for tooth numbers may choose from; the table of Lewis form factors begins at 12 teeth."""

    sun_minimum: int = Field(18, ge=12, le=400, description="Smallest tooth number of suns")
    sun_maximum: int | None = Field(
        None, ge=12, le=400, description="Largest tooth number of suns; left out: 59, or 400 where no fewer teeth do"
    )
    pinion_minimum: int | None = Field(
        None, ge=12, le=400, description="Smallest tooth number of pinions; left out: no undercut"
    )
    pinion_maximum: int = Field(40, ge=12, le=400, description="Largest tooth number of pinions that are searched")
    planet_minimum: int = Field(12, ge=12, le=400, description="Smallest tooth number of planets")
    planets_maximum: int = Field(
        5, ge=2, le=12, description="Maximum number of planets that are looked at where a set leaves their number out"
    )
    stage_tolerance: Ratio = Field(
        0.025, gt=0, le=0.2, description="Allowed deviation of a stage's ratio from its target"
    )
    speed_tolerance: Ratio = Field(0.05, gt=0, le=0.2, description="Allowed deviation of a speed from the one asked")
    split: Literal["equal", "optimal"] = Field(
        "equal", description="equal: stages share an open ratio equally (times ψ); optimal: as is lightest"
    )
    ring_deviation: int = Field(
        0, ge=0, le=2, description="Teeth by which chosen rings may differ from z_s + 2 z_p, where shifts close the set"
    )
    hunting: bool = Field(False, description="Ask for tooth numbers without a common factor")
    forbidden: dict[str, ForbiddenBand] = Field(
        default_factory=dict, description="Frequencies at which no teeth shall pass, by name: [teeth.forbidden.NAME]"
    )
    sized: int = Field(
        1,
        ge=1,
        le=1000,
        description="How many combinations of the lightest gears are sized in full, to take the lightest that passes",
    )

    def largest_sun(self, otherwise: int = SUN_LIMITS[0]) -> int:
        """Return the largest tooth number of suns that is looked at [-].

        Args:
            otherwise: Where none is given [-].
        """
        return self.sun_maximum or otherwise
