"""Keys of every command's answer by the name of its schema: what others' programs read.

`PYTHONPATH=tests python tests/golden/schemas.py` adds the digests of new names; one that is recorded is never replaced.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from typing import Any

from gearwright.cli.answers import ANSWERS, answer_schema

RECORDED = Path(__file__).parent / "schemas.json"


def keys(schema: Any, place: str = "") -> Iterator[str]:
    """Yield the path of every key of an answer, and the type that stands there."""
    if isinstance(schema, list):
        for part in schema:
            yield from keys(part, place)
    elif isinstance(schema, dict):
        if "type" in schema or "$ref" in schema:
            yield f"{place}: {schema.get('$ref', schema.get('type'))}"
        for name, inner in schema.items():
            if name in ("properties", "$defs"):
                for key, entry in inner.items():
                    yield from keys(entry, f"{place}/{key}")
            elif name in ("items", "anyOf", "additionalProperties", "rows"):
                yield from keys(inner, f"{place}/{name}")


def digest(command: str) -> str:
    """Return what changes where a key of a command's answer, or the type behind it, changes."""
    return sha256("\n".join(sorted(keys(answer_schema(command)))).encode()).hexdigest()[:16]


def recorded() -> dict[str, str]:
    """Return name of a schema -> digest of its keys."""
    found: dict[str, str] = json.loads(RECORDED.read_text(encoding="utf-8"))
    return found


def main() -> None:
    """Add the schemas that are not recorded yet."""
    known = recorded() if RECORDED.exists() else {}
    made = {answer_schema(command)["$id"]: digest(command) for command in ANSWERS}
    RECORDED.write_text(json.dumps(dict(sorted({**made, **known}.items())), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
