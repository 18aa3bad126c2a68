"""Face gears, supports and errors in a design file: what is refused, and with which words."""

from __future__ import annotations

import pytest

from gearwright.dynamics.assembly import assemble
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse

TEXT = shipped_design("face-gear-split-torque").read_text(encoding="utf-8")

BAD = {
    "axis_angle_deg = 90                 # *\n": ("", "pairs.first.axis_angle_deg: a face-gear pair needs the angle"),
    "axis_angle_deg = 90": ("axis_angle_deg = 80", "80 deg is not understood"),
    'kind = "face"\n': ("", "only face and bevel gears have one"),
    "radial_n_m = 1e7": (
        "radial_n_m = 0",
        "supports.input.radial_n_m: 0 N/m is not allowed; give a value from 1000 to 1e+13 N/m",
    ),
    "backlash_um = 100": ("backlash_um = -1", "give 0 or a value from 0.001 to 10000 µm"),
    "[supports.output]": ("[supports.outputs]", "there is no shaft 'outputs'; did you mean output?"),
    '[errors."first.pinion"]': ('[errors."first.pinyon"]', "no such gear, shaft or planet; did you mean first.pinion?"),
    "[errors.output]\n": ("[errors.output]\nclocking_deg = 1\n", "clocking belong to a gear"),
    "[errors.input]\n": ("[errors.input]\npin_radial_um = 1\n", "only planets have pins"),
    "eccentricity_um = 25": ("eccentricity_um = -25", "give 0 or a value from 0.001 to 100000 µm"),
}


@pytest.mark.parametrize("place", BAD)
def test_bad_input_is_named_with_its_cure(place):
    written, words = BAD[place]
    assert place in TEXT
    with pytest.raises(DesignError) as caught:
        parse(TEXT.replace(place, written, 1))
    assert words in str(caught.value)


def test_face_gear_that_stands_askew_is_refused_with_the_angles_that_do():
    """Its pinion has to lie along an axis of the drawing."""
    design = parse(TEXT.replace("angle_deg = -90", "angle_deg = -80").replace("angle_deg = 90\n", "angle_deg = 100\n"))
    with pytest.raises(DesignError, match="give 0, 90, 180 or -90"):
        assemble(size(design))


def test_given_bodies_and_machines_without_inertia_leave_what_is_written():
    """Six rotations with the file's inertias, no machine beside them."""
    design = parse(TEXT)
    system = assemble(size(design))
    inertia = dict(zip(system.labels.coordinates, system.arrays.mass, strict=True))
    assert inertia["first.pinion"] == pytest.approx(5e-4)
    assert inertia["second.wheel"] == pytest.approx(1.10)
    assert inertia["output.y"] == pytest.approx(45.0)
    assert system.labels.coordinate_units.count("rad") == 6
