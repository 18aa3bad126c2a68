"""Sums of parts held against published masses: bias, scatter, exponent, and the fit of the housing's constant."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import PublishedGearbox
from gearwright.sizing import Sizing, size
from gearwright.sizing.mass import CALIBRATED, Calibration, CompleteMass, summed
from gearwright.validate.gearboxes.designs import design_of

SHARES = tuple(float(share) for share in np.geomspace(0.03, 0.5, 15))
"""Stress shares at which sums are made; between them logarithms of masses lie on lines [-]."""
FINE = np.geomspace(SHARES[0], SHARES[-1], 400)
"""Stress shares that the fit tries [-]."""


@dataclass(frozen=True)
class Held:
    """A published gearbox and its sum of parts."""

    gearbox: PublishedGearbox
    sizing: Sizing

    def mass(self, constants: Calibration = CALIBRATED) -> CompleteMass:
        """Return its complete mass.

        Args:
            constants: With which the sum is made.
        """
        return summed(self.sizing, constants)


@dataclass(frozen=True)
class Score:
    """How computed masses stand to published ones."""

    count: int
    bias: float
    """Geometric mean of computed over published [-]."""
    scatter: float
    """Factor of one standard deviation about it [-]."""
    exponents: tuple[float, float]
    """Slopes of log mass over log torque, published and computed [-]."""


def held(gearboxes: Iterable[PublishedGearbox]) -> tuple[Held, ...]:
    """Return every gearbox sized from its requirement.

    Args:
        gearboxes: Published ones.
    """
    return tuple(Held(gearbox, size(design_of(gearbox))) for gearbox in gearboxes)


def score(rows: Sequence[Held], computed: Sequence[float]) -> Score:
    """Return bias, scatter and exponents of computed masses.

    Args:
        rows: Published gearboxes.
        computed: Their masses [kg].
    """
    published = np.log([row.gearbox.mass for row in rows])
    errors, torque = np.log(computed) - published, np.log([row.gearbox.torque for row in rows])
    slopes = [float(np.polyfit(torque, masses, 1)[0]) for masses in (published, np.log(computed))]
    return Score(
        len(rows), math.exp(errors.mean()), math.exp(errors.std(ddof=min(1, len(rows) - 1))), (slopes[0], slopes[1])
    )


def fitted(rows: Sequence[Held]) -> Calibration:
    """Return the stress share of least squares in the logarithms of the masses; families of one source weigh alike.

    Args:
        rows: Published gearboxes.
    """
    return _best(rows, np.array([_curve(row) for row in rows]))


def left_out(rows: Sequence[Held]) -> tuple[tuple[float, ...], tuple[Calibration, ...]]:
    """Return the mass of every gearbox with a constant that is fitted to the others alone, and these.

    Args:
        rows: Published gearboxes.
    """
    curves, masses, constants = np.array([_curve(row) for row in rows]), [], []
    for k, row in enumerate(rows):
        others = [j for j in range(len(rows)) if j != k]
        found = _best([rows[j] for j in others], curves[others])
        constants.append(found)
        masses.append(row.mass(found).total)
    return tuple(masses), tuple(constants)


def family_weights(rows: Sequence[Held]) -> Floats:
    """Return weights by which the gearboxes of one source count together as one.

    Args:
        rows: Published gearboxes.
    """
    sources = [row.gearbox.source for row in rows]
    return np.array([1.0 / sources.count(source) for source in sources])


def _curve(row: Held) -> Floats:
    """Return the logarithm of a gearbox's mass at every share of `FINE`."""
    masses = [row.mass(CALIBRATED._replace(stress_share=share)).total for share in SHARES]
    return np.interp(np.log(FINE), np.log(SHARES), np.log(masses))


def _best(rows: Sequence[Held], curves: Floats) -> Calibration:
    """Return the share whose masses differ least from the published ones."""
    errors = curves - np.log([row.gearbox.mass for row in rows])[:, None]
    squares = family_weights(rows) @ errors**2
    return CALIBRATED._replace(stress_share=float(FINE[int(np.argmin(squares))]))
