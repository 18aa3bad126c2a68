"""Measured duty: the file, what is wrong with it, and the spectrum that it becomes."""

import math
import tomllib

import numpy as np
import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.mission import duty_spectrum, read_duty

GOOD = "time_s,torque_knm,speed_rpm,temperature_c\n0,0,600,20\n10,1,600,30\n30,2,1200,40\n40,-2,1200,50\n100,0,0,60\n"


def written(tmp_path, text):
    """Return the path of a file with a text."""
    path = tmp_path / "duty.csv"
    path.write_text(text, encoding="utf-8")
    return path


def test_units_are_read_from_the_first_line(tmp_path):
    duty = read_duty(written(tmp_path, GOOD))
    assert duty.time.tolist() == [0.0, 10.0, 30.0, 40.0]
    assert duty.duration.tolist() == [10.0, 20.0, 10.0, 60.0]
    assert duty.torque.tolist() == [0.0, 1000.0, 2000.0, -2000.0]
    assert duty.speed == pytest.approx(np.array([600, 600, 1200, 1200]) * math.pi / 30.0)
    assert duty.temperature == pytest.approx([293.15, 303.15, 313.15, 323.15])


@pytest.mark.parametrize(
    "text",
    ["\ufeff" + GOOD, GOOD.replace("\n", "\r\n"), GOOD.replace(",", ";"), GOOD.replace(",", "\t"), "\n" + GOOD],
    ids=["byte order mark", "line ends of Windows", "semicolons", "tabs", "an empty line before it"],
)
def test_what_spreadsheets_write_is_read(text, tmp_path):
    plain, found = read_duty(written(tmp_path, GOOD)), read_duty(written(tmp_path, text))
    assert found.time.tolist() == plain.time.tolist() and found.torque.tolist() == plain.torque.tolist()


def test_lines_are_counted_as_an_editor_counts_them(tmp_path):
    with pytest.raises(DesignError, match="line 5, speed_rpm"):
        read_duty(written(tmp_path, "\ufeff\r\ntime_s;torque_nm;speed_rpm\r\n0;1;1\r\n\r\n1;1;x\r\n"))


def test_every_class_keeps_its_turns_in_the_text(tmp_path):
    """600 rpm for 30 s under 1 kN m, 1200 rpm for 10 s under 2 kN m, 60 s idle at no speed: by hand."""
    text = "time_s,torque_nm,speed_rpm\n0,1000,600\n30,2000,1200\n40,0,0\n100,0,0\n"
    told = tomllib.loads(duty_spectrum(read_duty(written(tmp_path, text)), classes=2).text("m"))
    case, spectrum = told["cases"]["measured"], told["spectra"]["measured"]
    turns = [share * case["duration_s"] * case["m"]["speed_rpm"] / 60.0 for share in spectrum["share"]]
    assert turns == pytest.approx([0.0, 300.0, 200.0], rel=1e-6) and spectrum["load"] == [0.0, 0.5, 1.0]


def test_names_with_spaces_are_quoted_and_others_refused(tmp_path):
    spectrum = duty_spectrum(read_duty(written(tmp_path, GOOD)))
    assert "gas turbine 1" in tomllib.loads(spectrum.text("gas turbine 1", "test bench"))["cases"]["test bench"]
    with pytest.raises(DesignError, match=r"machine: 'a\.b'"):
        spectrum.text("a.b")


def test_power_over_speed_is_torque(tmp_path):
    text = "time_min,power_kw,speed_rad_s\n0,10,100\n1,0,0\n2,0,0\n"
    duty = read_duty(written(tmp_path, text))
    assert duty.torque.tolist() == [100.0, 0.0] and duty.duration.tolist() == [60.0, 60.0]
    assert duty.power.tolist() == [10e3, 0.0]


def test_classes_hold_all_the_time_and_no_less_load(tmp_path):
    spectrum = duty_spectrum(read_duty(written(tmp_path, GOOD)), classes=4)
    assert spectrum.torque.tolist() == [0.0, 1000.0, 2000.0]  # edges 0, 500, …, 2000
    assert spectrum.share.tolist() == [0.1, 0.2, 0.7] and spectrum.time == 100.0
    coarse = duty_spectrum(read_duty(written(tmp_path, GOOD)), classes=3)
    assert coarse.torque == pytest.approx([0.0, 4000.0 / 3.0, 2000.0])  # the upper end of the class


def test_more_classes_come_down_to_what_was_measured(tmp_path):
    duty = read_duty(written(tmp_path, GOOD))
    damage = float((np.abs(duty.torque) ** 6.6 * duty.duration).sum() / duty.duration.sum())
    found = [duty_spectrum(duty, classes=classes) for classes in (3, 30, 3000)]
    sums = [float((spectrum.torque**6.6 * spectrum.share).sum()) / damage for spectrum in found]
    assert sums[0] >= sums[1] >= sums[2] >= 1.0 - 1e-12 and sums[2] == pytest.approx(1.0, rel=1e-3)


def test_the_text_is_a_case_of_a_design(tmp_path):
    text = duty_spectrum(read_duty(written(tmp_path, GOOD)), classes=10).text("motor", "bench")
    design = gw.parse(gw.design_text(gw.read("single-planetary")) + "\n" + text.replace("motor =", _driver() + " ="))
    assert design.cases["bench"].duration == 100.0
    assert sum(design.spectra["bench"].share) == pytest.approx(1.0, abs=1e-12)
    assert "bench" in gw.size(design).flows


def _driver():
    return next(name for name, machine in gw.read("single-planetary").machines.items() if machine.drives)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "the file is empty; its first line names the columns"),
        ("\n \n", "the file is empty"),
        ("0,1,1\n1,1,1\n", "time: there is no such column; give one of time_s"),
        ("time_s,torque_nm,speed_rpm\n", "two rows at least"),
        ("time_s;torque_nm;speed_rpm\n0;1,5;1\n1;1;1\n", r"line 2, torque_nm: '1,5' .*; decimals have a point: 1\.5"),
        (
            "time_s,torque_nm,speed_rpm\n0,1,5,1\n1,1,1\n",
            "line 2: has 4 cells, and 3 columns are named; decimals have a",
        ),
        ("time_s,torque_nm,speed_rpm\n0,1,1\n", "two rows at least"),
        ("time_s,torque_nm,sped_rpm\n0,1,1\n1,1,1\n", "sped_rpm: no such column"),
        ("time_s,torque_nm,power_w,speed_rpm\n0,1,1,1\n1,1,1,1\n", "one column of torque or power"),
        ("time_s,torque_nm,torque_knm,speed_rpm\n0,1,1,1\n1,1,1,1\n", "torque: is given twice"),
        ("time_s,torque_nm,speed_rpm\n0,1,1\n1,,1\n2,1,1\n", "line 3, torque_nm: '' is no finite number"),
        ("time_s,torque_nm,speed_rpm\n0,1,1\n1,nan,1\n2,1,1\n", "line 3, torque_nm: 'nan' is no finite number"),
        ("time_s,torque_nm,speed_rpm\n0,1,1\n1,1\n2,1,1\n", "line 3: has 2 cells, and 3 columns"),
        ("time_s,torque_nm,speed_rpm\n0,1,1\n2,1,1\n1,1,1\n", "line 4: 1 s comes after 2 s"),
        ("time_s,power_w,speed_rpm\n0,1,1\n1,5,0\n2,1,1\n", "line 3: power without speed"),
        ("time_s,torque_nm,speed_rpm,temperature_k\n0,1,1,300\n1,1,1,-4\n2,1,1,300\n", "line 3: a temperature below"),
    ],
)
def test_what_is_wrong_with_a_file_is_told_with_its_line(text, said, tmp_path):
    with pytest.raises(DesignError, match=said):
        read_duty(written(tmp_path, text))


def test_many_faults_are_counted(tmp_path):
    rows = "".join(f"{k},x,1\n" for k in range(30))
    with pytest.raises(DesignError, match="and 22 more lines like these"):
        read_duty(written(tmp_path, f"time_s,torque_nm,speed_rpm\n{rows}"))


def test_a_duty_of_nothing_and_no_classes_are_refused(tmp_path):
    idle = read_duty(written(tmp_path, "time_s,torque_nm,speed_rpm\n0,0,1\n1,0,1\n"))
    with pytest.raises(DesignError, match="nothing was measured but zero"):
        duty_spectrum(idle)
    with pytest.raises(DesignError, match="classes: 0; take 1 or more"):
        duty_spectrum(read_duty(written(tmp_path, GOOD)), classes=0)


def test_all_faults_are_told_at_once(tmp_path):
    with pytest.raises(DesignError) as raised:
        read_duty(written(tmp_path, "time_s,torque_nm,speed_rpm\n0,1,1\n2,x,1\n1,1,1\n3,1\n"))
    assert [problem.path for problem in raised.value.problems] == ["line 3, torque_nm", "line 5", "line 4"]


@pytest.mark.parametrize("cell", ["1e308", "1_000", "\u0661\u0660"])
def test_what_no_instrument_writes_is_no_number(cell, tmp_path):
    file = tmp_path / "duty.csv"
    file.write_text(f"time_s,torque_nm,speed_rpm\n0,10,100\n{cell},20,100\n", encoding="utf-8")
    with pytest.raises(DesignError, match=r"line 3, time_s: .* is no finite number"):
        read_duty(file)


def test_every_unit_of_a_column_is_read(tmp_path):
    """100 lbf ft at 10 Hz and 212 °F for a second are 135.58 N m at 62.83 rad/s and 373.15 K."""
    text = "time_ms,torque_lbf_ft,speed_hz,temperature_f\n0,100,10,212\n1000,0,0,212\n"
    duty = read_duty(written(tmp_path, text))
    assert duty.torque[0] == pytest.approx(135.5818, rel=1e-6) and duty.speed[0] == pytest.approx(62.83185, rel=1e-6)
    assert duty.duration[0] == pytest.approx(1.0) and duty.temperature[0] == pytest.approx(373.15)


def test_load_bins_have_durations_in_any_order(tmp_path):
    """A bin is a row with its duration: the spectrum is that of the record of which they were counted."""
    bins = read_duty(written(tmp_path, "duration_s,torque_nm,speed_rpm\n60,60,900\n10,120,600\n30,240,1200\n"))
    record = "time_s,torque_nm,speed_rpm\n0,120,600\n10,240,1200\n40,60,900\n100,0,0\n"
    one, other = (duty_spectrum(duty, classes=4) for duty in (bins, read_duty(written(tmp_path, record))))
    assert (one.torque.tolist(), one.time) == (other.torque.tolist(), other.time)
    assert one.share.tolist() == pytest.approx(other.share.tolist()) and one.turns.tolist() == pytest.approx(
        other.turns.tolist()
    )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("duration_s,time_s,torque_nm,speed_rpm\n1,0,1,1\n1,1,1,1\n", "durations of load bins, and not both"),
        ("duration_s,torque_nm,speed_rpm\n1,1,1\n0,1,1\n", "line 3: a duration that is not above 0"),
        ("duration_s,torque_nm,speed_rpm\n", "two rows at least"),
    ],
)
def test_what_is_wrong_with_load_bins_is_told(text, said, tmp_path):
    with pytest.raises(DesignError, match=said):
        read_duty(written(tmp_path, text))
