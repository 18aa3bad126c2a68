"""Tables 1.3-1.15 of Pulvirenti (2023) come out, or are flagged with the reason."""

import pytest

from gearwright.catalogue import all_series, engines
from gearwright.weights import Verdict, checked_engines, gearbox_mass

FINE = (Verdict.AGREES, Verdict.ROUNDED)
ROWS = {"PW100": 28, "PT6A-60": 13, "PT6T-3": 8, "PW210": 3, "PW200": 12, "AE2100": 3, "M250": 11}
ROWS |= {"CT7 turboprop": 5, "CT7 turboshaft": 15, "H80": 7, "M601": 14, "Catalyst": 1, "TPE331": 1}


def row(model):
    return next(one for one in checked_engines() if one.engine.model == model)


def test_there_are_121_engines_in_thirteen_tables():
    """Pulvirenti 2023, tables 1.3-1.15."""
    counts = {one.name: sum(engine.series is one for engine in engines()) for one in all_series()}
    assert counts == ROWS


def test_every_printed_number_agrees_within_print_rounding_or_is_flagged_with_a_reason():
    """Rounding as the printed digits of a number and of the inputs of its row allow."""
    for one in checked_engines():
        for check in one.checks:
            if check.verdict not in (*FINE, Verdict.BLANK):
                assert check.reason
                assert (one.engine.series.name, one.engine.model) in {
                    *(("CT7 turboshaft", engine.model) for engine in engines()),
                    ("M250", "B15A"),
                    ("M250", "B15G"),
                    ("TPE331", "TPE331"),
                }


def test_the_rule_of_each_series_reproduces_every_printed_mass_but_three():
    """NASA'15 with the engine speed of the series; M250 B15A and B15G miss the last digit, TPE331 follows no rule."""
    missed = [
        one.model
        for one in engines()
        if not one.as_printed("gearbox_mass_kg").bounds[0]
        <= gearbox_mass(one)
        <= one.as_printed("gearbox_mass_kg").bounds[1]
    ]
    assert missed == ["B15A", "B15G", "TPE331"]


def test_no_gearbox_mass_is_flagged_that_agrees():
    """A last digit or a difference that is noted is there in the numbers; half a digit is the limit."""
    for one in checked_engines():
        check = one.check("gearbox_mass_kg")
        if check.verdict in (Verdict.LAST_DIGIT, Verdict.DIFFERS):
            assert abs(check.difference) > check.printed.half_digit


def test_the_misplaced_numbers_of_the_tpe331_are_read_where_they_belong():
    """Table 1.15: 4.36 is Pd_engine and 14.7 is Pd_GB, so m_engine = 174.4 kg, Qd = 20.8, %GB = 29.7, Pd_GT = 6.20."""
    one = row("TPE331")
    assert sum(one.engine_mass) / 2 == pytest.approx(174.4, abs=0.1)
    assert one.check("torque_nm_kg").computed == pytest.approx(20.8, abs=0.05)
    assert one.check("gearbox_percent").computed == pytest.approx(29.7, abs=0.05)
    assert one.check("turbine_kw_kg").computed == pytest.approx(6.20, abs=0.005)
    assert one.check("gearbox_mass_kg").computed == pytest.approx(60.6, abs=0.05)
    assert one.check("engine_kw_kg").verdict is Verdict.BLANK


def test_an_engine_mass_reproduces_the_densities_of_every_row_at_once():
    """Pd_engine, Pd_GT, Qd and %GB hold one unknown; the interval is below two per cent of the mass of each engine."""
    for one in checked_engines():
        least, greatest = one.engine_mass
        assert 0.0 < greatest - least < 0.02 * least


def test_the_engine_mass_of_the_pw127_is_about_480_kilograms():
    """2051 kW at the printed 4.27 kW/kg is 480.3 kg, ± 0.6 kg by the rounding of 4.27."""
    least, greatest = row("PW127").engine_mass
    assert 479.8 < least < greatest < 480.9


def test_the_gearbox_columns_of_the_ct7_turboshaft_are_meaningless_but_its_power_density_is_not():
    """Table 1.11: 1384 rpm is the propeller speed of the turboprop."""
    one = row("CT7-8F5")
    assert not one.engine.has_gearbox
    assert one.check("gearbox_mass_kg").verdict is Verdict.MEANINGLESS
    assert one.check("engine_kw_kg").verdict in FINE
