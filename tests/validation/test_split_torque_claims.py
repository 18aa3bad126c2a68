"""The paper's claims: which hold, which hold under a condition, which do not, and the page that shows them."""

from __future__ import annotations

import pytest
from split_torque import shipped

from gearwright.dynamics.sharing import sharing_problem, sharing_study
from gearwright.render.pages.motion import sharing_page
from gearwright.replays import paper_on
from gearwright.replays.replay import Verdict
from gearwright.replays.wang.claims import split_torque, split_torque_claims
from gearwright.sizing import size

VERDICTS = {
    "Without floating": Verdict.HOLDS,
    "Sharing becomes better": Verdict.CONDITION,
    "The displacement": Verdict.HOLDS,
    "Vibration decreases": Verdict.FAILS,
    "Eccentric gears 4 and 5": Verdict.CONDITION,
    "Of the shafts": Verdict.CONDITION,
    "One error can make": Verdict.FAILS,
    "Axial errors": Verdict.CONDITION,
    "An eccentric shaft 1": Verdict.HOLDS,
    "Cutting one error": Verdict.HOLDS,
}


@pytest.fixture(scope="module")
def sizing():
    return size(shipped())


def test_verdicts_are_those_of_the_independent_reproduction(sizing):
    """Each from its own numbers; an independent program for the same equations came to the same ten."""
    found = {claim.printed: claim.verdict for claim in split_torque_claims(sizing, split_torque(sizing.design))}
    assert len(found) == len(VERDICTS)
    for start, verdict in VERDICTS.items():
        assert next(each for words, each in found.items() if words.startswith(start)) is verdict


def test_page_has_every_figure_of_the_paper(sizing):
    page = sharing_page(sizing, [sharing_study(sharing_problem(sizing))], paper=paper_on(sizing))
    for caption in ("Figure 3:", "Figure 4:", "Figure 6:", "Figures 5 and 7:", "Figures 8 to 18:"):
        assert caption in page
    assert page.count('class="said ') == len(VERDICTS)
