"""What the search for teeth takes where several choices are as light."""

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import edited, read
from gearwright.study import for_engine
from gearwright.units import RPM


@pytest.mark.parametrize("scale", [0.7, 1.0, 1.0 + 1e-13, 1.9])
def test_of_pairs_that_are_as_light_the_one_of_fewest_teeth_is_taken(scale):
    """At ratio 1 flanks ask m³ ~ (T/z)(2/z), so that 2 z² m³ is the same for all z: rounding must not choose."""
    design = for_engine(
        read(shipped_design("in-line-h1")), power=900e3, engine_speed=33000 * RPM, propeller_speed=1700 * RPM
    )
    teeth = size(edited(design, {"motors.electric.power_kw": design.motors["electric"].power * scale / 1e3})).teeth
    assert (teeth["motor-stage.pinion"], teeth["motor-stage.wheel"]) == (15, 15)
