"""Face gears, supports and errors in a design file: what is refused, and with which words."""

from __future__ import annotations

import pytest

from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.spec import parse

TEXT = shipped_design("face-gear-split-torque").read_text(encoding="utf-8")

BAD = {
    "axis_angle_deg = 90                 # *\n": ("", "pairs.first.axis_angle_deg: a face-gear pair needs the angle"),
    "axis_angle_deg = 90": ("axis_angle_deg = 80", "80 deg is not understood"),
    'kind = "face"\n': ("", "only face gears have one"),
    "radial_n_m = 1e7": (
        "radial_n_m = 0",
        "supports.input.radial_n_m: 0 n_m is not allowed; give a value greater than 0",
    ),
    "backlash_um = 100": ("backlash_um = -1", "give a value at least 0 um"),
    "[supports.output]": ("[supports.outputs]", "there is no shaft 'outputs'; did you mean output?"),
    '[errors."first.pinion"]': ('[errors."first.pinyon"]', "no such gear, shaft or planet; did you mean first.pinion?"),
    "[errors.output]\n": ("[errors.output]\nclocking_deg = 1\n", "clocking belong to a gear"),
    "[errors.input]\n": ("[errors.input]\npin_radial_um = 1\n", "only planets have pins"),
    'eccentricity_um = 25\n\n[errors."first.wheel.left"]': ("eccentricity_um = -25\n\n[errors.left2]", "at least 0 um"),
}


@pytest.mark.parametrize("place", BAD)
def test_bad_input_is_named_with_its_cure(place):
    written, words = BAD[place]
    assert place in TEXT
    with pytest.raises(DesignError) as caught:
        parse(TEXT.replace(place, written, 1))
    assert words in str(caught.value)
