"""Oils that cannot be, and keys of bearing lives that nothing reads, are told by their paths."""

import pytest

from designs import PAIR, problems
from gearwright.shipped import shipped_design
from gearwright.spec import parse

ISO = '[gears]\nrating = "iso6336"\n'


@pytest.mark.parametrize(
    ("text", "path"),
    [
        ("[oil]\nviscosity_40 = 10\nviscosity_100 = 20\n", "oil.viscosity_100"),
        (f"{ISO}[gears.iso6336]\noil_viscosity = 10\noil_viscosity_100 = 10\n", "gears.iso6336.oil_viscosity_100"),
        ("[pairs.stage.gears.iso6336]\noil_viscosity = 10\noil_viscosity_100 = 11\n",
         "pairs.stage.gears.iso6336.oil_viscosity_100"),
        ("[bearing_rules]\nreliability = 0.95\n", "bearing_rules.reliability"),
    ],
)  # fmt: skip
def test_what_cannot_be_or_is_read_by_nothing_is_told(text, path):
    assert path in {problem.path for problem in problems(PAIR + text)}


def test_a_compound_set_has_its_own_oil():
    text = shipped_design("wolfrom-reducer").read_text(encoding="utf-8")
    name = next(iter(parse(text).epicyclics))
    own = (
        f'\n[epicyclics.{name}.gears]\nrating = "iso6336"\niso6336 = {{ oil_viscosity = 10, oil_viscosity_100 = 12 }}\n'
    )
    assert f"epicyclics.{name}.gears.iso6336.oil_viscosity_100" in {problem.path for problem in problems(text + own)}


def test_an_oil_that_thins_is_none():
    assert parse(PAIR + "[oil]\nviscosity_40 = 30\nviscosity_100 = 5\n").oil.viscosity_100 == 5.0
