"""What every page that stands alone must be: closed tags, links that lead somewhere on it, nothing from outside."""

import re
from html.parser import HTMLParser

ENDED_BY = {"td": ("td", "th"), "th": ("td", "th"), "tr": ("td", "th", "tr")}
"""Start -> what it ends where that has no tag of its own: HTML leaves it to the writer."""
PACKED = re.compile(r'<script type="text/plain" id="live">[^/\s]*</script>')
"""Numbers and scripts of live figures, which no address can hide in."""


class Balance(HTMLParser):
    """Checks that tags close in order."""

    def __init__(self):
        super().__init__()
        self.stack = []

    def handle_starttag(self, tag, attributes):
        while self.stack and self.stack[-1] in ENDED_BY.get(tag, ()):
            self.stack.pop()
        if tag not in ("meta", "br"):
            self.stack.append(tag)

    def handle_endtag(self, tag):
        while self.stack[-1] in ("td", "th", "tr") and self.stack[-1] != tag:
            self.stack.pop()
        assert self.stack.pop() == tag


def stands_alone(page):
    """Assert all of it."""
    assert set(re.findall(r'href="#([^"]+)"', page)) <= set(re.findall(r'id="?([^">]+)"?', page))
    page = re.sub(r' xmlns="[^"]+"', "", PACKED.sub("", page))
    assert not re.search(r"https?:|src=|@import|<script[^>]|<link", page)
    parser = Balance()
    parser.feed(page)
    assert parser.stack == []
