"""The page on load sharing prints what the code and the command give."""

import doctest
import json
import re
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from gearwright.cli.commands.dynamics import sharing
from gearwright.replays.wang.claims import split_torque, split_torque_claims
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read

PAGE = Path(__file__).parents[2] / "docs" / "theory" / "load-sharing.md"
NUMBER = r"\d+(?:\.\d+)?(?:e[+]?\d+)?"
SPLIT = "face-gear-split-torque"
APP = typer.Typer()
APP.command()(sharing)


def test_examples_of_the_page_run_and_print_what_stands_there():
    failed, tried = doctest.testfile(str(PAGE), module_relative=False, encoding="utf-8")
    assert tried > 10
    assert failed == 0


def row(start: str) -> list[str]:
    """Return the cells of the line of a table that starts so."""
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    return next(line for line in lines if line.startswith(f"| {start}")).strip("| ").split(" | ")


def called(method: str) -> dict[str, object]:
    found = CliRunner().invoke(APP, [SPLIT, "--method", method, "--json"], catch_exceptions=False)
    return json.loads(found.stdout)["result"]


def test_command_prints_the_shares_of_the_table():
    """b₅ and K_γ under all errors at the paper's support, to the digits of the page."""
    dynamics, closed = called("dynamics"), called("quasi-static")
    least, most = (2.0 * dynamics["paths"][0][end] for end in ("minimum", "maximum"))
    assert f"{least:.3f}–{most:.3f}" == row("b₅ over a tooth cycle")[1].split(";")[0]
    factors = [f"{each['load_factor']:.3f}" for each in (dynamics, closed)]
    assert factors == row("K_γ of the second stage")[1].split("; ")


@pytest.fixture(scope="module")
def reasons() -> dict[str, str]:
    sizing = size(read(shipped_design(SPLIT)))
    claims = split_torque_claims(sizing, split_torque(sizing.design))
    return {claim.printed: claim.why for claim in claims}


@pytest.mark.parametrize(
    ("claim", "start"),
    [
        ("Without floating", "without floating, the paths"),
        ("Sharing becomes better", "sharing becomes better"),
        ("The displacement of the shaft", "the displacement of the shaft"),
        ("Vibration decreases", "vibration decreases"),
        ("One error can make", "one error makes 3 %"),
        ("Cutting one error", "cutting one error"),
    ],
)
def test_claims_of_the_report_have_the_numbers_of_the_page(reasons, claim, start):
    why = next(why for printed, why in reasons.items() if printed.startswith(claim))
    computed = {float(each) for each in re.findall(NUMBER, why)}
    printed = {float(each) for each in re.findall(NUMBER, row(start)[2])}
    assert printed
    assert printed <= computed
