"""Makes a page of each of thousands of albums, on a cluster.

    python batch_ray.py ALBUMS PAGES --workers 2 --style comic --page-size a4 --dpi 150

Every folder in ALBUMS is an album. Its page becomes PAGES/<folder>.pdf or .png. With --parquet, it becomes a row of a table in
PAGES. Albums with an existing page are skipped, so an interrupted job resumes. Errors do not stop the job: each becomes a row of
the error table PAGES/errors.jsonl, with the album, the photo if one is affected, a code, and a message. Requires
`pip install inkpanel "ray[data]"`. If the variable RAY_ADDRESS is set, the job runs on that cluster, whose machines need access to
both folders. See docs/guide/batches.md.
"""

import argparse
import json
import os
import resource
import sys
import time
import zlib
from pathlib import Path

PICTURES = {".jpg", ".jpeg", ".png", ".webp", ".gif", ".bmp", ".tif", ".tiff"}


class Draw:
    """A worker: draws the pages of albums, one after the other, on one core. It is created once for many
    batches, so the models are read once."""

    def __init__(self, settings, ending, pages, parquet, leave_out, retries, book):
        import inkpanel

        self.inkpanel, self.settings, self.ending = inkpanel, settings, ending
        self.pages, self.parquet, self.leave_out, self.retries = Path(pages), parquet, leave_out, retries
        self.book = book

    def __call__(self, batch):
        folders, pages = [Path(str(folder)) for folder in batch["folder"]], {}
        rows = [row for folder in folders for row in self.album(folder, pages)]
        if self.parquet and pages:
            # The name depends on the albums, so that a repeated batch overwrites its earlier file.
            name = zlib.crc32("/".join(folder.name for folder in folders).encode())
            self.retried(lambda: written(self.pages / f"pages-{name:08x}.parquet", table_of(pages, self.ending)))
        return {key: [row[key] for row in rows] for key in rows[0]}

    def album(self, folder, pages):
        """Returns the rows of an album: one without a code for its page, and one for each error. The page is
        written to a file, or stored in `pages`."""
        start, cpu, rows = time.time(), time.process_time(), []
        about = {"album": folder.name, "file": "", "code": "", "message": "", "pid": os.getpid()}
        about.update(began=start, ended=start, cpu=0.0, peak_mb=0.0)
        try:
            photos = sorted(file for file in folder.iterdir() if file.suffix.lower() in PICTURES)
            while True:
                try:
                    file = self.retried(lambda: self.page(folder, photos))
                    break
                except self.inkpanel.Error as error:
                    left = [photo for photo in photos if str(photo) != error.file]
                    if not self.leave_out or len(left) == len(photos):
                        raise
                    rows.append({**about, "file": error.file, "code": error.code, "message": str(error)})
                    photos = left
            if self.parquet:
                pages[folder.name] = file
            else:
                self.retried(lambda: written(self.pages / f"{folder.name}{self.ending}", file))
            # `ru_maxrss` is in kilobytes on Linux.
            peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
            cpu = time.process_time() - cpu
            rows.append({**about, "ended": time.time(), "cpu": cpu, "peak_mb": peak})
        except self.inkpanel.Error as error:
            rows.append({**about, "file": error.file or "", "code": error.code, "message": str(error)})
        except Exception as error:  # Whatever it is, the other albums go on.
            rows.append({**about, "code": type(error).__name__, "message": str(error)})
        return rows

    def page(self, folder, photos):
        # Each album has a separate seed, the same in every run.
        seed = zlib.crc32(folder.name.encode()) ^ self.settings["seed"]
        if self.book:
            settings = {key: value for key, value in self.settings.items() if key != "layout"}
            pages = self.inkpanel.book(photos, title=folder.name, **{**settings, "seed": seed})
            return self.inkpanel.pdf(pages, title=folder.name)
        page = self.inkpanel.render(photos, **{**self.settings, "seed": seed})
        return page.pdf(title=folder.name) if self.ending == ".pdf" else page.png()

    def retried(self, work):
        """Does it again where the disk or the network failed; a photo that is broken stays so."""
        for attempt in range(self.retries + 1):
            try:
                return work()
            except (OSError, self.inkpanel.Error) as error:
                passing = isinstance(error, OSError) or error.code == "unreadable"
                if not passing or attempt == self.retries:
                    raise
                time.sleep(2**attempt)


def table_of(pages, ending):
    """Pages by their albums as a Parquet file: album, format (pdf or png), and the bytes of the page, which are packed already."""
    import pyarrow
    import pyarrow.parquet

    columns = {"album": list(pages), "format": [ending[1:]] * len(pages), "page": list(pages.values())}
    table = pyarrow.table({**columns, "page": pyarrow.array(columns["page"], pyarrow.binary())})
    file = pyarrow.BufferOutputStream()
    pyarrow.parquet.write_table(table, file, compression="none", use_dictionary=False)
    return file.getvalue()


def albums_there(pages, ending, parquet):
    """The names of the albums whose pages were made before."""
    if not parquet:
        return {file.stem for file in pages.glob(f"*{ending}")}
    import pyarrow.parquet

    there = set()
    for file in pages.glob("pages-*.parquet"):
        table = pyarrow.parquet.read_table(file, columns=["album", "format"])
        there.update(row["album"] for row in table.to_pylist() if row["format"] == ending[1:])
    return there


def written(path, content):
    """Renames a file when it is complete."""
    fresh = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        with open(fresh, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(fresh, path)
    finally:
        fresh.unlink(missing_ok=True)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("albums", type=Path, help="the folder of albums")
    parser.add_argument("pages", type=Path, help="where pages and errors.jsonl go")
    parser.add_argument("--workers", type=int, default=2, help="processes, each on a core of its own")
    parser.add_argument("--batch", type=int, default=4, help="albums that a worker is given at once")
    parser.add_argument("--retries", type=int, default=2, help="of what failed by disk, network or a worker that died")
    parser.add_argument("--format", choices=["pdf", "png"], default="pdf")
    parser.add_argument("--book", action="store_true", help="make a book of each album (PDF only)")
    parser.add_argument("--parquet", action="store_true", help="pages as rows of Parquet files, a file for each batch")
    parser.add_argument("--leave-out", action="store_true", help="make pages without the photos that cannot be read")
    parser.add_argument("--report", type=Path, help="where figures of the run go, as JSON")
    parser.add_argument("--style"), parser.add_argument("--layout"), parser.add_argument("--page-size", default="a4")
    parser.add_argument("--dpi", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--no-detect", action="store_true")
    given = parser.parse_args()
    if given.book and given.format != "pdf":
        parser.error("--book: a book is a PDF file")
    return given


def joined(workers):
    """Joins the cluster, or starts one on this machine."""
    import ray

    # One thread a worker: as many workers as cores share nothing, and none waits for another.
    environment = {"env_vars": {"RAYON_NUM_THREADS": "1"}}
    if os.environ.get("RAY_ADDRESS"):
        ray.init(runtime_env=environment)
    else:
        ray.init(num_cpus=workers, runtime_env=environment, include_dashboard=False, log_to_driver=False)


def drawn(folders, given, batch, waiting):
    """Yields the rows of all albums as they arrive. A worker receives `batch` albums per batch, and `waiting`
    batches at once. No pixels travel between workers."""
    import ray

    context = ray.data.DataContext.get_current()
    # A batch that kills its worker repeatedly is reported as lost, and the other batches continue.
    context.max_errored_blocks = -1
    context.enable_progress_bars = sys.stderr.isatty()
    settings = {
        "style": given.style, "layout": given.layout, "page_size": given.page_size, "dpi": given.dpi,
        "seed": given.seed, "detect": not given.no_detect,
    }  # fmt: skip
    blocks = -(-len(folders) // batch)
    table = ray.data.from_items([{"folder": str(folder)} for folder in folders], override_num_blocks=blocks)
    done = table.map_batches(
        Draw,
        fn_constructor_args=(
            settings, f".{given.format}", str(given.pages), given.parquet, given.leave_out, given.retries, given.book
        ),  # fmt: skip
        batch_size=batch,
        num_cpus=1,
        compute=ray.data.ActorPoolStrategy(size=given.workers, max_tasks_in_flight_per_actor=waiting),
        # Without it an album that kills its worker would kill the next one for ever.
        max_task_retries=given.retries,
    )
    return list(done.iter_rows())


def main():
    given = arguments()
    given.albums, given.pages = given.albums.resolve(), given.pages.resolve()
    given.pages.mkdir(parents=True, exist_ok=True)
    albums = sorted(folder for folder in given.albums.iterdir() if folder.is_dir())
    there = albums_there(given.pages, f".{given.format}", given.parquet)
    folders = [folder for folder in albums if folder.name not in there]
    start, rows = time.time(), []

    def missing():
        told = {row["album"] for row in rows}
        return [folder for folder in folders if folder.name not in told]

    if folders:
        joined(given.workers)
        rows += drawn(folders, given, given.batch, waiting=2)
    # If a worker dies, innocent albums of its batch are lost too. Each lost album is repeated in a separate
    # batch.
    if missing():
        rows += drawn(missing(), given, 1, waiting=1)
    made = [row for row in rows if not row["code"]]
    errors = [row for row in rows if row["code"]]
    for folder in missing():
        errors.append({"album": folder.name, "file": "", "code": "lost", "message": "its worker died"})
    table = "".join(json.dumps({key: row[key] for key in ("album", "file", "code", "message")}) + "\n" for row in errors)
    written(given.pages / "errors.jsonl", table.encode())
    # Reports the startup time of the cluster and its workers separately.
    first, last = min((row["began"] for row in rows), default=start), max((row["ended"] for row in rows), default=start)
    seconds = last - first
    report = {
        "albums": len(albums), "skipped": len(albums) - len(folders), "pages": len(made), "errors": len(errors),
        "workers": given.workers, "seconds": seconds, "start_seconds": first - start,
        "pages_an_hour": len(made) / seconds * 3600 if made else 0,
        "cpu_seconds_a_page": sum(row["cpu"] for row in made) / len(made) if made else 0,
        "workers_seen": len({row["pid"] for row in made}),
        "peak_mb_a_worker": max((row["peak_mb"] for row in made), default=0),
    }  # fmt: skip
    print(json.dumps(report, indent=2))
    if given.report:
        written(given.report, json.dumps(report).encode())


if __name__ == "__main__":
    main()
