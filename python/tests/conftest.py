"""Shared fixtures: the sample album, and generated photos."""

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "www/public/samples"


def made_up(seed, height=90, width=120):
    """A picture with shapes that differ for every seed, because pages leave out similar photos."""
    random = np.random.default_rng(seed)
    y, x = np.mgrid[:height, :width].astype(float)
    picture = np.empty((height, width, 3))
    picture[:] = random.uniform(40, 220, 3)
    for _ in range(7):
        cx, cy, r = random.uniform(0, width), random.uniform(0, height), random.uniform(8, 40)
        picture[(x - cx) ** 2 + (y - cy) ** 2 < r * r] = random.uniform(0, 255, 3)
    picture += random.normal(0, 4, picture.shape)
    return picture.clip(0, 255).astype(np.uint8)


def file_of(array, kind="JPEG", **options):
    buffer = io.BytesIO()
    Image.fromarray(array).save(buffer, kind, **options)
    return buffer.getvalue()


@pytest.fixture(scope="session")
def samples():
    return sorted(SAMPLES.glob("*.jpg"))


@pytest.fixture
def album(tmp_path):
    """Four small files."""
    files = []
    for seed in range(4):
        file = tmp_path / f"{seed}.jpg"
        file.write_bytes(file_of(made_up(seed), quality=92))
        files.append(file)
    return files
