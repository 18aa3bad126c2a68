"""Bodies: every gear, carrier and machine of a sizing on its shaft, with its share of the shaft's inertia."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple

from gearwright.dynamics.assembly.compound_sets import compound_phases, own_gears, planet_bodies
from gearwright.dynamics.assembly.meshes import gear_pairs, mesh_curve, variation_left
from gearwright.dynamics.model import Model
from gearwright.identity import SIDES, Kind, PartId, Role, gear_part
from gearwright.parts.gears import GearPair
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import MachineSizing, ShaftSizing, Sizing
from gearwright.spec import GROUND
from gearwright.train import PowerFlow


class Rotor(NamedTuple):
    """What turns."""

    inertia: float
    """[kg m²]."""
    speed: float
    """In the load case [rad/s]."""
    part: PartId
    """Who it is."""


@dataclass
class Assembly:
    """A model under construction and what it is made from."""

    sizing: Sizing
    """What was sized."""
    flow: PowerFlow
    """The load case."""
    harmonics: int | None
    """Of the mesh stiffness: 0 keeps the mean, None as many as the design says."""
    model: Model = field(default_factory=Model)
    """Gets bodies, lines and loads."""
    members: dict[str, list[str]] = field(default_factory=dict)
    """Shaft -> bodies on it, in order."""
    rotors: dict[str, Rotor] = field(default_factory=dict)
    """Body -> its inertia and speed."""
    phases: dict[str, dict[str, tuple[float, ...]]] = field(default_factory=dict)
    """Compound set -> phases of its meshes, once they are known."""

    @cached_property
    def pairs(self) -> dict[str, GearPair]:
        """Mesh row -> geometry of one mesh of it."""
        return gear_pairs(self.sizing)

    @cached_property
    def moving(self) -> tuple[str, ...]:
        """Planetary sets whose members also move across."""
        design = self.sizing.design
        return tuple(design.planetaries) if design.dynamics.fidelity == "translational" else ()

    def compound_phases(self, stage: str) -> dict[str, tuple[float, ...]]:
        """Return mesh row -> phase of its mesh in every set of a compound set [cycles].

        Args:
            stage: Name of the set.
        """
        if stage not in self.phases:
            self.phases[stage] = compound_phases(self.sizing, self.flow, stage)
        return self.phases[stage]

    @property
    def machines_turn(self) -> bool:
        """Whether machines are bodies on shafts of their own, or torques on the train."""
        return self.sizing.design.dynamics.machines == "inertia"

    @property
    def turning_machines(self) -> tuple[MachineSizing, ...]:
        """Machines that are bodies on shafts of their own: those whose inertia is known."""
        return tuple(machine for machine in self.sizing.machines if self.machines_turn and machine.inertia)

    def curve(self, row: str) -> StiffnessCurve:
        """Return the stiffness of one mesh of a row along its line of action, as tip relief leaves it in the case.

        Args:
            row: Its name.
        """
        sized = next(mesh for mesh in self.sizing.meshes if mesh.name == row)
        curve = mesh_curve(self.sizing, sized, self.pairs[row], harmonics=self.harmonics)
        left = variation_left(self.sizing, sized, self.flow)
        cosine, sine = (tuple(left * value for value in values) for values in (curve.cosine, curve.sine))
        return curve if left == 1.0 else replace(curve, cosine=cosine, sine=sine)

    def put(self, body: PartId, shaft: str, inertia: float) -> None:
        """Put a body on a shaft; the ground takes none.

        Args:
            body: Who it is.
            shaft: That carries it.
            inertia: [kg m²].
        """
        if shaft != GROUND:
            name = f"{body} hub" if body.kind is Kind.SHAFT else str(body)
            self.rotors[name] = Rotor(inertia, self.flow.speeds[shaft], body)
            self.members.setdefault(shaft, []).append(name)

    def seat(self, machine: MachineSizing) -> str:
        """Return the body that a machine's shaft joins, or that its torque acts on.

        Args:
            machine: Turbine, motor or propeller.
        """
        members = self.members[machine.shaft]
        return members[0] if self.sizing.design.machines[machine.name].drives else members[-1]

    def loaded_body(self, machine: MachineSizing) -> str:
        """Return the body that feels a machine's torque.

        Args:
            machine: Turbine, motor or propeller.
        """
        return machine.name if machine in self.turning_machines else self.seat(machine)


def add_bodies(assembly: Assembly) -> None:
    """Put every gear and carrier on its shaft, in the order of the stages, then the machines.

    Args:
        assembly: That gets them.
    """
    sizing, speeds = assembly.sizing, assembly.flow.speeds
    for name in sizing.design.planetaries:
        _add_set(assembly, name)
    for name in sizing.design.epicyclics:
        _add_compound(assembly, name)
    for gear in sizing.gears:
        if gear.role in SIDES:
            for shaft in gear.shafts:
                assembly.put(gear.body(shaft), shaft, gear.inertia * gear.bodies / len(gear.shafts))
    for sized in sizing.shafts:
        _share_shaft(assembly, sized)
    for machine in assembly.turning_machines:
        assembly.rotors[machine.name] = Rotor(
            machine.inertia, speeds[machine.shaft], PartId(Kind.MACHINE, machine.name)
        )


def _add_set(assembly: Assembly, name: str) -> None:
    """Put a planetary set on its shafts; planets turn on none."""
    sizing, planetary = assembly.sizing, assembly.sizing.design.planetaries[name]
    gears = {gear.role: gear for gear in sizing.gears if gear.stage == name}
    planet, carrier = gears[Role.PLANET], next(carrier for carrier in sizing.carriers if carrier.stage == name)
    # Planets that move on their pins are masses of their own.
    carried = 0.0 if name in assembly.moving else planet.bodies * planet.turning_mass * carrier.radius**2
    assembly.put(gears[Role.SUN].part, planetary.sun, gears[Role.SUN].inertia)
    assembly.put(carrier.part, planetary.carrier, carrier.inertia + carried)
    assembly.put(gears[Role.RING].part, planetary.ring, gears[Role.RING].inertia)
    for number in range(1, planetary.planets + 1):
        body = gear_part(name, Role.PLANET, number=number)
        assembly.rotors[str(body)] = Rotor(planet.turning_inertia, assembly.flow.speeds[planet.name], body)


def _add_compound(assembly: Assembly, name: str) -> None:
    """Put a compound set on its shafts; each planet body of each set turns by itself, its steps together."""
    sizing, epicyclic = assembly.sizing, assembly.sizing.design.epicyclics[name]
    planets, gears = list(planet_bodies(sizing, name)), own_gears(sizing, name)
    carrier = next(carrier for carrier in sizing.carriers if carrier.stage == name)
    for own, central in epicyclic.centrals.items():
        assembly.put(gears[own].part, central.shaft, gears[own].inertia)
    carried = sum(planet.mass * abs(planet.place) ** 2 for planet in planets)
    assembly.put(carrier.part, epicyclic.carrier, carrier.inertia + carried)
    for planet in planets:
        assembly.rotors[str(planet.part)] = Rotor(planet.inertia, assembly.flow.speeds[planet.node], planet.part)


def _share_shaft(assembly: Assembly, shaft: ShaftSizing) -> None:
    """Give each end of a shaft half of its inertia; a shaft without gears is a body itself."""
    members = assembly.members.setdefault(shaft.name, [])
    if not members:
        assembly.put(PartId(Kind.SHAFT, shaft.name), shaft.name, shaft.inertia)
        return
    for end in {members[0], members[-1]}:
        share, rotor = 1.0 if len(members) == 1 else 2.0, assembly.rotors[end]
        assembly.rotors[end] = rotor._replace(inertia=rotor.inertia + shaft.inertia / share)
