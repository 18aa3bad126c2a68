"""Formulas as they stand in the code become mathematics that a browser sets, every one of them."""

import ast
from html.parser import HTMLParser
from pathlib import Path

import pytest

import gearwright
from gearwright.render.style import mathml

SOURCES = Path(gearwright.__file__).parent.rglob("*.py")


def equations():
    """Return the first argument of every Origin of the package."""
    calls = (node for path in SOURCES for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    return {
        call.args[0].value
        for call in calls
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "Origin"
        if call.args and isinstance(call.args[0], ast.Constant)
    }


class Letters(HTMLParser):
    """Keeps the letters of a formula and checks that its tags close in order."""

    def __init__(self):
        super().__init__()
        self.open, self.letters = [], ""

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_startendtag(self, tag, attrs):
        assert tag == "mspace"

    def handle_data(self, data):
        self.letters += "".join(filter(str.isalpha, data))


def test_no_letter_of_any_equation_is_lost_and_every_tag_closes():
    """The letter ᵀ of a transpose is set as a raised T."""
    listed = equations()
    assert len(listed) > 400
    for equation in listed:
        read = Letters()
        read.feed(mathml(equation))
        assert read.open == [], equation
        assert read.letters == "".join(filter(str.isalpha, equation)).replace("ᵀ", "T"), equation


@pytest.mark.parametrize(
    ("formula", "part"),
    [
        ("F_t/(d_1 b)", "<mfrac><msub><mi>F</mi><mtext>t</mtext></msub><mrow>"),
        ("2 T / (N d)", "<mfrac><mrow><mn>2</mn>"),
        ("2 T/d", "<mfrac><mi>T</mi><mi>d</mi></mfrac>"),
        ("m_n³", "<msup><msub><mi>m</mi><mtext>n</mtext></msub><mn>3</mn></msup>"),
        ("√2^(A−5)", "<msup><msqrt><mn>2</mn></msqrt>"),
        ("1/√cos β", "<msqrt><mi>cos</mi>"),
        ("R_p0.2", "<mtext>p0.2</mtext>"),
        ("S_F,stat = 1", "<mtext>F,stat</mtext>"),
        ("(a + b) (c + d)", "<mo stretchy=false>)</mo>"),
    ],
)
def test_fractions_powers_roots_and_indices_stand_as_they_are_read(formula, part):
    assert part in mathml(formula)


def test_words_stay_words_and_cannot_become_markup():
    assert mathml("cylinders of rings, rolling elements and cage") == "cylinders of rings, rolling elements and cage"
    assert "<b>" not in mathml("<b> = 1")
