"""Measures upscaling: photos reduced by 2 and by 3 and enlarged again, by this program and by other
libraries.

    pip install pillow==13.0.0 opencv-python-headless==5.0.0.93 scikit-image==0.26.0
    cargo build --example enlarge
    python tests/oracles/enlarge.py target/debug/examples/enlarge tests/photos/*.jpg

Prints PSNR in dB and SSIM of the green channel, the mean over all photos, for three ways of reducing.
"""

import pathlib
import subprocess
import sys
import tempfile

import cv2
import numpy
from PIL import Image
from skimage.metrics import structural_similarity

WAYS = {"area": Image.BOX, "bicubic": Image.BICUBIC, "Lanczos": Image.LANCZOS}


def enlarged(program, small, size, folder):
    source, made = folder / "small.png", folder / "large.png"
    small.save(source)
    subprocess.run([program, source, str(size[0]), str(size[1]), made], check=True)
    return numpy.asarray(Image.open(made).convert("RGB"))


def main(program, files):
    scores = {}
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            whole = Image.open(file).convert("RGB")
            for factor in (2, 3):
                size = (whole.width // factor * factor, whole.height // factor * factor)
                true = numpy.asarray(whole.crop((0, 0, *size)))
                for name, way in WAYS.items():
                    small = whole.crop((0, 0, *size)).resize((size[0] // factor, size[1] // factor), way)
                    pixels = numpy.asarray(small)
                    made = {
                        "Inkpanel": enlarged(program, small, size, pathlib.Path(folder)),
                        "Pillow bicubic": numpy.asarray(small.resize(size, Image.BICUBIC)),
                        "Pillow Lanczos": numpy.asarray(small.resize(size, Image.LANCZOS)),
                        "OpenCV bicubic": cv2.resize(pixels, size, interpolation=cv2.INTER_CUBIC),
                        "OpenCV Lanczos": cv2.resize(pixels, size, interpolation=cv2.INTER_LANCZOS4),
                    }
                    for how, image in made.items():
                        error = numpy.mean((true.astype(float) - image.astype(float)) ** 2)
                        likeness = structural_similarity(true[..., 1], image[..., 1])
                        row = scores.setdefault((factor, name, how), [])
                        row.append((10 * numpy.log10(255**2 / error), likeness))
    for (factor, name, how), row in scores.items():
        psnr, likeness = numpy.mean(row, axis=0)
        print(f"{factor}  {name:<8} {how:<15} {psnr:6.2f} dB  {likeness:.4f}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
