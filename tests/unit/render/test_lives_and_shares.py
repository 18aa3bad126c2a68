"""Figures of bearing lives and of shares round a shaft show the numbers they are given."""

from types import SimpleNamespace

import numpy as np
import pytest

from gearwright.dynamics.sharing import LoadSharing
from gearwright.render.figures.dynamics import around_figure
from gearwright.render.figures.flights import _spectrum
from gearwright.render.figures.masses import aged_bearings, bearing_life_figure
from gearwright.render.vector.figure import Axes, Box, Curve, Shape
from shipped_work import sized


def shared(force):
    """Return the sharing of three paths with these forces at each instant."""
    time = np.linspace(0.0, 1.0, len(force))
    return LoadSharing(("a", "b", "c"), "given", "", time, np.array(force), 0.5)


def test_a_wedge_reaches_as_far_as_the_mean_share_and_the_first_stands_on_top():
    figure = around_figure(shared([[2.0, 1.0, 3.0], [4.0, 1.0, 1.0]]))
    wedges = figure.axes[0].of(Shape)
    reach = [np.hypot(*wedge.points.T).max() for wedge in wedges]
    assert reach == pytest.approx([1.5, 0.5, 1.0])
    middle = wedges[0].points[:-1].mean(axis=0)
    assert middle[0] == pytest.approx(0.0, abs=1e-12)
    assert middle[1] > 0.0
    assert wedges[1].points[:-1].mean(axis=0)[0] > 0.0  # the second to the right: clockwise


def test_a_bar_goes_from_the_least_share_to_the_greatest():
    figure = around_figure(shared([[2.0, 1.0, 3.0], [4.0, 1.0, 1.0]]))
    bars = [curve for curve in figure.axes[0].of(Curve) if len(curve.x) == 2]
    assert np.hypot(bars[0].x, bars[0].y) == pytest.approx([1.0, 2.0])
    assert np.hypot(bars[2].x, bars[2].y) == pytest.approx([0.5, 1.5])


def test_every_loaded_bearing_has_a_bar_as_long_as_its_life_and_a_line_at_the_asked_one():
    sizing = sized("ec120b")
    lives = aged_bearings(sizing)
    axes = bearing_life_figure(lives).axes[0]
    bars = [box.width for box in axes.of(Box)]
    assert bars == pytest.approx([check.value / 3600.0 for check in lives])
    assert bars == sorted(bars)
    assert {curve.x[0] for curve in axes.of(Curve)} == {sizing.design.service.bearing_life / 3600.0}


def test_every_spectrum_is_a_curve_however_many_there_are():
    """More than four times the six colours, behind which curves were left out."""
    axes, load = Axes(), np.array([1.0, 2.0])
    _spectrum(axes, [SimpleNamespace(name=f"gear {k}", load=load, turns=np.array([5.0, 3.0])) for k in range(30)])
    assert [curve.label for curve in axes.of(Curve)] == [f"gear {k}" for k in range(30)]
