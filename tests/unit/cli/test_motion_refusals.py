"""Commands refuse what no run can follow, and say how right their forces are."""

import json

import pytest
from typer.testing import CliRunner

from gearwright.cli import app


@pytest.mark.parametrize(("words", "told"), [
    (["simulate", "single-planetary", "--duration", "0"], "duration: 0 s; it must be positive and finite"),
    (["simulate", "single-planetary", "--duration", "1e300"], "duration: 1e+300 s takes"),
    (["runup", "single-planetary", "--lowest", "nan"], "--lowest"),
    (["runup", "single-planetary", "--highest", "inf"], "--highest: inf; give a finite number"),
])  # fmt: skip
def test_a_command_says_what_cannot_be(words, told):
    result = CliRunner().invoke(app, words)
    assert result.exit_code != 0
    assert told in f"{result.output}{result.exception}"


def test_an_answer_carries_both_errors():
    """Peaks within 1 %, root mean squares within 0.1 %; no teeth part, so there is no exponent."""
    result = CliRunner().invoke(app, ["simulate", "single-planetary", "--duration", "0.01", "--json"])
    answer = json.loads(result.stdout)["result"]
    assert 0.0 < answer["rms_error"] <= 1e-3
    assert answer["rms_error"] <= answer["error"] <= 1e-2
    assert answer["exponent"] is None
