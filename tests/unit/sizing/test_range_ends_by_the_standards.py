"""Both ends of every range in which ISO 6336 holds, as standards print them: just inside silent, just outside told.

ISO 6336-1:2019, clause 1: ε_α from 1.0 to 2.5; clause 9: x_1 + x_2 from −0.5 to 2.0. ISO 6336-3:2019, clause 7: q_s
from 1 to 8; clause 8: a larger β counts as 30°. ISO 1328-1:2013, clause 1: z from 5 to 1000, d from 5 mm to 15 m, m_n
from 0.5 mm to 70 mm, b from 4 mm to 1200 mm.
"""

import math
from types import SimpleNamespace

import pytest

from gearwright.checks import Status
from gearwright.identity import Kind, PartId
from gearwright.sizing.rating.iso6336_inputs import beyond_ranges, range_checks

USUAL = {
    "ε_α": 1.6, "β": 0.2, "m_n": 3e-3, "b": 0.03, "z_1": 24.0, "z_2": 71.0, "d_1": 0.072, "d_2": 0.213,
    "q_s1": 2.0, "q_s2": 2.5, "x_1": 0.3, "x_2": 0.1,
}  # fmt: skip
"""In SI, angles in rad."""
ENDS = [
    ("ε_α", "ε_α", 1.0, 2.5, "ISO 6336-1:2019, clause 1"),
    ("m_n", "m_n", 0.0005, 0.070, "ISO 1328-1:2013, clause 1"),
    ("b", "b", 0.004, 1.200, "ISO 1328-1:2013, clause 1"),
    ("z_1", "z_1", 5.0, 1000.0, "ISO 1328-1:2013, clause 1"),
    ("z_2", "z_2", 5.0, 1000.0, "ISO 1328-1:2013, clause 1"),
    ("d_1", "d_1", 0.005, 15.0, "ISO 1328-1:2013, clause 1"),
    ("d_2", "d_2", 0.005, 15.0, "ISO 1328-1:2013, clause 1"),
    ("q_s1", "q_s1", 1.0, 8.0, "ISO 6336-3:2019, clause 7"),
    ("q_s2", "q_s2", 1.0, 8.0, "ISO 6336-3:2019, clause 7"),
]
HAIR = 1e-6
"""Of a value, by which it stands inside or outside; rounding is 1e-16, the least gap between two ends 0.2."""


def told(*, side: float = 1.0, **changed: float):
    values = USUAL | changed
    mesh = SimpleNamespace(
        transverse_contact_ratio=values["ε_α"],
        helix_angle=values["β"],
        module=values["m_n"],
        face_width=values["b"],
        teeth=(values["z_1"], side * values["z_2"]),
        pitch_diameters=(values["d_1"], values["d_2"]),
        side=side,
        proportions=tuple(SimpleNamespace(profile_shift=values[name]) for name in ("x_1", "x_2")),
    )
    roots = [SimpleNamespace(section=SimpleNamespace(notch=values[name])) for name in ("q_s1", "q_s2")]
    return beyond_ranges(mesh, SimpleNamespace(bending=roots))  # type: ignore[arg-type]


def test_a_usual_mesh_is_within_all_ranges():
    assert told() == ()
    assert told(side=-1.0) == ()


@pytest.mark.parametrize(("name", "quantity", "least", "most", "clause"), ENDS)
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_both_ends_of_every_range_of_meshes_and_rings(name, quantity, least, most, clause, side):
    for inside in (least, least * (1.0 + HAIR), most * (1.0 - HAIR), most):
        assert told(side=side, **{name: inside}) == ()
    for outside in (least * (1.0 - HAIR), most * (1.0 + HAIR)):
        (beyond,) = told(side=side, **{name: outside})
        assert (beyond.quantity, beyond.value, beyond.clause) == (quantity, outside, clause)
        assert (beyond.least, beyond.most) == (least, most)


def test_the_helix_has_its_end_at_thirty_degrees_and_straight_teeth_are_within():
    assert told(β=0.0) == () and told(β=math.radians(30.0 - HAIR)) == ()
    (beyond,) = told(β=math.radians(30.0 + HAIR))
    assert (beyond.quantity, beyond.least) == ("β", 0.0)
    assert math.degrees(beyond.most) == pytest.approx(30.0, rel=1e-12)
    assert beyond.clause.startswith("ISO 6336-3:2019, clause 8")


@pytest.mark.parametrize(("first", "second"), [(-0.2, -0.3), (1.5, 0.5), (-0.8, 0.3), (0.4, 1.6)])
def test_the_sum_of_shifts_has_its_ends_at_minus_a_half_and_two(first, second):
    assert told(x_1=first * (1 - HAIR), x_2=second * (1 - HAIR)) == ()
    (beyond,) = told(x_1=first * (1 + HAIR), x_2=second * (1 + HAIR))
    assert (beyond.quantity, beyond.least, beyond.most) == ("x_1 + x_2", -0.5, 2.0)
    assert beyond.value == pytest.approx(first + second, rel=2 * HAIR)
    assert beyond.clause == "ISO 6336-1:2019, clause 9"


def test_the_sum_of_shifts_is_asked_of_external_meshes_alone():
    """The shifts of a ring and its planet have opposite signs in c′, which the clause gives for external pairs."""
    assert told(side=-1.0, x_1=2.0, x_2=1.0) == ()


def test_all_that_lies_beyond_is_told_at_once_in_the_units_of_the_shop():
    beyond = told(z_1=4.0, m_n=0.08, β=math.radians(33.0), x_1=-1.0)
    checks = list(range_checks(beyond, PartId(Kind.MESH, "stage")))
    assert [check.mode for check in checks] == [f"range of {name}" for name in ("β", "m_n", "z_1", "x_1 + x_2")]
    assert {check.status for check in checks} == {Status.NOT_ASSESSED}
    assert {str(check.part) for check in checks} == {"stage"}
    for check, words in zip(
        checks,
        ("33 °; the formulas hold from 0 ° to 30 °", "80 mm; the formulas hold from 0.5 mm to 70 mm",
         "4; the formulas hold from 5 to 1000", "-0.9; the formulas hold from -0.5 to 2"),
        strict=True,
    ):  # fmt: skip
        assert " ".join(check.why.replace("−", "-").split()).startswith(words), check.why
