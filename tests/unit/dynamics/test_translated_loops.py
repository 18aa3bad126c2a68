"""Functions in a small part of Python do as machine code what they do as Python, to the last bit."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest

from driven_train import driven_state, driven_train
from gearwright.arrays import Floats, Ints
from gearwright.dynamics.codegen import address, excitation as laws
from gearwright.dynamics.codegen.loops import Room, at, library, packed

HALF = 0.5


class Given(NamedTuple):
    """A record as compiled loops read it."""

    count: int
    scale: float
    values: Floats
    marks: Ints


def mixed(one: float, other: float) -> float:
    """Return a sum, by a constant of the module."""
    return one + HALF * other


def summed(c: Given, skipped: int) -> float:
    """Return what every kind of statement makes of a record's numbers."""
    total = 0.0
    for i in range(1, c.count, 2):
        if c.marks[i] > 2 and not c.values[i] < 0:
            total = mixed(total, c.values[i] * c.scale) - math.cos(i * 1.0)
        elif i == skipped:
            continue
        else:
            total -= 1
        if total > 1e3 or total != total:
            break
    number = 7
    while number % 4 != 0 or number == skipped:
        number -= 1
        c.marks[number] = number // 2
    rest, least = at(c.values, 1), min(abs(total), number, 9.5)
    rest[0], rest[1] = (-7.5 if 3 <= number < 5 else total), max(least, c.scale) / 3
    return total


def given(seed: int) -> Given:
    rng = np.random.default_rng(seed)
    return Given(40, 0.3, rng.normal(size=40), rng.integers(0, 6, 40))


@pytest.mark.parametrize("seed", range(5))
def test_compiled_functions_are_the_same_in_python(seed: int) -> None:
    mine, its = given(seed), given(seed)
    code, record = library(mixed, summed).function("summed"), packed(its)
    assert code(address(record), 7) == summed(mine, 7)
    np.testing.assert_array_equal(mine.values, its.values)
    np.testing.assert_array_equal(mine.marks, its.marks)


def test_a_record_in_one_piece_is_had_anew_as_it_was_given() -> None:
    room, code = Room(given(0)), library(mixed, summed).function("summed")
    first = room.fresh()
    answers = [code(first.place, 7), code(room.fresh().place, 7)]
    assert answers[0] == answers[1] == summed(given(0), 7)
    assert np.any(first.values != given(0).values)


def test_what_is_not_known_is_named() -> None:
    def wrong(x: float) -> float:
        return x**2.5

    with pytest.raises((KeyError, NotImplementedError)):
        library(wrong)


@pytest.mark.parametrize("seed", range(3))
def test_laws_are_the_same_in_python(seed: int) -> None:
    """Of a propeller by its map with its governor, to the last bit."""
    drives, (_, v, x) = driven_train().arrays.drives, driven_state(driven_train(), seed)
    numbers, read, speed = drives.table[10:].copy(), np.array([1.2, 60.0, 120.0, 0.01]), 110.0 + v[0]
    mine, its = (np.zeros(6), np.zeros(6))
    wanted = laws.propeller_law(numbers, read, x, mine[:3], mine[3:], speed)
    places = [address(part) for part in (numbers, read, x, its[:3], its[3:])]
    code = library(laws.cell_of, laws.map_power, laws.govern, laws.propeller_law, laws.machine_law, laws.clutch_law)
    assert code.function("propeller_law")(*places, speed) == wanted
    np.testing.assert_array_equal(mine, its)
