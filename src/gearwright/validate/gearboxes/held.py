"""Sums of parts held against published masses: bias, scatter, exponent, and the fit of the two constants."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import PublishedGearbox
from gearwright.sizing import Sizing, size
from gearwright.sizing.mass import CALIBRATED, Calibration, CompleteMass, summed
from gearwright.validate.gearboxes.designs import design_of

SHARES = tuple(float(share) for share in np.geomspace(0.02, 0.5, 41))
"""Stress shares that the fit tries [-]."""
DETAILS = (0.0, 0.6)
"""Details that the fit may find [-]: none, to more than half as much again."""


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
        return summed(self.sizing, constants, films=self.gearbox.kind == "geared-fan")


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


def fitted(rows: Sequence[Held], weights: Floats | None = None) -> Calibration:
    """Return the two constants of least squares in the logarithms of the masses.

    Args:
        rows: Published gearboxes.
        weights: Of each [-]; left out: every family of one source weighs as much as any other.
    """
    tried = [_tabled(row) for row in rows]
    heavy = family_weights(rows) if weights is None else weights
    return _best(tried, np.array([row.gearbox.mass for row in rows]), heavy)


def left_out(rows: Sequence[Held]) -> tuple[tuple[float, ...], tuple[Calibration, ...]]:
    """Return the mass of every gearbox with constants that are fitted to the others alone, and these.

    Args:
        rows: Published gearboxes.
    """
    tried = [_tabled(row) for row in rows]
    published, masses, constants = np.array([row.gearbox.mass for row in rows]), [], []
    for k, row in enumerate(rows):
        others = [j for j in range(len(rows)) if j != k]
        heavy = family_weights([rows[j] for j in others])
        found = _best([tried[j] for j in others], published[others], heavy)
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


def _tabled(row: Held) -> Callable[[float], tuple[float, float]]:
    """Return share -> what details are a share of, and the rest of the mass [kg]; between tried shares by lines."""
    sums = [row.mass(Calibration(share, 0.0, 1.0)) for share in SHARES]
    plain = [sum(item.total for item in mass.parts) for mass in sums]
    counted = [sum(item.total for item in mass.parts if item.group not in ("lubrication", "details")) for mass in sums]
    logs = np.log(SHARES)
    return lambda share: (
        float(np.interp(math.log(share), logs, counted)), float(np.interp(math.log(share), logs, plain))
    )  # fmt: skip


def _best(tried: Sequence[Callable[[float], tuple[float, float]]], published: Floats, weights: Floats) -> Calibration:
    """Return the best of the shares with the details that suit it."""
    least, best = math.inf, CALIBRATED
    for share in SHARES:
        counted, plain = np.array([table(share) for table in tried]).T
        for details in np.linspace(*DETAILS, 61):
            errors = np.log((plain + details * counted) / published)
            square = float(weights @ errors**2)
            if square < least:
                least, best = square, Calibration(share, float(details), CALIBRATED.scatter)
    return best
