"""What a shell is offered: commands, shipped names and files."""

import os
import subprocess
import sys

import pytest


def offered(folder, *words, at=None):
    """Return what bash is offered for the last word."""
    line = " ".join(("gearwright", *words))
    asked = {"_GEARWRIGHT_COMPLETE": "complete_bash", "COMP_WORDS": line, "COMP_CWORD": str(at or len(words))}
    script = "import sys; sys.argv = ['gearwright']; from gearwright.cli import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=folder, env={**os.environ, **asked}, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    return done.stdout.split()


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("cam",), ["campbell"]),
        (("run", "in-line-h2"), ["in-line-h2", "in-line-h2-star"]),
        (("run", "inl"), ["inland.toml"]),
        (("size", "sub/"), ["sub/mine.toml"]),
        (("fly", "in-line", "thesis-"), ["thesis-chapter-4"]),
        (("study", "motor-speed-"), ["motor-speed-uncertainty"]),
        (("new", "ec120b-s"), ["ec120b-sortie"]),
    ],
)
def test_a_shell_is_offered_commands_shipped_names_and_files(tmp_path, words, expected):
    (tmp_path / "inland.toml").touch()
    (tmp_path / "notes.txt").touch()
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "mine.toml").touch()
    assert offered(tmp_path, *words) == expected


@pytest.mark.parametrize(
    ("shell", "speaks"),
    [
        ("bash", "complete -o default -F"),
        ("zsh", "#compdef gearwright"),
        ("fish", "complete --command gearwright"),
        ("powershell", "Register-ArgumentCompleter"),
    ],
)
def test_the_script_of_a_shell_is_shown(shell, speaks):
    """By its name: which shell calls is found from the parents of a process, which a test may not have."""
    script = "import sys; sys.argv = ['gearwright', '--show-completion', %r]; from gearwright.cli import main; main()"
    env = {**os.environ, "_TYPER_COMPLETE_TEST_DISABLE_SHELL_DETECTION": "1"}
    done = subprocess.run([sys.executable, "-c", script % shell], env=env, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert speaks in done.stdout
    assert "_GEARWRIGHT_COMPLETE" in done.stdout
