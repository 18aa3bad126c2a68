"""What stands in files and in names does not steer the terminal, and keeps its brackets."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from designs import PAIR, changed
from gearwright.cli.streams import clean, clean_json

EVIL = "\x1b[31mred\x1b]0;title\x07"


def test_an_escape_sequence_in_a_name_or_a_file_name_is_shown_as_its_code(call):
    named = PAIR.replace('"one pair"', '"one \\u001b[31m pair"')
    (call.folder / "named.toml").write_text(named, encoding="utf-8")
    (call.folder / f"{EVIL}.toml").write_text(PAIR, encoding="utf-8")
    (call.folder / "key.toml").write_text(PAIR + '\n["\\u001b[31m"]\nx = 1\n', encoding="utf-8")
    for words in (["size", "named.toml"], ["check", "named.toml"], ["check", f"none{EVIL}"], ["check", "key.toml"],
                  ["size", "named.toml", "--json"], ["report", f"{EVIL}.toml"], ["modes", "pair.toml", "--case", EVIL],
                  ["study", f"{EVIL}.toml"], ["window", "in-line-h2", EVIL]):  # fmt: skip
        ended = call(words)
        assert ended.code in (0, 2), ended.err
        assert "\x1b" not in ended.all, words
        assert "\x07" not in ended.all, words


def test_a_name_in_brackets_or_colons_is_printed_as_it_is(call):
    """Neither a style nor a picture."""
    (call.folder / "named.toml").write_text(changed(PAIR, "one pair", "[bold]one[/] :gear: pair"), encoding="utf-8")
    assert "[bold]one[/] :gear: pair" in call(["size", "named.toml"]).out
    assert "[bold]one[/] :gear: pair" in call(["check", "named.toml"]).out


def test_control_characters_become_codes_and_json_stays_json():
    assert clean("a\x1b[31m\x9b\u202eb\tc\n") == "a\\x1b[31m\\x9b\\u202eb\tc\n"
    assert clean_json('"σ\x9b"', "utf-8") == '"σ\\u009b"'
    assert clean_json('"σ𝛼"', "ascii") == '"\\u03c3\\ud835\\udefc"'


@pytest.mark.parametrize("encoding", ["ascii", "cp1252"])
def test_messages_in_small_alphabets_keep_their_words(call, encoding):
    """Standard error too: a message with Greek in it arrives."""
    ended = call(["check", "Größe-σ.toml"], PYTHONIOENCODING=encoding)
    assert ended.code == 2
    assert "e-s.toml: 1 problem" in ended.err


def test_a_long_name_stands_whole_on_a_narrow_terminal(call):
    name = "a-shaft-with-a-name-as-long-as-it-may-be-sixty-letters-in-all"[:60]
    (call.folder / "long.toml").write_text(PAIR.replace('"fast"', f'"{name}"'), encoding="utf-8")
    assert name in call(["size", "long.toml"], columns=50).out


@pytest.mark.parametrize("locale", [{"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}, {"LC_ALL": "C"}])
def test_a_fresh_interpreter_in_a_plain_locale_prints_tables(tmp_path, locale):
    (tmp_path / "pair.toml").write_text(PAIR, encoding="utf-8")
    start = [sys.executable, "-c", "from gearwright.cli import main; main()", "size", "pair.toml"]
    done = subprocess.run(start, cwd=tmp_path, env={**os.environ, **locale}, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"stage.pinion" in done.stdout


@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-", "</dev/null 2>/dev/full"])
def test_streams_that_are_not_there_cost_nothing(tmp_path, closed):
    (tmp_path / "pair.toml").write_text(PAIR, encoding="utf-8")
    call = f"exec '{sys.executable}' -c 'from gearwright.cli import main; main()' check pair.toml {closed}"
    assert subprocess.run(["sh", "-c", call], cwd=tmp_path, capture_output=True, check=False).returncode == 0


def test_commands_print_through_one_place_alone():
    """What goes past it is neither cleaned nor folded, and dies of letters that a stream lacks."""
    import gearwright.cli

    for path in Path(gearwright.cli.__file__).parent.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        assert "typer.echo" not in text, path.name
        assert path.name == "terminal.py" or not re.search(r"\bprint\(|\bConsole\(\)", text), path.name
