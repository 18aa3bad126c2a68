"""Windows of a mission: what cannot be flown is refused with path, value and fix, all at once."""

import pytest

from gearwright.errors import DesignError, SolveError
from gearwright.mission.windows import fly_window, window_rules
from gearwright.shipped import shipped_mission
from gearwright.spec import WindowRules, parse_mission
from shipped_work import flown


@pytest.fixture(scope="module")
def flight():
    return flown()


def test_every_problem_of_the_windows_is_told_at_once():
    text = shipped_mission("thesis").read_text(encoding="utf-8") + (
        '\n[windows.a]\nphase = "cruse"\n'
        '[windows.b]\nphase = "cruise"\nevent = "gust"\n'
        '[windows.c]\nphase = "cruise"\nevent = "mode-change"\nmode = "hybrid"\n'
        '[windows.d]\nphase = "cruise"\nevent = "motor-cut"\nevent_at_s = 20\n'
        '[windows.e]\nphase = "cruise"\nevent = "clutch-engagement"\n'
    )
    with pytest.raises(DesignError) as caught:
        parse_mission(text)
    words = str(caught.value)
    for part in (
        "no such phase: cruse; did you mean cruise?",
        "gust without gust",
        "hybrid without electric_share",
        "the window ends at 10 s",
        "without clutch",
        "without slip",
    ):
        assert part in words


def test_an_unknown_window_is_told_with_the_nearest(flight):
    with pytest.raises(DesignError, match="did you mean motor-cut"):
        window_rules(flight, "motor-cutt")


def test_a_window_behind_the_end_of_its_phase_is_refused(flight):
    with pytest.raises(DesignError, match="cruise ends after 2400 s; start earlier"):
        fly_window(flight, "late", WindowRules(phase="cruise", at=2400.0))


def test_a_clutch_that_the_design_lacks_is_refused(flight):
    rules = WindowRules(phase="cruise", event="clutch-engagement", clutch="sprag", slip=1.0)
    with pytest.raises(DesignError, match="no such clutch: sprag"):
        fly_window(flight, "join", rules)


def test_a_gust_beyond_the_map_is_refused_with_speed_and_pitch(flight):
    rules = WindowRules(
        phase="cruise", at=600.0, duration=1.0, event="gust", gust=60.0, event_at=0.1, gust_shape="step"
    )
    with pytest.raises(SolveError, match="propeller leaves its map at"):
        fly_window(flight, "storm", rules)


def test_a_mission_of_schedules_has_no_windows():
    flight = flown("face-gear-split-torque", "rotor-schedule")
    first = next(iter(flight.mission.phases))
    with pytest.raises(DesignError, match="a window needs a propeller_map"):
        fly_window(flight, "any", WindowRules(phase=first))


def test_a_fault_without_its_numbers_is_told_for_every_number():
    text = shipped_mission("thesis").read_text(encoding="utf-8") + (
        '\n[windows.a]\nphase = "cruise"\nevent = "motor-short-circuit"\n'
        '[windows.b]\nphase = "cruise"\nevent = "engine-out"\n'
        '[windows.c]\nphase = "cruise"\nevent = "pitch-runaway"\n'
        '[windows.d]\nphase = "cruise"\nevent = "power-slam"\nlag_s = 1\n'
        '[windows.e]\nphase = "cruise"\nevent = "propeller-strike"\nlasts_s = 1\n'
        '[windows.f]\nphase = "cruise"\nevent = "propeller-strike"\nlasts_s = 1\nstop_time_s = 0.5\n'
        '[windows.g]\nphase = "cruise"\nevent = "sudden-stop"\nstop_time_s = 0.5\nbrake_torque_nm = 100\n'
        '[windows.h]\nphase = "cruise"\nevent = "sudden-stop"\nstop_time_s = 0.001\n'
    )
    with pytest.raises(DesignError) as caught:
        parse_mission(text)
    words = str(caught.value)
    for part in (
        "motor-short-circuit without back_emf_v",
        "without inductance_mh",
        "without pole_pairs",
        "engine-out without lag",
        "pitch-runaway without overspeed",
        "power-slam without power",
        "either strike_torque or stop_time",
        "stands still after stop_time, 0.5 s",
        "either brake_torque or stop_time",
        "0.001 s is less than 0.01 s",
    ):
        assert part in words


def test_a_fault_of_a_machine_that_the_design_lacks_is_refused(flight):
    short = WindowRules(
        phase="cruise", event="motor-short-circuit", back_emf_v=1.0, inductance_mh=1.0, pole_pairs=2, machine="electrik"
    )
    with pytest.raises(DesignError, match="no such motor: electrik; did you mean electric"):
        fly_window(flight, "short", short)
    stop = WindowRules(phase="cruise", event="sudden-stop", stop_time=1.0, machine="propelle")
    with pytest.raises(DesignError, match="no such machine: propelle; did you mean propeller"):
        fly_window(flight, "stop", stop)
    out = WindowRules(phase="cruise", event="engine-out", lag=1.0, machine="electric")
    with pytest.raises(DesignError, match="no such turbine: electric"):
        fly_window(flight, "out", out)


def test_a_fault_names_its_machine_where_there_are_several_and_needs_one():
    flight = flown("twin-engine-sprag", "regional-250nm")
    with pytest.raises(DesignError, match="turbine-1, turbine-2; name one"):
        fly_window(flight, "out", WindowRules(phase="climb", event="engine-out", lag=1.0))
    short = WindowRules(phase="climb", event="motor-short-circuit", back_emf_v=1.0, inductance_mh=1.0, pole_pairs=2)
    with pytest.raises(DesignError, match="the design has no motor; choose another event"):
        fly_window(flight, "short", short)
