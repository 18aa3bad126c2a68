"""The data on the thesis: complete, and what it points to exists."""

from importlib import import_module
from pathlib import Path

import pytest

from gearwright.replays.pulvirenti.claims import EVIDENCE, STANDINGS, errata, printed_claims

VERIFICATION = Path(__file__).parents[2] / "verification"


def test_every_erratum_names_functions_that_exist():
    """`used` is a dotted name below the package; a renamed function must be renamed here, too."""
    for one in errata():
        for name in one.used:
            module, _, function = name.rpartition(".")
            assert hasattr(import_module(f"gearwright.{module}"), function), f"{one.equation}: {name}"


def test_every_proof_is_a_test_that_exists():
    """`proof` is a test of test_thesis_errata.py, or `file.test` of another file of the folder."""
    text = {path.stem: path.read_text(encoding="utf-8") for path in VERIFICATION.glob("test_*.py")}
    for one in errata():
        for name in one.proof:
            file, _, test = name.rpartition(".")
            assert f"def {test}(" in text[file or "test_thesis_errata"], f"{one.equation}: {name}"


def test_errata_use_the_known_words():
    assert {one.standing for one in errata()} == set(STANDINGS)
    assert {word for one in errata() for word in one.evidence} == set(EVIDENCE)


def test_what_is_wrong_on_provable_grounds_alone_is_proved_or_plain():
    """A formula that rests on nothing but a proof has one, unless the reason is one line of dimensions or sums."""
    plain = {"2.23", "2.28", "2.49", "3.11, appendix I_pt", "appendix theta_pII"}
    open_ones = {
        one.equation for one in errata() if one.standing == "wrong" and one.evidence == ("provable",) and not one.proof
    }
    assert open_ones == plain


def test_no_equation_and_no_claim_is_listed_twice():
    assert len({one.equation for one in errata()}) == len(errata())
    assert len({one.key for one in printed_claims()}) == len(printed_claims())


@pytest.mark.parametrize("claim", printed_claims(), ids=lambda claim: claim.key)
def test_the_wording_of_a_claim_covers_a_span(claim):
    assert claim.low < claim.high
    assert claim.covers(claim.low) and not claim.covers(claim.low - 1e-9)
