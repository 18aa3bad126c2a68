"""What oils and bearings take from tables, printed values written out again; laws of friction point by point."""

import math
from itertools import pairwise

import numpy as np
import pytest

from gearwright.parts.bearings import (
    Cleanliness,
    OilFilter,
    cleanliness_factor,
    contamination_factor,
    deep_groove_factors,
)
from gearwright.parts.bearings.life import ISO281_2007, ISO_R281_1962
from gearwright.parts.iso6336 import MeshGeometry
from gearwright.parts.losses import LossDuty, OilState, anderson_loewenthal_part, iso_tr_14179_1_part, tooth_contact
from gearwright.parts.micropitting import FilmMesh, OilGrade, film_of_test, film_thickness, path_places
from gearwright.units import RPM

PRINTED_2007 = [
    (0.172, 0.19, 2.30), (0.345, 0.22, 1.99), (0.689, 0.26, 1.71), (1.03, 0.28, 1.55), (1.38, 0.30, 1.45),
    (2.07, 0.34, 1.31), (3.45, 0.38, 1.15), (5.17, 0.42, 1.04), (6.89, 0.44, 1.00),
]  # fmt: skip
PRINTED_1962 = [(0.025, 0.22, 2.0), (0.04, 0.24, 1.8), (0.07, 0.27, 1.6), (0.13, 0.31, 1.4), (0.25, 0.37, 1.2)]


@pytest.mark.parametrize(
    "table, printed", [(ISO281_2007, PRINTED_2007), (ISO_R281_1962, [*PRINTED_1962, (0.5, 0.44, 1.0)])]
)
def test_factors_of_ball_bearings_stand_at_the_printed_rows_and_halfway_between(table, printed):
    """ISO 281:2007, table 3, and ISO/R 281:1962, rows as printed; between them straight, beyond them the last."""
    for load, limit, axial in printed:
        assert deep_groove_factors(load, table)[:3] == pytest.approx((limit, 0.56, axial), rel=1e-12)
    for (load, limit, axial), (after, next_limit, next_axial) in pairwise(printed):
        middle = ((limit + next_limit) / 2.0, 0.56, (axial + next_axial) / 2.0)
        assert deep_groove_factors((load + after) / 2.0, table)[:3] == pytest.approx(middle, rel=1e-12)
    for beyond, row in ((printed[0][0] / 3.0, printed[0]), (printed[-1][0] * 3.0, printed[-1])):
        assert deep_groove_factors(beyond, table)[:3] == (row[1], 0.56, row[2])


RANGES = {
    "EXTREME": ((1.0, 1.0), (1.0, 1.0)),
    "HIGH": ((0.6, 0.8), (0.8, 0.9)),
    "NORMAL": ((0.5, 0.6), (0.6, 0.8)),
    "SLIGHT": ((0.3, 0.5), (0.4, 0.6)),
    "TYPICAL": ((0.1, 0.3), (0.2, 0.4)),
    "SEVERE": ((0.0, 0.1), (0.0, 0.1)),
}
"""e_C of ISO 281:2007, table 13, below and from 100 mm, as printed: from, to."""


@pytest.mark.parametrize("name", RANGES)
def test_the_word_for_clean_oil_is_the_middle_of_its_printed_range(name):
    for diameter, printed in zip((0.0999, 0.1), RANGES[name], strict=True):
        assert cleanliness_factor(Cleanliness[name], diameter) == pytest.approx(sum(printed) / 2.0)


FILTERS = [
    ("BETA_6_200", 0.0864, 0.5663),
    ("BETA_12_200", 0.0432, 0.9987),
    ("BETA_25_75", 0.0288, 1.6329),
    ("BETA_40_75", 0.0216, 2.3362),
]


@pytest.mark.parametrize("name, slope, coarse", FILTERS)
def test_the_filter_of_an_oil_follows_its_printed_equation(name, slope, coarse):
    """ISO 281:2007, A.4 to A.7 at κ = 1.1 and D_pw = 64 mm, whose cube root is 4; a thick film ends at 1."""
    film = slope * 1.1**0.68 * 64.0**0.55
    assert film < 1.0
    assert contamination_factor(OilFilter[name], 1.1, 0.064) == pytest.approx(film * (1.0 - coarse / 4.0))
    assert contamination_factor(OilFilter[name], 4000.0, 0.064) == pytest.approx(1.0 - coarse / 4.0)


def test_the_sliding_and_rolling_of_anderson_and_loewenthal_point_by_point():
    """Benedict and Kelley's friction and the film's traction at 4000 points of a path that is written out anew.

    30/90, m 3, 20°: the path runs from the wheel's tip to the pinion's; pairs in contact share the load equally, and
    in a normal pitch from either end two of them bear (1 < ε < 2). The sum over 200 points keeps 0.5 %.
    """
    alpha, radii, module = math.radians(20.0), (45.0e-3, 135.0e-3), 3e-3
    contact = tooth_contact((30, 90), module, pressure_angle=alpha)
    load, width, velocity, oil = 12e3, 0.04, 15.0, 8.0
    pitch = math.pi * module * math.cos(alpha)
    before, behind = (
        math.sqrt((r + module) ** 2 - (r * math.cos(alpha)) ** 2) - r * math.sin(alpha) for r in reversed(radii)
    )
    place = (np.arange(4000) + 0.5) / 4000 * (before + behind) - before
    pairs = np.where((place < behind - pitch) | (place > pitch - before), 2.0, 1.0)
    first, second = radii[0] * math.sin(alpha) + place, radii[1] * math.sin(alpha) - place
    slide = velocity * np.abs(place) * (1.0 / radii[0] + 1.0 / radii[1])
    roll = velocity * (first / radii[0] + second / radii[1])
    own = load / pairs
    friction = np.clip(0.0127 * np.log10(29.66 * own / width / (oil * slide * roll**2)), 0.0, 0.2)
    film = 2.051e-7 * (roll * oil) ** 0.67 * own**-0.067 * (first * second / (first + second)) ** 0.464
    power = np.mean(friction * own * slide + 9e7 * film * width * roll) * (before + behind) / pitch
    part = power / (load * math.cos(alpha) * velocity)
    duty = LossDuty(load / width, width, velocity)
    assert anderson_loewenthal_part(contact, duty, OilState(8e-3, 950.0, 0.4e-6)) == pytest.approx(part, rel=5e-3)


def test_part_one_of_the_report_takes_a_helix_by_its_square():
    """f_m cos² β/M: the same transverse section, load and speed with a helix of 30° loses three quarters."""
    spur = tooth_contact((30, 90), 3e-3, pressure_angle=0.35)
    helical = spur._replace(helix=math.radians(30.0))
    duty, oil = LossDuty(300e3, 0.04, 15.0), OilState(8e-3, 950.0, 0.4e-6)
    part = iso_tr_14179_1_part(helical, duty, oil) / iso_tr_14179_1_part(spur, duty, oil)
    assert part == pytest.approx(0.75, rel=1e-12)


@pytest.mark.parametrize("stage, torque, line", [(10, 265.1, 236.3e3), (7, 132.5, 236.3e3 * 132.5 / 265.1)])
def test_the_film_of_the_micropitting_test_is_that_of_its_gears(stage, torque, line):
    """Gears C-GF, as FVA 54/7 prints them: 16/24, m 4.5, a 91.5, b 14, d_a 82.46 and 118.36; 2250 rpm, 90 °C."""
    gears = MeshGeometry((16.0, 24.0), 4.5e-3, 14e-3, 91.5e-3, (82.46e-3 / 2.0, 118.36e-3 / 2.0))
    force = 2.0 * torque / (16 * 4.5e-3)
    nominal = force / math.cos(math.radians(20.0)) / 14e-3
    oil = OilGrade(220e-6, 19e-6, 890.0)
    share = np.full(len(path_places(gears)), 1.045 * line / nominal / 1.163)
    mesh = FilmMesh(gears, force, 1.163, 2250.0 * RPM, 0.5e-6, supply=1.2)
    film = film_thickness(mesh, oil, 90.0, sharing=share)
    assert film_of_test(oil, stage) == pytest.approx(float(film.relative(0.5e-6)[0]), rel=1e-9)
