"""Where the templates of the HTML pages are, with the filters that they use."""

from __future__ import annotations

import re
from functools import cache

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

_SUBSCRIPT = re.compile(r"_([A-Za-z0-9α-ω.]*[A-Za-z0-9α-ω])")


@cache
def environment() -> Environment:
    """Return where the templates are, with the filters that they use."""
    templates = Environment(
        loader=PackageLoader("gearwright.render"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    templates.filters["symbols"] = symbols
    return templates


def symbols(words: str) -> Markup:
    """Return words whose ``m_n`` and the like are set with a subscript.

    Args:
        words: An equation or a symbol.
    """
    return Markup(_SUBSCRIPT.sub(r"<sub>\1</sub>", str(escape(words))))
