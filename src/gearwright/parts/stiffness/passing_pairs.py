"""Mesh stiffness as the sum of tooth pairs that pass through the path of contact one base pitch after another.

Places on the path are counted in base pitches from the pitch point, in the direction in which the contact moves.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.parts.stiffness.curve import StiffnessCurve, curve_of


def pair_curve(
    ends: tuple[float, float], stiffness: Callable[[Floats], Floats], *, overlap: float, harmonics: int, source: str
) -> StiffnessCurve:
    """Return the mesh stiffness that passing tooth pairs add up to.

    Args:
        ends: Start and end of contact, in base pitches from the pitch point [-].
        stiffness: Stiffness of one pair over its whole face width [N/m] at places in base pitches from the pitch point.
        overlap: Overlap ratio ε_β of helical teeth, 0 for spur [-].
        harmonics: Harmonics of the mesh phase to keep [-].
        source: Model of the pair stiffness.

    Returns:
        Its coefficients are the exact integrals ∫ k(τ) e^(−2πi n τ) dτ over the path of contact; slices of a helical
        tooth follow each other by ε_β pitches across the face, which multiplies harmonic n by sinc(n ε_β).

    Source: Poisson's sum of shifted pairs; slicing as Wan et al. 2015, Mech. Mach. Theory 92, without
        coupling between slices.
    """
    start, end = ends
    _check_contact(end - start + overlap)
    # Gauss needs half a point per radian of the highest harmonic; 24 more carry the pair stiffness itself.
    nodes, weights = np.polynomial.legendre.leggauss(24 + math.ceil(2.0 * harmonics * (end - start)))
    place = 0.5 * (start + end) + 0.5 * (end - start) * nodes
    order = np.arange(harmonics + 1)
    weighted = 0.5 * (end - start) * weights * stiffness(place)
    coefficients = np.exp(-2j * np.pi * np.outer(order, place)) @ weighted * np.sinc(order * overlap)
    return curve_of(coefficients, source)


def summed_pairs(ends: tuple[float, float], stiffness: Callable[[Floats], Floats], phase: ArrayLike) -> Floats:
    """Return the stiffness of passing spur tooth pairs at given mesh phases, jumps and all, without a Fourier series.

    Args:
        ends: Start and end of contact, in base pitches from the pitch point [-].
        stiffness: Stiffness of one pair over its whole face width [N/m] at places in base pitches from the pitch point.
        phase: Mesh phases φ [rad], shape (n,).

    Returns:
        k [N/m], shape (n,): what a figure shows beside the series that the dynamics keeps.

    Source: definition, k(φ) = Σ_j k_pair(φ/2π + j) over the pairs between the ends.
    """
    start, end = ends
    _check_contact(end - start)
    first = np.asarray(phase, dtype=np.float64) / (2.0 * np.pi)
    first = first - np.floor(first - start)  # the first pair after the start of contact
    total = np.zeros_like(first)
    for pair in range(math.ceil(end - start)):
        place = first + pair
        touching = place <= end
        total[touching] += stiffness(place[touching])
    return total


def rectangular_curve(
    single: float, ends: tuple[float, float], *, step: float = 0.75, overlap: float = 0.0, harmonics: int = 8
) -> StiffnessCurve:
    """Return the two-level curve of ISO 6336-1: c′ with one pair in contact, c′ (1 + 0.75) with two.

    Args:
        single: Stiffness of one pair in single contact, c′ b [N/m].
        ends: Start and end of contact, in base pitches from the pitch point [-].
        step: What each further pair adds, as a part of `single` [-].
        overlap: Overlap ratio ε_β [-].
        harmonics: Harmonics of the mesh phase to keep [-].

    Returns:
        A curve whose mean is c_γ b = c′ b (0.75 ε_α + 0.25).

    Source: ISO 6336-1:2006, clause 9; the levels are the only ones whose mean gives c_γα for every 1 ≤ ε_α ≤ 2.
    """
    start, end = ends
    _check_contact(end - start + overlap)
    order = np.arange(1, harmonics + 1)
    wave = np.exp(-2j * np.pi * order * end) - np.exp(-2j * np.pi * order * start)
    pairs = np.concatenate(([end - start], 1j * wave / (2.0 * np.pi * order) * np.sinc(order * overlap)))
    coefficients = single * step * pairs
    coefficients[0] += single * (1.0 - step)
    return curve_of(coefficients, "ISO 6336-1:2006, two levels")


def _check_contact(ratio: float) -> None:
    """Refuse a total contact ratio below 1: some of the time no tooth would touch."""
    if not ratio >= 1.0:
        message = f"{ratio:.3f} given; a mesh needs at least 1: longer teeth, less profile shift or more overlap"
        raise DesignError([Problem("contact_ratio", message)])
