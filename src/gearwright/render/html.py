"""Where the templates of the HTML pages are, with the filters that they use."""

import re
from functools import cache

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from gearwright.render.style import mathml

_SUBSCRIPT = re.compile(
    r"`([^`]+)`|(?<![\w.])([A-Za-zα-ωΑ-Ω]{1,2}[′*]?)_([A-Za-z0-9α-ω.]*[A-Za-z0-9α-ω])(?![A-Za-z0-9_α-ω])"
)
"""Code between backticks, or a symbol of one or two letters with its index: keys of files have longer names."""


@cache
def environment(package: str = "gearwright.render") -> Environment:
    """Return where the templates of a package are, with the filter that all of them use.

    Args:
        package: The one beside whose modules the folder ``templates`` is.
    """
    templates = Environment(
        loader=PackageLoader(package),
        autoescape=_is_html,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    templates.filters["symbols"] = symbols
    templates.filters["mathml"] = _mathematics
    templates.filters["exact"] = exact
    templates.filters["lean"] = lean
    return templates


def _is_html(template: str | None) -> bool:
    """Tell whether a template is HTML; Markdown is left as it is."""
    return template is None or ".html" in template


def symbols(words: str) -> Markup:
    """Return words whose ``m_n`` and the like are set with a subscript.

    Args:
        words: An equation or a symbol.
    """
    return Markup(_SUBSCRIPT.sub(_set, str(escape(words))))


def exact(number: float, text: str) -> Markup:
    """Return the attribute that holds a number's further digits; nothing where its text has all of them.

    Args:
        number: Of a cell.
        text: As it is read.
    """
    value = f"{number:.7g}"
    try:
        said = float(text.replace("−", "-"))
    except ValueError:
        return Markup(f" data-v={value}")
    return Markup("" if said == float(value) else f" data-v={value}")


def _set(match: re.Match[str]) -> str:
    code, symbol, index = match.groups()
    return f"<code>{code}</code>" if code else f"{symbol}<sub>{index}</sub>"


_INDENTED = re.compile(r"^[ \t]+|^/\*[^\n]*\*/\n", re.MULTILINE)


def lean(script: str) -> Markup:
    """Return a script or a style of ours without what only its readers need: indents, and comments of one line.

    Args:
        script: Without texts of several lines.
    """
    return Markup(_INDENTED.sub("", script))


def _mathematics(formula: str) -> Markup:
    return Markup(mathml(formula))
