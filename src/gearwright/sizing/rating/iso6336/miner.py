"""Stresses of rated gears under many loads, their safeties over a life, and Miner's parts by ISO 6336-6."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.parts.iso6336 import (
    LifeCurve,
    Steels,
    StressBin,
    Value,
    damage_part,
    life_curves,
    spectrum_damage,
)
from gearwright.sizing.rating.protocol import ClassDamage, MeshSpectrum


class Strain(NamedTuple):
    """Stress of one gear and what it bears; numbers, or arrays over loads."""

    stress: Value
    """σ_H or σ_F [Pa]."""
    endurance: Value
    """Its limit at a life factor of 1 [Pa]."""
    permissible: Value
    """Its limit after the life of the load [Pa]."""
    cycles: Value
    """Load cycles [-]."""


Strains = tuple[tuple[Strain, Strain], tuple[Strain, Strain]]
"""Of the flanks and of the roots, each of both gears."""
Both = tuple[float, float]


def of_each(strains: Strains, count: int) -> list[Strains]:
    """Return the strains of every load.

    Args:
        strains: Arrays over loads, or numbers that are the same in all.
        count: Number of loads [-].
    """
    (flank_1, flank_2), (root_1, root_2) = (tuple(_rows(strain, count) for strain in both) for both in strains)
    return [
        ((first, second), (third, fourth))
        for first, second, third, fourth in zip(flank_1, flank_2, root_1, root_2, strict=True)
    ]


def _rows(strain: Strain, count: int) -> list[Strain]:
    columns = (np.broadcast_to(values, count).tolist() for values in strain)
    return [Strain(*row) for row in zip(*columns, strict=True)]


def safeties(rated: Sequence[Strains], steels: Steels) -> tuple[Both, Both]:
    """Return S_H and S_F of both gears, each by Miner's sum over the loads where there are several [-].

    Args:
        rated: Of every load.
        steels: Of both gears.
    """
    curves = [life_curves(steel) for steel in steels]
    (flank, root) = (
        tuple(_safety([row[mode][gear] for row in rated], curves[gear][mode]) for gear in (0, 1)) for mode in (0, 1)
    )
    return (flank[0], flank[1]), (root[0], root[1])


def damages(strains: Strains, spectrum: MeshSpectrum, steels: Steels) -> tuple[ClassDamage, ClassDamage]:
    """Return Miner's parts of both gears.

    Args:
        strains: Under the loads of the spectrum, arrays over its classes.
        spectrum: With the turns of its classes.
        steels: Of both gears.
    """
    first, second = (float(np.asarray(teeth)) for teeth in spectrum.ask.teeth)
    both = []
    for gear, relative in enumerate((1.0, first / second)):
        cycles = [turns * relative * spectrum.ask.passes[gear] for turns in spectrum.turns]
        parts = zip(strains, life_curves(steels[gear]), strict=True)
        both.append(ClassDamage(*(_parts(cycles, pair[gear], curve) for pair, curve in parts)))
    return both[0], both[1]


def _safety(strains: list[Strain], curve: LifeCurve) -> float:
    if len(strains) == 1:
        return float(strains[0].permissible / strains[0].stress)
    # Every case has its own film and hence its own limit: stresses are counted in parts of it.
    bins = [StressBin(float(load.stress / load.endurance), float(load.cycles)) for load in strains]
    return spectrum_damage(bins, 1.0, curve).safety


def _parts(cycles: Sequence[float], strain: Strain, curve: LifeCurve) -> list[float]:
    """Miner's part of every class; the limits differ from class to class by the film factors."""
    stresses, limits = (np.broadcast_to(values, len(cycles)).tolist() for values in strain[:2])
    rows = zip(cycles, stresses, limits, strict=True)
    return [damage_part(turns, stress / limit, curve) for turns, stress, limit in rows]
