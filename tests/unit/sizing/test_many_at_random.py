"""Batches at random: a row is what its design is alone, to the last bit, whatever stands beside it or came before."""

import functools
import sys

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from designs import HYBRID
from gearwright.errors import DesignError
from gearwright.sizing import named_results, size, size_many
from gearwright.spec import edited, parse

BEVEL = parse("""
schema = 1
name = "square drive"
level = "concept"
shafts = ["engine", "mast"]
[turbines.turbine]
shaft = "engine"
power_kw = 300
speed_rpm = 6000
[propellers.rotor]
shaft = "mast"
speed_rpm = 2400
diameter_m = 4
[pairs.square]
kind = "bevel"
axis_angle_deg = 90
pinion = "engine"
wheel = "mast"
[gears]
rating = "iso6336"
""")
DESIGN = parse(HYBRID)
NAMES = [name for name, number in named_results(size(DESIGN)).items() if number.dimension != "text"]
VALUES = {
    "turbines.turbine.power_kw": st.floats(50.0, 4000.0),
    "turbines.turbine.speed_rpm": st.floats(15_000.0, 22_000.0),
    "motors.electric.speed_rpm": st.one_of(st.floats(2500.0, 7000.0), st.just(np.nan)),
    "propellers.propeller.speed_rpm": st.one_of(st.floats(900.0, 2500.0), st.just(4400.0)),
    "planetaries.first.planets": st.integers(2, 7),
    "planetaries.second.planets": st.integers(3, 6),
    "planetaries.second.module_mm": st.floats(1.0, 6.0),
    "gears.material": st.sampled_from(["16MnCr5", "42CrMo4", "no such steel"]),
    "gears.bending_safety": st.floats(1.0, 3.0),
    "gears.mesh_efficiency": st.floats(0.97, 1.0),
    "gears.face_width_ratio": st.floats(6.0, 14.0),
    "teeth.speed_tolerance": st.sampled_from([0.02, 0.05, 0.1]),
    "carriers.fill": st.floats(0.2, 1.0),
    "service.application_factor": st.floats(1.0, 1.5),
}
"""Path -> what stands in its column, beside nothing."""


@st.composite
def tables(draw: st.DrawFn) -> dict[str, list[float | int | str | None]]:
    """Return columns of some paths, of one length, with gaps."""
    rows = draw(st.integers(1, 4))
    paths = draw(st.lists(st.sampled_from(sorted(VALUES)), min_size=1, max_size=4, unique=True))
    return {path: draw(st.lists(st.none() | VALUES[path], min_size=rows, max_size=rows)) for path in paths}


def kept() -> list[functools._lru_cache_wrapper]:
    """Return what keeps its answers, of formulas and of readers of designs; tables of the catalogue are left out."""
    rooms = ("gearwright.parts", "gearwright.spec.design", "gearwright.train", "gearwright.sizing")
    names = [vars(module) for name, module in sys.modules.items() if name.startswith(rooms)]
    return [value for own in names for value in own.values() if isinstance(value, functools._lru_cache_wrapper)]


KEPT = kept()


def forget() -> None:
    """Forget what formulas keep of what they were asked before."""
    for formula in KEPT:
        formula.cache_clear()


def alone(cells: dict[str, float | int | str | None]) -> dict[str, float] | None:
    """Return every number of a design that is sized by itself, after nothing else; None where it is refused."""
    forget()
    try:
        sizing = size(edited(DESIGN, {path: cell for path, cell in cells.items() if cell is not None}))
    except DesignError:
        return None
    return {name: float(number.value) for name, number in named_results(sizing).items() if number.dimension != "text"}


def bits(columns: dict[str, np.ndarray], row: int) -> dict[str, bytes]:
    """Return the numbers that a row has, by their bits."""
    return {name: values[row].tobytes() for name, values in columns.items() if not np.isnan(values[row])}


@settings(max_examples=12)
@given(axes=tables(), order=st.randoms(use_true_random=False))
def test_a_row_of_any_table_is_its_design_alone_in_any_order_and_any_part(axes, order):
    rows = range(len(next(iter(axes.values()))))
    whole = size_many(DESIGN, axes, results=NAMES)
    mixed = order.sample(rows, len(rows))
    permuted = size_many(DESIGN, {path: [cells[row] for row in mixed] for path, cells in axes.items()}, results=NAMES)
    for place, row in enumerate(mixed):
        one = size_many(DESIGN, {path: cells[row : row + 1] for path, cells in axes.items()}, results=NAMES)
        expected = alone({path: cells[row] for path, cells in axes.items()})
        found = bits(whole.columns, row)
        assert found == bits(permuted.columns, place) == bits(one.columns, 0)
        assert whole.reasons.get(row) == permuted.reasons.get(place) == one.reasons.get(0)
        assert whole.sized[row] == (expected is not None)
        numbers = {} if expected is None else expected
        assert found == {name: np.float64(numbers[name]).tobytes() for name in NAMES if name in numbers}


def test_what_formulas_keep_can_be_forgotten():
    """Or else the rows above are never sized after nothing."""
    from gearwright.parts.iso6336 import Treatment, contact_life_curve

    contact_life_curve(Treatment.CASE_HARDENED)
    assert contact_life_curve.cache_info().currsize > 0
    forget()
    assert contact_life_curve.cache_info().currsize == 0


def test_a_bevel_pair_is_the_same_whatever_was_rated_before():
    """Root sections, life factors and film constants of bevel teeth are kept from pair to pair."""
    warm = [size(edited(BEVEL, {"turbines.turbine.power_kw": power})) for power in (300.0, 500.0, 300.0)]
    forget()
    cold = size(edited(BEVEL, {"turbines.turbine.power_kw": 300.0}))
    assert named_results(warm[0]) == named_results(warm[2]) == named_results(cold)


def test_columns_know_no_row_of_none():
    assert len(size_many(DESIGN, {path: [] for path in VALUES}, results=NAMES)) == 0
    with pytest.raises(DesignError, match="is no row"):
        size_many(DESIGN, {path: [] for path in VALUES}).at(0)
