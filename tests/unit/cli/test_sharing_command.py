"""The command ``sharing``."""

from __future__ import annotations

import json

import pytest
import typer
from typer.testing import CliRunner

from gearwright.cli.commands.dynamics import asked_share, sharing
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design

APP = typer.Typer()
APP.command()(sharing)
SPLIT = "face-gear-split-torque"


def called(*words: str) -> str:
    found = CliRunner().invoke(APP, words, catch_exceptions=False)
    assert found.exit_code == 0
    return found.output


@pytest.mark.parametrize(("written", "share"), [("52/48", 0.52), ("48/52", 0.52), ("0.6", 0.6), ("20/20/24", 0.375)])
def test_shares_are_read_as_written(written, share):
    assert asked_share(written) == pytest.approx(share)


@pytest.mark.parametrize("written", ["half", "0", "52", "0/0", "52/x"])
def test_what_is_no_share_is_refused(written):
    with pytest.raises(DesignError, match="is no sharing; write parts such as 52/48"):
        asked_share(written)


def test_tolerances_for_a_target_with_a_figure(tmp_path):
    output = called(SPLIT, "--target", "52/48", "--figure", str(tmp_path / "a.svg"))
    assert "Tolerances for 52/48 in 95 % of gearboxes" in output
    assert "<svg" in (tmp_path / "a.svg").read_text(encoding="utf-8")


def test_json_for_machines():
    content = json.loads(called(SPLIT, "--stage", "first", "--method", "quasi-static", "--json"))["result"]
    assert (content["stage"], content["method"]) == ("first", "quasi-static")


def test_figure_of_an_unknown_kind_is_refused(tmp_path):
    with pytest.raises(DesignError, match=r"end the name with .svg or .png"):
        called(SPLIT, "--method", "quasi-static", "--figure", str(tmp_path / "a.pdf"))


def test_page_is_chosen_by_the_train_and_not_by_the_name_of_the_file(tmp_path):
    """Another design under the name of the split torque gets the plain page, a renamed copy of it the paper's."""
    other, renamed, page = tmp_path / f"{SPLIT}.toml", tmp_path / "mine.toml", tmp_path / "page.html"
    other.write_bytes(shipped_design("off-set").read_bytes())
    renamed.write_bytes(shipped_design(SPLIT).read_bytes())
    called(str(other), "--report", str(page))
    assert "Figures of the paper" not in page.read_text(encoding="utf-8")
    called(str(renamed), "--method", "quasi-static", "--report", str(page))
    assert "Figures of the paper" in page.read_text(encoding="utf-8")
