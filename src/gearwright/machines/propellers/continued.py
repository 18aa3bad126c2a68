"""A propeller map in every state of the stream: what is charted stays, blade elements carry it on beyond."""

from __future__ import annotations

import math

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines.propeller_map import PropellerMap
from gearwright.machines.propellers.blade import BladeShape
from gearwright.machines.propellers.elements import loads

FADE = math.radians(8.0)
"""Blade angle in which the seam's offset fades by e [rad]; an assumption."""


def element_map(shape: BladeShape, ratios: Floats, angles: Floats, tip_mach: float = 0.0) -> PropellerMap:
    """Return the map of a propeller by its blade elements, full of points.

    Args:
        shape: The blades.
        ratios: J, rising, not negative [-].
        angles: Blade angles at three quarters of the radius, rising [rad].
        tip_mach: Of the tip's rotation; 0 leaves compressibility out [-].

    Source: `loads`.

    Valid for: axial flow.
    """
    found = loads(shape, ratios[:, None], angles[None, :], tip_mach)
    first, last = (np.full(len(ratios), k, dtype=np.int64) for k in (0, len(angles) - 1))
    return PropellerMap(ratios, angles, found.power, found.thrust, first, last)


def continued(chart: PropellerMap, shape: BladeShape, ratios: Floats, angles: Floats) -> PropellerMap:
    """Return a chart's map carried on by blade elements to other advance ratios and blade angles.

    Args:
        chart: The map that stays as it is.
        shape: Blades of the same propeller.
        ratios: J to be in the map beside the chart's; within the chart's range they are left out [-].
        angles: Blade angles to be in the map beside the chart's [rad].

    Source: beyond the chart's first and last blade angle the elements' coefficients, moved by what the two differ by at
        that seam, which fades by e in 8°; beyond its last advance ratio the elements alone. The map is continuous.
    """
    beyond = ratios[ratios > chart.advance_ratio[-1]]
    ratio = np.concatenate([chart.advance_ratio, beyond])
    angle = np.unique(np.round(np.concatenate([chart.blade_angle, angles]), 9))
    full = element_map(shape, ratio, angle)
    place = np.searchsorted(angle, np.round(chart.blade_angle, 9))
    for row in range(len(chart.advance_ratio)):
        given = slice(int(chart.first[row]), int(chart.last[row]) + 1)
        columns = place[given]
        for table, charted in ((full.power, chart.power), (full.thrust, chart.thrust)):
            table[row] += _offset(angle, angle[columns], charted[row, given] - table[row, columns])
    return full


def _offset(angle: Floats, given: Floats, offset: Floats) -> Floats:
    """Return what moves a row of the elements onto the chart, fading beyond its ends."""
    distance = np.maximum(np.maximum(given[0] - angle, angle - given[-1]), 0.0)
    return np.asarray(np.interp(angle, given, offset) * np.exp(-distance / FADE))
