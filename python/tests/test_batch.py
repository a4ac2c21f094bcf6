"""The batch of examples/batch_ray.py on a cluster of this machine, and its ten lines for Dask."""

import json
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT, file_of, made_up
from PIL import Image

pytestmark = pytest.mark.ray

ALBUMS = 200
SCRIPT = ROOT / "python/examples/batch_ray.py"
# Faults of albums, by album number.
BROKEN = {7: "cut", 50: "text", 99: "empty", 120: "none", 199: "bomb"}


def bomb():
    """A PNG file that announces more pixels than anyone has memory for."""
    file = bytearray(file_of(np.zeros((8, 8), np.uint8), "PNG"))
    file[16:24] = (100_000).to_bytes(4, "big") * 2
    import zlib

    file[29:33] = zlib.crc32(file[12:29]).to_bytes(4, "big")
    return bytes(file)


@pytest.fixture(scope="module")
def albums(tmp_path_factory):
    """Albums of three or four small photos each, five of them broken."""
    top = tmp_path_factory.mktemp("albums")
    for number in range(ALBUMS):
        folder = top / f"album-{number:03}"
        folder.mkdir()
        for photo in range(3 + number % 2):
            picture = made_up(number * 10 + photo, 240, 320)
            (folder / f"{photo}.jpg").write_bytes(file_of(picture, quality=90))
        bad = folder / "1.jpg"
        match BROKEN.get(number):
            case "cut":
                bad.write_bytes(bad.read_bytes()[:700])
            case "text":
                bad.write_text("no picture")
            case "empty":
                bad.write_bytes(b"")
            case "none":
                for file in folder.iterdir():
                    file.unlink()
            case "bomb":
                (folder / "1.png").write_bytes(bomb())
    return top


# The example with an album that ends the process as a fault of a decoder would.
POISONED = """
import os

import batch_ray


class Poisoned(batch_ray.Draw):
    def page(self, folder, photos):
        if folder.name == "album-003":
            os._exit(1)
        return super().page(folder, photos)


batch_ray.Draw = Poisoned
batch_ray.main()
"""


def batch(albums, pages, *more, script=SCRIPT):
    """Runs the script, and gives its figures."""
    options = ["--style", "comic", "--page-size", "a6", "--dpi", "150", "--workers", "2", "--no-detect", *more]
    # Ray also prints to standard output.
    report = pages.parent / "report.json"
    options += ["--report", str(report)]
    done = subprocess.run(
        [sys.executable, script, albums, pages, *options],
        capture_output=True,
        text=True,
        timeout=900,
        cwd=pages.parent,
        env={**os.environ, "PYTHONPATH": str(SCRIPT.parent)},
    )
    assert done.returncode == 0, done.stderr[-4000:]
    return json.loads(report.read_text())


def errors(pages):
    return [json.loads(line) for line in (pages / "errors.jsonl").read_text().splitlines()]


def test_five_broken_albums_of_two_hundred(albums, tmp_path):
    pages = tmp_path / "pages"
    report = batch(albums, pages)
    assert (report["albums"], report["pages"], report["errors"], report["skipped"]) == (200, 195, 5, 0)
    assert report["workers_seen"] == 2
    files = sorted(pages.glob("*.pdf"))
    assert len(files) == 195 and all(file.read_bytes().startswith(b"%PDF") for file in files)
    told = {row["album"]: row for row in errors(pages)}
    assert set(told) == {f"album-{number:03}" for number in BROKEN}
    codes = {number: told[f"album-{number:03}"]["code"] for number in BROKEN}
    assert codes == {7: "damaged", 50: "unknown-format", 99: "unknown-format", 120: "no-photos", 199: "too-large"}
    assert told["album-007"]["file"].endswith("album-007/1.jpg")
    # Nothing half written is left.
    assert {file.suffix for file in pages.iterdir()} == {".pdf", ".jsonl"}

    # Existing pages are not changed. Missing and failed pages are made again.
    files[3].unlink()
    before = {file: file.stat().st_mtime_ns for file in files if file.exists()}
    report = batch(albums, pages)
    assert (report["pages"], report["errors"], report["skipped"]) == (1, 5, 194)
    assert {file: file.stat().st_mtime_ns for file in before} == before and files[3].exists()


def test_photos_that_are_broken_can_be_left_out(albums, tmp_path):
    some, pages = tmp_path / "some", tmp_path / "pages"
    some.mkdir()
    for number in [7, 50, 99, 120, 199, 3]:
        (some / f"album-{number:03}").symlink_to(albums / f"album-{number:03}")
    report = batch(some, pages, "--leave-out", "--format", "png", "--batch", "1")
    # Every album has a page, except the one without photos. Every damaged photo has a row.
    assert (report["pages"], report["errors"]) == (5, 5)
    assert {row["code"] for row in errors(pages)} == {"damaged", "unknown-format", "too-large", "no-photos"}
    with Image.open(pages / "album-003.png") as page:
        assert page.size == (620, 874)


def test_an_album_that_kills_its_worker_is_lost_alone(albums, tmp_path):
    some, pages, script = tmp_path / "some", tmp_path / "pages", tmp_path / "poisoned.py"
    some.mkdir()
    for number in range(6):
        (some / f"album-{number:03}").symlink_to(albums / f"album-{number:03}")
    script.write_text(POISONED)
    report = batch(some, pages, "--batch", "2", "--retries", "1", script=script)
    assert (report["pages"], report["errors"]) == (5, 1)
    assert [(row["album"], row["code"]) for row in errors(pages)] == [("album-003", "lost")]


def test_pages_as_rows_of_parquet(albums, tmp_path):
    import pyarrow.parquet

    some, pages = tmp_path / "some", tmp_path / "pages"
    some.mkdir()
    for number in [1, 2, 3, 7]:
        (some / f"album-{number:03}").symlink_to(albums / f"album-{number:03}")
    report = batch(some, pages, "--parquet", "--batch", "2")
    assert (report["pages"], report["errors"]) == (3, 1)
    assert {file.suffix for file in pages.iterdir()} == {".parquet", ".jsonl"}

    def rows():
        files = sorted(pages.glob("*.parquet"))
        return [row for file in files for row in pyarrow.parquet.read_table(file).to_pylist()]

    assert [row["album"] for row in errors(pages)] == ["album-007"]
    before = {row["album"]: row["page"] for row in rows()}
    assert sorted(before) == ["album-001", "album-002", "album-003"]
    # They are the pages that the folder would have.
    batch(some, tmp_path / "folder")
    for album, page in before.items():
        assert page == (tmp_path / f"folder/{album}.pdf").read_bytes()
    # Existing pages are not made again.
    report = batch(some, pages, "--parquet", "--batch", "2")
    assert (report["pages"], report["skipped"]) == (0, 3)
    # Files of another format are not in the way.
    report = batch(some, pages, "--parquet", "--format", "png")
    assert report["pages"] == 3


def test_ten_lines_of_dask_do_the_same(albums, tmp_path):
    lines = re.search(r"```python\n(.*?)```", (ROOT / "docs/guide/batches.md").read_text(), re.DOTALL)[1]
    (tmp_path / "albums").mkdir()
    for number in [1, 2, 7]:
        (tmp_path / f"albums/album-{number:03}").symlink_to(albums / f"album-{number:03}")
    (tmp_path / "pages").mkdir()
    script = tmp_path / "batch_dask.py"
    script.write_text(lines)
    done = subprocess.run(
        [sys.executable, script], cwd=tmp_path, capture_output=True, text=True, timeout=300, env=os.environ
    )
    assert done.returncode == 0, done.stderr[-4000:]
    assert sorted(file.name for file in (tmp_path / "pages").iterdir()) == ["album-001.pdf", "album-002.pdf"]
    assert "album-007/1.jpg" in done.stdout
