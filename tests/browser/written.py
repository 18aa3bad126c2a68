"""Pages as the commands write them, each written once."""

import functools
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from gearwright.shipped import shipped_designs

COMMANDS = {
    "run of in-line-h2": "run in-line-h2 --out {folder}",
    "run of ec120b": "run ec120b --out {folder}",
    "window": "window in-line-h2 thesis motor-cut --report {page}",
    "comparison of designs": "compare in-line-h1 in-line-h2 --report {page}",
    "study": "study motor-speed --report {page}",
    "front": "study lightest-hybrid --report {page}",
    "mass": "mass --power-kw 2051 --engine-rpm 20204 --propeller-rpm 1212 --report {page}",
    "validation": "validate --report {page}",
    "drawings": "draw in-line-h2 --report {page}",
    "mix": "mix in-line-h2 regional-life --report {page}",
    "architectures": "architectures in-line-h2 --stages 2 --close 0 --workers 0 --report {page}",
    "load sharing": "sharing in-line-h2 --report {page}",
}
"""Page -> command that writes it."""
EVERY_DESIGN = os.environ.get("GEARWRIGHT_PAGES") == "all"
"""Ask for the pages of all shipped designs, which takes minutes."""
if EVERY_DESIGN:
    COMMANDS |= {f"run of {name}": f"run {name} --out {{folder}}" for name in shipped_designs()}


@functools.cache
def written(kind):
    """Return the page that a command writes."""
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / ("report.html" if kind.startswith("run of ") else "page.html")
        words = [word.format(folder=folder, page=page) for word in COMMANDS[kind].split()]
        call = [sys.executable, "-c", "from gearwright.cli import main; main()", *words]
        done = subprocess.run(call, cwd=folder, capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        return page.read_text(encoding="utf-8")
