"""What meshes gave is remembered among sizings: the same bits, and no mesh rated twice."""

from unittest.mock import patch

import gearwright as gw
from gearwright.sizing.rating import MESHES
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.spec import at_level, edited

DESIGN = at_level(gw.read("in-line-star"), "preliminary")
OTHERS = [
    DESIGN,
    edited(DESIGN, {"service.life_h": 5000.0}),
    edited(DESIGN, {"gears.iso6336.pitting_safety": 1.1}),
    edited(DESIGN, {"turbines.gas-turbine.power_kw": 900.0}),
    DESIGN,
]


def test_sizings_that_share_what_meshes_gave_have_the_bits_of_each_alone():
    alone = [gw.size(design) for design in OTHERS]
    with MESHES.sharing():
        assert [gw.size(design) for design in OTHERS] == alone


def test_equal_meshes_are_rated_once_within_and_anew_behind():
    counts = []
    rate = Iso6336._rate

    def counted(*arguments):
        counts[-1] += 1
        return rate(*arguments)

    with patch.object(Iso6336, "_rate", counted):
        with MESHES.sharing():
            for _ in range(2):
                counts.append(0)
                gw.size(DESIGN)
        counts.append(0)
        gw.size(DESIGN)
    assert counts[0] > 0 and counts[1] == 0 and counts[2] == counts[0]
