"""What modes and forces say about a planetary set: the family of each mode, the share of each planet."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import Modes
from gearwright.dynamics.model import PIN, Labels, Owner, System
from gearwright.errors import DesignError, Problem, near
from gearwright.identity import MEMBERS, Role, Row, gear_part, member_part, mesh_part
from gearwright.ranking import place_of_largest

Family = Literal["rigid", "rotational", "translational", "planet", "mixed"]
PURE = 0.99
"""Share of a mode's kinetic energy from which it counts as one of a family [-]."""


def family_shares(system: System, modes: Modes, positions: Sequence[float], *, name: str = "") -> Floats:
    """Return how much of each mode's kinetic energy is rotational, translational and of the planets alone.

    Args:
        system: A system with one planetary set of equal planets.
        modes: Its modes.
        positions: Angles of the planets ψ_n [rad].
        name: Name of the set.

    Returns:
        Shares [-], shape (3, modes): central rotations and what all planets do alike; central translations and what the
        planets do as cos ψ_n and sin ψ_n; the rest of the planets' motion. What is not of the set is in none.

    Source: Lin & Parker 1999, J. Vib. Acoust. 121, 316-321, section on the structure of the modes.
    """
    motion = modes.shapes * np.sqrt(system.arrays.mass)[:, None]
    place = {owner: number for number, owner in enumerate(system.labels.coordinate_owners)}
    shares = np.zeros((3, motion.shape[1]))
    for member in MEMBERS:
        for family, directions in ((0, ("",)), (1, ("x", "y"))):
            owners = [Owner(member_part(name, member), direction) for direction in directions]
            rows = [place[owner] for owner in owners if owner in place]
            shares[family] += np.sum(motion[rows] ** 2, axis=0)
    alike, waves = _planet_patterns(positions)
    numbers = range(1, len(positions) + 1)
    for direction in ("", *PIN):
        owners = [Owner(gear_part(name, Role.PLANET, number=number), direction) for number in numbers]
        if owners[0] not in place:
            continue
        planets = motion[[place[owner] for owner in owners]]
        parts = [np.sum((basis.T @ planets) ** 2, axis=0) for basis in (alike, waves)]
        shares += np.array([*parts, np.sum(planets**2, axis=0) - parts[0] - parts[1]])
    return shares


def mode_families(system: System, modes: Modes, positions: Sequence[float], *, name: str = "") -> tuple[Family, ...]:
    """Return the family of each mode of a planetary set.

    Args:
        system: A system with one planetary set of equal planets.
        modes: Its modes.
        positions: Angles of the planets ψ_n [rad].
        name: Name of the set.

    Returns:
        ``"rigid"``, ``"rotational"``, ``"translational"``, ``"planet"``, or ``"mixed"`` where the planets' places are
        not even, or where other parts of the train move along.

    Source: Lin & Parker 1999: 6 rotational modes, 6 pairs of translational ones, 3 planet modes of multiplicity N − 3.
    """
    shares = family_shares(system, modes, positions, name=name)
    names: tuple[Family, ...] = ("rotational", "translational", "planet")
    families: list[Family] = []
    for mode in range(shares.shape[1]):
        largest = place_of_largest(shares[:, mode])
        family: Family = names[largest] if shares[largest, mode] >= PURE else "mixed"
        families.append("rigid" if mode < modes.rigid else family)
    return tuple(families)


def load_shares(force: Floats, labels: Labels, *, name: str = "") -> Floats:
    """Return the share of each planet in the torque of the sun.

    Args:
        force: Line forces [N], shape (lines,) or (lines, instants).
        labels: Names of the lines.
        name: Name of the set.

    Returns:
        Shares [-], shape (planets,) or (planets, instants); N times the largest is the mesh load factor K_γ.

    Source: definition of K_γ, ISO 6336-1:2006, clause 4.
    """
    row = mesh_part(name, Row.SUN_PLANET)
    rows = list(labels.places_of(row))
    if not rows:
        raise DesignError([Problem(str(row), f"there is no such mesh; {near(str(row), labels.lines)}")])
    return np.asarray(force[rows] / np.sum(force[rows], axis=0))


def _planet_patterns(positions: Sequence[float]) -> tuple[Floats, Floats]:
    """Orthonormal patterns over the planets: all alike, and the two waves once around."""
    angles = np.asarray(positions)
    alike = np.ones((len(angles), 1)) / np.sqrt(len(angles))
    waves = np.column_stack([np.cos(angles), np.sin(angles)])
    waves = waves - alike @ (alike.T @ waves)
    vectors, singular, _ = np.linalg.svd(waves, full_matrices=False)
    return alike, vectors[:, singular > 1e-9]
