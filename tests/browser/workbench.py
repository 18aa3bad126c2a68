"""A workbench as its users have it: a server on this machine, what its page shows."""

import re
import subprocess
import sys
from pathlib import Path

import gearwright as gw
from shipped_work import sized

START = "from gearwright.cli import main; main()"
MASS = "#keys dd[data-key=mass_kg]"
PATIENT = 60_000
"""For answers on a busy machine [ms]."""


def started(folder, port=0):
    """Return a server and the address that it prints."""
    line = [
        sys.executable,
        "-c",
        START,
        "app",
        "in-line-h2",
        "--no-browser",
        "--folder",
        str(folder),
        "--port",
        str(port),
    ]
    server = subprocess.Popen(line, stdout=subprocess.PIPE, text=True)
    return server, re.findall(r"http\S+", server.stdout.readline())[0]


def ended(server):
    server.terminate()
    server.wait()
    server.stdout.close()


def children(number):
    """Return the processes that a process has started; none of one that runs no more, or where nobody can tell."""
    try:
        return [int(word) for word in Path(f"/proc/{number}/task/{number}/children").read_text().split()]
    except OSError:
        return None


def mass_of(text):
    return f"{float(f'{gw.size(gw.parse(text)).mass:.4g}'):g}"


def choose(page, name):
    page.select_option("#design", f"shipped:{name}")
    wait_for(page, MASS + " b", f"{float(f'{sized(name).mass:.4g}'):g}")


def wait_for(page, selector, text):
    from playwright.sync_api import expect

    expect(page.locator(selector).first).to_have_text(text, timeout=PATIENT)
