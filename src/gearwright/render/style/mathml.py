"""Formulas as they stand in the code, such as ``σ_H = Z_H √(F_t/(d_1 b))``, as mathematics that a browser sets."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from html import escape

_ABOVE = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻½ᵀ"
_INDEX = rf"[^\W_{_ABOVE}]"
_TOKEN = re.compile(
    r"(?P<space>\s+)"
    r"|(?P<number>\d+(?:\.\d+)?)"
    r"|(?P<operator>[ΣΠ])"
    rf"|(?P<raised>[{_ABOVE}]+)"
    rf"|(?P<name>[^\W\d_{_ABOVE}]+\u0307?(?:'s\b)?(?:[′*](?![^\W_]))*)(?:_(?P<below>{_INDEX}+(?:[.*]{_INDEX}+)*(?:[,-][^\W\d_]+)*))?"
    r"|(?P<sign>.)"
)
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻ᵀ", "0123456789−T")
_FUNCTIONS = {"sin", "cos", "tan", "cot", "inv", "ln", "log", "exp", "max", "min"}
_SIGNS = set("=+−·×≥≤<>±∓Σ∫Π∝→")
_GREEK = re.compile(r"[α-ωΑ-Ωϑϕ]")
_MATHEMATICS = re.compile(r"[=√Σ∫Πα-ωΑ-Ωϑ²³⁴^]|_|\d")
_WORD = re.compile(r"[^\W\d_]{3}")
_THIN = "<mspace width=.22em />"
_ROOT, _OVER, _POWER = "√", "/", "^"


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    below: str = ""


@cache
def mathml(formula: str) -> str:
    """Return a formula as MathML; what is words alone comes back as words. Both are safe in HTML.

    Args:
        formula: In the trade's symbols: ``_`` sets what follows below, ``^`` or a raised digit above, ``√`` takes what
            stands next, ``/`` divides its neighbours, and with blanks around it all that is multiplied before it.

    >>> mathml("its gears")
    'its gears'
    >>> mathml("T/r")
    '<math><mfrac><mi>T</mi><mi>r</mi></mfrac></math>'
    """
    if not _MATHEMATICS.search(formula) and _WORD.search(formula):
        return escape(formula)
    return f"<math>{_Reader(_tokens(formula)).sum_to('')}</math>"


def _tokens(formula: str) -> list[_Token]:
    made = []
    for match in _TOKEN.finditer(formula):
        kind = match.lastgroup if match.lastgroup != "below" else "name"
        kind = "sign" if kind == "operator" else kind
        made.append(_Token(kind or "sign", match["name"] or match[0], match["below"] or ""))
    return made


class _Reader:
    """Reads tokens from left to right."""

    def __init__(self, tokens: list[_Token]) -> None:
        self.tokens = tokens
        self.at = 0

    def peek(self, ahead: int = 0) -> _Token:
        place = self.at + ahead
        return self.tokens[place] if place < len(self.tokens) else _Token("end", "")

    def sum_to(self, closing: str) -> str:
        """Return all up to a closing sign, signs between products."""
        parts: list[str] = []
        while self.peek().kind != "end" and not (closing and self.peek().text == closing):
            token = self.peek()
            if token.kind == "space":
                self.at += 1
            elif token.kind == "sign" and token.text in _SIGNS:
                self.at += 1
                parts.append(f"<mo>{escape(token.text)}</mo>")
            elif token.kind == "sign" and token.text in ",;:":
                self.at += 1
                parts.append(f"<mtext>{token.text}&#160;</mtext>")
            else:
                parts.append(self.product(closing))
        return "".join(parts)

    def product(self, closing: str) -> str:
        """Return factors one beside the other, with their fractions."""
        factors: list[str] = []
        while True:
            token = self.peek()
            spaced = token.kind == "space"
            following = self.peek(1) if spaced else token
            ends = following.kind == "end" or (closing != "" and following.text == closing)
            if ends or (following.kind == "sign" and (following.text in _SIGNS or following.text in ",;:")):
                break
            self.at += spaced
            if following.text == _OVER and following.kind == "sign":
                self.at += 1
                self.at += self.peek().kind == "space"
                above = _row(factors) if spaced else (factors.pop() if factors else "<mrow></mrow>")
                factors = [] if spaced else factors
                below = self.factor()
                factors.append(f"<mfrac>{_bare(above)}{_bare(below)}</mfrac>")
            else:
                factors.append(self.factor())
        return _beside(factors)

    def factor(self) -> str:
        """Return one factor with what stands above it; a function takes what stands next."""
        function = self.peek().kind == "name" and self.peek().text in _FUNCTIONS
        made = self.raised()
        if function and self.peek().kind == "space" and self.peek(1).kind in ("name", "number"):
            self.at += 1
            return f"<mrow>{made}{_THIN}{self.factor()}</mrow>"
        return made

    def raised(self) -> str:
        """Return one atom with what stands above it."""
        made = self.atom()
        while True:
            token = self.peek()
            if token.kind == "raised":
                self.at += 1
                above = f"<mn>{token.text.translate(_RAISED)}</mn>"
            elif token.kind == "sign" and token.text == _POWER:
                self.at += 1
                above = _bare(self.atom())
            else:
                return made
            made = f"<msup>{made}{above}</msup>"

    def atom(self) -> str:
        """Return a number, a symbol, a root, what stands in parentheses, or a word."""
        token = self.peek()
        self.at += 1
        if token.kind == "number":
            return f"<mn>{token.text}</mn>"
        if token.kind == "name":
            return _named(token)
        if token.text == _ROOT:
            return f"<msqrt>{self._under_root()}</msqrt>"
        if token.text in "([":
            closing = ")" if token.text == "(" else "]"
            inside = self.sum_to(closing)
            closed = self.peek().text == closing
            self.at += closed
            end = f"<mo stretchy=false>{closing}</mo>" if closed else ""
            return f"<mrow><mo stretchy=false>{token.text}</mo>{inside}{end}</mrow>"
        if token.text in ("−", "+"):
            return f"<mrow><mo>{token.text}</mo>{self.factor()}</mrow>"
        return "<mrow></mrow>" if token.kind == "end" else f"<mtext>{escape(token.text)}</mtext>"

    def _under_root(self) -> str:
        """Return what a root is taken of: what stands in parentheses, one symbol, or a function with its argument."""
        first = self.peek().text
        made = _bare(self.atom())
        if first in _FUNCTIONS and self.peek().kind == "space":
            self.at += 1
            made += f"{_THIN}{self.atom()}"
        return made


def _named(token: _Token) -> str:
    """Return a symbol, upright where it is a function or a word."""
    name = escape(token.text)
    short = len(re.sub(r"[′*\u0307]", "", token.text)) == 1
    if token.text in _FUNCTIONS or (not short and not _GREEK.search(token.text) and token.below):
        symbol = f'<mi mathvariant="normal">{name}</mi>' if short else f"<mi>{name}</mi>"
    elif short or (_GREEK.search(token.text) and len(token.text) <= 2):
        symbol = f"<mi>{name}</mi>"
    else:
        return f"<mtext>{name}</mtext>"
    return f"<msub>{symbol}<mtext>{escape(token.below)}</mtext></msub>" if token.below else symbol


_ENCLOSED = re.compile(r"<mrow><mo stretchy=false>[(\[]</mo>(.*)<mo stretchy=false>[)\]]</mo></mrow>")


def _bare(made: str) -> str:
    """Return what stands in one pair of parentheses without them: a bar or a root encloses it already."""
    match = _ENCLOSED.fullmatch(made)
    if match is None:
        return made
    inside, depth = match[1], 0
    for sign in re.findall(r"stretchy=false>([(\[)\]])", inside):
        depth += 1 if sign in "([" else -1
        if depth < 0:
            return made
    return f"<mrow>{inside}</mrow>"


def _row(factors: list[str]) -> str:
    return factors[0] if len(factors) == 1 else f"<mrow>{_beside(factors)}</mrow>"


_WORDS = re.compile(r"<mtext>([^<]*)</mtext>")


def _beside(factors: list[str]) -> str:
    """Return factors one beside the other, words in one piece."""
    pieces: list[str] = []
    for factor in factors:
        word, before = _WORDS.fullmatch(factor), _WORDS.fullmatch(pieces[-1]) if pieces else None
        if word and before:
            pieces[-1] = f"<mtext>{before[1]} {word[1]}</mtext>"
        else:
            pieces.append(factor)
    return _THIN.join(pieces)
