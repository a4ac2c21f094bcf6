"""Measures examples/batch_ray.py with one worker and with two, for docs/guide/batches.md, and prints the
results.

    python python/tests/measure_batch.py FOLDER [ALBUMS]

FOLDER gets albums of six photos of twelve megapixels, made of the sample album, and the pages.
"""

import json
import subprocess
import sys
from pathlib import Path

from PIL import Image, ImageOps

ROOT = Path(__file__).resolve().parents[2]
PHOTOS = 6
SIZE = (4000, 3000)
# The methods run alternately, equally often, so that other load of the machine affects all of them.
RUNS = 4


def albums(top, count):
    samples = sorted((ROOT / "www/public/samples").glob("*.jpg"))
    larger = {}
    for sample in samples[: PHOTOS * 3]:
        file = top / "photos" / sample.name
        if not file.exists():
            file.parent.mkdir(parents=True, exist_ok=True)
            with Image.open(sample) as picture:
                upright = ImageOps.exif_transpose(picture).convert("RGB")
                size = SIZE if upright.width > upright.height else SIZE[::-1]
                ImageOps.fit(upright, size).save(file, quality=90)
        larger[sample.name] = file
    files = list(larger.values())
    for number in range(count):
        folder = top / "albums" / f"{number:04}"
        folder.mkdir(parents=True, exist_ok=True)
        for place in range(PHOTOS):
            link = folder / f"{place}.jpg"
            if not link.exists():
                link.symlink_to(files[(number + place * 3) % len(files)])
    return top / "albums"


def main():
    top, count = Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 24
    script = ROOT / "python/examples/batch_ray.py"
    folder = albums(top, count)
    told = {1: [], 2: []}
    for run in range(RUNS):
        for workers in (1, 2):
            report = top / f"report-{run}-{workers}.json"
            pages = top / f"pages-{run}-{workers}"
            options = ["--workers", str(workers), "--style", "comic", "--batch", "1", "--report", report]
            subprocess.run([sys.executable, script, folder, pages, *options], check=True, stdout=subprocess.DEVNULL)
            told[workers].append(json.loads(report.read_text()))
            print(told[workers][-1], flush=True)
    for name, of in [("all runs", lambda rates: sum(rates) / RUNS), ("least disturbed", max)]:
        one, two = (of([run["pages_an_hour"] for run in told[workers]]) for workers in (1, 2))
        print(f"{name}: pages an hour with one worker {one:.0f}, two {two:.0f}; efficiency {two / (2 * one):.2f}")


if __name__ == "__main__":
    main()
