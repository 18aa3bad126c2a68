"""The page on the thesis: whole, self-contained, the same at every run; and the page in the documentation is it."""

import re
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from gearwright.cli.commands.replay import thesis
from gearwright.errors import DesignError
from gearwright.replays.pulvirenti.claims import errata, printed_claims
from gearwright.replays.pulvirenti.pages import thesis_markdown, thesis_page
from html_checks import stands_alone

DOCS = Path(__file__).parents[3] / "docs" / "theory" / "thesis.md"


def test_the_page_holds_every_claim_and_every_erratum():
    page = thesis_page()
    assert all(f'id="claim-{one.key}"' in page for one in printed_claims())
    assert page.count('class="equation"') == len(errata())
    assert "{" not in re.sub(r"<(style|script)>.*?</\1>", "", page, flags=re.DOTALL), "a number was not filled in"


def test_the_page_stands_alone_with_closed_tags_and_links_that_lead_somewhere():
    stands_alone(thesis_page())


def test_the_page_is_the_same_at_every_run():
    assert thesis_page() == thesis_page()


def test_the_page_of_the_documentation_is_what_the_command_writes():
    """After a change of a number: gearwright replay pulvirenti --out docs/theory/thesis.md."""
    assert DOCS.read_text(encoding="utf-8") == thesis_markdown()


def test_figures_of_chapter_4_are_refused_without_its_page():
    with pytest.raises(DesignError, match="give --chapter-4"):
        thesis(figures=Path("figures"))


def test_a_folder_that_cannot_be_is_refused_before_the_minutes_of_chapter_4(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(DesignError, match="cannot be written"):
        thesis(chapter_4=tmp_path / "file" / "page.md")


def test_the_command_prints_the_verdicts_and_writes_the_page(tmp_path):
    app = typer.Typer()
    app.command()(thesis)
    run = CliRunner().invoke(app, ["--out", str(tmp_path / "page.html"), "--errata"])
    assert run.exit_code == 0, run.output
    assert "does not hold" in run.output and "3.34" in run.output
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == thesis_page()
