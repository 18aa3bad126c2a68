"""Pages as PDF, printed by a browser of this machine: bookmarks, tags, heads of tables on every sheet."""

import os
import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from gearwright.errors import DesignError, Problem
from gearwright.files import write_bytes, write_text
from gearwright.processes import run_program

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge",
            "microsoft-edge")  # fmt: skip
"""Names under which browsers that print are known."""
PATIENCE = 120.0
"""Until a browser that does not print is given up [s]."""
_OPTIONS = ("--headless", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-extensions",
            "--no-pdf-header-footer", "--generate-pdf-document-outline", "--export-tagged-pdf")  # fmt: skip


def find_browser() -> str:
    """Return the browser that prints: the one that CHROMIUM names, or the first that is found.

    Raises:
        DesignError: If there is none.
    """
    named = os.environ.get("CHROMIUM", "")
    found = next((path for name in (named, *BROWSERS) if name and (path := shutil.which(name))), None)
    if found is None:
        message = (
            "no browser is found that prints; install Chromium or Chrome, or name one in the variable CHROMIUM, or"
            " open the page in any browser and print it to a file"
        )
        raise DesignError([Problem("--pdf", message)])
    return found


def print_pdf(page: str, target: Path) -> None:
    """Print a page that stands alone to a PDF file; nothing is written where printing fails.

    Args:
        page: HTML.
        target: File to write.

    Raises:
        DesignError: If no browser is found, or it does not print.
    """
    browser = find_browser()
    with TemporaryDirectory(prefix="gearwright-") as folder:
        source, made = Path(folder) / "page.html", Path(folder) / "page.pdf"
        write_text(source, page)
        # A browser refuses its sandbox to the superuser; the page is our own and asks for nothing.
        unguarded = ("--no-sandbox",) if sys.platform != "win32" and os.geteuid() == 0 else ()
        profile, output = f"--user-data-dir={folder}/profile", f"--print-to-pdf={made}"
        command = [browser, *_OPTIONS, *unguarded, profile, output, source.as_uri()]
        try:
            run_program(command, seconds=PATIENCE)
        except (OSError, subprocess.TimeoutExpired) as reason:
            raise DesignError([Problem("--pdf", f"{browser} does not print: {reason}")]) from None
        if not made.is_file():
            message = f"{browser} printed nothing; open the page in it and print it to a file"
            raise DesignError([Problem("--pdf", message)])
        write_bytes(target, made.read_bytes())
