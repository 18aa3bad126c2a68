"""What every page that stands alone must be: closed tags, links that lead somewhere on it, nothing from outside."""

import re
from html.parser import HTMLParser


class _Balance(HTMLParser):
    def __init__(self):
        super().__init__()
        self.stack = []

    def handle_starttag(self, tag, attributes):
        if tag not in ("meta", "br"):
            self.stack.append(tag)

    def handle_endtag(self, tag):
        assert self.stack.pop() == tag


def stands_alone(page):
    """Assert all of it."""
    assert set(re.findall(r'href="#([^"]+)"', page)) <= set(re.findall(r'id="([^"]+)"', page))
    assert not re.search(r"https?:|src=|@import|<script[^>]|<link", page)
    parser = _Balance()
    parser.feed(page)
    assert parser.stack == []
