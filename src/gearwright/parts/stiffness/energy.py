"""Time-varying mesh stiffness from the strain energy of the teeth: bending, shear, compression, foundation, Hertz.

Pairs in contact are added as independent springs: what one pair does to its neighbour through their common body is
left out. The rim's own bending is not in it either: an elastic ring is a body of the dynamic model. A bore radius
brings in the twist of the disc, which every pair then feels for itself; a thin web is better a shaft of the model.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.parts.gears import CylindricalGear, GearPair, contact_radii, tooth_form, virtual_teeth
from gearwright.parts.material import Material
from gearwright.parts.stiffness.curve import StiffnessCurve
from gearwright.parts.stiffness.passing_pairs import pair_curve, summed_pairs
from gearwright.parts.stiffness.tooth_compliance import ToothCompliance, tooth_compliance

Bores: TypeAlias = tuple[float | None, float | None]


@dataclass(frozen=True)
class PairStiffness:
    """What gives where, when one tooth pair passes through its path of contact."""

    distance: Floats
    """Distance from the pitch point towards the driver's tip [m], shape (n,)."""
    driver: ToothCompliance
    """Compliance of the driver's tooth."""
    driven: ToothCompliance
    """Compliance of the driven tooth."""
    contact: float
    """Hertzian compliance of the contact line [m²/N]."""

    @property
    def stiffness(self) -> Floats:
        """Stiffness per unit length of contact along the flank's normal [N/m²], shape (n,)."""
        return 1.0 / (self.driver.total + self.driven.total + self.contact)


def contact_compliance(first: Material, second: Material) -> float:
    """Return the Hertzian compliance of a contact line, independent of the load.

    Args:
        first: Material of one flank.
        second: Material of the other.

    Returns:
        Approach per unit force and length [m²/N]; for equal materials 4 (1 − ν²)/(π E).

    Source: Yang & Sun 1985, J. Mech. Trans. Autom. Des. 107.
    """
    return (2.0 / math.pi) * sum((1.0 - m.poisson_ratio**2) / m.elastic_modulus for m in (first, second))


def pair_stiffness(
    pair: GearPair, distance: Floats, *, materials: tuple[Material, Material], bore_radii: Bores = (None, None)
) -> PairStiffness:
    """Return the stiffness of one tooth pair at given places of its path of contact.

    Args:
        pair: External or internal pair.
        distance: Distances from the pitch point towards the driver's tip [m], shape (n,).
        materials: Of driver and driven gear.
        bore_radii: Radii at which the two bodies are held [m]; None: half plane, always so for a ring.

    Source: as `tooth_compliance` and `contact_compliance`; helical teeth by their equivalent spur gears.
    """
    radii = np.array([contact_radii(pair, float(place)) for place in distance]).reshape(-1, 2)
    driver, driven = radii.T
    return PairStiffness(
        distance=distance,
        driver=_gear_compliance(pair.driver, driver, material=materials[0], bore_radius=bore_radii[0]),
        driven=_gear_compliance(pair.driven, driven, material=materials[1], bore_radius=bore_radii[1]),
        contact=contact_compliance(*materials),
    )


def mesh_stiffness_energy(
    pair: GearPair, *, materials: tuple[Material, Material], bore_radii: Bores = (None, None), harmonics: int = 8
) -> StiffnessCurve:
    """Return the time-varying mesh stiffness by the potential-energy method.

    Args:
        pair: External or internal, spur or helical.
        materials: Of driver and driven gear.
        bore_radii: Radii at which the two bodies are held [m]; None: half plane.
        harmonics: Harmonics of the mesh phase to keep [-].

    Returns:
        Stiffness along the transverse line of action [N/m] over the whole face width.

    Source: Yang & Lin 1987; Tian 2004; Cornell 1981 or Sainsot et al. 2004; Yang & Sun 1985. Helical teeth in slices
        (see `pair_curve`), each with the normal section's stiffness times cos β_b, as ISO 6336-1:2006 does with cos β.
    Valid for: perfect flanks without modifications; full contact along every line of contact.

    Raises:
        DesignError: for a total contact ratio below 1.
    """
    return pair_curve(
        _ends(pair),
        _passing_pair(pair, materials, bore_radii),
        overlap=pair.overlap_ratio,
        harmonics=harmonics,
        source="potential energy of the tooth",
    )


def mesh_cycle_energy(
    pair: GearPair, phase: Floats, *, materials: tuple[Material, Material], bore_radii: Bores = (None, None)
) -> Floats:
    """Return the stiffness of a spur mesh at given mesh phases with its jumps, as a figure shows it.

    Args:
        pair: External or internal spur pair.
        phase: Mesh phases φ [rad], shape (n,).
        materials: Of driver and driven gear.
        bore_radii: Radii at which the two bodies are held [m]; None: half plane.

    Returns:
        k [N/m], shape (n,).

    Source: as `mesh_stiffness_energy`, without its Fourier series.
    """
    if pair.driver.helix_angle > 0.0:
        raise DesignError([Problem("helix_angle", "helical teeth have no jumps to show; use `mesh_stiffness_energy`")])
    return summed_pairs(_ends(pair), _passing_pair(pair, materials, bore_radii), phase)


def _ends(pair: GearPair) -> tuple[float, float]:
    """Start and end of contact in base pitches from the pitch point."""
    return -pair.approach / pair.driver.base_pitch, pair.recess / pair.driver.base_pitch


def _passing_pair(
    pair: GearPair, materials: tuple[Material, Material], bore_radii: Bores
) -> Callable[[Floats], Floats]:
    """Stiffness of one pair [N/m] as a function of its place in base pitches, along the transverse line of action."""
    width = pair.face_width * math.cos(pair.driver.base_helix_angle)

    def stiffness(place: Floats) -> Floats:
        distance = place * pair.driver.base_pitch
        return width * pair_stiffness(pair, distance, materials=materials, bore_radii=bore_radii).stiffness

    return stiffness


def _gear_compliance(
    gear: CylindricalGear, radius: Floats, *, material: Material, bore_radius: float | None
) -> ToothCompliance:
    """Compliance of a gear's tooth; transverse radii go to the equivalent spur gear at equal height above its pitch."""
    virtual = virtual_teeth(abs(gear.teeth), gear.rack.pressure_angle, gear.helix_angle)
    moved = radius + (0.5 * virtual * gear.module - gear.pitch_radius)
    return tooth_compliance(tooth_form(gear), moved, material=material, bore_radius=bore_radius)
