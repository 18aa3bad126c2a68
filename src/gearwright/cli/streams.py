"""What standard output and standard error can show: the letters of their encoding, and no control characters.

A stream that does not know a letter gets the nearest one it knows: σ becomes s, − becomes -, and what has no likeness a
question mark. A control character, which could move the cursor or recolour the terminal, is shown as its code.
"""

import codecs
import io
import os
import re
import sys
import unicodedata

CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")
"""Characters that steer a terminal or turn the direction of writing; not the tab and the line feed."""
_NOT_PLAIN = re.compile(r"[^\n\x20-\x7e]")
_NEAREST = "nearest"
_ALIKE = {
    **dict(zip("αβγδεζηθικλμνξοπρςστυφχψωΔΣΩΦΘΛΠΓΨΞ", "abgdezhqiklmnxoprsstufcywDSOFQLPGYX", strict=True)),
    **dict.fromkeys("−–—‐‑━─╸╺", "-"), **dict.fromkeys("‘’′", "'"), **dict.fromkeys("“”″„", '"'),
    "µ": "u", "·": ".", "×": "x", "✓": "v", "∞": "inf", "…": "...", "→": "->", "≤": "<=", "≥": ">=", "≈": "~",
    "±": "+/-", "√": "sqrt", "°": "deg ", "§": "sec. ", "ø": "o", "Ø": "O", "ß": "ss", "∂": "d", "•": "*",
}  # fmt: skip


def clean(words: str) -> str:
    """Return words whose control characters are shown as their codes.

    >>> clean("shaft \\x1b[31m")
    'shaft \\\\x1b[31m'
    """
    return CONTROL.sub(lambda match: ascii(match[0])[1:-1], words)


def clean_json(text: str, encoding: str) -> str:
    """Return a JSON text with everything escaped that a stream of this encoding cannot hold or a terminal obeys."""
    return _NOT_PLAIN.sub(lambda match: match[0] if _holds(match[0], encoding) else _escaped(match[0]), text)


def _holds(letter: str, encoding: str) -> bool:
    try:
        letter.encode(encoding)
    except UnicodeEncodeError:
        return False
    return not CONTROL.match(letter)


def _escaped(letter: str) -> str:
    """Return a letter as JSON escapes it, in two halves where it needs them."""
    halves = letter.encode("utf-16-be", "surrogatepass")
    return "".join(f"\\u{halves[k : k + 2].hex()}" for k in range(0, len(halves), 2))


def _nearest(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_alike, error.object[error.start : error.end])), error.end


def _alike(letter: str) -> str:
    """Return ASCII for a letter that an encoding lacks."""
    plain = unicodedata.normalize("NFKD", _ALIKE.get(letter, letter)).encode("ascii", "ignore").decode()
    return _ALIKE.get(letter, plain) or "?"


def steady_streams() -> None:
    """Let both streams take every letter, and be there: a process may start without them."""
    codecs.register_error(_NEAREST, _nearest)
    # Closed at the start they are None; what is printed then goes nowhere, as with any other tool.
    sys.stdout = sys.stdout or io.StringIO()
    sys.stderr = sys.stderr or io.StringIO()
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors=_NEAREST)


def flushed() -> OSError | None:
    """Return why the last words of standard output cannot be written; Python then does not try them again."""
    try:
        sys.stdout.flush()
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return error
    return None
