"""Which of many frequencies is told of a band, and when the face of a bevel gear is too wide."""

import math

import pytest

from designs import PAIR
from gearwright.sizing import size
from gearwright.spec import parse, read
from gearwright.train import passes

BAND = """
[teeth.forbidden.cabin]
lowest_hz = LOW
highest_hz = HIGH
harmonics = 3
[cases.full.turbine]
power_kw = 100
[cases.slow.turbine]
power_kw = 50
[cases.slow.propeller]
speed_rpm = 1700
"""


@pytest.mark.parametrize("low, high", [(0.30, 0.31), (1.22, 1.24), (1.75, 1.76), (2.3, 2.4), (3.4, 3.5)])
def test_of_all_harmonics_in_all_cases_the_one_nearest_to_a_band_is_told(low, high):
    """By hand: six frequencies, each over the end of the band that it is nearer to; the least ratio is told."""
    open_design = size(parse(PAIR + BAND.replace("LOW", "1.0").replace("HIGH", "2.0")))
    flows = open_design.flows
    often = {
        case: next(iter(passes(open_design.design, open_design.train, open_design.teeth, flow, "mesh")))[1]
        for case, flow in flows.items()
    }
    first = often["full"]
    text = PAIR + BAND.replace("LOW", str(low * first)).replace("HIGH", str(high * first))
    sizing = size(parse(text))
    assert sizing.teeth == open_design.teeth
    (check,) = [check for check in sizing.checks if check.mode == "mesh frequency in cabin"]
    ratios = {
        (case, harmonic): max(low * first / (harmonic * own), harmonic * own / (high * first))
        for case, own in often.items() if case in ("full", "slow") for harmonic in (1, 2, 3)
    }  # fmt: skip
    assert min(ratios.values()) > 1.0
    (case, harmonic), least = min(ratios.items(), key=lambda item: item[1])
    assert check.ratio == pytest.approx(least) and check.case == case
    assert check.place == ("" if harmonic == 1 else f"{harmonic} times")


def test_the_face_of_a_bevel_gear_is_at_most_a_third_of_its_cone_or_ten_modules():
    """ISO 23509, annex B: R_e/3 and 10 m_et, whichever is less, of the asked width; wider than that fails."""
    sizing = size(read("ec120b"))
    found = [check for check in sizing.checks if check.clause.startswith("ISO 23509, annex B")]
    assert found
    for check in found:
        assert check.at_most and check.mode == "face width"
        assert check.ratio == pytest.approx(check.limit / check.value)
        first = next(gear for gear in sizing.gears if gear.part == check.part)
        pair = next(mesh for mesh in sizing.meshes if str(first.part) in mesh.gears)
        counts = [sizing.teeth[gear] for gear in pair.gears]
        cone = 0.5 * math.hypot(*counts)  # R_m over the transverse module at the middle
        module = check.limit / min(cone / 3.0, 10.0)
        assert 0.9 < module / first.pitch_diameter * first.teeth < 1.3
