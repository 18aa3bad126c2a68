"""What of a mesh lies beyond the ranges in which the formulas of ISO 6336 hold: said with value, range and clause."""

import pytest

from designs import PAIR
from gearwright.checks import Status
from gearwright.sizing import Sizing, size
from gearwright.spec import parse


def sized(module: float = 3.0, width: float = 30.0, helix: float = 0.0, rating: str = "iso6336") -> Sizing:
    return size(
        parse(
            f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n[gears]\nrating = "{rating}"\nhelix_angle_deg = {helix:g}\n'
            f'[overrides]\n"stage.module_mm" = {module:g}\n"stage.face_width_mm" = {width:g}\n'
        )
    )


def told(sizing: Sizing) -> dict[str, str]:
    return {
        check.mode: f"{check.clause}: {check.why}" for check in sizing.checks if check.status is Status.NOT_ASSESSED
    }


def test_a_usual_pair_is_within_all_ranges():
    assert sized().meshes[0].rating.beyond == ()
    assert told(sized()) == {}


@pytest.mark.parametrize(
    ("changes", "quantity", "clause"),
    [
        ({"helix": 30.5}, "β", "ISO 6336-3:2019, clause 8"),
        ({"module": 0.4, "width": 5.0}, "m_n", "ISO 1328-1"),
        ({"module": 71.0, "width": 900.0}, "m_n", "ISO 1328-1"),
        ({"width": 3.9}, "b", "ISO 1328-1"),
        ({"module": 0.2, "width": 5.0}, "d_1", "ISO 1328-1"),
    ],
)
def test_what_lies_beyond_is_not_assessed_with_value_and_clause(changes, quantity, clause):
    words = told(sized(**changes))[f"range of {quantity}"]
    assert words.startswith(clause)
    assert "the formulas hold from" in words


@pytest.mark.parametrize("changes", [{"helix": 29.9}, {"module": 0.55, "width": 5.0}, {"width": 4.1}])
def test_just_within_nothing_is_said(changes):
    assert told(sized(**changes)) == {}


def test_the_clause_is_that_of_the_edition():
    assert told(sized(helix=31.0, rating="iso6336-2006"))["range of β"].startswith("ISO 6336-3:2006")
    assert told(sized(helix=31.0, rating="din3990"))["range of β"].startswith("DIN 3990-3:1987")
