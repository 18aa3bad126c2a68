"""The engines and the weighed gearboxes as they are stored."""

import pytest

from gearwright.catalogue import Printed, engines, nearest, notes, select, weighed_gearboxes
from gearwright.errors import DesignError
from gearwright.units import RPM


def test_the_digits_of_a_printed_number_say_its_bounds():
    assert Printed("5.00").bounds == pytest.approx((4.995, 5.005), rel=1e-12)
    assert Printed("1342").half_digit == 0.5


def test_the_first_row_is_as_printed():
    """Pulvirenti 2023, table 1.3."""
    first = engines()[0]
    texts = [number.text for _, number in first.printed]
    assert first.model == "PW118"
    assert texts == ["1342", "1313", "124.5", "9760.2", "3.44", "5.04", "10.78", "24.99", "31.87"]


def test_the_ratio_of_the_pw100_gives_the_engine_speed_of_the_pw127():
    """16.67 times 1212 rpm is 20 204 rpm."""
    one = select(model="PW127M")[0]
    assert one.engine_speed == pytest.approx(20204 * RPM, rel=1e-5)


def test_filters_hold_together():
    found = select(manufacturer="pratt", kind="turboprop", power=(2.0e6, 2.1e6))
    assert {one.series.name for one in found} == {"PW100"}
    assert all(2.0e6 <= one.power <= 2.1e6 for one in found)


def test_a_filter_that_nothing_answers_to_names_what_there_is():
    with pytest.raises(DesignError, match=r"M601.*201 to 3781 kW"):
        select(series="Merlin")


def test_every_note_finds_its_row():
    """A misspelt model in the notes would flag nothing."""
    for note in notes():
        assert any(note in one.notes for one in engines())


def test_the_nearest_engine_to_an_engine_is_itself():
    for one in (select(series="Catalyst")[0], select(model="PW150A")[0]):
        assert nearest(one.power, one.engine_speed, one.propeller_speed, count=1) == (one,)


def test_a_turboshaft_without_a_gearbox_is_never_near():
    one = select(series="CT7 turboshaft")[0]
    found = nearest(one.power, one.engine_speed, one.propeller_speed, count=8)
    assert all(near.series.name != "CT7 turboshaft" for near in found)


def test_like_engines_are_shown_once():
    found = nearest(2051e3, 20204 * RPM, 1212 * RPM, count=4)
    assert len({(one.series.name, one.power, one.propeller_speed) for one in found}) == 4


def test_there_are_61_weights_in_the_order_of_beta():
    betas = [one.beta for one in weighed_gearboxes()]
    assert len(betas) == 61
    assert betas == sorted(betas)
