"""The envelope encloses what is drawn: rings, parallel axes and the longest row of shafts."""

from __future__ import annotations

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.arrangement import envelope
from gearwright.spec import read


def test_an_in_line_gearbox_is_as_wide_as_its_larger_ring_and_as_long_as_its_row() -> None:
    sizing = size(read(shipped_design("in-line-h2")))
    ring = next(gear for gear in sizing.gears if gear.name == "second.ring")
    box = envelope(sizing)
    assert box.width == box.height == pytest.approx(ring.pitch_diameter + 2.0 * ring.rim)
    rings = sum(gear.face_width for gear in sizing.gears if gear.role == "ring")
    assert box.length == pytest.approx(sum(shaft.length for shaft in sizing.shafts) + rings)


def test_parallel_axes_widen_the_box_by_their_distance() -> None:
    sizing = size(read(shipped_design("off-set")))
    wheel, lay = (next(gear for gear in sizing.gears if gear.name == name) for name in ("second.wheel", "first.wheel"))
    box = envelope(sizing)
    across = abs(sizing.shafts[1].axis[0] - sizing.shafts[2].axis[0]) + abs(
        sizing.shafts[1].axis[1] - sizing.shafts[2].axis[1]
    )
    assert max(box.width, box.height) >= across + lay.pitch_diameter
    assert min(box.width, box.height) >= wheel.pitch_diameter
    assert box.length == pytest.approx(max(shaft.length for shaft in sizing.shafts))


def test_the_volume_is_that_of_the_box() -> None:
    box = envelope(size(read(shipped_design("mixed"))))
    assert box.volume == pytest.approx(box.width * box.height * box.length)
