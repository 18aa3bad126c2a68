"""The version and the digest of files: what results, pages and journals say they were made with."""

from hashlib import sha256
from pathlib import Path

__version__ = "0.1.0"
_DIGITS = 12
"""Of the digest; one in 10^14 that two sets of files agree by chance."""


def digest(folder: Path) -> str:
    """Return the digest of the files in a folder, their names included; those that Python makes are left out.

    Args:
        folder: Of a package.
    """
    hashed = sha256()
    for path in sorted(entry for entry in folder.rglob("*") if entry.is_file() and "__pycache__" not in entry.parts):
        hashed.update(path.relative_to(folder).as_posix().encode() + b"\0")
        hashed.update(sha256(path.read_bytes()).digest())
    return hashed.hexdigest()[:_DIGITS]
