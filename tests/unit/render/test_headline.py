"""The same gearbox has the same worst entry on every page that looks at the same; who looks at less says so."""

import html
import io
import re
from dataclasses import replace
from functools import cache

import pytest
from rich.console import Console

from gearwright.checks import Check, Status, not_assessed
from gearwright.identity import Kind, PartId
from gearwright.particulars import particulars
from gearwright.render.figures.masses import margin_figure
from gearwright.render.pages.flight import flight_page
from gearwright.render.pages.report import report, warnings
from gearwright.render.pages.studies import comparison, study_page
from gearwright.render.words.flights import flight_text
from gearwright.render.words.review import review_text
from gearwright.render.words.sizing import energy_text, headline, said_of, sizing_headline
from gearwright.reviews import Review, review_of
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.mass import CompleteMass, Statistics
from gearwright.spec import parse, parse_study, read
from gearwright.study import run
from shipped_work import flown, flown_review, ground_review, lives, sized

DESIGN = read(shipped_design("in-line-h2"))
STUDY = parse_study(
    'schema = 1\nname = "one"\ndesigns = ["in-line-h2"]\nresults = ["review.worst", "review.margin", "review.verdict",'
    ' "mass", "worst_margin"]\n[objectives]\nmass = "minimum"\n'
)


@cache
def table():
    """Return the one row of the study."""
    return run(STUDY, {"in-line-h2": DESIGN})


def plain(shown):
    """Return what a terminal of great width shows."""
    console = Console(file=io.StringIO(), width=400)
    console.print(shown)
    return console.file.getvalue()


def said(page):
    """Return a page without its marks."""
    return html.unescape(re.sub(r"<[^>]+>", "", page))


def shows(page, reviewed):
    """Whether a page has verdict and worst entry of a review, folded as it may be, an index above or below."""
    words, shown = (" ".join(text.replace("_", "").lower().split()) for text in (said_of(reviewed), said(page)))
    return words in shown and str(reviewed.verdict) in shown


PAGES = {
    "review": lambda: plain(review_text(ground_review())),
    "report": lambda: report(sized(), review=ground_review()),
    "comparison": lambda: comparison(table(), {"in-line-h2": sized()}, {"in-line-h2": ground_review()}),
    "study page": lambda: study_page(STUDY, table(), {"in-line-h2": DESIGN}),
}
FLOWN_PAGES = {
    "review": lambda: plain(review_text(flown_review())),
    "fly": lambda: flight_text(flown(), lives(), flown_review()),
    "flight page": lambda: flight_page(flown(), lives(), flown_review()),
}


@pytest.mark.parametrize("page", PAGES)
def test_pages_without_a_mission_show_the_worst_entry_of_the_review(page):
    assert shows(PAGES[page](), ground_review())
    assert "worst margin 1.000" not in said(PAGES[page]())


@pytest.mark.parametrize("page", FLOWN_PAGES)
def test_pages_of_a_flight_show_the_worst_entry_of_the_flown_review(page):
    assert shows(FLOWN_PAGES[page](), flown_review())
    assert not shows(FLOWN_PAGES[page](), ground_review())


def test_a_study_gives_the_worst_entry_by_name():
    (row,) = table().rows
    assert row.results["review.worst"].value == ground_review().worst.name
    assert row.results["review.margin"].value == ground_review().worst.margin
    assert row.results["review.verdict"].value == str(ground_review().verdict)


def test_a_sizing_says_what_it_did_not_look_at():
    told = sizing_headline(sized())
    assert told.startswith(f"{len(sized().checks)} sizing checks pass, the worst: ")
    assert told.endswith("peaks, resonances and lives: gearwright review")
    assert " ".join(told.split()) in " ".join(said(report(sized())).split())
    unseen = not_assessed(PartId(Kind.SHAFT, "input"), "slope", "table", "nothing says where its bearings stand")
    less = replace(sized(), checks=(*sized().checks, unseen))
    assert sizing_headline(less) == told.replace("; peaks,", "; 1 not assessed; peaks,")


def test_a_sizing_whose_worst_check_fails_says_what_helps():
    part = PartId(Kind.MESH, "first")
    near, far = (Check(part, "main resonance", "law", value, 0.15, why="more teeth help") for value in (0.05, 0.2))
    assert "law): margin 0.333; more teeth help; peaks" in sizing_headline(replace(sized(), checks=(near,)))
    assert "more teeth help" not in sizing_headline(replace(sized(), checks=(far,)))


def test_a_headline_counts_what_fails_what_is_waived_and_what_is_open():
    part = PartId(Kind.SHAFT, "mast")
    checks = (Check(part, "slope", "table", 0.9, 1.0), Check(part, "fatigue", "law", 0.5, 1.0, waiver="an old shaft"))
    reviewed = Review("one", "", checks, {}, CompleteMass("one", (), 1.0), Statistics(None, None, None, ""))
    assert headline(reviewed) == (
        "fails: the worst is mast: slope 0.9000, limit 1.000 (table): margin 0.900; 1 fails, 1 waived"
    )
    assert headline(Review("one", "", (), {}, reviewed.complete, reviewed.statistics)).startswith("nothing is assessed")


def test_a_waived_failure_is_shown_as_such_with_its_reason():
    text = shipped_design("in-line-h2").read_text(encoding="utf-8")
    text += '[waivers]\n"gearbox resonance of second mesh x 2" = "measured: silent"\n"input Tresca" = "thick"\n'
    sizing = size(parse(text))
    reviewed = review_of(sizing)
    (found,) = reviewed.waived
    assert found.status is Status.FAILS
    for page in (plain(review_text(reviewed)), said(report(sizing, review=reviewed))):
        assert "measured: silent" in page
        assert "The waiver of input Tresca is not needed: it passes" in page
    assert any("waived: measured: silent" in words for words in warnings(particulars(sizing), {}, reviewed))


def test_a_waived_failure_is_no_longer_too_small_in_the_figure():
    thin = shipped_design("in-line-h2").read_text(encoding="utf-8") + '[overrides]\n"input.diameter_mm" = 20\n'
    for text, words in ((thin, "too small"), (thin + '[waivers]\n"input Tresca" = "as drawn"\n', "waived")):
        labels = margin_figure(size(parse(text))).texts()
        assert sum(label.endswith(words) for label in labels) == 1


def test_an_energy_book_that_closes_says_so():
    assert energy_text(0.0) == "to rounding"
    assert energy_text(3.2e-7) == "within 3.2e-07"


def test_the_review_of_a_case_can_still_be_asked_after_a_study_had_results_of_reviews():
    """A module loaded on the way, named as the function, once took its place."""
    from gearwright.study import cases

    assert table().rows[0].results["review.worst"].value == cases.reviewed(STUDY, DESIGN, {})[1].worst.name
