"""Whatever a file holds, the reader answers with a design or with a `DesignError`."""

import math

from hypothesis import given, settings, strategies as st

from designs import HYBRID, PAIR
from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.spec import Design, build, key_lines, line_of, parse
from gearwright.spec.checks import reference_problems

scalars = st.one_of(
    st.none().map(lambda _: "ground"), st.booleans(), st.integers(), st.floats(), st.text(max_size=8),
    st.sampled_from(["fast", "slow", "stage.wheel", 1e308, 10**400, 0, -1, 5]),
)  # fmt: skip
NAMES = [
    "shafts", "name", "schema", "turbines", "motors", "propellers", "pairs", "planetaries", "clutches", "gears",
    "teeth", "layout", "cases", "overrides", "speeds", "shaft", "power_kw", "speed_rpm", "diameter_m", "pinion",
    "wheel", "sun", "ring", "carrier", "planets", "sun_teeth", "keep", "share", "bore_mm", "material", "fast", "slow",
]  # fmt: skip
names = st.one_of(st.sampled_from(NAMES), st.text(max_size=5))
tables = st.recursive(
    scalars,
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(names, inner, max_size=5)),
    max_leaves=25,
)
VALUES = ["0", "1", "7", "1e6", "-3", "nan", "true", '"slow"', '"ground"', "[]", "{}"]


@settings(max_examples=300)
@given(raw=st.dictionaries(names, tables, max_size=8))
def test_any_table_gives_a_record_or_problems(raw):
    """What a TOML reader can return, not only what a text can be made to say."""
    record, written = build(Design, raw)
    if record is not None:
        found = [*written.problems, *reference_problems(record)]
    else:
        found = written.problems
        assert found
    assert all(each.message for each in found)


@settings(max_examples=200)
@given(text=st.text(max_size=80))
def test_any_text_gives_a_design_error(text):
    """No text of 80 characters is a design: name, shafts, a machine and a taker need more."""
    try:
        parse(text)
    except DesignError as error:
        assert all(problem.message for problem in error.problems) and error.problems
    else:
        raise AssertionError("this cannot be a design")


@settings(max_examples=150)
@given(data=st.data())
def test_any_damage_to_a_design_gives_a_design_or_a_design_error(data):
    """Lines of a good file are dropped, doubled, swapped or get another value; what still reads is sized."""
    lines = data.draw(st.sampled_from([PAIR, HYBRID])).splitlines()
    for _ in range(data.draw(st.integers(1, 3))):
        k = data.draw(st.integers(0, len(lines) - 1))
        match data.draw(st.sampled_from(["drop", "double", "swap", "value"])):
            case "drop":
                lines.pop(k)
            case "double":
                lines.insert(k, lines[k])
            case "swap":
                m = data.draw(st.integers(0, len(lines) - 1))
                lines[k], lines[m] = lines[m], lines[k]
            case "value":
                new = data.draw(
                    st.sampled_from(["0", "1", "7", "1e6", "-3", "nan", "true", '"slow"', '"ground"', "[]", "{}"])
                )
                lines[k] = lines[k].partition("=")[0] + "= " + new
    try:
        sizing = size(parse("\n".join(lines)))
    except DesignError as error:
        assert all(problem.message for problem in error.problems) and error.problems
    else:
        masses = [sizing.mass, *(gear.mass for gear in sizing.gears), *(shaft.mass for shaft in sizing.shafts)]
        assert all(0.0 < mass < math.inf for mass in masses)


def test_lines_are_those_of_the_text():
    text = 'a = 1\n\n[b]  # note\nc.d = 2\n"e f" = """\n[no]\nno = 1\n"""\n[b.\'g\']\nh = 3\n'
    lines = key_lines(text)
    assert lines == {"a": 1, "b": 3, "b.c.d": 4, "b.e f": 5, "b.g": 9, "b.g.h": 10}
    assert line_of("b.c.d.x", lines) == 4
    assert line_of("z", lines) is None


def test_a_line_of_blanks_in_brackets_is_read_at_once():
    """A bracket and a hundred thousand blanks: the search for keys must not go back over them."""
    assert key_lines("x = [\n[" + " " * 100_000 + "\n]]\ny = 2") == {"x": 1, "y": 4}


def test_a_separator_of_unicode_is_no_line_of_toml():
    assert key_lines("# a\u2028b\x0c\nx = 1") == {"x": 2}
