"""The page of a life of several missions: whole, alone, and the same each time."""

import re
from functools import cache

from gearwright.mission import fly_mix
from gearwright.render.pages.flight import mix_page
from gearwright.render.words.flights import totals, verdict
from gearwright.spec import read_mix
from html_checks import PACKED
from shipped_work import sized


@cache
def flown():
    """Return the life of the shipped mix."""
    return fly_mix(sized(), read_mix("regional-life"))


@cache
def page():
    """Return its page."""
    return mix_page(flown())


def test_the_page_asks_nothing_of_any_other_place_and_is_the_same_each_time():
    assert not re.search(r"(?:src|href)=[\"'](?!#)|url\((?!#)|@import", page())
    assert not re.search(r"<script[^>]", PACKED.sub("", page()))
    assert mix_page(flown()) == page()


def test_every_id_is_there_once():
    ids = re.findall(r'\bid="([^"]+)"', page())
    assert len(ids) == len(set(ids))


def test_the_page_says_what_the_terminal_says_and_shows_every_mission():
    told = page().replace("&#39;", "'")
    assert verdict(flown()) in told
    assert totals(flown()) in told
    for name in flown().flights:
        assert f"{name}: phases and who drives in them." in told


def test_a_long_heading_has_a_row_of_its_own_that_wraps():
    """A verdict of 120 letters ran out of its box at 1100 px, and the others with it."""
    assert '<div class="verdict bad"><p class="word">Does not live</p>' in page()
    assert not re.search(r"dl\.key dd \{[^}]*nowrap", page())
