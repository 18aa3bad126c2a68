"""The page and the tables of the Colibri replay: whole, self-contained, the wrong numbers in red."""

import json
import re

import pytest
import typer
from rich.console import Console
from typer.testing import CliRunner

from gearwright.cli.commands.replay import Part, colibri
from gearwright.replays.colibri.pages import colibri_page, indexed
from gearwright.replays.colibri.replay import PARTS, chosen, findings_table, replay, replay_tables
from gearwright.replays.colibri.report import printed_numbers
from html_checks import stands_alone


def command(*arguments):
    app = typer.Typer()
    app.command()(colibri)
    run = CliRunner().invoke(app, [*arguments], env={"COLUMNS": "120"})
    assert run.exit_code == 0, run.output
    return run.output


def test_the_page_holds_every_number_and_marks_the_wrong_ones():
    page = colibri_page()
    assert all(f'id="{one.key}"' in page for one in printed_numbers())
    assert len(re.findall(r'<tr class="wrong" id=', page)) == 51
    assert "{" not in re.sub(r"<(style|script)>.*?</\1>", "", page, flags=re.DOTALL), "a number was not filled in"


def test_the_page_stands_alone_with_closed_tags_and_links_that_lead_somewhere():
    stands_alone(colibri_page())


def test_what_follows_an_underscore_is_an_index_and_html_stays_words():
    assert indexed("S_H, F_a/C_0 < ε_α") == ("S<sub>H</sub>, F<sub>a</sub>/C<sub>0</sub> &lt; ε<sub>α</sub>")


def test_the_wrong_numbers_are_red_on_a_terminal():
    """Red is 31 among the codes of a terminal; one line for each of the 51, and the 24 checks that fail."""
    found = replay()
    console = Console(force_terminal=True, color_system="standard", width=160)
    with console.capture() as captured:
        console.print(replay_tables(found.numbers, found))
        console.print(findings_table(found.findings))
    red = [line for line in captured.get().splitlines() if "\x1b[31m" in line]
    assert sum("wrong E" in line for line in red) == 51
    assert sum("at least" in line or "at most" in line for line in red if "wrong E" not in line) == 24


def test_parts_of_the_command_are_those_of_the_report():
    assert [each.value for each in Part] == list(PARTS)
    assert [each.value for each in Part] == list(dict.fromkeys(one.part for one in printed_numbers()))


@pytest.mark.parametrize("part", PARTS)
def test_every_part_can_be_shown_alone(part):
    numbers = chosen(replay(), part=part)
    assert numbers and all(one.printed.part == part for one in numbers)
    assert PARTS[part] in command("--part", part)


def test_json_carries_all_numbers_or_only_the_wrong_ones():
    whole, wrong = (json.loads(command("--json", *words))["result"] for words in ((), ("--wrong",)))
    assert len(whole["numbers"]) == 236 and len(wrong["numbers"]) == 51
    assert whole["counts"]["wrong in source"] == 51
    life = next(one for one in whole["findings"] if one["what"] == "shaft 1: life of its bearing")
    assert life["value"] == pytest.approx(38.2, abs=0.05) and (life["limit"], life["unit"]) == (5000.0, "h")
    key = next(one for one in wrong["numbers"] if one["key"] == "shaft-1.key-length")
    assert key["printed"] == "4.745525" and key["correct"] == pytest.approx(71.18, abs=0.01)


def test_the_command_writes_the_page_it_is_asked_for(tmp_path):
    assert "51 wrong" in command("--out", str(tmp_path / "page.html"))
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == colibri_page()
    command("--out", str(tmp_path / "page.md"))
    assert (tmp_path / "page.md").read_text(encoding="utf-8").startswith("---\nhide: [toc]")
