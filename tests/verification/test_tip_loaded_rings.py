"""A ring's tooth loaded at its tip: lever and angle as they are drawn, in coordinates of the ring."""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest

from gearwright.parts.iso6336 import MeshGeometry, ShaperCutter, ToothProportions
from gearwright.parts.iso6336.geometry import Edition, outer_single_contact, root_section, tip_loaded

ANGLE = math.radians(20.0)
MESH = MeshGeometry(
    (24.0, -79.0), 3e-3, 30e-3, 82.5e-3, (39e-3, 115.8e-3),
    proportions=(ToothProportions(), ToothProportions(1.25, 0.3, cutter=ShaperCutter(30.0))),
)  # fmt: skip


def drawn(radius):
    """Return where the load at a radius cuts the tooth's centre line, and how far it leans from its normal.

    The ring's centre is the origin, the tooth's centre line the real axis, lengths in modules. The spaces of a ring
    are the teeth of an external gear of as many. The load touches the base circle and pushes out into the rim.
    """
    base = 0.5 * 79.0 * math.cos(ANGLE)
    pressure = math.acos(base / radius)
    space = math.pi / (2.0 * 79.0) + math.tan(ANGLE) - ANGLE - math.tan(pressure) + pressure
    point = cmath.rect(radius, math.pi / 79.0 - space)
    tangents = [base * cmath.exp(1j * (cmath.phase(point) + sign * pressure)) for sign in (-1.0, 1.0)]
    loads = [(point - touch) / abs(point - touch) for touch in tangents]
    load = next(each for each in loads if each.imag < 0.0 and each.real > 0.0)
    return (point - load * point.imag / load.imag).real, math.atan2(load.real, -load.imag)


def test_lever_and_angle_are_those_of_the_drawn_tooth():
    """The critical section does not move with the load, so that levers differ as the points on the centre line do."""
    tip, single = tip_loaded(MESH, 1), outer_single_contact(MESH, 1)
    assert float(tip.load_diameter) == pytest.approx(-2.0 * 115.8 / 3.0, rel=1e-12)
    sections = root_section(tip), root_section(single)
    assert float(sections[0].chord) == pytest.approx(float(sections[1].chord), rel=1e-12)
    found = [drawn(0.5 * abs(float(loaded.load_diameter))) for loaded in (tip, single)]
    roots = [crossing + float(section.lever) for (crossing, _), section in zip(found, sections, strict=True)]
    assert roots[0] == pytest.approx(roots[1], abs=1e-9)
    assert 39.5 < roots[0] < 39.5 + 1.25  # between pitch and root circle
    for (_, leaning), section in zip(found, sections, strict=True):
        assert abs(float(section.load_angle)) == pytest.approx(leaning, rel=1e-9)


@pytest.mark.parametrize("edition", list(Edition))
def test_loads_at_the_tip_bend_more_than_where_single_contact_ends(edition):
    tip, single = (root_section(place(MESH, 1), edition) for place in (tip_loaded, outer_single_contact))
    assert float(tip.form) > float(single.form)


def test_an_array_of_rings_is_loaded_as_each_alone():
    tips = np.array([115.5e-3, 115.8e-3, 116.1e-3])
    every = tip_loaded(replace(MESH, tip_radii=(39e-3, tips)), 1)
    alone = [float(tip_loaded(replace(MESH, tip_radii=(39e-3, float(tip))), 1).load_diameter) for tip in tips]
    assert np.asarray(every.load_diameter) == pytest.approx(alone, rel=1e-15)
