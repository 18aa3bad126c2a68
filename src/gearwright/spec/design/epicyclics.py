"""Compound epicyclic sets: one carrier, planets of several steps that may mesh with each other, any suns and rings."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from gearwright.parts.planetary import CompoundSet
from gearwright.spec.bounds import Name
from gearwright.spec.design.rules import CYLINDRICAL, INTERNAL, GearRules, ThicknessFit
from gearwright.spec.design.stages import LEVELS, NORMAL_PITCH, PINS, PITCH, PlanetBearing, SharingLevel
from gearwright.spec.record import Record
from gearwright.units import Inertia, Length, Mass, Ratio

_TEETH = Field(ge=6, le=2000, description="Tooth number z")
_MODULE = Field(None, gt=0, le=0.1, description="Module m_n of this gear and of all that mesh with it; left out: sized")
_WIDTH = Field(None, gt=0, description="Face width b of the meshes of this gear and of its mates; left out: sized")
_SHIFT = Field(
    None, ge=-1.5, le=1.5, description="Profile shift x; left out: closes its meshes, balanced, or gears.profile_shift"
)
_TIP = Field(None, ge=-0.6, le=0.3, description="Tip alteration k; left out: keeps the tip clearance")
_ALLOWANCE = Field(None, description="Its tooth thickness by DIN 3967; left out: gears.allowance")
_BORE = Field(
    None,
    gt=0,
    description="Bore, or inside of the rim, for K_V; left out: suns solid, planets 0.66 of d",
)
_PLACE = Field(
    None, gt=0, le=10, description="Middle of its face along the axis, from the carrier's plate; left out: not known"
)
_MASS = Field(None, gt=0, description="Of one gear; left out: of the disc or of the ring's wall")
_INERTIA = Field(None, gt=0, description="Of one gear; left out: of the disc or of the ring's wall")


class CentralGear(Record):
    """A sun or a ring of a compound set."""

    shaft: Name = Field(description="Shaft that carries it, or ground")
    teeth: int = _TEETH
    module: Annotated[Length | None, PITCH, NORMAL_PITCH] = _MODULE
    face_width: Length | None = _WIDTH
    place: Length | None = _PLACE
    shift: Ratio | None = _SHIFT
    tip_alteration: Ratio | None = _TIP
    allowance: ThicknessFit | None = _ALLOWANCE
    bore: Length | None = _BORE
    mass: Mass | None = _MASS
    inertia: Inertia | None = _INERTIA


class PlanetGear(Record):
    """A planet of a compound set, or one step of a stepped planet."""

    teeth: int = _TEETH
    meshes: list[Name] = Field(
        default_factory=list, description="Suns, rings and other planets of the set that it meshes with"
    )
    in_one_piece_with: Name | None = Field(
        None, description="Planet of the set with which it turns as one piece: the steps of a stepped planet"
    )
    module: Annotated[Length | None, PITCH, NORMAL_PITCH] = _MODULE
    face_width: Length | None = _WIDTH
    place: Length | None = _PLACE
    centre_distance: Length | None = Field(
        None,
        gt=0,
        description="Working distance of its pin from the set's axis, of all its meshes with suns and rings; the shifts"
        " follow; left out: they give it",
    )
    shift: Ratio | None = _SHIFT
    tip_alteration: Ratio | None = _TIP
    allowance: ThicknessFit | None = _ALLOWANCE
    bore: Length | None = _BORE
    mass: Mass | None = _MASS
    inertia: Inertia | None = _INERTIA
    bearing: PlanetBearing | None = Field(
        None, description="What this planet, or this step, turns on; left out: not known"
    )


class Epicyclic(Record):
    """A compound epicyclic set: suns, rings and planets on one carrier; several members may have one shaft."""

    carrier: Name = Field(description="Shaft of the carrier, or ground")
    sets: int = Field(3, ge=1, le=12, description="Equal sets of planets, evenly spaced around the carrier")
    suns: dict[str, CentralGear] = Field(default_factory=dict, description="Suns by name")
    rings: dict[str, CentralGear] = Field(default_factory=dict, description="Rings by name")
    planets: dict[str, PlanetGear] = Field(
        default_factory=dict, description="Planets of one set, and the steps of stepped ones, by name"
    )
    backlash: Length = Field(
        0.0, ge=0, le=0.01, description="Of each mesh, along the line of action; 0: contact both ways"
    )
    mesh_efficiencies: dict[str, Ratio] = Field(
        default_factory=dict,
        description='Efficiency of single meshes, by name: "sun-planet" = 0.99; left out: gears.mesh_efficiency',
    )
    load_sharing: SharingLevel | None = Field(None, description=LEVELS)
    pin_position: Length | None = Field(None, ge=1e-7, le=1e-3, description=PINS)
    pin_diameter: Length | None = Field(None, gt=0, description="Of the planets' pins; left out: sized")
    plate_thickness: Length | None = Field(None, gt=0, description="Of the carrier's plate; left out: sized")
    eye_wall: Length | None = Field(
        None, gt=0, description="Metal of the carrier's plates outside its pins; left out: sized"
    )
    carrier_mass: Mass | None = Field(None, gt=0, description="Of pins and plate; left out: computed")
    carrier_inertia: Inertia | None = Field(None, gt=0, description="Of pins and plate; left out: computed")
    gears: GearRules | None = Field(None, description="Rules of this set where they differ from [gears]")

    @property
    def centrals(self) -> dict[str, CentralGear]:
        """Every sun and ring by name."""
        return {**self.suns, **self.rings}

    @property
    def toothed(self) -> dict[str, CentralGear | PlanetGear]:
        """Every gear by name."""
        return {**self.suns, **self.rings, **self.planets}

    @property
    def members(self) -> tuple[str, ...]:
        """Shafts of its suns, rings and carrier."""
        return (*(gear.shaft for gear in self.centrals.values()), self.carrier)

    @property
    def meshes(self) -> tuple[str, ...]:
        """Kinds of its meshes, as methods of rating cover them."""
        return (CYLINDRICAL, INTERNAL) if self.rings else (CYLINDRICAL,)

    @property
    def mesh_pairs(self) -> tuple[tuple[str, str], ...]:
        """Every mesh once, as the names of its gears: a sun, or a planet and a ring, or two planets."""
        pairs: dict[frozenset[str], tuple[str, str]] = {}
        for planet, gear in self.planets.items():
            for mate in gear.meshes:
                order = (mate, planet) if mate in self.suns else (planet, mate)
                pairs.setdefault(frozenset(order), order)
        return tuple(pairs.values())

    @property
    def compound(self) -> CompoundSet:
        """Its gears and meshes as geometry takes them: rings count with negative tooth numbers."""
        return CompoundSet(
            self.sets,
            {name: -gear.teeth if name in self.rings else gear.teeth for name, gear in self.centrals.items()},
            {name: gear.teeth for name, gear in self.planets.items()},
            {name: self.body(name) for name in self.planets},
            self.mesh_pairs,
            {name: self.group(name) for name in self.toothed},
            places={name: gear.place for name, gear in self.toothed.items() if gear.place is not None},
            widths={name: width for name in self.toothed if (width := self.width(name)) is not None},
        )

    def width(self, gear: str) -> float | None:
        """Return the face width that is given for a gear or for one that teeth join to it [m].

        Args:
            gear: One of its gears.
        """
        joined = _joined(gear, self.mesh_pairs) & self.toothed.keys()
        return next((width for name in joined if (width := self.toothed[name].face_width) is not None), None)

    def module(self, gear: str) -> float | None:
        """Return the module that is given for a gear or for one that teeth join to it [m].

        Args:
            gear: One of its gears.
        """
        joined = _joined(gear, self.mesh_pairs) & self.toothed.keys()
        return next((module for name in joined if (module := self.toothed[name].module) is not None), None)

    def group(self, gear: str) -> str:
        """Return the first of all gears that teeth join to one, or nothing where teeth join all.

        Args:
            gear: One of its gears.
        """
        joined = _joined(gear, self.mesh_pairs)
        return "" if len(joined) == len(self.toothed) else next(name for name in self.toothed if name in joined)

    def body(self, planet: str) -> str:
        """Return the first planet of the piece that one belongs to.

        Args:
            planet: One of its planets.
        """
        seen = [planet]
        while (following := self.planets[seen[-1]].in_one_piece_with) in self.planets and following not in seen:
            seen.append(following or "")
        return seen[-1]


def _joined(gear: str, pairs: tuple[tuple[str, str], ...]) -> set[str]:
    """Return a gear and all that mesh with it, directly or through others."""
    joined = {gear}
    while more := {name for pair in pairs if joined & set(pair) for name in pair} - joined:
        joined |= more
    return joined
