"""What the search for teeth takes where several choices are as light, and gears that pairs share."""

import pytest

from designs import PAIR
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import edited, parse, read
from gearwright.study import for_engine
from gearwright.units import RPM


@pytest.mark.parametrize("scale", [0.7, 1.0, 1.0 + 1e-13, 1.9])
def test_of_pairs_that_are_as_light_the_one_of_fewest_teeth_is_taken(scale):
    """At ratio 1 flanks ask m³ ~ (T/z)(2/z), so that 2 z² m³ is the same for all z: rounding must not choose."""
    design = for_engine(
        read(shipped_design("in-line-h1")), power=900e3, engine_speed=33000 * RPM, propeller_speed=1700 * RPM
    )
    power = design.motors["electric"].power * scale / 1e3
    motor = {"motors.electric.power_kw": power, "motors.electric.mass_kg": 30}  # 838 kW are no rotor's at 33 000 rpm
    teeth = size(edited(design, motor)).teeth
    assert (teeth["motor-stage.pinion"], teeth["motor-stage.wheel"]) == (15, 15)


CHAIN = PAIR.replace('["fast", "slow"]', '["fast", "first", "second", "slow"]').replace(
    'wheel = "slow"', 'wheel = "first"'
)
CHAIN += """\
[pairs.next]
pinion = "stage.wheel"
wheel = "second"

[pairs.last]
pinion = "next.wheel"
wheel = "slow"
"""


def test_gears_in_a_chain_of_pairs_have_one_module():
    """The last pair shares a gear of a pair that shares one itself; gears of two modules do not mesh."""
    sizing = size(parse(CHAIN))
    assert len({gear.module for gear in sizing.gears}) == 1
    given = size(edited(sizing.design, {"pairs.stage.module_mm": 4.0}))
    assert {gear.module for gear in given.gears} == {0.004}
