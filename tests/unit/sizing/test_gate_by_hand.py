"""The quick look through the gate says what the slow one says, of every kind of value."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Annotated

import pytest

from gearwright.identity import Role
from gearwright.sizing.answers import _swallows
from gearwright.sizing.result import _is_number, _numbers_of, _wrong
from gearwright.units import Endless, Life


@dataclass(frozen=True)
class Part:
    size: float = 1.0
    turns: Annotated[Life, Endless()] = 2.0
    pair: Annotated[tuple[float, ...], Endless()] = (1.0, 2.0)
    maybe: Annotated[float | None, Endless()] = None
    fatigue_life: float = 3.0
    by_case: Mapping[str, float] = field(default_factory=dict)
    role: Role | None = None
    text: str = "nan"


@dataclass(frozen=True)
class Holder:
    parts: tuple[Part, ...]


GOOD = [
    1.0, 3, "inf", True, None, Role.SUN, (1.0, (2.0, "x")), {"a": 1.0}, Part(), Part(turns=math.inf),
    Part(maybe=math.inf), Part(pair=(1.0, math.inf)), Holder((Part(), Part(turns=math.inf))),
    MappingProxyType({"a": 2.0}),
]  # fmt: skip
BAD = [
    math.nan, math.inf, -math.inf, (1.0, math.nan), {"a": math.inf}, Part(size=math.inf), Part(turns=math.nan),
    Part(fatigue_life=math.inf), Part(maybe=math.nan), Part(pair=(math.nan,)), Part(by_case={"a": math.inf}),
    Holder((Part(), Part(size=math.nan))), MappingProxyType({"a": math.nan}),
    Part(by_case=MappingProxyType({"x": math.inf})),
]  # fmt: skip


@pytest.mark.parametrize("value", GOOD)
def test_what_may_be_passes_both(value):
    assert _is_number(value) is True
    assert list(_wrong(value, "")) == []


@pytest.mark.parametrize("value", BAD)
def test_what_is_none_passes_neither(value):
    assert _is_number(value) is False
    assert len(list(_wrong(value, ""))) == 1


def test_a_life_may_be_endless_and_no_more():
    assert _is_number(math.inf, endless=True)
    assert _is_number((1.0, math.inf), endless=True)
    assert not _is_number(math.nan, endless=True)
    assert not _is_number({"a": math.inf}, endless=True)
    assert _is_number(MappingProxyType({}), endless=True)


def test_fields_that_may_be_endless_are_known_by_their_marks():
    """A word is none by its declared type; what may be a role or nothing is looked at."""
    assert dict(_numbers_of(Part)) == {
        "size": False, "turns": True, "pair": True, "maybe": True, "fatigue_life": False, "by_case": False,
        "role": False,
    }  # fmt: skip
    assert _numbers_of(list) == ()


@pytest.mark.parametrize(
    ("powers", "swallows"),
    [([-5.0, -3.0], True), ([-5.0, 0.0], True), ([-5.0, 4e-9], True), ([-5.0, 6e-9], False), ([-5.0, 5.0], False),
     ([0.0, 0.0], False), ([3.0, 2.0], False), ([], False)],
)  # fmt: skip
def test_a_stage_swallows_what_it_gets_where_it_gives_nothing_beside_rounding(powers, swallows):
    assert _swallows(powers) is swallows
