"""Files of the workbench: only in its folder, never over a change, never a device."""

import os

import pytest

pytestmark = pytest.mark.extra("starlette", "httpx", "tomlkit", "uvicorn")
NEW = {"if-none-match": "*"}


def put(asked, name, text, headers):
    return asked.ask("PUT", f"/api/files/{name}", json={"text": text}, headers=headers)


def test_a_file_is_saved_whole_and_read_back_with_its_tag(asked, folder):
    saved = put(asked, "new.toml", "a = 1\n", NEW)
    assert saved.status_code == 200 and (folder / "new.toml").read_text() == "a = 1\n"
    read = asked.ask("GET", "/api/files/new.toml")
    assert read.json() == {"text": "a = 1\n", "tag": saved.json()["tag"]}
    assert read.headers["etag"] == f'"{saved.json()["tag"]}"'
    assert [path.name for path in folder.iterdir() if path.suffix == ".part"] == []


def test_what_has_changed_on_the_disk_is_not_overwritten(asked, folder):
    tag = put(asked, "race.toml", "a = 1\n", NEW).json()["tag"]
    (folder / "race.toml").write_text("a = 2\n")
    assert put(asked, "race.toml", "a = 3\n", {"if-match": f'"{tag}"'}).status_code == 412
    assert put(asked, "race.toml", "a = 3\n", NEW).status_code == 412
    assert put(asked, "race.toml", "a = 3\n", {}).status_code == 428
    assert (folder / "race.toml").read_text() == "a = 2\n"
    (folder / "race.toml").unlink()
    assert put(asked, "race.toml", "a = 3\n", {"if-match": f'"{tag}"'}).status_code == 412
    assert not (folder / "race.toml").exists()


def test_of_two_windows_that_save_one_text_the_second_is_told(asked):
    tag = put(asked, "two.toml", "a = 1\n", NEW).json()["tag"]
    answers = [put(asked, "two.toml", f"a = {k}\n", {"if-match": tag}).status_code for k in (2, 3)]
    assert answers == [200, 412]


@pytest.mark.parametrize(
    "name",
    [
        "..%2fa.toml",
        "%2fetc%2fpasswd",
        "a.txt",
        ".a.toml",
        "a%00.toml",
        "a%0a.toml",
        "%c3%a4.toml",
        "a" * 200 + ".toml",
        "a%5cb.toml",
    ],
)
def test_a_name_is_a_plain_name_of_a_design_file(asked, name):
    assert asked.ask("GET", f"/api/files/{name}").status_code in (404, 422)
    assert put(asked, name, "", NEW).status_code in (404, 422)


def test_links_out_of_the_folder_devices_pipes_and_folders_are_no_files(asked, folder, tmp_path):
    outside = tmp_path / "secret.toml"
    outside.write_text("secret = 1\n")
    (folder / "link.toml").symlink_to(outside)
    (folder / "zero.toml").symlink_to("/dev/zero")
    os.mkfifo(folder / "pipe.toml")
    (folder / "folder.toml").mkdir()
    for name in ("link", "zero", "pipe", "folder"):
        read = asked.ask("GET", f"/api/files/{name}.toml")
        assert read.status_code == 422 and "secret = " not in read.text, name
        for headers in (NEW, {"if-match": "x"}):
            assert put(asked, f"{name}.toml", "a = 1\n", headers).status_code in (412, 422), name
    assert outside.read_text() == "secret = 1\n"
    listed = asked.ask("GET", "/api/start").json()["files"]
    assert not {"pipe.toml", "folder.toml", "zero.toml"} & set(listed)


def test_a_text_that_nothing_would_read_is_not_written(asked, folder):
    assert put(asked, "large.toml", "#" * 1_000_001, NEW).status_code == 422
    assert not (folder / "large.toml").exists()


def test_a_design_that_names_files_reads_none_outside_its_folder(asked, tmp_path):
    """The text comes from the page; the folder is that of the workbench."""
    text = asked.ask("GET", "/api/designs/in-line-h2").json()["text"]
    for name in ("/etc/passwd", "../secret.csv", "/dev/zero"):
        named = text + f'\n[dynamics.curves.first.sun-planet]\nfile = "{name}"\n'
        answer = asked.post("/api/size", text=named)
        assert answer.status_code == 422 and "root:" not in answer.text
