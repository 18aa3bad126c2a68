"""How the meshes of a planetary set follow each other: relative mesh phases and what they excite.

A phase is a fraction of a mesh cycle by which a mesh runs ahead: its stiffness is k(φ + 2π γ), with φ the phase of the
set's first sun mesh. Planet positions are counted in the direction in which the driving sun turns beside the carrier.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from gearwright.errors import Problem, refuse
from gearwright.parts.gears import GearPair, half_angle_at, involute

_WHOLE = 1e-6  # of a cycle; positions come from whole teeth, so a real phase is far from this


@dataclass(frozen=True)
class PlanetPhases:
    """Relative phases of all meshes of a set."""

    sun: tuple[float, ...]
    """Phase γ_sn of each planet's sun mesh against the first planet's, in cycles [-], 0 ≤ γ < 1."""
    ring: tuple[float, ...]
    """Phase of each planet's ring mesh against the first planet's sun mesh, γ_rn + γ_rs, in cycles [-]."""


def planet_phases(sun_mesh: GearPair, ring_mesh: GearPair, positions: Sequence[float]) -> PlanetPhases:
    """Return the relative mesh phases of a planetary set whose sun drives.

    Args:
        sun_mesh: Sun (driver) and planet.
        ring_mesh: Planet (driver) and ring.
        positions: Angles of the planets ψ_n [rad].

    Source: Parker & Lin 2004, J. Mech. Des. 126, 365-370: γ_sn = −z_s ψ_n/2π, γ_rn = z_r ψ_n/2π for planets numbered
        in the sun's direction; γ_rs from the planet's tooth thickness, see `sun_to_ring_phase`.

    Raises:
        DesignError: when the planets cannot be put in at these positions.
    """
    sun, ring = sun_mesh.driver.teeth, -ring_mesh.driven.teeth
    refuse(
        Problem(
            f"positions.{n}",
            f"{math.degrees(psi):.4f}° given; the teeth fit at whole multiples of 360°/{sun + ring}",
        )
        for n, psi in enumerate(positions)
        if abs(_centred((sun + ring) * (psi - positions[0]) / (2.0 * math.pi))) > _WHOLE
    )
    shift = sun_to_ring_phase(sun_mesh, ring_mesh)
    turns = [(psi - positions[0]) / (2.0 * math.pi) for psi in positions]
    return PlanetPhases(
        sun=tuple(_cycle(-sun * turn) for turn in turns), ring=tuple(_cycle(ring * turn + shift) for turn in turns)
    )


def sun_to_ring_phase(sun_mesh: GearPair, ring_mesh: GearPair) -> float:
    """Return the phase of a planet's ring mesh against its own sun mesh, both counted from their pitch points.

    Args:
        sun_mesh: Sun (driver) and planet.
        ring_mesh: Planet (driver) and ring.

    Returns:
        γ_rs in cycles [-], 0 ≤ γ < 1. Without profile shift it is 0 for an odd and ½ for an even planet.

    Source: by geometry, as Parker & Lin 2004 ask: the sun touches one flank of a planet tooth, the ring the other, half
        a turn away: γ_rs = −z_p (π + inv α_ws + inv α_wr − 2 ψ_b)/2π with ψ_b the half angle of the tooth at its base.
    """
    planet = ring_mesh.driver
    angles = involute(sun_mesh.working_pressure_angle) + involute(ring_mesh.working_pressure_angle)
    turn = math.pi + angles - 2.0 * half_angle_at(planet, planet.base_radius)
    return _cycle(-planet.teeth * turn / (2.0 * math.pi))


def excited_modes(sun_teeth: int, planets: int, harmonic: int) -> str:
    """Return which family of modes a mesh harmonic can excite in a set of equal, equally spaced planets.

    Args:
        sun_teeth: Number of teeth of the sun z_s [-].
        planets: Number of planets N [-].
        harmonic: Harmonic of the mesh frequency l [-].

    Returns:
        ``"rotational"``, ``"translational"`` or ``"planet"``; the other two families stay silent.

    Source: Parker 2000, J. Sound Vib. 236, 561-573: by l z_s mod N being 0, 1 or N − 1, or another number.

    >>> excited_modes(27, 4, 1)
    'translational'
    """
    remainder = (harmonic * sun_teeth) % planets
    if remainder == 0:
        return "rotational"
    return "translational" if remainder in (1, planets - 1) else "planet"


def _centred(value: float) -> float:
    """Distance to the nearest whole number."""
    return value - round(value)


def _cycle(value: float) -> float:
    """Fraction of a cycle, with rounding noise below a whole taken for the whole."""
    part = value - math.floor(value)
    return 0.0 if part > 1.0 - 1e-9 or part < 1e-9 else part
