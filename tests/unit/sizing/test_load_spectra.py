"""Load spectra by name: levels of a case's loads, said once."""

import pytest

from designs import PAIR, problem
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import edited, parse, read

RATED = PAIR + 'pinion_teeth = 30\nwheel_teeth = 90\n[gears]\nrating = "iso6336"\n'
WIND = "[spectra.wind]\nload = [1, 0.5, 0]\nshare = [0.25, 0.65, 0.1]\n"
NAMED = '[cases.a]\nshare = 1\nspectrum = "wind"\nturbine.rating = 1\n'
SPELT = (
    "[cases.a]\nshare = 0.25\nturbine.rating = 1\n[cases.b]\nshare = 0.65\nturbine.rating = 0.5\n"
    "[cases.c]\nshare = 0.1\nturbine.rating = 0\n"
)


def safeties(text):
    """Return S_H and S_F of both gears."""
    rating = size(parse(text)).meshes[0].rating
    return [*rating.pitting, *rating.bending]


def test_a_spectrum_is_its_levels_said_case_by_case():
    """Levels are parts of what the case says, shares parts of its time; equal up to rounding."""
    assert safeties(RATED + WIND + NAMED) == pytest.approx(safeties(RATED + SPELT), rel=1e-12)
    alone = '[service]\nspectrum = "wind"\n'
    assert safeties(RATED + WIND + alone) == pytest.approx(safeties(RATED + SPELT), rel=1e-12)


def test_a_spectrum_counts_in_the_share_of_its_case():
    """Two cases of half of the life with one spectrum are one case with it."""
    halves = NAMED.replace("share = 1", "share = 0.5")
    both = halves + halves.replace("[cases.a]", "[cases.b]")
    assert safeties(RATED + WIND + both) == pytest.approx(safeties(RATED + WIND + NAMED), rel=1e-12)


def test_bearings_live_by_the_levels_too():
    """ISO 281: 1/L = Σ share (level)^p for loads in proportion; the static safety is that of level 1."""
    design = read(shipped_design("ec120b-as-reported"))
    spectrum = {"load": [1.0, 0.6], "share": [0.2, 0.8]}
    levels = design.model_copy(
        update={"spectra": {"s": parse(RATED + WIND).spectra["wind"].model_copy(update=spectrum)}}
    )
    before, after = size(design), size(edited(levels, {"service.spectrum": "s"}))
    radial = 0
    for one, other in zip(before.bearings, after.bearings, strict=True):
        assert one.static_safety == other.static_safety
        if one.axial == 0.0:  # with an axial force Y of a ball bearing follows the load
            assert one.life / other.life == pytest.approx(0.2 + 0.8 * 0.6**3, rel=1e-9)
            radial += 1
    assert radial >= 2


@pytest.mark.parametrize(
    ("spectrum", "path", "words"),
    [
        (WIND.replace("0.65", "0.6"), "spectra.wind.share", "their sum is 0.95"),
        (WIND.replace("[1, 0.5, 0]", "[1, 0.5]"), "spectra.wind", "2 levels of load and 3 shares"),
        (WIND.replace("[1, 0.5, 0]", "[1.2, 0.5, 0]"), "spectra.wind.load", "the highest; give 0 to 1"),
        (WIND.replace("[1, 0.5, 0]", "[]"), "spectra.wind.load", "at least one"),
        (WIND.replace("spectra.wind", "spectra.wnid"), "cases.a.spectrum", "did you mean wnid"),
        ("", "cases.a.spectrum", "there is no spectrum 'wind'; none is defined"),
    ],
)
def test_what_is_no_spectrum_is_refused_by_path(spectrum, path, words):
    found = problem(RATED + spectrum + NAMED)
    assert found.path == path
    assert words in found.message


def test_a_limit_load_has_no_spectrum():
    static = NAMED.replace("share = 1", "static = true").replace("cases.a", "cases.b")
    found = problem(RATED + WIND + NAMED + static)
    assert found.path == "cases.b.spectrum"
    assert "counts no cycles" in found.message
