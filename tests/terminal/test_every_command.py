"""Every command on terminals of two widths, without colours, piped, to a full disk, to nobody, in small alphabets."""

import re
from pathlib import Path

import pytest
from commands import COMMANDS, SERVING, Command

from gearwright.cli import app

DONE, FAILED, INTERRUPTED, BROKEN_PIPE = 0, 1, 130, 141
README = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
STEERING = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")
COLOUR = re.compile(r"\x1b\[(?:[0-9]+;)*[349][0-9]")
each_command = pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command.line)


def plain(text: str) -> str:
    """Return what is read of a terminal: without colours and without what a bar of progress wrote and wiped."""
    return STEERING.sub("", re.sub(r"[^\n]*\r", "", text))


def words(text: str) -> set[str]:
    """Return the words that are printed; rules of tables are none."""
    return {word for word in plain(text).split() if word.strip("─-+|")}


def test_the_table_has_every_command_of_the_readme_and_of_the_tool():
    tried = {command.words[0] for command in COMMANDS}
    table = "".join(line for line in README.splitlines() if line.startswith("| `gearwright"))
    named = {word for code in re.findall(r"`([^`]+)`", table) if (word := code.removeprefix("gearwright ").split()[0])}
    registered = {entry.name or entry.callback.__name__ for entry in app.registered_commands if not entry.hidden}
    assert registered <= tried | SERVING
    assert {name for name in named if name in registered} == registered


@each_command
def test_on_a_terminal_of_80_columns_every_word_stands_whole(call, command: Command):
    """Every word that is piped stands on the terminal too, and no line is wider than it."""
    piped = call(command.words)
    shown = call(command.words, columns=80)
    assert (piped.code, piped.err.count("Traceback"), shown.code) == (DONE, 0, DONE), piped.err + shown.out
    assert "Traceback" not in shown.out
    if command.machine:
        assert plain(shown.out) == piped.out
        return
    wide = [line for line in plain(shown.out).splitlines() if len(line) > 80 and len(line.split()) > 1]
    assert not wide
    if not command.narrow:
        assert words(piped.all) <= words(shown.out)


@each_command
def test_on_a_terminal_of_200_columns_it_runs(call, command: Command):
    shown = call(command.words, columns=200, NO_COLOR="1")
    assert shown.code == DONE, shown.out
    assert "Traceback" not in shown.out
    assert not COLOUR.search(shown.out)


@each_command
def test_on_a_dumb_terminal_nothing_steers_it(call, command: Command):
    shown = call(command.words, columns=80, TERM="dumb")
    assert shown.code == DONE, shown.out
    assert "\x1b" not in shown.out


@each_command
def test_a_full_disk_behind_standard_output_is_told(call, command: Command):
    full = call(command.words, output="/dev/full")
    assert full.code == FAILED
    assert full.err.splitlines()[-1] == "standard output cannot be written: No space left on device"
    assert "Traceback" not in full.err


@each_command
def test_when_nobody_reads_it_ends_without_a_word(call, command: Command):
    closed = call(command.words, output="closed")
    assert closed.code == BROKEN_PIPE
    assert "Traceback" not in closed.err
    assert "Broken pipe" not in closed.err


@each_command
@pytest.mark.parametrize("encoding", ["ascii", "cp1252"])
def test_small_alphabets_are_enough(call, command: Command, encoding: str):
    shown = call(command.words, PYTHONIOENCODING=encoding)
    assert shown.code == DONE, shown.err
    assert "Traceback" not in shown.err
    assert "Error" not in shown.err


@each_command
def test_ctrl_c_ends_with_130_and_leaves_nothing_that_looks_complete(call, command: Command):
    before = {path: path.read_bytes() for path in call.folder.rglob("*") if path.is_file()}
    stopped = call(command.words, interrupt=1)
    assert stopped.code == INTERRUPTED, stopped.all
    assert stopped.err.startswith("interrupted")
    assert "Traceback" not in stopped.err
    assert {path: path.read_bytes() for path in call.folder.rglob("*") if path.is_file()} == before
