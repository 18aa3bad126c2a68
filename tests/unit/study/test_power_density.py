"""Power density over the gearbox alone, and over gearbox and motor as the thesis's appendix has it."""

from __future__ import annotations

import pytest

import gearwright as gw
from gearwright.shipped import shipped_study
from gearwright.sizing.answers import named_results
from gearwright.spec.studies import read_study


def test_both_densities_are_offered_and_differ_by_the_motor():
    """P/m of In-Line H2, P = 1046 + 1005 kW; the motor makes about a third of the whole."""
    sizing = gw.size(gw.read("in-line-h2"))
    results = {name: result.value for name, result in named_results(sizing).items()}
    assert results["power_density"] * sizing.mass == pytest.approx(2051e3, rel=1e-12)
    assert results["total_power_density"] * (sizing.mass + sizing.motor_mass) == pytest.approx(2051e3, rel=1e-12)
    assert sizing.motor_mass > 20.0


def test_densities_of_a_train_without_motor_are_one():
    sizing = gw.size(gw.read("in-line"))
    assert sizing.total_power_density == sizing.power_density


def test_study_of_power_density_compares_by_the_appendix_and_by_the_gearbox():
    assert read_study(shipped_study("power-density")).results[:2] == ["total_power_density", "power_density"]
