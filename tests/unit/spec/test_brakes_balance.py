"""A brake that holds in a case bears what the machines leave, so that none of them need balance."""

import pytest

from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse

CAR = shipped_design("e-axle").read_text(encoding="utf-8")


def test_every_machine_may_be_stated_where_a_brake_holds():
    """The motor idles and the wheels are stated: the pawl bears 2110 N m over the second ratio."""
    flow = size(parse(CAR)).flows["parked"]
    assert flow.machine_powers == {"motor": 0.0, "wheels": 0.0}
    assert flow.speeds["axle"] == 0.0


def test_without_the_brake_the_same_case_is_refused():
    with pytest.raises(DesignError, match=r"cases\.parked: the power of every machine is given"):
        parse(CAR.replace('engaged = ["parking-lock"]\n', ""))


def test_a_clutch_between_two_shafts_is_no_brake():
    joined = CAR.replace('driven = "ground"\n', 'driven = "axle"\n')
    with pytest.raises(DesignError, match=r"cases\.parked: the power of every machine is given"):
        parse(joined)
