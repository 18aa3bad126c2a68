"""What the tutorial and the how-to pages tell a reader to do is done, and what they show is what comes.

Blocks titled with a file name are written, ``console`` blocks are run line by line in one folder for each page, and
every line shown must come, in this order; ``…`` stands for lines that are left out. Python examples are doctests.
"""

import doctest
import re
import shlex
import shutil
from importlib import import_module
from pathlib import Path

import pytest

from gearwright.cli import main

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = ["index.md", "tutorial.md", *(f"how-to/{path.name}" for path in sorted((DOCS / "how-to").glob("*.md")))]
LONG = re.compile(r"\d+\.\d{9,}(?:e[-+]\d+)?")
"""Numbers to the last bit, in which processors differ."""
BLOCK = re.compile(r'^```(?P<kind>toml title="(?P<file>[^"]+)"|console)\n(?P<text>.*?)^```$', re.DOTALL | re.MULTILINE)
EXAMPLES = [
    "how-to/openmdao.md",
    "how-to/python.md",
    "how-to/rotors.md",
    "theory/rotors.md",
    "theory/power-flow.md",
    "theory/first-sizing.md",
]
SCRIPTS = ["how-to/gear-dynamics.md"]
"""Pages about one script, which is run by a test of its own."""
EXAMPLES_OF = {"how-to/other-tools.md": [ROOT / "tests" / "rexs" / "examples" / "fva_2stage_1.4.rexs"]}
"""Page -> files that it says a reader finds in a clone."""


def run(command, monkeypatch, capsys):
    """Return what a command writes to both streams."""
    monkeypatch.setattr("sys.argv", shlex.split(command))
    try:
        main()
    except SystemExit as end:
        assert end.code in (0, None, 1, 2), command
    written = capsys.readouterr()
    return (written.out + written.err).splitlines()


def steps(text):
    """Yield every command of a console block with the lines that are shown after it."""
    for part in re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]:
        command, *shown = part.splitlines()
        yield command, [line.rstrip() for line in shown if line != "…"]


def missing(shown, written):
    """Return the first line that is shown and does not come in its turn."""
    rest = iter(rounded(line.rstrip()) for line in written)
    return next((line for line in shown if not any(rounded(line) == given for given in rest)), None)


def rounded(line):
    """Return a line without what a processor may round otherwise."""
    return LONG.sub(lambda number: f"{float(number[0]):.9g}", line)


@pytest.mark.parametrize("page", PAGES)
def test_the_commands_of_a_page_print_what_it_shows(page, tmp_path, monkeypatch, capsys):
    """100 columns, as on the pages."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "100")
    for example in EXAMPLES_OF.get(page, []):
        shutil.copy(example, tmp_path)
    tried = 0
    for block in BLOCK.finditer((DOCS / page).read_text(encoding="utf-8")):
        if block["file"]:
            (tmp_path / block["file"]).write_text(block["text"], encoding="utf-8")
            continue
        for command, shown in steps(block["text"]):
            written = run(command, monkeypatch, capsys)
            assert written, command
            assert missing(shown, written) is None, "\n".join([f"$ {command}", *written])
            tried += 1
    assert tried or page in (*EXAMPLES, *SCRIPTS)


@pytest.mark.parametrize("page", EXAMPLES)
def test_the_python_of_a_page_gives_what_it_shows(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    failed, tried = doctest.testfile(str(DOCS / page), module_relative=False, encoding="utf-8")
    assert tried > 3 and failed == 0


IMPORT = re.compile(r"^from (gearwright[\w.]*) import (?:\(([^)]*)\)|([^\n(#]+))", re.MULTILINE)


@pytest.mark.parametrize("page", [ROOT / "README.md", *sorted(DOCS.rglob("*.md"))], ids=lambda page: page.name)
def test_every_name_that_a_page_imports_is_there(page):
    """Also in examples that are not run as doctests."""
    text = re.sub(r"^(?:>>>|\.\.\.) ", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE)
    for module, several, one in IMPORT.findall(text):
        for name in re.findall(r"\w+", several or one):
            assert hasattr(import_module(module), name), f"{module}.{name}"


def test_a_line_that_does_not_come_is_noticed():
    """The comparison itself: order counts, lines between do not."""
    assert missing(["a", "c"], ["a", "b", "c"]) is None
    assert missing(["c", "a"], ["a", "b", "c"]) == "a"
    assert missing(["a "], ["a"]) == "a "
