"""What pages tell a reader to do is done, and what they show is what comes.

Blocks titled with a file name are written, commands after a prompt are run line by line in one folder for each page,
and every line shown must come, in this order; ``…`` stands for lines that are left out. Python examples are doctests.
After a change of what the tool prints: python docs/shown.py.
"""

import importlib.util
import random
import re
import sys
from importlib import import_module
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"


def beside(name):
    """Return a script of the documentation's folder, which is no package."""
    spec = importlib.util.spec_from_file_location(f"docs_{name}", DOCS / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


shown = beside("shown")


def fences(page):
    return list(shown.FENCE.finditer((DOCS / page).read_text(encoding="utf-8")))


def steps(page):
    return [step for fence in fences(page) if shown.has_steps(fence) for step in shown.steps(fence["text"])]


def has_examples(page):
    return any(">>> " in fence["text"] for fence in fences(page))


def extras(page):
    return {
        shown.NEEDS[name] for name in (page, *(Path(step.script).name for step in steps(page))) if name in shown.NEEDS
    }


SHOWING = [page for page in shown.pages() if steps(page) or has_examples(page) or page in shown.NUMBERS]


@pytest.mark.parametrize(
    "page", [pytest.param(page, marks=[pytest.mark.extra(*extras(page))] if extras(page) else []) for page in SHOWING]
)
def test_a_page_shows_what_comes(page):
    """Commands, examples in Python and computed numbers of sentences; after a change: python docs/shown.py."""
    text, lost = shown.made(page, quick=True)
    assert lost == []
    assert text.splitlines() == (DOCS / page).read_text(encoding="utf-8").splitlines()


def test_shown_output_stands_after_a_prompt_where_it_is_compared():
    """Fences without a prompt are commands alone, drawings and formulas: no line of theirs is a result."""
    told = re.compile(r"\bkg\b|contradicts|worst margin")
    for page in shown.pages():
        for fence in fences(page):
            if fence["kind"] in ("", "text") and not shown.has_steps(fence):
                assert not told.search(fence["text"]), f"{page}: {fence[0]}"


def test_comments_after_code_give_no_results():
    """Results are shown by doctests, which are compared."""
    result = re.compile(r"\S.*#\s*[(\[]?[^#a-zA-Z]*\d+\.\d")
    for page in shown.pages():
        for fence in fences(page):
            if fence["kind"] == "python" and ">>> " not in fence["text"]:
                assert not [line for line in fence["text"].splitlines() if result.search(line)], page


def test_lines_whose_numbers_have_moved_are_found_again():
    """Every digit of a shown table made another, the lines come back as they were, and those left out stay so."""
    written = [
        "Train",
        "",
        " first.sun   1.25 kg   40 mm",
        " first.ring  3.10 kg   55 mm",
        " shaft       0.75 kg",
        "Sum 5.1 kg",
    ]
    page = [written[0], "…", written[3], written[4], "…", written[5]]
    moved = [re.sub(r"\d", lambda _: random.Random(1).choice("6789"), line) for line in page]
    assert moved != page
    assert shown.renewed(moved, written) == (page, [])
    assert shown.renewed([*moved[:3], "a line of another table"], written)[1] == ["a line of another table"]


def test_one_line_that_is_shown_alone_is_found_again():
    assert shown.renewed(["mass 2 kg"], ["title", "mass 3 kg"]) == (["mass 3 kg"], [])


def test_numbers_of_sentences_are_found_below_their_command_or_computed(monkeypatch):
    """Several in one sentence; a sentence or a result that is not there is said."""
    below = r"^\$ b\n(?:(?!\$ ).*\n)*?mass ([\d.]+) kg, at ([\d.]+)"
    told = [("weighs {} kg at {:.1f} rpm", below), ("of {:.0f} and −{:.2f} %", lambda: [2.6, 0.125])]
    monkeypatch.setattr(shown, "NUMBERS", {"page": told})
    came = ["$ a", "mass 1 kg, at 2", "$ b", "title", "mass 3.50 kg, at 4"]
    page = "It weighs 9.99 kg at 0 rpm, for want of 7 and −8.1 %."
    assert shown.with_numbers("page", page, came) == "It weighs 3.50 kg at 4.0 rpm, for want of 3 and −0.12 %."
    with pytest.raises(ValueError, match="nothing that it shows"):
        shown.with_numbers("page", page, came[:3])
    for wrong in ("", page + page):
        with pytest.raises(ValueError, match="write them as they are, once"):
            shown.with_numbers("page", wrong, came)


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
    assert shown.missing(["a", "c"], ["a", "b", "c"]) is None
    assert shown.missing(["c", "a"], ["a", "b", "c"]) == "a"
    assert shown.missing(["a b"], ["a"]) == "a b"
