"""Searches of gears that a standard rates, in lanes: every lane has the bits of the function of one design."""

import random

import numpy as np
import pytest

from gearwright.lanes import Diverged, Lanes
from gearwright.parts.iso6336 import StressBin, Treatment, bending_life_curve, contact_life_curve, spectrum_damage
from gearwright.sizing.many import size_many
from gearwright.sizing.many.by_lane import each_lane, of_lane, stacked_lanes
from gearwright.sizing.many.twinned import twinned
from gearwright.sizing.rating.geometry import narrowest, next_standard, strong_enough, under_spectrum

assert size_many  # which changes the twins


def lanes(low: float, high: float, count: int = 40, *, seed: int = 1) -> Lanes:
    """Return numbers between two, evenly in their logarithms."""
    draw = random.Random(seed)
    return Lanes(np.array([low * (high / low) ** draw.random() for _ in range(count)]))


def test_standard_modules_are_those_of_each_lane():
    needed = Lanes(np.r_[lanes(1e-4, 0.1).data, 1e-3, 1e-3 * (1 + 0.9e-9), 1e-3 * (1 + 2e-9), 0.05, 0.0501])
    found = twinned("gearwright.sizing.rating.geometry").next_standard(needed)
    assert found.data.tolist() == [next_standard(value) for value in needed.data.tolist()]


def test_narrowest_faces_are_those_of_each_lane():
    """Loads could grow by b/b_needed; some lanes find it at once, some never."""
    least, widest, needed = lanes(1e-3, 0.05), lanes(0.02, 0.2, seed=2), lanes(5e-3, 0.5, seed=3)
    found = twinned("gearwright.sizing.rating.geometry").narrowest(least, widest, lambda width: width / needed)
    rows = zip(least.data.tolist(), widest.data.tolist(), needed.data.tolist(), strict=True)
    assert found.data.tolist() == [narrowest(low, high, lambda width, own=own: width / own) for low, high, own in rows]


@pytest.mark.parametrize("is_rounded", [True, False])
def test_modules_under_a_spectrum_are_those_of_each_lane(is_rounded):
    """A gap that is a power of the module, so that corrections go on or end early by the lane."""
    start, power = lanes(1e-3, 9e-3), lanes(1.5, 4.0, seed=4)
    twin = twinned("gearwright.sizing.rating.geometry")
    rounded = (twin.next_standard, next_standard) if is_rounded else (None, None)
    found = twin.under_spectrum(start, 10.0, lambda module, width: (module / 4e-3) ** power, rounded[0])
    rows = zip(start.data.tolist(), power.data.tolist(), strict=True)
    alone = [under_spectrum(at, 10.0, lambda module, width, p=p: (module / 4e-3) ** p, rounded[1]) for at, p in rows]
    assert found.data.tolist() == alone


@pytest.mark.parametrize("standard", [True, False])
def test_modules_beyond_a_resonance_are_those_of_each_lane(standard):
    """A gap that asks for a module of its own in every lane: none, one or more steps up, and some in vain."""
    start, needed = next_standard_of(lanes(1e-3, 9e-3)), lanes(0.9, 1.5, seed=5)
    needed = start * needed
    twin = twinned("gearwright.sizing.rating.geometry")
    found = twin.strong_enough(start, lambda module: (module / needed) ** 2, standard=standard)
    rows = list(zip(start.data.tolist(), needed.data.tolist(), strict=True))
    alone = [strong_enough(at, lambda module, d=d: (module / d) ** 2, standard=standard) for at, d in rows]
    assert found.data.tolist() == alone
    assert len({value / at for value, (at, _) in zip(alone, rows, strict=True)}) > 3


def next_standard_of(needed):
    return Lanes(np.array([next_standard(value) for value in needed.data.tolist()]))


@pytest.mark.parametrize("curve_of", [contact_life_curve, bending_life_curve])
def test_safeties_of_spectra_are_those_of_each_lane(curve_of):
    """Three levels of stress, below and above every corner of the curve."""
    twin, curve = twinned("gearwright.parts.iso6336"), curve_of(Treatment.CASE_HARDENED)
    stresses = [lanes(2e8, 1.6e9, seed=seed) for seed in (5, 6, 7)]
    cycles = (1e3, 1e6, 1e9)
    bins = [twin.StressBin(stress, turns) for stress, turns in zip(stresses, cycles, strict=True)]
    found = twin.spectrum_damage(bins, 1.4e9, curve)
    for row in range(len(stresses[0].data)):
        levels = [StressBin(float(stress.data[row]), turns) for stress, turns in zip(stresses, cycles, strict=True)]
        alone = spectrum_damage(levels, 1.4e9, curve)
        assert (found.safety.data[row], found.total.data[row]) == (alone.safety, alone.total)


def test_a_function_of_arrays_is_called_for_those_of_every_lane():
    both = each_lane(lambda pair, scale: (pair[0] @ pair[1] * scale, pair[0] * scale), None)
    first, second = Lanes(np.arange(6.0).reshape(2, 3)), np.array([1.0, 2.0, 3.0])
    product, scaled = both((first, second), 2.0)
    assert product.data.tolist() == [16.0, 52.0] and scaled.data.tolist() == [[0, 2, 4], [6, 8, 10]]
    assert each_lane(None, lambda *values: values)(1, [2.0]) == (1, [2.0])
    assert of_lane({"a": (first, 3)}, 1)["a"][0].tolist() == [3.0, 4.0, 5.0]
    with pytest.raises(Diverged):
        stacked_lanes([np.zeros(2), np.zeros(3)])
