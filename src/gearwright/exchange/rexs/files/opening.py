"""A REXS file in any of its forms: XML (.rexs), JSON (.rexsj), and either of them in an archive (.rexsz)."""

from __future__ import annotations

import io
import zipfile
import zlib
from pathlib import Path, PurePosixPath

from gearwright.errors import Problem, excerpt, refuse
from gearwright.exchange.rexs.files.document import Document
from gearwright.exchange.rexs.files.json_text import document_of_json
from gearwright.exchange.rexs.files.parsing import document_of
from gearwright.reading import bytes_of

LARGEST = 10_000_000
"""Largest REXS file that is read, unpacked [bytes]; a wind turbine's gearbox with all results has 0.9 MB."""
FORMS = (".rexs", ".rexsj")
"""How the names of models end, in archives, too."""
_ARCHIVE, _BOM = b"PK\x03\x04", "\ufeff"


def opened(path: str | Path) -> Document:
    """Return what a REXS file says, whatever its name ends with.

    Args:
        path: Of the file.

    Raises:
        DesignError: If it is no REXS file, damaged, too large, or of a version that is not read.
    """
    source, content = str(path), bytes_of(path, largest=LARGEST)
    if content.startswith(_ARCHIVE):
        content = _unpacked(content, source)
    try:
        text = content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError:
        refuse([Problem("", "this is not a text file in UTF-8; export it again")], source)
    plain = text.lstrip(f"{_BOM} \n\r\t")
    return document_of_json(plain, source) if plain.startswith(("{", "[")) else document_of(plain, source)


def _unpacked(content: bytes, source: str) -> bytes:
    """Return the one model of an archive; nothing is written anywhere, and no more than the limit unpacked."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            names = [entry.filename for entry in archive.infolist() if _is_model(entry.filename)]
            if len(names) != 1:
                held = ", ".join(excerpt(name) for name in names[:3]) or "none"
                refuse([Problem("", f"the archive must hold one .rexs or .rexsj; it holds {held}")], source)
            with archive.open(names[0]) as file:
                unpacked = file.read(LARGEST + 1)
    except (
        zipfile.BadZipFile,
        zlib.error,
        EOFError,
        NotImplementedError,
        RuntimeError,
    ) as error:  # locked: RuntimeError
        refuse([Problem("", f"the archive cannot be unpacked: {excerpt(str(error))}; pack it again")], source)
    if len(unpacked) > LARGEST:
        refuse([Problem("", f"the model in it has more than {LARGEST:,} bytes, the most that is read")], source)
    return unpacked


def _is_model(name: str) -> bool:
    path = PurePosixPath(name)
    return path.suffix.lower() in FORMS and not path.name.startswith("._")  # which is what macOS packs beside files
