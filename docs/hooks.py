"""What the documentation's build adds: formulas as MathML, the notebooks as they run, and the changelog.

Formulas are LaTeX between dollar signs and become MathML while the site is built, so that a reader's browser needs no
script and no request for them. Code is left alone.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))
import gallery
from latex2mathml.converter import convert
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

_CODE_OR_FORMULA = re.compile(
    r"^(?P<fence> {0,3}(?:```|~~~)).*?^(?P=fence)[^\n]*$"  # fenced code
    r"|^(?: {4}|\t)[^\n]*$"  # indented code
    r"|(?P<ticks>`+)(?!`).*?(?<!`)(?P=ticks)(?!`)"  # code in a line
    r"|\$\$(?P<block>[^$]+)\$\$"
    r"|(?<![\\$\w])\$(?P<line>[^\s$](?:[^$\n]*[^\s$])?)\$(?![\w$])",
    re.DOTALL | re.MULTILINE,
)
_shown: dict[str, list[str]] = {}
"""Page of a notebook -> what its cells show as HTML, in order; until the page is made only."""
_formulas: dict[str, list[str]] = {}
"""Page -> its formulas as MathML, in order; between the two events of a page only."""


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the changelog, which lies beside the documentation's folder."""
    changelog = Path(config.config_file_path).with_name("CHANGELOG.md").read_text(encoding="utf-8")
    files.append(File.generated(config, "changelog.md", content=changelog))
    for notebook in sorted(gallery.NOTEBOOKS.glob("*.ipynb")):
        uri = f"notebooks/{notebook.stem}.md"
        text, _shown[uri] = gallery.page(notebook, gallery.executed(notebook))
        files.append(File.generated(config, uri, content=text))
    return files


def on_page_markdown(markdown: str, page: Page, **_: Any) -> str:
    """Set a mark in the place of every formula, so that Markdown does not touch it."""
    text, _formulas[page.file.src_uri] = taken_out(markdown)
    return text


def on_page_content(html: str, page: Page, **_: Any) -> str:
    """Put the formulas in."""
    whole = put_in(html, _formulas.pop(page.file.src_uri))
    for place, shown in enumerate(_shown.pop(page.file.src_uri, [])):
        whole = whole.replace(f"<p>{gallery.mark(place)}</p>", shown)
    return whole


def taken_out(markdown: str) -> tuple[str, list[str]]:
    """Return a text with marks instead of its formulas, and the formulas as MathML."""
    found: list[str] = []

    def mark(match: re.Match[str]) -> str:
        block, line = match["block"], match["line"]
        if block is None and line is None:
            return match[0]
        found.append(convert(block or line, display="block" if block else "inline"))
        return _mark(len(found) - 1)

    return _CODE_OR_FORMULA.sub(mark, markdown), found


def put_in(html: str, formulas: list[str]) -> str:
    """Return a page with its formulas in the place of the marks."""
    for number, formula in enumerate(formulas):
        html = html.replace(_mark(number), formula)
    return html


def _mark(number: int) -> str:
    return f"FORMULA{number}HERE"
