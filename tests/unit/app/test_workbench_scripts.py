"""The scripts of the workbench: what is bundled is what it says, our own are short and take no text for markup."""

import hashlib
import re
import subprocess
import sys
from pathlib import Path

import gearwright.app
from gearwright.app.serving import bundled, files, index

STATIC = Path(gearwright.app.__file__).parent / "static"
OWN = sorted(path for path in STATIC.rglob("*.js") if path.parent.name != "vendor")
LONGEST = 200
"""Lines of a script."""
LARGEST = 1_500_000
"""All that the page loads [bytes]."""
MARKUP = re.compile(
    r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|createContextualFragment|srcdoc"
    r"|\beval\(|new Function|setTimeout\(['\"]"
)
HELP = """
import sys
from gearwright.cli import main
sys.argv = ["gearwright", "--help"]
try:
    main()
finally:
    print(*sys.modules, file=sys.stderr)
"""


def test_what_is_bundled_is_what_its_digest_says():
    told = bundled()
    content = (STATIC / "vendor" / "codemirror.min.js").read_bytes()
    assert hashlib.sha512(content).hexdigest() == told["sha512"]
    licences = (STATIC / "vendor" / "LICENSES.txt").read_text(encoding="utf-8")
    for name, words in told["packages"].items():
        version, licence = words.split(", ")
        assert f"{name} {version}" in licences and licence == "MIT"


def test_our_scripts_are_short_and_take_no_text_for_markup():
    for path in OWN:
        text = path.read_text(encoding="utf-8")
        assert len(text.splitlines()) <= LONGEST, path.name
        assert not MARKUP.search(text), path.name
        assert re.findall(r"https?://", text) == [], path.name


def test_the_page_holds_no_script_no_style_and_no_foreign_address():
    page = index()
    assert re.findall(r"<script(?![^>]*\bsrc=)", page) == [] and "<style" not in page and " style=" not in page
    assert not re.search(r"\bon[a-z]+=", page) and not re.search(r"https?://", page)
    named = set(re.findall(r'(?:src|href)="/static/([^"]+)"', page))
    assert named <= files().keys()


def test_every_script_that_is_imported_is_given_out():
    for path in OWN:
        for name in re.findall(r'(?:from|import) "/static/([^"]+)"', path.read_text(encoding="utf-8")):
            assert name in files(), (path.name, name)


def test_the_page_is_small_enough():
    assert sum(len(found.read_bytes()) for found in files().values()) + len(index()) <= LARGEST


def test_every_element_that_a_script_asks_for_is_in_the_page():
    ids = re.findall(r'\bid="([^"]+)"', index())
    assert len(ids) == len(set(ids))
    for path in OWN:
        asked = re.findall(r'\b(?:at|listen)\("([^"]+)"', path.read_text(encoding="utf-8"))
        assert set(asked) <= set(ids), path.name


def test_no_other_command_loads_anything_of_the_workbench():
    loaded = subprocess.run([sys.executable, "-c", HELP], capture_output=True, text=True, check=True).stderr.split()
    assert not {"gearwright.app", "starlette", "uvicorn", "tomlkit", "multiprocessing"} & set(loaded)


def test_without_its_extra_the_command_says_what_to_install(monkeypatch, capsys):
    import gearwright.app.serving
    from gearwright.cli import main

    monkeypatch.setattr(gearwright.app.serving, "NEEDED", ("starlette_that_is_not_here",))
    monkeypatch.setattr("sys.argv", ["gearwright", "app"])
    try:
        main()
    except SystemExit as end:
        assert end.code == 2
    assert 'pip install ".[app]"' in capsys.readouterr().err
