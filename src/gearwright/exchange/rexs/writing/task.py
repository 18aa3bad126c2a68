"""What the parts of the writer share: the sizing, the file in the making, and the numbers of its components."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from gearwright.arrays import Floats
from gearwright.exchange.rexs.writing.sheet import Sheet, Value
from gearwright.parts import Material
from gearwright.shape import Contact, Stand
from gearwright.sizing import Sizing


@dataclass
class Task:
    """A sizing on its way into a file."""

    sizing: Sizing
    sheet: Sheet
    stands: tuple[Stand, ...]
    contacts: tuple[Contact, ...]
    unit: int = 0
    """Number of the gear unit."""
    casing: int = 0
    """Number of the housing."""
    shafts: dict[str, int] = field(default_factory=dict)
    """Shaft -> its number."""
    planets: dict[tuple[str, int], int] = field(default_factory=dict)
    """Body of planets and which of the equal ones -> number of its shaft."""
    gears: dict[str, tuple[int, ...]] = field(default_factory=dict)
    """Gear where it stands -> its number, or those of its halves."""
    loads: dict[str, int] = field(default_factory=dict)
    """Machine -> its number."""
    materials: dict[Material, int] = field(default_factory=dict)

    def material(self, name: str, of: int) -> None:
        """Say of what a component is made.

        Args:
            name: Of the material.
            of: Number of the component.
        """
        made = self.sizing.design.material(name)
        if made not in self.materials:
            self.materials[made] = self.sheet.add("material", made.name, _material(made))
        self.sheet.relate("reference", {"origin": of, "referenced": self.materials[made]})


def _material(made: Material) -> dict[str, Value]:
    return {
        "material_designation": made.name, "elastic_modulus": made.elastic_modulus,
        "poisson_ratio": made.poisson_ratio, "density": made.density, "yield_strength": made.yield_strength,
        "tensile_strength": made.ultimate_strength, "surface_hardness_vickers": made.hardness,
        "allowable_stress_number_contact_iso_6336_2016": made.contact_strength,
        "nominal_stress_number_tooth_root_iso_6336_2016": made.bending_strength,
    }  # fmt: skip


def placed(origin: Floats, along: Iterable[float], up: Iterable[float], unit: int) -> dict[str, Value]:
    """Return the attributes that say where a component stands.

    Args:
        origin: Of its own axes [m], shape (3,).
        along: Its u axis, shape (3,).
        up: Its w axis, shape (3,).
        unit: Number of the component in whose axes that is said.
    """
    return {
        "support_vector": tuple(map(float, origin)), "u_axis_vector": _direction(along),
        "w_axis_vector": _direction(up), "reference_component_for_position": unit,
    }  # fmt: skip


def _direction(way: Iterable[float]) -> tuple[float, ...]:
    """Return a direction that reads as one of length 1 in the database's unit, which is mm."""
    return tuple(float(part) * 1e-3 for part in np.asarray(tuple(way)))
