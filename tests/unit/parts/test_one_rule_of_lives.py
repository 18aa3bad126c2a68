"""S-N curves of every standard: life factor and endured cycles are inverses, and a life may be told in any parts."""

import itertools
import math
import random

import numpy as np
import pytest

from gearwright.parts import agma2001, agma2003
from gearwright.parts.iso6336 import (
    StressBin,
    Treatment,
    bending_life_curve,
    contact_life_curve,
    endurable_cycles,
    knee_curve,
    life_factor,
    spectrum_damage,
)

ENDS = (0.85, 0.93, 1.0)
CURVES = (
    *(contact_life_curve(steel, some_pitting=some, at_1e10=end)
      for steel, some, end in itertools.product(Treatment, (False, True), ENDS)),
    *(bending_life_curve(steel, at_1e10=end) for steel, end in itertools.product(Treatment, ENDS)),
    knee_curve(5e9, 30.0, greatest=1.2), knee_curve(1e4, 3.0, greatest=1.5, at_1e10=0.5),
    knee_curve(3e6, 9.0, greatest=2.5),
    agma2001.BENDING_HB160, agma2001.BENDING_HB250, agma2001.BENDING_HB400, agma2001.BENDING_CARBURISED,
    agma2001.BENDING_NITRIDED, agma2001.PITTING, agma2001.PITTING_NITRIDED,
    agma2003.CONTACT, agma2003.BENDING, agma2003.BENDING_CRITICAL,
)  # fmt: skip
"""Of ISO 6336 (and so of ISO 10300 and DIN 3990), of materials of a user's own, of AGMA 2001 and AGMA 2003."""
SPECTRA = 300


def spectra(count: int):
    """Yield curves with loads, each a part of the strength and its cycles: from single turns to far beyond 1e10."""
    rng = random.Random(11)
    for _ in range(count):
        loads = [(rng.uniform(0.3, 1.2), 10.0 ** rng.uniform(0.0, 12.5)) for _ in range(rng.choice((1, 1, 2, 4)))]
        yield rng.choice(CURVES), loads, rng


def safety(curve, loads):
    return spectrum_damage([StressBin(*load) for load in loads], 1.0, curve).safety


def test_endured_cycles_are_the_inverse_of_the_life_factor_however_many():
    """N of f(N) is N and f of N(f) is f, from the first corner to 1e13 cycles; all is borne below a flat last line."""
    for curve in CURVES:
        for cycles in np.geomspace(1.001 * curve.cycles[0], 1e13, 60):
            factor = float(life_factor(curve, cycles))
            if factor <= curve.factors[-1] == curve.factors[-2]:
                assert endurable_cycles(curve, factor) == math.inf
            else:
                assert endurable_cycles(curve, factor) == pytest.approx(cycles, rel=1e-9)
                assert life_factor(curve, endurable_cycles(curve, factor)) == pytest.approx(factor, rel=1e-12)
        assert life_factor(curve, 0.0) == pytest.approx(curve.factors[0], rel=1e-12)
        assert endurable_cycles(curve, 1.0001 * curve.factors[0]) == 0.0


def test_the_safety_of_one_load_is_its_life_factor_over_its_stress():
    for curve, cycles in itertools.product(CURVES, np.geomspace(1.0, 1e13, 30)):
        assert safety(curve, [(0.7, cycles)]) == pytest.approx(float(life_factor(curve, cycles)) / 0.7, rel=1e-9)


def test_a_life_in_equal_parts_is_the_life():
    """Miner 1945: N/k cycles k times are N cycles."""
    for curve, loads, rng in spectra(SPECTRA):
        whole = safety(curve, loads)
        for parts in (2, 3, 7):
            split = [(stress, cycles / parts) for stress, cycles in loads for _ in range(parts)]
            rng.shuffle(split)
            assert safety(curve, split) == pytest.approx(whole, rel=1e-9)


def test_an_easier_part_never_lowers_the_safety():
    """Where any part of a load is made less, the safety is not below what it was."""
    for curve, loads, rng in spectra(SPECTRA):
        whole = safety(curve, loads)
        changed = rng.randrange(len(loads))
        stress, cycles = loads[changed]
        part = rng.random()
        halves = [(stress, (1.0 - part) * cycles), (rng.random() * stress, part * cycles)]
        assert safety(curve, loads[:changed] + halves + loads[changed + 1 :]) >= whole * (1.0 - 1e-9)
