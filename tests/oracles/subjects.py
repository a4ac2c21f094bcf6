#!/usr/bin/env python3
"""Marks the subjects of photos: a manual outline, refined by GrabCut at its border, reviewed and corrected.

    python3 tests/oracles/subjects.py [--looks FOLDER] [--again] [NAME...]    (numpy, pillow, opencv-python-headless)

Writes tests/data/subjects/NAME.png of each photo: 1 bit a pixel, 640 pixels along the longer side, white
within. `--looks` writes the photos with their marks, for review.

A subject is the part to cut out: people and animals with the things that they hold, or the
main object. Branches and rocks under an animal, shadows, and single whiskers or hairs are not part of it.
Outlines are in pixels of the photo reduced to 640 along its longer side. Pixels farther than `band` from the
outline are certain. GrabCut (Rother, Kolmogorov and Blake, 2004) decides the others by the colours of both
sides and the edges. With a band of 0, the outline is the border.
"""

import json
import pathlib
import sys

import cv2
import numpy as np
from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
MARKS = ROOT / "tests/data/subjects"
# Longer side in pixels of outlines and marks, and of the copy for edge detection.
SIDE, FINE = 640, 1280


def path(name):
    return ROOT / ("www/public/samples" if name[0].isdigit() else "tests/photos") / f"{name}.jpg"


def polygons(outlines, shape, scale):
    """White within any of the outlines."""
    canvas = np.zeros(shape, np.uint8)
    for outline in outlines:
        points = np.float32(outline).reshape(-1, 2) * scale
        cv2.fillPoly(canvas, [np.int32(np.round(points * 16))], 255, shift=4)
    return canvas


def within(photo, told):
    """Which pixels of a photo are its subject, by its outlines."""
    height, width = photo.shape[:2]
    scale = max(width, height) / SIDE
    drawn = polygons(told["outlines"], (height, width), scale)
    drawn[polygons(told.get("holes", []), (height, width), scale) > 0] = 0
    band = told.get("band", 5) * scale
    if band > 0:
        inside = cv2.distanceTransform(np.pad(drawn, 1, mode="edge"), cv2.DIST_L2, 5)[1:-1, 1:-1]
        outside = cv2.distanceTransform(np.pad(255 - drawn, 1, mode="edge"), cv2.DIST_L2, 5)[1:-1, 1:-1]
        guess = np.where(drawn > 0, cv2.GC_PR_FGD, cv2.GC_PR_BGD).astype(np.uint8)
        guess[inside > band] = cv2.GC_FGD
        guess[outside > band] = cv2.GC_BGD
        cv2.setRNGSeed(1)
        cv2.grabCut(photo, guess, None, np.zeros((1, 65)), np.zeros((1, 65)), 4, cv2.GC_INIT_WITH_MASK)
        drawn = np.where((guess == cv2.GC_FGD) | (guess == cv2.GC_PR_FGD), 255, 0).astype(np.uint8)
        # Single hairs and specks are neither.
        disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (5, 5))
        drawn = cv2.morphologyEx(cv2.morphologyEx(drawn, cv2.MORPH_OPEN, disc), cv2.MORPH_CLOSE, disc)
    drawn[polygons(told.get("add", []), (height, width), scale) > 0] = 255
    drawn[polygons(told.get("cut", []), (height, width), scale) > 0] = 0
    return drawn


def resized(picture, side):
    height, width = picture.shape[:2]
    scale = side / max(width, height)
    size = (round(width * scale), round(height * scale))
    return cv2.resize(picture, size, interpolation=cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC)


def look(photo, mark, file):
    """The border of the mark in red, the background darker."""
    large = cv2.resize(mark, photo.shape[1::-1], interpolation=cv2.INTER_NEAREST)
    shown = np.where(large[..., None] > 0, photo, photo // 3 + np.uint8([80, 0, 80]))
    border, _ = cv2.findContours(large, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    cv2.imwrite(str(file), cv2.drawContours(shown, border, -1, (0, 0, 255), 1))


def by_another_hand(told, seed):
    """The same outlines with each corner moved by up to 2 pixels, and a band wider by 2."""
    random = np.random.default_rng(seed)
    moved = {key: told[key] for key in ("cut", "add") if key in told}
    for key in ("outlines", "holes"):
        moved[key] = [np.float32(line) + random.uniform(-2, 2, len(line)) for line in told.get(key, [])]
    return {**moved, "band": told.get("band", 5) + 2}


def border(mark):
    """Pixels of the mark with a neighbour outside. The edge of the picture does not count."""
    return (mark > 0) & (cv2.erode(mark, np.ones((3, 3), np.uint8), borderValue=255) == 0)


def agreement(mark, other):
    """Intersection over union, and the share of the other's border within 2 and 6 pixels of the first at a width of 1920."""
    width, height = 1920, round(1920 * mark.shape[0] / mark.shape[1])
    first, second = (
        np.uint8(cv2.resize(cv2.GaussianBlur(np.float32(m), (0, 0), 0.7), (width, height), interpolation=cv2.INTER_CUBIC) > 127)
        for m in (mark, other)
    )
    apart = cv2.distanceTransform(np.uint8(~border(first)), cv2.DIST_L2, 5)[border(second)]
    return [(first & second).sum() / (first | second).sum(), (apart <= 2).mean(), (apart <= 6).mean()]


def main():
    names = sys.argv[1:]
    looks = pathlib.Path(names.pop(names.index("--looks") + 1)) if "--looks" in names else None
    again = "--again" in names
    names = [name for name in names if not name.startswith("--")]
    outlines = json.loads((MARKS / "outlines.json").read_text())
    rows = []
    for seed, name in enumerate(names or outlines):
        photo = resized(cv2.imread(str(path(name))), FINE)
        marked = [outlines[name]] + ([by_another_hand(outlines[name], seed)] if again else [])
        mark, *other = [np.where(resized(within(photo, told), SIDE) >= 128, 255, 0).astype(np.uint8) for told in marked]
        if again:
            rows.append(agreement(mark, other[0]))
            print(name, *(f"{value:.3f}" for value in rows[-1]))
            continue
        Image.fromarray(mark).convert("1").save(MARKS / f"{name}.png", optimize=True)
        if looks:
            look(photo, mark, looks / f"{name}.png")
    if again:
        print("mean", *(f"{value:.3f}" for value in np.mean(rows, 0)))


if __name__ == "__main__":
    main()
