"""Arrays that a REXS file holds as base64, number by number."""

from __future__ import annotations

import base64
import binascii
import struct

CODES = {"int32": "i", "float32": "f", "float64": "d"}
"""How an array is coded -> a number of it, as `struct` has it; the least byte comes first."""


def decoded(text: str, code: str) -> tuple[str, ...]:
    """Return the numbers of a coded array, as texts.

    Args:
        text: In base64.
        code: Of its numbers, a key of `CODES`.

    Raises:
        ValueError: If there is no such code, or the text is no base64 of whole numbers of it.

    Source: REXS API, FVA GmbH, Base64Utils: the least byte first.

    >>> decoded("AAAAAAAA+D8=", "float64")
    ('1.5',)
    """
    if code not in CODES:
        raise ValueError(f"the code is {code!r}; allowed: {', '.join(CODES)}")
    try:
        numbers = struct.iter_unpack(f"<{CODES[code]}", base64.b64decode(text, validate=True))
        return tuple(repr(number) for (number,) in numbers)
    except (binascii.Error, struct.error):
        raise ValueError(f"its array is no base64 of {code}") from None
